"""Cells of an inventory: reading them as text and numbers, and refusing what they may not hold."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from stayput.catalogue import phrase
from stayput.errors import InputError, has_control, whole_within
from stayput.inventory.columns import UNITS

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
_WITH_REST = re.compile(r"([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*([^\d\s.,].*)?", re.ASCII)
_GROUPS = re.compile(
    r"[+-]?[1-9]\d{0,2}"
    r"(?:(?:,\d{3}){2,}(?:\.\d*)?|(?:\.\d{3}){2,}(?:,\d*)?|,\d{3}\.\d+|\.\d{3},\d+)",
    re.ASCII,
)
"""A number with two marks of thousands or more, or one and another mark, which can be no decimal ones."""

_WHOLE_UNITS = ("mm", "g")
"""Units so small that nobody writes thousandths of them: a comma before three digits is one of thousands."""

WHOLE = ("count", "value", "costs")
"""Columns of counts and of money, in which a point before three digits may be one of thousands."""

_FULL_WIDTH = str.maketrans("０１２３４５６７８９＋，－．", "0123456789+,-.")
"""Full-width digits, signs and marks by their usual ones."""


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
_SIGN_OF_MONEY = re.compile(r"[¥￥\\$€]\s*(?=\d)|(?<=\d)\s*[円€]")
_AMOUNT = re.compile(r"[¥\\$€]?\s*(\d{1,3}(?:,\d{3})+(?:\.\d{1,2})?|\d+(?:\.\d*)?)\s*[円€]?", re.ASCII)

Cell: TypeAlias = "str | float | int | Unusable | None"
"""A cell of a table: text, a number, nothing, or something that cannot be used."""

CellReader: TypeAlias = Callable[[Cell], Cell]
"""Makes a column's own text or number of a cell in another unit or spelling."""


def is_empty(cell: Cell) -> bool:
    """Return whether a cell holds nothing, or only blanks."""
    return cell is None or (isinstance(cell, str) and not cell.strip())


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
        Something else than a number: with a unit that is unknown, with a decimal comma, not finite.
    """
    value = plain(name, cell)
    if value is None:
        return None
    if isinstance(value, str):
        text = half_width(value)
        if _may_be_thousands(name, text, unit):
            raise InputError("inventory_tables.comma", name, name=name, value=shown(value))
        number = _in_unit(text, unit)
        if number is None:
            hint: Phrase | str = ""
            if _DECIMAL_COMMA.fullmatch(text):
                hint = phrase("inventory_tables.decimal_comma")
            elif unit and re.match(r"[+-]?[\d.,]+\s*[^\d.,]+$", value):
                hint = phrase("inventory.without_unit")
            raise _not_a_plain_number(name, shown(value), unit, hint)
        value = number
    if not math.isfinite(value):
        raise _not_a_plain_number(name, str(value), unit)
    return float(value)


def _may_be_thousands(name: str, text: str, unit: str) -> bool:
    """Return whether a number has a point that would leave thousandths of what nobody divides so finely."""
    parted = _WITH_REST.fullmatch(text)
    if parted is None or "," in parted[1] or _THOUSANDS.fullmatch(parted[1]) is None:
        return False
    return name in WHOLE or (_unit_behind(parted) or unit) in _WHOLE_UNITS


def half_width(text: str) -> str:
    """Return a text whose full-width digits, signs and marks are the usual ones."""
    return text if text.isascii() else text.translate(_FULL_WIDTH)


def _in_unit(text: str, unit: str) -> float | None:
    """Return the number of a text in a unit, converted from the one behind it; None where it is none."""
    parted = _WITH_REST.fullmatch(text)
    if parted is None:
        return None
    number, written = parted[1], _unit_behind(parted)
    factor = _factor(written, unit) if written else (1.0, 1.0)
    number = without_thousands(number, written or unit)
    if factor is None or _NUMBER.fullmatch(number) is None:
        return None
    times, over = factor
    return float(number) * times / over


def _unit_behind(parted: re.Match[str]) -> str:
    return unicodedata.normalize("NFKC", parted[2] or "").strip().lower()


def _factor(written: str, unit: str) -> tuple[float, float] | None:
    """Return what a number in a unit is multiplied with and divided by to be in another of its kind."""
    for units in UNITS.values():
        own, wanted = units.get(written), units.get(unit)
        if own is not None and wanted is not None:
            return (1.0, 1.0) if own == wanted else (own.times * wanted.over, own.over * wanted.times)
    return None


def without_thousands(number: str, unit: str, marks: str = ",") -> str:
    """Return a number without marks between its thousands where they can be nothing else; else as it is."""
    if _GROUPS.fullmatch(number):
        mark = next(letter for letter in number if letter in ".,")
        return number.replace(mark, "").replace(",", ".")
    if unit in _WHOLE_UNITS and _THOUSANDS.fullmatch(number) and any(mark in number for mark in marks):
        return re.sub("[.,]", "", number)
    return number


def _not_a_plain_number(name: str, value: str, unit: str, hint: Phrase | str = "") -> InputError:
    return InputError(
        "inventory.not_plain_number",
        name,
        name=name,
        value=value,
        unit=phrase("inventory.in_unit", unit=unit) if unit else "",
        hint=hint,
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
    return whole_within(name, value, low, high, field=name)


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
        text = half_width(cell.strip())
        text = text.replace(",", ".") if _DECIMAL_COMMA.fullmatch(text) else text
        cell = float(text) if _NUMBER.fullmatch(text) else None
    return float(cell) if isinstance(cell, int | float) and math.isfinite(cell) else None


def in_own_unit(cell: Cell, kind: str) -> bool:
    """Return whether a cell is a number with a unit behind it, of the kind of a column's unit."""
    parted = _WITH_REST.fullmatch(half_width(cell.strip())) if isinstance(cell, str) else None
    return parted is not None and _unit_behind(parted) in UNITS[kind]


def refuse_without_unit(name: str, cell: Cell) -> Cell:
    """Return a cell of a column in which every number has a unit of its own.

    Raises
    ------
    InputError
        A number without a unit.
    """
    if number_or_none(cell) is not None:
        raise InputError("inventory_tables.cell_without_unit", name, name=name, value=shown(cell))
    return cell


def with_point(name: str, text: str, kind: str, money: bool = False) -> str:
    """Return a number of a table in which commas may be decimal, with a point; any other text as it is.

    An amount of money loses its sign.

    Raises
    ------
    InputError
        The comma or the point may be one of thousands.
    """
    parted = _WITH_REST.fullmatch(_SIGN_OF_MONEY.sub("", text.strip(), 1) if money else text.strip())
    if parted is None:
        return text
    number, rest = without_thousands(parted[1], parted[2] or kind, ".,"), parted[2] or ""
    if _THOUSANDS.fullmatch(number) and (rest or kind) not in ("m", "°"):  # a piece of 1800 m is none
        raise InputError("inventory_tables.comma", name, name=name, value=shown(text))
    return (number.replace(",", ".") if _DECIMAL_COMMA.fullmatch(number) else number) + rest


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
        text = half_width(text) if isinstance(text, str) else text
        if decimal_comma and isinstance(text, str):
            text = with_point(name, text, written, kind == "currency")
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
