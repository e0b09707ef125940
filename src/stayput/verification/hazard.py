"""The shaking of a verification: every motion at every level, as the furniture feels it.

A level is the strength of the ground: a JMA intensity to which each motion is scaled. Without a building, or
with one that stays elastic, the floor's motion scales with the ground's; where storeys yield it does not, and
is computed anew at each level.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from stayput.fragility import JMA_INTENSITY, PFA, PFV, PGA, PGV
from stayput.motion.intensity import factor_to_intensity

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.fragility import IntensityMeasure
    from stayput.motion import Motion
    from stayput.motion.suites import Suite
    from stayput.scenario.building import BuildingTable


@dataclass(frozen=True, slots=True, eq=False)
class Floors:
    """The motions under the furniture at one level.

    Parameters
    ----------
    motions : tuple of Motion
        The floor's motions, x and, where it acts, z.
    scales : ndarray, shape (motions,)
        Factors on them.
    measures : dict
        Each intensity measure of each motion, shape (motions,).
    """

    motions: tuple[Motion, ...]
    scales: NDArray[np.float64]
    measures: dict[IntensityMeasure, NDArray[np.float64]]

    def felt(self, number: int) -> Motion:
        """Return a motion as it is felt, scaled."""
        scale = float(self.scales[number])
        return self.motions[number] if scale == 1.0 else self.motions[number].scaled(scale)


@dataclass(frozen=True, eq=False)
class Hazard:
    """The motions of the ground, and the building between them and the furniture.

    Parameters
    ----------
    ground : Suite
        The motions of the ground; their own strength does not matter.
    building : BuildingTable, optional
        The building; none on the ground.
    storey : int
        The storey where the furniture stands.
    vertical : bool
        Whether the vertical motion acts on the furniture. The intensity counts it in any case.
    """

    ground: Suite
    building: BuildingTable | None = None
    storey: int = 1
    vertical: bool = True

    @cached_property
    def _to_zero(self) -> NDArray[np.float64]:
        """Factors that bring the motions to intensity 0."""
        return np.array([factor_to_intensity(motion, 0.0) for motion in self.ground])

    @cached_property
    def _acting(self) -> tuple[Motion, ...]:
        """The ground's motions without what does not act."""
        return tuple(replace(motion, y=None, z=motion.z if self.vertical else None) for motion in self.ground)

    @cached_property
    def _elastic(self) -> tuple[Motion, ...]:
        """The floor's motions where they scale with the ground's."""
        return self._acting if self.building is None else self._floors(self._acting, None)

    def _floors(self, ground: tuple[Motion, ...], threads: int | None) -> tuple[Motion, ...]:
        assert self.building is not None
        made = self.building.building()
        return tuple(floor for (floor,) in made.floor_motions(ground, [self.storey], threads=threads))

    def at(self, intensity: float, threads: int | None = None) -> Floors:
        """Return the motions under the furniture with the ground at a JMA intensity.

        Parameters
        ----------
        intensity : float
            The level.
        threads : int, optional
            As many as there are cores by default. The bits do not depend on them.

        Raises
        ------
        InputError
            A still motion.
        """
        return self._with(10.0 ** (0.5 * intensity) * self._to_zero, threads)

    def as_given(self, scale: float = 1.0, threads: int | None = None) -> Floors:
        """Return the motions under the furniture with the ground's own strength times a factor."""
        return self._with(np.full(len(self.ground), scale), threads)

    def _with(self, factors: NDArray[np.float64], threads: int | None) -> Floors:
        if self.building is not None and self.building.yields:
            scaled = tuple(m.scaled(float(k)) for m, k in zip(self._acting, factors, strict=True))
            motions, scales = self._floors(scaled, threads), np.ones(len(factors))
        else:
            motions, scales = self._elastic, factors

        def peaks(of: tuple[Motion, ...], name: str) -> NDArray[np.float64]:
            return np.array([getattr(motion, name) for motion in of])

        measures = {
            JMA_INTENSITY: 2.0 * np.log10(np.abs(factors) / self._to_zero),
            PGA: np.abs(factors) * peaks(self._acting, "pga"),
            PGV: np.abs(factors) * peaks(self._acting, "pgv"),
            PFA: np.abs(scales) * peaks(motions, "pga"),
            PFV: np.abs(scales) * peaks(motions, "pgv"),
        }
        return Floors(motions, scales, measures)
