"""Items on a shelf as cases of the planar mechanics: what slides and topples there, and what that means.

In the shelf's axes an item is a body on a floor. The board behind it is a wall on the left. A lip is a wall
on the right that meets the item's front only as high up as the lip is: the corner of the section that hits it
is moved down from the item's top, so that the item is stopped at its foot and topples over the lip.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.mechanics import columns as col
from stayput.model.body import Body
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.simulation.flat_fields import case_rows, flat_fields
from stayput.uncertainty import Lognormal, Uncertainty

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.contents.contents import Contents
    from stayput.simulation.flat_fields import NumberOrColumn

DRAWN = Uncertainty(
    {"friction": Lognormal(1.0, 0.2, low=0.3, high=3.0), "height": Lognormal(1.0, 0.15, low=0.5, high=1.5)}
)
"""Factors on friction and height of each item; low confidence."""

SEED = 1
"""Seed of the items' draws, the same for all pieces, motions and measures."""

_WAY_OF_A_DRAWER = 0.9
"""Part of its depth that a drawer without a stop comes out before it falls."""

_UPRIGHT_DRAWER = 50.0
"""Width over height with which a drawer does not tip: its runners hold it level."""


class Items(NamedTuple):
    """Items on the shelves of a piece.

    Attributes
    ----------
    cases : ndarray of CASE, shape [shelves, items]
        Each item in the axes of its shelf.
    middle : tuple of float
        Centre of gravity of a usual item: right of the middle of the piece, above its shelf [m].
    front : float
        Clear distance to the front edge [m].
    way : float
        Slide with which the centre of gravity is beyond the edge, or the drawer out of its runners [m].
    blocked : bool
        Whether a lip keeps things from sliding out.
    """

    cases: NDArray[np.void]
    middle: tuple[float, float]
    front: float
    way: float
    blocked: bool


def items_of(contents: Contents, body: Body, gravity: float) -> Items:
    """Return the items in a piece with its doors open.

    Parameters
    ----------
    contents : Contents
        What is in it.
    body : Body
        The piece, with its contents.
    gravity : float
        g [m/s²].
    """
    in_drawers = contents.drawers != "none"
    width, height = contents.item_size(body)
    front, behind = contents.places(body)
    static, kinetic = contents.friction
    way = _WAY_OF_A_DRAWER * width if in_drawers else front + 0.5 * width
    blocked = contents.lip > 0.0 and not in_drawers
    # A way back that is longer than the way out would hide which of the two the largest slide was.
    left = Wall(min(behind, way), contents.restitution) if contents.back else None
    room = Room(
        Floor(static, kinetic),
        left_wall=left,
        right_wall=Wall(front, contents.restitution) if blocked else None,
    )
    # The mass has no effect: an item does not move the piece.
    section = Body(width, width / _UPRIGHT_DRAWER if in_drawers else height, 100.0)
    shape = (contents.levels, contents.items)
    drawn = DRAWN.sample(contents.items, SEED, motions=contents.levels)
    factors = {name: values.ravel() for name, values in drawn.items()}
    numbers: dict[str, NumberOrColumn] = {**flat_fields(section, room, State(), gravity)}
    heights = np.full(shape, section.height).ravel()
    if not in_drawers:
        heights = np.minimum(factors["height"] * heights, body.height / contents.levels)
    numbers["body.height"] = heights
    for name in ("static_friction", "kinetic_friction"):
        numbers[f"room.floor.{name}"] = factors["friction"] * numbers[f"room.floor.{name}"]
    cases = case_rows(numbers, heights.size)
    if blocked:
        cases["v"][:, 3] = np.minimum(contents.lip, heights) - 0.5 * heights
    middle = 0.5 * (body.width - width) - front
    return Items(cases.reshape(shape), (middle, 0.5 * section.height), front, way, blocked)


def out_of_shelf(items: Items, cases: NDArray[np.void], results: NDArray[np.void]) -> NDArray[np.bool_]:
    """Return which items came out: they slid with their centre of gravity over an edge, or toppled over it.

    A lip holds the foot of an item nearer to the edge than that, and lets out what topples over it.

    Parameters
    ----------
    items : Items
        The items.
    cases : ndarray of CASE, shape [n]
        Some of them.
    results : ndarray of RESULT, shape [n]
        What became of these.
    """
    slid = results["peak_slide"] > items.way
    side = np.sign(results["residual_tilt"])
    to_an_edge = toppled(results) & ((side > 0.0) | np.isinf(cases["left_distance"]))
    half = -cases["v"][:, 0]  # where the centre of gravity of a lying item is beyond its foot
    over = side * results["residual_slide"] + half > items.front
    return slid | (to_an_edge & (over | (items.blocked & (side > 0.0))))


def toppled(results: NDArray[np.void]) -> NDArray[np.bool_]:
    """Return which items turned over, to any side."""
    return results["outcome"] == col.OVERTURNED_OUTCOME


def uncovered(slides: float, leaf: float) -> float:
    """Return the part of the front that two sliding doors leave open, each of which covers half.

    Parameters
    ----------
    slides : float
        Largest slide of a leaf [m].
    leaf : float
        Its width [m].
    """
    return 0.5 * min(slides / leaf, 1.0) if math.isfinite(slides) else 0.5
