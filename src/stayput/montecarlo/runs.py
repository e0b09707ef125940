"""Simulating Monte Carlo samples: at one level of shaking, and at many for fragility curves.

At many levels the runs whose outcome others tell are not made: a draw that stands at one level is taken to
stand at all weaker ones, and one that falls to fall at all stronger ones, so that a search finds where it
begins to. Rocking is not monotonic in the intensity, so this is no theorem but a rule; it is wrong both ways
about equally often. `benchmarks/verification.py` counts that, and the manual has the table.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.measures.element import failed, utilisation
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.mechanics.runner import no_elements
from stayput.montecarlo.counting import Outcomes
from stayput.simulation.many import run_columns, run_rows

if TYPE_CHECKING:
    from stayput.montecarlo.sampling import Rows
    from stayput.montecarlo.scaled_motions import FloorMotions, PreparedFloor


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
    results : ndarray of RESULT, shape (motions, samples, bodies)
        What became of each piece; of those that count together any overturned or hit a wall, and slide and
        tilt are the largest of theirs.
    hits, blocked, shut_in : ndarray
        What happened in a room by motion and sample, to nobody and no door where it has no plan; see
        `stayput.montecarlo.scenes.Seen`.
    tracks : ndarray of Track, shape (motions, samples, bodies)
        Where each piece was; of no body where that was not kept.
    """

    devices: NDArray[np.void]
    used: NDArray[np.float64]
    masses: NDArray[np.float64]
    results: NDArray[np.void]
    hits: NDArray[np.float64]
    blocked: NDArray[np.bool_]
    shut_in: NDArray[np.bool_]
    tracks: NDArray[np.object_]

    def of_bodies(self) -> Iterator[Outcomes]:
        """Yield the outcomes of each of the pieces."""
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
    # all sets of measures as one column, padded with elements that do nothing
    elements = no_elements(max(piece_rows.elements.shape[1] for piece_rows in rows), len(cases))
    start = 0
    for piece_rows in rows:
        stop = start + len(piece_rows.cases)
        elements[start:stop, : piece_rows.elements.shape[1]] = piece_rows.elements
        start = stop
    motion = [np.repeat(np.arange(motions), len(piece_rows.cases) // motions) for piece_rows in rows]
    return cases, elements, np.concatenate(motion)


def _runs(
    rows: Rows, results: NDArray[np.void], devices: NDArray[np.void], broken: NDArray[np.bool_], motions: int
) -> Runs:
    shape = (motions, len(results) // motions)
    count, nothing = rows.elements.shape[1], np.zeros((*shape, 0), np.bool_)
    used = utilisation(rows.elements, devices[:, :count])
    without_free_slide(results, rows.free_slide)
    outcomes = Outcomes.of(results.reshape(shape), broken.reshape(shape))
    return Runs(
        **{field.name: getattr(outcomes, field.name) for field in fields(Outcomes)},
        devices=devices[:, :count].reshape((*shape, count)),
        used=used.reshape((*shape, count)),
        masses=rows.masses.reshape(shape),
        results=results.reshape((*shape, 1)),
        hits=np.zeros((*shape, 0, 1, 4)),
        blocked=nothing,
        shut_in=nothing,
        tracks=nothing.astype(object),
    )


def without_free_slide(results: NDArray[np.void], free_slide: ArrayLike) -> None:
    """Take off the slides of results how far measures are made to let the pieces slide [m]."""
    results["peak_slide"] = np.maximum(results["peak_slide"] - free_slide, 0.0)


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
    of_pieces = np.stack(results, axis=1)
    without_free_slide(of_pieces, np.array([piece_rows.free_slide for piece_rows in rows])[:, None, None])
    return [Outcomes.of(*each) for each in zip(of_pieces, np.stack(broken, axis=1), strict=True)]


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


Known: TypeAlias = "tuple[NDArray[np.float64], Outcomes]"
"""JMA intensities of the ground at another shaking, shape (motions,), and what became of the runs there."""


def run_levels(
    rows: Sequence[Rows],
    levels: NDArray[np.float64],
    floors_at: Callable[[float], FloorMotions],
    *,
    known: Sequence[Known] = (),
    every_run: bool = False,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> tuple[list[Falls], int]:
    """Run several pieces or sets of measures in the plane at many levels.

    Parameters
    ----------
    rows : sequence of Rows
        The cases of each.
    levels, known, every_run, progress
        As for `settled_levels`, which returns the same.
    floors_at : callable
        Returns the motions at a level; called as it is needed.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    """
    motions = len(floors_at(float(levels[-1])).motions)
    cases, elements, motion = joined_rows(rows, motions)
    shape = (len(rows), motions, len(cases) // (len(rows) * motions))

    def run(level: float, wanted: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        chosen = np.flatnonzero(wanted)
        results, _ = _ran(
            cases[chosen], elements[chosen], motion[chosen], floors_at(level), threads, progress
        )
        outcomes = np.zeros(len(cases), np.int64)
        outcomes[chosen] = results["outcome"]
        outcomes = outcomes.reshape(shape)
        return outcomes == OVERTURNED_OUTCOME, outcomes == FAILED_OUTCOME

    return settled_levels(shape, levels, run, known=known, every_run=every_run, progress=progress)


def settled_levels(
    shape: tuple[int, int, int],
    levels: NDArray[np.float64],
    run: Callable[[float, NDArray[np.bool_]], tuple[NDArray[np.bool_], NDArray[np.bool_]]],
    *,
    known: Sequence[Known] = (),
    every_run: bool = False,
    progress: Callable[[int], None] | None = None,
) -> tuple[list[Falls], int]:
    """Find from which level on each draw falls; the levels beside that are settled without a run.

    Parameters
    ----------
    shape : tuple of int
        Pieces or options, motions, and samples of each.
    levels : ndarray, shape (levels,)
        JMA intensities of the ground, increasing; at least one.
    run : callable
        Runs some draws (bool, of the shape) at a level; returns of all what overturned and what was given up.
    known : sequence of Known, optional
        What became of each at another shaking.
    every_run : bool
        Whether all runs are made, those too whose outcome others tell.
    progress : callable, optional
        Called with the number of runs just settled; an exception that it raises stops the work.

    Returns
    -------
    tuple
        The falls of each, and how many runs were made for them.
    """
    number = np.arange(len(levels)).reshape(-1, 1, 1, 1)
    missing = np.zeros((len(levels), *shape), np.bool_)
    made = settled = 0

    def ran(place: int, chosen: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        nonlocal made
        made += int(chosen.sum())
        fell, lost = run(float(levels[place]), chosen)
        return chosen & fell & ~lost, chosen & lost

    def falls(overturned: NDArray[np.bool_]) -> list[Falls]:
        return [Falls(overturned[:, option], missing[:, option]) for option in range(shape[0])]

    if every_run:
        overturned = np.zeros_like(missing)
        for place in range(len(levels)):
            overturned[place], missing[place] = ran(place, np.ones(shape, np.bool_))
        return falls(overturned), made
    # the strongest level at which a draw is known to stand, and the weakest at which to fall
    low, high, step = np.full(shape, -1), np.full(shape, len(levels)), 1
    for option, (intensities, outcomes) in enumerate(known):
        below, above = (
            np.searchsorted(levels, intensities, side)[:, np.newaxis] for side in ("right", "left")
        )
        low[option] = np.where(~outcomes.overturned & ~outcomes.missing, below - 1, -1)
        high[option] = np.where(outcomes.overturned & ~outcomes.missing, above, len(levels))
    while True:
        open_levels = np.maximum(high - low - 1, 0)
        more = missing.size - int(open_levels.sum()) - made - settled
        if progress is not None and more:
            progress(more)
        settled += more
        if not open_levels.any():
            return falls(number >= high), made
        middle = (low + high) // 2
        if known:  # most draws change near the shaking that is known: one level from there, then two, four
            rises, sinks = (low >= 0) & (high == len(levels)), (low < 0) & (high < len(levels))
            middle = np.where(rises, np.minimum(low + step, len(levels) - 1), middle)
            middle = np.where(sinks, np.maximum(high - step, 0), middle)
            step *= 2
        for place in np.unique(middle[open_levels > 0]).tolist():
            chosen = (open_levels > 0) & (middle == place)
            fell, lost = ran(place, chosen)
            # of a run that is given up nothing is known at the levels that are still open
            missing |= lost & (low < number) & (number < high)
            low = np.where(lost, high - 1, np.where(chosen & ~fell, place, low))
            high = np.where(fell, place, high)
