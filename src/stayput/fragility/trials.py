"""Counted falls over a measure of intensity, of any layout, as a list of cells."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.fragility.probabilities import checked_runs

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from stayput.fragility.intensity_measures import IntensityMeasure


@dataclass(frozen=True, slots=True, eq=False)
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
        Motion of each cell, where the cells of a motion are alike; None where all runs are independent.
    missing : int
        Runs that were given up; they are in no cell.
    """

    measure: IntensityMeasure
    im: NDArray[np.float64]
    fell: NDArray[np.float64]
    runs: NDArray[np.float64]
    level: NDArray[np.intp]
    motion: NDArray[np.intp] | None = None
    missing: int = 0

    def __len__(self) -> int:
        return len(self.im)

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
        values = measure.checked(im)
        if values.shape not in (fell.shape[:1], fell.shape[:2]):
            raise InputError(
                f"The shape of the intensities is {values.shape}; with runs of shape {fell.shape} it must be "
                f"{fell.shape[:1]} or {fell.shape[:2]}."
            )
        if values.ndim == 1:
            values = np.repeat(values[:, np.newaxis], fell.shape[1], axis=1)
        level, motion = np.indices(values.shape)
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
        values, k, n = measure.checked(im), np.array(fell, np.float64), np.array(runs, np.float64)
        if not values.ndim == 1 <= len(values) or not values.shape == k.shape == n.shape:
            raise InputError(
                f"The shapes are {values.shape}, {k.shape}, {n.shape}; they must be lists of one length."
            )
        bad = ~((k >= 0.0) & (k <= n) & (k == np.rint(k)) & (n == np.rint(n)))
        if bad.any():
            raise InputError(
                f"A level has {k[bad][0]:g} falls of {n[bad][0]:g} runs; it must have whole numbers, no more "
                "falls than runs."
            )
        return cls._of_cells(measure, values, k, n, np.arange(len(values)), None)

    @classmethod
    def from_rows(
        cls,
        measure: IntensityMeasure,
        im: ArrayLike,
        fallen: ArrayLike,
        motion: Sequence[object] | None = None,
        *,
        groups: int = 10,
    ) -> Trials:
        """Take one row a run.

        Parameters
        ----------
        measure : IntensityMeasure
            What ``im`` is.
        im : array_like, shape (runs,)
            Intensity of each run [SI].
        fallen : array_like of bool, shape (runs,)
            Whether it fell.
        motion : sequence, length (runs,), optional
            What names the motion of each run; without it all runs are independent.
        groups : int
            Groups of about equal size in which the observed fractions are shown, where there are more
            different intensities.

        Raises
        ------
        InputError
            Arrays of other shapes, or intensities that cannot be.
        """
        fell, _ = checked_runs(fallen, None, 1)
        values = measure.checked(im)
        if values.shape != fell.shape or (motion is not None and len(motion) != len(fell)):
            raise InputError(f"There are {len(fell)} runs; there must be an intensity and a motion for each.")
        different, place = np.unique(values, return_inverse=True)
        if len(different) > groups:
            place = (np.argsort(np.argsort(values, kind="stable"), kind="stable") * groups) // len(values)
        names = None
        if motion is not None:
            numbers: dict[object, int] = {}
            names = np.array([numbers.setdefault(name, len(numbers)) for name in motion], np.intp)
        return cls._of_cells(measure, values, fell, np.ones(len(fell)), place, names)

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
            raise InputError("All runs were given up or there are none; a curve needs at least one run.")
        names = None
        if motion is not None:
            different, names = np.unique(motion[used], return_inverse=True)
            names = names.astype(np.intp) if len(different) > 1 else None
        return cls(
            measure,
            im[used],
            fell[used].astype(np.float64),
            runs[used].astype(np.float64),
            level[used].astype(np.intp),
            names,
            missing,
        )
