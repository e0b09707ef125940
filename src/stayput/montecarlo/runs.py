"""Simulating Monte Carlo samples in the plane, also to find from which level on each draw falls."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.measures.element import failed, utilisation
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.mechanics.runner import no_elements
from stayput.montecarlo.counting import Members, Outcomes
from stayput.simulation.many import run_columns

if TYPE_CHECKING:
    from stayput.montecarlo.sampling import Rows
    from stayput.montecarlo.scaled_motions import FloorMotions


@dataclass(frozen=True, slots=True, eq=False)
class Runs(Outcomes):
    """Outcomes of one piece or several with one option, and of their devices.

    Parameters
    ----------
    devices : ndarray of DEVICE, shape (runs, elements)
        Peaks and failure of each device, per unit mass.
    used : ndarray, shape (runs, elements)
        Utilisation of each device: its largest peak force over its strength.
    masses : ndarray, shape (runs,)
        By what forces are multiplied: the mass of the body [kg], or 1 where they are in newtons.
    results : ndarray of RESULT, shape (runs, bodies)
        What became of each piece; of those that count together any overturned or hit a wall, and slide and
        tilt are the largest of theirs.
    hits, blocked, shut_in : ndarray
        What happened in a room by run, to nobody and no door where it has no plan; see
        `stayput.montecarlo.scenes.RoomEvents`.
    tracks : ndarray of Track, shape (runs, bodies)
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

    @property
    def outcomes(self) -> Outcomes:
        """The outcomes alone."""
        return Outcomes(*(getattr(self, field.name) for field in fields(Outcomes)))

    def of_bodies(self) -> Iterator[Outcomes]:
        """Yield the outcomes of each of the pieces."""
        for results in np.moveaxis(self.results, -1, 0):
            yield Outcomes.of(self.members, results, self.device_failed)


def run_level(
    rows: Sequence[Rows],
    floors: FloorMotions,
    members: Members | None = None,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> list[Runs]:
    """Run several pieces or sets of measures together, so that all threads are busy.

    Parameters
    ----------
    rows : sequence of Rows
        The cases of each, all with the same members.
    floors : FloorMotions
        The motions.
    members : Members, optional
        The runs; by default the draws of one motion after those of the other, as many of each.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : callable, optional
        Called with the number of runs just done; an exception that it raises stops the work.
    """
    count = len(rows[0].cases)
    made = Members.of_samples(floors.each, count // floors.each) if members is None else members
    cases, elements = joined_rows(rows)
    motion = np.tile(floors.place(made), len(rows))
    results, devices = _ran(cases, elements, motion, floors, threads, progress)
    broken = failed(elements, devices).sum(axis=-1) > 0
    parts = (slice(first, first + count) for first in range(0, len(cases), count))
    return [
        _runs(piece_rows, made, results[part], devices[part], broken[part])
        for piece_rows, part in zip(rows, parts, strict=True)
    ]


def _ran(
    cases: NDArray[np.void],
    elements: NDArray[np.void],
    motion: NDArray[np.intp],
    floors: FloorMotions,
    threads: int | None,
    progress: Callable[[int], None] | None,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases, each under the motion of its number."""
    cases["scale"] = floors.scales[motion]
    return run_columns(cases, elements, floors.motions, motion, threads=threads, on_progress=progress)


def joined_rows(rows: Sequence[Rows]) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Return the cases of several pieces, and their devices."""
    cases = np.concatenate([piece_rows.cases for piece_rows in rows])
    # all sets of measures as one column, padded with elements that do nothing
    elements = no_elements(max(piece_rows.elements.shape[1] for piece_rows in rows), len(cases))
    start = 0
    for piece_rows in rows:
        stop = start + len(piece_rows.cases)
        elements[start:stop, : piece_rows.elements.shape[1]] = piece_rows.elements
        start = stop
    return cases, elements


def _runs(
    rows: Rows,
    members: Members,
    results: NDArray[np.void],
    devices: NDArray[np.void],
    broken: NDArray[np.bool_],
) -> Runs:
    count, nothing = rows.elements.shape[1], np.zeros((len(members), 0), np.bool_)
    without_free_slide(results, rows.free_slide)
    outcomes = Outcomes.of(members, results, broken)
    return Runs(
        **{field.name: getattr(outcomes, field.name) for field in fields(Outcomes)},
        devices=devices[:, :count],
        used=utilisation(rows.elements, devices[:, :count]),
        masses=rows.masses,
        results=results[:, np.newaxis],
        hits=np.zeros((len(members), 0, 1, 4)),
        blocked=nothing,
        shut_in=nothing,
        tracks=nothing.astype(object),
    )


def without_free_slide(results: NDArray[np.void], free_slide: ArrayLike) -> None:
    """Take off the slides of results how far measures are made to let the pieces slide [m]."""
    results["peak_slide"] = np.maximum(results["peak_slide"] - free_slide, 0.0)


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
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> list[Falls]:
    """Find from which level on each draw of several pieces falls in the plane.

    A draw that stands at one level is taken to stand at all weaker ones, and one that falls to fall at all
    stronger ones. Rocking is not monotonic in the intensity, so that this is no theorem but a rule, which is
    wrong both ways about equally often.

    Parameters
    ----------
    rows : sequence of Rows
        The cases of each.
    levels : ndarray, shape (levels,)
        JMA intensities of the ground, increasing; at least one.
    floors_at : callable
        Returns the motions at a level; called as it is needed.
    threads, progress
        As for `run_level`.
    """
    motions = len(floors_at(float(levels[-1])).motions)
    cases, elements = joined_rows(rows)
    motion = np.tile(np.repeat(np.arange(motions), len(rows[0].cases) // motions), len(rows))
    number = np.arange(len(levels))[:, np.newaxis]
    missing = np.zeros((len(levels), len(cases)), np.bool_)
    # the strongest level at which a draw is known to stand, and the weakest at which to fall
    low, high = np.full(len(cases), -1), np.full(len(cases), len(levels))
    while (high - low > 1).any():
        middle = (low + high) // 2
        for place in np.unique(middle[high - low > 1]).tolist():
            chosen = np.flatnonzero((high - low > 1) & (middle == place))
            floors = floors_at(float(levels[place]))
            results, _ = _ran(cases[chosen], elements[chosen], motion[chosen], floors, threads, progress)
            fell, lost = (results["outcome"] == which for which in (OVERTURNED_OUTCOME, FAILED_OUTCOME))
            # of a run that is given up nothing is known at the levels that are still open
            missing[:, chosen] |= lost & (low[chosen] < number) & (number < high[chosen])
            low[chosen] = np.where(lost, high[chosen] - 1, np.where(fell, low[chosen], place))
            high[chosen[fell]] = place
    shape = len(levels), len(rows), motions, -1
    each = (np.moveaxis(flags.reshape(shape), 1, 0) for flags in (number >= high, missing))
    return [Falls(*of_piece) for of_piece in zip(*each, strict=True)]
