"""The options that a verification compares: nothing, measures, joints; and how well founded their inputs are.

What each grade means stands in `stayput.measures.measure`, and with the parameters whether they decide.
The earthquakes are what is asked, so they have no grade.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError
from stayput.measures import MEASURES, Measure, hold, sets_of
from stayput.measures.floor import OtherFriction
from stayput.measures.measure import GRADE_OF, Grade
from stayput.model.body import FURNITURE
from stayput.model.parameters import GIVEN, parameters
from stayput.model.room import SURFACES, Floor
from stayput.model.state import refuse_bad_start
from stayput.scenario.measures import NOTHING, Option
from stayput.simulation.placing import placed
from stayput.uncertainty import Confidence
from stayput.wording import inside, joined

if TYPE_CHECKING:
    from stayput.scenario import Scenario
    from stayput.scenario.pieces import PieceTable
    from stayput.scenario.tables import BuildingTable


def _effort(kinds: tuple[str, ...]) -> tuple[int, int, bool]:
    """Return the sort key of sets of measures: few, cheap, and what ties a piece before what is under it."""
    measures = [MEASURES[kind] for kind in kinds]
    return len(kinds), sum(each.cost_class for each in measures), measures[0].acts_on == "the base"


TRIED = tuple(sorted(sets_of(lambda measure: measure.tried_in_rooms), key=_effort))
"""Sets of measures that are tried on the pieces of a room: one measure, or two together."""

TRIED_ALONE = tuple(kinds[0] for kinds in TRIED if len(kinds) == 1)
"""Those of one measure."""


@dataclass(frozen=True, slots=True)
class Impossible:
    """An option that cannot be put in place: it has no numbers, not even 0.

    Parameters
    ----------
    option : Option
        What would hold the pieces.
    error : InputError
        Why not.
    """

    option: Option
    error: InputError

    def why(self, language: str) -> str:
        """Return why not, in "en" or "ja"."""
        return self.error.told("ja" if language == "ja" else "en")


def usual() -> tuple[Option, ...]:
    """Return the usual measures on a piece, each alone and pairs, whether they can be applied or not."""
    sets = sets_of(lambda measure: measure.compared_by_default)
    return tuple(Option(" + ".join(kinds), (tuple(MEASURES[kind]() for kind in kinds),)) for kinds in sets)


def compared_options(scenario: Scenario) -> tuple[tuple[Option, ...], tuple[Impossible, ...]]:
    """Return the options that a verification compares, the baseline first, and the impossible ones.

    Raises
    ------
    InputError
        Pieces that stand in a wall or in the ceiling, what the file states, or options of which none can be
        put in place.
    """
    named, stated, room = scenario.options, scenario.stated, scenario.room.room()

    def put_in_place(option: Option) -> object:
        if scenario.alone:
            return hold(scenario.piece.body(), room, option.measures, dimensions=scenario.dimensions)
        return placed(scenario.scene(option))

    if scenario.alone:
        refuse_bad_start(scenario.piece.body(), room, scenario.initial.state())
        compared = named or (() if scenario.in_python["measures"] == () else usual())
        if not named and any(stated.on):
            compared = (replace(stated, name=stated.generated_name),)
    else:
        with scenario.naming_keys():
            scene = scenario.scene()
            scene.refuse_wrong_places()
            placed(scene)
        compared = named or (() if scenario.plan is not None else _usual_of_several(scenario))
    possible, impossible = list[Option](), list[Impossible]()
    for option in compared:
        try:
            put_in_place(option)
        except InputError as error:  # no wall behind, no ceiling known, mats under a piece on another
            impossible.append(Impossible(option, error.with_traceback(None)))
        else:
            possible.append(option)
    if named and not possible:
        with scenario.naming_file():
            raise impossible[0].error
    # what is named, or tried in a room, changes the pieces as stated; else their own measures are compared
    as_stated = any(stated.on) if named else scenario.plan is not None
    baseline = stated if as_stated else Option(NOTHING, ((),) * len(scenario.names))
    return (baseline, *possible), tuple(impossible)


def _usual_of_several(scenario: Scenario) -> tuple[Option, ...]:
    """Return the options where a file names none: its joints and measures, or the usual ones.

    What is under the base goes under the pieces on the floor, all else on the uppermost ones. The first
    measure alone is compared without the joints too.
    """
    stated, joints = scenario.stated, bool(scenario.joints)
    options = [Option("joined", ((),) * len(scenario.names), joined=True)] if joints else []
    if any(stated.on):
        return (*options, stated)
    carried = {piece.on for piece in scenario.pieces if piece.is_furniture}
    for kind in TRIED_ALONE:
        below = MEASURES[kind].acts_on == "the base"
        chosen = [
            piece.is_furniture and (piece.on is None if below else piece.title not in carried)
            for piece in scenario.pieces
        ]
        if any(chosen):
            on = tuple((MEASURES[kind](),) if held else () for held in chosen)
            if not joints or kind == TRIED_ALONE[0]:
                options.append(Option(kind, on))
            if joints:
                options.append(Option(f"joined + {kind}", on, joined=True))
    return tuple(options)


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
    """Return the inputs that decide the outcome of an option, each once.

    Parameters
    ----------
    option : Option
        What is in place, which is possible.
    scenario : Scenario
        The pieces and where they stand.
    """
    each = (inputs_of_piece(option.on[number], scenario, number) for number in scenario.counted)
    return tuple(dict.fromkeys(item for of_piece in each for item in of_piece))


def weakest(option: Option, scenario: Scenario) -> tuple[Input, ...]:
    """Return the inputs of the worst grade among those of an option; see `inputs`."""
    deciding = inputs(option, scenario)
    worst = max(item.grade for item in deciding)
    return tuple(item for item in deciding if item.grade == worst)


def grade(option: Option, scenario: Scenario) -> Grade:
    """Return the grade of an option: that of its weakest input."""
    return weakest(option, scenario)[0].grade


def inputs_of_piece(measures: tuple[Measure, ...], scenario: Scenario, number: int) -> tuple[Input, ...]:
    """Return the inputs that decide what becomes of a piece with measures on it.

    Parameters
    ----------
    measures : tuple of Measure
        The measures, which can be put in place.
    scenario : Scenario
        The pieces and where they stand.
    number : int
        The piece.
    """
    room = scenario.room
    basis = [Input(phrase("verification.size_and_mass"), furniture_tag(scenario.pieces[number]))]
    replaced = any(isinstance(measure, OtherFriction) for measure in measures)
    basis += _around(scenario, room.room().floor, replaced)
    for measure in measures:
        basis += _of_measure(measure)
        wall, ceiling = room.left_wall, room.ceiling
        known = "walls" in room.model_fields_set or (wall and "construction" in wall.model_fields_set)
        if measure.drilled and not known:
            basis.append(Input(phrase("verification.the_wall"), Confidence.LOW.value))
        if measure.needs == "ceiling" and ceiling and "construction" not in ceiling.model_fields_set:
            basis.append(Input(phrase("verification.the_ceiling"), Confidence.LOW.value))
    return tuple(dict.fromkeys(basis))


def _around(scenario: Scenario, floor: Floor, replaced: bool) -> Iterator[Input]:
    """Yield what decides of the floor, whose friction a measure may have replaced, and of the building."""
    if not replaced:
        yield Input(phrase("verification.floor_friction"), floor_tag(scenario))
    if floor.settlement >= SOFT:
        table = scenario.room.floor
        usual = isinstance(table, str) or table.settlement is None
        tag = Confidence.LOW.value if usual else GIVEN
        yield Input(phrase("verification.floor_settlement"), tag)
    building = scenario.shaking.building
    if building is not None:
        yield Input(phrase("verification.the_building"), building_tag(building))


def _of_measure(measure: Measure) -> Iterator[Input]:
    called = inside(measure.label[0]), measure.label[1]
    for parameter in parameters(measure):
        if parameter.decides:
            label = joined((called, parameter.label), "common.colon")
            yield Input(label, parameter.tag(getattr(measure, parameter.name)))


def furniture_tag(table: PieceTable) -> str:
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


def floor_tag(scenario: Scenario) -> str:
    """Return the tag of the floor's friction."""
    table = scenario.room.floor
    surface = table if isinstance(table, str) else table.surface
    return GIVEN if surface is None else SURFACES[surface].confidence.value


def building_tag(table: BuildingTable) -> str:
    """Return the tag of a building: its masses are the user's, or follow from the structure."""
    return GIVEN if table.masses is not None else Confidence.LOW.value
