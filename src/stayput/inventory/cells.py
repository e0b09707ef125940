"""Cells of an inventory: reading them as text and numbers, and refusing what they may not hold."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, has_control, not_allowed, too_many
from stayput.inventory.columns import UNITS, NumberUnit
from stayput.vocabulary import LONGEST_WORD, WORDS, plain_word

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
_AMOUNT = re.compile(r"\d{1,3}(?:,\d{3})+(?:\.\d{1,2})?", re.ASCII)

Cell: TypeAlias = "str | float | int | Unusable | None"
"""A cell of a table: text, a number, nothing, or something that cannot be used."""

CellReader: TypeAlias = Callable[[Cell], Cell]
"""Makes a column's own text or number of a cell in another unit or spelling."""


def is_empty(cell: Cell) -> bool:
    """Return whether a cell holds nothing, or only blanks."""
    return cell is None or (isinstance(cell, str) and not cell.strip())


def fixing_known(cell: Cell) -> Cell:
    """Return a cell of what fixes a piece; nothing where it says that this is not known."""
    return None if plain_word(str(cell)) in ("unknown", "not known", "n/a", "?", "不明") else cell


def plain(name: str, cell: Cell) -> str | float | int | None:
    """Return a cell as text without blanks around it, a number, or None where it is empty.

    Raises
    ------
    InputError
        A formula or the like, or a text that is too long or goes over several lines.
    """
    if isinstance(cell, Unusable):
        raise not_allowed(name, cell.what, "inventory.usable", name)
    if not isinstance(cell, str):
        return cell
    if not cell:
        return None
    if len(cell) > LONGEST:
        raise too_many(name, len(cell), "motion.characters", LONGEST, name)
    text = cell.strip()
    if has_control(text):
        raise not_allowed(name, shown(text), "common.plain_text", name)
    if text.startswith("="):
        raise not_allowed(name, phrase("inventory.cell_formula"), "inventory.usable", name)
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
        raise too_many(name, len(text), "motion.characters", longest, name)
    return text


LENGTHS = (0.01, 10.0)
"""Sizes of a piece [m]; beyond, a number is in another unit than is stated."""


def length_or_none(cell: Cell, *, stated: NumberUnit | None, decimal_comma: bool) -> float | None:
    """Return a size along the wall [m]; None where it is none: without it a piece is run in the plane."""
    try:
        value = number_of("length", cell, "m", stated, decimal_comma)
    except InputError:
        return None
    return value if value is not None and LENGTHS[0] <= value <= LENGTHS[1] else None


def number_of(
    name: str, cell: Cell, unit: str = "", stated: NumberUnit | None = None, decimal_comma: bool = False
) -> float | None:
    """Return a cell as a finite number in the column's own unit.

    Parameters
    ----------
    name : str
        What a sentence calls the column.
    cell : Cell
        The cell; a unit behind its number holds before all others. An amount of money may have a sign: in
        cp932 that of the yen is a backslash.
    unit : str
        The column's own unit.
    stated : NumberUnit, optional
        The unit of numbers without one; the column's own by default.
    decimal_comma : bool
        Whether numbers may have a comma in the place of a point.

    Raises
    ------
    InputError
        Something else than a number: with a unit that is unknown, with a comma or a point that may be one of
        thousands or of decimals, not finite.
    """
    value = plain(name, cell)
    if value is None:
        return None
    money = unit == "currency"
    usual = stated.name if stated is not None else "" if money else unit
    if isinstance(value, str):
        text = half_width(value)
        number, written = _parted(_SIGN_OF_MONEY.sub("", text, 1) if money else text) or ("", "")
        if money and not decimal_comma and _AMOUNT.fullmatch(number):
            number = number.replace(",", "")
        taken = written or usual
        number = without_thousands(number, taken, ".," if decimal_comma else ",")
        if decimal_comma:
            doubtful = taken not in ("m", "°")  # a piece of 1800 m is none
        else:
            doubtful = "," not in number and (name in WHOLE or taken in _WHOLE_UNITS)
        if doubtful and _THOUSANDS.fullmatch(number):
            raise not_allowed(name, shown(value), "inventory.comma", name)
        if decimal_comma and _DECIMAL_COMMA.fullmatch(number):
            number = number.replace(",", ".")
        factor = _factor(written, usual) if written else (1.0, 1.0)
        if factor is None or _NUMBER.fullmatch(number) is None:
            hint = phrase("inventory.decimal_comma") if _DECIMAL_COMMA.fullmatch(text) else ""
            raise _not_a_plain_number(name, shown(value), usual, hint)
        value = float(number) * factor[0] / factor[1]
    if not math.isfinite(value):
        raise _not_a_plain_number(name, str(value), usual)
    return float(value) if stated is None else value * stated.times / stated.over


def half_width(text: str) -> str:
    """Return a text whose full-width digits, signs and marks are the usual ones."""
    return text if text.isascii() else text.translate(_FULL_WIDTH)


def _parted(text: str) -> tuple[str, str] | None:
    """Return the number of a text and the unit behind it, "" without one; None where it is no number."""
    matched = _WITH_REST.fullmatch(half_width(text.strip()))
    if matched is None:
        return None
    return matched[1], unicodedata.normalize("NFKC", matched[2] or "").strip().lower()


def _factor(written: str, unit: str) -> tuple[float, float] | None:
    """Return what a number in a unit is multiplied with and divided by to be in another of its kind."""
    for units in UNITS.values():
        now, wanted = units.get(written), units.get(unit)
        if now is not None and wanted is not None:
            return (1.0, 1.0) if now == wanted else (now.times * wanted.over, now.over * wanted.times)
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
    said = phrase("inventory.in_unit", unit=unit) if unit else ""
    allowed = phrase("inventory.plain_number", unit=said)
    return InputError("common.not_allowed", name, value=value, hint=hint, allowed=allowed)


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
        raise too_many(name, len(parts), "inventory.parts", MOST_NUMBERS, name)
    numbers = [number_of(name, part, unit) for part in parts]
    if any(value is None for value in numbers):
        raise not_allowed(name, shown(value), "inventory.missing_number", name)
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
    parted = _parted(cell) if isinstance(cell, str) else None
    return parted is not None and parted[1] in UNITS[kind]


def refuse_without_unit(name: str, cell: Cell) -> Cell:
    """Return a cell of a column in which every number has a unit of its own.

    Raises
    ------
    InputError
        A number without a unit.
    """
    if number_or_none(cell) is not None:
        raise not_allowed(name, shown(cell), "inventory.cell_without_unit", name)
    return cell


def numbers_read(name: str, cell: Cell, **about: Any) -> Cell:
    """Return a cell of numbers with semicolons between them in the column's own unit; see `number_of`."""
    value = plain(name, cell)
    if not isinstance(value, str) or ";" not in value:
        return value if name == "floor" else number_of(name, value, **about)  # a floor may be a surface
    numbers = (number_of(name, part, **about) for part in value.split(";"))
    return ";".join("" if number is None else str(number) for number in numbers)


ROOF = "roof"
"""The storey of a piece on the roof, whose number depends on the building."""

_STOREY = re.compile(
    r"(?:m|中)?(?P<above>[1-9]\d{0,2})(?:\.0)? ?(?:f|fl|floor|階|층)?"
    r"|(?P<upper>[1-9]\d?)\. ?og"
    r"|(?:b|地下|지하|basement) ?(?P<below>[1-9]) ?(?:f|階|층)?|(?P<under>[1-9])\. ?ug"
    r"|(?P<roof>屋上階?|r[f階]?|roof(?: ?top)?|옥상)",
    re.ASCII,
)
"""3F, 3階, and M3F or 中3階, the mezzanine below it, which is taken to move as it does; 2. OG; B1, 1. UG."""

_NAMED = {
    **dict.fromkeys(("地下", "地階", "basement", "ug"), -1),
    **dict.fromkeys(("eg", "rdc", "ground floor"), 1),
    "mezzanine": 2,
}
_DIGITS = str.maketrans("一二三四五六七八九", "123456789")


def preset_called(name: Cell) -> str | None:
    """Return the preset that a piece is called, or None where its name is no preset's."""
    if not isinstance(name, str) or len(name) > LONGEST_WORD:
        return None
    return WORDS["preset"].get(plain_word(name))


@lru_cache(maxsize=1000)
def storey_called(text: str) -> int | str | None:
    """Return the number of a storey, below 0 in a basement, or `ROOF`; None where a text is no storey."""
    word = plain_word(text).translate(_DIGITS) if len(text) <= 20 else ""
    matched = _STOREY.fullmatch(word)
    if matched is None:
        return _NAMED.get(word)
    kind, number = matched.lastgroup, matched[matched.lastgroup or 0]
    if kind == "roof":
        return ROOF
    return -int(number) if kind in ("below", "under") else int(number) + (kind == "upper")


def storey_meant(cell: Cell) -> Cell:
    """Return the storey of a cell as `storey_called` does; any cell that is none as it is."""
    storey = storey_called(cell) if isinstance(cell, str) else None
    return cell if storey is None else storey


DEEPEST = 9
"""Lowest basement that there may be."""


def storey_of(cell: Cell, highest: int) -> int | None:
    """Return the storey of a cell, below 0 in a basement; None where it is empty.

    Raises
    ------
    InputError
        No storey, or one that a building of so many does not have.
    """
    if cell == ROOF:
        return highest
    if is_empty(cell):
        return None
    storey = None if isinstance(cell, str) and number_or_none(cell) is None else number_of("storey", cell)
    if storey is None or not (1 <= storey <= highest or -DEEPEST <= storey <= -1) or storey % 1:
        raise InputError("inventory.storey", "storey", value=shown(cell), highest=highest, deepest=DEEPEST)
    return int(storey)
