"""JMA CSV: seven header lines, then NS, EW, UD in gal.

Source: Japan Meteorological Agency, strong-motion data of major earthquakes,
https://www.data.jma.go.jp/eqev/data/kyoshin/jishin/. Coded in cp932 or UTF-8; times are JST.
"""

from __future__ import annotations

import re

import numpy as np

from stayput.errors import InputError
from stayput.motion.channels import Channel, plain_label
from stayput.motion.readers.fields import check_rows, number_after, numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

FORMAT = "JMA CSV"

_RATE = r"^ *SAMPLING +(?:RATE|FREQ)[^=\n]{0,20}= *([0-9.]{1,12})"
_UNIT = re.compile(r"^ *UNIT *= *([^,\n]{1,30})", re.IGNORECASE | re.MULTILINE)
_NAMES = re.compile(r"^ *[NEU][SWD] *(?:, *[NEU][SWD] *)+[, ]*$", re.IGNORECASE)
_HEADER_LINES = 12


def recognise(text: str) -> bool:
    """Return whether the file begins with its site code and states a sampling rate."""
    head = text[:2000].upper()
    return head.lstrip().startswith("SITE CODE") and "SAMPLING" in head


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        No sampling rate, unit or line of names; a row with too few or too many values.
    """
    lines = text.split("\n")
    names_at = next((i for i, line in enumerate(lines[:_HEADER_LINES]) if _NAMES.match(line)), None)
    if names_at is None:
        raise InputError("The header has no line of component names; it must have one such as NS,EW,UD.")
    header = "\n".join(lines[:names_at])
    rate = number_after(_RATE, header, "sampling rate")
    if not rate > 0.0:
        raise InputError(f"The sampling rate is {rate:g} Hz; it must be more than 0 Hz.")
    stated = _UNIT.search(header)
    factor = acceleration_unit(stated[1] if stated else None, unit)
    labels = [name.strip().upper() for name in lines[names_at].rstrip(", ").split(",")]
    if len({plain_label(label) for label in labels}) < len(labels):
        raise InputError(f"The component names are {', '.join(labels)}; they must differ.")
    rows = [line.rstrip(", \t") for line in lines[names_at + 1 :]]
    while rows and not rows[-1]:
        rows.pop()
    check_rows(rows, len(labels) - 1)
    values = numbers(",".join(rows).split(",") if rows else [], "the samples")
    samples = factor * values.reshape(-1, len(labels))
    site = re.sub(r"^.*?=", "", lines[0]).split(",")[0].strip()
    step = time_step(1.0 / rate, dt)
    return [Channel(name, np.ascontiguousarray(samples[:, i]), step, site) for i, name in enumerate(labels)]
