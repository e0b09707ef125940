"""The simulations of a verification, level by level."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.ensemble.columns import run_columns
from stayput.measures.results import failures_of, utilisation
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.mechanics.restrained.runner import no_elements

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.verification.draws import Rows
    from stayput.verification.hazard import Floors


@dataclass(frozen=True, slots=True, eq=False)
class Runs:
    """What became of one option at one level, over motions and samples.

    Parameters
    ----------
    overturned, missing, hit_wall, device_failed : ndarray of bool, shape (motions, samples)
        Whether it turned over; whether the run was given up; whether it hit a wall; whether a device failed.
    slide, tilt : ndarray, shape (motions, samples)
        Peak slide [m] and tilt [rad].
    devices : ndarray of DEVICE, shape (motions, samples, elements)
        What became of each device, per unit mass.
    used : ndarray, shape (motions, samples, elements)
        Utilisation of each device: its largest peak force over its strength.
    masses : ndarray, shape (motions, samples)
        Mass of the body [kg].
    """

    overturned: NDArray[np.bool_]
    missing: NDArray[np.bool_]
    hit_wall: NDArray[np.bool_]
    device_failed: NDArray[np.bool_]
    slide: NDArray[np.float64]
    tilt: NDArray[np.float64]
    devices: NDArray[np.void]
    used: NDArray[np.float64]
    masses: NDArray[np.float64]

    @classmethod
    def joined(cls, parts: list[Runs]) -> Runs:
        """Join the samples of several calls."""
        if len(parts) == 1:
            return parts[0]
        return cls(*(np.concatenate([getattr(p, name) for p in parts], axis=1) for name in cls.__slots__))


def run_level(
    options: list[Rows],
    floors: Floors,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> list[Runs]:
    """Run all options at one level, in one go: their pieces of work fill the threads together.

    Parameters
    ----------
    options : list of Rows
        The cases of each option.
    floors : Floors
        The motions.
    threads : int, optional
        As many as there are cores by default.
    progress : callable, optional
        Told how many more runs are done; what it raises stops the work.
    """
    motions = len(floors.motions)
    cases = np.concatenate([rows.cases for rows in options])
    elements = _side_by_side([rows.elements for rows in options])
    place = np.concatenate([np.repeat(np.arange(motions), len(rows.cases) // motions) for rows in options])
    cases["scale"] = floors.scales[place]
    results, devices = run_columns(
        cases, elements, floors.motions, place, threads=threads, progress=False, told=progress
    )
    failed = failures_of(elements, devices).count > 0
    found: list[Runs] = []
    start = 0
    for rows in options:
        mine = slice(start, start + len(rows.cases))
        found.append(_runs(rows, results[mine], devices[mine], failed[mine], motions))
        start = mine.stop
    return found


def _side_by_side(rows: list[NDArray[np.void]]) -> NDArray[np.void]:
    """Return the elements of all options as one column, filled up with none."""
    most = max(row.shape[1] for row in rows)
    joined = no_elements(most, sum(len(row) for row in rows))
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
    return Runs(
        overturned=(results["outcome"] == OVERTURNED_OUTCOME).reshape(shape),
        missing=(results["outcome"] == FAILED_OUTCOME).reshape(shape),
        hit_wall=(results["wall_impacts"] > 0).reshape(shape),
        device_failed=failed.reshape(shape),
        slide=results["peak_slide"].reshape(shape),
        tilt=results["peak_tilt"].reshape(shape),
        devices=devices[:, :count].reshape((*shape, count)),
        used=used.reshape((*shape, count)),
        masses=rows.masses.reshape(shape),
    )
