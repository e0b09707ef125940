"""Measures as simple shapes, to scale, as they are in the room while the body rests: what drawings show."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

from stayput.measures.element import at_rest

if TYPE_CHECKING:
    from stayput.measures.measure import Held
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


def box(left: float, low: float, right: float, high: float) -> Points:
    """Return the corners of a rectangle."""
    return (left, low), (right, low), (right, high), (left, high)


def outline(body: Body, role: Role, points: Points) -> Shape:
    """Return a filled outline whose points are in the body's axes."""
    return Shape("polygon", tuple(at_rest(body, point) for point in points), role)


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
    drawn = [shape for measure in held.measures for shape in measure.outlines(held.body)]
    kinds = {measure.kind: measure for measure in held.measures}
    for element in held.elements:
        drawn += kinds[element.kind].device_shapes(element, held.body, held.room)
    return drawn
