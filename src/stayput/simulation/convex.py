"""Convex bodies, and whether they are apart or inside each other.

Two convex bodies are apart where an axis separates them: the normal of a face of one, or the cross product of
an edge of each (Gottschalk, Lin and Manocha 1996). The largest gap along such an axis is never more than the
distance, and below 0 exactly where they overlap; its rate just before they touch is how fast they close.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.model.floor_plan import PersonPlace, rectangle

if TYPE_CHECKING:
    from stayput.model.solid import Solid
    from stayput.simulation.piece import Piece

SLIGHT = 1e-6
"""Length of a cross product of two unit vectors up to which they are parallel."""

PARALLEL = 1e-9
"""Largest difference of the parts of two unit vectors that count as parallel."""


@dataclass(frozen=True, slots=True, eq=False)
class ConvexShape:
    """A convex body for questions of where it is.

    Parameters
    ----------
    corners : ndarray, shape (n, 3)
        From its centre of gravity, along the axes of its frame [m].
    normals, edges : ndarray, shape (f, 3) and (e, 3)
        Directions of its faces and of its edges, no two of them parallel.
    mass : float
        Mass [kg].
    inertia : ndarray, shape (3, 3)
        About the centre of gravity [kg m²].
    """

    corners: NDArray[np.float64]
    normals: NDArray[np.float64]
    edges: NDArray[np.float64]
    mass: float
    inertia: NDArray[np.float64]

    @classmethod
    def of(cls, solid: Solid) -> ConvexShape:
        """Return that of a solid."""
        edges = np.concatenate(
            [solid.vertices[np.roll(face, -1)] - solid.vertices[face] for face in solid.faces]
        )
        edges = edges / np.linalg.norm(edges, axis=1)[:, np.newaxis]
        return cls(
            solid.vertices - solid.centre_of_gravity,
            _different(solid.normals),
            _different(edges),
            solid.mass,
            solid.inertia,
        )


def _different(directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return unit vectors without those that are parallel to one before."""
    different: list[NDArray[np.float64]] = []
    for direction in directions:
        if not any(1.0 - abs(float(direction @ other)) <= PARALLEL for other in different):
            different.append(direction)
    return np.array(different)


class Convex(NamedTuple):
    """A convex body at k samples: corners (k, n, 3), directions of faces (k, f, 3) and of edges (k, e, 3)."""

    corners: NDArray[np.float64]
    normals: NDArray[np.float64]
    edges: NDArray[np.float64]


def separation(body: Convex, other: Convex) -> NDArray[np.float64]:
    """Return the largest gap along any axis that may separate two bodies [m], shape (k,)."""
    crossed = np.cross(body.edges[:, :, np.newaxis], other.edges[:, np.newaxis])
    crossed = crossed.reshape(len(crossed), -1, 3)
    size = np.linalg.norm(crossed, axis=2)
    slight = size <= SLIGHT
    crossed = crossed / np.where(slight, 1.0, size)[..., np.newaxis]
    axes = np.concatenate([body.normals, other.normals, crossed], axis=1)
    first, second = (convex.corners @ np.swapaxes(axes, 1, 2) for convex in (body, other))
    gaps = np.maximum(first.min(axis=1) - second.max(axis=1), second.min(axis=1) - first.max(axis=1))
    faces = body.normals.shape[1] + other.normals.shape[1]
    gaps[:, faces:][slight] = -np.inf  # parallel edges span no axis
    return gaps.max(axis=1)


def box_of(place: PersonPlace, count: int) -> Convex:
    """Return the place of a person at so many samples."""
    plan = rectangle(place.at, place.width, place.length, place.heading)
    corners = np.concatenate([np.column_stack((plan, np.full(4, z))) for z in (place.low, place.high)])
    sides = np.diff(plan[:3], axis=0) / np.linalg.norm(np.diff(plan[:3], axis=0), axis=1)[:, np.newaxis]
    axes = np.concatenate([np.column_stack((sides, np.zeros(2))), [[0.0, 0.0, 1.0]]])
    corners, axes = (np.broadcast_to(values, (count, *values.shape)) for values in (corners, axes))
    return Convex(corners, axes, axes)


def inside_each_other(piece: Piece, other: Piece | PersonPlace) -> float:
    """Return how deep a piece stands in another, or where a person is, at first [m]; 0 where it does not."""
    box = box_of(other, 1) if isinstance(other, PersonPlace) else _at_first(other)
    return max(0.0, -float(separation(_at_first(piece), box)[0]))


def _at_first(piece: Piece) -> Convex:
    shape = ConvexShape.of(piece.solid)
    corners, normals, edges = (
        values[np.newaxis] @ piece.turn.T for values in (shape.corners, shape.normals, shape.edges)
    )
    return Convex(corners + piece.place, normals, edges)
