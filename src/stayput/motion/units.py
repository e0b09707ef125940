"""Units of acceleration, by the names that records and their users write."""

from __future__ import annotations

import re
import unicodedata
from typing import TYPE_CHECKING

from stayput.errors import InputError, excerpt
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from stayput.catalogue import Phrase

ACCELERATION_UNITS = {
    "m/s²": 1.0,
    "cm/s²": 0.01,
    "gal": 0.01,
    "mm/s²": 0.001,
    "g": STANDARD_GRAVITY,
    "%g": 0.01 * STANDARD_GRAVITY,
    "mg": 0.001 * STANDARD_GRAVITY,
    "in/s²": 0.0254,
    "ft/s²": 0.3048,
}
"""Size of each accepted unit [m/s²]."""

UNIT_NAMES: Phrase = ", ".join(ACCELERATION_UNITS), "、".join(ACCELERATION_UNITS)
"""The accepted units, as a sentence lists them."""

_PER_SECOND_TWICE = r"(?:/s/s|[/p_.·⋅]?\(?s(?:\^|\*\*)?[-−]?2\)?)"
_LENGTHS = {"meters?|metres?|m": "m", "centimet(?:er|re)s?|cm": "cm", "millimet(?:er|re)s?|mm": "mm"} | {
    "inch(?:es)?|in\\.?": "in",
    "feet|foot|ft\\.?": "ft",
}
_SPELLINGS = {rf"(?:{length}){_PER_SECOND_TWICE}": f"{name}/s²" for length, name in _LENGTHS.items()} | {
    "gals?|ガル": "gal",
    "g's|gs?": "g",
    "(?:%|percent|pct)(?:of)?g": "%g",
    "milli-?g|mg": "mg",
}
_NAMED = {re.compile(spelling): name for spelling, name in _SPELLINGS.items()}
_BRACKET = re.compile(r"([^()\[\]]+)[(\[]([^()\[\]]*)[)\]]?")


def unit_factor(unit: str) -> float:
    """Return the size of a unit of acceleration [m/s²].

    Parameters
    ----------
    unit : str
        A name of `ACCELERATION_UNITS` in any spelling that is in use: ``cm/s2``, ``cm/s/s``,
        ``CM/SEC/SEC``, ``gal(cm/s/s)``, ``m s^-2``, ...

    Raises
    ------
    InputError
        The name is none of them.
    """
    name = known_unit(str(unit))
    if name is None:
        raise InputError("motion.unknown_unit", "unit", unit=excerpt(str(unit)), known=UNIT_NAMES)
    return ACCELERATION_UNITS[name]


def known_unit(unit: str) -> str | None:
    """Return the name that `ACCELERATION_UNITS` has for a unit, or None where it has none."""
    plain = re.sub(r"\s", "", unicodedata.normalize("NFKC", unit[:100]).lower()).rstrip(".")
    plain = re.sub(r"sec(?:ond)?s?", "s", plain)
    if twice := _BRACKET.fullmatch(plain):  # "gal(cm/s/s)"
        first, second = known_unit(twice[1]), known_unit(twice[2])
        same = first and second and ACCELERATION_UNITS[first] == ACCELERATION_UNITS[second]
        return first if same else None
    return next((name for spelling, name in _NAMED.items() if spelling.fullmatch(plain)), None)
