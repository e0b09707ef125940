"""Words in the cells of an inventory: the names of pieces, and storeys as people write them."""

from __future__ import annotations

import re
import unicodedata
from typing import TYPE_CHECKING

from stayput.vocabulary import LONGEST_WORD, WORDS, plain_word

if TYPE_CHECKING:
    from stayput.inventory.cells import Cell

STOREY = re.compile(r"[1-9][0-9]{0,2}(?:\.0)?\s*(?:f|fl|階)?", re.IGNORECASE | re.ASCII)
"""A storey as people write it: 3, 3F, 3階."""


def preset_called(name: Cell) -> str | None:
    """Return the preset that a piece is called, or None where its name is no preset's."""
    if not isinstance(name, str) or len(name) > LONGEST_WORD:
        return None
    return WORDS["preset"].get(plain_word(name))


def storey_meant(cell: Cell) -> Cell:
    """Return the number of a storey such as "3F" or "3階"; any other cell as it is."""
    if isinstance(cell, str) and len(cell) <= 20:
        text = unicodedata.normalize("NFKC", cell).strip()
        if STOREY.fullmatch(text):
            return re.match(r"\d+", text)[0]  # type: ignore[index]
    return cell
