"""A case in space: piece and room of a `CASE` that has a length, and what became of it as a `RESULT`.

As in the plane a case has no mass: the engine runs it with 1 kg, and forces are per unit mass.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import DEVICE, NONE
from stayput.mechanics.space.columns import ON_FLOOR, ON_ROOM
from stayput.model.body import BASES
from stayput.model.soft_base import landing_factor
from stayput.model.solid import Solid
from stayput.simulation.outcome import OUTCOMES, Outcome
from stayput.simulation.placing import springs_of
from stayput.simulation.space_engine import STEP, SpaceTrace, run_world
from stayput.simulation.space_fate import fates_of
from stayput.simulation.space_records import (
    NORMALS,
    FloorLaws,
    frames_of,
    matrices,
    planes_of,
    pose_of,
    world_of,
)
from stayput.simulation.standing import Standing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion


@dataclass(frozen=True, slots=True, eq=False)
class SpaceShaking:
    """A motion prepared for the engine in space: the floor's acceleration, shape (samples, 3), and its dt."""

    acceleration: NDArray[np.float64]
    dt: float

    @property
    def times(self) -> NDArray[np.float64]:
        """The times of its samples [s]."""
        return self.dt * np.arange(len(self.acceleration), dtype=np.float64)


def acceleration_of(motion: Motion) -> NDArray[np.float64]:
    """Return the floor's acceleration along x, y and z, shape (samples, 3) [m/s²]."""
    given = motion.components
    return np.stack([given.get(name, np.zeros(len(motion.x))) for name in "xyz"], axis=1)


def solid_of(case: np.void, mass: float = 1.0) -> Solid:
    """Return the piece of a case in space, of a mass [kg], which a case leaves out.

    Its frame is that of `Solid`: the origin in the middle of the base of its outline.
    """
    if math.isnan(case["length"]):
        raise InputError("solids.no_length", "length")
    names = ("length", "half_base", "roll_inertia", "inertia", "yaw_inertia")
    # 0 added: −0 is the same key as 0, and should be the same number
    u, v = (tuple((case[name] + 0.0).tolist()) for name in ("u", "v"))
    sizes = (float(case[name]) + 0.0 for name in names)
    return _solid_of(u, v, *sizes, mass, BASES[int(case["base"])])


# A verification shakes the same pieces with each measure.
@lru_cache(maxsize=512)
def _solid_of(
    u: tuple[float, ...],
    v: tuple[float, ...],
    length: float,
    half_base: float,
    roll_inertia: float,
    inertia: float,
    yaw_inertia: float,
    mass: float,
    base: str,
) -> Solid:
    (a, b, c, d), (v_a, v_b, top, _) = u, v
    half, middle, low = 0.5 * length, 0.5 * (c + d), min(v_a, v_b)
    outline = [(x - middle, z - low) for x, z in ((c, v_a), (d, v_b), (c, top), (d, top))]
    feet = [(x - middle, z - low) for x, z in ((a, v_a), (b, v_b))]
    return Solid(
        [(x, y, z) for x, z in outline for y in (-half, half)],
        mass,
        centre_of_gravity=(-middle, 0.0, -low),
        inertia=mass * np.diag([roll_inertia, inertia, yaw_inertia]),
        feet=[(x, y, z) for x, z in feet for y in (-half_base, half_base)],
        base=base,
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


def piece_of(case: np.void, mass: float = 1.0) -> Standing:
    """Return the piece of a case as it rests; the middle of its base is at the origin of the room."""
    resting = case.copy()
    for name in ("tilt", "tilt_rate", "slide", "slide_rate"):
        resting[name] = 0.0
    turn, place, _, _ = _pose(resting)
    solid = solid_of(case, mass)
    origin = place - turn @ solid.centre_of_gravity
    u, v = case["u"], case["v"]
    lean = math.atan2(v[1] - v[0], u[1] - u[0])
    return Standing(solid, (float(origin[0]), 0.0, float(origin[2])), tilt=(0.0, lean, 0.0))


def trace_case(
    case: np.void,
    elements: NDArray[np.void],
    motion: SpaceShaking,
    step: float = STEP,
    mass: float = 1.0,
    lies: float = math.inf,
) -> tuple[Standing, NDArray[np.void], SpaceTrace]:
    """Run a case in space, per unit mass; return the piece as it rests, its room (PLANE), and the run.

    Parameters
    ----------
    case : CASE
        With a length.
    elements : ndarray of ELEMENT, shape (n,)
        What holds it, each device by itself: of `stayput.measures.hold` with three dimensions.
    motion : SpaceShaking
        Of the floor, before the factor of the case.
    step : float
        Longest step that is not extrapolated [s].
    mass : float
        Mass of the solid that is returned [kg]; it changes nothing else.
    lies : float
        How long the piece lies before the run ends [s].

    Raises
    ------
    InputError
        A case without a length, or one that begins in a wall or the ceiling.
    """
    piece = piece_of(case)
    room = case.copy()  # a piece as high as the room that leans as drawn reaches no farther
    room["ceiling_distance"] = max(float(case["ceiling_distance"]), -piece.along(NORMALS["ceiling"])[0])
    solid, planes = piece.solid, planes_of([piece], room)
    world = world_of([solid], [_laws_of_piece(case)], planes, (0.0, 0.0))
    springs = springs_of(elements, piece.turn, piece.place, solid.principal[1])
    pose = pose_of(solid, *_pose(case))
    shaken = float(case["scale"]) * motion.acceleration
    trace = run_world(world, pose[np.newaxis], springs, shaken, motion.dt, step, float(case["gravity"]), lies)
    return piece if mass == 1.0 else piece_of(case, mass), planes, trace


def _laws_of_piece(case: np.void) -> FloorLaws:
    """Return the laws of a case's floor; the restitution without the landing place, which has a direction."""
    u, v = case["u"], case["v"]
    landing = landing_factor(case["landing_place"], -u[0] * u[1], -min(v[0], v[1]), case["inertia"])
    laws = FloorLaws.of(case)
    return laws._replace(restitution=float(laws.restitution / landing))


def results_of(
    standing: Sequence[Standing], trace: SpaceTrace, time: NDArray[np.float64]
) -> NDArray[np.void]:
    """Return what became of bodies: RESULT, shape (bodies,). Slides are distances in plan, of any direction.

    Parameters
    ----------
    standing : sequence of Standing
        The bodies as they stood at first.
    trace : SpaceTrace
        What the engine returned.
    time : ndarray, shape (samples,)
        Time [s].
    """
    turns = matrices(frames_of(standing, trace.attitude))
    results = np.zeros(len(standing), RESULT)
    fates = fates_of(standing, trace.place, turns, trace.gaps, trace.given_up)
    for body, (result, fate) in enumerate(zip(results, fates, strict=True)):
        falls = [sample for sample in (fate.overturned, fate.fell_off) if sample is not None]
        end = min(falls, default=len(time) - 1)
        # the mechanics know of no body that another bears
        fell_off = fate.outcome is Outcome.FELL_OFF
        result["outcome"] = OVERTURNED_OUTCOME if fell_off else OUTCOMES.index(fate.outcome)
        result["end"] = time[end]
        seen = falls or standing[body].round_side is not None  # the engine's tilt counts what it has rolled
        result["peak_tilt"] = fate.tilt[: end + 1].max() if seen else trace.peak_tilt[body]
        result["peak_slide"] = fate.way[: end + 1].max()
        result["residual_tilt"], result["residual_slide"] = fate.tilt[end], fate.way[end]
        result["floor_impacts"], result["wall_impacts"] = trace.hit_numbers[body, [ON_FLOOR, ON_ROOM]]
        result["events"], result["steps"] = trace.hit_numbers[-1, 0], trace.steps
    return results


ENDS = 0.5
"""How long a piece lies in a run of which only results are asked for [s]: nothing of them comes after."""


def run_rows_in_space(
    cases: NDArray[np.void], elements: NDArray[np.void], motion: SpaceShaking
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases under one motion on this thread; see `stayput.simulation.many.run_rows`."""
    results, devices = np.zeros(len(cases), RESULT), np.zeros(elements.shape, DEVICE)
    devices["failure_time"] = np.nan
    time = motion.times
    for n, (case, rows) in enumerate(zip(cases, elements, strict=True)):
        piece, _, trace = trace_case(case, rows, motion, lies=ENDS)
        results[n] = results_of([piece], trace, time)[0]
        devices[n, rows["kind"] != NONE] = trace.devices
    return results, devices
