"""Bodies in space under one motion: assemblies of solids, and a piece of furniture with measures."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputWarning, warn, within
from stayput.measures.element import device_results
from stayput.model.parameters import GRAVITY
from stayput.model.room import friction_factor
from stayput.simulation.flat_fields import case_columns, room_row
from stayput.simulation.placing import joint_results, joint_springs, placed, planes_around
from stayput.simulation.space_case import SpaceShaking, acceleration_of, trace_case
from stayput.simulation.space_engine import STEP, run_world
from stayput.simulation.space_records import FloorLaws, frames_of, pose_of, surface_of, world_of
from stayput.simulation.space_run import Hit, SpaceRun
from stayput.simulation.standing import Standing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.measures.element import DeviceResult
    from stayput.measures.measure import Held
    from stayput.model.room import Room
    from stayput.model.state import State
    from stayput.motion import Motion
    from stayput.simulation.placing import Placed
    from stayput.simulation.space_engine import SpaceTrace
    from stayput.simulation.standing import Assembly, Joint

ON_FLOOR_WITHIN = 1e-6
"""Height up to which the lowest point of a body is on the floor [m]."""


def warn_of_settlement(assembly: Assembly, room: Room) -> None:
    """Warn where solids stand on a floor that settles: only pieces of furniture have the base for that."""
    solids = (one for one in assembly.members if isinstance(one, Standing))
    if room.floor.settlement and any(one.along((0.0, 0.0, 1.0))[0] <= ON_FLOOR_WITHIN for one in solids):
        warn(InputWarning("simulation.settles", value=room.floor.settlement))


def checked_step(step: float | None) -> float:
    """Return a longest step [s], or raise `InputError`."""
    return STEP if step is None else within("simulation.step", step, 1e-6, 0.01, "s", "step")


def simulate_assembly(
    assembly: Assembly, room: Room, motion: Motion, gravity: float, step: float | None = None
) -> SpaceRun:
    """Simulate solids in space; see `stayput.simulate`.

    The gaps of the walls are from the outermost corners of all bodies. The floor's settlement is a law of
    furniture: for solids on the floor it is left out, and warned of.
    """
    warn_of_settlement(assembly, room)
    shaking = SpaceShaking(acceleration_of(motion), motion.dt)
    traced = trace_assembly(assembly, room, shaking, GRAVITY.check(gravity), checked_step(step))
    return run_of_assembly(traced, assembly.joints, room, motion)


class AssemblyTrace(NamedTuple):
    """Several bodies as the engine ran them: bodies, room, and what became of them and what holds them."""

    bodies: tuple[Placed, ...]
    planes: NDArray[np.void]
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
    planes = planes_around(assembly.members, room)
    bodies = placed(assembly.members, room, strength)
    standing = [one.standing for one in bodies]
    laws = [_laws_under(one, room, friction) for one in bodies]
    world = world_of([one.solid for one in standing], laws, planes, assembly.friction)
    poses = np.stack(
        [pose_of(one.solid, one.turn, one.place, one.velocity, one.rotation_rate) for one in standing]
    )
    springs = np.concatenate([*(one.springs for one in bodies), joint_springs(standing, assembly.joints)])
    trace = run_world(world, poses, springs, shaking.acceleration, shaking.dt, step, gravity)
    return AssemblyTrace(bodies, planes, trace)


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
    bodies, planes, trace = traced
    springs = trace.springs
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


def run_held(
    held: Held, rows: NDArray[np.void], motion: Motion, initial: State, gravity: float, step: float = STEP
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
    piece, planes, trace = trace_case(case, rows, shaking, step, m)
    hits = trace.hits.copy()
    hits["impulse"] *= m
    trace = trace._replace(pressing=m * trace.pressing, hits=hits)
    devices = device_results(held, rows, trace.devices, trace.forces, held.body.mass)
    return _run((piece,), held.room, motion, planes, trace, devices, (held,))


def _run(
    standing: tuple[Standing, ...],
    room: Room,
    motion: Motion,
    planes: NDArray[np.void],
    trace: SpaceTrace,
    devices: tuple[DeviceResult, ...],
    held: tuple[Held | None, ...],
) -> SpaceRun:
    surfaces = [surface_of(plane) for plane in planes]
    hits = tuple(
        Hit(
            float(hit["time"]),
            int(hit["a"]),
            None if hit["b"] < 0 else int(hit["b"]),
            "" if hit["plane"] < 0 else surfaces[int(hit["plane"])],
            float(hit["speed"]),
            float(hit["impulse"]),
        )
        for hit in trace.hits
    )
    run = SpaceRun(
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
        trace.gaps,
        devices,
        trace.springs,
        trace.steps,
        trace.unconverged,
        trace.error,
        held,
        trace.given_up,
    )
    if lying := [b for b, one in enumerate(standing) if one.round_side is not None]:
        run.peak_tilt[lying] = run.tilt[lying].max(axis=1)  # the engine's counts what they have rolled
    return run


def _laws_under(body: Placed, room: Room, factor: float) -> FloorLaws:
    """Return the laws of the floor under a body: where a measure changes the friction, its feet have that."""
    if body.held is None:
        return FloorLaws.of(room_row(room))
    own = body.held.room.floor
    drawn = friction_factor(own, factor)
    changed = {
        name: drawn * value
        for name, value in ((field.name, getattr(own, field.name)) for field in fields(own))
        if name.endswith("friction") and value is not None and value != getattr(room.floor, name)
    }
    laws = FloorLaws.of(room_row(replace(room, floor=replace(own, **changed))))
    if not {"static_friction", "kinetic_friction"} & changed.keys():
        return laws
    friction = laws.edge_friction
    return laws._replace(back_friction=friction, front_friction=friction)
