"""Readers of strong-motion files, the formats of one origin a module; a file is known by its content.

To add a format, write a `stayput.motion.readers.text.Reader` of it, which returns a file's channels in m/s²,
and list it in `READERS`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Unpack

from stayput import errors
from stayput.catalogue import phrase
from stayput.motion import seismogram
from stayput.motion.channels import Channel, check_horizontal, is_vertical, labels_phrase, motion_fields
from stayput.motion.floors import BOREHOLE, floor_phrase
from stayput.motion.processing import STEP_RANGE, checked_record
from stayput.motion.readers import california, databases, japan, mexico
from stayput.motion.readers.columns import COLUMNS, MOST_SKIPPED, ReadingOptions, chosen_columns, read_columns
from stayput.motion.readers.text import check_end, file_bytes, other_format, text_of
from stayput.motion.record import Motion
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    import os


_HEAD = 1000
"""A file that calls itself synthetic in so many of its first characters stays labelled so."""

READERS = (databases.PEER, *japan.READERS, databases.ESM, *california.READERS, mexico.ASA, COLUMNS)
"""The readers, in the order in which they are asked whether a file is theirs.

Any file may have lines of bare numbers, so columns come last; the others' first lines exclude one another.
"""


def read_motion(
    path: str | os.PathLike[str],
    component: str | None = None,
    unit: str | None = None,
    **options: Unpack[ReadingOptions],
) -> Motion:
    """Read a record in any of the formats of `READERS`, recognised by its content.

    Nothing is guessed, and nothing is corrected that is not asked for: samples are as in the file, in m/s².
    Only a K-NET record has its offset taken off, as its own header's peak does, and a channel that points
    down is turned up.

    Parameters
    ----------
    path : str or path
        The file.
    component : str, optional
        Channel that becomes x: its direction ("NS", "EW", "360", "HNE", ...) or its place in the file
        ("channel 2"); default the first horizontal one. The other horizontal one becomes y and the
        vertical one z. PEER and K-NET files hold one channel each: see `Motion.combine`. A vertical one alone
        is named ("channel 1"), else it is warned of.
    unit : str, optional
        Unit of the numbers ("m/s²", "cm/s²", "gal", "mm/s²", "g", "%g", "mg", "in/s²", "ft/s²"): required
        where the file states none that is known, and refused where it contradicts the file.
    dt : float, optional
        Time step [s]: likewise.
    columns : str or mapping, optional
        Of columns of numbers, which are the time and the components, by their headings or their places:
        "t=time,x=acc_2,z=4" or ``{"t": 1, "x": 3}``; the others are not read. Without t, ``dt`` is given.
        "rows" where each row has several samples of one series.
    skip_lines : int
        How many lines at the beginning of the file are passed over.
    decimal_comma : bool
        Whether the numbers have a comma in the place of the point.
    location : str, optional
        Of SAC and miniSEED, the code of the sensor where a station has several; "--" of none.
    remove_mean : bool
        Whether the mean of each component is taken off, as for a record with an offset, or with gravity in
        its vertical component. The motion's source says what was taken off.

    Raises
    ------
    InputError
        The file cannot be read, is damaged or contradicts itself, or lacks its unit or time step; the mean
        of a component is gravity.

    Warns
    -----
    InputWarning
        It is read, but perhaps not as it was meant: a channel had to be chosen, or is the vertical one of a
        file that has horizontal ones; the peak is above 5 g, the header mentions another unit or an upper
        floor, channels seem to be missing, columns of other quantities are left out, the sensor is in a
        borehole; a component has an offset (see `stayput.motion.processing.oscillates_about_offset`), or the
        time step is longer than 0.1 s.

    Examples
    --------
    >>> import stayput as sp
    >>> path = sp.sine(amplitude=4.0, frequency=1.0, duration=2.0).write("shake.csv")
    >>> sp.read_motion(path).pga
    4.0
    """
    return motion_of([read_file(path, unit, **options)], along(component, refuse=False))


def read_shaking(
    path: str | os.PathLike[str],
    component: str | None = None,
    unit: str | None = None,
    *,
    several: bool = False,
    vertical: bool = False,
    **options: Unpack[ReadingOptions],
) -> Motion:
    """Read a record that shakes furniture sideways: a vertical channel is not taken for a horizontal one.

    Parameters
    ----------
    path, component, unit, options
        As for `read_motion`.
    several : bool
        Whether the file is one of several: ``unit`` and ``dt`` are for those that do not state their own.
    vertical : bool
        Whether it shakes it up and down instead: x is the file's vertical channel, or its only one where its
        direction is not stated.

    Raises
    ------
    InputError
        Likewise; or ``component`` names a vertical channel of a file that has horizontal ones, or there is
        none or more than one where the vertical is asked for.
    """
    file = read_file(path, unit, several=several, **options)
    return motion_of([file], _vertical_of if vertical else along(component))


def along(component: str | None, *, refuse: bool = True) -> Callable[[Sequence[Channel]], str | None]:
    """Return what names the channel along the shaking, for `motion_of`.

    Parameters
    ----------
    component : str, optional
        The channel; None where it is not said.
    refuse : bool
        Whether a vertical one is refused; else it is warned of.
    """

    def named(channels: Sequence[Channel]) -> str | None:
        if component is not None and channels[0].role:
            raise errors.InputError("scenario.only_one", "component", other="columns")
        check_horizontal(channels, component, refuse=refuse)
        return component

    return named


def _vertical_of(channels: Sequence[Channel]) -> str:
    upright = [
        i for i, channel in enumerate(channels, 1) if channel.role == "z" or is_vertical(channel.label)
    ]
    if len(channels) == 1 and (channels[0].role or not channels[0].label):
        upright = [1]
    if len(upright) != 1:
        labels = labels_phrase([channel.label for channel in channels])
        raise errors.InputError("motion.not_one_vertical", "component", channels=labels)
    return f"channel {upright[0]}"


def _warn_of_name(path: str | os.PathLike[str], channels: Sequence[Channel]) -> None:
    """Warn of a file whose name alone says that its one channel is vertical."""
    ending = re.search(r"(?<=[-_. ])[A-Za-z]{1,4}[0-9]{0,2}$|(?:UP|VER|DWN)$", Path(path).stem)
    if len(channels) == 1 and not channels[0].label and ending and is_vertical(ending[0]):
        errors.warn(errors.InputWarning("motion.vertical_by_name", "component", ending=ending[0]))


class ReadFile(NamedTuple):
    """A file of a record.

    Attributes
    ----------
    path : Path
        Where it is.
    form : str
        Name of its format.
    channels : list of Channel
        What it holds.
    warnings : list of InputWarning
        What is doubtful about it.
    synthetic : bool
        Whether it says that it was computed.
    remove_mean : bool
        Whether the mean is taken off each component of the motion that is made of it.
    """

    path: Path
    form: str
    channels: list[Channel]
    warnings: list[errors.InputWarning]
    synthetic: bool
    remove_mean: bool

    @contextmanager
    def naming(self) -> Generator[None]:
        """Refuse with the file's name, and keep the warnings until a motion is made of it."""
        form = phrase("motion.columns_of_numbers") if self.form == COLUMNS.name else self.form
        title = phrase("motion.file_and_form", file=self.path.name, form=form)
        try:
            with errors.warnings_to(lambda warning: self.warnings.append(warning.at(title))):
                yield
        except errors.InputError as error:
            raise error.at(title) from None


def read_file(
    path: str | os.PathLike[str],
    unit: str | None = None,
    *,
    dt: float | None = None,
    columns: str | Mapping[str, str | int] | None = None,
    skip_lines: int = 0,
    decimal_comma: bool = False,
    location: str | None = None,
    remove_mean: bool = False,
    several: bool = False,
) -> ReadFile:
    """Read a file's channels; arguments and errors as for `read_shaking`."""
    comma = errors.instance_of("decimal_comma", decimal_comma, bool)
    skipped = errors.whole_within("skip_lines", skip_lines, 0, MOST_SKIPPED, field="skip_lines")
    chosen = chosen_columns(columns)
    if unit is not None:
        unit_factor(unit)
    if dt is not None:
        errors.within("motion.name_dt", dt, *STEP_RANGE, "s", "dt")
    if location is not None:
        errors.instance_of("location", location, str)
    data = file_bytes(path)
    binary = seismogram.format_of(data)
    text = "" if binary is not None else text_of(path, data)
    other = None
    synthetic = "synthetic" in text[:_HEAD].lower()
    if binary is not None:
        form = seismogram.FORMATS[binary]
        read = partial(seismogram.read, data, binary, location=location)
        unused = {"columns": chosen, "skip_lines": skipped, "decimal_comma": comma}
    else:
        text = _without_lines(text, skipped, Path(path).name)
        text = text.replace(",", ".") if comma else text
        reader = COLUMNS if chosen or comma else next((r for r in READERS if r.recognise(text)), None)
        other = other_format(text) if reader in (None, COLUMNS) and not chosen else None
        if reader is None:
            raise _not_read(path, other)
        form, unused = reader.name, {"location": location}
        read = partial(read_columns, text, chosen=chosen) if chosen else partial(reader.read, text)
    file = ReadFile(Path(path), form, [], [], synthetic, remove_mean)
    try:
        with file.naming():
            for name in (name for name, value in unused.items() if value):
                raise errors.InputError(
                    "common.left_out", name, where=phrase("motion.not_of_format", format=form)
                )
            check_end(text)
            file.channels.extend(_channels(read, unit, dt, several))
    except errors.InputError as error:
        if other and error.field is None:
            raise _not_read(path, other) from None
        raise
    return file


def _channels(
    read: Callable[[str | None, float | None], list[Channel]],
    unit: str | None,
    dt: float | None,
    several: bool,
) -> list[Channel]:
    """Return the channels; of several files one that states another unit or time step keeps its own."""
    try:
        return read(unit, dt)
    except errors.InputError as error:
        if not several or error.code != "motion.not_the_files_own":
            raise
        unit, dt = (None, dt) if error.field == "unit" else (unit, None)
        return _channels(read, unit, dt, several)


def _not_read(path: str | os.PathLike[str], other: str | None) -> errors.InputError:
    """Return the refusal of a file in a format that is known but not read, or in none that is known."""
    formats = ", ".join((*(reader.name for reader in READERS), *seismogram.FORMATS.values()))
    form = phrase("motion.a_format", format=other) if other else phrase("motion.no_known_format")
    return errors.InputError("motion.unknown_format", path=str(path), format=form, formats=formats)


def _without_lines(text: str, count: int, name: str) -> str:
    lines = text.split("\n", count)
    if len(lines) <= count or not lines[-1].strip():
        raise errors.not_allowed("skip_lines", str(count), "motion.fewer_lines", "skip_lines").at(name)
    return lines[-1]


def motion_of(files: Sequence[ReadFile], choose: Callable[[Sequence[Channel]], str | None]) -> Motion:
    """Return the motion that the channels of files make, which belong to one record.

    Parameters
    ----------
    files : sequence of ReadFile
        The files.
    choose : callable
        Returns which channel becomes x, or None where it is not said.

    Raises
    ------
    InputError
        As for `motion_fields`.
    """
    first = files[0]
    channels = [channel for file in files for channel in file.channels]
    with first.naming():
        component = choose(channels)
        if component is None and len(files) == 1:
            _warn_of_name(first.path, channels)
        motion = Motion(**motion_fields(channels, component, first.form, name=first.path.stem))
        motion = checked_record(motion, remove_mean=first.remove_mean)
        if motion.floor not in ("", BOREHOLE):  # the choice of its channel has warned
            errors.warn(errors.InputWarning("motion.upper_floor", floor=floor_phrase(motion.floor)))
    for warning in (warning for file in files for warning in file.warnings):
        errors.warn(warning)
    return replace(motion, synthetic=any(file.synthetic for file in files))
