"""PEER AT2: four header lines, then the samples in g, 5 or 8 a line.

Source: PEER strong-motion and NGA databases, https://ngawest2.berkeley.edu. The last header line is
"NPTS=  4000, DT= .01000 SEC" or, in older files, "4096    0.0100    NPTS, DT".
"""

from __future__ import annotations

import re
from itertools import islice

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel, in_borehole
from stayput.motion.readers.fields import check_count, free_numbers, quantity
from stayput.motion.readers.header import acceleration_unit, stated_unit, time_step
from stayput.motion.readers.text import lines

FORMAT = "PEER AT2"

_WORD = re.compile(r"[A-Z]+")
_NAMED = re.compile(r"NPTS ?[=:] ?([^ ,=:]{1,40}) ?,? ?DT ?[=:] ?(.+)", re.IGNORECASE)
_BARE = re.compile(r"([^ ,=]{1,40}) ([^ ,=]{1,40}) NPTS ?, ?DT\b.*", re.IGNORECASE)
_OTHER = re.compile(r"\b(?:(VEL(?:OCITY)?)|DISP?L?(?:ACEMENT)?)\b", re.IGNORECASE)
_DIRECTION = re.compile(
    r"[0-9]{1,3}|[NSEWUVZ]|[NEUV][SWD]|UP|DOWN|DWN|DN|VERT?|VERTICAL|NORTH|SOUTH|EAST|WEST|[HV][12]|[LRTXY]"
    r"|LONG|TRANS?|(?:[BCEHLMNS][HLGN][NE]|[A-Z]{2}Z)[0-9]{0,2}",
    re.IGNORECASE,
)
_VERTICAL = re.compile(r"UP|UD|DOWN|DWN|DN|VERT?|VERTICAL|Z|V1|[BCEHLMNS][HLGN]Z[0-9]{0,2}", re.IGNORECASE)
_BESIDE = re.compile(r"COMP(?:ONENT)?|CHANNEL|DIR(?:ECTION)?", re.IGNORECASE)
_HEADER_LINES = 8
_SECONDS = ("SEC", "S", "SECS", "SECOND", "SECONDS")


def _header(text: str) -> tuple[list[str], str, int] | None:
    """Return the lines above that of NPTS and DT, that line with single blanks, and where the next is."""
    before: list[str] = []
    for start, line in islice(lines(text), _HEADER_LINES):
        if {"NPTS", "DT"} <= set(_WORD.findall(line.upper())):
            return before, " ".join(line.split()), start + len(line) + 1
        before.append(line)
    return None


def recognise(text: str) -> bool:
    """Return whether one of the first lines states NPTS and DT."""
    return _header(text) is not None


def _direction(title: str) -> tuple[str, str]:
    """Return the direction at the end of a title "event, station, direction", and what stands before it.

    A vertical one is known behind other words too.
    """
    before, comma, last = title.rpartition(",")
    last = re.sub(r"(?<=[^(\s]) *\(.*", "", last)  # "(USGS STATION 117)"
    words = [word for word in re.findall(r"[A-Za-z0-9]+", last) if not _BESIDE.fullmatch(word)]
    for count in (len(words), 2, 1):
        label = "".join(words[-count:])
        if (comma and count == len(words) and _DIRECTION.fullmatch(label)) or _VERTICAL.fullmatch(label):
            begin = last.rfind(words[-count])
            before = before if count == len(words) and comma else f"{before}{comma}{last[:begin]}"
            return ("V" if label.upper() == "V1" else label), before.strip(" ,-=")
    return "", title


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

    Raises
    ------
    InputError
        It is not an acceleration, states no unit, or has not as many samples as it states.
    """
    header = _header(text)
    if header is None:
        raise InputError("motion.peer_no_npts")
    before, size, start = header
    titles = [line.strip() for line in before if line.strip()]
    # The last such line: the first one may hold any text.
    kind = next((line for line in titles[::-1] if "UNITS" in line.upper() or "TIME" in line.upper()), "")
    if other := _OTHER.search(kind):
        raise InputError(
            "motion.peer_no_acceleration", kind=phrase(f"motion.{'velocity' if other[1] else 'displacement'}")
        )
    factor = acceleration_unit(stated_unit(kind) or stated_unit(" ".join(titles)), unit, " ".join(titles))
    match = _NAMED.search(size) or _BARE.fullmatch(size)
    if match is None:
        raise InputError("motion.peer_npts_line", line=excerpt(size))
    count = quantity(match[1], (), "npts")
    words = match[2].split()
    unit_of_step = words[1:2] if words[1:2] and words[1].rstrip(".,").isalpha() else []
    step = quantity(" ".join([words[0].rstrip(","), *unit_of_step]), _SECONDS, "dt")
    samples = free_numbers(text, start, "the_samples")
    check_count(len(samples), count)
    title = titles[1] if len(titles) > 1 else ""
    label, place = _direction(title)
    step, below = time_step(step, dt), in_borehole(label, titles)
    return [Channel(label, factor * samples, step, place, location=" ".join(titles), borehole=below)]
