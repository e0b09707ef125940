"""What devices have to bear: peak forces over the runs, and the strength to ask for in a shop.

A device that gives way bears no more than its strength, and tells nothing of what it would have had to bear.
So its peak forces are taken from runs in which it cannot fail, with the stiffness that it has.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.measures import GelMats, TensionPole
from stayput.measures.wall import WallDevice
from stayput.uncertainty import USUAL

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.measures import Held, Measure

QUANTILE = 0.95
"""Share of the runs in which a device of the strength asked for is strong enough, with no margin."""

MARGIN = 1.0 / float(USUAL["strength"].quantile(np.array(1.0 - QUANTILE)))
"""What a strength is multiplied by: a product's median strength over what 95 of 100 of them reach.

That is the scatter of strengths that all runs draw from; a strength that 95 % reach is what EN 1990 calls
characteristic (4.2(3), recalled and not read again).
"""

UNBREAKABLE = 1e6
"""Strength of a device that cannot fail [N]: the most that one may be given."""


class DeviceForces(NamedTuple):
    """Forces on one device [N]: away from what it is fixed to, towards it, and across."""

    pull: float
    push: float
    shear: float

    def times(self, factor: float) -> DeviceForces:
        """Return them multiplied."""
        return DeviceForces(*(factor * force for force in self))


PeakForces = dict[tuple[int, str], DeviceForces]
"""Largest forces on any of the like devices in a run, by the piece's place in its part and the kind."""


def peak_forces(place: int, held: Held, devices: NDArray[np.void], mass: float) -> PeakForces:
    """Return the largest forces of a run on one of each kind of device of a piece.

    Parameters
    ----------
    place : int
        The place of the piece in its part.
    held : Held
        The piece with its devices.
    devices : ndarray of DEVICE
        What became of them.
    mass : float
        By what the forces are multiplied: the body's mass [kg] where they are per unit mass.
    """
    found: PeakForces = {}
    for element, device in zip(held.elements, devices, strict=True):
        each = mass / element.count
        own = DeviceForces(*(each * float(device[name]) for name in ("peak_pull", "peak_push", "peak_shear")))
        known = found.get((place, element.kind), own)
        found[place, element.kind] = DeviceForces(*map(max, own, known))
    return found


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
