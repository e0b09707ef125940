"""Motions of the ground scaled to levels, and the floor motions under the furniture.

A level says how strong the ground shakes: a JMA intensity, or the common logarithm of a spectral
acceleration [g] or of a peak [m/s², m/s], to which each motion is scaled. A scenario may also state a peak,
and a scatter. Without a building, or in one that stays elastic, the floor's motion scales with the ground's;
where storeys yield it does not, and is computed at each level at which it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from typing import TYPE_CHECKING, Self, overload

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.fragility.intensity_measures import JMA_INTENSITY, PFA, PFV, PGA, PGV, IntensityMeasure
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.floors import of_the_ground
from stayput.motion.ground_shaking import GroundStrength, horizontal_peak, horizontal_sa, larger_peak
from stayput.motion.intensity import factor_to_intensity, mercalli_beyond
from stayput.motion.record import Motion

if TYPE_CHECKING:
    from stayput.montecarlo.counting import Members
    from stayput.motion.suites.suite import Suite
    from stayput.scenario import Scenario
    from stayput.scenario.tables import BuildingTable


def growth(measure: IntensityMeasure) -> float:
    """Return by how much a level grows where a motion grows tenfold: JMA's intensity is 2 log10 a + const."""
    return 2.0 if measure.is_logarithm else 1.0


def factors_to_level_zero(measure: IntensityMeasure, motions: Iterable[Motion]) -> NDArray[np.float64]:
    """Return the factors that bring motions to level 0, shape (motions,).

    Parameters
    ----------
    measure : IntensityMeasure
        JMA's intensity, a spectral acceleration, PGA or PGV.
    motions : iterable of Motion
        The motions of the ground.

    Raises
    ------
    InputError
        A motion that is still.
    """
    period = measure.period
    if measure == JMA_INTENSITY:
        return np.array([factor_to_intensity(motion.intensity, 0.0) for motion in motions])
    if period is None:
        peak = "PGA" if measure == PGA else "PGV"
        return np.array([1.0 / horizontal_peak(motion, peak) for motion in motions])
    return np.array([STANDARD_GRAVITY / horizontal_sa(motion, period) for motion in motions])


class ComputedMotions(Sequence[Motion]):
    """Motions that are computed where they are first asked for, and then stay.

    Parameters
    ----------
    calls : sequence of callable
        Each returns a motion.
    """

    def __init__(self, calls: Sequence[Callable[[], Motion]]) -> None:
        self._calls = [cache(call) for call in calls]

    def __len__(self) -> int:
        return len(self._calls)

    @overload
    def __getitem__(self, place: int) -> Motion: ...
    @overload
    def __getitem__(self, place: slice) -> ComputedMotions: ...
    def __getitem__(self, place: int | slice) -> Motion | ComputedMotions:
        """Return a motion, or some of them, which are not computed yet."""
        return ComputedMotions(self._calls[place]) if isinstance(place, slice) else self._calls[place]()

    @classmethod
    def joined(cls, parts: Iterable[Sequence[Motion]]) -> Self:
        """Return the motions of several parts, none of them computed for that."""
        return cls([partial(part.__getitem__, place) for part in parts for place in range(len(part))])


@dataclass(frozen=True, slots=True, eq=False)
class FloorMotions:
    """The motions under the furniture at one level, or at several, one level after the other.

    Parameters
    ----------
    motions : sequence of Motion
        The floor's motions: x; y, where pieces are run in space; and z, where it acts.
    scales : ndarray, shape (motions,)
        Factors on them.
    of_ground : dict
        Each intensity measure of the ground under each motion, shape (motions,).
    floor : str
        The upper floors that the motions were stated for, if they are not of the ground: intensities are
        then by the formula alone, and there is no PGA and no PGV.
    levels : int
        How many levels there are.
    """

    motions: Sequence[Motion]
    scales: NDArray[np.float64]
    of_ground: dict[IntensityMeasure, NDArray[np.float64]]
    floor: str = ""
    levels: int = 1
    _peaks: dict[int, dict[IntensityMeasure, float]] = field(
        default_factory=dict[int, "dict[IntensityMeasure, float]"], init=False
    )

    @classmethod
    def joined(cls, levels: Sequence[FloorMotions]) -> FloorMotions:
        """Return the motions of several levels."""
        return cls(
            ComputedMotions.joined(each.motions for each in levels),
            np.concatenate([each.scales for each in levels]),
            {im: np.concatenate([each.of_ground[im] for each in levels]) for im in levels[0].of_ground},
            levels[0].floor,
            len(levels),
        )

    @property
    def measures(self) -> tuple[IntensityMeasure, ...]:
        """The intensity measures that are known of the motions."""
        usual = (im for im in (JMA_INTENSITY, PGA, PGV) if im in self.of_ground)
        return tuple(dict.fromkeys((*usual, PFA, PFV, *self.of_ground)))

    def values(
        self, measure: IntensityMeasure, place: NDArray[np.intp] | slice = slice(None)
    ) -> NDArray[np.float64]:
        """Return a measure of the motions of some places; floors of others are not computed for it."""
        if measure in self.of_ground:
            return self.of_ground[measure][place]
        places = np.arange(len(self.motions))[place]
        peaks = {number: self._peaks_of(number) for number in np.unique(places).tolist()}
        return np.abs(self.scales[place]) * [peaks[number][measure] for number in places.tolist()]

    def _peaks_of(self, place: int) -> dict[IntensityMeasure, float]:
        motion = self.motions[place]
        if id(motion) not in self._peaks:  # without a building all levels have one motion
            self._peaks[id(motion)] = {PFA: larger_peak(motion, "PGA"), PFV: larger_peak(motion, "PGV")}
        return self._peaks[id(motion)]

    @property
    def each(self) -> int:
        """How many motions there are at each level."""
        return len(self.motions) // self.levels

    def place(self, members: Members) -> NDArray[np.intp]:
        """Return the place of the motion of each run."""
        return members.level * self.each + members.motion

    @property
    def median_intensity(self) -> float:
        """Median JMA intensity of the ground."""
        return float(np.median(self.of_ground[JMA_INTENSITY]))


@dataclass(frozen=True, eq=False)
class ScaledMotions:
    """Motions of the ground that are scaled to levels, and those of a floor of the building above them.

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
    dimensions : int
        2 where pieces are run in the plane, 3 in space.
    further : tuple of IntensityMeasure
        Measures that are wanted beside the usual ones: modified Mercalli intensity, or spectral accelerations
        of the ground.
    measure : IntensityMeasure
        What levels are of: JMA's intensity, a spectral acceleration, PGA or PGV.
    """

    ground: Suite
    building: BuildingTable | None = None
    storey: int = 1
    vertical: bool = True
    dimensions: int = 2
    further: tuple[IntensityMeasure, ...] = ()
    measure: IntensityMeasure = JMA_INTENSITY

    @classmethod
    def of(
        cls, scenario: Scenario, further: tuple[IntensityMeasure, ...] = (), ground: Suite | None = None
    ) -> ScaledMotions:
        """Return that of a scenario, or with other motions of the ground in the place of its own."""
        shaking, motions = scenario.shaking, scenario.ground() if ground is None else ground
        place = shaking.building, shaking.storey or 1
        return cls(motions, *place, bool(shaking.vertical), scenario.dimensions, further)

    @cached_property
    def to_jma_zero(self) -> NDArray[np.float64]:
        """Factors that bring the motions to JMA intensity 0, shape (motions,)."""
        return factors_to_level_zero(JMA_INTENSITY, self.ground)

    @cached_property
    def to_zero(self) -> NDArray[np.float64]:
        """Factors that bring the motions to level 0, shape (motions,)."""
        if self.measure == JMA_INTENSITY:
            return self.to_jma_zero
        return factors_to_level_zero(self.measure, self.ground)

    @cached_property
    def acting(self) -> tuple[Motion, ...]:
        """The motions without the components that do not act on the furniture."""
        return tuple(
            replace(
                motion, y=motion.y if self.dimensions == 3 else None, z=motion.z if self.vertical else None
            )
            for motion in self.ground
        )

    def factors(self, level: float, scatter: float = 0.0, seed: int = 0) -> NDArray[np.float64]:
        """Return the factors to a level, or to levels out of its scatter (see `GroundStrength.drawn`).

        Parameters
        ----------
        level : float
            The median level.
        scatter : float
            Its standard deviation.
        seed : int
            Seed by which the motions have their levels out of the scatter.
        """
        each = GroundStrength("JMA", level, scatter).drawn(len(self.ground), seed)
        return np.array([10.0 ** (ground.level / growth(self.measure)) for ground in each]) * self.to_zero

    def stated_factors(
        self, strength: GroundStrength | None, scale: float | None, seed: int
    ) -> NDArray[np.float64]:
        """Return the factors to what a scenario states: a strength with its scatter, or a factor (default 1).

        Parameters
        ----------
        strength : GroundStrength, optional
            The strength. To a peak, the motions have one of 1 (see `stayput.scenario.shaking`).
        scale : float, optional
            The factor, where there is no strength.
        seed : int
            Seed by which the motions have their strengths out of the scatter.
        """
        if strength is None:
            return np.full(len(self.ground), 1.0 if scale is None else scale)
        each = strength.drawn(len(self.ground), seed)
        if strength.measure == "JMA":
            steps = np.array([10.0 ** (ground.level / growth(JMA_INTENSITY)) for ground in each])
            return steps * self.to_jma_zero
        return np.array([ground.median for ground in each])

    def intensities(self, factors: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the JMA intensities of the motions times factors."""
        return 2.0 * np.log10(np.abs(factors) / self.to_jma_zero)

    def median_intensity(self, factors: NDArray[np.float64]) -> float:
        """Return the median JMA intensity of the motions times factors."""
        return float(np.median(self.intensities(factors)))

    def floors(
        self,
        building: BuildingTable | None,
        storeys: Sequence[int],
        factors: NDArray[np.float64],
        threads: int | None = None,
    ) -> tuple[list[tuple[Motion, ...]], NDArray[np.float64]]:
        """Return the motions under the furniture of each storey, and the factors on them.

        Parameters
        ----------
        building : BuildingTable, optional
            The building, which is computed once for all its storeys; none on the ground.
        storeys : sequence of int
            The storeys; anything without a building.
        factors : ndarray, shape (motions,)
            Factors on the ground's motions.
        threads : int, optional
            As many as there are cores by default. The bits do not depend on them.
        """
        acting = self.acting
        if building is None:
            return [acting for _ in storeys], factors
        if building.yields:
            acting = tuple(motion.scaled(float(k)) for motion, k in zip(acting, factors, strict=True))
            factors = np.ones(len(factors))
        by_motion = building.building().floor_motions(acting, list(storeys), threads=threads)
        return list(zip(*by_motion, strict=True)), factors

    @cached_property
    def _elastic(self) -> Sequence[Motion]:
        """The floor's motions where they scale with the ground's."""
        return self.floors(self.building, (self.storey,), np.ones(len(self.ground)))[0][0]

    @cached_property
    def _ground_peaks(self) -> dict[IntensityMeasure, NDArray[np.float64]]:
        """PGA and PGV of the motions, of the larger component each."""
        return {
            PGA: np.array([larger_peak(motion, "PGA") for motion in self.acting]),
            PGV: np.array([larger_peak(motion, "PGV") for motion in self.acting]),
        }

    def at(self, intensity: float) -> FloorMotions:
        """Return the motions under the furniture with the ground at a JMA intensity.

        Parameters
        ----------
        intensity : float
            The level.

        Raises
        ------
        InputError
            A still motion.
        """
        return self._with(self.factors(intensity))

    def stated(
        self, strength: GroundStrength | None, scale: float | None, seed: int, times: float = 1.0
    ) -> FloorMotions:
        """Return the motions at so many times the shaking that a scenario states; see `stated_factors`."""
        return self._with(times * self.stated_factors(strength, scale, seed))

    def stated_by(self, scenario: Scenario, times: float = 1.0) -> FloorMotions:
        """Return the same as a scenario states it, refused with its file's name."""
        shaking, seed = scenario.shaking, scenario.uncertainty.seed
        with scenario.naming_file("shaking"):
            if shaking.scale == 0.0:
                raise InputError("motion.still_floor", "shaking.scale")
            return self.stated(shaking.strength, shaking.scale, seed, times)

    def _with(self, factors: NDArray[np.float64]) -> FloorMotions:
        if self.building is not None and self.building.yields:
            motions, scales = self._yielding(self.building, factors), np.ones(len(factors))
        else:
            motions, scales = self._elastic, factors
        measures = {JMA_INTENSITY: self.intensities(factors)}
        if not self.ground.floor:
            measures |= {im: np.abs(factors) * peaks for im, peaks in self._ground_peaks.items()}
        for measure in self.further:
            if measure not in measures and measure not in (PFA, PFV):
                measures[measure] = self._further(measure, np.abs(factors))
        return FloorMotions(motions, scales, measures, self.ground.floor)

    def _yielding(self, building: BuildingTable, factors: NDArray[np.float64]) -> ComputedMotions:
        """Return the floor's motions in a building that yields under the ground's motions times factors."""
        model = building.building()

        def floor_of(motion: Motion, factor: float) -> Motion:
            ((floor,),) = model.floor_motions((motion.scaled(factor),), (self.storey,), threads=1)
            return floor

        of_motions = zip(self.acting, factors.tolist(), strict=True)
        return ComputedMotions([partial(floor_of, motion, factor) for motion, factor in of_motions])

    @cached_property
    def _horizontal_peaks(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        pga, pgv = ([horizontal_peak(motion, name) for motion in self.ground] for name in ("PGA", "PGV"))
        return np.array(pga), np.array(pgv)

    @cached_property
    def _spectral(self) -> dict[float, NDArray[np.float64]]:
        periods = [measure.period for measure in self.further if measure.period is not None]
        return {T: np.array([horizontal_sa(motion, T) for motion in self.ground]) for T in periods}

    def _further(self, measure: IntensityMeasure, factors: NDArray[np.float64]) -> NDArray[np.float64]:
        for motion in self.ground:
            of_the_ground(motion, "measure")
        if measure.period is not None:
            return factors * self._spectral[measure.period]
        pga, pgv = self._horizontal_peaks
        return np.array([mercalli_beyond(k * a, k * v) for k, a, v in zip(factors, pga, pgv, strict=True)])
