"""A case in space: piece and room of a `CASE` that has a length, and what became of it as a `RESULT`.

As in the plane a case has no mass: the engine runs it with 1 kg, and forces are per unit mass.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputError
from stayput.mechanics.columns import (
    FAILED_OUTCOME,
    LEANING,
    OVERTURNED_OUTCOME,
    RESTED,
    RESULT,
    ROCKED,
    SLID,
)
from stayput.mechanics.devices.columns import DEVICE, NONE
from stayput.mechanics.space.columns import ON_FLOOR, ON_ROOM
from stayput.model.soft_base import landing_factor
from stayput.model.solid import Solid
from stayput.simulation.outcome import Outcome
from stayput.simulation.space_devices import springs_of
from stayput.simulation.space_engine import STEP, SpaceTrace, run_world
from stayput.simulation.space_kinematics import slides, tilts
from stayput.simulation.space_records import (
    FloorLaws,
    RoomSurface,
    frames_of,
    matrices,
    planes_of,
    pose_of,
    world_of,
)
from stayput.simulation.space_run import fallen, outcome_of
from stayput.simulation.standing import Standing

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion import Motion

NUMBERS = {
    Outcome.RESTED: RESTED,
    Outcome.SLID: SLID,
    Outcome.ROCKED: ROCKED,
    Outcome.LEANING: LEANING,
    Outcome.OVERTURNED: OVERTURNED_OUTCOME,
    Outcome.FAILED: FAILED_OUTCOME,
}
"""Numbers of the outcomes in the mechanics."""


@dataclass(frozen=True, slots=True, eq=False)
class SpaceShaking:
    """A motion prepared for the engine in space: the floor's acceleration, shape (samples, 3), and its dt."""

    acceleration: NDArray[np.float64]
    dt: float


def acceleration_of(motion: Motion) -> NDArray[np.float64]:
    """Return the floor's acceleration along x, y and z, shape (samples, 3) [m/s²]."""
    given = motion.components
    return np.stack([given.get(name, np.zeros(len(motion.x))) for name in "xyz"], axis=1)


class PieceInRoom(NamedTuple):
    """A piece of furniture as it rests, and its room; the middle of its base is at the origin of the room."""

    standing: Standing
    planes: NDArray[np.void]


def solid_of(case: np.void, mass: float = 1.0) -> Solid:
    """Return the piece of a case in space, of a mass [kg], which a case leaves out.

    Its frame is that of `Solid`: the origin in the middle of the base of its outline.
    """
    if math.isnan(case["length"]):
        raise InputError("solids.no_length", "length")
    (a, b, c, d), (v_a, v_b, top, _) = case["u"].tolist(), case["v"].tolist()
    half, reach = 0.5 * float(case["length"]), float(case["half_base"])
    middle, low = 0.5 * (c + d), min(v_a, v_b)
    outline = [(u - middle, v - low) for u, v in ((c, v_a), (d, v_b), (c, top), (d, top))]
    feet = [(u - middle, v - low) for u, v in ((a, v_a), (b, v_b))]
    moments = [float(case[name]) for name in ("roll_inertia", "inertia", "yaw_inertia")]
    return Solid(
        [(x, y, z) for x, z in outline for y in (-half, half)],
        mass,
        centre_of_gravity=(-middle, 0.0, -low),
        inertia=mass * np.diag(moments),
        feet=[(x, y, z) for x, z in feet for y in (-reach, reach)],
    )


def _upright(tilt: float) -> NDArray[np.float64]:
    """Return the rotation by a tilt, + from z towards x."""
    cos, sin = math.cos(tilt), math.sin(tilt)
    return np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])


def _pose(case: np.void) -> tuple[NDArray[np.float64], ...]:
    """Return attitude, place and velocity of G, and rotation rate of a body in its initial state."""
    u, v = case["u"], case["v"]
    tilt, rate = float(case["tilt"]), float(case["tilt_rate"])
    fulcrum = 1 if tilt > 0.0 or (tilt == 0.0 and rate > 0.0) else 0
    half = 0.5 * math.hypot(u[1] - u[0], v[1] - v[0])
    turn = _upright(math.atan2(v[1] - v[0], u[1] - u[0]) + tilt)
    foot = turn @ [u[fulcrum], 0.0, v[fulcrum]]
    place = np.array([(half if fulcrum else -half) + float(case["slide"]), 0.0, 0.0]) - foot
    spin = np.array([0.0, rate, 0.0])
    return turn, place, np.array([float(case["slide_rate"]), 0.0, 0.0]) - np.cross(spin, foot), spin


def piece_of(case: np.void, mass: float = 1.0) -> PieceInRoom:
    """Return the piece of a case as it rests."""
    resting = case.copy()
    for name in ("tilt", "tilt_rate", "slide", "slide_rate"):
        resting[name] = 0.0
    turn, place, _, _ = _pose(resting)
    solid = solid_of(case, mass)
    origin = place - turn @ solid.centre_of_gravity
    across = origin[0] + solid.vertices @ turn[0]
    back, front, above = (
        RoomSurface(
            reach + float(case[f"{name}_distance"]),
            float(case[f"{name}_friction"]),
            float(case[f"{name}_restitution"]),
        )
        if math.isfinite(case[f"{name}_distance"])
        else None
        for name, reach in (("left", -across.min()), ("right", across.max()), ("ceiling", 0.0))
    )
    floor = [float(case[name]) for name in ("static_friction", "kinetic_friction", "normal_restitution")]
    planes = planes_of((floor[0], floor[1], floor[2]), back, front, above)
    u, v = case["u"], case["v"]
    lean = math.atan2(v[1] - v[0], u[1] - u[0])
    standing = Standing(solid, (float(origin[0]), 0.0, float(origin[2])), tilt=(0.0, lean, 0.0))
    return PieceInRoom(standing, planes)


def trace_case(
    case: np.void, elements: NDArray[np.void], motion: SpaceShaking, step: float = STEP, mass: float = 1.0
) -> tuple[PieceInRoom, SpaceTrace]:
    """Run a case in space, per unit mass.

    Parameters
    ----------
    case : CASE
        With a length.
    elements : ndarray of ELEMENT, shape (n,)
        What holds it, each device by itself: of `stayput.measures.hold` with three dimensions.
    motion : SpaceShaking
        Of the floor, before the factor of the case.
    step : float
        Longest step [s].
    mass : float
        Mass of the solid that is returned [kg]; it changes nothing else.

    Raises
    ------
    InputError
        A case without a length, or one that begins in a wall or the ceiling.
    """
    piece = piece_of(case)
    solid = piece.standing.solid
    world = world_of([solid], [_floor_laws(case)], piece.planes, (0.0, 0.0))
    springs = springs_of(elements, piece.standing.turn, piece.standing.place, solid.principal[1])
    pose = pose_of(solid, *_pose(case))
    shaken = float(case["scale"]) * motion.acceleration
    trace = run_world(world, pose[np.newaxis], springs, shaken, motion.dt, step, float(case["gravity"]))
    return piece if mass == 1.0 else piece_of(case, mass), trace


def _floor_laws(case: np.void) -> FloorLaws:
    """Return the laws of a case's floor; the restitution without the landing place, which has a direction."""
    u, v = case["u"], case["v"]
    landing = landing_factor(case["landing_place"], -u[0] * u[1], -min(v[0], v[1]), case["inertia"])
    back, front, edge = (
        (float(case[f"{part}edge_static_friction"]), float(case[f"{part}edge_kinetic_friction"]))
        for part in ("left_", "right_", "")
    )
    return FloorLaws(float(case["restitution"] / landing), float(case["landing_place"]), edge, back, front)


def result_of(
    one: Standing, planes: NDArray[np.void], trace: SpaceTrace, time: NDArray[np.float64], body: int = 0
) -> NDArray[np.void]:
    """Return what became of a body: a RESULT. Its slide is a distance in plan, whatever the direction.

    Parameters
    ----------
    one : Standing
        The body as it stood at first.
    planes : ndarray of PLANE
        The room.
    trace : SpaceTrace
        What the engine returned.
    time : ndarray, shape (samples,)
        Time [s].
    body : int
        Its number.
    """
    result = np.zeros((), RESULT)
    turn, place = matrices(frames_of([one], trace.attitude[body : body + 1])[0]), trace.place[body]
    tilt = tilts(one.rest, turn)
    slide = np.linalg.norm(slides(one, place, turn), axis=1)
    fell = np.flatnonzero(fallen(one, place, turn))
    end = int(fell[0]) if len(fell) else len(time) - 1
    result["outcome"] = NUMBERS[outcome_of(one, planes, place, turn)]
    result["end"] = time[end]
    result["peak_tilt"] = tilt[: end + 1].max() if len(fell) else trace.peak_tilt[body]
    result["peak_slide"] = slide[: end + 1].max()
    result["residual_tilt"], result["residual_slide"] = tilt[end], slide[end]
    result["floor_impacts"], result["wall_impacts"] = trace.hit_numbers[body, [ON_FLOOR, ON_ROOM]]
    result["events"], result["steps"] = trace.hit_numbers[-1, 0], trace.steps
    return result


def run_rows_in_space(
    cases: NDArray[np.void], elements: NDArray[np.void], motion: SpaceShaking
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases under one motion on this thread; see `stayput.simulation.columns.run_rows`."""
    results, devices = np.zeros(len(cases), RESULT), np.zeros(elements.shape, DEVICE)
    devices["failure_time"] = np.nan
    time = motion.dt * np.arange(len(motion.acceleration), dtype=np.float64)
    for n, (case, rows) in enumerate(zip(cases, elements, strict=True)):
        piece, trace = trace_case(case, rows, motion)
        results[n] = result_of(piece.standing, piece.planes, trace, time)
        devices[n, rows["kind"] != NONE] = trace.devices
    return results, devices
