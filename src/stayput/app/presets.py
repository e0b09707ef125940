"""The presets reply: everything that a user can choose, with labels and numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import MISSING
from typing import TYPE_CHECKING, Any, Literal

from pydantic import Field

import stayput
from stayput.app.downloads import film_kinds
from stayput.app.messages import Reply, Words
from stayput.catalogue import Phrase, names, phrase
from stayput.estimates import PRESET_DRAWERS, Everyday
from stayput.measures import MEASURES, Measure, Parameter, parameters
from stayput.model.body import FURNITURE, Body, Part, Preset
from stayput.model.floor_plan import PLACES, Door, FloorPlan, PersonPlace, Window
from stayput.model.parameters import parameter_of
from stayput.model.parameters import parameters as parameters_of
from stayput.model.room import SURFACES, Ceiling, Wall
from stayput.motion.ground_shaking import (
    EarthquakeSource,
    strength_of_mercalli,
    strength_of_pga,
    strength_of_pgv,
    strength_of_sa,
)
from stayput.motion.intensity import CLASSES, intensity_of_class
from stayput.motion.suites.synthesis import synthetic_suite

if TYPE_CHECKING:
    from stayput.app.limits import Limits

SHELVES = 5
"""Shelves that a bookcase is drawn with."""

SCENE: dict[str, Any] = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"intensity": "6-upper", "member": 3},
}
"""A scene to begin with: a bookcase that falls, in the shortest of the mixed suite's kinds of motion."""

ROOM_SCENE: dict[str, Any] = {
    "plan": {"width": 3.6, "length": 2.7},
    "furniture": [
        {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 1.9},
        {"name": "wardrobe", "preset": "wardrobe", "against": "far_side_wall", "along": 2.9},
        {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 1.6},
    ],
    "places": [{"kind": "bed", "at": [1.4, 1.9], "heading": math.pi / 2.0}],
    "doors": [{"wall": "right_wall", "start": 0.3, "width": 0.8}],
    "windows": [{"wall": "far_side_wall", "start": 0.5, "width": 1.6}],
    "room": {"floor": "wood flooring", "ceiling": {"height": 2.4}},
    "shaking": {"intensity": "6-upper", "suite": {"family": "mixed", "count": 20}, "member": 3},
}
"""A room to begin with: a bedroom with a bookcase that falls on the bed."""

SCENE_MEASURES: list[dict[str, Any]] = [{"type": "l_bracket"}]
"""Measures to begin with."""

NUMBERS = {
    f"{table}.{name}": parameter_of(kind, name)
    for table, kind, *names_there in (
        ("furniture", Body, "width", "height", "length", "mass", "base"),
        ("room.left_wall", Wall, "gap", "construction"),
        ("room.ceiling", Ceiling, "height", "construction"),
        ("everyday", Everyday, "drawers", "load", "pull"),
        ("shaking.suite", synthetic_suite, "count"),
        ("shaking", strength_of_pga, "pga"),
        ("shaking", strength_of_pgv, "pgv"),
        ("shaking.sa", strength_of_sa, "period", "value"),
        ("shaking", strength_of_mercalli, "mmi"),
        ("shaking.earthquake", EarthquakeSource, *(about.name for about in parameters_of(EarthquakeSource))),
        ("plan", FloorPlan, "width", "length"),
        ("doors", Door, "start", "width"),
        ("windows", Window, "start", "width", "sill"),
        ("places", PersonPlace, "width", "length", "low", "high", "day", "night"),
    )
    for name in names_there
} | {"furniture.shelves": parameter_of(Part, "mass")}
"""Numbers and words of a scene, and of a room with a plan, that the pages ask for."""


class NamedReply(Reply):
    """A name that is shown."""

    id: str
    label: Words


class FurnitureReply(NamedReply):
    """A preset of furniture."""

    width_m: float
    height_m: float
    length_m: float = Field(description="Across its depth.")
    mass_kg: float
    carcass_mass_kg: float | None
    shelves: int | None
    drawers: int = Field(description="Drawers that can be open at once.")
    base: str = Field(description="What bears on the floor; see `furniture.base` of the numbers.")


class SurfaceReply(NamedReply):
    """A preset of a surface."""

    static_friction: float
    kinetic_friction: float


class FamilyReply(NamedReply):
    """A family of earthquakes."""

    about: Words


class IntensityReply(NamedReply):
    """A class of JMA's intensity."""

    from_: float | None = Field(serialization_alias="from", description="Where it begins.")
    middle: float
    about: Words = Field(description="What people meet.")
    furniture: Words = Field(description="What it does to furniture.")


class ParameterReply(Reply):
    """What is known of a field: a measure's parameter, or a number of a scene."""

    name: str
    default: float | int | str | None
    usual: float | None = Field(description="What it comes to in a usual room, where it has no default.")
    unit: str
    low: float
    high: float
    confidence: str
    label: Words
    choices: list[str]
    words: list[str] = Field(description="Words that are accepted beside numbers.")
    whole: bool


class MeasureReply(Reply):
    """A kind of measure."""

    type: str
    label: Words
    about: Words
    place: str | None = Field(description="Two measures of one place exclude each other.")
    needs: list[Literal["wall", "ceiling"]]
    usual: bool
    parameters: list[ParameterReply]


class LimitsReply(Reply):
    """What the server accepts."""

    duration_s: float
    samples: int
    jobs_running: int
    jobs_waiting: int
    motions: int
    storeys: int


class PlaceReply(NamedReply):
    """A common place of a person in a room."""

    width_m: float
    length_m: float
    low_m: float = Field(description="Height above the floor from which the person is.")
    high_m: float
    day: float = Field(description="Share of the day in which somebody is there.")
    night: float
    blocks: bool = Field(description="Whether nobody walks there.")


class PresetsReply(Reply):
    """Everything that can be chosen."""

    version: str
    furniture: list[FurnitureReply]
    surfaces: list[SurfaceReply]
    contents: list[NamedReply]
    doors: list[NamedReply]
    structures: list[NamedReply]
    families: list[FamilyReply]
    intensities: list[IntensityReply]
    measures: list[MeasureReply]
    numbers: dict[str, ParameterReply] = Field(
        description="Numbers and words of a scene by their dotted names."
    )
    outcomes: list[NamedReply]
    events: list[NamedReply]
    scene: dict[str, Any] = Field(description="A scene to begin with.")
    measures_shown: list[dict[str, Any]]
    places: list[PlaceReply]
    room_scene: dict[str, Any] = Field(description="A room to begin with.")
    films: list[str] = Field(description="The kinds of films that this server can make.")
    limits: LimitsReply


def presets(limits: Limits) -> PresetsReply:
    """Return everything that can be chosen."""
    return PresetsReply(
        version=stayput.__version__,
        furniture=[_furniture(name, preset) for name, preset in FURNITURE.items()],
        surfaces=[
            SurfaceReply.from_attributes(surface, id=name, label=Words.of(names.SURFACES[name]))
            for name, surface in SURFACES.items()
        ],
        contents=_named(names.CONTENTS),
        doors=_named(names.DOORS),
        structures=_named(names.STRUCTURES),
        families=[
            FamilyReply(id=name, label=Words.of(label), about=Words.of(about))
            for name, (label, about) in names.FAMILIES.items()
        ],
        intensities=[_intensity(name, start) for name, start in CLASSES],
        measures=[_measure(name, kind) for name, kind in MEASURES.items()],
        numbers={name: _parameter(number) for name, number in NUMBERS.items()},
        outcomes=_named(names.OUTCOMES),
        events=_named(names.EVENTS),
        scene=SCENE,
        measures_shown=SCENE_MEASURES,
        places=[
            PlaceReply.from_attributes(place, id=name, label=Words.of(phrase(f"rooms.{name}")))
            for name, place in PLACES.items()
        ],
        room_scene=ROOM_SCENE,
        films=list(film_kinds()),
        limits=LimitsReply.from_attributes(limits),
    )


def _named(labels: Mapping[str, Phrase]) -> list[NamedReply]:
    return [NamedReply(id=name, label=Words.of(label)) for name, label in labels.items()]


def _furniture(name: str, preset: Preset) -> FurnitureReply:
    return FurnitureReply.from_attributes(
        preset,
        id=name,
        label=Words.of(names.FURNITURE[name]),
        shelves=None if preset.carcass_mass is None else SHELVES,
        drawers=PRESET_DRAWERS.get(name, 0),
    )


def _intensity(name: str, start: float) -> IntensityReply:
    return IntensityReply(
        id=name,
        label=Words.of(names.INTENSITIES[name]),
        from_=start if math.isfinite(start) else None,
        middle=intensity_of_class(name),
        about=Words.of(names.PEOPLE[name]),
        furniture=Words.of(names.ON_FURNITURE[name]),
    )


def _measure(name: str, kind: type[Measure]) -> MeasureReply:
    return MeasureReply(
        type=name,
        label=Words.of(kind.label),
        about=Words.of(kind.about),
        place=None if (place := kind().where()) is None else place[0],
        needs=[kind.needs] if kind.needs else [],
        usual=() in kind.compared_by_default,
        parameters=[
            _parameter(parameter, kind().in_a_usual_room().get(parameter.name))
            for parameter in parameters(kind)
        ],
    )


def _parameter(parameter: Parameter, usual: float | None = None) -> ParameterReply:
    return ParameterReply.from_attributes(
        parameter,
        default=None if parameter.default is MISSING else parameter.default,
        usual=usual,
        confidence=str(parameter.confidence),
        label=Words.of(parameter.label),
        choices=list(parameter.choices),
        words=list(parameter.words),
    )
