"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z. Lines that begin
with "#", "%", "//" or "!" are comments. Titles, a line of headings and a row of units may stand above the
numbers: the column that is headed "time" or "t" is the time, in s or "[ms]"; without such a heading the first
is. A comment may state the order, "columns: t, UD, NS, EW", and the unit, "unit: m/s²"; each heading states
that of its column, as in "t, NS (gal), EW (gal), UD (g)"; the caller must do it otherwise. Above one column
the number of samples and the time step may stand: "4000 0.02".
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from stayput.errors import InputError, without_control
from stayput.motion.channels import Channel, is_direction
from stayput.motion.readers.fields import Numbers, check_count, numbers
from stayput.motion.readers.header import regular_step, stated_unit, time_step
from stayput.motion.readers.headings import column_factors, is_title, read_headings, split
from stayput.motion.readers.text import chunks

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FORMAT = "columns of numbers"

_COMMENT = ("#", "%", "//", "!")
_STARTS = re.compile(r"[\"']?[+\-]?\.?[0-9]")
_LABELS = {1: [""], 2: ["", ""], 4: ["t", "x", "y", "z"]}
_HEAD = 20_000  # characters at the beginning in which comments and titles are looked for


@dataclass
class _Head:
    """The beginning of a file.

    Attributes
    ----------
    comments : list of str
        Its comments, without their marks.
    titles : list of str
        The lines of words above the numbers.
    rows : list of str
        The first two lines of numbers.
    """

    comments: list[str] = field(default_factory=list[str])
    titles: list[str] = field(default_factory=list[str])
    rows: list[str] = field(default_factory=list[str])

    def states_count(self) -> bool:
        """Return whether the number of samples and the time step stand above one column."""
        first, second = [*map(split, self.rows), [], []][:2]
        return (
            len(first) == 2 and len(second) == 1 and any(len(text) > 1 and text.isdecimal() for text in first)
        )


def _head(text: str) -> _Head:
    head = _Head()
    for line in map(str.strip, without_control(text[:_HEAD]).split("\n")):
        if line.startswith(_COMMENT):
            head.comments.append(line.lstrip("#%/! "))
        elif line and not head.rows and is_title(line):
            head.titles.append(line)
        elif line and len(head.rows) < 2:
            head.rows.append(line)
    return head


def recognise(text: str) -> bool:
    """Return whether numbers follow the comments, the titles and the headings."""
    return any(_STARTS.match(line) for line in _head(text).rows)


def _table(text: str, skipped: int) -> NDArray[np.float64]:
    """Return the numbers, shape (rows, columns), below as many lines of words."""
    table, count, row = Numbers("the_numbers"), 0, 0
    for chunk in chunks(text):
        tokens: list[str] = []
        for line in map(str.strip, chunk.split("\n")):
            seen = line if line.isascii() else without_control(line).strip()
            if not seen or seen.startswith(_COMMENT):
                continue
            if skipped:
                skipped -= 1
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
    titles = [line for line in head.titles if any(map(str.isalnum, line))]  # no rules of dashes
    above, counted = head.comments + titles, head.states_count()
    table = _table(text, len(head.titles) + counted)
    count = table.shape[1]
    headings = read_headings(titles, head.comments, count, head.rows[0])
    stated = next(filter(None, map(stated_unit, above)), None)
    place = " ".join(above)
    step_missing = count == 1 and dt is None and not counted
    factors = column_factors(headings, count, stated, unit, "\n".join(above), step_missing=step_missing)
    if len(table) < 2:
        raise InputError("motion.column_one_row")
    if count == 1:
        label, step = next(filter(is_direction, headings.names), ""), None
        if counted:
            step, size = sorted(numbers(split(head.rows[0]), "the_line_before_the_samples").tolist())
            check_count(len(table), size)
        # Some files begin with the number of samples: nearly as large as the number of lines, and no sample.
        elif len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
            raise InputError("motion.column_count_first", number=float(table[0, 0]))
        return [Channel(label, factors[0] * table[:, 0], time_step(step, dt), location=place)]
    labels = headings.names or _LABELS[count]
    time = headings.time or 0
    step = regular_step(headings.time_factor * table[:, time])
    # The column's times are rounded: the two may differ by a fifth of a step at the last sample.
    if dt is not None and abs(dt - step) * (len(table) - 1) > 0.2 * step:
        raise InputError("motion.time_column_step", "dt", given=dt, step=step)
    step = time_step(step if dt is None else dt, None)
    return [
        Channel(label, factors[i] * table[:, i], step, location=place)
        for i, label in enumerate(labels)
        if i != time
    ]
