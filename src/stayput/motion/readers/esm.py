"""ESM (DYNA 1.2) ASCII, also of ITACA and AFAD: "KEY: value" lines, then the samples; one channel a file.

Source: Engineering Strong-Motion database, https://esm-db.eu. AFAD writes some values in small letters.
"""

from __future__ import annotations

import re

from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import check_count, free_numbers, numbers
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.readers.text import lines

FORMAT = "ESM ASCII"

_ENTRY = re.compile(r"\s*([A-Za-z][A-Za-z0-9_/^]*) ?: ?(.*)")
_NEEDED = [
    re.compile(rf"^ *{key} ?:", re.IGNORECASE | re.MULTILINE) for key in ("NDATA", "SAMPLING_INTERVAL_S")
]


def recognise(text: str) -> bool:
    """Return whether the header states the number of samples and their interval."""
    head = text[:10000]
    return bool(_ENTRY.match(head)) and all(needed.search(head) for needed in _NEEDED)


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

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
        raise InputError("motion.esm_no_acceleration", kind=excerpt(kind))
    missing = [key for key in ("NDATA", "SAMPLING_INTERVAL_S") if not header.get(key)]
    if missing:
        raise InputError("motion.no_header_entry", what=(missing[0], f"「{missing[0]}」"))
    count, step = numbers([header["NDATA"], header["SAMPLING_INTERVAL_S"]], "the_esm_size")
    factor = acceleration_unit(header.get("UNITS") or None, unit)
    samples = free_numbers(text, begin, "the_samples")
    check_count(len(samples), float(count))
    if header.get("DURATION_S"):
        duration = float(numbers([header["DURATION_S"]], "the_esm_duration")[0])
        # Some writers count samples, others the steps between them, and round to milliseconds.
        if abs(duration - step * count) > 1.5 * step + 1e-3:
            raise InputError("motion.esm_duration", stated=duration, duration=float(step * count))
    pga = header.get("PGA_CM/S^2")
    peak = 0.01 * float(numbers([pga], "the_esm_peak")[0]) if pga else None
    name = ".".join(header[key] for key in ("NETWORK", "STATION_CODE") if header.get(key))
    event = header.get("EVENT_ID") or header.get("EVENT_NAME", "")
    title = ", ".join(part for part in (name, event) if part)
    place = header.get("STATION_NAME", "")
    step = time_step(float(step), dt)
    return [Channel(header.get("STREAM", ""), factor * samples, step, title, peak, location=place)]
