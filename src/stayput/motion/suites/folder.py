"""The records in a folder as a database delivers it: which files belong together, and which are left out."""

from __future__ import annotations

import re
from contextlib import contextmanager
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, warn
from stayput.motion.channels import is_vertical, labels_phrase, plain_origin
from stayput.motion.readers import along, motion_of, read_file
from stayput.wording import joined

if TYPE_CHECKING:
    from collections.abc import Generator, Hashable, Sequence
    from pathlib import Path
    from typing import Unpack

    from stayput.catalogue import Phrase
    from stayput.motion.channels import Channel
    from stayput.motion.readers import ReadFile
    from stayput.motion.readers.columns import ReadingOptions
    from stayput.motion.record import Motion

_PASSED_OVER = (".md",)
"""Endings of files that may stand beside records without a word."""

_NO_RECORD = re.compile(
    r"SearchResults\.csv$|\.(?:ps|gz|pdf|png|jpe?g|gif|html?)$|^(?:read[ _-]?me|licen[cs]e|copying)\b",
    re.IGNORECASE,
)
"""Names of PEER's tables of what was found, of pictures and archives, and of texts about the records."""

_LEFT_OUT = {
    "motion.not_acceleration": "no_acceleration",
    "motion.other_instrument": "no_acceleration",
    "motion.unknown_format": "no_record",
}
"""Refusals of files that are left out, and as what."""

_RECORD_NUMBER = re.compile(r"RSN([0-9]{1,7})_", re.IGNORECASE)
_LISTED = 3


def records_in(
    folder: Path, title: str, component: str | None, unit: str | None, **options: Unpack[ReadingOptions]
) -> list[Motion]:
    """Return the records in a folder, in the order of the files' names.

    Files of one channel each are one record where their names have the same record number (PEER's RSN), or
    where they state the same station, event and sensor.

    Parameters
    ----------
    folder : Path
        The folder.
    title : str
        What the warning calls it.
    component, unit, options
        As for `read_motion`.

    Raises
    ------
    InputError
        A file that cannot be read: its name is in the sentence.

    Warns
    -----
    InputWarning
        Files are left out: velocities and displacements, boreholes, records of the vertical alone, tables and
        pictures.
    """
    records: dict[Hashable, list[ReadFile]] = {}
    left_out: dict[str, list[str]] = {}
    for path in sorted(folder.iterdir()):
        if not path.is_file() or path.name.startswith(".") or path.suffix.lower() in _PASSED_OVER:
            continue
        if _NO_RECORD.search(path.name):
            left_out.setdefault("no_record", []).append(path.name)
            continue
        try:
            with naming(path):
                file = read_file(path, unit, several=True, **options)
        except InputError as error:
            if error.code not in _LEFT_OUT:
                raise
            left_out.setdefault(_LEFT_OUT[error.code], []).append(path.name)
            continue
        if all(channel.borehole for channel in file.channels):
            left_out.setdefault("in_borehole", []).append(path.name)
        else:
            records.setdefault(_record_of(file) or path, []).append(file)
    for key, files in list(records.items()):
        if all(is_vertical(channel.label) for file in files for channel in file.channels):
            left_out.setdefault("vertical_only", []).extend(file.path.name for file in records.pop(key))
    if left_out:
        files = joined((_listed(kind, names) for kind, names in left_out.items()), ("; ", "、"))
        warn(InputWarning("motion.suite_left_out", "source", name=title, files=files))
    return [_motion(files, component) for files in records.values()]


@contextmanager
def naming(path: Path) -> Generator[None]:
    """Refuse a file of many with its name."""
    try:
        yield
    except InputError as error:
        if path.name in str(error):
            raise
        raise error.at(path.name) from None


def _record_of(file: ReadFile) -> Hashable:
    """Return what tells the record that a file's one channel is of; None of several or where nothing does."""
    channel = file.channels[0]
    if len(file.channels) > 1:
        return None
    if number := _RECORD_NUMBER.match(file.path.name):
        return int(number[1])
    origin = channel.origin or channel.name
    return plain_origin(origin) if channel.label and origin else None


def _motion(files: Sequence[ReadFile], component: str | None) -> Motion:
    """Return the motion of a record's files; x is the first horizontal channel, or the component."""

    def first_horizontal(channels: Sequence[Channel]) -> str | None:
        level = [i for i, channel in enumerate(channels, 1) if not is_vertical(channel.label)]
        return f"channel {level[0]}" if len(level) in (1, 2) else None

    with naming(files[0].path):
        if component is None and len(files) > 1:
            return motion_of(files, first_horizontal)
        return motion_of(files, along(component))


def _listed(kind: str, names: Sequence[str]) -> Phrase:
    more = phrase("motion.and_more", count=len(names) - _LISTED) if len(names) > _LISTED else ""
    return phrase(f"motion.{kind}", files=labels_phrase(names[:_LISTED]), more=more)
