"""Convex polyhedra: hulls with polygons as faces, volume and second moments, stance; inertia tensors."""

from __future__ import annotations

import math
from collections import Counter
from itertools import combinations, permutations
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.errors import InputError
from stayput.model.parameters import SIZE_RANGE

if TYPE_CHECKING:
    from stayput.catalogue import Phrase


def inertia_of(second_moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the inertia tensor of a unit mass with these second moments, tr(S) 1 − S, shape (3, 3) [m²]."""
    return np.trace(second_moments) * np.eye(3) - second_moments


def moments_of_furniture(
    width: ArrayLike, length: ArrayLike, height: ArrayLike, inertia: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the principal moments of inertia of a piece of furniture over its mass, about x, y and z [m²].

    Along its length the mass is spread evenly. In the section it is spread as in the uniform rectangle, and
    drawn together or apart in both directions so that the moment about y is as given.

    Parameters
    ----------
    width, length, height : float or ndarray
        Sides along x, y and z [m].
    inertia : float or ndarray
        Moment of inertia about y over the mass [m²].
    """
    b, l, h, I = (np.asarray(value, np.float64) for value in (width, length, height, inertia))
    spread = I / (b * b + h * h)
    deep, tall = spread * b * b, spread * h * h
    across = l * l / 12.0
    return across + tall, deep + tall, deep + across


def uniform_cone(R: float, r: float, h: float) -> tuple[float, NDArray[np.float64]]:
    """Return where the centroid of an evenly filled truncated cone is, and its second moments.

    Integrals over the height of powers of the radius, which goes from R to r.

    Parameters
    ----------
    R, r : float
        Radius of the lower and of the upper end [m].
    h : float
        Height [m].

    Returns
    -------
    height : float
        Height of the centroid above the lower end [m].
    second_moments : ndarray, shape (3, 3)
        Mean of x xᵀ over the volume, x from the centroid, z along the axis [m²].
    """
    squares = R * R + R * r + r * r
    height = h * (R * R + 2.0 * R * r + 3.0 * r * r) / (4.0 * squares)
    across = 3.0 * (R**4 + R**3 * r + R * R * r * r + R * r**3 + r**4) / (20.0 * squares)
    along = h * h * (R * R + 3.0 * R * r + 6.0 * r * r) / (10.0 * squares) - height * height
    return height, np.diag([across, across, along])


def principal_axes(inertia: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the principal moments, shape (3,), and the rotation R, shape (3, 3), whose columns are the axes.

    The tensor is R diag(moments) Rᵀ. The axes have the order and the signs that bring R nearest to the
    identity; of a diagonal tensor it is the identity itself.

    Parameters
    ----------
    inertia : ndarray, shape (3, 3)
        A symmetric tensor.
    """
    diagonal = np.diag(np.diag(inertia))
    # what is left of rounding would turn the axes of equal moments anywhere
    slight = np.abs(inertia) <= 1e-13 * np.trace(inertia)
    tensor = np.where(slight, diagonal, inertia)
    if not (tensor - diagonal).any():
        return np.diag(inertia).copy(), np.eye(3)
    moments, axes = np.linalg.eigh(tensor)
    order = list(max(permutations(range(3)), key=lambda p: sum(abs(axes[i, p[i]]) for i in range(3))))
    moments, axes = moments[order], axes[:, order]
    axes *= np.where(np.diag(axes) < 0.0, -1.0, 1.0)
    if np.linalg.det(axes) < 0.0:
        axes[:, np.argmin(np.diag(axes))] *= -1.0
    return moments, axes


TOLERANCE = 1e-6
"""Points as near to a plane as this, as a part of the body's size, lie in it: files may have 7 digits."""

FLATTEST = 1e-9
"""Smallest volume of a body, as a part of the cube of its size."""


class Hull(NamedTuple):
    """A convex polyhedron.

    Attributes
    ----------
    vertices : ndarray, shape (n, 3)
        Its corners [m], in the order in which they were given.
    faces : tuple of ndarray
        The corners of each face, counter-clockwise as seen from outside, each from its smallest index on.
    planes : ndarray, shape (f, 4)
        Those of the faces: outward unit normal n and d, n·x ≤ d inside [m].
    """

    vertices: NDArray[np.float64]
    faces: tuple[NDArray[np.int64], ...]
    planes: NDArray[np.float64]

    @property
    def filled(self) -> UniformSolid:
        """What follows where it is filled evenly."""
        return uniform_solid(self.vertices, triangulated(self.faces))

    def inertia(self, mass: float) -> NDArray[np.float64]:
        """Return its inertia tensor where a mass fills it evenly [kg m²]."""
        return mass * inertia_of(self.filled.second_moments)


class UniformSolid(NamedTuple):
    """What follows from a shape that is filled evenly.

    Attributes
    ----------
    volume : float
        Volume [m³].
    centroid : ndarray, shape (3,)
        Its centroid [m].
    second_moments : ndarray, shape (3, 3)
        Mean of x xᵀ over the volume, x from the centroid [m²].
    """

    volume: float
    centroid: NDArray[np.float64]
    second_moments: NDArray[np.float64]


def size_of(points: NDArray[np.float64]) -> float:
    """Return the longest side of the box around points [m]."""
    return float(np.ptp(points, axis=0).max())


def check_size(points: NDArray[np.float64], field: str, hint: str | Phrase = "") -> None:
    """Refuse points whose box has a side that no body has.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        Points, finite [m].
    field : str
        The input that they are.
    hint : str or Phrase
        An aside at the end of the sentence.

    Raises
    ------
    InputError
        A side that is too short or too long.
    """
    sides = np.ptp(points, axis=0)
    low, high = SIZE_RANGE
    if not (low <= sides.min() and sides.max() <= high):
        extents = " × ".join(f"{side:.4g}" for side in sides)
        raise InputError("solids.size", field, extents=extents, low=low, high=high, hint=hint)


def convex_hull(points: NDArray[np.float64]) -> Hull:
    """Return the convex hull of points.

    Triangles that lie in a plane make one face. Points inside, within faces and within edges are left out.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        Points, finite [m].

    Raises
    ------
    InputError
        The points lie in a plane, or nearly so.
    """
    size = size_of(points)
    if len(points) == 8 and (box := _box_like(points, size)) is not None:
        return box
    from scipy.spatial import ConvexHull, QhullError  # which a body by its section needs not load

    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):
        raise InputError("solids.flat", "vertices") from None
    if hull.volume <= FLATTEST * size**3:
        raise InputError("solids.flat", "vertices")
    triangles = hull.simplices.astype(np.int64)
    # Qhull's simplices are turned either way; its normals all point outwards.
    turned = np.einsum("ij,ij->i", _normals(points, triangles), hull.equations[:, :3]) < 0.0
    triangles[turned] = triangles[turned][:, ::-1]
    grouped = _grouped(points, triangles, hull.neighbors, TOLERANCE * size)
    of_faces: list[list[list[int]]] = [[] for _ in range(grouped.max() + 1)]
    for face, triangle in zip(grouped, triangles.tolist(), strict=True):
        of_faces[face].append(triangle)
    loops = _without_straight_corners([loop for of_face in of_faces for loop in _outlines(of_face)])
    kept = np.array(sorted({corner for loop in loops for corner in loop}))
    renumbered = np.full(len(points), -1)
    renumbered[kept] = np.arange(len(kept))
    faces = sorted(_from_smallest(renumbered[loop].tolist()) for loop in loops)
    corners, numbered = points[kept], tuple(np.array(face, np.int64) for face in faces)
    return Hull(corners, numbered, planes_of_faces(corners, numbered))


_BOX_FACES = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
"""Faces of a box by the halves in which its corners lie: 1 for the upper half of x, 2 of y, 4 of z."""


def _box_like(points: NDArray[np.float64], size: float) -> Hull | None:
    """Return the hull of eight points that are the corners of a box or nearly so; None for all others.

    It is what Qhull would find, in a fraction of the time: most furniture is a box.
    """
    halves = (points > (points.min(axis=0) + points.max(axis=0)) / 2.0) @ [1, 2, 4]
    order = np.argsort(halves, kind="stable")
    if not np.array_equal(halves[order], np.arange(8)):
        return None
    faces = sorted(_from_smallest(face) for face in order[_BOX_FACES].tolist())
    loops = np.array(faces, np.int64)
    planes = planes_of_faces(points, tuple(loops))
    beyond = points @ planes[:, :3].T - planes[:, 3]
    on_face = np.zeros((8, 6), np.bool_)
    on_face[loops, np.arange(6)[:, np.newaxis]] = True
    if np.all(np.where(on_face, np.abs(beyond) <= TOLERANCE * size, beyond < -10.0 * TOLERANCE * size)):
        return Hull(points, tuple(loops), planes)
    return None


def triangulated(faces: tuple[NDArray[np.int64], ...]) -> NDArray[np.int64]:
    """Return the triangles of convex faces, shape (t, 3), turned like them."""
    return np.concatenate(
        [np.column_stack((np.full(len(face) - 2, face[0]), face[1:-1], face[2:])) for face in faces]
    )


def planes_of_faces(
    vertices: NDArray[np.float64], faces: tuple[NDArray[np.int64], ...]
) -> NDArray[np.float64]:
    """Return the planes of faces, shape (f, 4): outward unit normal n and d, n·x ≤ d inside [m].

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        Corners [m].
    faces : tuple of ndarray
        Those of each face, counter-clockwise as seen from outside.
    """
    counts = np.array([len(face) for face in faces])
    starts = np.cumsum(counts) - counts
    around = vertices[np.concatenate(faces)]
    arms = around - np.repeat(np.add.reduceat(around, starts) / counts[:, np.newaxis], counts, axis=0)
    after = np.arange(1, len(around) + 1)
    after[starts + counts - 1] = starts
    # Newell's normals: of all corners alike
    normals = np.add.reduceat(_cross(arms, arms[after]), starts)
    normals /= np.linalg.norm(normals, axis=1)[:, np.newaxis]
    heights = (around * np.repeat(normals, counts, axis=0)).sum(axis=1)
    return np.column_stack((normals, np.maximum.reduceat(heights, starts)))


def _cross(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return cross products of rows, shape (n, 3): of a few rows NumPy's takes several times as long."""
    (x, y, z), (u, v, w) = a.T, b.T
    return np.column_stack((y * w - z * v, z * u - x * w, x * v - y * u))


def enclosed_volume(vertices: NDArray[np.float64], triangles: NDArray[np.int64]) -> float:
    """Return the volume in a closed surface of triangles [m³]; negative where they are clockwise.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        Its corners [m].
    triangles : ndarray, shape (t, 3)
        Indices, counter-clockwise as seen from outside.
    """
    return float(_tetrahedra(vertices, triangles)[1].sum())


def uniform_solid(vertices: NDArray[np.float64], triangles: NDArray[np.int64]) -> UniformSolid:
    """Return volume, centroid and second moments of what a closed surface of triangles encloses.

    They are sums over the tetrahedra between a point and the triangles, of volume V and with the corners
    0, a, b, c and s = a + b + c: ∫x dV = V s/4, ∫x xᵀ dV = V (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/20.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        Its corners [m].
    triangles : ndarray, shape (t, 3)
        Indices, counter-clockwise as seen from outside.
    """
    origin = vertices.mean(axis=0)
    corners, volumes = _tetrahedra(vertices, triangles)
    sums = corners.sum(axis=1)
    volume = float(volumes.sum())
    centroid = volumes @ sums / (4.0 * volume)
    moments = np.einsum("t,tki,tkj->ij", volumes, corners, corners)
    moments += np.einsum("t,ti,tj->ij", volumes, sums, sums)
    return UniformSolid(volume, origin + centroid, moments / (20.0 * volume) - np.outer(centroid, centroid))


def _tetrahedra(
    vertices: NDArray[np.float64], triangles: NDArray[np.int64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return triangles' corners from the vertices' mean, shape (t, 3, 3), and volumes between it and them."""
    corners = (vertices - vertices.mean(axis=0))[triangles]
    return corners, np.einsum("ij,ij->i", corners[:, 0], _cross(corners[:, 1], corners[:, 2])) / 6.0


def _normals(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return normals of triangles, twice as long as their area."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return _cross(b - a, c - a)


def _grouped(
    points: NDArray[np.float64], triangles: NDArray[np.int64], neighbours: NDArray[np.int32], tolerance: float
) -> NDArray[np.int64]:
    """Return the number of each triangle's face: neighbours that lie in the plane of the largest of them."""
    normals = _normals(points, triangles)
    areas = np.linalg.norm(normals, axis=1)
    group = np.full(len(triangles), -1)
    count = 0
    for seed in np.argsort(-areas, kind="stable"):
        if group[seed] >= 0:
            continue
        group[seed] = count
        height, reach = points[triangles[seed, 0]] @ normals[seed], tolerance * areas[seed]
        waiting = [seed]
        while waiting:
            for other in neighbours[waiting.pop()]:
                if group[other] < 0 and np.all(
                    np.abs(points[triangles[other]] @ normals[seed] - height) <= reach
                ):
                    group[other] = count
                    waiting.append(other)
        count += 1
    return group


def _outlines(triangles: list[list[int]]) -> list[list[int]]:
    """Return the corners around triangles of a plane; of those that have no single outline, each by itself.

    A bulge as slight as the tolerance can leave a ring of triangles around others.
    """
    edges = {(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)}
    outer = [(start, end) for start, end in edges if (end, start) not in edges]
    after = dict(outer)
    loop = [min(after)]
    while (corner := after[loop[-1]]) != loop[0] and len(loop) < len(after):
        loop.append(corner)
    return [loop] if len(loop) == len(outer) else triangles


def _without_straight_corners(loops: list[list[int]]) -> list[list[int]]:
    """Return faces without corners that only two of them have, and without what shrinks to an edge."""
    while True:
        count = Counter(corner for loop in loops for corner in loop)
        kept = [[corner for corner in loop if count[corner] > 2] for loop in loops]
        if kept == loops:
            return loops
        loops = [loop for loop in kept if len(loop) > 2]


def _from_smallest(loop: list[int]) -> list[int]:
    """Return the same corners in the same direction, the smallest first."""
    start = loop.index(min(loop))
    return loop[start:] + loop[:start]


def up_at_rest(
    points: NDArray[np.float64], centre_of_gravity: NDArray[np.float64], tolerance: float
) -> NDArray[np.float64] | None:
    """Return what points up in the body's frame while it rests on some of its points.

    It rests on a plane through at least three of them that has none below, when G lies above the inside of
    what these span in the plane. Of several such planes the one nearest to the frame's z is taken.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        The points that may touch the floor, in the body's frame [m]; at most some dozens unless all are as
        low.
    centre_of_gravity : ndarray, shape (3,)
        G in the same frame [m].
    tolerance : float
        How far from a plane a point may be that lies in it [m].

    Returns
    -------
    ndarray, shape (3,), or None
        Unit vector; None where the body rests on no such plane.
    """
    resting = [
        up
        for up in _planes_below(points, tolerance)
        if _surrounded(
            points[points @ up <= (points @ up).min() + tolerance], centre_of_gravity, up, tolerance
        )
    ]
    return max(resting, key=lambda up: up[2], default=None)


def _planes_below(points: NDArray[np.float64], tolerance: float) -> list[NDArray[np.float64]]:
    """Return the upward unit normals of the planes through three of the points that have no point below."""
    if np.ptp(points[:, 2]) <= tolerance:
        return [np.array([0.0, 0.0, 1.0])]
    normals: list[NDArray[np.float64]] = []
    for a, b, c in combinations(points, 3):
        normal = _cross((b - a)[np.newaxis], (c - a)[np.newaxis])[0]
        length = float(np.linalg.norm(normal))
        if abs(normal[2]) <= tolerance * tolerance:  # upright, or three points in a line
            continue
        up = normal / math.copysign(length, normal[2])
        if (points @ up).min() >= a @ up - tolerance:
            normals.append(up)
    return normals


def _surrounded(
    contacts: NDArray[np.float64], point: NDArray[np.float64], up: NDArray[np.float64], tolerance: float
) -> bool:
    """Tell whether contacts in a plane lie around a point above it: no half of the directions is empty."""
    along = np.array([up[2], 0.0, -up[0]]) / math.hypot(up[0], up[2])
    from_point = contacts - point
    x, y = from_point @ along, from_point @ _cross(up[np.newaxis], along[np.newaxis])[0]
    directions = np.sort(np.arctan2(y, x)[np.hypot(x, y) > tolerance])
    if len(directions) < 3:
        return False
    ahead = np.append(directions[1:], directions[0] + 2.0 * math.pi)
    return bool((ahead - directions).max() < math.pi - 1e-9)
