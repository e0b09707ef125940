"""What has been tried for a plan to buy and do, and which of it is better."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from stayput.fragility import Probability
    from stayput.measures import Measure
    from stayput.model.floor_plan import PersonPlace
    from stayput.rooms.runs import PartRuns
    from stayput.rooms.steps import PlanStep
    from stayput.rooms.tracks import Track
    from stayput.rooms.verdict import RoomEffect

ALIKE = 0.005
"""Risks that differ by no more than this are equal in the order of steps: half a per cent."""


class OtherTracks(NamedTuple):
    """How some pieces move otherwise: their tracks, and which of their runs were given up."""

    tracks: Mapping[int, Sequence[Track]]
    missing: NDArray[np.bool_]

    def joined(self, other: OtherTracks) -> OtherTracks:
        """Return this with other pieces, or the same once more otherwise."""
        return OtherTracks({**self.tracks, **other.tracks}, self.missing | other.missing)


class Trial(NamedTuple):
    """Measures on a piece that have run where it stands; ``own`` is the risk from its part of the room."""

    measures: tuple[Measure, ...]
    way: OtherTracks
    effect: RoomEffect
    own: float
    overturns: Probability


class ChosenStep(NamedTuple):
    """A step before its place in the order is known.

    ``here`` is how the piece moves then where it stands; ``there``, once it has been moved. ``place`` is the
    place of a person where it is moved to, with its number.
    """

    step: PlanStep
    place: tuple[int, PersonPlace] | None
    here: OtherTracks
    there: OtherTracks


def chance_of_overturning(runs: PartRuns, place: int) -> Probability:
    """Return the chance that one of the pieces of a part overturns."""
    return runs.of_body(place).probability_of_overturning()


def in_order_of_gain(effect: RoomEffect) -> tuple[float, ...]:
    """Return the sort key of what something brings, the best first: for people, and then what overturns."""
    return (*for_people(effect), round(effect.fallen / ALIKE))


def for_people(effect: RoomEffect) -> tuple[float, ...]:
    """Return how much happens to people, who is hit before who is shut in."""
    return (
        round(effect.risk / ALIKE),
        round(effect.shut_in.estimate / ALIKE),
        round(effect.blocked.estimate / ALIKE),
    )


def merit(tried: Trial) -> tuple[float, ...]:
    """Return the sort key of measures on a piece: of those that bring the same, what it falls with least."""
    own, effect = round(tried.own / ALIKE), tried.effect
    ways = round(effect.shut_in.estimate / ALIKE), round(effect.blocked.estimate / ALIKE)
    return (own, *ways, round(tried.overturns.estimate / ALIKE), len(tried.measures))


def frees(effect: RoomEffect) -> bool:
    """Return whether a way out is free more often, clearly or not."""
    return any(one.estimate < 0.0 for one in (effect.shut_in_change, effect.blocked_change))
