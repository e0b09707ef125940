"""What is drawn of a solid: faces, sharp edges, and marks that tell its front and how far it has rolled."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.model.floor_plan import Door, FloorPlan, PersonPlace, rectangle
from stayput.report.palette import MUTED, ROLE_COLOURS
from stayput.simulation.space_records import on_rims

if TYPE_CHECKING:
    from stayput.model.solid import Solid
    from stayput.simulation.run import Run


_PANEL = 0.82
"""Size of the panel on the front, of that of the face."""

_ARROW = 0.2
"""Half the length of the arrow on the top, of the shorter side of the body in plan."""

_STRIPE = 0.12
"""Half the width of the stripe along a round side, in radii."""

_FACING = 0.7
"""A face whose unit normal has at least this along an axis looks that way."""


LENGTH_DIGITS = 5
"""Digits of lengths [m] in a scene's data: 0.01 mm."""


def rounded(values: NDArray[np.float64], digits: int = LENGTH_DIGITS) -> list[float]:
    """Return values as a list with so many digits after the point; −0 is 0."""
    return (np.round(values, digits) + 0.0).tolist()


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
    on = on_rims(solid)
    # faces that join two round edges: all of their corners lie on rims, but not on one
    curved = np.array(
        [on[:, face].any(axis=0).all() and not on[:, face].all(axis=1).any() for face in solid.faces]
    )
    return SolidShape(solid, curved, _edges(solid.faces, curved), tuple(_marks(solid, curved)))


def _edges(faces: Sequence[NDArray[np.int64]], curved: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Return the edges that are not between two faces of a round side, shape (k, 2)."""
    beside: dict[tuple[int, int], list[bool]] = {}
    for face, is_curved in zip(faces, curved.tolist(), strict=True):
        for i, j in zip(face.tolist(), np.roll(face, -1).tolist(), strict=True):
            beside.setdefault((min(i, j), max(i, j)), []).append(is_curved)
    return np.array([edge for edge, sides in beside.items() if not all(sides)], np.int64)


def _marks(solid: Solid, curved: NDArray[np.bool_]) -> list[Mark]:
    vertices, normals, marks = solid.vertices, solid.normals, list[Mark]()
    if curved.any():
        front = vertices[solid.faces[int(np.argmax(normals[:, 0]))], 0].mean()
        for face in np.flatnonzero(curved & (normals[:, 0] > _FACING)):
            half, stripe = _STRIPE * front, vertices[solid.faces[face]]
            for side in (1.0, -1.0):
                stripe = cut(stripe, half - side * stripe[:, 1])
            if len(stripe) > 2:
                marks.append(Mark(int(face), stripe, light=True))
    front_face, _, top = np.argmax(normals, axis=0).tolist()
    middles = [0.5 * (vertices[face].min(axis=0) + vertices[face].max(axis=0)) for face in solid.faces]
    if not curved.any() and normals[front_face, 0] > _FACING:
        corners, middle = vertices[solid.faces[front_face]], middles[front_face]
        marks.append(Mark(front_face, middle + _PANEL * (corners - middle), light=True))
    if normals[top, 2] > _FACING:
        corners, middle = vertices[solid.faces[top]], middles[top]
        reach = _ARROW * float(np.ptp(corners[:, :2], axis=0).min())
        plan = reach * np.array([(1.2, 0.0), (-0.8, 1.0), (-0.3, 0.0), (-0.8, -1.0)])
        slope = -normals[top, :2] / normals[top, 2]
        marks.append(Mark(top, middle + np.column_stack((plan, plan @ slope)), light=False))
    return marks


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
    for corner, here, (other, there) in zip(corners, inside.tolist(), following, strict=True):
        if here >= 0.0:
            kept.append(corner)
        if here * there < 0.0:
            kept.append(corner + here / (here - there) * (other - corner))
    return np.array(kept).reshape(-1, 3)


class StillLook(NamedTuple):
    """How something that stands still is drawn.

    Parameters
    ----------
    ink : str
        Its colour in browsers, of report/canvas/inks.css.
    colour : str
        That of the light theme, for pictures.
    shade : float
        How opaque its faces are.
    """

    ink: str
    colour: str
    shade: float


STILL_LOOKS = {
    "furniture": StillLook("muted", MUTED, 0.14),
    "person": StillLook("record", ROLE_COLOURS["tie"], 0.22),
    "door": StillLook("muted", MUTED, 0.1),
    "window": StillLook("record", ROLE_COLOURS["tie"], 0.1),
}
"""The look of each role."""

OPENINGS = ("door", "window")
"""The roles of what is in a wall."""

_DOOR_HEIGHT = 2.0  # plans do not say how high doors and windows reach [m]
_WINDOW_HEIGHT = 1.2
_LYING = 0.5  # whoever takes less height than this lies, and has a pillow [m]
_ARC = 12  # sides of the line that the edge of a door's leaf makes


class StillShape(NamedTuple):
    """Faces and lines of something that does not move.

    Parameters
    ----------
    role : str
        A key of `STILL_LOOKS`.
    faces : tuple of ndarray, shape (k, 3)
        Convex polygons, counter-clockwise as seen from outside [m].
    lines : tuple of ndarray, shape (k, 3)
        Lines from point to point [m].
    """

    role: str
    faces: tuple[NDArray[np.float64], ...]
    lines: tuple[NDArray[np.float64], ...]

    @property
    def points(self) -> NDArray[np.float64]:
        """All corners, shape (k, 3) [m]."""
        return np.concatenate([*self.faces, *self.lines])

    @property
    def normals(self) -> NDArray[np.float64]:
        """Unit normals of the faces, shape (faces, 3)."""
        ways = [np.cross(face[1] - face[0], face[2] - face[0]) for face in self.faces]
        return np.array([way / np.linalg.norm(way) for way in ways]).reshape(-1, 3)

    def data(self) -> dict[str, Any]:
        """Return it as plain values."""
        return {
            "role": self.role,
            "ink": STILL_LOOKS[self.role].ink,
            "shade": STILL_LOOKS[self.role].shade,
            "faces_m": [[rounded(corner) for corner in face] for face in self.faces],
            "lines_m": [[rounded(corner) for corner in line] for line in self.lines],
        }


def still_of(run: Run) -> tuple[StillShape, ...]:
    """Return what is drawn of the doors, windows and places of a run's room; a ceiling ends the openings."""
    if (plan := run.plan) is None:
        return ()
    ceiling = math.inf if run.room.ceiling is None else run.room.ceiling.height
    shapes: list[StillShape] = []
    for window in plan.windows:
        top = min(window.sill + _WINDOW_HEIGHT, ceiling)
        if top > window.sill:
            shapes.append(_opening(plan, window.wall, (window.start, window.width), (window.sill, top)))
    for door in plan.doors:
        frame = _opening(plan, door.wall, (door.start, door.width), (0.0, min(_DOOR_HEIGHT, ceiling)))
        swing = swing_of(plan, door, _ARC) if door.opens == "inwards" else ()
        on_floor = (np.column_stack((line, np.zeros(len(line)))) for line in swing)
        shapes.append(StillShape("door", frame.faces, (*frame.lines, *on_floor)))
    for place in plan.places:
        if place.low > 0.0:
            shapes.append(_box("furniture", place.corners, 0.0, place.low))
        person = _box("person", place.corners, place.low, place.high)
        shapes.append(person._replace(lines=(*person.lines, *_pillow(place))))
    return tuple(shapes)


def _box(role: str, corners: NDArray[np.float64], low: float, high: float) -> StillShape:
    """Return a box above a rectangle of the floor: its sides, its top and its edges."""
    bottom, top = (np.column_stack((corners, np.full(4, height))) for height in (low, high))
    sides = [np.array([bottom[i], bottom[j], top[j], top[i]]) for i, j in ((0, 1), (1, 2), (2, 3), (3, 0))]
    edges = [np.array([bottom[i], top[i]]) for i in range(4)]
    return StillShape(role, (*sides, top), (_closed(bottom), _closed(top), *edges))


def _pillow(place: PersonPlace) -> list[NDArray[np.float64]]:
    """Return the outline of a pillow at the head of whoever lies there."""
    if place.high - place.low > _LYING:
        return []
    cos, sin, away = math.cos(place.heading), math.sin(place.heading), 0.38 * place.length
    middle = (place.at[0] + sin * away, place.at[1] - cos * away)
    corners = rectangle(middle, 0.62 * place.width, 0.14 * place.length, place.heading)
    return [_closed(np.column_stack((corners, np.full(4, place.high))))]


def _opening(
    plan: FloorPlan, wall: str, along: tuple[float, float], heights: tuple[float, float]
) -> StillShape:
    """Return a rectangle on a wall, from where it begins along it and how wide it is."""
    start, width = along
    low, high = heights
    ends = [plan.on_wall(wall, at) for at in (start, start + width)]
    first, last = ends if wall in ("left_wall", "far_side_wall") else ends[::-1]
    frame = np.array([(*first, low), (*last, low), (*last, high), (*first, high)])
    return StillShape("window", (frame,), (_closed(frame),))


def swing_of(plan: FloorPlan, door: Door, parts: int) -> tuple[list[tuple[float, float]], ...]:
    """Return the way of the edge of a door's leaf, in so many parts, and the open leaf [m]."""
    hinge, way = (door.start, 1.0) if door.hinge == "start" else (door.start + door.width, -1.0)
    into = -door.width if door.opens == "outwards" else door.width
    turned = [(math.cos(angle), math.sin(angle)) for angle in np.linspace(0.0, 0.5 * math.pi, parts + 1)]
    edge = [plan.on_wall(door.wall, hinge + way * door.width * x, into * y) for x, y in turned]
    return edge, [plan.on_wall(door.wall, hinge), edge[-1]]


def _closed(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.concatenate([corners, corners[:1]])
