"""Bodies and rooms in space as the engine reads them, and the attitudes that it writes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.mechanics.devices.columns import DEVICE
from stayput.mechanics.space.columns import (
    CONTACT,
    FACE,
    FLOW,
    PAIR,
    PLANE,
    POINT,
    POSE,
    PRESSING,
    PULL,
    RIM,
    SOLID,
)
from stayput.mechanics.space.constants import MOST_PRESSING, MOST_ROWS
from stayput.mechanics.space.pairs import MOST_TOUCHING
from stayput.mechanics.space.touching import RIM_POINTS
from stayput.model.even_base import friction_ratio
from stayput.model.flat_fields import WALLS_AND_CEILING
from stayput.model.room import Wall

if TYPE_CHECKING:
    from stayput.model.room import Ceiling, Room
    from stayput.model.solid import Solid
    from stayput.simulation.piece import Piece


def quaternion_of(turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the unit quaternion w, x, y, z of a rotation matrix, shape (3, 3); its largest part is > 0."""
    xx, yy, zz = np.diag(turn)
    squares = 0.25 * np.array([1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz])
    place = int(np.argmax(squares))
    largest = np.sqrt(squares[place])
    odd, even = turn - turn.T, turn + turn.T
    wx, wy, wz, xy, xz, yz = odd[2, 1], odd[0, 2], odd[1, 0], even[1, 0], even[0, 2], even[2, 1]
    products = np.array([[0.0, wx, wy, wz], [wx, 0.0, xy, xz], [wy, xy, 0.0, yz], [wz, xz, yz, 0.0]])
    quaternion = products[place] / (4.0 * largest)
    quaternion[place] = largest
    return quaternion / np.linalg.norm(quaternion)


def product(q: NDArray[np.float64], r: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the quaternion that turns by r and then by q, shape (..., 4)."""
    w, x, y, z = (q[..., part] for part in range(4))
    a, b, c, d = (r[..., part] for part in range(4))
    quaternion = np.empty(np.broadcast_shapes(q.shape, r.shape))
    quaternion[..., 0] = w * a - x * b - y * c - z * d
    quaternion[..., 1] = w * b + x * a + y * d - z * c
    quaternion[..., 2] = w * c - x * d + y * a + z * b
    quaternion[..., 3] = w * d + x * c - y * b + z * a
    return quaternion


def matrices(q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rotation matrices of unit quaternions of shape (..., 4).

    In memory each element of a matrix is beside that of the next matrix: one by one they are read fast.
    """
    w, x, y, z = (q[..., part] for part in range(4))
    a, b, c = 2.0 * x, 2.0 * y, 2.0 * z
    xx, yy, zz, xy, xz, yz = a * x, b * y, c * z, a * y, a * z, b * z
    wx, wy, wz = w * a, w * b, w * c
    turns = np.empty((3, 3, *q.shape[:-1]))
    turns[0, 0], turns[0, 1], turns[0, 2] = 1.0 - (yy + zz), xy - wz, xz + wy
    turns[1, 0], turns[1, 1], turns[1, 2] = xy + wz, 1.0 - (xx + zz), yz - wx
    turns[2, 0], turns[2, 1], turns[2, 2] = xz - wy, yz + wx, 1.0 - (xx + yy)
    return turns.transpose(*range(2, turns.ndim), 0, 1)


def pose_of(
    solid: Solid,
    turn: NDArray[np.float64],
    place: NDArray[np.float64],
    velocity: ArrayLike,
    rotation_rate: ArrayLike,
) -> NDArray[np.void]:
    """Return where a body is and how it moves at first: a POSE.

    Parameters
    ----------
    solid : Solid
        The body.
    turn : ndarray, shape (3, 3)
        The rotation of its frame into the room's.
    place, velocity, rotation_rate : array_like, shape (3,)
        Of its centre of gravity [m, m/s], and of itself [rad/s].
    """
    pose = np.zeros((), POSE)
    inertia = turn @ solid.inertia @ turn.T
    pose["x"], pose["y"], pose["z"] = place
    pose["qw"], pose["qx"], pose["qy"], pose["qz"] = quaternion_of(turn @ solid.principal[1])
    pose["vx"], pose["vy"], pose["vz"] = np.asarray(velocity)
    pose["lx"], pose["ly"], pose["lz"] = inertia @ np.asarray(rotation_rate)
    return pose


def frames_of(pieces: Sequence[Piece], attitudes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the attitudes of frames from those of principal axes, shape (bodies, samples, 4)."""
    back = [_principal_attitude(piece.solid) * np.array([1.0, -1.0, -1.0, -1.0]) for piece in pieces]
    return np.stack([product(q, r) for q, r in zip(attitudes, back, strict=True)])


@lru_cache(maxsize=256)
def _principal_attitude(solid: Solid) -> NDArray[np.float64]:
    return quaternion_of(solid.principal[1])


def moved_samples(*histories: NDArray[np.float64]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the samples at which numbers are not as before, and which of them each sample repeats.

    Furniture stands still for most of a record.

    Parameters
    ----------
    *histories : ndarray, shape (samples, ...)
        The numbers: where bodies are, and how they are turned.
    """
    moved = np.ones(len(histories[0]), np.bool_)
    moved[1:] = False
    for history in histories:
        for numbers in history.reshape(len(history), -1).T:
            moved[1:] |= numbers[1:] != numbers[:-1]
    return np.flatnonzero(moved), np.cumsum(moved) - 1


class Path(NamedTuple):
    """The poses of bodies at the samples at which any of them moves.

    Parameters
    ----------
    sample, repeats : ndarray of int
        These samples, shape (k,), and which of them each sample repeats; see `moved_samples`.
    place, turn : ndarray, shape (bodies, k, 3) and (bodies, k, 3, 3)
        Of the centres of gravity [m], and the rotations of the frames into the room's.
    """

    sample: NDArray[np.intp]
    repeats: NDArray[np.intp]
    place: NDArray[np.float64]
    turn: NDArray[np.float64]

    @classmethod
    def of(
        cls, place: NDArray[np.float64], attitude: NDArray[np.float64], pieces: Sequence[Piece] | None = None
    ) -> Path:
        """Return that of bodies from where they were and how they were turned at all samples.

        Attitudes are those of the principal axes of pieces, where these are given, else of frames.
        """
        sample, repeats = moved_samples(*place, *attitude)
        turned = attitude[:, sample]
        frames = turned if pieces is None else frames_of(pieces, turned)
        return cls(sample, repeats, place[:, sample], matrices(frames))


def world_of(
    solids: Sequence[Solid], floors: Sequence[np.void], planes: NDArray[np.void], between: tuple[float, float]
) -> tuple[Any, ...]:
    """Return bodies and room as `run_in_space` takes them.

    Parameters
    ----------
    solids : sequence of Solid
        The bodies.
    floors : sequence of CASE
        The floor under each, with what measures change of it.
    planes : ndarray of PLANE
        The room.
    between : tuple of float
        Static and kinetic coefficients of friction between bodies.
    """
    of_bodies, under = [_records_of(solid) for solid in solids], np.array(floors)
    bodies, points, backward, rims, faces, loops, edges = map(np.concatenate, zip(*of_bodies, strict=True))
    for name in ("point", "rim", "face", "edge"):
        bodies[f"first_{name}"] = np.cumsum(bodies[f"{name}s"]) - bodies[f"{name}s"]
    faces["first"] = np.cumsum(faces["count"]) - faces["count"]
    loops += np.repeat(bodies["first_point"], [len(records[5]) for records in of_bodies])
    edges += np.repeat(bodies["first_point"], bodies["edges"])[:, np.newaxis]
    owner = np.repeat(np.arange(len(bodies)), bodies["points"])
    for kind in ("static", "kinetic"):
        bodies[f"mu_{kind}"] = under[f"{kind}_friction"]
        bodies[f"edge_{kind}"] = under[f"edge_{kind}_friction"]
    bodies["restitution"], bodies["landing_place"] = under["floor_restitution"], under["landing_place"]
    bodies["rolling"] = under["rolling_resistance"]
    sides = np.where(backward, *(_edge_friction(under, side)[:, owner] for side in ("left", "right")))
    points["mu_static"], points["mu_kinetic"] = sides
    pairs = [(b, a, *between, 0.0) for b in range(len(solids)) for a in range(b)]
    return bodies, points, rims, planes, np.array(pairs, PAIR), faces, loops, edges


def _edge_friction(floors: NDArray[np.void], side: str) -> NDArray[np.float64]:
    """Return an edge's static and kinetic friction by floor: nan, or that of all edges for one of both."""
    stated, usual = (
        np.array([floors[f"{edge}_{kind}_friction"] for kind in ("static", "kinetic")])
        for edge in (f"{side}_edge", "edge")
    )
    return np.where(np.isnan(stated) & ~np.isnan(stated).all(axis=0), usual, stated)


@lru_cache(maxsize=256)
def _records_of(solid: Solid) -> tuple[NDArray[Any], ...]:
    """Return a SOLID, its POINTs, which of them are at its back, RIMs, FACEs, their corners, and edges.

    They lack what the floor gives, on which the same body stands differently with each measure.
    """
    moments, axes = solid.principal
    about = solid.centre_of_gravity

    def in_axes(place: NDArray[np.float64]) -> NDArray[np.float64]:
        return (place - about) @ axes

    corners = solid.vertices
    vertices = in_axes(corners)
    on_rim: NDArray[np.bool_] = np.any(on_rims(solid), axis=0)
    above = _above_feet(solid, corners)
    stands = np.zeros((0, 3))
    if solid.feet is not None:
        stands = np.concatenate([solid.feet, _cut_off(corners[~above], solid.feet)])
    points, low = np.zeros(len(corners) + len(stands), POINT), np.ones(len(stands), np.bool_)
    points["x"], points["y"], points["z"] = np.concatenate([vertices, in_axes(stands)]).T
    points["floor"], points["walls"] = np.append(~on_rim & above, low), np.append(~on_rim, ~low)
    rims = [
        (*in_axes(rim[:3]), *(rim[3:6] @ axes), rim[6], int(free), 1)
        for rim, free in zip(solid.rims, _above_feet(solid, solid.rims[:, :3]), strict=True)
    ]
    loops = [face.tolist() for face in solid.faces]
    normals = zip((solid.normals @ axes).tolist(), loops, strict=True)
    ahead = [pair for around in loops for pair in zip(around, [*around[1:], around[0]], strict=True)]
    edges = [(i, j) for i, j in ahead if i < j]
    body = np.zeros(1, SOLID)
    body["mass"], body["rm"] = solid.mass, 1.0 / math.sqrt(solid.mass)
    body["i1"], body["i2"], body["i3"] = moments
    body["r1"], body["r2"], body["r3"] = 1.0 / np.sqrt(moments)
    body["points"], body["hull"], body["rims"] = len(points), len(vertices), len(rims)
    body["faces"], body["edges"], body["kappa"] = len(loops), len(edges), friction_ratio(solid)
    up = solid.up_at_rest
    body["ux"], body["uy"], body["uz"] = axes[2] if up is None else up @ axes
    body["radius"] = np.linalg.norm(vertices, axis=1).max()
    return (
        body,
        points,
        np.concatenate([corners, stands])[:, 0] - about[0] < 0.0,
        np.array(rims, RIM),
        np.array([(*normal, 0, len(around)) for normal, around in normals], FACE),
        np.array([corner for around in loops for corner in around], np.int64),
        np.array(edges, np.int64).reshape(-1, 2),
    )


def _above_feet(solid: Solid, points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which points are higher than all feet as the body stands; in place of the others stand the feet.

    A body without feet stands on its points. One that leans on feet of unequal height lifts what juts out
    beyond the higher ones by its lean: that is low too.
    """
    if solid.feet is None:
        return np.ones(len(points), np.bool_)
    up = solid.up_at_rest
    up = np.array([0.0, 0.0, 1.0]) if up is None else up
    lifted = float(np.hypot(up[0], up[1])) * _from_feet(points, solid.feet)
    return points @ up > (solid.feet @ up).max() + 1e-6 + lifted


def _from_feet(points: NDArray[np.float64], feet: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far points are from the nearest foot in plan [m]."""
    return np.linalg.norm(points[:, np.newaxis, :2] - feet[:, :2], axis=2).min(axis=1)


def _cut_off(low: NDArray[np.float64], feet: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return points above the low corners of a body with feet, which touch the floor where it falls over.

    A corner that juts out beyond the feet is cut off at 45°: at the height of its distance from the nearest
    foot. So the body tips over the foot, and lies on its side.
    """
    apart = _from_feet(low, feet)
    return low[apart > 1e-9] + apart[apart > 1e-9, np.newaxis] * [0.0, 0.0, 1.0]


def on_rims(solid: Solid) -> NDArray[np.bool_]:
    """Return which corners lie on which rim, shape (rims, n): planes meet the rim itself."""
    on_rim = np.zeros((len(solid.rims), len(solid.vertices)), np.bool_)
    for row, rim in zip(on_rim, solid.rims, strict=True):
        arms = solid.vertices - rim[:3]
        along = arms @ rim[3:6]
        across = np.linalg.norm(arms - along[:, np.newaxis] * rim[3:6], axis=1)
        row[:] = (np.abs(along) <= 1e-6) & (np.abs(across - rim[6]) <= 0.01 * rim[6])
    return on_rim


NORMALS = {
    "floor": (0.0, 0.0, 1.0),
    "left_wall": (1.0, 0.0, 0.0),
    "right_wall": (-1.0, 0.0, 0.0),
    "near_side_wall": (0.0, 1.0, 0.0),
    "far_side_wall": (0.0, -1.0, 0.0),
    "ceiling": (0.0, 0.0, -1.0),
}
"""Which way into the room each of its surfaces faces, by the names in `Room`."""


def surface_of(plane: np.void) -> str:
    """Return which surface of the room a PLANE is, by the name in `Room`."""
    normal = tuple(float(plane[axis]) for axis in ("nx", "ny", "nz"))
    return next(name for name, direction in NORMALS.items() if direction == normal)


APART = 1e-6
"""Least gap from walls and ceiling [m]: one that touches a body at first would press it against the floor or
an opposite one with any force, as nothing tells how hard, and hold it by friction.
"""


def planes_of(pieces: Sequence[Piece], room: Room) -> NDArray[np.void]:
    """Return a room as the engine reads it, the floor first: PLANE.

    Parameters
    ----------
    pieces : sequence of Piece
        What stands in it: the gaps of the walls are from what is outermost of all bodies.
    room : Room
        The room, with the walls of its plan.
    """
    floor = (room.floor.static_friction, room.floor.kinetic_friction, room.floor.normal_restitution)
    planes = [(*NORMALS["floor"], 0.0, *floor, 1)]
    for name in WALLS_AND_CEILING:
        surface: Wall | Ceiling | None = getattr(room, name)
        if surface is not None:
            normal, mu = NORMALS[name], surface.friction
            outermost = min(piece.reach(normal)[0] for piece in pieces)
            offset = outermost - surface.gap if isinstance(surface, Wall) else -surface.height
            if abs(outermost - offset) < APART:
                offset = outermost - APART
            planes.append((*normal, offset, mu, mu, surface.restitution, 0))
    return np.array(planes, PLANE)


def scratch_of(world: tuple[Any, ...], devices: int) -> tuple[Any, ...]:
    """Return the working memory of `run_in_space` with so many devices; all contacts stick at first."""
    bodies, points, rims, planes, pairs, faces = world[:6]
    keys = len(planes) * (len(points) + RIM_POINTS * len(rims)) + MOST_TOUCHING * len(pairs)
    features = len(planes) * (len(points) + len(rims)) + len(pairs)
    kept = np.zeros((3, keys, 10))
    kept[0, :, 3] = 1.0
    # of two convex faces that cut each other half as many corners are left; by rounding it may be more
    most_corners = 4 * faces["count"].max()
    return (
        np.zeros(keys, CONTACT),
        kept,
        np.zeros((2, features)),
        np.zeros((len(points), 3)),
        np.zeros((2, most_corners, 4)),
        np.zeros((MOST_TOUCHING, 5)),
        (
            np.zeros((len(points), 3)),
            np.zeros(len(bodies), np.int64),
            np.zeros((len(bodies), 3)),
            np.zeros(len(bodies)),
            np.zeros((len(bodies), 6)),
            np.zeros((len(bodies), 4)),
        ),
        (
            np.zeros((keys + devices, 2, 6, 6)),
            np.zeros((len(bodies), len(bodies), 6, 6)),
            np.zeros((len(bodies), 6)),
            np.zeros(len(bodies), np.int64),
            np.zeros((len(bodies), 6)),
        ),
        np.full((len(pairs), 2), -1),
        np.zeros(devices, PULL),
        np.zeros(devices, DEVICE),
        np.zeros(5),
        (
            np.zeros(1, FLOW),
            np.zeros(MOST_PRESSING, PRESSING),
            (
                np.zeros((MOST_ROWS, 6)),
                np.zeros((MOST_ROWS, 6)),
                np.zeros((MOST_ROWS, MOST_ROWS)),
                np.zeros((8, MOST_ROWS)),
                np.zeros(MOST_ROWS, np.int64),
            ),
            np.zeros((7, 13)),
            np.zeros((6, 13)),
            np.zeros(features),
        ),
    )
