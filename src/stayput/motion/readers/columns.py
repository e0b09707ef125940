"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z. Lines that begin
with "#", "%" or "//" are comments. One line of column names may stand above the numbers. A comment that says
"unit: m/s²" states the unit, and so do names of columns that all have the same one, as in
"t, NS (gal), EW (gal), UD (gal)"; the caller must do it otherwise.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import Numbers
from stayput.motion.readers.header import (
    acceleration_unit,
    mentioned_unit,
    regular_step,
    stated_unit,
    time_step,
)
from stayput.motion.readers.text import chunks
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FORMAT = "columns of numbers"

_COMMENT = ("#", "%", "//")
_STARTS = re.compile(r"[+\-]?\.?[0-9]")
_NAME = re.compile(r"[A-Za-z][A-Za-z\-]{0,11}")
_TIME = re.compile(r"t(?![a-z])|.*time", re.IGNORECASE)
_NOT_FINITE = re.compile(r"[+\-]?(?:nan|inf|infinity)", re.IGNORECASE)
_LABELS = {1: [""], 2: ["", ""], 4: ["t", "x", "y", "z"]}
_HEAD = 20_000  # characters at the beginning in which comments and names are looked for


def _split(line: str) -> list[str]:
    for mark in (";", ","):
        if mark in line:
            return [value.strip() for value in line.rstrip(f"{mark} \t").split(mark)]
    return line.split()


@dataclass
class _Head:
    """The beginning of a file.

    Attributes
    ----------
    comments : list of str
        Its comments.
    content : list of str
        Its first two lines that are neither comments nor blank.
    """

    comments: list[str] = field(default_factory=list[str])
    content: list[str] = field(default_factory=list[str])


def _head(text: str) -> _Head:
    head = _Head()
    for line in map(str.strip, text[:_HEAD].split("\n")):
        if line.startswith(_COMMENT):
            head.comments.append(line)
        elif line and len(head.content) < 2:
            head.content.append(line)
    return head


def recognise(text: str) -> bool:
    """Return whether the first line, or the one below a line of names, begins with a number."""
    return any(_STARTS.match(line) for line in _head(text).content)


def _is_names(line: str) -> bool:
    """Return whether every field begins like a name, and none is a number that is not finite."""
    fields = [text.strip("\"' ") for text in _split(line)]
    return all(_NAME.match(text) and not _NOT_FINITE.fullmatch(text) for text in fields)


def _headings(above: list[str]) -> list[str]:
    """Return the fields of the last line above the numbers, which may name the columns."""
    return _split(above[-1].lstrip("#%/ ")) if above else []


def _unit_of_columns(above: list[str], count: int) -> str | None:
    """Return the one unit in the names of all columns but the time's: "t, NS (gal), EW (gal), UD (gal)"."""
    headings = _headings(above)
    if len(headings) != count or not _TIME.match(headings[0].strip("\"' ")):
        return None
    units = [mentioned_unit(heading) for heading in headings[1:]]
    same = None not in units and len({unit_factor(unit or "") for unit in units}) == 1
    return units[0] if same else None


def _names(above: list[str], count: int) -> list[str]:
    """Return the columns' names, from the last line above the numbers where that has as many."""
    fields = _headings(above)
    names = [m[0] if (m := _NAME.match(text.strip("\"' "))) else "" for text in fields]
    return names if len(names) == count and all(names) else _LABELS[count]


def _table(text: str, named: bool) -> NDArray[np.float64]:
    """Return the numbers, shape (rows, columns); the first line is passed over where it has the names."""
    table, count, row = Numbers("the_numbers"), 0, 0
    for chunk in chunks(text):
        tokens: list[str] = []
        for line in map(str.strip, chunk.split("\n")):
            if not line or line.startswith(_COMMENT):
                continue
            if named:
                named = False
                continue
            values = _split(line)
            row, count = row + 1, count or len(values)
            if count not in _LABELS:
                raise InputError("motion.column_count", columns=count)
            if len(values) != count:
                raise InputError("motion.column_row", row=row, count=len(values), columns=count)
            tokens += values
        table.add(tokens)
    if not count:
        raise InputError("motion.column_no_rows")
    return table.array().reshape(-1, count)


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels: one, or three.

    Raises
    ------
    InputError
        No unit or time step, another number of columns, an incomplete row, irregular sampling.
    """
    head = _head(text)
    named = bool(head.content) and _is_names(head.content[0])
    above = head.comments + head.content[:1] if named else head.comments
    table = _table(text, named)
    count = table.shape[1]
    stated = next(filter(None, map(stated_unit, head.comments)), None) or _unit_of_columns(above, count)
    factor = acceleration_unit(stated, unit, "\n".join(above), step_missing=count == 1 and dt is None)
    if len(table) < 2:
        raise InputError("motion.column_one_row")
    labels = _names(above, count)
    place = " ".join(above)
    if count == 1:
        # Some files begin with the number of samples: nearly as large as the number of lines, and no sample.
        if len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
            raise InputError("motion.column_count_first", number=float(table[0, 0]))
        return [Channel("", factor * table[:, 0], time_step(None, dt), location=place)]
    step = regular_step(table[:, 0])
    # The column's times are rounded: the two may differ by a fifth of a step at the last sample.
    if dt is not None and abs(dt - step) * (len(table) - 1) > 0.2 * step:
        raise InputError("motion.time_column_step", "dt", given=dt, step=step)
    step = time_step(step if dt is None else dt, None)
    return [
        Channel(label, factor * table[:, i], step, location=place)
        for i, label in enumerate(labels[1:], start=1)
    ]
