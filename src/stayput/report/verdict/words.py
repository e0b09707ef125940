"""Texts of the report of a verdict, and names of presets and motions, in one language."""

from __future__ import annotations

import re

from stayput.catalogue import TEXTS, say
from stayput.catalogue.names import FAMILIES, MOTIONS, PIECES, PLACES, SURFACES

_NAMES = {
    **{name: label for name, (label, _) in FAMILIES.items()},
    **MOTIONS,
    **PIECES,
    **PLACES,
    **SURFACES,
}

_MEMBER = re.compile(r"synthetic (.+) (\d+)")
"""What a motion of a synthetic suite is called: its kind of earthquake and its number."""


def word(key: str, language: str, **values: object) -> str:
    """Return a text of the report in "en" or "ja", with values in it.

    Parameters
    ----------
    key : str
        Its key in `stayput.catalogue.report`, or in `stayput.catalogue.common`.
    language : str
        "en" or "ja".
    **values
        What stands in its braces.
    """
    module = "report" if f"report.{key}" in TEXTS else "common"
    return say(f"{module}.{key}", language, **values)


def named(name: str, language: str) -> str:
    """Return a preset's name in a language; a name of the user's own stays as it is, as all do in English."""
    return name if language == "en" or name not in _NAMES else say(_NAMES[name], language)


def place_named(place: str, language: str) -> str:
    """Return the place of a device in a language: "front left", or "前面側・左"."""
    return place if language == "en" else "・".join(named(part, language) for part in place.split())


def motion_named(name: str, language: str) -> str:
    """Return a motion's name in a language; a record's stays as it is."""
    member = None if language == "en" else _MEMBER.fullmatch(name)
    if member is None:
        return named(name, language)
    return word("suite_member", language, family=named(member[1], language), number=member[2])
