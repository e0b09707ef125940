"""Histories of bodies in space that pictures show beside those of `SpaceRun`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.space_run import SpaceRun


def slid(run: SpaceRun) -> NDArray[np.float64]:
    """Return how far from where it stood each body is in plan, shape (bodies, samples) [m]."""
    slide = run.slide
    return np.hypot(slide[..., 0], slide[..., 1])


def peak_of(motion: Motion) -> float:
    """Return the largest acceleration of the floor, all components together [m/s²]."""
    return float(np.linalg.norm(list(motion.components.values()), axis=0).max())


def at_time(time: float, run: SpaceRun, history: NDArray[np.float64]) -> float:
    """Return the value of a history, shape (samples,), at a time [s]."""
    return float(np.interp(time, run.time, history))
