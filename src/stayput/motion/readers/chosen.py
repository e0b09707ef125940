"""Which columns of a file are the time and the components, as the caller says it."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypedDict, cast

from stayput.errors import InputError, excerpt, shown, unknown
from stayput.spreadsheets import named_columns

if TYPE_CHECKING:
    from collections.abc import Sequence

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
        given = cast("Mapping[Any, Any]", columns if isinstance(columns, Mapping) else {})
        pairs = [(role, str(column)) for role, column in given.items() if isinstance(column, str | int)]
    for role, _ in pairs:
        if role not in ROLES:
            raise unknown(name, role, ROLES, name)
    chosen = dict(pairs)
    told = excerpt(columns) if isinstance(columns, str) else shown(cast("object", columns))
    if "x" not in chosen or not len(pairs) == len(chosen) == len(set(chosen.values())):
        raise InputError("motion.columns_like", name, name=name, value=told)
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
            found = [int(column) - 1] if 1 <= int(column) <= count else []
        else:
            wanted = _plain(column)
            found = [i for i, text in enumerate(plain) if text == wanted]
            found = found or [i for i, text in enumerate(bare) if text == wanted]
        if len(found) != 1 or found[0] in places:
            english, japanese = zip(*map(excerpt, (*headings[:10], "")), strict=True)
            listed = ", ".join((f"1–{count}", *english[:-1])), "、".join((f"1–{count}", *japanese[:-1]))
            raise InputError(
                "motion.no_such_column", "columns", role=role, column=excerpt(column), known=listed
            )
        places += found
    return places


def _plain(heading: str) -> str:
    return " ".join(unicodedata.normalize("NFKC", heading).strip("\"' ").casefold().split())
