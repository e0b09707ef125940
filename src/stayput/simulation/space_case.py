"""A case in space: piece and room of a `CASE` that has a length, and what became of it as a `RESULT`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.mechanics import columns as col
from stayput.mechanics.devices.columns import DEVICE, NONE
from stayput.mechanics.space.columns import ON_FLOOR, ON_ROOM
from stayput.model.soft_base import landing_factor
from stayput.model.solid import Solid
from stayput.simulation.space_devices import springs_of
from stayput.simulation.space_engine import SpaceTrace, run_world
from stayput.simulation.space_records import FloorLaws, RoomSurface, matrices, planes_of, pose_of, world_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

MOVED = 1e-6
"""Way from which on a body has slid [m]."""

ROCKED = 1e-4
"""Tilt from which on a body has rocked [rad]."""

TOUCHES = 1e-5
"""Gap up to which a body leans on a wall or the ceiling in the end [m]."""


class Piece(NamedTuple):
    """A piece of furniture in space at rest: its solid, its attitude, the place of its G, and the room."""

    solid: Solid
    turn: NDArray[np.float64]
    place: NDArray[np.float64]
    planes: NDArray[np.void]


def solid_of(case: np.void, mass: float) -> Solid:
    """Return the piece of a case in space, its mass [kg] being what a case leaves out.

    Its frame is that of `Solid`: the origin in the middle of the base of its outline.
    """
    (a, b, c, d), (v_a, v_b, top, _) = case["u"].tolist(), case["v"].tolist()
    half, reach = 0.5 * float(case["length"]), float(case["half_base"])
    middle, low = 0.5 * (c + d), min(v_a, v_b)
    outline = [(u - middle, v - low) for u, v in ((c, v_a), (d, v_b), (c, top), (d, top))]
    feet = [(u - middle, v - low) for u, v in ((a, v_a), (b, v_b))]
    moments = case["roll_inertia"], case["inertia"], case["yaw_inertia"]
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


def _stand(case: np.void, tilt: float, fulcrum: int, slide: float) -> NDArray[np.float64]:
    """Return where G is while a body stands on a base corner (0: the back one) that has slid."""
    u, v = case["u"], case["v"]
    half = 0.5 * math.hypot(u[1] - u[0], v[1] - v[0])
    foot = _upright(tilt) @ [u[fulcrum], 0.0, v[fulcrum]]
    return np.array([(half if fulcrum else -half) + slide - foot[0], 0.0, -foot[2]])


def piece_of(case: np.void, mass: float) -> Piece:
    """Return the piece of a case as it stands at rest, the middle of its base at the origin of the room."""
    rest = _resting_tilt(case)
    solid, turn, place = solid_of(case, mass), _upright(rest), _stand(case, rest, 0, 0.0)
    across = _places(solid, place, turn)[:, 0]
    surfaces = [
        RoomSurface(reach + case[f"{name}_distance"], case[f"{name}_friction"], case[f"{name}_restitution"])
        if math.isfinite(case[f"{name}_distance"])
        else None
        for name, reach in (("left", -across.min()), ("right", across.max()), ("ceiling", 0.0))
    ]
    floor = case["static_friction"], case["kinetic_friction"], case["normal_restitution"]
    return Piece(solid, turn, place, planes_of(floor, *surfaces))


def _places(solid: Solid, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where the corners of a body are [m], shape (k, 3)."""
    return place + (solid.vertices - solid.centre_of_gravity) @ turn.T


def _resting_tilt(case: np.void) -> float:
    u, v = case["u"], case["v"]
    return math.atan2(v[1] - v[0], u[1] - u[0])


def trace_case(
    case: np.void,
    elements: NDArray[np.void],
    acceleration: NDArray[np.float64],
    dt: float,
    step: float,
    mass: float,
) -> tuple[Piece, SpaceTrace]:
    """Run a case in space.

    Parameters
    ----------
    case : CASE
        With a length.
    elements : ndarray of ELEMENT, shape (n,)
        What holds it, each device by itself (`stayput.measures.element.Element.spread`).
    acceleration : ndarray, shape (samples, 3)
        Of the floor, before the factor of the case [m/s²].
    dt, step : float
        Time between samples, and longest step [s].
    mass : float
        Mass of the body [kg]; forces are in newtons with it.
    """
    piece = piece_of(case, mass)
    solid, turn, place, planes = piece
    world = world_of([solid], [_floor_laws(case)], planes, (0.0, 0.0))
    axes = solid.principal[1]
    springs = springs_of(elements, mass, turn, place, axes)
    pose = pose_of(solid, *_start(case))
    scaled = float(case["scale"]) * acceleration
    return piece, run_world(world, pose[np.newaxis], springs, scaled, dt, step, float(case["gravity"]))


def _start(case: np.void) -> tuple[NDArray[np.float64], ...]:
    """Return attitude, place, velocity and rotation rate at first."""
    tilt, rate = float(case["tilt"]), float(case["tilt_rate"])
    fulcrum = 1 if tilt > 0.0 or (tilt == 0.0 and rate > 0.0) else 0
    theta = _resting_tilt(case) + tilt
    place = _stand(case, theta, fulcrum, float(case["slide"]))
    turn = _upright(theta)
    spin = np.array([0.0, rate, 0.0])
    foot = turn @ [case["u"][fulcrum], 0.0, case["v"][fulcrum]]
    velocity = np.array([float(case["slide_rate"]), 0.0, 0.0]) - np.cross(spin, foot)
    return turn, place, velocity, spin


def _floor_laws(case: np.void) -> FloorLaws:
    """Return the laws of a case's floor; the restitution without the landing place, which has a direction."""
    u, v = case["u"], case["v"]
    landing = landing_factor(case["landing_place"], -u[0] * u[1], -min(v[0], v[1]), case["inertia"])
    own = [
        (case[f"{side}_edge_static_friction"], case[f"{side}_edge_kinetic_friction"])
        for side in ("left", "right")
    ]
    edge = case["edge_static_friction"], case["edge_kinetic_friction"]
    return FloorLaws(float(case["restitution"] / landing), float(case["landing_place"]), edge, *own)


def result_of(piece: Piece, trace: SpaceTrace, time: NDArray[np.float64]) -> NDArray[np.void]:
    """Return what became of a piece: a RESULT.

    Its slide is that of the foot it stands on, from where that stood at first; its tilt the angle between
    the vertical and what points up at rest. It has overturned where it lies at 90°, or on more than its base.
    """
    result = np.zeros((), col.RESULT)
    solid = piece.solid
    turn = matrices(trace.attitude[0]) @ solid.principal[1].T
    place = trace.place[0]
    up = piece.turn.T @ [0.0, 0.0, 1.0]
    tilt = np.arctan2(np.linalg.norm(np.cross(turn @ up, [0.0, 0.0, 1.0]), axis=1), (turn @ up)[:, 2])
    feet = solid.base - solid.centre_of_gravity
    ways = place[:, np.newaxis] + np.einsum("sij,fj->sfi", turn, feet)
    lowest = ways[:, :, 2].argmin(axis=1)
    stood = piece.place + feet @ piece.turn.T
    way = ways[np.arange(len(time)), lowest, :2] - stood[lowest, :2]
    slide = np.hypot(way[:, 0], way[:, 1])
    fell = np.flatnonzero((tilt >= math.pi / 2) | lies(solid, place, turn))
    end = int(fell[0]) if len(fell) else len(time) - 1
    result["end"] = time[end]
    result["peak_tilt"], result["peak_slide"] = tilt[: end + 1].max(), slide[: end + 1].max()
    result["residual_tilt"], result["residual_slide"] = tilt[end], slide[end]
    result["floor_impacts"], result["wall_impacts"] = trace.hit_numbers[0, [ON_FLOOR, ON_ROOM]]
    result["events"], result["steps"] = trace.hit_numbers[-1, 0], trace.steps
    if not np.isfinite(place).all():
        result["outcome"] = col.FAILED_OUTCOME
    elif len(fell):
        result["outcome"] = col.OVERTURNED_OUTCOME
    elif result["residual_tilt"] > ROCKED and _touches(piece, place[-1], turn[-1]):
        result["outcome"] = col.LEANING
    elif result["peak_tilt"] > ROCKED:
        result["outcome"] = col.ROCKED
    else:
        result["outcome"] = col.SLID if result["peak_slide"] > MOVED else col.RESTED
    return result


def _touches(piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64]) -> bool:
    """Return whether a body touches a wall or the ceiling."""
    corners = _places(piece.solid, place, turn)
    walls = piece.planes[1:]
    normals = np.stack([walls[axis] for axis in ("nx", "ny", "nz")], 1)
    return bool(((corners @ normals.T - walls["offset"]) <= TOUCHES).any())


ON_THE_FLOOR = 1e-4
"""Height up to which a point lies on the floor [m]."""


def lies(solid: Solid, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether a body touches the floor with more than its base, shape (samples,).

    More than its base is what is above the lowest tenth of its height.

    Parameters
    ----------
    solid : Solid
        The body.
    place : ndarray, shape (samples, 3)
        Where its centre of gravity is [m].
    turn : ndarray, shape (samples, 3, 3)
        The rotation of its frame into the room's.
    """
    vertices = solid.vertices
    above = vertices[vertices[:, 2] > vertices[:, 2].min() + 0.1 * np.ptp(vertices[:, 2])]
    heights = place[:, 2, np.newaxis] + turn[:, 2] @ (above - solid.centre_of_gravity).T
    return heights.min(axis=1) <= ON_THE_FLOOR


def run_rows_in_space(
    cases: NDArray[np.void],
    elements: NDArray[np.void],
    acceleration: NDArray[np.float64],
    dt: float,
    step: float,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases under one motion on this thread: RESULT, shape [m], and DEVICE, shape [m, n].

    As `stayput.simulation.columns.run_rows`, in space: per unit mass.
    """
    results, devices = np.zeros(len(cases), col.RESULT), np.zeros(elements.shape, DEVICE)
    devices["failure_time"] = np.nan
    time = dt * np.arange(len(acceleration), dtype=np.float64)
    for n, (case, rows) in enumerate(zip(cases, elements, strict=True)):
        piece, trace = trace_case(case, rows, acceleration, dt, step, 1.0)
        results[n] = result_of(piece, trace, time)
        devices[n, rows["kind"] != NONE] = trace.devices
    return results, devices
