"""Columns of numbers, parted by blanks, tabs, commas or semicolons.

One column is x, with ``dt`` from the caller; two are time and x; four are time, x, y, z; or ``columns``
says which are these, or by "rows" that each row has several samples of one series. Velocities, displacements
and the magnitude of the acceleration, by their headings, are left out beside accelerations.
Lines that begin with "#", "%", "//" or "!" are comments. Titles, a line of headings and a row of units may
stand above the numbers: the column that is headed "time" or "t" is the time, in s or "[ms]"; without such
a heading the first is, unless it counts the samples, 1, 2, 3, …: then ``dt`` must be given. A comment may
state the time step, "dt = 0.01", the order, "columns: t, UD, NS, EW", and the unit, "unit: m/s²"; each
heading states that of its column, as in "t, NS (gal), EW (gal), UD (g)"; the caller must do it otherwise.
Above the samples of one channel, one or several a row, their number and the time step may stand: "4000 0.02",
or in words, as China's CSMNC writes them: "NO. OF POINTS: 4000", "INTERVALS OF: 0.01 SEC". Below a time step
columns that are all headed by directions have no time, as in the files of Türkiye's NSMN.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypedDict, cast

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, excerpt, shown, unknown, warn, without_control
from stayput.files import named_columns
from stayput.motion import units as known_units
from stayput.motion.channels import LISTED, Channel, in_borehole, is_direction, labels_phrase
from stayput.motion.readers.headings import Headings, headings_in, is_title, read_headings, split, units_in
from stayput.motion.readers.text import Reader, check_count, is_decimal, lines, not_as_stated, numbers
from stayput.wording import joined

_COMMENT = ("#", "%", "//", "!")
_STARTS = re.compile(r"[\"']?[+\-]?\.?[0-9]")
_TOUCHING = re.compile(r"(?<=[0-9.])(?=-)")
"""Where a number of fixed width touches the next, a negative one; before an exponent's minus is its e."""
_FEWEST_ROWS = 10  # fewer do not show whether a series goes on from row to row
_CONTINUITY = 1.5
"""Ratio of changes down a column to those along the rows of one series: above; of channels, far below 1."""
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
    beginning = without_control(text[:_HEAD])
    beginning = beginning if len(text) <= _HEAD else beginning.rpartition("\n")[0]
    heading, some_lines = 0, [line.strip() for line in beginning.split("\n")]
    # Where the number of samples is stated any lines may stand above them: none is lost unnoticed.
    if known_units.stated_count(beginning) is not None:
        numeric = [bool(line) and all(map(is_decimal, _samples(line))) for line in some_lines]
        heading = next((i for i in range(len(numeric)) if all(numeric[i : i + 3])), 0)
    for i, line in enumerate(some_lines):
        if line.startswith(_COMMENT):
            head.comments.append(line.lstrip("#%/! "))
        elif (
            line and not head.rows and (i < heading or is_title(line) or (chosen and not _STARTS.match(line)))
        ):
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


def _samples(line: str) -> list[str]:
    """Return the numbers of a row of one series, which may touch."""
    return split(_TOUCHING.sub(" ", line))


def _is_one_series(text: str, skipped: int, row: str, size: float | None) -> bool:
    """Return whether rows are of several samples of one series each, and not of columns.

    They are where that makes the stated number of samples. Else all rows but the last are of one length, and
    the series changes less from a number to the next, and from row to row, than down a column.

    Raises
    ------
    InputError
        The stated number is that of neither.
    """
    width = len(_samples(row))
    body = text.rstrip().rpartition("\n")[0] if size is None else text
    values = _numbers_at(body, skipped, range(width), _samples, counted=size is not None)
    try:
        flat = numbers(values, "the_numbers")
    except InputError:
        return False
    if size is not None:
        count = min(len(flat), len(flat) // width, key=lambda count: abs(count - size))
        check_count(count, size)
        return count == len(flat)
    rows = flat.reshape(-1, width)
    if width == 1 or len(rows) < _FEWEST_ROWS:
        return False
    changes = (np.diff(rows), rows[1:, 0] - rows[:-1, -1], np.diff(rows, axis=0))
    along, over, down = (float(np.abs(change).mean()) for change in changes)
    return over < _CONTINUITY * along < down


def _numbers_at(
    text: str, skipped: int, places: Sequence[int], fields: Callable[[str], list[str]], *, counted: bool
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
        values = fields(line.strip())
        row, count = row + 1, count or len(values)
        if len(values) != count and not counted:
            about: dict[str, Any] = {"row": row, "columns": count}
            if row == 2:
                about |= {"count": len(values), "option": "skip_lines"}
                raise InputError("motion.column_first_row", "skip_lines", **about)
            raise InputError("motion.row_width", value=excerpt(line.strip()), **about)
        as_they_stand = counted or places == range(count)
        yield from values if as_they_stand else (values[place] for place in places)


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
    chosen, in_rows = ({}, True) if chosen == SERIES_IN_ROWS else (chosen or {}, False)
    head = _head(text, chosen=bool(chosen))
    if not head.rows:
        raise InputError("motion.few_rows", rows=0)
    head.titles[:], skipped = [line for line in head.titles if any(map(str.isalnum, line))], len(head.titles)
    above = head.comments + head.titles
    header = "\n".join(above)
    size: float | None = known_units.stated_count(header)
    written = known_units.stated_step(header)
    if not chosen and head.states_count():
        stated, skipped = numbers(split(head.rows.pop(0)), "the_line_before_the_samples"), skipped + 1
        written, size = sorted(stated.tolist())
    width = len(_samples(head.rows[0]))
    in_doubt = size is not None or ("t" not in chosen and (bool(chosen) or width not in _LABELS))
    series = in_rows or (in_doubt and _is_one_series(text, skipped, head.rows[0], size))
    if series and chosen and width > 1:
        raise InputError("motion.rows_of_one_series", "columns", count=width, option="columns")
    if series and size is None and not in_rows:
        warn(InputWarning("motion.rows_taken_as_samples", count=width))
    places, headings = _chosen_columns(head, chosen) if chosen else _usual_columns(head, series, written)
    if [*chosen] == ["x"] and width > 1 and not any(headings.texts[1:]):
        warn(InputWarning("motion.one_column_of_rows", "columns", count=width, option="columns"))
    # Where one column of several is read, a heading speaks of its own column alone.
    count = len(_fields(head.rows[0], chosen=bool(chosen)))
    remarks = [line for line in above if count < 3 or not headings.texts or len(headings_in(line)) != count]
    known_units.check_quantity(remarks, header)
    fields = _samples if series else partial(_fields, chosen=bool(chosen))
    values = _numbers_at(text, skipped, places, fields, counted=series)
    table = numbers(values, "the_numbers").reshape(-1, len(places))
    if line := known_units.stated_factor(above):
        raise InputError("motion.column_factor", "skip_lines", line=excerpt(line), option="skip_lines")
    stated_units = list(filter(None, map(known_units.stated_unit, above)))
    units = {known_units.unit_factor(name): name for name in stated_units if known_units.known_unit(name)}
    if len(units) > 1:
        first, second, *_ = map(excerpt, units.values())
        raise InputError("motion.stated_twice", what=phrase("motion.the_unit"), first=first, second=second)
    timeless = "t" not in chosen if chosen else len(places) == 1 or headings.time is None
    # The headings of chosen columns begin with one of the time, whether the file has that or not.
    shift = 1 if chosen and timeless else 0
    unit_above, step_missing = next(iter(stated_units), None), timeless and dt is None and written is None
    factors = known_units.column_factors(
        headings, len(places) + shift, unit_above, unit, header, step_missing=step_missing
    )[shift:]
    if len(table) < 2:
        raise InputError("motion.few_rows", rows=len(table))
    if size is not None:
        check_count(len(table), size)
    time = None if timeless else headings.time or 0
    if time is not None:
        times = headings.time_factor * table[:, time]
        counts = times[0].is_integer() and np.array_equal(times, times[0] + np.arange(len(times)))
        if counts and not headings.name_the_time():
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
    else:
        # Some files begin with the number of samples: nearly as large as the number of lines, and no sample.
        if len(table) > 10 and 1 <= len(table) - table[0, 0] <= 2:
            number = float(table[0, 0])
            raise InputError("motion.column_count_first", "skip_lines", number=number, option="skip_lines")
        step = known_units.time_step(written, dt)
    if chosen:
        labels = headings.names[shift:] or [""] * len(places)
    elif len(places) == 1:
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


def _usual_columns(head: _Head, counted: bool, step: float | None) -> tuple[Sequence[int], Headings]:
    """Return the places of the time and the accelerations, and what the headings say."""
    count = 1 if counted else len(split(head.rows[0]))
    places: Sequence[int] = range(count)
    headings = read_headings(head.titles, head.comments, count, head.rows[0], step_stated=step is not None)
    if others := known_units.other_quantities(headings):
        left_out = labels_phrase(headings.texts[place] for place in others)
        warn(InputWarning("motion.columns_left_out", "columns", columns=left_out))
        places = [place for place in places if place not in others]
        headings = headings.at(places)
    of_directions = all(is_direction(name) for i, name in enumerate(headings.names) if i != headings.time)
    if len(places) not in _LABELS and not (headings.names and of_directions):
        axes = known_units.axes_of(headings) or {"t": 0, "x": 1}
        example = ",".join(f"{role}={place + 1}" for role, place in axes.items())
        raise InputError("motion.column_count", columns=len(places), option="columns", example=example)
    return places, headings


ROLES = ("t", "x", "y", "z")
"""What a column may hold: the time, and the components of a motion."""

SERIES_IN_ROWS = {"rows": ""}
"""The choice of no columns, where each row has several samples of one series."""

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
        Headings, or places from 1 on; "rows" of one series in rows; None where nothing is said.
    name : str
        What refusals call it.

    Raises
    ------
    InputError
        Something else, no x, or one name or one column twice.
    """
    if columns is None:
        return {}
    if columns == "rows":
        return SERIES_IN_ROWS
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
