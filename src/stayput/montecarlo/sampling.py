"""Monte Carlo samples: draws of the uncertain quantities, the cases they make, and their number.

The same draws serve every set of measures and every level of shaking (common random numbers), so that
differences between measures are not blurred by chance.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import NDArray

from stayput.measures import Measure, element_rows, hold
from stayput.measures.wall import REACH
from stayput.mechanics.runner import no_elements
from stayput.model.body import MOST_INSET, Body
from stayput.model.flat_fields import NumberOrColumn, case_rows, fields_of, flat_fields
from stayput.model.room import FRICTION_RANGE, MOST_SETTLEMENT, WALLS_AROUND, Floor, Room, friction_factor
from stayput.model.state import State
from stayput.uncertainty import QUANTITIES, Uncertainty

if TYPE_CHECKING:
    from stayput.measures.measure import Held
    from stayput.model.room import Wall
    from stayput.montecarlo.counting import Members
    from stayput.scenario import Scenario

INSETS = ("back_inset", "front_inset")


@dataclass(frozen=True, slots=True)
class Settings:
    """Monte Carlo settings.

    Parameters
    ----------
    motions, samples : int
        Motions, and most samples of each.
    seed : int
        Seed of the draws.
    precision : float, optional
        Half-width of the 95 % interval of the probability of overturning at which sampling stops.
    slide_limit : float
        Slide that counts as too far [m].
    gravity : float
        Acceleration of gravity [m/s²].
    as_stated : tuple of str
        Quantities that are not drawn.
    quantities : Uncertainty
        The distributions of the others.
    all_runs : bool
        Whether all runs of all options are made, as where their number is asked for without a precision.
    """

    motions: int
    samples: int
    seed: int
    precision: float | None
    slide_limit: float
    gravity: float
    as_stated: tuple[str, ...]
    quantities: Uncertainty = QUANTITIES
    all_runs: bool = False

    @property
    def runs(self) -> int:
        """Most runs."""
        return self.motions * self.samples

    @classmethod
    def of(cls, scenario: Scenario, motions: int, slide_limit: float) -> Self:
        """Return the settings of a scenario, its samples spread evenly over a number of motions."""
        stated = scenario.uncertainty
        samples = max(1, -(-scenario.samples // motions))
        return cls(
            motions,
            samples,
            stated.seed,
            stated.precision,
            slide_limit,
            scenario.gravity,
            tuple(stated.as_stated),
            stated.quantities,
            stated.samples is not None and stated.precision is None,
        )


@dataclass(frozen=True, slots=True)
class Draw:
    """One draw of the quantities of `stayput.uncertainty.USUAL`, in its order.

    Factors on what the scenario states, how the piece stands, and the restitution of the walls, of which NaN
    leaves that which is stated.
    """

    friction: float
    restitution: float
    wall_restitution: float
    mass: float
    gravity_height: float
    strength: float
    wall_gap: float
    lean: float
    back_inset: float
    front_inset: float
    settlement: float
    landing_place: float


AS_STATED = Draw(1.0, 1.0, math.nan, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0)
"""The draw that leaves everything as the scenario states it."""


@dataclass(frozen=True, slots=True, eq=False)
class DrawTable:
    """Draws for every motion.

    Parameters
    ----------
    columns : dict of str to ndarray, shape (motions, samples)
        Each field of `Draw`.
    """

    columns: dict[str, NDArray[np.float64]]

    @property
    def shape(self) -> tuple[int, int]:
        """Motions, and samples of each."""
        motions, samples = self.columns["mass"].shape
        return motions, samples

    def of(self, members: Members) -> DrawTable:
        """Return the draw of each run, shape (runs, 1)."""
        place = members.motion, members.sample
        return DrawTable({name: column[place][:, np.newaxis] for name, column in self.columns.items()})

    def __len__(self) -> int:
        return len(self.columns["mass"])

    def __getitem__(self, motion: int) -> list[Draw]:
        """Return the draws of a motion."""
        columns = (column[motion].tolist() for column in self.columns.values())
        return [Draw(*row) for row in zip(*columns, strict=True)]

    def __iter__(self) -> Iterator[list[Draw]]:
        return (self[motion] for motion in range(len(self)))


def draws(
    motions: int,
    samples: int,
    seed: int,
    start: int = 0,
    *,
    as_stated: Collection[str] = (),
    quantities: Uncertainty = QUANTITIES,
) -> DrawTable:
    """Return the draws of every motion.

    Parameters
    ----------
    motions, samples : int
        Motions, and samples of each.
    seed : int
        Seed of the draws.
    start : int
        Continues an earlier call after so many samples.
    as_stated : collection of str
        Quantities that are not drawn; the draws of the others stay as they are.
    quantities : Uncertainty
        Their distributions, in the order of `stayput.uncertainty.USUAL`.
    """
    drawn = quantities.sample(samples, seed, motions=motions, start=start)
    for name in as_stated:
        drawn[name] = np.full((motions, samples), getattr(AS_STATED, name))
    return DrawTable(drawn)


def drawn_body(body: Body, draw: Draw) -> Body:
    """Return the body with its mass, the height of its centre of gravity and how it stands as drawn.

    Of one with a shape of its own only the mass is drawn.
    """
    if body.shape is not None:
        inertia = draw.mass * body.shape.inertia
        return Body.of_shape(replace(body.shape, mass=draw.mass * body.mass, inertia=inertia))
    x, z = body.cg_offset
    back, front = body.base_heights
    insets = (float(_drawn_inset(body, 0, draw.back_inset)), float(_drawn_inset(body, 1, draw.front_inset)))
    height = min(0.95, draw.gravity_height * (0.5 + z / body.height)) * body.height
    inertia = None if body.inertia is None else draw.mass * body.inertia
    base_width = body.width - insets[0] - insets[1]
    return replace(
        body,
        mass=draw.mass * body.mass,
        cg_offset=(x, height - 0.5 * body.height),
        inertia=inertia,
        base_heights=(back, front - draw.lean * base_width),
        base_insets=insets,
    )


def _drawn_inset(body: Body, side: int, share: NumberOrColumn) -> NumberOrColumn:
    """Return drawn insets of the back (0) or the front [m]: at most half of what is left of the base there.

    So a base that carries the centre of gravity as stated does so in every draw.
    """
    stated, foot = body.base_insets[side], abs(body.corners[side][0])
    return stated + np.minimum(share * body.width, min(0.5 * foot, MOST_INSET * body.width - stated))


def drawn_place(room: Room, draw: Draw) -> Room:
    """Return the room with the walls at the distances drawn, before measures are put in place."""
    return _with_walls(room, lambda wall: replace(wall, gap=float(_drawn_gap(wall.gap, draw.wall_gap))))


def _with_walls(room: Room, change: Callable[[Wall], Wall]) -> Room:
    """Return a room with each of its walls changed."""
    walls = {name: getattr(room, name) for name in WALLS_AROUND}
    return replace(room, **{name: change(wall) for name, wall in walls.items() if wall is not None})


def _drawn_gap(gap: float, factor: NumberOrColumn) -> NumberOrColumn:
    """Return drawn gaps [m]: behind a piece, where a bracket reaches the wall in every draw too.

    How far away other walls are is known.
    """
    return np.minimum(factor * gap, REACH) if gap <= REACH else gap


def drawn_floor(floor: Floor, draw: Draw) -> Floor:
    """Return a floor with friction, restitution and softness as drawn."""
    coefficients = {f.name: getattr(floor, f.name) for f in fields(floor) if f.name.endswith("friction")}
    factor = friction_factor(floor, draw.friction)
    changed = {
        name: min(float(factor * value), FRICTION_RANGE[1])
        for name, value in coefficients.items()
        if value is not None
    }
    return replace(
        floor,
        **changed,
        restitution=draw.restitution * floor.restitution,
        landing_place=draw.landing_place * floor.landing_place,
        settlement=min(draw.settlement * floor.settlement, MOST_SETTLEMENT),
    )


def drawn_surfaces(room: Room, draw: Draw) -> Room:
    """Return the room with friction, restitution and softness as drawn, after measures were put in place."""

    def drawn(wall: Wall) -> Wall:
        return replace(wall, restitution=float(_drawn_rebound(wall.restitution, draw.wall_restitution)))

    return replace(_with_walls(room, drawn), floor=drawn_floor(room.floor, draw))


def _drawn_rebound(stated: NumberOrColumn, drawn: NumberOrColumn) -> NumberOrColumn:
    """Return drawn restitutions of a wall: the stated one where none is drawn."""
    return np.where(np.isnan(drawn), stated, drawn)


def drawn_held(
    body: Body, room: Room, measures: Iterable[Measure], draw: Draw
) -> tuple[Held, NDArray[np.void]]:
    """Return a piece in the plane with its measures in place as drawn, and the rows of its devices.

    The body and its place are drawn before the measures are applied, friction after them: a measure's
    surface is as uncertain as the floor's. A product is bought for the piece as stated.
    """
    bought = [measure.fitted_to(body) for measure in measures]
    held = hold(drawn_body(body, draw), drawn_place(room, draw), bought)
    return replace(held, room=drawn_surfaces(held.room, draw)), element_rows(held, draw.strength)


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Case and element rows of one piece with one set of measures, by motion and by sample within it.

    Parameters
    ----------
    cases : ndarray of CASE, shape (motions · samples,)
        The cases.
    elements : ndarray of ELEMENT, shape (motions · samples, elements)
        Their devices, per unit mass.
    masses : ndarray, shape (motions · samples,)
        Mass of the body [kg].
    free_slide : float
        How far the measures are made to let the piece slide [m].
    """

    cases: NDArray[np.void]
    elements: NDArray[np.void]
    masses: NDArray[np.float64]
    free_slide: float = 0.0


def rows_of(
    body: Body,
    room: Room,
    measures: tuple[Measure, ...],
    drawn: DrawTable,
    gravity: float,
    initial: State | None = None,
) -> Rows:
    """Return the rows of a piece in the plane under all draws; see `drawn_held`.

    Parameters
    ----------
    body, room, measures
        The piece as stated.
    drawn : DrawTable
        The draws.
    gravity : float
        Acceleration of gravity [m/s²].
    initial : State, optional
        The initial state; at rest by default.

    Raises
    ------
    InputError
        The measures cannot be applied, as stated or in one of the draws.
    """
    columns = {name: column.ravel() for name, column in drawn.columns.items()}
    count = len(columns["mass"])
    bought = tuple(measure.fitted_to(body) for measure in measures)
    held = hold(body, room, bought)
    numbers: dict[str, NumberOrColumn] = {**flat_fields(held.body, held.room, initial or State(), gravity)}
    if not held.elements and held.body == body:
        # Nothing but numbers changes with the draw, so that all rows are made at once: far faster than one by
        # one. The formulas are those of `drawn_body`, in the same order of operations: the bits are the same.
        z = body.cg_offset[1]
        height = np.minimum(0.95, columns["gravity_height"] * (0.5 + z / body.height)) * body.height
        masses = columns["mass"] * body.mass
        numbers |= {"body.mass": masses, "body.cg_offset.z": height - 0.5 * body.height}
        if body.inertia is not None:
            numbers["body.inertia"] = columns["mass"] * body.inertia
        left, right = (_drawn_inset(body, side, columns[name]) for side, name in enumerate(INSETS))
        numbers |= {"body.base_insets.left": left, "body.base_insets.right": right}
        numbers["body.base_heights.right"] = body.base_heights[1] - columns["lean"] * (
            body.width - left - right
        )
        for name in WALLS_AROUND:
            wall = getattr(room, name)
            if wall is not None and wall == getattr(held.room, name):  # a measure's own gap is as it says
                numbers[f"room.{name}.gap"] = _drawn_gap(wall.gap, columns["wall_gap"])
        friction = friction_factor(held.room.floor, columns["friction"])
        for path in numbers:
            if path.startswith("room.floor.") and path.endswith("friction"):
                numbers[path] = np.minimum(friction * numbers[path], FRICTION_RANGE[1])
        for name in ("restitution", "landing_place", "settlement"):
            numbers[f"room.floor.{name}"] = columns[name] * numbers[f"room.floor.{name}"]
        numbers["room.floor.settlement"] = np.minimum(numbers["room.floor.settlement"], MOST_SETTLEMENT)
        for name in WALLS_AROUND:
            if getattr(held.room, name) is not None:
                path = f"room.{name}.restitution"
                numbers[path] = _drawn_rebound(numbers[path], columns["wall_restitution"])
        return Rows(case_rows(numbers, count), no_elements(0, count), masses, held.free_slide)
    each = [drawn_held(body, room, measures, draw) for row in drawn for draw in row]
    leaf_rows = [{**fields_of("body", fixed.body), **fields_of("room", fixed.room)} for fixed, _ in each]
    numbers |= {path: np.array([row[path] for row in leaf_rows]) for path in leaf_rows[0]}
    masses, elements = np.array([fixed.body.mass for fixed, _ in each]), np.stack([rows for _, rows in each])
    return Rows(case_rows(numbers, count), elements, masses, held.free_slide)
