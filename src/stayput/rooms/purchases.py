"""What to buy for a piece, and how strong: the strengths are those of `stayput.verification.demand`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.measures.wall import WallDevice, most_on_studs
from stayput.simulation.placing import placed
from stayput.uncertainty import USUAL
from stayput.verification.demand import DEMAND_RUNS, demand_runs

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.measures import Element, Measure
    from stayput.scenario.measures import Option
    from stayput.verification.option_runner import OptionRunner

QUANTILE = 0.95
"""Share of the runs in which a device of the strength asked for is strong enough, with no margin."""

MARGIN = 1.0 / float(USUAL["strength"].quantile(np.array(1.0 - QUANTILE)))
"""What a strength is multiplied by: a product's median strength over what 95 of 100 of them reach.

That is the scatter of strengths that all runs draw from; a strength that 95 % reach is what EN 1990 calls
characteristic (4.2(3), recalled and not read again).
"""


class DeviceForces(NamedTuple):
    """Forces on one device [N]: away from what it is fixed to, towards it, and across."""

    pull: float
    push: float
    shear: float


def quantile_of(devices: NDArray[np.void], elements: Sequence[Element]) -> DeviceForces:
    """Return what the forces on one device of a kind do not exceed in `QUANTILE` of the runs, each by itself.

    Parameters
    ----------
    devices : ndarray of DEVICE, shape (runs, elements)
        What became of them.
    elements : sequence of Element
        The devices, each for a number of like ones.
    """
    counts = np.array([element.count for element in elements])

    def quantile(name: str) -> float:
        peaks = np.sort((devices[name] / counts).max(axis=-1))
        return float(peaks[min(len(peaks) - 1, math.ceil(QUANTILE * len(peaks)) - 1)])

    return DeviceForces(*map(quantile, ("peak_pull", "peak_push", "peak_shear")))


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


def purchases_of(
    runner: OptionRunner, option: Option, measures: tuple[Measure, ...], body: int, count: int = DEMAND_RUNS
) -> tuple[Purchase, ...]:
    """Return what to buy for a piece: how strong one must be, and how strong what it is fixed to is.

    Parameters
    ----------
    runner : OptionRunner
        The motions and draws.
    option : Option
        The room with these measures.
    measures : tuple of Measure
        What is put on the piece, beside what is on it already.
    body : int
        The piece.
    count : int
        How many runs tell it.
    """
    scene = runner.scene(option)
    held, kinds = placed(scene)[body].held, {measure.kind for measure in measures}
    assert held is not None
    strong = tuple(measure.unbreakable() if measure.kind in kinds else measure for measure in option.on[body])
    on = (*option.on[:body], strong, *option.on[body + 1 :])
    of_piece = [names == (scene.names[body],) for names, _ in runner.held_by(option)]
    devices = demand_runs(runner, option, replace(option, on=on), count).devices[:, of_piece]
    purchases: list[Purchase] = []
    for measure in measures:
        like = [n for n, element in enumerate(held.elements) if element.kind == measure.kind]
        if not like:  # it bears no force
            purchases.append(Purchase(measure))
            continue
        elements = [held.elements[n] for n in like]
        device = elements[0]
        normal, tangent = device.normal.shared(device.count), device.tangent.shared(device.count)
        across = min(tangent.limit_plus, tangent.limit_minus) if tangent.stiffness > 0.0 else math.inf
        holds = DeviceForces(normal.limit_plus, normal.limit_minus, across)
        needed = DeviceForces(*(MARGIN * force for force in quantile_of(devices[..., like], elements)))
        purchases.append(Purchase(measure, needed, holds, device.normal.weakest))
    return tuple(purchases)


def in_number(purchase: Purchase, length: float) -> Measure:
    """Return a device on a wall in the number that its fixing needs, one on each stud at most."""
    measure = purchase.measure
    if not isinstance(measure, WallDevice) or purchase.needed is None or purchase.holds is None:
        return measure
    most = max(measure.count, most_on_studs(length))
    needed = math.ceil(measure.count * more_than(purchase.needed, purchase.holds))
    return replace(measure, count=min(most, max(measure.count, needed)))
