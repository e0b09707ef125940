"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z; or ``columns`` says
which are these. Velocities and displacements, by their headings, are left out beside accelerations. Lines
that begin with "#", "%" or "//" are comments. One line of headings may stand above the numbers: the column
that is headed "time" or "t" is the time, in s or "[ms]"; without such a heading the first is. A comment that
says "unit: m/s²" states the unit, and each heading that of its column, as in "t, NS (gal), EW (gal), UD (g)";
the caller must do it otherwise.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from stayput.errors import InputError, InputWarning, excerpt, warn, without_control
from stayput.motion.channels import Channel, is_direction, labels_phrase
from stayput.motion.readers.chosen import places_of
from stayput.motion.readers.fields import Numbers
from stayput.motion.readers.header import regular_step, stated_unit, time_step
from stayput.motion.readers.headings import (
    are_headings,
    column_factors,
    other_quantities,
    read_headings,
    split,
)
from stayput.motion.readers.text import chunks

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
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


def _fields(line: str, chosen: bool) -> list[str]:
    """Return the fields of a line; where columns are chosen those between tabs may have blanks."""
    if chosen and "\t" in line:
        return [value.strip() for value in line.split("\t")]
    return split(line)


def _table(text: str, named: bool, places: Sequence[int], chosen: bool) -> NDArray[np.float64]:
    """Return the numbers of the columns at some places, shape (rows, columns).

    The first line is passed over where it has the names.
    """
    table, count, row = Numbers("the_numbers"), 0, 0
    for chunk in chunks(text):
        tokens: list[str] = []
        for line in map(str.strip, chunk.split("\n")):
            if not line or (line if line.isascii() else without_control(line)).startswith(_COMMENT):
                continue
            if named:
                named = False
                continue
            values = _fields(line, chosen)
            row, count = row + 1, count or len(values)
            as_they_stand = places == range(count)
            if len(values) != count:
                raise InputError("motion.column_row", row=row, count=len(values), columns=count)
            tokens += values if as_they_stand else [values[place] for place in places]
        table.add(tokens)
    if not count:
        raise InputError("motion.column_no_rows")
    return table.array().reshape(-1, len(places))


def read(
    text: str, unit: str | None, dt: float | None, chosen: Mapping[str, str] | None = None
) -> list[Channel]:
    """Return the channels: one, or three; or those that are chosen.

    Parameters
    ----------
    text, unit, dt
        As for every reader.
    chosen : mapping of str to str, optional
        Which columns to take; see `chosen_columns`. The others may hold anything.

    Raises
    ------
    InputError
        No unit or time step, another number of columns, an incomplete row, irregular sampling.
    """
    head = _head(text)
    first = "".join(head.content[:1])
    named = are_headings(first) if first else False
    named = named or (bool(chosen) and first != "" and not _STARTS.match(first))
    above = [*head.comments, first] if named else head.comments
    line = above[-1].lstrip("#%/ ") if above else ""
    row = "".join(head.content[1:]) if named else first
    count = len(_fields(row, bool(chosen))) if row else 0
    roles = list(chosen or ())
    places: Sequence[int] = range(count)
    if chosen:
        written = _fields(line, True)
        written = written if len(written) == count else []
        places = places_of(chosen, written, count)
        # Where no column is the time, one more heading stands for it.
        texts = [*(["t"] if "t" not in chosen else []), *(written[place] for place in places if written)]
        headings = read_headings("".join(f"{text};" for text in texts), len({"t", *chosen}), None)
        if headings.time:
            raise InputError("motion.column_no_time", column=excerpt(headings.texts[0]))
    else:
        headings = read_headings(line, count, None if named else row)
        if others := other_quantities(headings):
            left_out = labels_phrase(headings.texts[place] for place in others)
            warn(InputWarning("motion.columns_left_out", "columns", columns=left_out))
            places = [place for place in places if place not in others]
            headings = headings.at(places)
        of_directions = all(is_direction(name) for i, name in enumerate(headings.names) if i != headings.time)
        if count and len(places) not in _LABELS and not (headings.names and of_directions):
            raise InputError("motion.column_count", columns=len(places), option="columns")
    table = _table(text, named, places, bool(chosen))
    stated = next(filter(None, map(stated_unit, head.comments)), None)
    place = " ".join(above)
    timeless = "t" not in roles if chosen else len(places) == 1
    shift = 1 if chosen and timeless else 0
    step_missing = timeless and dt is None
    factors = column_factors(
        headings, len(places) + shift, stated, unit, "\n".join(above), step_missing=step_missing
    )[shift:]
    if len(table) < 2:
        raise InputError("motion.column_one_row")
    # Some files begin with the number of samples: nearly as large as the number of lines, and no sample.
    if timeless and len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
        raise InputError("motion.column_count_first", number=float(table[0, 0]))
    time = None if timeless else headings.time or 0
    if time is None:
        step = time_step(None, dt)
    else:
        step = regular_step(headings.time_factor * table[:, time])
        # The column's times are rounded: the two may differ by a fifth of a step at the last sample.
        if dt is not None and abs(dt - step) * (len(table) - 1) > 0.2 * step:
            raise InputError("motion.time_column_step", "dt", given=dt, step=step)
        step = time_step(step if dt is None else dt, None)
    if chosen:
        labels = headings.names[shift:] or [""] * len(places)
    else:
        labels = [""] if timeless else headings.names or _LABELS[len(places)]
    return [
        Channel(
            label,
            factors[i] * table[:, i],
            step,
            location=place,
            role=roles[i] if chosen else "",
            note=f", column {places[i] + 1}" if chosen else "",
        )
        for i, label in enumerate(labels)
        if i != time
    ]
