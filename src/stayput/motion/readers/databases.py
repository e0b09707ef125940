"""Files of strong-motion databases that hold one channel each: PEER's, and those of ESM, ITACA and AFAD.

PEER AT2: four header lines, then the samples in g, 5 or 8 a line.

ESM ASCII: "KEY: value" lines, then the samples; one channel a file (DYNA 1.2; also of ITACA and AFAD).

Sources: PEER strong-motion and NGA databases, https://ngawest2.berkeley.edu. The last header line is
"NPTS=  4000, DT= .01000 SEC" or, in older files, "4096    0.0100    NPTS, DT". Engineering Strong-Motion
database, https://esm-db.eu; AFAD writes some values in small letters.
"""

from __future__ import annotations

import re
from itertools import islice

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel, in_borehole, is_direction
from stayput.motion.readers.text import Reader, check_count, lines, not_as_stated, numbers, quantity, words
from stayput.motion.units import acceleration_unit, not_acceleration, stated_unit, time_step

_WORD = re.compile(r"[A-Z]+")
_NAMED = re.compile(r"NPTS ?[=:] ?([^ ,=:]{1,40}) ?,? ?DT ?[=:] ?(.+)", re.IGNORECASE)
_BARE = re.compile(r"([^ ,=]{1,40}) ([^ ,=]{1,40}) NPTS ?, ?DT\b.*", re.IGNORECASE)
_OTHER = re.compile(r"\b(?:(VEL(?:OCITY)?)|DISP?L?(?:ACEMENT)?)\b", re.IGNORECASE)
_DIRECTION = re.compile(r"[0-9]{1,3}|S|V[12]", re.IGNORECASE)  # beside those of channels
_VERTICAL = re.compile(r"UP|UD|DOWN|DWN|DN|VERT?|VERTICAL|Z|V1|[BCEHLMNS][HLGN]Z[0-9]{0,2}", re.IGNORECASE)
_BESIDE = re.compile(r"COMP(?:ONENT)?|CHANNEL|DIR(?:ECTION)?", re.IGNORECASE)
_HEADER_LINES = 8
_SECONDS = ("SEC", "S", "SECS", "SECOND", "SECONDS")

_ENTRY = re.compile(r"\s*([A-Za-z][A-Za-z0-9_/^]*) ?: ?(.*)")
_NEEDED = ("NDATA", "SAMPLING_INTERVAL_S")


def _peer_header(text: str) -> tuple[list[str], str, int] | None:
    """Return the lines above that of NPTS and DT, that line with single blanks, and where the next is."""
    before: list[str] = []
    for start, line in islice(lines(text), _HEADER_LINES):
        if {"NPTS", "DT"} <= set(_WORD.findall(line.upper())):
            return before, " ".join(line.split()), start + len(line) + 1
        before.append(line)
    return None


def _direction(title: str) -> tuple[str, str]:
    """Return the direction at the end of a title "event, station, direction", and what stands before it.

    A vertical one is known behind other words too.
    """
    before, comma, last = title.rpartition(",")
    last = re.sub(r"(?<=[^(\s]) *\(.*", "", last)  # "(USGS STATION 117)"
    words = [word for word in re.findall(r"[A-Za-z0-9]+", last) if not _BESIDE.fullmatch(word)]
    for count in (len(words), 2, 1):
        label = "".join(words[-count:])
        named = _DIRECTION.fullmatch(label) or is_direction(label)
        if (comma and count == len(words) and named) or _VERTICAL.fullmatch(label):
            begin = last.rfind(words[-count])
            before = before if count == len(words) and comma else f"{before}{comma}{last[:begin]}"
            return ("V" if label.upper() == "V1" else label), before.strip(" ,-=")
    return "", title


def _read_peer(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the one channel of PEER's file.

    Raises
    ------
    InputError
        It is not an acceleration, states no unit, or has not as many samples as it states.
    """
    header = _peer_header(text)
    assert header is not None  # as it was recognised by it
    before, size, start = header
    titles = [line.strip() for line in before if line.strip()]
    # The last such line: the first one may hold any text.
    kind = next((line for line in titles[::-1] if "UNITS" in line.upper() or "TIME" in line.upper()), "")
    if other := _OTHER.search(kind):
        raise not_acceleration(kind, "velocity" if other[1] else "displacement")
    factor = acceleration_unit(stated_unit(kind) or stated_unit(" ".join(titles)), unit, " ".join(titles))
    match = _NAMED.search(size) or _BARE.fullmatch(size)
    if match is None:
        raise InputError("motion.header_line", line=excerpt(size), wanted=phrase("motion.npts_and_dt"))
    count = quantity(match[1], (), "npts")
    number, *others = match[2].split()
    unit_of_step = others[:1] if others and others[0].rstrip(".,").isalpha() else []
    step = quantity(" ".join([number.rstrip(","), *unit_of_step]), _SECONDS, "dt")
    samples = numbers(words(text, start), "the_samples")
    check_count(len(samples), count)
    label, place = _direction(titles[1] if len(titles) > 1 else "")
    step, below = time_step(step, dt), in_borehole(label, titles)
    return [Channel(label, factor * samples, step, place, location=" ".join(titles), borehole=below)]


def _is_esm(text: str) -> bool:
    """Return whether the header states the number of samples and their interval."""
    keys = {entry[1].upper() for line in text[:10000].split("\n") if (entry := _ENTRY.match(line))}
    return bool(_ENTRY.match(text)) and keys.issuperset(_NEEDED)


def _read_esm(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the one channel of ESM's file.

    Raises
    ------
    InputError
        It is not an acceleration, an entry is missing, or there are not as many samples as stated.
    """
    header: dict[str, str] = {}
    begin = len(text)
    for start, line in lines(text):
        entry = _ENTRY.match(line)
        if entry is None and line.strip():
            begin = start
            break
        if entry is not None:
            header.setdefault(entry[1].upper(), entry[2].strip())
    kind = header.get("DATA_TYPE", "")
    if kind.upper() != "ACCELERATION":
        where = "DATA_TYPE", "「DATA_TYPE」"
        raise InputError("motion.not_acceleration", where=where, quantity=excerpt(kind))
    count, step = numbers([header.get(key, "") for key in _NEEDED], "the_esm_size").tolist()
    factor = acceleration_unit(header.get("UNITS") or None, unit)
    samples = numbers(words(text, begin), "the_samples")
    check_count(len(samples), count)
    if header.get("DURATION_S"):
        duration = float(numbers([header["DURATION_S"]], "duration")[0])
        # Some writers count samples, others the steps between them, and round to milliseconds.
        if abs(duration - step * count) > 1.5 * step + 1e-3:
            raise not_as_stated("duration", duration, step * count, " s")
    pga = header.get("PGA_CM/S^2")
    peak = 0.01 * float(numbers([pga], "the_peak")[0]) if pga else None
    name = ".".join(header[key] for key in ("NETWORK", "STATION_CODE") if header.get(key))
    event = header.get("EVENT_ID") or header.get("EVENT_NAME", "")
    title = ", ".join(part for part in (name, event) if part)
    label, place = header.get("STREAM", ""), header.get("STATION_NAME", "")
    return [Channel(label, factor * samples, time_step(step, dt), title, peak, location=place)]


PEER = Reader("PEER AT2", _peer_header, _read_peer)
ESM = Reader("ESM ASCII", _is_esm, _read_esm)
