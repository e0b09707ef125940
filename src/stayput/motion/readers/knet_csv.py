"""K-NET CSV: "#" header lines, then date and time, seconds, and NS, EW, UD with their offset.

Source: NIED K-NET and KiK-net, https://www.kyoshin.bosai.go.jp. The line "#Offset" states what is to be
subtracted from each component.
"""

from __future__ import annotations

import re

import numpy as np

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.columns import regular_step
from stayput.motion.readers.fields import check_rows, numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

FORMAT = "K-NET CSV"

_DEFAULT_LABELS = ["NS", "EW", "UD"]
_LABEL = re.compile(r"(?<![A-Z])(NS|EW|UD|N-S|E-W|U-D)([12]?)(?![A-Z])", re.IGNORECASE)
_DATE = re.compile(r" *[0-9]{4}[-/][0-9]{1,2}[-/][0-9]{1,2}[ T]+[0-9]{1,2}:")
_VALUE = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def recognise(text: str) -> bool:
    """Return whether the file begins with "#" lines and has "#Offset" among them or dates below them."""
    lines = text[:10000].split("\n")
    return text.startswith("#") and any(_key(line) == "offset" or _DATE.match(line) for line in lines)


def _key(line: str) -> str:
    found = re.match(r"# *([A-Za-z]+)", line)
    return found[1].lower() if found else ""


def _labels(line: str) -> list[str]:
    found = [m[1].replace("-", "").upper() + m[2] for m in _LABEL.finditer(line)]
    return found if len(found) >= 3 else []


def _values(line: str, count: int) -> list[float]:
    plain = re.sub(r"\([^)]*\)|\[[^\]]*\]", " ", line)
    found = _VALUE.findall(plain)
    if len(found) != count:
        raise InputError(f"The header line {line[:60]!r} has {len(found)} numbers; it must have {count}.")
    return [float(value) for value in found]


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        The offsets or the unit are not stated, a row is incomplete, or the sampling is not regular.
    """
    lines = text.split("\n")
    header = [line for line in lines if line.startswith("#")]
    rows = [line.rstrip(", \t") for line in lines if line.strip() and not line.startswith("#")]
    names = rows.pop(0) if rows and _labels(rows[0]) else header[-1] if header else ""
    labels = _labels(names) or _DEFAULT_LABELS
    offset = next((line for line in header if _key(line) == "offset"), None)
    if offset is None:
        raise InputError("The header has no line #Offset; it must state what to subtract.")
    offsets = _values(offset, len(labels))
    stated = "gal" if re.search(r"\bgal\b", "\n".join(header), re.IGNORECASE) else None
    factor = acceleration_unit(stated, unit)
    undated = next((row for row in rows if not _DATE.match(row)), None)
    if undated is not None:
        raise InputError(f"The row {undated[:40]!r} has no date and time; each must begin with them.")
    check_rows(rows, len(labels) + 1)
    tokens = [value for row in rows for value in row.split(",")[1:]]
    table = numbers(tokens, "the samples").reshape(-1, len(labels) + 1)
    if len(table) < 2:
        raise InputError(f"The file has {len(table)} rows of samples; it must have at least 2.")
    step = time_step(regular_step(table[:, 0]), dt)
    samples = factor * (table[:, 1:] - np.array(offsets))
    station = next(
        (re.split(r"[,:=]", line, maxsplit=1)[-1].strip(" ,") for line in header if _key(line) == "station"),
        "",
    )
    return [
        Channel(name, np.ascontiguousarray(samples[:, i]), step, station, note=", offset removed")
        for i, name in enumerate(labels)
    ]
