"""Names of presets, pieces, places of devices, motions, suites, targets, buildings, floors, by language."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, say
from stayput.catalogue.names import FAMILIES, MOTIONS, PIECES, PIECES_OF_RUNS, PLACES, STRUCTURES, SURFACES
from stayput.motion.floors import floor_phrase
from stayput.wording import called, name_within

if TYPE_CHECKING:
    from stayput.motion.record import Motion
    from stayput.simulation.run import Run

_NAMES = {
    **{name: label for name, (label, _) in FAMILIES.items()},
    **MOTIONS,
    **PIECES,
    **PLACES,
    **STRUCTURES,
    **SURFACES,
}

_MADE = (
    ("report.sine", re.compile(r"sine (?P<values>.+)")),
    ("report.suite", re.compile(r"synthetic (?P<family>.+) suite, seed (?P<seed>\d+)")),
    ("report.suite_member", re.compile(r"synthetic (?P<family>.+) (?P<number>\d+)")),
    ("report.japanese_target", re.compile(r"Japanese design spectrum, (?P<level>.+), soil (?P<soil>\d)")),
    ("report.building_name", re.compile(r"(?P<storeys>\d+)-storey (?P<structure>.+) building")),
    ("report.model_name", re.compile(r"(?P<masses>\d+)-mass shear model")),
    ("report.floor_name", re.compile(r"storey (?P<storey>\d+)")),
    ("motion.roof", re.compile(r"roof")),
    ("report.ground_name", re.compile(r"ground")),
    ("report.standard_input", re.compile(r"standard input")),
)
"""Names that stayput gives, with what varies in them, and the sentence of each."""

_ON_A_FLOOR = re.compile(r"(?P<motion>.+), (?P<place>[^,]+) of (?P<building>.+)")
"""How the motion of a building's floor is called after that of the ground."""


def named(name: str, language: str) -> str:
    """Return a preset's name in a language; a name of the user's own stays as it is, as all do in English."""
    return name if language == "en" or name not in _NAMES else say(_NAMES[name], language)


def piece_name(name: str) -> Phrase:
    """Return what a piece of a run is called, translated where that is a preset's name or a default one."""
    return called(name, PIECES_OF_RUNS)


def piece_at_first(name: str) -> Phrase:
    """Return what a sentence begins with that is about a piece: "The bookcase", "Bookcase 2", "“My own”"."""
    english, japanese = name_within(name, PIECES_OF_RUNS)
    return english[:1].upper() + english[1:], japanese


def names_of(run: Run, language: str) -> tuple[str, ...]:
    """Return what the pieces of a run are called in a language."""
    return tuple(say(piece_name(name), language) for name in run.names)


def place_named(place: str, language: str) -> str:
    """Return the place of a device in a language: "front left", or "前面側・左"."""
    return place if language == "en" else "・".join(named(part, language) for part in place.split())


def given_name(name: str, language: str) -> str:
    """Return a name that stayput gives, to a motion, a suite, a target, a building or a floor, in a language.

    A name of the user's own stays as it is, as do all in English.

    Examples
    --------
    >>> given_name("10-storey RC building", "ja"), given_name("Kobe, JMA", "ja")
    ('10階建て（鉄筋コンクリート造）', 'Kobe, JMA')
    """
    if language == "en":
        return name
    for key, pattern in _MADE:
        if made := pattern.fullmatch(name):
            parts = {part: named(text, language) for part, text in made.groupdict().items()}
            return say(key, language, **parts)
    if floor := _ON_A_FLOOR.fullmatch(name):
        parts = {part: given_name(text, language) for part, text in floor.groupdict().items()}
        if parts["place"] != floor["place"]:
            return say("report.motion_on_floor", language, **parts)
    return named(name, language)


def acceleration_label(motion: Motion, language: str) -> str:
    """Return the label of the axis of what a piece stands on; of an upper floor's motion, which floor."""
    key = "plots.acceleration_of" if motion.floor else "plots.floor_acceleration"
    return say(key, language, floor=floor_phrase(motion.floor))


def motion_place(motion: Motion, language: str = "en") -> str:
    """Return a motion's label, with where it was recorded unless on the ground or its name says the floor."""
    label = motion_label(motion, language)
    if not motion.floor or motion.floor in motion.name.lower():
        return label
    return say("runs.recorded_on", language, name=label, floor=floor_phrase(motion.floor))


def motion_label(motion: Motion, language: str = "en") -> str:
    """Return a motion's label in pictures; a computed one is always labelled synthetic."""
    if not motion.name:
        return say("runs.unnamed", language)
    name = given_name(motion.name, language)
    plain = motion.synthetic and "synthetic" not in motion.name.lower()
    return say("runs.synthetic", language, name=name) if plain else name
