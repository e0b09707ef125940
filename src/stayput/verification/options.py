"""The options that a verification compares: no measure, and each measure or set of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.measures import MEASURES, hold

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.body import Body
    from stayput.measures import Measure
    from stayput.room import Room
    from stayput.scenario import Scenario

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

NOTHING = ("No measure", "対策なし")
"""What the option without a measure is called, in English and Japanese."""


@dataclass(frozen=True, slots=True)
class Option:
    """One of the things that may be done.

    Parameters
    ----------
    name : str
        What the user calls it; unique.
    measures : tuple of Measure
        What is done; nothing for the option without a measure.
    """

    name: str
    measures: tuple[Measure, ...] = ()

    def label(self, language: str) -> str:
        """Return what it is called in "en" or "ja"."""
        which = 0 if language == "en" else 1
        if not self.measures:
            return NOTHING[which]
        joint = " + " if language == "en" else "+"
        return joint.join(measure.label[which] for measure in self.measures)


def usual_options(body: Body, room: Room) -> tuple[Option, ...]:
    """Return the usual measures, each alone, and the usual pair: those that can be applied here."""
    sets = [(name,) for name in USUAL] + [COMBINED]
    found: list[Option] = []
    for names in sets:
        measures = tuple(MEASURES[name]() for name in names)
        try:
            hold(body, room, measures)
        except InputError:  # no wall behind, no ceiling known
            continue
        found.append(Option(" + ".join(names), measures))
    return tuple(found)


def options_of(scenario: Scenario) -> tuple[Option, ...]:
    """Return the options of a scenario, that without a measure first.

    Raises
    ------
    InputError
        A measure that cannot be applied there, or two of one name.
    """
    body, room = scenario.furniture.body(), scenario.room.room()
    named = tuple(Option(one.name, one.measures) for one in scenario.measures)
    for option in named:
        hold(body, room, option.measures)
    options = (Option("none"), *(named or usual_options(body, room)))
    _refuse_twice(options)
    return options


def _refuse_twice(options: Sequence[Option]) -> None:
    names = [option.name for option in options]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"Two measures are named {name!r}; each must have a name of its own.")
