"""Words in the cells of an inventory in the languages of its users: presets, surfaces, contents, storeys."""

from __future__ import annotations

import re
import unicodedata
from typing import TYPE_CHECKING

from stayput.catalogue import names

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.inventory.cells import Cell

STOREY = re.compile(r"[1-9][0-9]{0,2}(?:\.0)?\s*(?:f|fl|階)?", re.IGNORECASE | re.ASCII)
"""A storey as people write it: 3, 3F, 3階."""

OTHER_NAMES = {
    "bookshelf": "bookcase",
    "book shelf": "bookcase",
    "書棚": "bookcase",
    "書架": "bookcase",
    "洋服タンス": "wardrobe",
    "整理タンス": "chest",
    "fridge": "refrigerator",
    "tv": "television",
    "自販機": "vending machine",
    "サーバラック": "server rack",
    "piano": "upright piano",
    "ピアノ": "upright piano",
}
"""Further names of presets of furniture."""


def plain_word(text: str) -> str:
    """Return a word in one spelling: of width, case and blanks."""
    return " ".join(unicodedata.normalize("NFKC", text).lower().split())


def _words(*tables: Mapping[str, tuple[str, str]]) -> dict[str, str]:
    """Return the keys of tables of names by their names; of two with one name, the first."""
    words: dict[str, str] = {}
    for table in tables:
        for key, labels in table.items():
            for word in (key, *labels):
                words.setdefault(plain_word(word), key)
    return words


WORDS: dict[str, dict[str, str]] = {
    "preset": _words(names.FURNITURE, names.PIECES) | OTHER_NAMES,
    "floor": _words(names.SURFACES),
    "contents": _words(names.CONTENTS),
}
"""What the words of a column stand for."""


def meant(column: str, cell: Cell) -> Cell:
    """Return what a cell stands for: the name of a preset for what people call it; else the cell as it is."""
    if not isinstance(cell, str) or not cell or len(cell) > 100:
        return cell
    return WORDS[column].get(plain_word(cell), cell)


def preset_called(name: Cell) -> str | None:
    """Return the preset that a piece is called, or None where its name is no preset's."""
    return WORDS["preset"].get(plain_word(name)) if isinstance(name, str) and len(name) <= 100 else None


def storey_meant(cell: Cell) -> Cell:
    """Return the number of a storey such as "3F" or "3階"; any other cell as it is."""
    if isinstance(cell, str) and len(cell) <= 20:
        text = unicodedata.normalize("NFKC", cell).strip()
        if STOREY.fullmatch(text):
            return re.match(r"\d+", text)[0]  # type: ignore[index]
    return cell
