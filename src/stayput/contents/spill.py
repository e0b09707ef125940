"""`spill`: what comes out of a piece of furniture, item by item; its shelves, doors and drawers in the plane.

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
from dataclasses import dataclass
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from stayput.contents.carrier import STEP, Carrier, PointMotion, parts
from stayput.contents.contents import STOPPED, Contents
from stayput.errors import InputError, instance_of, not_allowed, whole_within
from stayput.measures import element_rows, hold
from stayput.mechanics import columns as col
from stayput.mechanics.runner import Shaking, Traced, run_cases, shaking, trace
from stayput.model.body import Body
from stayput.model.flat_fields import NumberOrColumn, case_columns, case_rows, flat_fields
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.simulation.case import Case, scene_of
from stayput.simulation.many import plane_shaking
from stayput.simulation.run import Run
from stayput.uncertainty import Lognormal, Uncertainty

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


@dataclass(frozen=True, slots=True, eq=False)
class Spill:
    """What came out of a piece of furniture; made by `spill`.

    Arrays have one value for each item, shape [shelves, items], the lowest shelf first.

    Attributes
    ----------
    contents : Contents
        What was in it.
    overturned : bool
        Whether the piece itself turned over, or fell off another: then all comes out that no closed door or
        drawer holds.
    out : ndarray of bool
        Whether it came out.
    toppled : ndarray of bool
        Whether it turned over on its shelf, or over the edge.
    mass : ndarray
        Mass of each [kg].
    open_from : ndarray, shape [shelves]
        When the doors or the drawer opened [s]; inf where they stayed shut, 0 where there are none.
    time : ndarray
        When it left the shelf [s], nan where it did not; likewise the three that follow, which are nan too
        for what the piece takes with it as it turns over, and for items that were not followed.
    height : ndarray
        Height above the floor of the shelf at that time [m].
    speed : ndarray
        Horizontal velocity in the room's frame, that of its floor, + to where the piece faces [m/s].
    distance : ndarray
        How far from the edge of the shelf it lands, by free fall from there, + to the front [m].

    Examples
    --------
    >>> import stayput as sp
    >>> bookcase = sp.Body(width=0.30, height=1.80, mass=200.0)
    >>> run = sp.simulate(bookcase, sp.Room(), sp.near_fault().scaled(0.4))
    >>> spilt = sp.spill(run, sp.Contents("books"))
    >>> 0.0 <= spilt.share_out <= 1.0
    True
    """

    contents: Contents
    overturned: bool
    out: NDArray[np.bool_]
    toppled: NDArray[np.bool_]
    mass: NDArray[np.float64]
    open_from: NDArray[np.float64]
    time: NDArray[np.float64]
    height: NDArray[np.float64]
    speed: NDArray[np.float64]
    distance: NDArray[np.float64]

    @property
    def share_out(self) -> float:
        """Share of the items that came out."""
        return float(self.out.mean())

    @property
    def shelf_share_out(self) -> NDArray[np.float64]:
        """The same by shelf, shape [shelves]."""
        return self.out.mean(axis=1)

    @property
    def share_toppled(self) -> float:
        """Share of the items that turned over."""
        return float(self.toppled.mean())

    @property
    def mass_out(self) -> float:
        """Mass of what came out [kg]."""
        return float(self.mass[self.out].sum())


def spill(of: Run | Case, contents: Contents, piece: int | None = None) -> Spill:
    """Follow what is in a piece of furniture, item by item, as the piece moves.

    The items feel the motion of their shelf and do not act back on the piece: see
    `stayput.contents.contents.emptied` for bounds of what that is worth.

    Parameters
    ----------
    of : Run or Case
        The piece, where it stands, how the floor moves and what holds it. A run in space is followed at its
        samples, which must be no more than `stayput.contents.carrier.STEP` apart; a case in space is run so.
    contents : Contents
        What is in it.
    piece : int, optional
        The number of the body of a run in space of several, from 0.

    Returns
    -------
    Spill
        What came out, when and where from.

    Raises
    ------
    InputError
        The paper's contact law; loads that are heavier than the piece; a run that was given up, whose samples
        are too far apart, or whose body has a shape of its own.

    Examples
    --------
    A bookcase that brackets hold spills what it would have kept if it could move:

    >>> import stayput as sp
    >>> case = sp.Case(sp.Body(0.3, 1.8, 200.0), sp.Room(left_wall=sp.Wall(0.02)), sp.near_fault())
    >>> spill(case, sp.Contents("books")).share_out > 0.0
    True
    """
    instance_of("of", of, (Run, Case))
    instance_of("contents", contents, Contents)
    bodies = len(of.pieces) if isinstance(of, Run) else 1
    if piece is not None or bodies > 1:
        piece = whole_within("contents.piece", cast("int", piece), 0, bodies - 1, "", "piece")
    if isinstance(of, Run) and of.engine == "space":
        carrier, body = _in_run(of, piece or 0)
    else:
        carrier, body = _run_again(of)
    if carrier.failed:
        raise InputError("contents.given_up")
    return spill_of(carrier, body, contents, followed=contents.items)


def _run_again(of: Run | Case) -> tuple[Carrier, Body]:
    """Follow a piece by itself at finer samples; return it as it is held, too."""
    if of.contact != "coulomb":
        raise not_allowed("model.contact", repr(of.contact), "contents.needs_coulomb", "contact")
    if isinstance(of, Case) and of.in_space:
        return _in_space(of)
    held = of.held if isinstance(of, Run) else None
    held = hold(of.body, of.room, of.measures) if held is None else held
    case = case_columns(held.body, held.room, of.initial, of.gravity)[0]
    return Carrier.of(case, element_rows(held), plane_shaking(of.motion), held.body.height), held.body


def _in_space(of: Case) -> tuple[Carrier, Body]:
    from stayput.simulation.space import ENDS, trace_together  # SciPy takes its time to load
    from stayput.simulation.space_engine import SpaceShaking

    coarse, scene = SpaceShaking.of(of.motion), scene_of(of.body, of.room, of.measures)
    fine = coarse.refined(parts(coarse.dt))
    traced = trace_together(scene, fine, of.gravity, initial=of.initial, stop_after_rest=ENDS)
    held = traced.bodies[0].held
    assert held is not None  # a body in its section
    return Carrier.of_trace(fine, traced, held.body.height), held.body


def _in_run(run: Run, piece: int) -> tuple[Carrier, Body]:
    """Follow a piece in a run in space; return it as it is held, too."""
    from stayput.simulation.space_engine import SpaceShaking

    held = run[piece].held
    if held is None:
        raise InputError("model.another_shape", "piece")
    if run.motion.dt > STEP * (1.0 + 1e-9):
        raise InputError("contents.samples_apart", "motion.dt", dt=run.motion.dt, most=STEP)
    body, shaken = held.body, SpaceShaking.of(run.motion)
    case = case_columns(body, held.room, State(), run.gravity)[0]
    times = [time for time in (run[piece].overturn_time, run[piece].fall_time) if math.isfinite(time)]
    fell = round(min(times) / run.motion.dt) if times else None
    moved = run.place[piece], run.turn[piece], fell
    return Carrier.in_space(case, shaken, *moved, body.height, run.given_up), body


def spill_of(carrier: Carrier, body: Body, contents: Contents, *, followed: int) -> Spill:
    """Return what comes out of a piece that moves as it does.

    Parameters
    ----------
    carrier : Carrier
        How the piece moves.
    body : Body
        The piece with its contents.
    contents : Contents
        What is in it.
    followed : int
        Most items of a shelf that are followed until they leave it: when, how fast and how far.
    """
    items, masses = items_of(contents, body, carrier.gravity), contents.masses(body)
    right, above = items.middle
    points = [carrier.point(right, height + above, contents.slope) for height in contents.heights(body)]
    opened = opening_samples(contents, points, masses, carrier.gravity, carrier.dt)
    shape = items.cases.shape
    out, over = np.zeros(shape, np.bool_), np.zeros(shape, np.bool_)
    leaving = np.full((4, *shape), np.nan)
    part = 1.0
    if contents.doors == "sliding":
        middle = _shaking(points[len(points) // 2], 0, carrier.dt)
        part = uncovered(slide_of_a_leaf(contents, middle, carrier.gravity), contents.leaf)
    # Which items of a shelf stand before the open part of the front.
    exposed = (np.arange(contents.items) + 0.5) / contents.items < part
    samples = len(carrier.tilt)
    for shelf, (point, start) in enumerate(zip(points, opened.tolist(), strict=True)):
        if start > samples - 2 or not exposed.any():  # it stays shut
            continue
        if contents.drawers in STOPPED:  # and holds what is in it until the piece lies
            out[shelf] = carrier.overturned
            continue
        cases, shaken = items.cases[shelf, exposed], _shaking(point, start, carrier.dt)
        results = run_cases(cases, shaken)
        came, fell = out_of_shelf(items, cases, results), toppled(results)
        first: list[int] = np.flatnonzero(came)[:followed].tolist()
        for place in first:
            traced = trace(cases[place], shaken)
            number = np.flatnonzero(exposed)[place]
            leaving[:, shelf, number] = _leaving(items, traced, point, start, carrier)
        out[shelf, exposed], over[shelf, exposed] = came | carrier.overturned, fell
    time, height, speed, distance = leaving
    return Spill(
        contents=contents,
        overturned=carrier.overturned,
        out=out,
        toppled=over,
        mass=np.repeat(np.array(masses)[:, np.newaxis] / shape[1], shape[1], axis=1),
        open_from=np.where(opened < samples, opened * carrier.dt, math.inf),
        time=time,
        height=height,
        speed=speed,
        distance=distance,
    )


def _shaking(point: PointMotion, start: int, dt: float) -> Shaking:
    return shaking(point.along[start:], point.up[start:], dt, col.COULOMB)


def _leaving(
    items: Items, traced: Traced, point: PointMotion, start: int, carrier: Carrier
) -> tuple[float, float, float, float]:
    """Return when an item leaves its shelf [s], from how high [m], how fast [m/s], and how far it lands [m].

    It leaves as its centre of gravity passes the edge, or as it lies on it.
    """
    slide, tilt = traced.history[:, col.H_SLIDE], traced.history[:, col.H_TILT]
    beyond = np.abs(slide) > items.way
    sample = int(beyond.argmax()) if beyond.any() else len(slide) - 1
    place = start + sample
    along = traced.history[sample, col.H_SLIDE_RATE]
    if abs(tilt[sample]) > 0.25 * math.pi:  # its centre of gravity turns about the foot
        along += traced.history[sample, col.H_TILT_RATE] * items.middle[1] * math.cos(tilt[sample])
    speed = float(along * math.cos(point.turn[place]) + point.velocity[place])
    height = max(float(point.height[place]) - items.middle[1], 0.0)
    return place * carrier.dt, height, speed, speed * math.sqrt(2.0 * height / carrier.gravity)
