"""Bodies in space under one motion: assemblies of solids, and a piece of furniture with measures."""

from __future__ import annotations

import math
from dataclasses import fields, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputError, within
from stayput.measures.measure import element_rows, hold
from stayput.measures.results import device_results
from stayput.mechanics.columns import RESULT
from stayput.motion.units import GRAVITY
from stayput.simulation.flat_fields import case_columns
from stayput.simulation.placing import bare, placed
from stayput.simulation.space_case import SpaceShaking, acceleration_of, result_of, trace_case
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
    from stayput.simulation.placing import Placed
    from stayput.simulation.space_engine import SpaceTrace
    from stayput.simulation.standing import Assembly, Joint, Standing

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
    shaking = SpaceShaking(acceleration_of(motion), motion.dt)
    traced = trace_assembly(assembly, room, shaking, GRAVITY.check(gravity), checked_step(step))
    return run_of_assembly(traced, assembly.joints, room, motion)


class AssemblyTrace(NamedTuple):
    """Several bodies as the engine ran them: bodies, room, devices and joints, and what became of them."""

    bodies: tuple[Placed, ...]
    planes: NDArray[np.void]
    springs: NDArray[np.void]
    trace: SpaceTrace


def trace_assembly(
    assembly: Assembly,
    room: Room,
    shaking: SpaceShaking,
    gravity: float,
    step: float = STEP,
    strength: float = 1.0,
    friction: float = 1.0,
) -> AssemblyTrace:
    """Run the bodies of an assembly with their measures in place.

    Parameters
    ----------
    assembly : Assembly
        The bodies.
    room : Room
        Where they stand.
    shaking : SpaceShaking
        Of the floor.
    gravity, step : float
        g [m/s²], and the longest step [s].
    strength : float
        Factor on the strengths of all devices but joints.
    friction : float
        Factor on the friction of what measures put between a piece and the floor.

    Raises
    ------
    InputError
        Measures that cannot be put in place, or bodies that begin inside each other or the room.
    """
    stated = [bare(one) for one in assembly.members]
    planes = planes_in(stated, room)
    bodies = placed(assembly.members, room, wall_distances(stated, room), strength)
    standing = [one.standing for one in bodies]
    laws = [_laws_under(one, room.floor, friction) for one in bodies]
    world = world_of([one.solid for one in standing], laws, planes, assembly.friction)
    poses = np.stack(
        [pose_of(one.solid, one.turn, one.place, one.velocity, one.rotation_rate) for one in standing]
    )
    springs = np.concatenate([*(one.springs for one in bodies), joint_springs(standing, assembly.joints)])
    trace = run_world(world, poses, springs, shaking.acceleration, shaking.dt, step, gravity)
    return AssemblyTrace(bodies, planes, springs, trace)


def results_of(traced: AssemblyTrace, shaking: SpaceShaking) -> NDArray[np.void]:
    """Return what became of each body of an assembly: RESULT, shape (bodies,)."""
    bodies, planes, _, trace = traced
    time = shaking.dt * np.arange(len(shaking.acceleration), dtype=np.float64)
    each = [result_of(one.standing, planes, trace, time, body) for body, one in enumerate(bodies)]
    return np.array(each, RESULT)


def run_of_assembly(traced: AssemblyTrace, joints: Sequence[Joint], room: Room, motion: Motion) -> SpaceRun:
    """Return the run of an assembly, with the names of its devices and joints.

    Parameters
    ----------
    traced : AssemblyTrace
        What the engine returned.
    joints : sequence of Joint
        The joints.
    room, motion
        Where the bodies stood, and how the floor moved.
    """
    bodies, planes, springs, trace = traced
    devices: list[DeviceResult] = []
    first = 0
    for number, one in enumerate(bodies):
        own = slice(first, first + len(one.springs))
        if one.held is not None:
            found = device_results(
                one.held, springs[own], trace.devices[own], trace.forces[:, own], mass=1.0, member=number
            )
            devices += found
        first = own.stop
    between = slice(first, None)
    devices += joint_results(joints, springs[between], trace.devices[between], trace.forces[:, between])
    standing, held = tuple(one.standing for one in bodies), tuple(one.held for one in bodies)
    return _run(standing, room, motion, planes, trace, tuple(devices), held)


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
    devices = device_results(held, rows, trace.devices, trace.forces, held.body.mass)
    return _run((piece.standing,), held.room, motion, piece.planes, trace, devices, (held,))


def _run(
    standing: tuple[Standing, ...],
    room: Room,
    motion: Motion,
    planes: NDArray[np.void],
    trace: SpaceTrace,
    devices: tuple[DeviceResult, ...],
    held: tuple[Held | None, ...],
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


def _laws_under(body: Placed, floor: Floor, factor: float) -> FloorLaws:
    """Return the laws of the floor under a body: where a measure changes the friction, its feet have that."""
    if body.held is None:
        return _floor_laws(floor)
    own = body.held.room.floor
    changed = {
        name: factor * value
        for name, value in ((field.name, getattr(own, field.name)) for field in fields(own))
        if name.endswith("friction") and value is not None and value != getattr(floor, name)
    }
    laws = _floor_laws(replace(own, **changed))
    if not {"static_friction", "kinetic_friction"} & changed.keys():
        return laws
    friction = laws.edge_friction
    return laws._replace(back_friction=friction, front_friction=friction)


def wall_distances(standing: Sequence[Standing], room: Room) -> tuple[float, float]:
    """Return how far the walls at either end of x are from the origin [m], infinite for none.

    Their gaps are from what is outermost of all bodies.
    """
    back, front = zip(*(one.depth for one in standing), strict=True)
    behind, before = (
        math.inf if wall is None else reach + wall.gap
        for wall, reach in ((room.left_wall, -min(back)), (room.right_wall, max(front)))
    )
    return behind, before


def planes_in(standing: Sequence[Standing], room: Room) -> NDArray[np.void]:
    """Return the room; see `wall_distances`."""
    floor, above = room.floor, room.ceiling
    behind, before = (
        None if wall is None else RoomSurface(distance, wall.friction, wall.restitution)
        for wall, distance in zip(
            (room.left_wall, room.right_wall), wall_distances(standing, room), strict=True
        )
    )
    ceiling = None if above is None else RoomSurface(above.height, above.friction, above.restitution)
    return planes_of(
        (floor.static_friction, floor.kinetic_friction, floor.normal_restitution), behind, before, ceiling
    )
