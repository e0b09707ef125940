"""What stands still in a room's picture: places of people, doors and windows. They hold nothing up."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from stayput.model.floor_plan import rectangle
from stayput.report.palette import MUTED, ROLE_COLOURS
from stayput.report.scene import rounded

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.model.floor_plan import Door, FloorPlan, PersonPlace
    from stayput.simulation.space_run import SpaceRun


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
        ways = np.array([np.cross(face[1] - face[0], face[2] - face[0]) for face in self.faces]).reshape(
            -1, 3
        )
        return ways / np.linalg.norm(ways, axis=1, keepdims=True)

    def data(self) -> dict[str, Any]:
        """Return it as plain values."""
        return {
            "role": self.role,
            "ink": STILL_LOOKS[self.role].ink,
            "shade": STILL_LOOKS[self.role].shade,
            "faces_m": [[rounded(corner) for corner in face] for face in self.faces],
            "lines_m": [[rounded(corner) for corner in line] for line in self.lines],
        }


def still_of(run: SpaceRun) -> tuple[StillShape, ...]:
    """Return what is drawn of the doors, windows and places of a run's room, below its ceiling."""
    if run.plan is None:
        return ()
    return still_shapes(run.plan, math.inf if run.room.ceiling is None else run.room.ceiling.height)


def still_shapes(plan: FloorPlan, ceiling: float = math.inf) -> tuple[StillShape, ...]:
    """Return what is drawn of doors, windows and places; a ceiling, at its height [m], ends the openings."""
    found: list[StillShape] = []
    for window in plan.windows:
        top = min(window.sill + _WINDOW_HEIGHT, ceiling)
        if top > window.sill:
            found.append(_opening(plan, window.wall, (window.start, window.width), (window.sill, top)))
    for door in plan.doors:
        frame = _opening(plan, door.wall, (door.start, door.width), (0.0, min(_DOOR_HEIGHT, ceiling)))
        found.append(StillShape("door", frame.faces, (*frame.lines, *_swing(plan, door))))
    for place in plan.places:
        if place.low > 0.0:
            found.append(_box("furniture", place.corners, 0.0, place.low))
        person = _box("person", place.corners, place.low, place.high)
        found.append(person._replace(lines=(*person.lines, *_pillow(place))))
    return tuple(found)


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


def _swing(plan: FloorPlan, door: Door) -> list[NDArray[np.float64]]:
    """Return on the floor the leaf of a door that opens inwards, and the way of its edge."""
    if door.opens != "inwards":
        return []
    hinge, way = (door.start, 1.0) if door.hinge == "start" else (door.start + door.width, -1.0)
    angles = np.linspace(0.0, 0.5 * math.pi, _ARC + 1).tolist()
    edge = [
        plan.on_wall(door.wall, hinge + way * door.width * math.cos(angle), door.width * math.sin(angle))
        for angle in angles
    ]
    return [_on_floor(edge), _on_floor([plan.on_wall(door.wall, hinge), edge[-1]])]


def _on_floor(points: Sequence[tuple[float, float]]) -> NDArray[np.float64]:
    return np.column_stack((points, np.zeros(len(points))))


def _closed(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.concatenate([corners, corners[:1]])
