"""What devices have to bear, the strength to ask for in a shop, and how many of them a fixing needs.

A device that gives way bears no more than its strength, and tells nothing of what it would have had to bear.
So its peak forces are taken from runs in which it cannot fail, with the stiffness that it has.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.measures import GelMats, Held, Measure, TensionPole
from stayput.measures.wall import WallDevice
from stayput.rooms.runs import DeviceForces, PeakForces, RoomPart, with_member
from stayput.rooms.steps import STUD_PITCH
from stayput.simulation.placing import placed
from stayput.simulation.standing import Piece
from stayput.uncertainty import USUAL

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.catalogue import Phrase
    from stayput.rooms.runs import Question

QUANTILE = 0.95
"""Share of the runs in which a device of the strength asked for is strong enough, with no margin."""

MARGIN = 1.0 / float(USUAL["strength"].quantile(np.array(1.0 - QUANTILE)))
"""What a strength is multiplied by: a product's median strength over what 95 of 100 of them reach.

That is the scatter of strengths that all runs draw from; a strength that 95 % reach is what EN 1990 calls
characteristic (4.2(3), recalled and not read again).
"""

UNBREAKABLE = 1e6
"""Strength of a device that cannot fail [N]: the most that one may be given."""


def quantile_of(peaks: Sequence[PeakForces], key: tuple[int, str]) -> DeviceForces:
    """Return what the forces on a device do not exceed in `QUANTILE` of the runs, each by itself."""
    values = np.sort(np.array([run[key] for run in peaks]), axis=0)
    forces = values[min(len(values) - 1, math.ceil(QUANTILE * len(values)) - 1)]
    return DeviceForces(*forces.tolist())


def unbreakable(measure: Measure) -> Measure:
    """Return a measure that has the same stiffness and cannot fail."""
    match measure:
        case WallDevice():
            return replace(measure, strength=UNBREAKABLE)
        case TensionPole():
            return replace(measure, strength=UNBREAKABLE)
        case GelMats():
            return replace(measure, tension=1e7, shear=1e7, realism=1.0)
        case _:
            return measure


@dataclass(frozen=True, slots=True)
class Purchase:
    """A product to buy for a piece.

    Parameters
    ----------
    measure : Measure
        The measure, with how many there are.
    needed : DeviceForces or None
        What one must be rated for: its peak forces in `QUANTILE` of the runs times `MARGIN` [N]; None of what
        bears no force of its own.
    holds : DeviceForces or None
        What one holds as computed, with what it is fixed to [N]; inf: any.
    fails : Phrase or None
        What gives way first, as a clause.
    """

    measure: Measure
    needed: DeviceForces | None = None
    holds: DeviceForces | None = None
    fails: Phrase | None = None

    @property
    def count(self) -> int:
        """How many to buy."""
        return getattr(self.measure, "count", 1)

    @property
    def enough(self) -> bool:
        """Whether what it is fixed to holds what is needed, as far as the computed strengths tell."""
        return self.needed is None or self.holds is None or more_than(self.needed, self.holds) <= 1.0


def more_than(needed: DeviceForces, holds: DeviceForces) -> float:
    """Return the largest ratio of what is needed to what is held."""
    return max(
        force / strength if strength > 0.0 else 0.0 for force, strength in zip(needed, holds, strict=True)
    )


def strengths_of(held: Held, kind: str) -> tuple[DeviceForces, Phrase | None] | None:
    """Return what one device of a kind holds in place [N], and what gives way; None if it bears no force.

    Parameters
    ----------
    held : Held
        The piece with the device in place.
    kind : str
        The measure.
    """
    elements = [element for element in held.elements if element.kind == kind]
    if not elements:
        return None
    weakest = elements[0]
    normal, tangent = weakest.normal.shared(weakest.count), weakest.tangent.shared(weakest.count)
    across = min(tangent.limit_plus, tangent.limit_minus) if tangent.stiffness > 0.0 else math.inf
    return DeviceForces(normal.limit_plus, normal.limit_minus, across), weakest.normal.weakest


def purchases_of(
    question: Question, part: RoomPart, measures: tuple[Measure, ...], body: int
) -> tuple[Purchase, ...]:
    """Return what to buy: how strong one must be, and how strong what it is fixed to is."""
    place = part.bodies.index(body)
    piece = part.assembly.members[place]
    held = placed(part.assembly.members, part.room)[place].held
    assert isinstance(piece, Piece)
    assert held is not None
    kinds = {measure.kind for measure in measures}
    strong = tuple(
        unbreakable(measure.fitted_to(piece.body)) if measure.kind in kinds else measure
        for measure in piece.measures
    )
    member = replace(piece, measures=strong)
    runs = question.run([part._replace(assembly=with_member(part.assembly, place, member))])[0]
    found: list[Purchase] = []
    for measure in measures:
        strengths = strengths_of(held, measure.kind)
        if strengths is None:
            found.append(Purchase(measure))
            continue
        holds, fails = strengths
        needed = quantile_of(runs.peaks, (place, measure.kind)).times(MARGIN)
        found.append(Purchase(measure, needed, holds, fails))
    return tuple(found)


def in_number(purchase: Purchase, length: float) -> Measure:
    """Return a device on a wall in the number that its fixing needs, one on each stud at most."""
    measure = purchase.measure
    if not isinstance(measure, WallDevice) or purchase.needed is None or purchase.holds is None:
        return measure
    most = max(measure.count, math.floor(length / STUD_PITCH[0]) + 1)
    needed = math.ceil(measure.count * more_than(purchase.needed, purchase.holds))
    return replace(measure, count=min(most, max(measure.count, needed)))
