"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z; or ``columns``
says which are these. Velocities, displacements and the magnitude of the acceleration, by their headings, are
left out beside accelerations.
Lines that begin with "#", "%", "//" or "!" are comments. Titles, a line of headings and a row of units may
stand above the numbers: the column that is headed "time" or "t" is the time, in s or "[ms]"; without such
a heading the first is, unless it counts the samples, 1, 2, 3, …: then ``dt`` must be given. A comment may
state the time step, "dt = 0.01", the order, "columns: t, UD, NS, EW", and the unit, "unit: m/s²"; each
heading states that of its column, as in "t, NS (gal), EW (gal), UD (g)"; the caller must do it otherwise.
Above the samples of one channel, one or several a row, their number and the time step may stand: "4000 0.02".
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypedDict, cast

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, excerpt, shown, unknown, warn, without_control
from stayput.files import named_columns
from stayput.motion import units as known_units
from stayput.motion.channels import LISTED, Channel, in_borehole, is_direction, labels_phrase
from stayput.motion.readers.headings import (
    Headings,
    check_quantity,
    is_time,
    is_title,
    read_headings,
    split,
    units_in,
)
from stayput.motion.readers.text import Reader, check_count, lines, not_as_stated, numbers
from stayput.wording import joined

_COMMENT = ("#", "%", "//", "!")
_STARTS = re.compile(r"[\"']?[+\-]?\.?[0-9]")
_LABELS = {1: [""], 2: ["", ""], 4: ["t", "x", "y", "z"]}
_STATED_STEP = 0.01
"""Relative difference up to which the time column has the step that is stated above it."""

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
        """Return whether the number of samples and the time step stand above the samples of one channel."""
        first, second = [*map(split, self.rows), [], []][:2]
        counts = any(len(text) > 1 and text.isdecimal() for text in first)
        return counts and len(first) == 2 and len(second) not in (0, 2)


def _head(text: str, *, chosen: bool = False) -> _Head:
    """Return the beginning of a file; where columns are chosen their headings may be any text."""
    head = _Head()
    for line in map(str.strip, without_control(text[:_HEAD]).split("\n")):
        if line.startswith(_COMMENT):
            head.comments.append(line.lstrip("#%/! "))
        elif line and not head.rows and (is_title(line) or (chosen and not _STARTS.match(line))):
            head.titles.append(line)
        elif line and len(head.rows) < 2:
            head.rows.append(line)
    return head


def _recognise(text: str) -> bool:
    """Return whether numbers follow the comments, the titles and the headings."""
    return any(_STARTS.match(line) for line in _head(text).rows)


def _fields(line: str, *, chosen: bool) -> list[str]:
    """Return the fields of a line; where columns are chosen those between tabs may have blanks."""
    if chosen and "\t" in line:
        return [value.strip() for value in line.split("\t")]
    return split(line)


def _numbers_at(
    text: str, skipped: int, places: Sequence[int], *, chosen: bool, counted: bool
) -> Iterator[str]:
    """Yield the numbers of the columns at some places, row by row, below so many lines.

    Where their number is stated those of one column may stand in rows of any length.
    """
    count, row = 0, 0
    for _, line in lines(text):
        seen = line.strip() if line.isascii() else without_control(line).strip()
        if not seen or seen.startswith(_COMMENT):
            continue
        if skipped:
            skipped -= 1
            continue
        values = _fields(line.strip(), chosen=chosen)
        row, count = row + 1, count or len(values)
        if len(values) != count and not counted:
            about: dict[str, Any] = {"row": row, "columns": count}
            if row == 2:
                about |= {"count": len(values), "option": "skip_lines"}
                raise InputError("motion.column_first_row", "skip_lines", **about)
            raise InputError("motion.row_width", value=excerpt(line.strip()), **about)
        as_they_stand = counted or places == range(count)
        yield from values if as_they_stand else (values[place] for place in places)
    if not count:
        raise InputError("motion.few_rows", rows=0)


def read_columns(
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
    chosen = chosen or {}
    head = _head(text, chosen=bool(chosen))
    if not head.rows:
        raise InputError("motion.few_rows", rows=0)
    check_quantity(head.comments + head.titles)
    head.titles[:], skipped = [line for line in head.titles if any(map(str.isalnum, line))], len(head.titles)
    counted = not chosen and head.states_count()
    places, headings = _chosen_columns(head, chosen) if chosen else _usual_columns(head, counted)
    values = _numbers_at(text, skipped + counted, places, chosen=bool(chosen), counted=counted)
    table = numbers(values, "the_numbers").reshape(-1, len(places))
    above = head.comments + head.titles
    if line := known_units.stated_factor(above):
        raise InputError("motion.column_factor", "skip_lines", line=excerpt(line), option="skip_lines")
    units = {
        known_units.unit_factor(name): name
        for name in map(known_units.stated_unit, above)
        if name and known_units.known_unit(name)
    }
    if len(units) > 1:
        first, second, *_ = map(excerpt, units.values())
        raise InputError("motion.stated_twice", what=phrase("motion.the_unit"), first=first, second=second)
    written = known_units.stated_step("\n".join(above))
    timeless = "t" not in chosen if chosen else len(places) == 1
    # The headings of chosen columns begin with one of the time, whether the file has that or not.
    shift = 1 if chosen and timeless else 0
    factors = known_units.column_factors(
        headings,
        len(places) + shift,
        next(filter(None, map(known_units.stated_unit, above)), None),
        unit,
        "\n".join(above),
        step_missing=timeless and dt is None and written is None and not counted,
    )[shift:]
    if len(table) < 2:
        raise InputError("motion.few_rows", rows=1)
    time = None if timeless else headings.time or 0
    if time is not None:
        times = headings.time_factor * table[:, time]
        counts = times[0].is_integer() and np.array_equal(times, times[0] + np.arange(len(times)))
        if counts and not (headings.texts and is_time(headings.texts[time])):
            if (dt := written if dt is None else dt) is None:
                raise InputError("motion.time_counts", "dt", first=times[0], second=times[1], option="dt")
            times = dt * times
        step = known_units.regular_step(times, varying=dt is not None)
        # The column's times are rounded: the two may differ by a fifth of a step at the last sample.
        if dt is not None and abs(dt - step) * (len(table) - 1) > 0.2 * step:
            raise known_units.not_the_files_own("dt", f"{dt:g} s", f"{step:g} s")
        if written is not None and abs(written - step) > _STATED_STEP * step:
            raise not_as_stated("the_time_step", written, step, " s")
        step = known_units.time_step(step if dt is None else dt, None)
    elif counted:
        stated, size = sorted(numbers(split(head.rows[0]), "the_line_before_the_samples").tolist())
        check_count(len(table), size)
        step = known_units.time_step(stated, dt)
    else:
        # Some files begin with the number of samples: nearly as large as the number of lines, and no sample.
        if len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
            number = float(table[0, 0])
            raise InputError("motion.column_count_first", "skip_lines", number=number, option="skip_lines")
        step = known_units.time_step(written, dt)
    if chosen:
        labels = headings.names[shift:] or [""] * len(places)
    elif timeless:
        labels = [next(filter(is_direction, headings.names), "")]
    else:
        labels = headings.names or _LABELS[len(places)]
    roles = list(chosen)
    return [
        Channel(
            label,
            factors[i] * table[:, i],
            step,
            location=" ".join(above),
            borehole=in_borehole(label, above),
            role=roles[i] if chosen else "",
            heading=known_units.without_unit(headings.texts[i]) if headings.texts and not chosen else "",
            note=f", column {places[i] + 1}" if chosen else "",
        )
        for i, label in enumerate(labels)
        if i != time
    ]


def _chosen_columns(head: _Head, chosen: Mapping[str, str]) -> tuple[Sequence[int], Headings]:
    """Return the places of the columns that the caller chooses, and what their headings say."""
    count = len(_fields(head.rows[0], chosen=True))
    above = [*head.comments, *head.titles]
    rows = [fields for line in above if len(fields := _fields(line, chosen=True)) == count]
    units = units_in(above[-1]) if len(rows) > 1 else []
    written = rows[-2 if units else -1] if rows else []
    places = places_of(chosen, written, count)
    with_units = [f"{t} [{u}]" for t, u in zip(written, units, strict=True)] if units else written
    # Where no column is the time, one more heading stands for it.
    texts = [*(["t"] if "t" not in chosen else []), *(with_units[place] for place in places if written)]
    headings = read_headings(["".join(f"{text};" for text in texts)], [], len({"t", *chosen}), "")
    if headings.time:
        raise InputError(
            "motion.column_no_time", "columns", column=excerpt(headings.texts[0]), option="columns"
        )
    return places, headings


def _usual_columns(head: _Head, counted: bool) -> tuple[Sequence[int], Headings]:
    """Return the places of the time and the accelerations, and what the headings say."""
    count = 1 if counted else len(split(head.rows[0]))
    places: Sequence[int] = range(count)
    headings = read_headings(head.titles, head.comments, count, head.rows[0])
    if others := known_units.other_quantities(headings):
        left_out = labels_phrase(headings.texts[place] for place in others)
        warn(InputWarning("motion.columns_left_out", "columns", columns=left_out))
        places = [place for place in places if place not in others]
        headings = headings.at(places)
    of_directions = all(is_direction(name) for i, name in enumerate(headings.names) if i != headings.time)
    if len(places) not in _LABELS and not (headings.names and of_directions):
        example = (
            ",".join(f"{role}={place + 1}" for role, place in known_units.axes_of(headings).items())
            or "t=1,x=2"
        )
        raise InputError("motion.column_count", columns=len(places), option="columns", example=example)
    return places, headings


ROLES = ("t", "x", "y", "z")
"""What a column may hold: the time, and the components of a motion."""

MOST_SKIPPED = 10_000
"""Most lines that are passed over at the beginning of a file."""


class ReadingOptions(TypedDict, total=False):
    """What a caller says of a record's file: arguments of `read_motion`."""

    dt: float | None
    columns: str | Mapping[str, str | int] | None
    skip_lines: int
    decimal_comma: bool
    location: str | None
    remove_mean: bool


OPTIONS = set(ReadingOptions.__annotations__)
"""Their names."""


def chosen_columns(columns: object, name: str = "columns") -> dict[str, str]:
    """Return the columns of "t=time,x=NS", or of a mapping, by what they hold, in the order of `ROLES`.

    Parameters
    ----------
    columns : str, mapping of str to str or int, or None
        Headings, or places from 1 on; None where nothing is said.
    name : str
        What refusals call it.

    Raises
    ------
    InputError
        Something else, no x, or one name or one column twice.
    """
    if columns is None:
        return {}
    if isinstance(columns, str):
        pairs = named_columns(columns, "motion.columns_like", name)
    else:
        table = cast("Mapping[Any, Any]", columns if isinstance(columns, Mapping) else {})
        pairs = [(role, str(column)) for role, column in table.items() if isinstance(column, str | int)]
    for role, _ in pairs:
        if role not in ROLES:
            raise unknown(name, role, ROLES, name)
    chosen = dict(pairs)
    written = excerpt(columns) if isinstance(columns, str) else shown(cast("object", columns))
    if "x" not in chosen or not len(pairs) == len(chosen) == len(set(chosen.values())):
        raise InputError("motion.columns_like", name, name=name, value=written)
    return {role: chosen[role] for role in ROLES if role in chosen}


def places_of(chosen: Mapping[str, str], headings: Sequence[str], count: int) -> list[int]:
    """Return the places of the columns that are chosen.

    Parameters
    ----------
    chosen : mapping of str to str
        As `chosen_columns` returns it.
    headings : sequence of str
        The file's, as it writes them; none where it has none.
    count : int
        How many columns it has.

    Raises
    ------
    InputError
        There is no such column, or more than one.
    """
    plain = [_plain(heading) for heading in headings]
    bare = [_plain(re.split(r"[(\[]", heading)[0]) for heading in headings]
    places: list[int] = []
    for role, column in chosen.items():
        if column.isascii() and column.isdecimal():
            matches = [int(column) - 1] if 1 <= int(column) <= count else []
        else:
            wanted = _plain(column)
            matches = [i for i, text in enumerate(plain) if text == wanted]
            matches = matches or [i for i, text in enumerate(bare) if text == wanted]
        if len(matches) != 1 or matches[0] in places:
            listed = joined([(f"1–{count}", f"1–{count}"), *map(excerpt, headings[:10])], LISTED)
            raise InputError(
                "motion.no_such_column", "columns", role=role, column=excerpt(column), known=listed
            )
        places += matches
    return places


def _plain(heading: str) -> str:
    return " ".join(unicodedata.normalize("NFKC", heading).strip("\"' ").casefold().split())


COLUMNS = Reader("columns of numbers", _recognise, read_columns)
