"""Cells of an inventory: reading them as text and numbers, and refusing what they may not hold."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from stayput.catalogue import phrase
from stayput.errors import InputError, has_control, within

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.inventory.columns import NumberUnit

LONGEST = 1000
"""Most characters of a cell."""

MOST_NUMBERS = 100
"""Most numbers of a cell."""

SHOWN = 40
"""Characters of a cell that a sentence shows."""

_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)


@dataclass(frozen=True, slots=True)
class Unusable:
    """A cell that cannot be used: a formula, a date, an error of the spreadsheet.

    Parameters
    ----------
    what : Phrase
        What it is, with its article.
    """

    what: Phrase


_DECIMAL_COMMA = re.compile(r"[+-]?\d*,\d+", re.ASCII)
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}", re.ASCII)
_AMOUNT = re.compile(r"[¥\\$€]?\s*(\d{1,3}(?:,\d{3})+(?:\.\d{1,2})?|\d+(?:\.\d*)?)\s*円?", re.ASCII)

Cell: TypeAlias = "str | float | int | Unusable | None"
"""A cell of a table: text, a number, nothing, or something that cannot be used."""

CellReader: TypeAlias = Callable[[Cell], Cell]
"""Makes a column's own text or number of a cell in another unit or spelling."""


def plain(name: str, cell: Cell) -> str | float | int | None:
    """Return a cell as text without blanks around it, a number, or None where it is empty.

    Raises
    ------
    InputError
        A formula or the like, or a text that is too long or goes over several lines.
    """
    if isinstance(cell, Unusable):
        raise InputError("inventory.unusable", name, name=name, what=cell.what)
    if not isinstance(cell, str):
        return cell
    if not cell:
        return None
    if len(cell) > LONGEST:
        raise InputError("inventory.too_long", name, name=name, count=len(cell), most=LONGEST)
    text = cell.strip()
    if "\n" in text or "\r" in text:
        raise InputError("inventory.several_lines", name, name=name)
    if has_control(text):
        raise InputError("inventory.control_character", name, name=name)
    if text.startswith("="):
        raise InputError("inventory.unusable", name, name=name, what=phrase("inventory.cell_formula"))
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
        raise InputError("inventory.too_long", name, name=name, count=len(text), most=longest)
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
    if isinstance(value, str):
        if _NUMBER.fullmatch(value) is None:
            has_unit = bool(unit) and re.match(r"[+-]?[\d.,]+\s*[^\d.,]+$", value) is not None
            raise _not_a_plain_number(name, shown(value), unit, has_unit)
        value = float(value)
    if not math.isfinite(value):
        raise _not_a_plain_number(name, str(value), unit, False)
    return float(value)


def _not_a_plain_number(name: str, value: str, unit: str, has_unit: bool) -> InputError:
    return InputError(
        "inventory.not_plain_number",
        name,
        name=name,
        value=value,
        unit=phrase("inventory.in_unit", unit=unit) if unit else "",
        hint=phrase("inventory.without_unit") if has_unit else "",
    )


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
        raise InputError("common.not_whole", name, name=name, value=value)
    return int(within(name, value, low, high, field=name))


def numbers_of(name: str, cell: Cell, unit: str = "") -> tuple[float, ...]:
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
    if len(parts) > MOST_NUMBERS:
        raise InputError("inventory.too_many_numbers", name, name=name, count=len(parts), most=MOST_NUMBERS)
    numbers = [number_of(name, part, unit) for part in parts]
    if any(value is None for value in numbers):
        raise InputError("inventory.missing_number", name, name=name, value=shown(value))
    return tuple(value for value in numbers if value is not None)


def number_or_none(cell: Cell) -> float | None:
    """Return the number of a cell, with a point or a comma, or None where it is none."""
    if isinstance(cell, str):
        text = cell.strip()
        text = text.replace(",", ".") if _DECIMAL_COMMA.fullmatch(text) else text
        cell = float(text) if _NUMBER.fullmatch(text) else None
    return float(cell) if isinstance(cell, int | float) and math.isfinite(cell) else None


def with_point(name: str, text: str, kind: str) -> str:
    """Return a number of a table in which commas may be decimal, with a point; any other text as it is.

    Raises
    ------
    InputError
        The comma or the point may be one of thousands.
    """
    if _THOUSANDS.fullmatch(text.strip()) and kind not in ("m", "°"):  # a piece of 1800 m is none
        raise InputError("inventory_tables.comma", name, name=name, value=shown(text))
    return text.replace(",", ".") if _DECIMAL_COMMA.fullmatch(text.strip()) else text


def amount_of(text: str) -> str:
    """Return an amount of money without its sign and the commas of its thousands; any other text as it is.

    In cp932 the sign of the yen is a backslash.
    """
    matched = _AMOUNT.fullmatch(text.strip().replace("￥", "¥"))
    return text if matched is None else matched[1].replace(",", "")


def converting_reader(
    name: str, unit: NumberUnit | None, kind: str, listed: bool, decimal_comma: bool
) -> CellReader:
    """Return the reader of the cells of a column of numbers.

    Parameters
    ----------
    name : str
        What a sentence calls the column.
    unit : NumberUnit, optional
        The unit of its numbers; None where it is the column's own.
    kind : str
        The column's own unit.
    listed : bool
        Whether a cell holds numbers with semicolons between them.
    decimal_comma : bool
        Whether numbers may have a comma in the place of a point.
    """
    written = kind if unit is None else unit.name

    def number(text: Cell) -> Cell:
        if decimal_comma and isinstance(text, str):
            text = with_point(name, text, written)
        elif kind == "currency" and isinstance(text, str):
            text = amount_of(text)
        if unit is None or unit.times == unit.over:
            return text
        value = number_of(name, text, written)
        return None if value is None else value * unit.times / unit.over

    def read(cell: Cell) -> Cell:
        if not listed or not isinstance(cell, str):
            return number(cell)
        return ";".join("" if part is None else str(part) for part in map(number, cell.split(";")))

    return read
