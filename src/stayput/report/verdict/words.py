"""Texts and names of a report of a verdict in one of its languages."""

from __future__ import annotations

import re

from stayput.catalogue import LANGUAGES, phrase
from stayput.catalogue.names import FAMILIES, MOTIONS, PIECES, PLACES, SURFACES
from stayput.errors import InputError

_NAMES = {
    **{name: label for name, (label, _) in FAMILIES.items()},
    **MOTIONS,
    **PIECES,
    **PLACES,
    **SURFACES,
}

_MEMBER = re.compile(r"synthetic (.+) (\d+)")
"""What a motion of a synthetic suite is called: its kind of earthquake and its number."""


def check_language(language: str) -> str:
    """Return a language, or refuse it.

    Raises
    ------
    InputError
        It is neither "en" nor "ja".
    """
    if language not in LANGUAGES:
        raise InputError("report.no_language", "language", given=language, languages=", ".join(LANGUAGES))
    return language


def word(key: str, language: str, **values: object) -> str:
    """Return a text of the report in "en" or "ja", with values in it.

    Parameters
    ----------
    key : str
        Its key in `stayput.catalogue.report`.
    language : str
        "en" or "ja".
    **values
        What stands in its braces.
    """
    return phrase(f"report.{key}", **values)[place(language)]


def named(name: str, language: str) -> str:
    """Return a preset's name in a language; a name of the user's own stays as it is, as all do in English."""
    return name if language == "en" or name not in _NAMES else _NAMES[name][place(language)]


def motion_named(name: str, language: str) -> str:
    """Return a motion's name in a language; a record's stays as it is."""
    member = None if language == "en" else _MEMBER.fullmatch(name)
    if member is None:
        return named(name, language)
    return word("suite_member", language, family=named(member[1], language), number=member[2])


def place(language: str) -> int:
    """Return where a language stands in a `stayput.catalogue.Phrase`: 0 for "en", 1 for "ja"."""
    return [str(one) for one in LANGUAGES].index(language)
