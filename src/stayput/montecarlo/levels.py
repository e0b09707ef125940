"""Falls at many levels of shaking, for fragility curves, without the runs whose outcome stronger ones tell.

From the strongest level downwards: pieces that stayed far from falling at two levels stand at all weaker ones.
Rocking is not monotonic in the intensity, so this is no theorem; it was measured how often it fails
(`benchmarks/verification.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.measures.results import failures_of
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.montecarlo.runs import joined_rows
from stayput.simulation.columns import run_columns

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.montecarlo.hazard import FloorMotions
    from stayput.montecarlo.sampling import Rows

CALM_TILT = 0.3
"""A calm run tilts less than this part of the angle at which the piece overturns."""

CALM_SLIDE = 0.5
"""A calm run slides less than this part of the width of the base: what slides far meets other motion, or a wall."""

GROUP = 8
"""Fewest runs that are judged together: those of one motion or, of few samples, of several motions."""

APART = 0.14
"""Least difference of two levels at which all of a group must be calm; the usual levels are 0.15 apart [JMA]."""


@dataclass(frozen=True, slots=True, eq=False)
class Falls:
    """Falls of a piece with one set of measures at several levels.

    Parameters
    ----------
    overturned, missing : ndarray of bool, shape (levels, motions, samples)
        Whether it overturned; whether the run was given up.
    """

    overturned: NDArray[np.bool_]
    missing: NDArray[np.bool_]


def run_levels(
    rows: Sequence[Rows],
    levels: NDArray[np.float64],
    floors: Sequence[FloorMotions],
    *,
    every_run: bool = False,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> tuple[list[Falls], int]:
    """Run several pieces or sets of measures at many levels, or settle from stronger ones that they stand.

    Parameters
    ----------
    rows : sequence of Rows
        The cases of each.
    levels : ndarray, shape (levels,)
        JMA intensities of the ground, increasing.
    floors : sequence of FloorMotions
        The motions of each level.
    every_run : bool
        Whether all runs are made, those too whose outcome stronger ones tell.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : callable, optional
        Called with the number of runs just made or settled; an exception that it raises stops the work.

    Returns
    -------
    tuple
        The falls of each, and how many runs were made for them.
    """
    motions = len(floors[0].motions)
    cases, elements, motion = joined_rows(rows, motions)
    shape = (len(rows), motions, len(cases) // (len(rows) * motions))
    samples = shape[2]
    overturned = np.zeros((len(levels), len(cases)), np.bool_)
    missing = np.zeros_like(overturned)
    starts = np.zeros(0, np.intp) if every_run else group_starts(motions, samples)
    unsettled = np.ones(shape[:2], np.bool_)
    calm_from = np.full(shape[:2], -np.inf)  # the strongest level from which on downwards all were calm
    made = 0
    for number in reversed(range(len(levels))):
        chosen = np.flatnonzero(np.repeat(unsettled, samples))
        if not len(chosen):
            break
        made += len(chosen)
        floor, chosen_cases = floors[number], cases[chosen]
        chosen_cases["scale"] = floor.scales[motion[chosen]]
        results, devices = run_columns(
            chosen_cases,
            elements[chosen],
            floor.motions,
            motion[chosen],
            threads=threads,
            progress=False,
            on_progress=progress,
        )
        overturned[number, chosen] = results["outcome"] == OVERTURNED_OUTCOME
        missing[number, chosen] = results["outcome"] == FAILED_OUTCOME
        if not len(starts):
            continue
        calm = np.zeros(len(cases), np.bool_)
        calm[chosen] = calm_runs(chosen_cases, results, failures_of(elements[chosen], devices).count > 0)
        by_group = np.logical_and.reduceat(calm.reshape(shape).all(axis=2), starts, axis=1)
        together = np.repeat(by_group, np.diff(starts, append=motions), axis=1)
        calm_from = np.where(together, np.maximum(calm_from, levels[number]), -np.inf)
        settled = unsettled & (calm_from - levels[number] >= APART)
        unsettled &= ~settled
        if progress is not None and settled.any():
            progress(int(settled.sum()) * samples * number)
    of_each = (len(levels), *shape)
    by_piece = zip(*(np.moveaxis(flags.reshape(of_each), 1, 0) for flags in (overturned, missing)), strict=True)
    return [Falls(fell, given_up) for fell, given_up in by_piece], made


def group_starts(motions: int, samples: int) -> NDArray[np.intp]:
    """Return the first motion of each group of motions with at least `GROUP` runs; none where all are fewer."""
    each = -(-GROUP // samples)
    return each * np.arange(motions // each)


def calm_runs(
    cases: NDArray[np.void], results: NDArray[np.void], device_failed: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """Return which runs stayed far from a fall: little tilt, little slide, and all devices hold.

    Parameters
    ----------
    cases : ndarray of CASE, shape (n,)
        The cases.
    results : ndarray of RESULT, shape (n,)
        What became of them.
    device_failed : ndarray of bool, shape (n,)
        Whether a device failed.
    """
    u, v = cases["u"][:, :2], cases["v"][:, :2]  # the base corners from the centre of gravity
    overturning = np.arctan2(np.abs(u), -v).min(axis=1)
    return (
        (results["outcome"] != OVERTURNED_OUTCOME)
        & (results["outcome"] != FAILED_OUTCOME)
        & (results["peak_tilt"] < CALM_TILT * overturning)
        & (results["peak_slide"] < CALM_SLIDE * (u[:, 1] - u[:, 0]))
        & ~device_failed
    )
