"""What is drawn of a solid: faces, sharp edges, and marks that tell its front and how far it has rolled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.report.scene import rounded
from stayput.simulation.space_records import on_rims

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.model.solid import Solid

_PANEL = 0.82
"""Size of the panel on the front, of that of the face."""

_ARROW = 0.2
"""Half the length of the arrow on the top, of the shorter side of the body in plan."""

_STRIPE = 0.12
"""Half the width of the stripe along a round side, in radii."""

_FACING = 0.7
"""A face whose unit normal has at least this along an axis looks that way."""


@dataclass(frozen=True, slots=True, eq=False)
class Mark:
    """A polygon on a face, in the frame of the body.

    Parameters
    ----------
    face : int
        The face that it lies on.
    corners : ndarray, shape (k, 3)
        Its corners, counter-clockwise as seen from outside [m].
    light : bool
        Whether it is lighter than the body; else it is darker.
    """

    face: int
    corners: NDArray[np.float64]
    light: bool


@dataclass(frozen=True, slots=True, eq=False)
class SolidShape:
    """A solid made ready for drawing.

    Parameters
    ----------
    solid : Solid
        The body.
    curved : ndarray, shape (faces,)
        Whether a face is part of a round side, which is shaded smoothly.
    edges : ndarray, shape (k, 2)
        Corners at the ends of its sharp edges.
    marks : tuple of Mark
        A panel on the front and an arrow to it on the top; of a round body a stripe along its front.
    """

    solid: Solid
    curved: NDArray[np.bool_]
    edges: NDArray[np.int64]
    marks: tuple[Mark, ...]

    def data(self) -> dict[str, Any]:
        """Return the shape as plain values, in the body's frame."""
        return {
            "vertices_m": [rounded(vertex) for vertex in self.solid.vertices],
            "faces": [face.tolist() for face in self.solid.faces],
            "normals": [rounded(normal) for normal in self.solid.normals],
            "curved": self.curved.tolist(),
            "edges": self.edges.tolist(),
            "marks": [
                {
                    "corners_m": [rounded(corner) for corner in mark.corners],
                    "normal": rounded(self.solid.normals[mark.face]),
                    "light": mark.light,
                }
                for mark in self.marks
            ],
        }


def shape_of(solid: Solid) -> SolidShape:
    """Make a solid ready for drawing."""
    curved = _curved(solid)
    return SolidShape(solid, curved, _edges(solid.faces, curved), tuple(_marks(solid, curved)))


def _curved(solid: Solid) -> NDArray[np.bool_]:
    """Return which faces join two round edges, shape (faces,): all corners lie on rims, but not on one."""
    on = on_rims(solid)
    return np.array(
        [on[:, face].any(axis=0).all() and not on[:, face].all(axis=1).any() for face in solid.faces]
    )


def _edges(faces: Sequence[NDArray[np.int64]], curved: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Return the edges that are not between two faces of a round side, shape (k, 2)."""
    beside: dict[tuple[int, int], list[bool]] = {}
    for face, is_curved in zip(faces, curved.tolist(), strict=True):
        for i, j in zip(face.tolist(), np.roll(face, -1).tolist(), strict=True):
            beside.setdefault((min(i, j), max(i, j)), []).append(is_curved)
    return np.array([edge for edge, sides in beside.items() if not all(sides)], np.int64)


def _marks(solid: Solid, curved: NDArray[np.bool_]) -> list[Mark]:
    vertices, normals, found = solid.vertices, solid.normals, list[Mark]()
    if curved.any():
        front = vertices[solid.faces[int(np.argmax(normals[:, 0]))], 0].mean()
        for face in np.flatnonzero(curved & (normals[:, 0] > _FACING)):
            half, stripe = _STRIPE * front, vertices[solid.faces[face]]
            for side in (1.0, -1.0):
                stripe = cut(stripe, half - side * stripe[:, 1])
            if len(stripe) > 2:
                found.append(Mark(int(face), stripe, light=True))
    else:
        front_face = int(np.argmax(normals[:, 0]))
        if normals[front_face, 0] > _FACING:
            corners = vertices[solid.faces[front_face]]
            middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
            found.append(Mark(front_face, middle + _PANEL * (corners - middle), light=True))
    top = int(np.argmax(normals[:, 2]))
    if normals[top, 2] > _FACING:
        corners = vertices[solid.faces[top]]
        middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
        reach = _ARROW * float(np.ptp(corners[:, :2], axis=0).min())
        plan = reach * np.array([(1.2, 0.0), (-0.8, 1.0), (-0.3, 0.0), (-0.8, -1.0)])
        slope = -normals[top, :2] / normals[top, 2]
        found.append(Mark(top, middle + np.column_stack((plan, plan @ slope)), light=False))
    return found


def cut(corners: NDArray[np.float64], inside: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the part of a convex polygon, or of a line, on one side of a plane, shape (m, 3).

    Parameters
    ----------
    corners : ndarray, shape (k, 3)
        Its corners in order.
    inside : ndarray, shape (k,)
        How far each is on that side of the plane, negative beyond it.
    """
    kept: list[NDArray[np.float64]] = []
    following = zip(np.roll(corners, -1, axis=0), np.roll(inside, -1).tolist(), strict=True)
    for one, here, (other, there) in zip(corners, inside.tolist(), following, strict=True):
        if here >= 0.0:
            kept.append(one)
        if here * there < 0.0:
            kept.append(one + here / (here - there) * (other - one))
    return np.array(kept).reshape(-1, 3)
