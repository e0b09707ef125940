"""Histories of bodies in space that pictures show beside those of `SpaceRun`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.simulation.space import SpaceRun


def slid(run: SpaceRun) -> NDArray[np.float64]:
    """Return how far from where it stood each body is in plan, shape (bodies, samples) [m]."""
    slide = run.slide
    return np.hypot(slide[..., 0], slide[..., 1])


def yaw(run: SpaceRun) -> NDArray[np.float64]:
    """Return by how much each body has turned about the vertical, shape (bodies, samples) [rad].

    It is the twist of the turn from the first attitude when that is split into a twist about the vertical
    and the shortest tilt; whole turns count.
    """
    w, x, y, z = np.moveaxis(run.attitude, -1, 0)
    a, b, c, d = (part[:, :1] for part in (w, -x, -y, -z))
    return np.unwrap(2.0 * np.arctan2(w * d + x * c - y * b + z * a, w * a - x * b - y * c - z * d))


def at_time(time: float, run: SpaceRun, history: NDArray[np.float64]) -> float:
    """Return the value of a history, shape (samples,), at a time [s]."""
    return float(np.interp(time, run.time, history))
