"""`Option`: what may hold the pieces of a scene, which a verification compares with other options."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple, Self

from stayput.catalogue import Phrase, phrase
from stayput.wording import joined

if TYPE_CHECKING:
    from stayput.measures import BadlyInstalled, Measure
    from stayput.model.room import Room

NOTHING, AS_STATED = "none", "as stated"
"""Names of the option with nothing in place, which every verification has, and of what a file states."""

YOURS = "yours"
"""Name of the set that is put together on the app's page; the user has not chosen it."""


class Moved(NamedTuple):
    """What stands elsewhere with an option.

    Parameters
    ----------
    what : str
        The piece, or the place of a person.
    at : tuple of float
        Its middle in plan [m].
    heading : float
        What it faces there [rad].
    """

    what: str
    at: tuple[float, float]
    heading: float


@dataclass(frozen=True, slots=True)
class Option:
    """What may hold the pieces of a scene: measures on each, and their joints; and what stands elsewhere.

    Parameters
    ----------
    name : str
        What it is called; unique.
    on : tuple of tuple of Measure
        The measures on each piece; none of the option with nothing in place.
    joined : bool
        Whether the joints are in place.
    moved : tuple of Moved
        What stands elsewhere than as the scenario states it.
    """

    name: str
    on: tuple[tuple[Measure, ...], ...] = ((),)
    joined: bool = False
    moved: tuple[Moved, ...] = ()

    @property
    def measures(self) -> tuple[Measure, ...]:
        """The measures on all pieces."""
        return tuple(measure for measures in self.on for measure in measures)

    @property
    def count(self) -> int:
        """How many things are put in place or moved: measures, the joints together, pieces and places."""
        return len(self.measures) + self.joined + len(self.moved)

    @property
    def generated_name(self) -> str:
        """Its name where the user gives none: what is in place, by the types of a scenario file."""
        kinds = dict.fromkeys(measure.kind for measure in self.measures)
        if len(self.on) == 1:
            kinds = [measure.kind for measure in self.measures]
        return " + ".join([*["joined"] * self.joined, *kinds]) or NOTHING

    @property
    def own_name(self) -> bool:
        """Whether the name is the user's own, and not made of what is in place."""
        usual = self.generated_name
        return self.name not in (usual, usual.replace(" + ", "+"), YOURS, AS_STATED)

    def badly_installed(self, room: Room) -> tuple[Self, tuple[BadlyInstalled, ...]] | None:
        """Return the measures as one installs them who does it badly, and what is wrong; None if nothing is.

        All that can be badly installed is, since the same person does it.
        """
        wrong: list[BadlyInstalled] = []

        def installed(measure: Measure) -> Measure:
            bad = measure.badly_installed(room)
            if bad is None:
                return measure
            wrong.append(bad)
            return bad.measure

        on = tuple(tuple(installed(measure) for measure in measures) for measures in self.on)
        return (replace(self, on=on), tuple(wrong)) if wrong else None

    def label(self, names: Sequence[str] = ()) -> Phrase:
        """Return what it consists of: "Joints + Belts on upper part"; no "on" of one piece."""
        if not self.count:
            return phrase("common.without" if len(self.on) == 1 else "several.nothing")
        held: dict[Phrase, list[str]] = {}
        named = names if len(self.on) > 1 else ()
        for number, measures in enumerate(self.on):
            for measure in measures:
                held.setdefault(measure.label, []).extend(named[number : number + 1])
        parts = [phrase("several.joined")] if self.joined else []
        for what, on in held.items():
            pieces = " and ".join(on), "と".join(on)
            parts.append(phrase("several.on", measure=what, pieces=pieces) if on else what)
        return joined(parts, "action_plan.plus")
