"""Bodies in space under one motion: assemblies of solids, and a piece of furniture with measures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, within
from stayput.measures.measure import element_rows, hold
from stayput.measures.results import device_results
from stayput.motion.units import GRAVITY
from stayput.simulation.flat_fields import case_columns, room_row
from stayput.simulation.space_case import SpaceShaking, acceleration_of, trace_case
from stayput.simulation.space_devices import joint_results, joint_springs
from stayput.simulation.space_engine import STEP, run_world
from stayput.simulation.space_records import (
    FloorLaws,
    frames_of,
    planes_of,
    pose_of,
    surface_of,
    world_of,
)
from stayput.simulation.space_run import Hit, SpaceRun

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.measures.measure import Held, Measure
    from stayput.measures.results import DeviceResult
    from stayput.model.body import Body
    from stayput.model.room import Room
    from stayput.model.state import State
    from stayput.motion import Motion
    from stayput.simulation.space_engine import SpaceTrace
    from stayput.simulation.standing import Assembly, Standing


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
    numbers = room_row(room)
    planes = planes_of(standing, numbers)
    laws = [FloorLaws.of(numbers)] * len(standing)
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
        trace.gaps,
        devices,
        trace.steps,
        trace.unconverged,
        held,
    )
