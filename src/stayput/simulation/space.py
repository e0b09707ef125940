"""Bodies in space under one motion of the floor: `simulate_in_space` and its result."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, numbers, within
from stayput.mechanics.space.columns import SPRING
from stayput.model.room import FRICTION_RANGE, Floor, Room
from stayput.model.solid import Solid
from stayput.motion import Motion
from stayput.motion.units import GRAVITY, STANDARD_GRAVITY
from stayput.simulation.space_case import lies
from stayput.simulation.space_engine import STEP, run_world
from stayput.simulation.space_records import (
    FloorLaws,
    RoomSurface,
    frames_of,
    matrices,
    planes_of,
    pose_of,
    world_of,
)
from stayput.simulation.standing import Standing

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class SpaceRun:
    """What bodies in space did, in axes that move with the floor.

    Parameters
    ----------
    standing : tuple of Standing
        The bodies, as they stood at first.
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
            touching = np.flatnonzero(lies(one.solid, self.place[number], self.turn[number]))
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
    if room.floor.settlement:
        raise InputError("simulation.settles", "room.floor.settlement", value=room.floor.settlement)
    longest = within("simulation.step", step, 1e-6, 0.01, "s", "step")
    laws = [_floor_laws(room.floor)] * len(standing)
    world = world_of(
        [one.solid for one in standing], laws, _planes(standing, room), _checked_friction(friction)
    )
    count = len(motion.x)
    acceleration = np.zeros((count, 3))
    for axis, name in enumerate("xyz"):
        if name in motion.components:
            acceleration[:, axis] = getattr(motion, name)
    poses = np.stack([_pose(one) for one in standing])
    trace = run_world(
        world, poses, np.zeros(0, SPRING), acceleration, motion.dt, longest, GRAVITY.check(gravity)
    )
    return SpaceRun(
        standing,
        motion.dt * np.arange(count, dtype=np.float64),
        trace.place,
        frames_of(standing, trace.attitude),
        trace.velocity,
        trace.rotation_rate,
        trace.steps,
        trace.unconverged,
    )


def _pose(one: Standing) -> NDArray[np.void]:
    place = np.asarray(one.at) + one.turn @ one.solid.centre_of_gravity
    return pose_of(one.solid, one.turn, place, one.velocity, one.rotation_rate)


def _floor_laws(floor: Floor) -> FloorLaws:
    def own(side: str) -> tuple[float, float]:
        static, kinetic = (getattr(floor, f"{side}_edge_{kind}_friction") for kind in ("static", "kinetic"))
        return math.nan if static is None else static, math.nan if kinetic is None else kinetic

    return FloorLaws(floor.restitution, floor.landing_place, floor.edge_friction, own("left"), own("right"))


def _planes(standing: Sequence[Standing], room: Room) -> NDArray[np.void]:
    """Return the room; the gaps of its walls are from what is outermost of all bodies."""
    back, front = zip(*(one.depth for one in standing), strict=True)
    floor, above = room.floor, room.ceiling
    behind, before = (
        None if wall is None else RoomSurface(reach + wall.gap, wall.friction, wall.restitution)
        for wall, reach in ((room.left_wall, -min(back)), (room.right_wall, max(front)))
    )
    ceiling = None if above is None else RoomSurface(above.height, above.friction, above.restitution)
    return planes_of(
        (floor.static_friction, floor.kinetic_friction, floor.normal_restitution), behind, before, ceiling
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
