"""Counts of falls over an intensity measure, and the observed shares of groups of about one intensity."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, not_allowed, numbers
from stayput.fragility.intensity_measures import IntensityMeasure
from stayput.fragility.probabilities import Probability, checked_runs, probability_of_counts


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Trials:
    """Runs and falls, counted in cells; made by one of the methods below.

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
    (Trials(PGA, 14 of 60 fell), 3)
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
        return f"Trials({self.measure.key}, {fell} of {runs} fell)"

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
            Intensity of the levels, or of each motion at each level [SI].
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
        of_runs = np.broadcast_to(values.reshape(len(values), -1, 1), fell.shape)
        motion = np.indices(fell.shape)[1].ravel()
        return cls.of_runs(
            measure, of_runs.ravel(), fell.ravel(), given_up.ravel(), motion, groups=len(values)
        )

    @classmethod
    def of_runs(
        cls,
        measure: IntensityMeasure,
        im: NDArray[np.float64],
        fell: NDArray[np.bool_],
        missing: NDArray[np.bool_],
        motion: NDArray[np.intp],
        groups: int,
    ) -> Trials:
        """Take runs one by one.

        Parameters
        ----------
        measure : IntensityMeasure
            What ``im`` is.
        im : ndarray, shape (runs,)
            Intensity of each run [SI].
        fell, missing : ndarray of bool, shape (runs,)
            Whether it fell; whether the run was given up.
        motion : ndarray of int, shape (runs,)
            The number of each run's motion.
        groups : int
            Groups of about equal size for which shares are observed; runs of one intensity are in one group
            where there are no more intensities.
        """
        # of one level up to rounding; motions of one level differ in other measures
        values, level = np.unique(measure.coordinate(im).round(9), return_inverse=True)
        level = level if len(values) <= groups else _groups(im, groups)
        return cls._of_cells(measure, im, fell & ~missing, ~missing, level, motion, int(missing.sum()))

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
        bad = ~((k >= 0.0) & (k <= n) & (n < np.inf) & (k == np.rint(k)) & (n == np.rint(n)))
        if bad.any():
            raise InputError("fragility.bad_counts", fell=k[bad][0], runs=n[bad][0])
        return cls._of_cells(measure, values, k, n, np.arange(len(values)), None)

    @classmethod
    def _of_cells(
        cls,
        measure: IntensityMeasure,
        im: NDArray[np.float64],
        fell: NDArray[np.number | np.bool_],
        runs: NDArray[np.number | np.bool_],
        level: NDArray[np.integer],
        motion: NDArray[np.integer] | None,
        missing: int = 0,
    ) -> Trials:
        used = runs.astype(np.float64) > 0.0
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
