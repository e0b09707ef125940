"""Bodies in space under one motion of the floor: `simulate_in_space` and its result."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, numbers, within
from stayput.mechanics.space.columns import HISTORY, POSE
from stayput.mechanics.space.engine import run_in_space
from stayput.model.room import FRICTION_RANGE, Floor, Room
from stayput.model.solid import Solid
from stayput.motion import Motion
from stayput.motion.units import GRAVITY, STANDARD_GRAVITY
from stayput.simulation.space_records import (
    frames_of,
    initial_pose,
    matrices,
    refuse_overlaps,
    scratch_of,
    world_of,
)
from stayput.simulation.standing import Standing

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    import xarray as xr
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

STEP = 5e-4
"""Longest step [s]."""

ON_THE_FLOOR = 1e-4
"""Height up to which a point lies on the floor [m]."""

_ONLY_IN_THE_PLANE = (
    "edge_static_friction",
    "edge_kinetic_friction",
    "left_edge_static_friction",
    "left_edge_kinetic_friction",
    "right_edge_static_friction",
    "right_edge_kinetic_friction",
    "restitution",
    "landing_place",
    "settlement",
)
"""Fields of a floor that only the engine in the plane knows."""


@dataclass(frozen=True, slots=True, eq=False)
class SpaceRun:
    """What bodies in space did, in axes that move with the floor.

    Parameters
    ----------
    standing : tuple of Standing
        The bodies, as they stood at first.
    room : Room
        Where they stood.
    motion : Motion
        How the floor moved.
    time : ndarray, shape (samples,)
        Time [s].
    place : ndarray, shape (bodies, samples, 3)
        Of the centres of gravity [m].
    attitude : ndarray, shape (bodies, samples, 4)
        Unit quaternions w, x, y, z that turn the bodies' frames into the room's.
    velocity, rotation_rate : ndarray, shape (bodies, samples, 3)
        Of the centres of gravity [m/s], and of the bodies [rad/s], in the room's axes.
    steps : int
        Steps of the engine.
    unconverged : int
        Steps whose contact forces did not converge; a few where contacts jam.
    """

    standing: tuple[Standing, ...]
    room: Room
    motion: Motion
    time: NDArray[np.float64]
    place: NDArray[np.float64]
    attitude: NDArray[np.float64]
    velocity: NDArray[np.float64]
    rotation_rate: NDArray[np.float64]
    steps: int
    unconverged: int

    @property
    def turn(self) -> NDArray[np.float64]:
        """Rotations of the bodies' frames into the room's, shape (bodies, samples, 3, 3)."""
        return matrices(self.attitude)

    @property
    def tilt(self) -> NDArray[np.float64]:
        """Angles between the bodies' vertical axes and the vertical, shape (bodies, samples) [rad]."""
        up = self.turn[..., :, 2]
        return np.arctan2(np.hypot(up[..., 0], up[..., 1]), up[..., 2])

    @property
    def slide(self) -> NDArray[np.float64]:
        """Ways of the origins of the bodies' frames in plan, shape (bodies, samples, 2) [m]."""
        offset = np.array([one.solid.centre_of_gravity for one in self.standing])
        origin = self.place - np.einsum("bsij,bj->bsi", self.turn, offset)
        return (origin - origin[:, :1])[..., :2]

    @property
    def overturned(self) -> NDArray[np.bool_]:
        """Whether each body came to touch the floor with more than its base, shape (bodies,)."""
        return np.isfinite(self.overturn_time)

    @property
    def overturn_time(self) -> NDArray[np.float64]:
        """When each body first touched the floor with more than its base, shape (bodies,) [s]; else nan."""
        found = np.full(len(self.standing), math.nan)
        for number, one in enumerate(self.standing):
            vertices = one.solid.vertices
            above = vertices[vertices[:, 2] > vertices[:, 2].min() + 0.1 * np.ptp(vertices[:, 2])]
            arms = above - one.solid.centre_of_gravity
            heights = self.place[number, :, 2, np.newaxis] + self.turn[number, :, 2] @ arms.T
            touching = np.flatnonzero(heights.min(axis=1) <= ON_THE_FLOOR)
            if len(touching):
                found[number] = self.time[touching[0]]
        return found

    def to_dataset(self) -> xr.Dataset:
        """Return the histories as a dataset over ``body``, ``time`` and components."""
        import xarray as xr

        about = {"long_name": "time", "units": "s"}
        return xr.Dataset(
            {
                "place": (("body", "time", "axis"), self.place, {"units": "m"}),
                "attitude": (("body", "time", "part"), self.attitude, {"long_name": "unit quaternion"}),
                "velocity": (("body", "time", "axis"), self.velocity, {"units": "m/s"}),
                "rotation_rate": (("body", "time", "axis"), self.rotation_rate, {"units": "rad/s"}),
                "tilt": (("body", "time"), self.tilt, {"units": "rad"}),
            },
            {"time": ("time", self.time, about), "axis": list("xyz"), "part": list("wxyz")},
        )

    def plot(
        self, path: str | Path | None = None, *, names: Sequence[str] | None = None, language: str = "en"
    ) -> Figure:
        """Draw the histories and the ways in plan; see `stayput.report.space.plot.plot_space_run`."""
        from stayput.report.space.plot import plot_space_run

        return plot_space_run(self, path, names=names, language=language)

    def animate(self, path: str | Path, *, names: Sequence[str] | None = None, language: str = "en") -> Path:
        """Write an animation (GIF, MP4 or HTML); see `stayput.report.space.animation.animate_space_run`."""
        from stayput.report.space.animation import animate_space_run

        return animate_space_run(self, path, names=names, language=language)


def simulate_in_space(
    bodies: Solid | Standing | Sequence[Standing],
    room: Room,
    motion: Motion,
    *,
    friction: tuple[float, float] = (0.4, 0.3),
    step: float = STEP,
    gravity: float = STANDARD_GRAVITY,
) -> SpaceRun:
    """Simulate bodies in space under one motion of the floor.

    Parameters
    ----------
    bodies : Solid, Standing, or a sequence of them
        What stands in the room, not inside each other, the floor or the ceiling.
    room : Room
        Floor, walls at either end of x, their gaps from the outermost corners, and ceiling. The floor's
        friction and normal restitution hold; its other laws belong to the engine in the plane.
    motion : Motion
        Acceleration of the floor: x, and y and z where it has them.
    friction : tuple of float
        Static and kinetic coefficients of friction between bodies.
    step : float
        Longest step [s], 1e-6 to 0.01.
    gravity : float
        Acceleration of gravity g [m/s²].

    Returns
    -------
    SpaceRun
        Histories of places and attitudes.

    Raises
    ------
    InputError
        Input that is refused, in one sentence.

    Examples
    --------
    >>> from stayput import Motion, Room, Solid
    >>> still = Motion(dt=0.01, x=[0.0] * 100, y=[0.0] * 100)
    >>> run = simulate_in_space(Solid.box(0.4, 0.9, 1.8, 100.0), Room(), still)
    >>> float(abs(run.slide).max()), float(run.tilt.max())
    (0.0, 0.0)
    """
    if isinstance(bodies, Solid):
        bodies = (Standing(bodies),)
    elif isinstance(bodies, Standing):
        bodies = (bodies,)
    standing = list_of("bodies", bodies, Standing)
    if not standing:
        raise InputError("simulation.no_bodies", "bodies")
    instance_of("room", room, Room)
    instance_of("motion", motion, Motion)
    _refuse_laws_of_the_plane(room.floor)
    longest = within("simulation.step", step, 1e-6, 0.01, "s", "step")
    world = world_of(standing, room, _checked_friction(friction))
    count = len(motion.x)
    acceleration = np.zeros((count, 3))
    for axis, name in enumerate("xyz"):
        if name in motion.components:
            acceleration[:, axis] = getattr(motion, name)
    poses = np.zeros((2, len(standing)), POSE)
    for b, one in enumerate(standing):
        poses[0, b] = initial_pose(one)
    histories = np.zeros((len(standing), count, len(HISTORY)))
    times = np.array([motion.dt, longest, GRAVITY.check(gravity)])
    scratch, work = scratch_of(world), np.zeros(2)
    run_in_space(world, poses, acceleration[:1], times, scratch, histories, work)  # notes gaps, takes no step
    refuse_overlaps(world, scratch[2][0])
    run_in_space(world, poses, acceleration, times, scratch, histories, work)
    return SpaceRun(
        standing,
        room,
        motion,
        motion.dt * np.arange(count, dtype=np.float64),
        histories[..., 0:3],
        frames_of(standing, histories[..., 3:7]),
        histories[..., 7:10],
        histories[..., 10:13],
        int(work[0]),
        int(work[1]),
    )


def _checked_friction(friction: object) -> tuple[float, float]:
    """Return the coefficients of friction between bodies, or raise `InputError`."""
    called = phrase("simulation.friction")
    values = numbers(called, friction, "friction")
    if values.shape != (2,):
        raise InputError("simulation.not_two", "friction", count=values.size)
    static, kinetic = (within(called, value, *FRICTION_RANGE, "", "friction") for value in values)
    if kinetic > static:
        raise InputError("simulation.kinetic_above_static", "friction", kinetic=kinetic, static=static)
    return static, kinetic


def _refuse_laws_of_the_plane(floor: Floor) -> None:
    """Raise `InputError` where a floor has a law that only the engine in the plane knows."""
    usual = Floor()
    for name in _ONLY_IN_THE_PLANE:
        if getattr(floor, name) != getattr(usual, name):
            raise InputError(
                "simulation.only_in_the_plane", f"room.floor.{name}", name=name, value=getattr(floor, name)
            )
