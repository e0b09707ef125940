"""Upper floors of buildings that records are of, and the rules that hold for the ground alone."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, excerpt

if TYPE_CHECKING:
    from stayput.motion.record import Motion

# How names and headers write the upper floor of a building: "42nd Floor", "floor42", "42F", "42階". A number
# of storeys ("52-STORY BLDG", "12階建") and a floor below the ground ("地下2階") are not meant.
_ORDINALS = ["second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh"]
_ORDINAL = (
    rf"(?<![0-9a-z])(?<!basement )([0-9]{{1,3}}(?= ?(?:st|nd|rd|th))|{'|'.join(_ORDINALS)})"
    r"(?: ?(?:st|nd|rd|th))?[ _-]{1,2}(?:floor|flr?|storey|story|level)(?![a-z])"
)
_OTHER_LEVEL = r"(?! ?[0-9]+ (?:data|earthquake|ground|motion|seismic|shaking|input|wave))"
_NUMBERED = (
    r"(?<![a-z])(?:floor|fl\.|storey|story"
    rf"|(?<!sea )(?<!data )(?<!ing )(?<!basement )level{_OTHER_LEVEL})[ _-]?([0-9]{{1,3}})(?!\.?[0-9])"
)
_SHORT = r"(?<![a-z0-9.])([0-9]{1,3})/?(?:f|fl|flr)(?![a-z0-9])"
_JAPANESE = r"(?<!地下)(?<![0-9])([0-9]{1,3}) ?階(?!建)"
_UPPER_FLOOR = re.compile(f"{_ORDINAL}|{_NUMBERED}|{_SHORT}|{_JAPANESE}", re.IGNORECASE)
_HIGH = re.compile(
    r"(?<![a-z])(?:top|upper|uppermost)[ _-](?:floor|storey|story|level)(?![a-z])|最上階", re.IGNORECASE
)
_ROOF = re.compile(r"(?<![a-z])(?:roof|rooftop|penthouse)(?![a-z])|屋上", re.IGNORECASE)


BOREHOLE = "borehole"
"""The `Motion.floor` of a sensor below the ground."""


def upper_floor(texts: Iterable[str]) -> str:
    """Return the upper floor of a building that texts name: "floor 42", "roof", "upper floor"; else "".

    A first floor, a ground floor and a basement are none.

    Parameters
    ----------
    texts : iterable of str
        A record's name and what its header says.
    """
    for text in texts:
        for match in _UPPER_FLOOR.finditer(text):
            said = next(filter(None, match.groups())).lower()
            if (floor := _ORDINALS.index(said) + 2 if said in _ORDINALS else int(said)) > 1:
                return f"floor {floor}"
        if _ROOF.search(text):
            return "roof"
        if _HIGH.search(text):
            return "upper floor"
    return ""


def floor_phrase(floor: str) -> Phrase:
    """Return where a motion is of in both languages, by its `Motion.floor`."""
    kind, _, number = floor.partition(" ")
    if kind in ("floor", "storey"):
        return phrase(f"motion.{kind}_number", number=number)
    named = {
        "": "ground",
        "roof": "roof_place",
        "upper floor": "some_upper_floor",
        BOREHOLE: "borehole_place",
    }
    return phrase(f"motion.{named[floor]}") if floor in named else (floor, floor)


def of_the_ground(motion: Motion, rule: str) -> Motion:
    """Return a motion; refuse one of an upper floor for a rule that holds for the ground alone.

    Parameters
    ----------
    motion : Motion
        The motion.
    rule : str
        Which rule, as ``ground_alone_...`` of the catalogue of motions says it.

    Raises
    ------
    InputError
        The motion is of an upper floor.
    """
    if motion.floor:
        reason, floor = phrase(f"motion.ground_alone_{rule}"), floor_phrase(motion.floor)
        raise InputError(
            "motion.not_of_the_ground", "motion", motion=excerpt(motion.name), floor=floor, rule=reason
        )
    return motion
