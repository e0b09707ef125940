"""`Placement`: where axes stand in a room in which pieces were run by themselves."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.model.floor_plan import FACING

WALLS_IN_TURN = tuple(sorted(FACING, key=lambda wall: FACING[wall] % (2.0 * math.pi)))
"""The walls in the order in which a quarter turn from x towards y takes each to the next."""


class Placement(NamedTuple):
    """Where the axes are in a room along which pieces were run: turned by quarter turns, then shifted.

    Quarter turns swap and negate coordinates, so no bit of a run changes with the wall at which it stands.

    Parameters
    ----------
    x, y : float
        Where the origin is [m].
    quarter_turns : int
        By how many quarter turns the axes are turned, from x towards y: 0 to 3.
    """

    x: float = 0.0
    y: float = 0.0
    quarter_turns: int = 0

    @classmethod
    def at(cls, x: float, y: float, heading: float) -> Placement:
        """Return the axes at a point whose x is nearest to a heading [rad]."""
        return cls(x, y, round(heading / (0.5 * math.pi)) % 4)

    @property
    def heading(self) -> float:
        """Where the x of the axes points [rad]."""
        return 0.5 * math.pi * self.quarter_turns

    def directions(self, vectors: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return vectors along the axes of the room, shape (..., 2) or (..., 3)."""
        return turned(vectors, self.quarter_turns)

    def points(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return points in the axes of the room [m], shape (..., 2) or (..., 3)."""
        placed = turned(points, self.quarter_turns)
        if self.x or self.y:
            placed = placed + np.array([self.x, self.y, 0.0][: placed.shape[-1]])
        return placed


ORIGIN = Placement()
"""Axes that are those of the room."""


def turned(vectors: NDArray[np.float64], quarter_turns: int) -> NDArray[np.float64]:
    """Return vectors turned from x towards y, shape (..., 2) or (..., 3); exact."""
    x, y = vectors[..., 0], vectors[..., 1]
    result = vectors.copy()
    match quarter_turns % 4:
        case 1:
            result[..., 0], result[..., 1] = -y, x
        case 2:
            result[..., 0], result[..., 1] = -x, -y
        case 3:
            result[..., 0], result[..., 1] = y, -x
        case _:
            pass
    return result


def wall_after(name: str, quarter_turns: int) -> str:
    """Return the wall at which one is after quarter turns of the room."""
    return WALLS_IN_TURN[(WALLS_IN_TURN.index(name) + quarter_turns) % 4]
