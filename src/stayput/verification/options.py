"""The options that a verification compares: nothing, measures, joints; and how well founded their inputs are.

What each grade means stands in `stayput.measures.measure`, and with the parameters whether they decide.
The earthquakes are what is asked, so they have no grade.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Generic, TypeVar

from stayput.catalogue import Phrase, phrase, say
from stayput.errors import InputError
from stayput.measures import MEASURES, BadlyInstalled, Measure, TensionPole, hold
from stayput.measures.floor import OtherFriction
from stayput.measures.measure import GRADE_OF, Grade
from stayput.measures.wall import WallDevice
from stayput.model.body import FURNITURE
from stayput.model.parameters import GIVEN, parameters
from stayput.model.room import SURFACES, Floor
from stayput.model.state import refuse_bad_start
from stayput.scenario.pieces import NOTHING, AssemblyOption
from stayput.simulation.placing import placed
from stayput.uncertainty import Confidence
from stayput.wording import inside, joined

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from stayput.model.room import Room
    from stayput.scenario import Scenario
    from stayput.scenario.pieces import PieceTable
    from stayput.scenario.tables import BuildingTable

OptionT = TypeVar("OptionT")

USUAL = ("anti_slip_sheet", "felt_glides", "gel_mats", "wedge_stopper", "l_bracket", "belt", "tension_pole")
"""Measures that are compared where a scenario names none; each that can be applied."""

COMBINED = ("wedge_stopper", "tension_pole")
"""The usual pair: each makes up for what the other lacks."""

YOURS = "yours"
"""Name of the set that is put together on the app's page; the user has not chosen it."""


@dataclass(frozen=True, slots=True)
class Option:
    """A set of measures that is compared with others.

    Parameters
    ----------
    name : str
        What the user calls it; unique.
    measures : tuple of Measure
        The measures; none for the option without a measure.
    """

    name: str
    measures: tuple[Measure, ...] = ()

    @property
    def own_name(self) -> bool:
        """Whether the name is the user's own, and not made of its measures' types."""
        kinds = [measure.kind for measure in self.measures]
        return bool(kinds) and self.name not in (" + ".join(kinds), "+".join(kinds), YOURS)

    def badly_installed(self, room: Room) -> tuple[Option, tuple[BadlyInstalled, ...]] | None:
        """Return the measures as one installs them who does it badly, and what is wrong; None if nothing is.

        All that can be badly installed is, since the same person does it.
        """
        each = [measure.badly_installed(room) for measure in self.measures]
        wrong = tuple(bad for bad in each if bad is not None)
        if not wrong:
            return None
        pairs = zip(self.measures, each, strict=True)
        measures = tuple(measure if bad is None else bad.measure for measure, bad in pairs)
        return replace(self, measures=measures), wrong

    def label(self, language: str) -> str:
        """Return its label in "en" or "ja"."""
        if not self.measures:
            return say("common.without", language)
        joint = " + " if language == "en" else "+"
        return joint.join(say(measure.label, language) for measure in self.measures)


@dataclass(frozen=True, slots=True)
class Impossible(Generic[OptionT]):
    """An option that cannot be put in place: it has no numbers, not even 0.

    Parameters
    ----------
    option : Option or AssemblyOption
        The measures.
    error : InputError
        Why not.
    """

    option: OptionT
    error: InputError

    def why(self, language: str) -> str:
        """Return why not, in "en" or "ja"."""
        return self.error.told("ja" if language == "ja" else "en")


def _possible(
    options: Iterable[OptionT], put_in_place: Callable[[OptionT], object]
) -> tuple[tuple[OptionT, ...], tuple[Impossible[OptionT], ...]]:
    """Return those options that can be put in place, and those that cannot with the reason."""
    possible: list[OptionT] = []
    impossible: list[Impossible[OptionT]] = []
    for option in options:
        try:
            put_in_place(option)
        except InputError as error:  # no wall behind, no ceiling known, an anchor above the ceiling
            impossible.append(Impossible(option, error.with_traceback(None)))
        else:
            possible.append(option)
    return tuple(possible), tuple(impossible)


def usual() -> tuple[Option, ...]:
    """Return the usual measures, each alone, and the usual pair, whether they can be applied or not."""
    sets = [(name,) for name in USUAL] + [COMBINED]
    return tuple(Option(" + ".join(names), tuple(MEASURES[name]() for name in names)) for names in sets)


def compared_options(scenario: Scenario) -> tuple[tuple[Option, ...], tuple[Impossible[Option], ...]]:
    """Return the options that a verification compares, that without a measure first, and the impossible ones.

    Raises
    ------
    InputError
        A piece that stands in a wall or in the ceiling, or measures of which none can be applied there.
    """
    named = tuple(Option(measure_set.name, measure_set.measures) for measure_set in scenario.measures)
    body, room = scenario.piece.body(), scenario.room.room()
    refuse_bad_start(body, room, scenario.initial.state())
    compared = named if named or scenario.without_measures else usual()
    possible, impossible = _possible(compared, lambda option: hold(body, room, option.measures))
    if named and not possible:
        raise impossible[0].error
    return (Option(NOTHING), *possible), impossible


ON_TOP = ("l_bracket", "belt", "tension_pole")
"""Measures that are compared on the uppermost pieces of furniture, where a file names no options."""

BELOW = ("gel_mats",)
"""Measures that are compared under the pieces of furniture on the floor."""

ALONE = ("l_bracket",)
"""Those of them that are compared without the joints too."""


def label(option: AssemblyOption, names: Sequence[str] = ()) -> Phrase:
    """Return what an option consists of: "Joints + Belts on upper part"; no "on" without names."""
    if not option.count:
        return phrase("several.nothing")
    on: dict[Phrase, list[str]] = {}
    for number, measures in enumerate(option.measures):
        for measure in measures:
            on.setdefault(measure.label, []).extend(names[number : number + 1])
    parts = [phrase("several.joined")] if option.joined else []
    for what, held in on.items():
        pieces = " and ".join(held), "と".join(held)
        parts.append(phrase("several.on", measure=what, pieces=pieces) if held else what)
    return joined(parts, "action_plan.plus")


def options_of_several(
    scenario: Scenario,
) -> tuple[tuple[AssemblyOption, ...], tuple[Impossible[AssemblyOption], ...]]:
    """Return the options that a verification compares, that without anything first, and the impossible ones.

    Raises
    ------
    InputError
        What the file states, or options of which none can be put in place.
    """
    nothing = AssemblyOption(NOTHING, False, ((),) * len(scenario.names))
    named = scenario.options

    def put_in_place(option: AssemblyOption) -> None:
        placed(scenario.scene(option))  # refuses mats under a piece on another, say

    with scenario.naming_file():
        put_in_place(scenario.stated)
    possible, rejected = _possible(named or _usual(scenario), put_in_place)
    if named and not possible:
        with scenario.naming_file():
            raise rejected[0].error
    return (nothing, *possible), rejected


def _usual(scenario: Scenario) -> tuple[AssemblyOption, ...]:
    """Return the options where a file names none: its joints and measures, or the usual ones."""
    stated, joints = scenario.stated, bool(scenario.joints)
    options = [AssemblyOption("joined", True, ((),) * len(scenario.names))] if joints else []
    if any(stated.measures):
        return (*options, stated)
    carried = {piece.on for piece in scenario.pieces if piece.is_furniture}
    for kinds, chosen in (
        (ON_TOP, [piece.is_furniture and piece.title not in carried for piece in scenario.pieces]),
        (BELOW, [piece.is_furniture and piece.on is None for piece in scenario.pieces]),
    ):
        if not any(chosen):
            continue
        for kind in kinds:
            measures = tuple((MEASURES[kind](),) if on else () for on in chosen)
            if not joints or kind in ALONE:
                options.append(AssemblyOption(kind, False, measures))
            if joints:
                options.append(AssemblyOption(f"joined + {kind}", True, measures))
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
    """Return the inputs that decide the outcome of an option, the piece first.

    Parameters
    ----------
    option : Option
        The measures, which can be put in place.
    scenario : Scenario
        The furniture and where it stands.
    """
    before = scenario.room.room()
    after = hold(scenario.piece.body(), before, option.measures).room.floor
    replaced = (after.static_friction, after.kinetic_friction) != (
        before.floor.static_friction,
        before.floor.kinetic_friction,
    )
    return (
        Input(phrase("verification.size_and_mass"), furniture_tag(scenario.piece)),
        *_around(scenario, after, replaced),
        *(quantity for measure in option.measures for quantity in _of_measure(measure)),
    )


def weakest(option: Option, scenario: Scenario) -> tuple[Input, ...]:
    """Return the inputs of the worst grade among those of an option; see `inputs`."""
    deciding = inputs(option, scenario)
    worst = max(item.grade for item in deciding)
    return tuple(item for item in deciding if item.grade == worst)


def grade(option: Option, scenario: Scenario) -> Grade:
    """Return the grade of an option: that of its weakest input."""
    return weakest(option, scenario)[0].grade


def inputs_in_room(measures: tuple[Measure, ...], scenario: Scenario, number: int) -> tuple[Input, ...]:
    """Return the inputs that decide what becomes of a piece of a room with measures on it.

    Parameters
    ----------
    measures : tuple of Measure
        The measures, which can be put in place.
    scenario : Scenario
        The room.
    number : int
        The piece.
    """
    table, room = scenario.pieces[number], scenario.room.room()
    known = table.preset is None or table.mass not in (None, FURNITURE[table.preset].mass)
    basis = [Input(phrase("verification.size_and_mass"), GIVEN if known else Confidence.LOW.value)]
    basis += _around(scenario, room.floor, any(isinstance(measure, OtherFriction) for measure in measures))
    stated = scenario.room.model_fields_set
    for measure in measures:
        basis += _of_measure(measure)
        if isinstance(measure, WallDevice) and "walls" not in stated:
            basis.append(Input(phrase("verification.the_wall"), Confidence.LOW.value))
    ceiling = scenario.room.ceiling
    on_ceiling = any(isinstance(measure, TensionPole) for measure in measures)
    if on_ceiling and ceiling is not None and "construction" not in ceiling.model_fields_set:
        basis.append(Input(phrase("verification.the_ceiling"), Confidence.LOW.value))
    return tuple(basis)


def _around(scenario: Scenario | Scenario, floor: Floor, replaced: bool) -> Iterator[Input]:
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
