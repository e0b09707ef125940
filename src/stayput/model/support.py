"""On which of its points a body stands, and which way it then points."""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def up_at_rest(
    points: NDArray[np.float64], centre_of_gravity: NDArray[np.float64], tolerance: float
) -> NDArray[np.float64] | None:
    """Return what points up in the body's frame while it rests on some of its points.

    It rests on a plane through at least three of them that has none below, when G lies above the inside of
    what these span in the plane. Of several such planes the one nearest to the frame's z is taken.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        The points that may touch the floor, in the body's frame [m]; at most some dozens unless all are as
        low.
    centre_of_gravity : ndarray, shape (3,)
        G in the same frame [m].
    tolerance : float
        How far from a plane a point may be that lies in it [m].

    Returns
    -------
    ndarray, shape (3,), or None
        Unit vector; None where the body rests on no such plane.
    """
    resting = [
        up
        for up in _normals(points, tolerance)
        if _surrounded(
            points[points @ up <= (points @ up).min() + tolerance], centre_of_gravity, up, tolerance
        )
    ]
    return max(resting, key=lambda up: up[2], default=None)


def _normals(points: NDArray[np.float64], tolerance: float) -> list[NDArray[np.float64]]:
    """Return the upward unit normals of the planes through three of the points that have no point below."""
    if np.ptp(points[:, 2]) <= tolerance:
        return [np.array([0.0, 0.0, 1.0])]
    normals: list[NDArray[np.float64]] = []
    for a, b, c in combinations(points, 3):
        normal = np.cross(b - a, c - a)
        length = float(np.linalg.norm(normal))
        if abs(normal[2]) <= tolerance * tolerance:  # upright, or three points in a line
            continue
        up = normal / math.copysign(length, normal[2])
        if (points @ up).min() >= a @ up - tolerance:
            normals.append(up)
    return normals


def _surrounded(
    contacts: NDArray[np.float64], point: NDArray[np.float64], up: NDArray[np.float64], tolerance: float
) -> bool:
    """Tell whether contacts in a plane lie around a point above it: no half of the directions is empty."""
    along = np.cross([0.0, 1.0, 0.0], up)
    along /= np.linalg.norm(along)
    across = np.cross(up, along)
    from_point = contacts - point
    x, y = from_point @ along, from_point @ across
    directions = np.sort(np.arctan2(y, x)[np.hypot(x, y) > tolerance])
    if len(directions) < 3:
        return False
    gaps = np.diff(directions, append=directions[0] + 2.0 * math.pi)
    return bool(gaps.max() < math.pi - 1e-9)
