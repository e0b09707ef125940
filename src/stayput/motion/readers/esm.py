"""ESM (DYNA 1.2) ASCII: "KEY: value" lines, then one sample a line; one channel a file.

Source: Engineering Strong-Motion database, https://esm-db.eu.
"""

from __future__ import annotations

import re

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import check_count, numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

FORMAT = "ESM ASCII"

_ENTRY = re.compile(r"([A-Z][A-Z0-9_/^]*): ?(.*)")


def recognise(text: str) -> bool:
    """Return whether the header states the number of samples and their interval."""
    head = text[:10000]
    return bool(_ENTRY.match(head)) and "\nNDATA:" in head and "\nSAMPLING_INTERVAL_S:" in head


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

    Raises
    ------
    InputError
        It is not an acceleration, an entry is missing, or there are not as many samples as stated.
    """
    lines = text.split("\n")
    header: dict[str, str] = {}
    for line in lines:
        entry = _ENTRY.match(line)
        if entry is None:
            break
        header.setdefault(entry[1], entry[2].strip())
    kind = header.get("DATA_TYPE", "")
    if kind != "ACCELERATION":
        raise InputError(f"The DATA_TYPE is {kind!r}; it must be 'ACCELERATION'.")
    missing = [key for key in ("NDATA", "SAMPLING_INTERVAL_S") if not header.get(key)]
    if missing:
        raise InputError(f"The header has no {missing[0]}; it must state it.")
    count, step = numbers([header["NDATA"], header["SAMPLING_INTERVAL_S"]], "NDATA and SAMPLING_INTERVAL_S")
    factor = acceleration_unit(header.get("UNITS") or None, unit)
    samples = numbers([line for line in lines[len(header) :] if line.strip()], "the samples")
    check_count(len(samples), float(count), "samples")
    pga = header.get("PGA_CM/S^2")
    peak = 0.01 * float(numbers([pga], "PGA_CM/S^2")[0]) if pga else None
    name = ".".join(header[key] for key in ("NETWORK", "STATION_CODE") if header.get(key))
    event = header.get("EVENT_ID") or header.get("EVENT_NAME", "")
    title = ", ".join(part for part in (name, event) if part)
    return [Channel(header.get("STREAM", ""), factor * samples, time_step(float(step), dt), title, peak)]
