"""Measures as simple shapes, to scale: what a picture draws of them, whole or broken.

A point of a shape goes with the body or with the room, so that a device between the two stretches as the
body moves. A picture needs nothing else: each point is turned and moved with its frame.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from stayput.measures.element import Element, at_rest
from stayput.model.room import Room, Wall
from stayput.model.state import wall_faces

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from stayput.measures.measure import Held, Measure
    from stayput.model.body import Body

Point: TypeAlias = "tuple[Literal['body', 'room'], float, float]"
"""A frame and a place in it [m]: from the middle of the base in the body's axes, or in the room."""

Role = Literal["tie", "pad", "rubber", "metal", "wheel", "mass"]
"""What a shape is made of, for its colour."""


@dataclass(frozen=True, slots=True)
class Shape:
    """A line or a filled outline.

    Attributes
    ----------
    kind : str
        "line" or "polygon".
    points : tuple
        Its points.
    role : str
        What it is made of.
    element : int or None
        The place of the element that it shows, in the list of elements.
    when : str
        "always", or while the element is "whole" or "broken".

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Chain, hold, sketch
    >>> held = hold(sp.Body(0.4, 1.8, 100.0), sp.Room(left_wall=sp.Wall(0.05)), [Chain()])
    >>> for shape in sketch(held):
    ...     print(shape.kind, shape.role, shape.when)
    line tie whole
    line tie broken
    line tie broken
    """

    kind: Literal["line", "polygon"]
    points: tuple[Point, ...]
    role: Role
    element: int | None = None
    when: Literal["always", "whole", "broken"] = "always"


THIN = 0.018
"""Sheets and pads are drawn so thick that they are seen [m]."""

STUB = 0.3
"""Part of a device that stays at either end once it is broken."""

SHORTEST_STUB = 0.06
"""What stays of a short device is no less than this, or half of it [m]."""


def _box(
    left: float,
    low: float,
    right: float,
    high: float,
    role: Role,
    frame: Literal["body", "room"] = "body",
    n: int | None = None,
) -> Shape:
    corners = ((left, low), (right, low), (right, high), (left, high))
    return Shape("polygon", tuple((frame, x, z) for x, z in corners), role, n)


def _between(
    n: int, body: Body, point: tuple[float, float], anchor: tuple[float, float], role: Role
) -> list[Shape]:
    """Return a line from a point of the body to one of the room, and what is left of it once it broke."""
    x, z = at_rest(body, point)
    far = math.dist((x, z), anchor)
    share = min(0.5, max(STUB, SHORTEST_STUB / far)) if far > 0.0 else 0.0
    right, up = share * (anchor[0] - x), share * (anchor[1] - z)
    held: Point = ("body", *point)
    fixed: Point = ("room", *anchor)
    return [
        Shape("line", (held, fixed), role, n, "whole"),
        Shape("line", (held, ("body", point[0] + right, point[1] + up)), role, n, "broken"),
        Shape("line", (fixed, ("room", anchor[0] - right, anchor[1] - up)), role, n, "broken"),
    ]


def _to_wall(n: int, element: Element, body: Body, room: Room) -> list[Shape]:
    """Return a bracket: an arm to the wall and a leg on it."""
    _, z = at_rest(body, element.point)
    wall = _face(body, room)
    leg = min(0.06, 0.5 * body.height)
    plate = Shape("line", (("room", wall, z), ("room", wall, z - leg)), "metal", n)
    inside = element.point[0] + min(0.06, 0.5 * body.width)
    arm = Shape("line", (("body", *element.point), ("body", inside, element.point[1])), "metal", n)
    return [plate, arm, *_between(n, body, element.point, (wall, z), "metal")]


def _face(body: Body, room: Room) -> float:
    """Return the place of the wall behind [m]."""
    return wall_faces(body, replace(room, left_wall=room.left_wall or Wall(0.0)))[0]


def _tie(n: int, element: Element, body: Body, room: Room) -> list[Shape]:
    """Return a line from the body to the anchor, for any device that has no picture of its own."""
    right, up = element.to_anchor or (0.0, 0.0)
    x, z = at_rest(body, element.point)
    return _between(n, body, element.point, (x + right, z + up), "tie")


def _pole(n: int, element: Element, body: Body, room: Room) -> list[Shape]:
    assert room.ceiling is not None
    (x, _), top, half = at_rest(body, element.point), room.ceiling.height, 0.035
    u, v = element.point
    plates = [
        Shape("line", (("room", x - half, top - 0.01), ("room", x + half, top - 0.01)), "metal", n, "whole"),
        Shape("line", (("body", u - half, v + 0.01), ("body", u + half, v + 0.01)), "metal", n, "whole"),
    ]
    return [*plates, *_between(n, body, element.point, (x, top), "metal")]


def _gel(n: int, element: Element, body: Body, room: Room) -> list[Shape]:
    """Return a pad: a box that stretches between body and floor, and what is left on the floor of it."""
    u, v = element.point
    inner, thick = u - math.copysign(0.06, u), THIN
    x0, x1 = at_rest(body, (u, v))[0], at_rest(body, (inner, v))[0]
    floor: tuple[Point, ...] = (("room", x1, -thick), ("room", x0, -thick))
    whole = Shape("polygon", (("body", u, v), ("body", inner, v), *floor), "pad", n, "whole")
    left = Shape("polygon", (*floor, ("room", x0, 0.0), ("room", x1, 0.0)), "pad", n, "broken")
    return [whole, left]


def _stops(n: int, element: Element, body: Body, room: Room) -> list[Shape]:
    """Return the tray and the stops on the floor at the ends of its stroke."""
    half, reach = 0.5 * body.width, 0.5 * body.width + element.normal.slack_plus
    tray = _box(-half, -0.03, half, 0.0, "metal", n=n)
    sides = ((-reach, -1.0), (reach, 1.0))
    return [tray, *(_box(x, -0.04, x + side * 0.02, 0.03, "rubber", "room", n) for x, side in sides)]


_OF_ELEMENT: dict[str, Callable[[int, Element, Body, Room], list[Shape]]] = {
    "gel_mats": _gel,
    "l_bracket": _to_wall,
    "l_bracket_board": _to_wall,
    "tension_pole": _pole,
    "base_isolator": _stops,
}


def _feet(body: Body, thick: float, role: Role) -> list[Shape]:
    half, wide = body.width / 2, min(0.04, 0.2 * body.width)
    return [_box(-half, -thick, wide - half, 0.0, role), _box(half - wide, -thick, half, 0.0, role)]


def _wheels(body: Body) -> list[Shape]:
    r, half = min(0.025, 0.2 * body.width), body.width / 2
    turns = [2.0 * math.pi * i / 16 for i in range(16)]
    return [
        Shape("polygon", tuple(("body", x + r * math.cos(t), r * math.sin(t)) for t in turns), "wheel")
        for x in (r - half, half - r)
    ]


def _of_measure(measure: Measure, body: Body) -> list[Shape]:
    half = body.width / 2
    match measure.kind:
        case "anti_slip_sheet":
            return [_box(-half, -THIN, half, 0.0, "rubber")]
        case "felt_glides" | "sliding_glides":
            return _feet(body, THIN, "pad")
        case "free_casters" | "locked_casters":
            return _wheels(body)
        case "wedge_stopper":
            front = body.base_heights[1]
            back = max(-half, half - 0.15)
            inner = front * (0.5 + back / body.width)
            nose = half + 0.03
            edge = ((back, inner), (nose, front), (nose, THIN), (half, 0.8 * THIN), (half, 0.0))
            return [Shape("polygon", tuple(("body", x, z) for x, z in edge), "rubber")]
        case "ballast":
            height: float = getattr(measure, "height")  # noqa: B009
            thick = min(0.04, height)
            return [_box(-0.9 * half, height - thick, 0.9 * half, height + thick, "mass")]
        case _:
            return []


def sketch(held: Held) -> list[Shape]:
    """Return the shapes of all measures of a body, some of which only show when a device is broken.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import WedgeStopper, hold, sketch
    >>> wedge, = sketch(hold(sp.Body(0.4, 1.8, 100.0), sp.Room(), [WedgeStopper()]))
    >>> wedge.kind, wedge.role
    ('polygon', 'rubber')
    >>> [(frame, round(x, 2), round(z, 3)) for frame, x, z in wedge.points[:3]]  # m
    [('body', 0.05, -0.004), ('body', 0.23, -0.007), ('body', 0.23, 0.018)]
    """
    drawn = [shape for measure in held.measures for shape in _of_measure(measure, held.body)]
    for n, element in enumerate(held.elements):
        drawn += _OF_ELEMENT.get(element.kind, _tie)(n, element, held.body, held.room)
    return drawn


def shapes(held: Held, x: float, z: float, tilt: float, broken: Iterable[int] = ()) -> list[dict[str, Any]]:
    """Return what a picture shows of the measures, in the room's coordinates, as plain data.

    Parameters
    ----------
    held : Held
        The body with its measures.
    x, z : float
        Where G is [m].
    tilt : float
        Tilt of the body, + clockwise [rad].
    broken : iterable of int
        Places of the elements that have failed.

    Returns
    -------
    list of dict
        ``kind``: "line" or "polygon"; ``points``: pairs (x, z) [m]; ``role``: what it is made of; ``broken``:
        whether it is what is left of a device that failed.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Ballast, hold, shapes
    >>> held = hold(sp.Body(0.4, 1.8, 60.0), sp.Room(), [Ballast()])
    >>> x, z = held.body.centre_of_gravity
    >>> for tilt in (0.0, 0.1):  # the lower left and right corner of the ballast, as the body turns [m]
    ...     points = shapes(held, x, z, tilt)[0]["points"]
    ...     print([(round(right, 2), round(up, 2)) for right, up in points[:2]])
    [(-0.18, 0.06), (0.18, 0.06)]
    [(-0.24, 0.08), (0.12, 0.05)]
    """
    gone = set(broken)
    x_g, z_g = held.body.centre_of_gravity
    sin, cos = math.sin(tilt), math.cos(tilt)

    def placed(frame: str, right: float, up: float) -> tuple[float, float]:
        if frame == "room":
            return right, up
        u, v = right - x_g, up - z_g
        return x + u * cos + v * sin, z + v * cos - u * sin

    return [
        {
            "kind": shape.kind,
            "points": [placed(*point) for point in shape.points],
            "role": shape.role,
            "broken": shape.when == "broken",
        }
        for shape in sketch(held)
        if shape.when == "always" or (shape.when == "broken") == (shape.element in gone)
    ]
