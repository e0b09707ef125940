"""`Standing`: a body in space where it stands."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, numbers, within
from stayput.model.solid import Solid

if TYPE_CHECKING:
    from numpy.typing import NDArray


_VECTORS = ("at", 100.0, "m"), ("velocity", 100.0, "m/s"), ("rotation_rate", 1e3, "rad/s")
"""Fields of three numbers, the most of each, and their units."""


@dataclass(frozen=True, slots=True)
class Standing:
    """A body in a room.

    Parameters
    ----------
    solid : Solid
        The body.
    at : tuple of float
        Where the origin of its frame is: along x, across y, up z [m].
    heading : float
        By what it is turned about the vertical, from x towards y [rad].
    velocity, rotation_rate : tuple of float
        Of its centre of gravity [m/s], and of itself [rad/s], along x, y and z of the room, at first.

    Raises
    ------
    InputError
        A number out of range.
    """

    solid: Solid
    at: tuple[float, float, float] = (0.0, 0.0, 0.0)
    heading: float = 0.0
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation_rate: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        instance_of("solid", self.solid, Solid)
        for name, most, unit in _VECTORS:
            called = phrase(f"simulation.{name}")
            values = numbers(called, getattr(self, name), name)
            if values.shape != (3,):
                raise InputError("simulation.not_three", name, name=called, count=values.size)
            for value in values:
                within(called, value, -most, most, unit, name)
            object.__setattr__(self, name, tuple(values.tolist()))
        within("simulation.heading", self.heading, -2.0 * math.pi, 2.0 * math.pi, "rad", "heading")

    @property
    def turn(self) -> NDArray[np.float64]:
        """The rotation of its frame into the room's, shape (3, 3)."""
        cos, sin = math.cos(self.heading), math.sin(self.heading)
        return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])

    @property
    def depth(self) -> tuple[float, float]:
        """The least and the greatest x of its corners and round edges [m]."""
        corners = self.at[0] + self.solid.vertices @ self.turn[0]
        centres = self.at[0] + self.solid.rims[:, :3] @ self.turn[0]
        axes = self.solid.rims[:, 3:6] @ self.turn.T
        reach = self.solid.rims[:, 6] * np.hypot(axes[:, 1], axes[:, 2])
        ends = np.concatenate([corners, centres - reach, centres + reach])
        return float(ends.min()), float(ends.max())
