"""Items on a shelf, and the doors and drawers in front of them, as cases of the planar mechanics.

In the shelf's axes an item is a body on a floor. The board behind it is a wall on the left. A lip is a wall
on the right that meets the item's front only as high up as the lip is: the corner of the section that hits it
is moved down from the item's top, so that the item is stopped at its foot and topples over the lip.

A hinged door with its contents behind it pushes on its catch with, at the free edge of each of two leaves,

    F = ¼ (m_d [−a]⁺ + Σ m_i [−a − μ' n]⁺)

with a along the shelves and n perpendicular to them, as `stayput.contents.carrier` has them: the door by its
inertia, the contents with what friction on their shelves does not hold; half of each on a leaf, at its
middle. A drawer pushes on its own catch with m [−a − μ' n]⁺. The catch lets go where the mean of this force
over `CATCH_TIME` is more than it holds. Blows of sliding contents on a door are left out, and a door that has
opened stays open.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics import columns as col
from stayput.mechanics.runner import Shaking, run_cases
from stayput.model.body import Body
from stayput.model.flat_fields import NumberOrColumn, case_columns, case_rows, flat_fields
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.uncertainty import Lognormal, Uncertainty

if TYPE_CHECKING:
    from stayput.contents.carrier import PointMotion
    from stayput.contents.contents import Contents

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


CATCH_TIME = 0.02
"""Time over which the force on a catch is averaged [s]; low confidence.

A catch lets go over a way of some 2 mm, which takes so long at 1 g: a blow that is shorter does not open it.
"""

GROOVE = (0.15, 0.12)
"""Static and kinetic friction of sliding doors in their grooves; low confidence."""


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


def opening_samples(
    contents: Contents, points: Sequence[PointMotion], masses: Sequence[float], gravity: float, dt: float
) -> NDArray[np.intp]:
    """Return the sample from which each shelf is open, shape [shelves]; the number of samples where never.

    Parameters
    ----------
    contents : Contents
        What is in the piece.
    points : sequence of PointMotion
        How each shelf moves.
    masses : sequence of float
        Mass on each [kg].
    gravity : float
        g [m/s²].
    dt : float
        Time between the samples [s].
    """
    count = len(points[0].along)
    if contents.doors.startswith("hinged"):
        pushes = sum(_push(contents, *shelf, gravity) for shelf in zip(points, masses, strict=True))
        door = contents.door_mass * np.maximum(0.0, -points[len(points) // 2].along)
        forces = [0.25 * (door + pushes)] * len(points)
    elif contents.drawers == "catches":
        forces = [_push(contents, *shelf, gravity) for shelf in zip(points, masses, strict=True)]
    else:
        return np.zeros(len(points), np.intp)
    window = np.full(max(1, round(CATCH_TIME / dt)), 1.0)
    means = [np.convolve(force, window / len(window))[:count] for force in forces]
    lets_go = np.stack(means) > contents.holding_force
    return np.where(lets_go.any(axis=1), lets_go.argmax(axis=1), count)


def _push(contents: Contents, point: PointMotion, mass: float, gravity: float) -> NDArray[np.float64]:
    """Return the force of what friction does not hold, forwards [N], shape [n]."""
    pressure = np.maximum(0.0, point.up + gravity)
    return mass * np.maximum(0.0, -point.along - contents.friction[1] * pressure)


def slide_of_a_leaf(contents: Contents, shaken: Shaking, gravity: float) -> float:
    """Return how far the leaf of a sliding door runs [m].

    It runs across the shaking that is computed; that along its groove is taken to be as strong, and the same.

    Parameters
    ----------
    contents : Contents
        What is in the piece.
    shaken : Shaking
        How the shelf in the middle moves.
    gravity : float
        g [m/s²].
    """
    stop = Wall(contents.leaf, 0.0)
    body = Body(1.0, 0.02, 100.0)  # its mass has no effect
    leaf = case_columns(body, Room(Floor(*GROOVE), Wall(0.0, 0.0), stop), State(), gravity)
    return float(run_cases(leaf, shaken)["peak_slide"][0])
