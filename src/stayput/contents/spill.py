"""`spill`: what comes out of a piece of furniture, item by item."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np
from numpy.typing import NDArray

from stayput.contents.carrier import STEP, Carrier, PointMotion, parts
from stayput.contents.contents import STOPPED, Contents
from stayput.contents.items import (
    Items,
    items_of,
    opening_samples,
    out_of_shelf,
    slide_of_a_leaf,
    toppled,
    uncovered,
)
from stayput.errors import InputError, instance_of, not_allowed, whole_within
from stayput.measures import element_rows, hold
from stayput.mechanics import columns as col
from stayput.mechanics.runner import Shaking, Traced, run_cases, shaking, trace
from stayput.model.flat_fields import case_columns
from stayput.model.state import State
from stayput.simulation.case import Case, scene_of
from stayput.simulation.many import plane_shaking
from stayput.simulation.run import Run

if TYPE_CHECKING:
    from stayput.model.body import Body


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
    traced = trace_together(scene, fine, of.gravity, initial=of.initial, lies=ENDS)
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
    exposed = _exposed(shape[1], part)
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


def _exposed(count: int, part: float) -> NDArray[np.bool_]:
    """Return which items of a shelf stand before the open part of the front."""
    return (np.arange(count) + 0.5) / count < part


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
