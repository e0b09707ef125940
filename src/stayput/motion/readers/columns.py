"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z. Lines that begin
with "#", "%" or "//" are comments. One line of headings may stand above the numbers: the column that is
headed "time" or "t" is the time, in s or "[ms]"; without such a heading the first is. One without
it that counts the samples, 1, 2, 3, …, is no time: ``dt`` must be given beside it. A comment that says
"unit: m/s²" states the unit, and each heading that of its column, as in "t, NS (gal), EW (gal), UD (g)"; the
caller must do it otherwise.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, without_control
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import Numbers
from stayput.motion.readers.header import regular_step, stated_unit, time_step
from stayput.motion.readers.headings import are_headings, column_factors, is_time, read_headings, split
from stayput.motion.readers.text import chunks

if TYPE_CHECKING:
    from numpy.typing import NDArray

FORMAT = "columns of numbers"

_COMMENT = ("#", "%", "//")
_STARTS = re.compile(r"[+\-]?\.?[0-9]")
_LABELS = {1: [""], 2: ["", ""], 4: ["t", "x", "y", "z"]}
_HEAD = 20_000  # characters at the beginning in which comments and names are looked for


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
    for line in map(str.strip, without_control(text[:_HEAD]).split("\n")):
        if line.startswith(_COMMENT):
            head.comments.append(line)
        elif line and len(head.content) < 2:
            head.content.append(line)
    return head


def recognise(text: str) -> bool:
    """Return whether the first line, or the one below a line of names, begins with a number."""
    return any(_STARTS.match(line) for line in _head(text).content)


def _table(text: str, named: bool) -> NDArray[np.float64]:
    """Return the numbers, shape (rows, columns); the first line is passed over where it has the names."""
    table, count, row = Numbers("the_numbers"), 0, 0
    for chunk in chunks(text):
        tokens: list[str] = []
        for line in map(str.strip, chunk.split("\n")):
            if not line or (line if line.isascii() else without_control(line)).startswith(_COMMENT):
                continue
            if named:
                named = False
                continue
            values = split(line)
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
    named = bool(head.content) and are_headings(head.content[0])
    above = head.comments + head.content[:1] if named else head.comments
    table = _table(text, named)
    count = table.shape[1]
    line = above[-1].lstrip("#%/ ") if above else ""
    headings = read_headings(line, count, None if named else "".join(head.content[:1]))
    stated = next(filter(None, map(stated_unit, head.comments)), None)
    place = " ".join(above)
    step_missing = count == 1 and dt is None
    factors = column_factors(headings, count, stated, unit, "\n".join(above), step_missing=step_missing)
    if len(table) < 2:
        raise InputError("motion.column_one_row")
    if count == 1:
        # Some files begin with the number of samples: nearly as large as the number of lines, and no sample.
        if len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
            raise InputError("motion.column_count_first", number=float(table[0, 0]))
        return [Channel("", factors[0] * table[:, 0], time_step(None, dt), location=place)]
    labels = headings.names or _LABELS[count]
    time = headings.time or 0
    times = headings.time_factor * table[:, time]
    counted = times[0].is_integer() and np.array_equal(times, times[0] + np.arange(len(times)))
    if counted and not (headings.texts and is_time(headings.texts[time])):
        if dt is None:
            raise InputError("motion.time_counts", "dt", first=times[0], second=times[1], option="dt")
        times *= dt
    step = regular_step(times)
    # The column's times are rounded: the two may differ by a fifth of a step at the last sample.
    if dt is not None and abs(dt - step) * (len(table) - 1) > 0.2 * step:
        raise InputError("motion.time_column_step", "dt", given=dt, step=step)
    step = time_step(step if dt is None else dt, None)
    return [
        Channel(label, factors[i] * table[:, i], step, location=place)
        for i, label in enumerate(labels)
        if i != time
    ]
