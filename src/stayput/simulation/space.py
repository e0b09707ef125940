"""Bodies in space under one motion: assemblies of solids, and a piece of furniture with measures."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, within
from stayput.measures.measure import element_rows, hold
from stayput.measures.results import device_results
from stayput.motion.units import GRAVITY
from stayput.simulation.flat_fields import case_columns
from stayput.simulation.space_case import SpaceShaking, acceleration_of, trace_case
from stayput.simulation.space_devices import joint_results, joint_springs
from stayput.simulation.space_engine import STEP, run_world
from stayput.simulation.space_records import (
    FloorLaws,
    RoomSurface,
    frames_of,
    planes_of,
    pose_of,
    world_of,
)
from stayput.simulation.space_run import Hit, SpaceRun

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.measures.measure import Held, Measure
    from stayput.measures.results import DeviceResult
    from stayput.model.body import Body
    from stayput.model.room import Floor, Room
    from stayput.model.state import State
    from stayput.motion import Motion
    from stayput.simulation.space_engine import SpaceTrace
    from stayput.simulation.standing import Assembly, Standing

SURFACES = ("floor", "left_wall", "right_wall", "ceiling")


def checked_step(step: float | None) -> float:
    """Return a longest step [s], or raise `InputError`."""
    return STEP if step is None else within("simulation.step", step, 1e-6, 0.01, "s", "step")


def simulate_assembly(
    assembly: Assembly, room: Room, motion: Motion, gravity: float, step: float | None = None
) -> SpaceRun:
    """Simulate solids in space; see `stayput.simulate`.

    The gaps of the walls are from the outermost corners of all bodies. The floor's settlement is a law of
    pieces of furniture, and is refused.
    """
    if room.floor.settlement:
        raise InputError("simulation.settles", "room.floor.settlement", value=room.floor.settlement)
    standing = assembly.members
    planes = planes_in(standing, room)
    laws = [_floor_laws(room.floor)] * len(standing)
    world = world_of([one.solid for one in standing], laws, planes, assembly.friction)
    poses = np.stack(
        [pose_of(one.solid, one.turn, one.place, one.velocity, one.rotation_rate) for one in standing]
    )
    springs = joint_springs(standing, assembly.joints)
    trace = run_world(
        world,
        poses,
        springs,
        acceleration_of(motion),
        motion.dt,
        checked_step(step),
        GRAVITY.check(gravity),
    )
    joints = joint_results(assembly.joints, springs, trace.devices, trace.forces)
    return _run(standing, room, motion, planes, trace, joints)


def simulate_piece(
    body: Body,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure],
    initial: State,
    gravity: float,
    step: float | None = None,
) -> SpaceRun:
    """Simulate a piece of furniture with measures in space; see `stayput.simulate`.

    Raises
    ------
    InputError
        A body without a length, or measures that cannot be put in place.
    """
    held = hold(body, room, measures, dimensions=3)
    return run_held(held, element_rows(held), motion, initial, gravity, checked_step(step))


def run_held(
    held: Held,
    rows: NDArray[np.void],
    motion: Motion,
    initial: State,
    gravity: float,
    step: float = STEP,
) -> SpaceRun:
    """Run a piece with measures in place.

    Parameters
    ----------
    held : Held
        The piece, of `hold` with three dimensions.
    rows : ndarray of ELEMENT, shape (n,)
        Its devices.
    motion, initial, gravity, step
        As for `stayput.simulate`.
    """
    case = case_columns(held.body, held.room, initial, gravity)[0]
    m = held.body.mass
    shaking = SpaceShaking(acceleration_of(motion), motion.dt)
    piece, trace = trace_case(case, rows, shaking, step, m)
    trace = trace._replace(pressing=m * trace.pressing)
    devices = device_results(held, rows, trace.devices, trace.forces)
    return _run((piece.standing,), held.room, motion, piece.planes, trace, devices, held)


def _run(
    standing: tuple[Standing, ...],
    room: Room,
    motion: Motion,
    planes: NDArray[np.void],
    trace: SpaceTrace,
    devices: tuple[DeviceResult, ...],
    held: Held | None = None,
) -> SpaceRun:
    present = [name for name in SURFACES if name == "floor" or getattr(room, name) is not None]
    hits = tuple(
        Hit(
            float(hit["time"]),
            int(hit["a"]),
            None if hit["b"] < 0 else int(hit["b"]),
            "" if hit["plane"] < 0 else present[int(hit["plane"])],
            float(hit["speed"]),
            float(hit["impulse"]),
        )
        for hit in trace.hits
    )
    return SpaceRun(
        standing,
        room,
        motion,
        planes,
        motion.dt * np.arange(len(motion.x), dtype=np.float64),
        trace.place,
        frames_of(standing, trace.attitude),
        trace.velocity,
        trace.rotation_rate,
        trace.pressing,
        hits,
        trace.hit_numbers[:-1],
        trace.peak_tilt,
        devices,
        trace.steps,
        trace.unconverged,
        held,
    )


def _floor_laws(floor: Floor) -> FloorLaws:
    def own(side: str) -> tuple[float, float]:
        static, kinetic = (getattr(floor, f"{side}_edge_{kind}_friction") for kind in ("static", "kinetic"))
        return math.nan if static is None else static, math.nan if kinetic is None else kinetic

    return FloorLaws(floor.restitution, floor.landing_place, floor.edge_friction, own("left"), own("right"))


def planes_in(standing: Sequence[Standing], room: Room) -> NDArray[np.void]:
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
