"""Grades of options: how well founded are the inputs that decide the outcome, and which is the weakest.

What each grade means stands in `stayput.measures.measure`, and with the parameters whether they decide.
The earthquakes are what is asked, so they have no grade.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase
from stayput.measures import Measure, TensionPole, hold
from stayput.measures.floor import OtherFriction
from stayput.measures.measure import GRADE_OF, Grade
from stayput.measures.wall import WallDevice
from stayput.model.body import FURNITURE
from stayput.model.parameters import GIVEN, parameters
from stayput.model.room import SURFACES, Floor
from stayput.uncertainty import Confidence
from stayput.wording import inside

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.scenario import AssemblyScenario, RoomScenario, Scenario
    from stayput.scenario.tables import BuildingTable, FurnitureTable
    from stayput.verification.options import Option


SOFT = 0.2e-3
"""From so far on that the floor gives, it decides whether a flat base overturns [m]: tatami and carpet."""


@dataclass(frozen=True, slots=True)
class Input:
    """An input that decides the outcome, and how well founded its value is.

    Parameters
    ----------
    label : Phrase
        What it is, in English and Japanese.
    tag : str
        A `stayput.uncertainty.Confidence`, or `stayput.model.parameters.GIVEN`.
    """

    label: Phrase
    tag: str

    @property
    def grade(self) -> Grade:
        """Its grade."""
        return GRADE_OF[self.tag]


def inputs(option: Option, scenario: Scenario) -> tuple[Input, ...]:
    """Return the inputs that decide the outcome of an option, the piece first.

    Parameters
    ----------
    option : Option
        The measures, which can be put in place.
    scenario : Scenario
        The furniture and where it stands.
    """
    before = scenario.room.room()
    after = hold(scenario.furniture.body(), before, option.measures).room.floor
    replaced = (after.static_friction, after.kinetic_friction) != (
        before.floor.static_friction,
        before.floor.kinetic_friction,
    )
    return (
        Input(phrase("verification.size_and_mass"), furniture_tag(scenario.furniture)),
        *_around(scenario, after, replaced),
        *(one for measure in option.measures for one in _of_measure(measure)),
    )


def weakest(option: Option, scenario: Scenario) -> tuple[Input, ...]:
    """Return the inputs of the worst grade among those of an option; see `inputs`."""
    deciding = inputs(option, scenario)
    worst = max(item.grade for item in deciding)
    return tuple(item for item in deciding if item.grade == worst)


def grade(option: Option, scenario: Scenario) -> Grade:
    """Return the grade of an option: that of its weakest input."""
    return weakest(option, scenario)[0].grade


def inputs_in_room(measures: tuple[Measure, ...], scenario: RoomScenario, number: int) -> tuple[Input, ...]:
    """Return the inputs that decide what becomes of a piece of a room with measures on it.

    Parameters
    ----------
    measures : tuple of Measure
        The measures, which can be put in place.
    scenario : RoomScenario
        The room.
    number : int
        The piece.
    """
    table, room = scenario.furniture[number], scenario.surroundings()
    known = table.preset is None or table.mass not in (None, FURNITURE[table.preset].mass)
    found = [Input(phrase("verification.size_and_mass"), GIVEN if known else Confidence.LOW.value)]
    found += _around(scenario, room.floor, any(isinstance(one, OtherFriction) for one in measures))
    stated = scenario.room.model_fields_set
    for measure in measures:
        found += _of_measure(measure)
        if isinstance(measure, WallDevice) and "walls" not in stated:
            found.append(Input(phrase("verification.the_wall"), Confidence.LOW.value))
    ceiling = scenario.room.ceiling
    on_ceiling = any(isinstance(measure, TensionPole) for measure in measures)
    if on_ceiling and ceiling is not None and "construction" not in ceiling.model_fields_set:
        found.append(Input(phrase("verification.the_ceiling"), Confidence.LOW.value))
    return tuple(found)


def _around(scenario: Scenario | RoomScenario, floor: Floor, replaced: bool) -> Iterator[Input]:
    """Yield what decides of the floor, whose friction a measure may have replaced, and of the building."""
    if not replaced:
        yield Input(phrase("verification.floor_friction"), floor_tag(scenario))
    if floor.settlement >= SOFT:
        yield Input(phrase("verification.floor_settlement"), settlement_tag(scenario))
    building = scenario.shaking.building
    if building is not None:
        yield Input(phrase("verification.the_building"), building_tag(building))


def _of_measure(measure: Measure) -> Iterator[Input]:
    for parameter in parameters(measure):
        if parameter.decides:
            label = phrase(
                "verification.of_a_measure",
                measure=(inside(measure.label[0]), measure.label[1]),
                parameter=parameter.label,
            )
            yield Input(label, parameter.tag(getattr(measure, parameter.name)))


def furniture_tag(table: FurnitureTable) -> str:
    """Return the tag of a piece's size and mass; a preset's own value is a default."""
    preset = FURNITURE.get(table.preset or "")
    if preset is None:
        return GIVEN
    known = (
        table.width not in (None, preset.width),
        table.height not in (None, preset.height),
        table.shelves is not None or table.mass not in (None, preset.mass),
    )
    return GIVEN if all(known) else Confidence.LOW.value


def floor_tag(scenario: Scenario | AssemblyScenario) -> str:
    """Return the tag of the floor's friction."""
    table = scenario.room.floor
    surface = table if isinstance(table, str) else table.surface
    return GIVEN if surface is None else SURFACES[surface].confidence.value


def settlement_tag(scenario: Scenario | AssemblyScenario) -> str:
    """Return the tag of how far the floor gives."""
    table = scenario.room.floor
    return Confidence.LOW.value if isinstance(table, str) or table.settlement is None else GIVEN


def building_tag(table: BuildingTable) -> str:
    """Return the tag of a building: its masses are the user's, or follow from the structure."""
    return GIVEN if table.masses is not None else Confidence.LOW.value
