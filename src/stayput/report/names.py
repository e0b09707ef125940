"""Names of presets, places of devices, and motions, in one language."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.catalogue.names import FAMILIES, MOTIONS, PIECES, PLACES, SURFACES

if TYPE_CHECKING:
    from stayput.motion import Motion

_NAMES = {
    **{name: label for name, (label, _) in FAMILIES.items()},
    **MOTIONS,
    **PIECES,
    **PLACES,
    **SURFACES,
}

_MEMBER = re.compile(r"synthetic (.+) (\d+)")
"""What a motion of a synthetic suite is called: its kind of earthquake and its number."""

_SINE = re.compile(r"(sine) (.+)")
"""What a sine is called: with its amplitude and frequency."""


def named(name: str, language: str) -> str:
    """Return a preset's name in a language; a name of the user's own stays as it is, as all do in English."""
    return name if language == "en" or name not in _NAMES else say(_NAMES[name], language)


def place_named(place: str, language: str) -> str:
    """Return the place of a device in a language: "front left", or "前面側・左"."""
    return place if language == "en" else "・".join(named(part, language) for part in place.split())


def motion_named(name: str, language: str) -> str:
    """Return a motion's name in a language; a record's stays as it is."""
    if language == "en":
        return name
    if member := _MEMBER.fullmatch(name):
        return say("report.suite_member", language, family=named(member[1], language), number=member[2])
    if sine := _SINE.fullmatch(name):
        return f"{named(sine[1], language)} {sine[2]}"
    return named(name, language)


def motion_label(motion: Motion, language: str = "en") -> str:
    """Return a motion's label in pictures; a computed one is always labelled synthetic."""
    if not motion.name:
        return say("runs.unnamed", language)
    name = motion_named(motion.name, language)
    plain = motion.synthetic and "synthetic" not in motion.name.lower()
    return say("runs.synthetic", language, name=name) if plain else name
