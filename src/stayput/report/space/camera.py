"""The camera of the frames in space: where points lie in the picture."""

from __future__ import annotations

import math
from copy import copy
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.report.space.shape import cut

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

Outline: TypeAlias = list[tuple[float, float]]
"""Corners in a picture, right and down [pixels]."""

_AZIMUTH, _HEIGHT = -1.02, 0.33  # direction from which the scene is seen, as on the page [rad]
_TANGENT = math.tan(math.radians(14.0))  # of half the angle of the picture's height
_MARGIN = 1.13
_NEAREST = 0.2  # nothing nearer than this is seen, in the distance of the nearest point


class Camera:
    """A camera that sees all of some points.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        The points [m].
    width, height : int
        Size of the picture [pixels].
    """

    def __init__(self, points: NDArray[np.float64], width: int, height: int) -> None:
        self._half = 0.5 * np.array([width, height])
        c, s = math.cos(_AZIMUTH), math.sin(_AZIMUTH)
        back = np.array([c * math.cos(_HEIGHT), s * math.cos(_HEIGHT), math.sin(_HEIGHT)])
        right = np.array([-s, c, 0.0])
        self._axes = np.array([right, np.cross(back, right), back])
        # The planes through the points that bound the picture meet in the eye: see `orbit` of camera.js.
        along = points @ self._axes.T
        tangents = _TANGENT * np.array([width / height, 1.0])
        above = (along[:, :2] + tangents * along[:, 2:]).max(axis=0)
        below = (-along[:, :2] + tangents * along[:, 2:]).max(axis=0)
        nearest = along[:, 2].max()
        far = _MARGIN * (((above + below) / (2.0 * tangents)).max() - nearest)
        self._place = np.array([*(above - below) / 2.0, nearest + far])
        self._nearest = _NEAREST * far
        self._focus = self._half[1] / _TANGENT

    def moved(self, way: NDArray[np.float64]) -> Camera:
        """Return the camera moved, shape (3,) [m]."""
        other = copy(self)
        other._place = self._place + self._axes @ way
        return other

    @property
    def place(self) -> NDArray[np.float64]:
        """Where it stands, shape (3,) [m]."""
        return self._place @ self._axes

    def seen(self, points: NDArray[np.float64]) -> Outline:
        """Return where the corners of a convex polygon or the ends of a line lie in the picture [pixels].

        Right and down; what is behind the camera, or nearly so, is cut off.
        """
        return self.outlines(points, [range(len(points))])[0]

    def outlines(self, points: NDArray[np.float64], parts: Sequence[Sequence[int]]) -> list[Outline]:
        """Return the same of several polygons or lines, whose corners are given by their numbers."""
        apart = points @ self._axes.T - self._place
        inside = -apart[:, 2] - self._nearest
        behind = inside < 0.0
        hidden = set(np.flatnonzero(behind).tolist())
        places = self._projected(np.where(behind[:, np.newaxis], [0.0, 0.0, -1.0], apart))
        return [
            [places[corner] for corner in part]
            if hidden.isdisjoint(part)
            else self._projected(cut(apart[list(part)], inside[list(part)]))
            for part in parts
        ]

    def _projected(self, apart: NDArray[np.float64]) -> Outline:
        """Return where points in front of the camera lie in the picture, from places along its axes."""
        across, up, back = apart.T
        scale = self._focus / -back
        right, down = self._half[0] + scale * across, self._half[1] - scale * up
        return list(zip(right.tolist(), down.tolist(), strict=True))
