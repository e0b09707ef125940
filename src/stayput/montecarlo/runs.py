"""Simulating Monte Carlo samples: at one level of shaking, and at many for fragility curves.

At many levels the runs whose outcome others tell are not made. From the strongest level downwards: what
stayed far from falling at two levels stands at all weaker ones. Rocking is not monotonic in the intensity, so
this is no theorem but a rule with margins. None of 1,425,920 runs of drawn scenarios was settled wrongly, one
without the limit on devices; `benchmarks/verification.py` counts that, for other margins too, and the manual
has the table. There is no such rule upwards, from levels at which all fall: what falls at one level often
stands at a stronger one, and is run quickly in any case.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from stayput.measures.element import failed, utilisation
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.mechanics.runner import no_elements
from stayput.montecarlo.counting import Outcomes
from stayput.simulation.many import run_columns, run_rows

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from numpy.typing import NDArray

    from stayput.montecarlo.hazard import FloorMotions, PreparedFloor
    from stayput.montecarlo.sampling import Rows
    from stayput.simulation.piece import Piece


@dataclass(frozen=True, slots=True, eq=False)
class Runs(Outcomes):
    """Outcomes of one piece or several with one option, and of their devices.

    Parameters
    ----------
    devices : ndarray of DEVICE, shape (motions, samples, elements)
        Peaks and failure of each device, per unit mass.
    used : ndarray, shape (motions, samples, elements)
        Utilisation of each device: its largest peak force over its strength.
    masses : ndarray, shape (motions, samples)
        By what forces are multiplied: the mass of the body [kg], or 1 where they are in newtons.
    results : ndarray of RESULT, shape (motions, samples, bodies), optional
        What became of each of several pieces; of those that count together any overturned or hit a wall, and
        slide and tilt are the largest of theirs.
    hits, blocked, shut_in : ndarray, optional
        What happened in a room with a plan, by motion and sample; see `stayput.montecarlo.scenes.Seen`.
    tracks : ndarray of Track, shape (motions, samples, bodies), optional
        Where each piece was, where that was kept.
    """

    devices: NDArray[np.void]
    used: NDArray[np.float64]
    masses: NDArray[np.float64]
    results: NDArray[np.void] | None = None
    hits: NDArray[np.float64] | None = None
    blocked: NDArray[np.bool_] | None = None
    shut_in: NDArray[np.bool_] | None = None
    tracks: NDArray[np.object_] | None = None

    def of_bodies(self) -> Iterator[Outcomes]:
        """Yield the outcomes of each of the pieces."""
        if self.results is None:
            yield self
            return
        for results in np.moveaxis(self.results, -1, 0):
            yield Outcomes.of(results, self.device_failed)


def run_level(
    rows: Sequence[Rows],
    floors: FloorMotions,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> list[Runs]:
    """Run several pieces or sets of measures at one level together, so that all threads are busy.

    Parameters
    ----------
    rows : sequence of Rows
        The cases of each.
    floors : FloorMotions
        The motions.
    threads : int, optional
        As many as there are cores by default.
    progress : callable, optional
        Called with the number of runs just done; an exception that it raises stops the work.
    """
    motions = len(floors.motions)
    cases, elements, motion = joined_rows(rows, motions)
    results, devices = _ran(cases, elements, motion, floors, threads, progress)
    broken = failed(elements, devices).sum(axis=-1) > 0
    runs: list[Runs] = []
    start = 0
    for piece_rows in rows:
        part = slice(start, start + len(piece_rows.cases))
        runs.append(_runs(piece_rows, results[part], devices[part], broken[part], motions))
        start = part.stop
    return runs


def _ran(
    cases: NDArray[np.void],
    elements: NDArray[np.void],
    motion: NDArray[np.int64],
    floors: FloorMotions,
    threads: int | None,
    progress: Callable[[int], None] | None,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases under the motions of a level, each under that of its number."""
    cases["scale"] = floors.scales[motion]
    return run_columns(cases, elements, floors.motions, motion, threads=threads, on_progress=progress)


def joined_rows(
    rows: Sequence[Rows], motions: int
) -> tuple[NDArray[np.void], NDArray[np.void], NDArray[np.int64]]:
    """Return the cases of several pieces, their devices and the number of each one's motion."""
    cases = np.concatenate([piece_rows.cases for piece_rows in rows])
    elements = _side_by_side([piece_rows.elements for piece_rows in rows])
    motion = [np.repeat(np.arange(motions), len(piece_rows.cases) // motions) for piece_rows in rows]
    return cases, elements, np.concatenate(motion)


def _side_by_side(rows: list[NDArray[np.void]]) -> NDArray[np.void]:
    """Return the elements of all sets of measures as one column, padded with elements that do nothing."""
    joined = no_elements(max(row.shape[1] for row in rows), sum(len(row) for row in rows))
    start = 0
    for row in rows:
        joined[start : start + len(row), : row.shape[1]] = row
        start += len(row)
    return joined


def _runs(
    rows: Rows, results: NDArray[np.void], devices: NDArray[np.void], broken: NDArray[np.bool_], motions: int
) -> Runs:
    shape = (motions, len(results) // motions)
    count = rows.elements.shape[1]
    used = utilisation(rows.elements, devices[:, :count])
    outcomes = Outcomes.of(results.reshape(shape), broken.reshape(shape))
    return Runs(
        **{field.name: getattr(outcomes, field.name) for field in fields(Outcomes)},
        devices=devices[:, :count].reshape((*shape, count)),
        used=used.reshape((*shape, count)),
        masses=rows.masses.reshape(shape),
    )


def run_prepared(rows: Sequence[Rows], floor: PreparedFloor) -> list[Outcomes]:
    """Run several pieces with the same number of devices on this thread.

    Parameters
    ----------
    rows : sequence of Rows
        The cases of each piece; at least one.
    floor : PreparedFloor
        The motions.
    """
    motions = len(floor.shakings)
    shape = (motions, len(rows[0].cases) // motions)
    cases = np.stack([piece_rows.cases.reshape(shape) for piece_rows in rows])
    elements = np.stack([piece_rows.elements.reshape((*shape, -1)) for piece_rows in rows])
    results: list[NDArray[np.void]] = []
    broken: list[NDArray[np.bool_]] = []
    for motion, shaking in enumerate(floor.shakings):
        motion_cases = np.ascontiguousarray(cases[:, motion]).ravel()
        motion_cases["scale"] = floor.scales[motion]
        motion_elements = np.ascontiguousarray(elements[:, motion]).reshape(len(motion_cases), -1)
        result, devices = run_rows(motion_cases, motion_elements, shaking)
        results.append(result.reshape(len(rows), -1))
        broken.append((failed(motion_elements, devices).sum(axis=-1) > 0).reshape(len(rows), -1))
    together = zip(np.stack(results, axis=1), np.stack(broken, axis=1), strict=True)
    return [Outcomes.of(result, bad) for result, bad in together]


CALM_TILT = 0.3
"""A calm run tilts less than this part of the angle at which the piece overturns."""

CALM_SLIDE = 0.3
"""A calm run slides less than this part of the width of the base: what slides far may meet a wall."""

CALM_USE = 0.9
"""The devices of a calm run bear less than this part of their strength, so that none fails."""

GROUP = 8
"""Fewest runs that are judged together: those of one motion or, of few samples, of several motions."""

APART = 0.14
"""Least difference of the two levels at which all of a group are calm [JMA]; the usual are 0.15 apart."""


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
    floors_at: Callable[[float], FloorMotions],
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
    levels, floors_at, every_run, progress
        As for `settled_levels`, which returns the same.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    """
    motions = len(floors_at(float(levels[-1])).motions)
    cases, elements, motion = joined_rows(rows, motions)
    shape = (len(rows), motions, len(cases) // (len(rows) * motions))

    def run(floors: FloorMotions, unsettled: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], ...]:
        chosen = np.flatnonzero(np.repeat(unsettled, shape[2]))
        results, devices = _ran(cases[chosen], elements[chosen], motion[chosen], floors, threads, progress)
        used = utilisation(elements[chosen], devices).max(axis=-1, initial=0.0)
        flags = np.zeros((3, len(cases)), np.bool_)
        flags[0, chosen] = results["outcome"] == OVERTURNED_OUTCOME
        flags[1, chosen] = results["outcome"] == FAILED_OUTCOME
        flags[2, chosen] = calm_runs(cases[chosen], results, used)
        return tuple(flags.reshape(3, *shape))

    return settled_levels(shape, levels, floors_at, run, every_run=every_run, progress=progress)


def settled_levels(
    shape: tuple[int, int, int],
    levels: NDArray[np.float64],
    floors_at: Callable[[float], FloorMotions],
    run: Callable[[FloorMotions, NDArray[np.bool_]], tuple[NDArray[np.bool_], ...]],
    *,
    every_run: bool = False,
    progress: Callable[[int], None] | None = None,
) -> tuple[list[Falls], int]:
    """Run at many levels, the strongest first, but what stronger ones settle: that it stands.

    Parameters
    ----------
    shape : tuple of int
        Pieces or options, motions, and samples of each.
    levels : ndarray, shape (levels,)
        JMA intensities of the ground, increasing; at least one.
    floors_at : callable
        Returns the motions at a level; called as it is needed.
    run : callable
        Runs those motions of each option that are not settled (bool, options × motions) under the motions of
        a level; returns of all runs what overturned, what was given up, and what was calm.
    every_run : bool
        Whether all runs are made, those too whose outcome stronger ones tell.
    progress : callable, optional
        Called with the number of runs just settled; an exception that it raises stops the work.

    Returns
    -------
    tuple
        The falls of each, and how many runs were made for them.
    """
    _, motions, samples = shape
    overturned = np.zeros((len(levels), *shape), np.bool_)
    missing = np.zeros_like(overturned)
    starts = np.zeros(0, np.intp) if every_run else group_starts(motions, samples)
    unsettled = np.ones(shape[:2], np.bool_)
    calm_from = np.full(shape[:2], -np.inf)  # the strongest level from which on downwards all were calm
    made = 0
    for number in reversed(range(len(levels))):
        if not unsettled.any():
            break
        made += int(unsettled.sum()) * samples
        floors = floors_at(float(levels[number]))
        overturned[number], missing[number], calm = run(floors, unsettled)
        if not len(starts):
            continue
        by_group = np.logical_and.reduceat(calm.all(axis=2), starts, axis=1)
        together = np.repeat(by_group, np.diff(starts, append=motions), axis=1)
        calm_from = np.where(together, np.maximum(calm_from, levels[number]), -np.inf)
        settled = unsettled & (calm_from - levels[number] >= APART)
        unsettled &= ~settled
        if progress is not None and settled.any():
            progress(int(settled.sum()) * samples * number)
    return [Falls(overturned[:, option], missing[:, option]) for option in range(shape[0])], made


def group_starts(motions: int, samples: int) -> NDArray[np.intp]:
    """Return the first motion of each group of at least `GROUP` runs; none where there are not so many."""
    each = -(-GROUP // samples)
    return each * np.arange(motions // each)


def calm_runs(
    cases: NDArray[np.void], results: NDArray[np.void], used: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Return which runs stayed far from a fall: with little tilt and slide, and devices that hold easily.

    Parameters
    ----------
    cases : ndarray of CASE, shape (n,)
        The cases.
    results : ndarray of RESULT, shape (n,)
        What became of them.
    used : ndarray, shape (n,)
        Largest utilisation of their devices; 0 without devices.
    """
    left, right = cases["u"][:, :2].T
    return (
        (results["outcome"] != OVERTURNED_OUTCOME)
        & (results["outcome"] != FAILED_OUTCOME)
        & (results["peak_tilt"] < CALM_TILT * overturning_tilts(cases))
        & (results["peak_slide"] < CALM_SLIDE * (right - left))
        & (used < CALM_USE)
    )


def calm_scenes(runs: Runs, pieces: Sequence[Piece]) -> NDArray[np.bool_]:
    """Return which runs of a scene stayed far from a fall in the same sense, shape (motions, samples)."""
    assert runs.results is not None
    calm = ~runs.missing & (runs.used < CALM_USE).all(axis=-1)
    for piece, results in zip(pieces, np.moveaxis(runs.results, -1, 0), strict=True):
        base = piece.solid.base_points[:, :2] - piece.solid.centre_of_gravity[:2]
        nearest = float(np.minimum(-base.min(axis=0), base.max(axis=0)).min())
        critical = math.atan2(nearest, float(piece.solid.centre_of_gravity[2]))
        calm &= results["outcome"] != OVERTURNED_OUTCOME
        calm &= results["peak_tilt"] < CALM_TILT * critical
        calm &= results["peak_slide"] < CALM_SLIDE * float(np.ptp(base, axis=0).min())
    return calm


def overturning_tilts(cases: NDArray[np.void]) -> NDArray[np.float64]:
    """Return the tilts at which pieces overturn by their weight, to the side where it is less [rad]."""
    left, right = cases["u"][:, :2].T
    return np.arctan2(np.minimum(-left, right), -cases["v"][:, 0])
