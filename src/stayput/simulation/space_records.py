"""Bodies and rooms in space as the engine reads them, and the attitudes that it writes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.mechanics.space.columns import CONTACT, FACE, PAIR, PLANE, POINT, POSE, RIM, SOLID
from stayput.mechanics.space.pairs import MOST_TOUCHING
from stayput.mechanics.space.touching import RIM_POINTS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.model.room import Room
    from stayput.model.solid import Solid
    from stayput.simulation.standing import Standing


DEEPEST = 1e-6
"""How deep a body may begin inside another or a plane, by rounding [m]."""


def quaternion_of(turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the unit quaternion w, x, y, z of a rotation matrix, shape (3, 3); its largest part is > 0."""
    xx, yy, zz = np.diag(turn)
    squares = 0.25 * np.array([1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz])
    place = int(np.argmax(squares))
    largest = np.sqrt(squares[place])
    products = np.array(
        [
            [0.0, turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]],
            [turn[2, 1] - turn[1, 2], 0.0, turn[1, 0] + turn[0, 1], turn[0, 2] + turn[2, 0]],
            [turn[0, 2] - turn[2, 0], turn[1, 0] + turn[0, 1], 0.0, turn[2, 1] + turn[1, 2]],
            [turn[1, 0] - turn[0, 1], turn[0, 2] + turn[2, 0], turn[2, 1] + turn[1, 2], 0.0],
        ]
    )
    found = products[place] / (4.0 * largest)
    found[place] = largest
    return found / np.linalg.norm(found)


def product(q: NDArray[np.float64], r: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the quaternion that turns by r and then by q, shape (..., 4)."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    a, b, c, d = np.moveaxis(np.broadcast_to(r, q.shape), -1, 0)
    return np.stack(
        [
            w * a - x * b - y * c - z * d,
            w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a,
        ],
        axis=-1,
    )


def matrices(q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rotation matrices of unit quaternions of shape (..., 4)."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def initial_pose(one: Standing) -> NDArray[np.void]:
    """Return where a body is at first, at rest: a POSE."""
    pose = np.zeros((), POSE)
    solid = one.solid
    pose["x"], pose["y"], pose["z"] = np.asarray(one.at) + one.turn @ solid.centre_of_gravity
    pose["qw"], pose["qx"], pose["qy"], pose["qz"] = quaternion_of(one.turn @ solid.principal[1])
    pose["vx"], pose["vy"], pose["vz"] = one.velocity
    inertia = one.turn @ solid.inertia @ one.turn.T
    pose["lx"], pose["ly"], pose["lz"] = inertia @ np.asarray(one.rotation_rate)
    return pose


def frames_of(standing: Sequence[Standing], attitudes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the attitudes of frames from those of principal axes, shape (bodies, samples, 4)."""
    back = [quaternion_of(one.solid.principal[1]) * np.array([1.0, -1.0, -1.0, -1.0]) for one in standing]
    return np.stack([product(q, r) for q, r in zip(attitudes, back, strict=True)])


def world_of(standing: Sequence[Standing], room: Room, between: tuple[float, float]) -> tuple[Any, ...]:
    """Return bodies and room as `run_in_space` takes them.

    Parameters
    ----------
    standing : sequence of Standing
        The bodies.
    room : Room
        The room.
    between : tuple of float
        Static and kinetic coefficients of friction between bodies.
    """
    bodies = np.zeros(len(standing), SOLID)
    points: list[tuple[Any, ...]] = []
    rims: list[tuple[Any, ...]] = []
    faces: list[tuple[Any, ...]] = []
    loops: list[int] = []
    edges: list[tuple[int, int]] = []
    for body, one in zip(bodies, standing, strict=True):
        _add(body, one.solid, points, rims, faces, loops, edges)
    pairs = [(b, a, *between, 0.0) for b in range(len(standing)) for a in range(b)]
    return (
        bodies,
        np.array(points, POINT),
        np.array(rims, RIM),
        planes_of(standing, room),
        np.array(pairs, PAIR),
        np.array(faces, FACE),
        np.array(loops, np.int64),
        np.array(edges, np.int64).reshape(-1, 2),
    )


def _add(
    body: Any,
    solid: Solid,
    points: list[tuple[Any, ...]],
    rims: list[tuple[Any, ...]],
    faces: list[tuple[Any, ...]],
    loops: list[int],
    edges: list[tuple[int, int]],
) -> None:
    """Fill in a SOLID, and add its points, rims, faces and edges."""
    moments, axes = solid.principal
    about = solid.centre_of_gravity

    def own(place: NDArray[np.float64]) -> NDArray[np.float64]:
        return (place - about) @ axes

    vertices = own(solid.vertices)
    first = len(points)
    on_rim: NDArray[np.bool_] = np.any(on_rims(solid), axis=0)
    lowest = solid.vertices[:, 2] <= solid.vertices[:, 2].min() + 1e-6
    on_floor = ~on_rim if solid.feet is None else ~on_rim & ~lowest
    body["mass"] = solid.mass
    body["i1"], body["i2"], body["i3"] = moments
    body["first_point"], body["hull"] = first, len(vertices)
    points += [(*v, int(f), int(not r)) for v, f, r in zip(vertices, on_floor, on_rim, strict=True)]
    if solid.feet is not None:
        points += [(*v, 1, 0) for v in own(solid.feet)]
    body["points"] = len(points) - first
    body["radius"] = np.linalg.norm(vertices, axis=1).max()
    body["first_rim"], body["rims"] = len(rims), len(solid.rims)
    for rim in solid.rims:
        lies_low = solid.feet is not None and rim[2] <= solid.vertices[:, 2].min() + 1e-6
        rims.append((*own(rim[:3]), *(rim[3:6] @ axes), rim[6], int(not lies_low), 1))
    body["first_face"], body["faces"] = len(faces), len(solid.faces)
    body["first_edge"] = len(edges)
    for face in solid.faces:
        faces.append((*face_normal(vertices[face]), len(loops), len(face)))
        loops += [first + int(i) for i in face]
        around = zip(face, np.roll(face, -1), strict=True)
        edges += [(first + int(i), first + int(j)) for i, j in around if i < j]
    body["edges"] = len(edges) - body["first_edge"]


def face_normal(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the outward normal of a face (Newell's method, which bears corners nearly on a line)."""
    n = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    return n / np.linalg.norm(n)


def on_rims(solid: Solid) -> NDArray[np.bool_]:
    """Return which corners lie on which rim, shape (rims, n): planes meet the rim itself."""
    found = np.zeros((len(solid.rims), len(solid.vertices)), np.bool_)
    for own, rim in zip(found, solid.rims, strict=True):
        arms = solid.vertices - rim[:3]
        along = arms @ rim[3:6]
        across = np.linalg.norm(arms - along[:, np.newaxis] * rim[3:6], axis=1)
        own[:] = (np.abs(along) <= 1e-6) & (np.abs(across - rim[6]) <= 0.01 * rim[6])
    return found


def planes_of(standing: Sequence[Standing], room: Room) -> NDArray[np.void]:
    """Return the floor, the walls at either end of x, their gaps from what is outermost, and the ceiling."""
    floor = room.floor
    law = floor.static_friction, floor.kinetic_friction, floor.normal_restitution
    planes: list[tuple[Any, ...]] = [(0.0, 0.0, 1.0, 0.0, *law, 1)]
    back, front = zip(*(one.depth for one in standing), strict=True)
    walls = (1.0, room.left_wall, min(back)), (-1.0, room.right_wall, max(front))
    for inwards, wall, outermost in walls:
        if wall is not None:
            law = wall.friction, wall.friction, wall.restitution
            planes.append((inwards, 0.0, 0.0, inwards * outermost - wall.gap, *law, 0))
    if room.ceiling is not None:
        above = room.ceiling
        planes.append((0.0, 0.0, -1.0, -above.height, above.friction, above.friction, above.restitution, 0))
    return np.array(planes, PLANE)


def refuse_overlaps(world: tuple[Any, ...], gaps: NDArray[np.float64]) -> None:
    """Raise `InputError` where a body begins inside the floor, the ceiling or another.

    Parameters
    ----------
    world : tuple
        Bodies and room, from `world_of`.
    gaps : ndarray, shape (features,)
        Gaps as the engine notes them: of points and rims from each plane, then of pairs of bodies.
    """
    bodies, points, rims, planes, pairs = world[:5]
    alone = len(planes) * (len(points) + len(rims))
    for plane, apart in zip(planes, gaps[:alone].reshape(len(planes), -1), strict=True):
        for number, body in enumerate(bodies):
            own = slice(body["first_point"], body["first_point"] + body["points"])
            first_rim = len(points) + body["first_rim"]
            round_edges = slice(first_rim, first_rim + body["rims"])
            least = min(apart[own].min(), apart[round_edges].min(initial=np.inf))
            if least < -DEEPEST:
                surface = phrase("simulation.floor" if plane["floor"] else "simulation.ceiling")
                raise InputError(
                    "simulation.begins_inside", "bodies", number=number, surface=surface, depth=-least
                )
    for pair, apart in zip(pairs, gaps[alone:], strict=True):
        if apart < -DEEPEST:
            first, second = sorted((int(pair["a"]), int(pair["b"])))
            raise InputError(
                "simulation.begin_in_each_other", "bodies", first=first, second=second, depth=-apart
            )


def scratch_of(world: tuple[Any, ...]) -> tuple[NDArray[Any], ...]:
    """Return the working memory of `run_in_space`; all contacts stick at first."""
    _, points, rims, planes, pairs, faces = world[:6]
    keys = len(planes) * (len(points) + RIM_POINTS * len(rims)) + MOST_TOUCHING * len(pairs)
    features = len(planes) * (len(points) + len(rims)) + len(pairs)
    kept = np.zeros((keys, 4))
    kept[:, 3] = 1.0
    # of two convex faces that cut each other half as many corners are left; by rounding it may be more
    most_corners = 4 * faces["count"].max()
    return (
        np.zeros(keys, CONTACT),
        kept,
        np.zeros((2, features)),
        np.zeros((len(points), 3)),
        np.zeros((2, most_corners, 4)),
        np.zeros((MOST_TOUCHING, 5)),
    )
