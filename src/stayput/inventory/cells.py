"""Cells of an inventory: what one may hold, and the sentence where it does not."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TypeAlias

from stayput.errors import InputError, within

LONGEST = 1000
"""Most characters of a cell."""

SHOWN = 40
"""Characters of a cell that a sentence shows."""

_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u200b\u200e\u200f\u2028-\u202e\u2060-\u2069\ufeff]")
"""What nobody sees, and what turns the order of other letters."""

_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)


@dataclass(frozen=True, slots=True)
class Unusable:
    """A cell that can be nothing: a formula, a date, an error of the spreadsheet.

    Parameters
    ----------
    what : str
        What it is, with its article.
    """

    what: str


Cell: TypeAlias = "str | float | int | Unusable | None"
"""What a table gives: text, a number, nothing, or something that is of no use."""


def plain(name: str, cell: Cell) -> str | float | int | None:
    """Return a cell as text without blanks around it, a number, or None where it is empty.

    Raises
    ------
    InputError
        A formula or the like, or a text that is too long or goes over several lines.
    """
    if isinstance(cell, Unusable):
        raise InputError(f"{name} is {cell.what}; it must be a plain text or number.")
    if not isinstance(cell, str):
        return cell
    if not cell:
        return None
    if len(cell) > LONGEST:
        raise InputError(f"{name} has {len(cell)} characters; it must have at most {LONGEST}.")
    text = cell.strip()
    if "\n" in text or "\r" in text:
        raise InputError(f"{name} goes over several lines; it must be one line (is a quote missing?).")
    if _CONTROL.search(text) is not None:
        raise InputError(f"{name} has a control character or an invisible one; it must be plain text.")
    if text.startswith("="):
        raise InputError(f"{name} is a formula; it must be a plain text or number.")
    return text or None


def shown(value: object) -> str:
    """Return a value as a sentence shows it."""
    text = repr(value)
    return text if len(text) <= SHOWN else f"{text[:SHOWN]}…"


def text_of(name: str, cell: Cell, longest: int = 200) -> str | None:
    """Return a cell as text; a whole number is written without a point.

    Raises
    ------
    InputError
        A cell that is not of use, or too long.
    """
    value = plain(name, cell)
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    text = None if value is None else str(value)
    if text is not None and len(text) > longest:
        raise InputError(f"{name} has {len(text)} characters; it must have at most {longest}.")
    return text


def number_of(name: str, cell: Cell, unit: str = "") -> float | None:
    """Return a cell as a finite number.

    Raises
    ------
    InputError
        Something else than a plain number: with its unit, with a decimal comma, not finite.
    """
    value = plain(name, cell)
    if value is None:
        return None
    allowed = f"it must be a plain number{f' in {unit}' if unit else ''}"
    if isinstance(value, str):
        if _NUMBER.fullmatch(value) is None:
            hint = ", without its unit" if unit and re.match(r"[+-]?[\d.,]+\s*[^\d.,]+$", value) else ""
            raise InputError(f"{name} is {shown(value)}; {allowed}{hint}.")
        value = float(value)
    if not math.isfinite(value):
        raise InputError(f"{name} is {value}; {allowed}.")
    return float(value)


def whole_of(name: str, cell: Cell, low: int, high: int) -> int | None:
    """Return a cell as a whole number.

    Raises
    ------
    InputError
        Not a whole number, or out of range.
    """
    value = number_of(name, cell)
    if value is None:
        return None
    if not value.is_integer():
        raise InputError(f"{name} is {value:g}; it must be a whole number.")
    return int(within(name, value, low, high))


def numbers_of(name: str, cell: Cell, unit: str = "", most: int = 100) -> tuple[float, ...]:
    """Return the numbers of a cell, with semicolons between them; none where it is empty.

    Raises
    ------
    InputError
        One of them is not a plain number, or there are too many.
    """
    value = plain(name, cell)
    if value is None:
        return ()
    parts = value.split(";") if isinstance(value, str) else [value]
    if len(parts) > most:
        raise InputError(f"{name} has {len(parts)} numbers; it must have at most {most}.")
    found = [number_of(name, part, unit) for part in parts]
    missing = InputError(f"{name} is {shown(value)}; between its semicolons there must be numbers.")
    if any(one is None for one in found):
        raise missing
    return tuple(one for one in found if one is not None)
