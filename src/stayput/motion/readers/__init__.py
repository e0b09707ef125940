"""Readers of strong-motion files, one format a file; a file is recognised by its content.

A reader is a module with ``FORMAT`` (its name), ``recognise(text)`` and ``read(text, unit, dt)``, which
returns the file's channels in m/s². To add a format, write such a module and list it in `READERS`.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from stayput.errors import InputError, InputWarning, warn, warnings_to, within
from stayput.motion.baseline import checked_record
from stayput.motion.channels import (
    is_vertical,
    labels_phrase,
    motion_fields,
    refuse_vertical,
    upper_floor_warning,
    warn_of_vertical,
)
from stayput.motion.processing import STEP_RANGE
from stayput.motion.readers import columns, cosmos, csmip, esm, jma, knet, knet_csv, peer
from stayput.motion.readers.text import check_end, file_text
from stayput.motion.record import Motion
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Sequence

    from stayput.motion.channels import Channel


class Reader(Protocol):
    """What a reader's module has."""

    @property
    def FORMAT(self) -> str:  # noqa: N802
        """Name of the format."""
        ...

    def recognise(self, text: str) -> bool:
        """Return whether the text is of this format."""
        ...

    def read(self, text: str, unit: str | None, dt: float | None) -> list[Channel]:
        """Return the channels; ``unit`` and ``dt`` are the caller's, for files that do not state theirs."""
        ...


_HEAD = 1000
"""A file that calls itself synthetic in so many of its first characters stays labelled so."""

_STATED_OTHERWISE = (
    "motion.another_unit",
    "motion.column_another_unit",
    "motion.another_time_step",
    "motion.time_column_step",
)
"""Refusals of a unit or a time step that is not the one that the file states."""

READERS: tuple[Reader, ...] = (peer, jma, knet, knet_csv, esm, csmip, cosmos, columns)
"""The readers, in the order in which they are asked whether a file is theirs.

Any file may have lines of bare numbers, so columns come last; the others' first lines exclude one another.
"""


def read_motion(
    path: str | os.PathLike[str],
    component: str | None = None,
    unit: str | None = None,
    *,
    dt: float | None = None,
    remove_mean: bool = False,
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
        Unit of the numbers ("m/s²", "cm/s²", "gal", "mm/s²", "g"): required where the file does not
        state it, and refused where it contradicts the file.
    dt : float, optional
        Time step [s]: likewise.
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
        floor, channels seem to be missing; a component has an offset (see
        `stayput.motion.baseline.oscillates_about_offset`), or the time step is longer than 0.1 s.

    Examples
    --------
    >>> import stayput as sp
    >>> path = sp.sine(amplitude=4.0, frequency=1.0, duration=2.0).write("shake.csv")
    >>> sp.read_motion(path).pga
    4.0
    """

    def asked(channels: Sequence[Channel]) -> str | None:
        warn_of_vertical(channels, component)
        if component is None:
            _warn_of_name(path, channels)
        return component

    return _read(path, asked, unit, dt, remove_mean)


def read_shaking(
    path: str | os.PathLike[str],
    component: str | None = None,
    unit: str | None = None,
    *,
    dt: float | None = None,
    remove_mean: bool = False,
    several: bool = False,
) -> Motion:
    """Read a record that shakes furniture sideways: a vertical channel is not taken for a horizontal one.

    Parameters
    ----------
    path, component, unit, dt, remove_mean
        As for `read_motion`.
    several : bool
        Whether the file is one of several: ``unit`` and ``dt`` are for those that do not state their own.

    Raises
    ------
    InputError
        Likewise; or ``component`` names a vertical channel of a file that has horizontal ones.
    """

    def asked(channels: Sequence[Channel]) -> str | None:
        refuse_vertical(channels, component)
        if component is None:
            _warn_of_name(path, channels)
        return component

    return _read(path, asked, unit, dt, remove_mean, several)


def read_vertical(
    path: str | os.PathLike[str],
    unit: str | None = None,
    *,
    dt: float | None = None,
    remove_mean: bool = False,
    several: bool = False,
) -> Motion:
    """Read a file's vertical channel, or its only one where its direction is not stated, as x of a motion.

    Parameters
    ----------
    path, unit, dt, remove_mean, several
        As for `read_shaking`.

    Raises
    ------
    InputError
        Likewise; or there is no vertical channel, or more than one.
    """
    return _read(path, _vertical_of, unit, dt, remove_mean, several)


def _vertical_of(channels: Sequence[Channel]) -> str:
    upright = [i for i, channel in enumerate(channels, start=1) if is_vertical(channel.label)]
    if len(channels) == 1 and not channels[0].label:
        upright = [1]
    if len(upright) != 1:
        labels = labels_phrase([channel.label for channel in channels])
        raise InputError("motion.not_one_vertical", "component", channels=labels)
    return f"channel {upright[0]}"


def _warn_of_name(path: str | os.PathLike[str], channels: Sequence[Channel]) -> None:
    """Warn of a file whose name alone says that its one channel is vertical."""
    ending = re.search(r"(?<=[-_. ])[A-Za-z]{1,4}$", Path(path).stem)
    if len(channels) == 1 and not channels[0].label and ending and is_vertical(ending[0]):
        warn(InputWarning("motion.vertical_by_name", "component", ending=ending[0]))


def _read(
    path: str | os.PathLike[str],
    choose: Callable[[Sequence[Channel]], str | None],
    unit: str | None,
    dt: float | None,
    remove_mean: bool,
    several: bool = False,
) -> Motion:
    if unit is not None:
        unit_factor(unit)
    if dt is not None:
        within("motion.name_dt", dt, *STEP_RANGE, "s", "dt")
    text = file_text(path)
    reader = next((reader for reader in READERS if reader.recognise(text)), None)
    if reader is None:
        formats = ", ".join(r.FORMAT for r in READERS)
        raise InputError("motion.unknown_format", path=str(path), formats=formats)
    title = f"{Path(path).name} ({reader.FORMAT})"
    warnings: list[InputWarning] = []
    try:
        with warnings_to(warnings.append):
            check_end(text)
            channels = _channels(reader, text, unit, dt, several)
            fields = motion_fields(channels, choose(channels), reader.FORMAT, name=Path(path).stem)
            motion = checked_record(Motion(**fields), remove_mean=remove_mean)
    except InputError as error:
        raise error.at(title) from None
    if motion.floor:
        warnings.append(upper_floor_warning(motion.floor))
    for warning in warnings:
        warn(warning.at(title))
    return replace(motion, synthetic="synthetic" in text[:_HEAD].lower())


def _channels(reader: Reader, text: str, unit: str | None, dt: float | None, several: bool) -> list[Channel]:
    """Return the channels; of several files one that states another unit or time step keeps its own."""
    try:
        return reader.read(text, unit, dt)
    except InputError as error:
        if not several or error.code not in _STATED_OTHERWISE:
            raise
        unit, dt = (None, dt) if error.field == "unit" else (unit, None)
        return _channels(reader, text, unit, dt, several)
