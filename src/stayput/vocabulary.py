"""What people call furniture, floors, contents, buildings and classes of shaking, in the users' languages."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Iterable, Mapping
from typing import TypeVar

from stayput.catalogue import Phrase, names
from stayput.errors import unknown

Said = TypeVar("Said")

LONGEST_WORD = 100
"""Longest text that may be such a name [characters]."""

TATAMI = "tatami, along the weave"
"""The surface that tatami is taken for where nobody says how it lies: the lower of its two frictions."""

OTHER_NAMES: dict[str, dict[str, str]] = {
    "preset": {
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
    },
    "floor": {
        "wood": "wood flooring",
        "wooden floor": "wood flooring",
        "wood floor": "wood flooring",
        "板張り": "wood flooring",
        "板の間": "wood flooring",
        "木の床": "wood flooring",
        "vinyl floor": "vinyl",
        "ビニール床": "vinyl",
        "塩ビシート": "vinyl",
        "長尺シート": "vinyl",
        "tatami": TATAMI,
        "畳": TATAMI,
        "たたみ": TATAMI,
        "carpet tiles": "carpet",
        "タイルカーペット": "carpet",
        "じゅうたん": "carpet",
        "絨毯": "carpet",
    },
    "contents": {},
    "structure": {
        "RC造": "RC",
        "鉄筋コンクリート": "RC",
        "S": "steel",
        "S造": "steel",
        "鉄骨": "steel",
        "W": "wood",
        "W造": "wood",
        "木": "wood",
        "timber": "wood",
        "免震": "base-isolated",
        "免震建物": "base-isolated",
    },
    "intensity": {
        **{label.removeprefix("震度"): key for key, (_, label) in names.INTENSITIES.items()},
        **{key.replace("-lower", "-").replace("-upper", "+"): key for key in names.INTENSITIES},
    },
}
"""Further names, beside those that the catalogue tells."""


def plain_word(text: str) -> str:
    """Return a word in one spelling: of width, case and blanks."""
    return " ".join(unicodedata.normalize("NFKC", text).lower().split())


def _spelled(kind: str, *tables: Mapping[str, tuple[str, str]]) -> dict[str, str]:
    """Return the keys of tables of names by their names, and by further ones; of two with one, the first."""
    words: dict[str, str] = {}
    for table in tables:
        for key, labels in table.items():
            for word in (key, *labels):
                words.setdefault(word, key)
    return words | OTHER_NAMES[kind]


_NAMES = {
    "preset": (names.FURNITURE, names.PIECES),
    "floor": (names.SURFACES,),
    "contents": (names.CONTENTS,),
    "structure": (names.STRUCTURES,),
    "intensity": (names.INTENSITIES,),
}
"""The catalogue's names of each kind; of two for one key, the first."""

_SPELLED = {kind: _spelled(kind, *tables) for kind, tables in _NAMES.items()}

WORDS: dict[str, dict[str, str]] = {
    kind: {plain_word(word): key for word, key in reversed(words.items())} for kind, words in _SPELLED.items()
}
"""What the words of a kind stand for, each as `plain_word` gives it."""


def meant(kind: str, value: Said) -> Said | str:
    """Return the name of a preset for what people call it; anything else as it is.

    Examples
    --------
    >>> meant("floor", "フローリング"), meant("structure", "木造"), meant("preset", 3.0)
    ('wood flooring', 'wood', 3.0)
    >>> meant("intensity", "震度６強")
    '6-upper'
    """
    if not isinstance(value, str) or not value or len(value) > LONGEST_WORD:
        return value
    return WORDS[kind].get(plain_word(value), value)


def also_called(presets: Iterable[str]) -> list[str]:
    """Return what people call presets besides their names, as a sentence may offer it."""
    wanted = frozenset(presets)
    return [
        word
        for words in _SPELLED.values()
        for word, key in words.items()
        if key in wanted and plain_word(word) != plain_word(key)
    ]


def listed(presets: Collection[str]) -> Phrase:
    """Return the names of presets of one kind in English and Japanese; any other names as they are."""
    tables = next((tables for tables in _NAMES.values() if set[str]().union(*tables).issuperset(presets)), ())
    japanese = {key: label for table in reversed(tables) for key, (_, label) in table.items()}
    return ", ".join(map(repr, presets)), ", ".join(repr(japanese.get(key, key)) for key in presets)


def preset_meant(
    kind: str, name: str | Phrase, value: object, known: Collection[str], field: str | None = None
) -> str:
    """Return the name of a preset for what people call it.

    Parameters
    ----------
    kind : str
        Of `WORDS`.
    name : str or Phrase
        What a sentence calls it; see `stayput.errors.finite`.
    value : object
        The word.
    known : collection of str
        The presets.
    field : str, optional
        Dotted name of the input.

    Raises
    ------
    InputError
        No preset is called so.
    """
    word = meant(kind, value)
    if not isinstance(word, str) or word not in known:
        raise unknown(name, value, known, field, also_called(known), listed(known))
    return word
