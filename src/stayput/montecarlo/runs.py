"""Simulating Monte Carlo samples: over threads for a few pieces, on the calling thread for an inventory."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from stayput.measures.results import failures_of, utilisation
from stayput.mechanics.runner import no_elements
from stayput.montecarlo.counting import Outcomes
from stayput.simulation.many import run_columns, run_rows

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.montecarlo.hazard import FloorMotions, PreparedFloor
    from stayput.montecarlo.sampling import Rows


@dataclass(frozen=True, slots=True, eq=False)
class Runs(Outcomes):
    """Outcomes of the body and of its devices.

    Parameters
    ----------
    devices : ndarray of DEVICE, shape (motions, samples, elements)
        Peaks and failure of each device, per unit mass.
    used : ndarray, shape (motions, samples, elements)
        Utilisation of each device: its largest peak force over its strength.
    masses : ndarray, shape (motions, samples)
        Mass of the body [kg].
    """

    devices: NDArray[np.void]
    used: NDArray[np.float64]
    masses: NDArray[np.float64]


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
    cases["scale"] = floors.scales[motion]
    results, devices = run_columns(
        cases,
        elements,
        floors.motions,
        motion,
        dimensions=floors.dimensions,
        threads=threads,
        progress=False,
        on_progress=progress,
    )
    failed = failures_of(elements, devices).count > 0
    runs: list[Runs] = []
    start = 0
    for piece_rows in rows:
        part = slice(start, start + len(piece_rows.cases))
        runs.append(_runs(piece_rows, results[part], devices[part], failed[part], motions))
        start = part.stop
    return runs


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
    rows: Rows,
    results: NDArray[np.void],
    devices: NDArray[np.void],
    failed: NDArray[np.bool_],
    motions: int,
) -> Runs:
    shape = (motions, len(results) // motions)
    count = rows.elements.shape[1]
    used = utilisation(rows.elements, devices[:, :count])
    outcomes = Outcomes.of(results.reshape(shape), failed.reshape(shape))
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
    failed: list[NDArray[np.bool_]] = []
    for motion, shaking in enumerate(floor.shakings):
        motion_cases = np.ascontiguousarray(cases[:, motion]).ravel()
        motion_cases["scale"] = floor.scales[motion]
        motion_elements = np.ascontiguousarray(elements[:, motion]).reshape(len(motion_cases), -1)
        result, devices = run_rows(motion_cases, motion_elements, shaking)
        results.append(result.reshape(len(rows), -1))
        failed.append((failures_of(motion_elements, devices).count > 0).reshape(len(rows), -1))
    together, broken = np.stack(results, axis=1), np.stack(failed, axis=1)
    return [Outcomes.of(result, bad) for result, bad in zip(together, broken, strict=True)]
