"""Every sentence that stayput says, in English and in Japanese, each once and under an id.

An id is ``"<module>.<key>"``: ``"motion.no_unit"`` is the key ``no_unit`` of `stayput.catalogue.motion`,
which holds the sentences of the package `stayput.motion`. The ``TEXTS`` of a module are its texts by their
keys, in English and in Japanese. What varies stands in braces, with the format specifications of
`str.format`. The catalogue knows nothing of the rest of stayput: its modules hold strings only.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules
from typing import Literal, TypeGuard

Language = Literal["en", "ja"]

LANGUAGES: tuple[Language, ...] = ("en", "ja")
"""The languages, in the order of a `Phrase`."""

Phrase = tuple[str, str]
"""A text in English and in Japanese."""

TEXTS: Mapping[str, Phrase] = {
    f"{module.name}.{key}": text
    for module in iter_modules(__path__)
    if module.name not in ("names", "motion_files")  # which are no part of an id
    for key, text in import_module(f"{__name__}.{module.name}").TEXTS.items()
}
"""All texts by their ids."""


def phrase(text: str | Phrase, **values: object) -> Phrase:
    """Return a text in both languages, with its values filled in.

    Parameters
    ----------
    text : str or Phrase
        The id of a text, or a text in both languages.
    **values
        What stands in its braces; a value that is itself a `Phrase` is filled in in each language.

    Raises
    ------
    KeyError
        There is no such text, or it needs another value.

    Examples
    --------
    >>> phrase("common.too_large", name="dt")
    ('dt is too large; it must be a finite number.', 'dtが大きすぎます。有限の数値を指定してください。')
    """
    both = TEXTS[text] if isinstance(text, str) else text
    if not values:
        return both
    english, japanese = (
        both[place].format_map({key: _in_language(value, place) for key, value in values.items()})
        for place in range(len(LANGUAGES))
    )
    return english, japanese


def say(text: str | Phrase, language: str = "en", **values: object) -> str:
    """Return a text in one of `LANGUAGES`, with its values filled in; see `phrase`."""
    return phrase(text, **values)[LANGUAGES.index(language)]


def is_phrase(value: object) -> TypeGuard[Phrase]:
    """Tell whether a value is a text in both languages."""
    match value:
        case (str(), str()):
            return True
        case _:
            return False


def _in_language(value: object, place: int) -> object:
    return value[place] if is_phrase(value) else value
