"""Counts of falls over an intensity measure, observed shares by level, and their isotonic regression.

The share that falls is only assumed not to decrease: the estimate is the isotonic regression of the levels'
shares (Barlow, Bartholomew, Bremner and Brunk 1972), by the algorithm of pool-adjacent-violators, drawn
straight from level to level. The band is that of the levels' own intervals, which know that runs of one
motion are alike: levels that are put together have the widest of theirs, and what a level leaves out is left
out at weaker ones from above and at stronger ones from below. From level to level it is drawn straight in
Φ⁻¹(p), in which a normal curve is straight: below a level where the lower end is 0 nothing is known but that
it is not less, and so on above. Where the share rises by more than a half from one level to the next, what
lies between was not seen, and the band there is as wide as at both.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtr, ndtri

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, not_allowed, numbers
from stayput.fragility.intensity_measures import IntensityMeasure
from stayput.fragility.probabilities import Probability, checked_runs, probability_of_counts

_JUMP = 0.5
"""Rise of the share from one level to the next above which nothing is said of what lies between."""


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Trials:
    """Runs and falls, counted in cells; made by one of the three methods below.

    Parameters
    ----------
    measure : IntensityMeasure
        What the cells' intensity is.
    im : ndarray, shape (cells,)
        Intensity of each cell [SI].
    fell, runs : ndarray, shape (cells,)
        Counts in each cell; every cell has runs.
    level : ndarray of int, shape (cells,)
        Group in which a cell's observed fraction is shown.
    motion : ndarray of int, shape (cells,), optional
        Motion of each cell, since the runs of a motion are alike; None where all runs are independent.
    missing : int
        Runs that were given up; they are in no cell.

    Examples
    --------
    >>> import numpy as np
    >>> import stayput as sp
    >>> from stayput.fragility.intensity_measures import PGA
    >>> fell = np.zeros((2, 3, 10), dtype=bool)  # at 2 levels, under 3 motions, 10 samples each
    >>> fell[1, 0], fell[1, 1, :4] = True, True
    >>> trials = sp.Trials.from_runs(PGA, [3.0, 6.0], fell)
    >>> trials, trials.motions
    (Trials(PGA, 6 cells, 14 of 60 fell), 3)
    """

    measure: IntensityMeasure
    im: NDArray[np.float64]
    fell: NDArray[np.float64]
    runs: NDArray[np.float64]
    level: NDArray[np.intp]
    motion: NDArray[np.intp] | None = None
    missing: int = 0

    def __repr__(self) -> str:
        fell, runs = int(self.fell.sum()), int(self.runs.sum())
        return f"Trials({self.measure.key}, {len(self)} cells, {fell} of {runs} fell)"

    def __len__(self) -> int:
        return len(self.im)

    @property
    def motions(self) -> int:
        """How many motions there are; 0 where all runs are independent, and each has its own."""
        return 0 if self.motion is None else int(self.motion.max()) + 1

    @property
    def one_motion(self) -> bool:
        """Whether all runs are of one motion, so that they tell nothing of how motions scatter."""
        return self.motions == 1

    @classmethod
    def from_runs(
        cls, measure: IntensityMeasure, im: ArrayLike, fallen: ArrayLike, missing: ArrayLike | None = None
    ) -> Trials:
        """Count runs in which every motion is scaled to every level (incremental analysis).

        Parameters
        ----------
        measure : IntensityMeasure
            What ``im`` is.
        im : array_like, shape (levels,) or (levels, motions)
            Intensity of the levels, or of each motion at each level [SI]. Where the levels overlap, the
            observed fractions are those of as many groups of about equal size.
        fallen : array_like of bool, shape (levels, motions, samples)
            Whether it fell.
        missing : array_like of bool, same shape, optional
            Runs that were given up.

        Raises
        ------
        InputError
            Arrays of another shape, or intensities that cannot be.
        """
        fell, given_up = checked_runs(fallen, missing, 3)
        values = instance_of("measure", measure, IntensityMeasure).checked(im)
        if values.shape not in (fell.shape[:1], fell.shape[:2]):
            levels, motions = str(fell.shape[:1]), str(fell.shape[:2])
            allowed = phrase("fragility.either", first=levels, second=motions)
            raise not_allowed(phrase("common.shape_of", name="im"), str(values.shape), allowed)
        if values.ndim == 1:
            values = np.repeat(values[:, np.newaxis], fell.shape[1], axis=1)
        level, motion = np.indices(values.shape)
        if (values.max(axis=1)[:-1] >= values.min(axis=1)[1:]).any():
            # levels of another measure than this one: motions of one level differ in it
            level = _groups(values, len(values))
        counts = (fell & ~given_up).sum(axis=2), (~given_up).sum(axis=2)
        k, n = (each.ravel() for each in counts)
        lost = int(given_up.sum())
        return cls._of_cells(measure, values.ravel(), k, n, level.ravel(), motion.ravel(), lost)

    @classmethod
    def from_counts(
        cls, measure: IntensityMeasure, im: ArrayLike, fell: ArrayLike, runs: ArrayLike
    ) -> Trials:
        """Take independent runs counted by level (multiple stripes, each of other motions).

        Parameters
        ----------
        measure : IntensityMeasure
            What ``im`` is.
        im, fell, runs : array_like, shape (levels,)
            Intensity [SI], falls and runs of each level.

        Raises
        ------
        InputError
            Arrays of other shapes, more falls than runs, or intensities that cannot be.
        """
        values = instance_of("measure", measure, IntensityMeasure).checked(im)
        _, k, n = (
            numbers(name, row, name, values.size)
            for name, row in (("im", im), ("fell", fell), ("runs", runs))
        )
        bad = ~((k >= 0.0) & (k <= n) & (k == np.rint(k)) & (n == np.rint(n)))
        if bad.any():
            raise InputError("fragility.bad_counts", fell=k[bad][0], runs=n[bad][0])
        return cls._of_cells(measure, values, k, n, np.arange(len(values)), None)

    @classmethod
    def _of_cells(
        cls,
        measure: IntensityMeasure,
        im: NDArray[np.float64],
        fell: NDArray[np.number | np.bool_],
        runs: NDArray[np.number],
        level: NDArray[np.integer],
        motion: NDArray[np.integer] | None,
        missing: int = 0,
    ) -> Trials:
        used = runs > 0
        if not used.any():
            raise InputError("fragility.no_runs")
        names = None
        if motion is not None:
            names = np.unique(motion[used], return_inverse=True)[1].astype(np.intp)
        k, n = fell[used].astype(np.float64), runs[used].astype(np.float64)
        return cls(measure, im[used], k, n, level[used].astype(np.intp), names, missing)


def _groups(values: NDArray[np.float64], groups: int) -> NDArray[np.intp]:
    """Return the group of each value, of groups of about equal size."""
    rank = np.argsort(np.argsort(values, axis=None, kind="stable"), kind="stable")
    return ((rank * groups) // values.size).reshape(values.shape)


@dataclass(frozen=True, slots=True)
class Level:
    """A group of cells of about one intensity.

    Parameters
    ----------
    im, lowest, highest : float
        Mean (of the logarithm, for a peak), smallest and largest intensity [SI].
    probability : Probability
        What was observed.
    """

    im: float
    lowest: float
    highest: float
    probability: Probability


def observed_levels(trials: Trials) -> tuple[Level, ...]:
    """Return the levels of some trials, from the weakest to the strongest."""
    levels: list[Level] = []
    u = trials.measure.coordinate(trials.im)
    for number in np.unique(trials.level):
        inside = trials.level == number
        k, n = trials.fell[inside], trials.runs[inside]
        if trials.motion is not None:
            names = trials.motion[inside]
            k, n = np.bincount(names, k), np.bincount(names, n)
        else:
            k, n = k.sum(keepdims=True), n.sum(keepdims=True)
        middle = trials.measure.value(np.average(u[inside], weights=trials.runs[inside]))
        ends = trials.im[inside].min(), trials.im[inside].max()
        share = probability_of_counts(k, n)
        if trials.motions > 1 == share.motions:
            # the only one of the motions here says nothing of the others
            share = replace(share, low=0.0, high=1.0)
        levels.append(Level(float(middle), float(ends[0]), float(ends[1]), share))
    return tuple(sorted(levels, key=lambda level: level.im))


@dataclass(frozen=True, slots=True, eq=False)
class Isotonic:
    """The isotonic (non-decreasing) share at the levels, and its 95 % band.

    Parameters
    ----------
    u : ndarray, shape (levels,)
        Coordinates of the levels in which they are drawn, increasing: the intensity, or a peak's logarithm.
    share, low, high : ndarray, shape (levels,)
        Share that falls and the ends of its interval; none of them falls.
    """

    u: NDArray[np.float64]
    share: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    @classmethod
    def of(cls, measure: IntensityMeasure, levels: tuple[Level, ...]) -> Isotonic:
        """Return the regression of the observed shares."""
        observed = [(p.fell, p.runs, p.low, p.high) for p in (level.probability for level in levels)]
        fell, runs, low, high = np.array(observed, np.float64).T
        share = pooled(fell, runs)
        for value in np.unique(share):
            together = share == value
            low[together], high[together] = low[together].min(), high[together].max()
        return cls(
            measure.coordinate([level.im for level in levels]),
            share,
            np.maximum.accumulate(low),
            np.minimum.accumulate(high[::-1])[::-1],
        )

    def jumps(self, place: int) -> bool:
        """Whether the share jumps on the way to a level from the one below."""
        return bool(self.share[place] - self.share[place - 1] > _JUMP)

    def at(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the share at coordinates; NaN outside the levels."""
        return np.interp(u, self.u, self.share, math.nan, math.nan)

    def band(self, u: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the ends of the band at coordinates; NaN outside the levels."""
        low, high = np.full(u.shape, math.nan), np.full(u.shape, math.nan)
        for place in range(1, len(self.u)):
            inside = (u >= self.u[place - 1]) & (u <= self.u[place])
            part = (u[inside] - self.u[place - 1]) / (self.u[place] - self.u[place - 1])
            for end, values, wider in ((low, self.low, np.floor), (high, self.high, np.ceil)):
                z = self._seen(values, place)
                if z is None:
                    end[inside] = np.where(wider(part) < 1.0, *values[place - 1 : place + 1])
                else:
                    end[inside] = ndtr(z[0] + part * (z[1] - z[0]))
        return low, high

    def _seen(self, end: NDArray[np.float64], place: int) -> NDArray[np.float64] | None:
        """Return Φ⁻¹ of an end of the band at two levels; None where no line joins them."""
        z = ndtri(end[place - 1 : place + 1])
        return None if self.jumps(place) or not np.isfinite(z).all() else z

    def crossing(self, share: float) -> float:
        """Return the coordinate at which a share is reached; ±∞ beyond the levels, NaN within a jump."""
        place = int(np.searchsorted(self.share, share))
        if place == 0:
            return float(self.u[0]) if self.share[0] == share else -math.inf
        if place == len(self.u):
            return math.inf
        if self.share[place] == share:
            return float(self.u[place])
        if self.jumps(place):
            return math.nan
        return float(np.interp(share, self.share, self.u))

    def interval(self, share: float) -> tuple[float, float]:
        """Return the coordinates between which the band holds a share; ±∞ beyond the levels."""
        first = int(np.searchsorted(self.high, share))
        last = int(np.searchsorted(self.low, share))
        return (
            -math.inf if first == 0 else self._edge(self.high, first, share, 0.0),
            math.inf if last == len(self.u) else self._edge(self.low, last, share, 1.0),
        )

    def _edge(self, end: NDArray[np.float64], place: int, share: float, unseen: float) -> float:
        """Return where an end of the band reaches a share, on the way to a level from the one below.

        ``unseen`` is the part of that way at which it does where it is not drawn straight.
        """
        if place == 0 or place == len(self.u):
            return float(self.u[min(place, len(self.u) - 1)])
        z = self._seen(end, place)
        part = unseen if z is None else float((ndtri(share) - z[0]) / (z[1] - z[0]))
        return float(self.u[place - 1] + part * (self.u[place] - self.u[place - 1]))


def pooled(fell: NDArray[np.float64], runs: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rising shares nearest to counted ones: neighbours that do not rise are put together.

    Examples
    --------
    >>> pooled(np.array([0.0, 4.0, 2.0, 10.0]), np.full(4, 10.0)).tolist()
    [0.0, 0.3, 0.3, 1.0]
    """
    from scipy.optimize import isotonic_regression  # takes its time to load

    rising: Any = isotonic_regression(fell / runs, weights=runs)
    ends: NDArray[np.intp] = rising.blocks
    # of the whole numbers, so that blocks of the same share have the same bits
    return np.repeat(np.add.reduceat(fell, ends[:-1]) / np.add.reduceat(runs, ends[:-1]), np.diff(ends))
