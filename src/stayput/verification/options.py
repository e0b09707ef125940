"""The options that a verification compares: nothing, measures, and joints of several pieces."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Generic, TypeVar

from stayput.catalogue import Phrase, phrase, say
from stayput.errors import InputError
from stayput.measures import MEASURES, BadlyInstalled, Measure, hold
from stayput.model.state import refuse_bad_start
from stayput.scenario.pieces import NOTHING, AssemblyOption
from stayput.simulation.placing import placed
from stayput.wording import joined

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from stayput.model.room import Room
    from stayput.scenario import AssemblyScenario, Scenario

OptionT = TypeVar("OptionT")

USUAL = (
    "anti_slip_sheet",
    "felt_glides",
    "gel_mats",
    "wedge_stopper",
    "l_bracket",
    "belt",
    "tension_pole",
)
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

    @property
    def reason(self) -> str:
        """Why not, in English."""
        return str(self.error)

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
        A piece that stands in a wall or in the ceiling, measures of which none can be applied there, or two
        of one name.
    """
    named = tuple(Option(measure_set.name, measure_set.measures) for measure_set in scenario.measures)
    names = ["none", *(option.name for option in named)]
    for name in names:
        if names.count(name) > 1:
            raise InputError("verification.two_of_one_name", "measures", name=repr(name))
    body, room = scenario.furniture.body(), scenario.room.room()
    refuse_bad_start(body, room, scenario.initial.state())
    compared = named if named or scenario.without_measures else usual()
    possible, impossible = _possible(compared, lambda option: hold(body, room, option.measures))
    if named and not possible:
        raise impossible[0].error
    return (Option("none"), *possible), impossible


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
    scenario: AssemblyScenario,
) -> tuple[tuple[AssemblyOption, ...], tuple[Impossible[AssemblyOption], ...]]:
    """Return the options that a verification compares, that without anything first, and the impossible ones.

    Raises
    ------
    InputError
        Options of which none can be put in place.
    """
    nothing = AssemblyOption(NOTHING, False, ((),) * len(scenario.names))
    named = scenario.options
    room = scenario.surroundings()

    def put_in_place(option: AssemblyOption) -> None:
        try:
            placed(scenario.assembly(option).members, room)
        except InputError as error:  # such as mats under a piece on another
            raise scenario.by_names(error) from None

    possible, rejected = _possible(named or _usual(scenario), put_in_place)
    if named and not possible:
        with scenario.naming_file():
            raise rejected[0].error
    return (nothing, *possible), rejected


def _usual(scenario: AssemblyScenario) -> tuple[AssemblyOption, ...]:
    """Return the options where a file names none: its joints and measures, or the usual ones."""
    stated, joints = scenario.stated, bool(scenario.joints)
    found = [AssemblyOption("joined", True, ((),) * len(scenario.names))] if joints else []
    if any(stated.measures):
        return (*found, stated)
    carried = {piece.on for piece in scenario.furniture if piece.is_furniture}
    for kinds, chosen in (
        (ON_TOP, [piece.is_furniture and piece.name not in carried for piece in scenario.furniture]),
        (BELOW, [piece.is_furniture and piece.on is None for piece in scenario.furniture]),
    ):
        if not any(chosen):
            continue
        for kind in kinds:
            measures = tuple((MEASURES[kind](),) if on else () for on in chosen)
            if not joints or kind in ALONE:
                found.append(AssemblyOption(kind, False, measures))
            if joints:
                found.append(AssemblyOption(f"joined + {kind}", True, measures))
    return tuple(found)
