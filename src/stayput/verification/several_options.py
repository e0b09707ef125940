"""The options that a verification of several pieces compares: nothing, their joints, measures on them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.errors import InputError
from stayput.measures import MEASURES
from stayput.scenario.pieces import NOTHING, AssemblyOption
from stayput.simulation.placing import placed

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.scenario import AssemblyScenario

ON_TOP = ("l_bracket", "belt", "tension_pole")
"""Measures that are compared on the uppermost pieces of furniture, where a file names no options."""

BELOW = ("gel_mats",)
"""Measures that are compared under the pieces of furniture on the floor."""

ALONE = ("l_bracket",)
"""Those of them that are compared without the joints too."""


@dataclass(frozen=True, slots=True)
class RejectedOption:
    """An option that cannot be put in place: it has no numbers.

    Parameters
    ----------
    option : AssemblyOption
        The option.
    error : InputError
        Why not.
    """

    option: AssemblyOption
    error: InputError

    def why(self, language: str) -> str:
        """Return why not, in "en" or "ja"."""
        return self.error.told("ja" if language == "ja" else "en")


def label(option: AssemblyOption, scenario: AssemblyScenario) -> Phrase:
    """Return what an option consists of: "Joints + Screwed L-brackets on upper part"."""
    english, japanese = (_label(option, scenario.names, language) for language in ("en", "ja"))
    return english, japanese


def brief_label(option: AssemblyOption) -> Phrase:
    """Return the same without the names of the pieces."""
    english, japanese = (_label(option, (), language) for language in ("en", "ja"))
    return english, japanese


def _label(option: AssemblyOption, names: tuple[str, ...], language: str) -> str:
    if not option.count:
        return say("several.nothing", language)
    on: dict[Phrase, list[str]] = {}
    for number, measures in enumerate(option.measures):
        for measure in measures:
            on.setdefault(measure.label, []).extend(names[number : number + 1])
    parts = [say("several.joined", language)] if option.joined else []
    for what, held in on.items():
        pieces = (" and " if language == "en" else "と").join(held)
        on_pieces = phrase("several.on", measure=what, pieces=pieces)
        parts.append(say(on_pieces if held else what, language))
    return (" + " if language == "en" else "＋").join(parts)


def options_of_several(
    scenario: AssemblyScenario,
) -> tuple[tuple[AssemblyOption, ...], tuple[RejectedOption, ...]]:
    """Return the options that a verification compares, that without anything first, and the impossible ones.

    Raises
    ------
    InputError
        Options of which none can be put in place.
    """
    nothing = AssemblyOption(NOTHING, False, ((),) * len(scenario.names))
    named = scenario.options
    wanted = named or _usual(scenario)
    possible: list[AssemblyOption] = []
    rejected: list[RejectedOption] = []
    for option in wanted:
        try:
            _put_in_place(scenario, option)
        except InputError as error:  # no wall behind, no ceiling known, mats under a piece on another
            rejected.append(RejectedOption(option, scenario.by_names(error)))
        else:
            possible.append(option)
    if named and not possible:
        with scenario.naming_file():
            raise rejected[0].error
    return (nothing, *possible), tuple(rejected)


def _put_in_place(scenario: AssemblyScenario, option: AssemblyOption) -> None:
    """Raise `InputError` where an option cannot be put in place."""
    members, room = scenario.assembly(option).members, scenario.surroundings()
    placed(members, room)


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
