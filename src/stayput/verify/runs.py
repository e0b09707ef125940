"""The simulations of a verification, level by level."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.ensemble.columns import run_columns
from stayput.measures.results import failures_of
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.verify.draws import Rows
    from stayput.verify.hazard import Floors


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
    masses: NDArray[np.float64]

    @classmethod
    def joined(cls, parts: list[Runs]) -> Runs:
        """Join the samples of several calls."""
        if len(parts) == 1:
            return parts[0]
        return cls(*(np.concatenate([getattr(p, name) for p in parts], axis=1) for name in cls.__slots__))


def run_level(
    rows: Rows,
    floors: Floors,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> Runs:
    """Run one option at one level.

    Parameters
    ----------
    rows : Rows
        The option's cases.
    floors : Floors
        The motions.
    threads : int, optional
        As many as there are cores by default.
    progress : callable, optional
        Told how many runs are done.
    """
    cases, elements = rows.cases, rows.elements
    motions = len(floors.motions)
    samples = len(cases) // motions
    place = np.repeat(np.arange(motions), samples)
    scaled = cases.copy()
    scaled["scale"] = floors.scales[place]
    given = elements if elements.shape[1] else None
    results, devices = run_columns(scaled, given, floors.motions, place, threads=threads, progress=False)
    if progress is not None:
        progress(len(cases))
    shape = (motions, samples)
    failed = failures_of(devices, elements)[0] > 0 if given is not None else np.zeros(len(cases), bool)
    return Runs(
        overturned=(results["outcome"] == OVERTURNED_OUTCOME).reshape(shape),
        missing=(results["outcome"] == FAILED_OUTCOME).reshape(shape),
        hit_wall=(results["wall_impacts"] > 0).reshape(shape),
        device_failed=failed.reshape(shape),
        slide=results["peak_slide"].reshape(shape),
        tilt=results["peak_tilt"].reshape(shape),
        devices=devices.reshape((*shape, elements.shape[1])),
        masses=rows.masses.reshape(shape),
    )
