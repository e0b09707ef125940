"""A case in numbers: the initial state, and the columns that the mechanics read."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import within
from stayput.mechanics.columns import CASE
from stayput.room import Ceiling

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.body import Body
    from stayput.room import Room, Wall


@dataclass(frozen=True, slots=True)
class State:
    """Initial state of a body that stands on the floor.

    Parameters
    ----------
    tilt, tilt_rate : float
        Tilt from the position of rest, + to the right, and its rate [rad, rad/s]; the body turns about
        the corner on the side it tilts to.
    slide, slide_rate : float
        Displacement of that corner from its place at rest, and its rate [m, m/s].

    Raises
    ------
    InputError
        A value that is not finite, or a tilt of 90° and more.
    """

    tilt: float = 0.0
    tilt_rate: float = 0.0
    slide: float = 0.0
    slide_rate: float = 0.0

    def __post_init__(self) -> None:
        within("Initial tilt", self.tilt, -1.57, 1.57, "rad")
        within("Initial tilt rate", self.tilt_rate, -1e3, 1e3, "rad/s")
        within("Initial slide", self.slide, -1e3, 1e3, "m")
        within("Initial slide rate", self.slide_rate, -1e3, 1e3, "m/s")


def standing_corners(body: Body, start: State) -> tuple[tuple[float, float], ...]:
    """Places of the corners A, B, C, D in the room, for a body that stands on the floor [m]."""
    tilt = body.resting_tilt + start.tilt
    sin, cos = math.sin(tilt), math.cos(tilt)
    turned = [(u * cos + v * sin, v * cos - u * sin) for u, v in body.corners]
    (u_a, v_a), (u_b, v_b), _, _ = body.corners
    half = 0.5 * math.hypot(u_b - u_a, v_b - v_a)
    right = start.tilt > 0.0 or (start.tilt == 0.0 and start.tilt_rate > 0.0)
    foot = 1 if right else 0
    x = start.slide + (half if right else -half) - turned[foot][0]
    z = -turned[foot][1]
    return tuple((x + u, z + v) for u, v in turned)


def case_columns(body: Body, room: Room, start: State, gravity: float) -> NDArray[np.void]:
    """Return one row of `CASE`, shape [1]; the factor on the motion is 1."""
    row = np.zeros(1, CASE)
    corners = np.array(body.corners)
    row["inertia"] = body.inertia_about_cg / body.mass
    row["u"], row["v"] = corners[:, 0], corners[:, 1]
    row["gravity"], row["scale"] = gravity, 1.0
    floor = room.floor
    row["static_friction"], row["kinetic_friction"] = floor.static_friction, floor.kinetic_friction
    row["edge_static_friction"], row["edge_kinetic_friction"] = floor.edge_friction
    row["restitution"], row["normal_restitution"] = floor.restitution, floor.normal_restitution
    _surface(row, "right", room.right_wall)
    _surface(row, "left", room.left_wall)
    _surface(row, "ceiling", room.ceiling)
    row["tilt"], row["tilt_rate"] = start.tilt, start.tilt_rate
    row["slide"], row["slide_rate"] = start.slide, start.slide_rate
    return row


def _surface(row: NDArray[np.void], name: str, surface: Wall | Ceiling | None) -> None:
    """Fill in a wall or the ceiling; its distance is infinite where there is none."""
    row[f"{name}_distance"] = math.inf
    if surface is not None:
        row[f"{name}_distance"] = surface.height if isinstance(surface, Ceiling) else surface.gap
        row[f"{name}_restitution"], row[f"{name}_friction"] = surface.restitution, surface.friction
