"""Words in the cells of an inventory: the names of pieces, and storeys as people write them."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING

from stayput.vocabulary import LONGEST_WORD, WORDS, plain_word

if TYPE_CHECKING:
    from stayput.inventory.cells import Cell

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
    "地下": -1,
    "地階": -1,
    "basement": -1,
    "ug": -1,
    "eg": 1,
    "rdc": 1,
    "ground floor": 1,
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
