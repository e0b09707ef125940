"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z. Lines that begin
with "#", "%" or "//" are comments; one that says "unit: m/s²" states the unit, which the caller
must do otherwise. One line of column names may stand above the numbers.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

if TYPE_CHECKING:
    from numpy.typing import NDArray

FORMAT = "columns of numbers"

_COMMENT = ("#", "%", "//")
_STARTS = re.compile(r"[+\-]?\.?[0-9]")
_NAME = re.compile(r"[A-Za-z][A-Za-z\-]{0,11}")
_NOT_FINITE = re.compile(r"[+\-]?(?:nan|inf|infinity)", re.IGNORECASE)
_UNIT = re.compile(r"\bunit:\s*(\S{1,20})", re.IGNORECASE)
_LABELS = {1: [""], 2: ["", ""], 4: ["t", "x", "y", "z"]}


def _split(line: str) -> list[str]:
    for mark in (";", ","):
        if mark in line:
            return [field.strip() for field in line.rstrip(f"{mark} \t").split(mark)]
    return line.split()


def _content(text: str) -> list[str]:
    lines = (line.strip() for line in text.split("\n"))
    return [line for line in lines if line and not line.startswith(_COMMENT)]


def recognise(text: str) -> bool:
    """Return whether the first line, or the one below a line of names, begins with a number."""
    return any(_STARTS.match(line) for line in _content(text[:20000])[:2])


def regular_step(time: NDArray[np.float64]) -> float:
    """Return the step of equally spaced times [s]; they may be rounded to a fifth of it.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Times [s], n ≥ 2.

    Raises
    ------
    InputError
        The times do not grow, or not by equal steps.
    """
    n = len(time)
    step = float(time[-1] - time[0]) / (n - 1)
    if not step > 0.0:
        raise InputError(f"The time runs from {time[0]:g} s to {time[-1]:g} s; it must grow.")
    off = np.abs(time - (time[0] + step * np.arange(n)))
    if off.max() > 0.2 * step:
        worst = int(off.argmax())
        raise InputError(
            f"The sampling is irregular near {time[worst]:g} s; the time must grow by equal steps."
        )
    for digits in range(1, 12):  # the printed times are rounded, and so is the step they give
        nominal = round(step, digits)
        if nominal > 0.0 and abs(nominal - step) * (n - 1) <= 1e-3 * step + 1e-9:
            return nominal
    return step


def _is_names(line: str) -> bool:
    """Return whether every field begins like a name, and none is a number that is not finite."""
    fields = [field.strip("\"' ") for field in _split(line)]
    return all(_NAME.match(field) and not _NOT_FINITE.fullmatch(field) for field in fields)


def _names(text: str, content: list[str], count: int) -> list[str]:
    above = [
        line.strip().lstrip("#%/ ") for line in text[:20000].split("\n") if line.strip().startswith(_COMMENT)
    ]
    if _is_names(content[0]):
        above.append(content[0])
    fields = _split(above[-1]) if above else []
    found = [m[0] if (m := _NAME.match(field.strip("\"' "))) else "" for field in fields]
    return found if len(found) == count and all(found) else _LABELS[count]


def _stated_unit(text: str) -> str | None:
    comments = (line.strip() for line in text[:20000].split("\n"))
    found = [m[1] for line in comments if line.startswith(_COMMENT) and (m := _UNIT.search(line))]
    return found[0] if found else None


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels: one, or three.

    Raises
    ------
    InputError
        No unit or time step, another number of columns, an incomplete row, irregular sampling.
    """
    factor = acceleration_unit(_stated_unit(text), unit)
    content = _content(text)
    rows = [_split(line) for line in content[_is_names(content[0]) :]]
    count = len(rows[0]) if rows else 0
    if count not in _LABELS:
        raise InputError(
            f"The file has {count} columns; it must have 1 (x), 2 (time, x) or 4 (time, x, y, z)."
        )
    for i, row in enumerate(rows):
        if len(row) != count:
            raise InputError(f"Row {i + 1} has {len(row)} values; it must have {count} like the first.")
    table = numbers([value for row in rows for value in row], "the numbers").reshape(-1, count)
    if len(table) < 2:
        raise InputError("The file has one row of numbers; it must have at least 2.")
    labels = _names(text, content, count)
    if count == 1:
        if len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
            raise InputError(
                f"The first number, {table[0, 0]:g}, looks like a count; only samples may stand there."
            )
        return [Channel("", factor * table[:, 0], time_step(None, dt))]
    step = regular_step(table[:, 0])
    if dt is not None and abs(dt - step) * (len(table) - 1) > 0.2 * step:
        raise InputError(f"The dt is given as {dt:g} s; it must be the one of the time column, {step:g} s.")
    step = time_step(step if dt is None else dt, None)
    samples = factor * np.ascontiguousarray(table[:, 1:].T)
    return [Channel(label, a, step) for label, a in zip(labels[1:], samples, strict=True)]
