"""The motions under the furniture of a building's storeys, computed once for all pieces there.

They are those of `stayput.verification.hazard.Hazard`, storey by storey; a building answers for all its
storeys at once.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.inventory.strength import JMA
from stayput.mechanics.runner import Shaking, shaking

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.inventory.strength import Strength
    from stayput.motion import Motion
    from stayput.motion.suites import Suite
    from stayput.scenario.building import BuildingTable


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Motions of the ground, and the factors that bring each to level 0.

    Parameters
    ----------
    motions : Suite
        The motions.
    vertical : bool
        Whether the vertical motion acts on the furniture.
    strength : Strength
        What levels mean.
    to_zero : ndarray, shape (motions,)
        The factors.
    to_jma_zero : ndarray, shape (motions,)
        The same of JMA's intensity.
    """

    motions: Suite
    vertical: bool
    strength: Strength
    to_zero: NDArray[np.float64]
    to_jma_zero: NDArray[np.float64]

    @classmethod
    def of(cls, motions: Suite, vertical: bool, strength: Strength = JMA) -> Ground:
        """Return the ground with these motions."""
        jma = JMA.to_zero(motions)
        return cls(motions, vertical, strength, jma if strength == JMA else strength.to_zero(motions), jma)

    def factors(self, level: float | None, scale: float) -> NDArray[np.float64]:
        """Return the factors to a level, or the scale for each motion where there is none."""
        if level is None:
            return np.full(len(self.motions), scale)
        return 10.0 ** (level / self.strength.growth) * self.to_zero

    def median_intensity(self, factors: NDArray[np.float64]) -> float:
        """Return the median JMA intensity of the motions times factors."""
        return float(np.median(2.0 * np.log10(np.abs(factors) / self.to_jma_zero)))


@dataclass(frozen=True, slots=True, eq=False)
class Floor:
    """What shakes the furniture of one storey: motions ready for the mechanics, and factors on them."""

    shakings: tuple[Shaking, ...]
    scales: NDArray[np.float64]


def floors_of(
    ground: Ground, building: BuildingTable | None, storeys: Sequence[int], factors: NDArray[np.float64]
) -> dict[int, Floor]:
    """Return what shakes the furniture of each storey.

    Parameters
    ----------
    ground : Ground
        The motions of the ground.
    building : BuildingTable, optional
        The building; none on the ground.
    storeys : sequence of int
        Storeys; anything without a building.
    factors : ndarray, shape (motions,)
        Factors on the ground's motions.
    """
    acting = tuple(
        replace(motion, y=None, z=motion.z if ground.vertical else None) for motion in ground.motions
    )
    scales = factors
    if building is None:
        return dict.fromkeys(storeys, Floor(tuple(map(_ready, acting)), scales))
    if building.yields:
        acting = tuple(motion.scaled(float(k)) for motion, k in zip(acting, factors, strict=True))
        scales = np.ones(len(factors))
    ready: list[list[Shaking]] = [[] for _ in storeys]
    for found in building.building().floor_motions(acting, list(storeys), threads=1):
        for kept, motion in zip(ready, found, strict=True):
            kept.append(_ready(motion))
    return {storey: Floor(tuple(kept), scales) for storey, kept in zip(storeys, ready, strict=True)}


def _ready(motion: Motion) -> Shaking:
    return shaking(motion.x, motion.z, motion.dt, 0)
