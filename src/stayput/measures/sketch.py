"""Measures as simple shapes, to scale, as they are in the room while the body rests: what drawings show."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, TypeAlias

from stayput.measures.element import Element, at_rest
from stayput.model.room import Room, Wall
from stayput.model.state import wall_faces

if TYPE_CHECKING:
    from stayput.measures.measure import Held, Measure
    from stayput.model.body import Body

Points: TypeAlias = "tuple[tuple[float, float], ...]"
"""Places in the room, or right of the middle of the base and up in the body's axes [m]."""

Role = Literal["tie", "pad", "rubber", "metal", "wheel", "mass"]
"""What a shape is made of, for its colour."""


@dataclass(frozen=True, slots=True)
class Shape:
    """A line or a filled outline.

    Attributes
    ----------
    kind : str
        "line" or "polygon".
    points : tuple of tuple of float
        Its points in the room, right and up [m].
    role : str
        What it is made of.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Chain, hold, sketch
    >>> held = hold(sp.Body(0.4, 1.8, 100.0), sp.Room(left_wall=sp.Wall(0.05)), [Chain()])
    >>> shape, = sketch(held)
    >>> print(shape.kind, shape.role)
    line tie
    >>> [(round(x, 2), round(z, 2)) for x, z in shape.points]  # from the top to the wall
    [(-0.1, 1.8), (-0.25, 1.88)]
    """

    kind: Literal["line", "polygon"]
    points: Points
    role: Role


THIN = 0.018
"""Sheets and pads are drawn so thick that they are seen [m]."""


def _box(left: float, low: float, right: float, high: float) -> Points:
    return (left, low), (right, low), (right, high), (left, high)


def _on_body(body: Body, points: Points) -> Points:
    return tuple(at_rest(body, point) for point in points)


def _to_wall(element: Element, body: Body, room: Room) -> list[Shape]:
    """Return a bracket: an arm to the wall and a leg on it."""
    (u, v), (x, z) = element.point, at_rest(body, element.point)
    wall = wall_faces(body, replace(room, left_wall=room.left_wall or Wall(0.0)))[0]
    leg, inside = min(0.06, 0.5 * body.height), u + min(0.06, 0.5 * body.width)
    lines = ((wall, z), (wall, z - leg)), _on_body(body, ((u, v), (inside, v))), ((x, z), (wall, z))
    return [Shape("line", line, "metal") for line in lines]


def _tie(element: Element, body: Body, room: Room) -> list[Shape]:
    """Return a line from the body to the anchor, for any device that has no picture of its own."""
    (right, up), (x, z) = element.to_anchor or (0.0, 0.0), at_rest(body, element.point)
    return [Shape("line", ((x, z), (x + right, z + up)), "tie")]


def _pole(element: Element, body: Body, room: Room) -> list[Shape]:
    assert room.ceiling is not None
    (u, v), (x, z), top, half = element.point, at_rest(body, element.point), room.ceiling.height, 0.035
    below = _on_body(body, ((u - half, v + 0.01), (u + half, v + 0.01)))
    lines = ((x - half, top - 0.01), (x + half, top - 0.01)), below, ((x, z), (x, top))
    return [Shape("line", line, "metal") for line in lines]


def _gel(element: Element, body: Body, room: Room) -> list[Shape]:
    """Return a pad between body and floor."""
    u, v = element.point
    outer, inner = _on_body(body, ((u, v), (u - math.copysign(0.06, u), v)))
    return [Shape("polygon", (outer, inner, (inner[0], -THIN), (outer[0], -THIN)), "pad")]


def _stops(element: Element, body: Body, room: Room) -> list[Shape]:
    """Return the tray and the stops on the floor at the ends of its stroke; nothing of what pulls it back."""
    if element.tangent.slack_plus == 0.0:
        return []
    half, reach = 0.5 * body.width, 0.5 * body.width + element.tangent.slack_plus
    sides = [_box(x, -0.04, x + side * 0.02, 0.03) for x, side in ((-reach, -1.0), (reach, 1.0))]
    tray = Shape("polygon", _on_body(body, _box(-half, -0.03, half, 0.0)), "metal")
    return [tray, *(Shape("polygon", side, "rubber") for side in sides)]


_OF_ELEMENT: dict[str, Callable[[Element, Body, Room], list[Shape]]] = {
    "gel_mats": _gel,
    "l_bracket": _to_wall,
    "l_bracket_board": _to_wall,
    "tension_pole": _pole,
    "base_isolator": _stops,
}


def _of_measure(measure: Measure, body: Body) -> tuple[Role, list[Points]]:
    """Return what a measure without devices is made of, and its outlines in the body's axes."""
    half = body.width / 2
    match measure.kind:
        case "anti_slip_sheet":
            return "rubber", [_box(-half, -THIN, half, 0.0)]
        case "felt_glides" | "sliding_glides":
            wide = min(0.04, 0.2 * body.width)
            return "pad", [_box(-half, -THIN, wide - half, 0.0), _box(half - wide, -THIN, half, 0.0)]
        case "free_casters" | "locked_casters":
            r = min(0.025, 0.2 * body.width)
            turns = [2.0 * math.pi * i / 16 for i in range(16)]
            wheel = [(r * math.cos(turn), r * math.sin(turn)) for turn in turns]
            return "wheel", [tuple((x + u, v) for u, v in wheel) for x in (r - half, half - r)]
        case "wedge_stopper":
            front = body.base_heights[1]
            back = max(-half, half - 0.15)
            inner = front * (0.5 + back / body.width)
            nose = half + 0.03
            return "rubber", [((back, inner), (nose, front), (nose, THIN), (half, 0.8 * THIN), (half, 0.0))]
        case "ballast":
            height: float = getattr(measure, "height")  # noqa: B009
            thick = min(0.04, height)
            return "mass", [_box(-0.9 * half, height - thick, 0.9 * half, height + thick)]
        case _:
            return "mass", []


def sketch(held: Held) -> list[Shape]:
    """Return the shapes of all measures of a body at rest.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import WedgeStopper, hold, sketch
    >>> wedge, = sketch(hold(sp.Body(0.4, 1.8, 100.0), sp.Room(), [WedgeStopper()]))
    >>> wedge.kind, wedge.role
    ('polygon', 'rubber')
    """
    body, room = held.body, held.room
    drawn = [
        Shape("polygon", _on_body(body, points), role)
        for measure in held.measures
        for role, outlines in [_of_measure(measure, body)]
        for points in outlines
    ]
    for element in held.elements:
        drawn += _OF_ELEMENT.get(element.kind, _tie)(element, body, room)
    return drawn
