"""PEER AT2: four header lines, then the samples in g, 5 or 8 a line.

Source: PEER strong-motion and NGA databases, https://ngawest2.berkeley.edu. The last header line is
"NPTS=  4000, DT= .01000 SEC" or, in older files, "4096    0.0100    NPTS, DT".
"""

from __future__ import annotations

import re

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import check_count, free_numbers, numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

FORMAT = "PEER AT2"

_NUMBER = r"([0-9.eE+\-]{1,20})"
_NAMED = re.compile(rf"NPTS\s*=\s*{_NUMBER}\s*,?\s*DT\s*=\s*{_NUMBER}", re.IGNORECASE)
_BARE = re.compile(rf"^\s*{_NUMBER}\s+{_NUMBER}\s+NPTS\s*,\s*DT", re.IGNORECASE)
_UNIT = re.compile(r"UNITS? +OF +([A-Z][A-Z0-9/^²]{0,15})", re.IGNORECASE)
_OTHER = re.compile(r"\b(VELOCITY|DISPLACEMENT)\b", re.IGNORECASE)
_DIRECTION = re.compile(
    r"(?:[0-9]{1,3}|[NSEW]|[NEUV][SWD]|UP|DOWN|DWN|DN|VERT?)(?= *(?:$|\())", re.IGNORECASE
)
_HEADER_LINES = 8


def _size(lines: list[str]) -> tuple[int, re.Match[str]] | None:
    for i, line in enumerate(lines[:_HEADER_LINES]):
        found = _NAMED.search(line) or _BARE.search(line)
        if found:
            return i, found
    return None


def recognise(text: str) -> bool:
    """Return whether one of the first lines states NPTS and DT."""
    return _size(text.split("\n", _HEADER_LINES)[:_HEADER_LINES]) is not None


def _direction(title: str) -> str:
    found = _DIRECTION.match(title.rsplit(",", 1)[-1].strip()) if "," in title else None
    return found[0] if found else ""


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

    Raises
    ------
    InputError
        It is not an acceleration, states no unit, or has not as many samples as it states.
    """
    lines = text.split("\n")
    size = _size(lines)
    if size is None:
        raise InputError("The header has no NPTS and DT; it must state them.")
    last, found = size
    header = lines[:last]
    titles = [line.strip() for line in header if line.strip()]
    kind = next((line for line in titles if "UNITS" in line.upper() or "TIME" in line.upper()), "")
    if other := _OTHER.search(kind):
        raise InputError(f"The file is a {other[1].lower()} history; it must be an acceleration history.")
    stated = _UNIT.search(" ".join(titles))
    factor = acceleration_unit(stated[1] if stated else None, unit)
    count, step = numbers([found[1], found[2]], "the line of NPTS and DT")
    samples = free_numbers(lines[last + 1 :], "the samples")
    check_count(len(samples), count, "samples")
    title = titles[1] if len(titles) > 1 else ""
    label = _direction(title)
    place = title.rsplit(",", 1)[0].strip() if label else title
    return [Channel(label, factor * samples, time_step(float(step), dt), place)]
