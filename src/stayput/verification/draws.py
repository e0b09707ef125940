"""What is not known of the furniture and its surroundings, drawn for every motion.

The same draws serve every option and every level (common random numbers), so that differences between
options are not blurred by chance.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.cases import State, case_columns
from stayput.measures import element_rows, hold
from stayput.uncertainty import USUAL, Uncertainty

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.body import Body
    from stayput.measures import Held
    from stayput.room import Floor, Room
    from stayput.verification.options import Option

QUANTITIES = Uncertainty(USUAL)
"""The quantities that are drawn."""


@dataclass(frozen=True, slots=True)
class Draw:
    """One set of what is not known: factors on what the scenario states, and the wall's restitution."""

    friction: float
    restitution: float
    wall_restitution: float
    mass: float
    gravity_height: float
    strength: float


def draws(motions: int, samples: int, seed: int, start: int = 0) -> list[list[Draw]]:
    """Return the draws of every motion: [motions][samples]; ``start`` continues an earlier call."""
    drawn = QUANTITIES.sample(samples, seed, motions=motions, start=start)
    columns = [drawn[name] for name in USUAL]
    return [
        [Draw(*(float(column[motion, sample]) for column in columns)) for sample in range(samples)]
        for motion in range(motions)
    ]


def drawn_body(body: Body, draw: Draw) -> Body:
    """Return the body with its mass and the height of its centre of gravity as drawn."""
    x, z = body.cg_offset
    height = min(0.95, draw.gravity_height * (0.5 + z / body.height)) * body.height
    inertia = None if body.inertia is None else draw.mass * body.inertia
    offset = (x, height - 0.5 * body.height)
    return replace(body, mass=draw.mass * body.mass, cg_offset=offset, inertia=inertia)


def _drawn_floor(floor: Floor, draw: Draw) -> Floor:
    coefficients = {f.name: getattr(floor, f.name) for f in fields(floor) if f.name.endswith("friction")}
    changed = {name: draw.friction * value for name, value in coefficients.items() if value is not None}
    return replace(floor, **changed, restitution=draw.restitution * floor.restitution)


def drawn_room(room: Room, draw: Draw) -> Room:
    """Return the room with its friction and restitution as drawn."""
    left, right = room.left_wall, room.right_wall
    return replace(
        room,
        floor=_drawn_floor(room.floor, draw),
        left_wall=None if left is None else replace(left, restitution=draw.wall_restitution),
        right_wall=None if right is None else replace(right, restitution=draw.wall_restitution),
    )


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """What the mechanics read of one option under all draws, by motion and by sample within it.

    Parameters
    ----------
    cases : ndarray of CASE, shape (motions · samples,)
        The cases.
    elements : ndarray of ELEMENT, shape (motions · samples, elements)
        Their devices, per unit mass.
    masses : ndarray, shape (motions · samples,)
        Mass of the body [kg].
    """

    cases: NDArray[np.void]
    elements: NDArray[np.void]
    masses: NDArray[np.float64]


def rows_of(
    option: Option,
    body: Body,
    room: Room,
    drawn: list[list[Draw]],
    gravity: float,
    initial: State | None = None,
) -> Rows:
    """Return the rows of one option under all draws.

    The body is drawn before the measures are applied, friction after them: a measure's surface is as
    little known as the floor's.
    """
    start = State() if initial is None else initial
    cases: list[NDArray[np.void]] = []
    elements: list[NDArray[np.void]] = []
    masses: list[float] = []
    for draw in (one for row in drawn for one in row):
        held: Held = hold(drawn_body(body, draw), room, option.measures)
        cases.append(case_columns(held.body, drawn_room(held.room, draw), start, gravity))
        elements.append(element_rows(held, draw.strength))
        masses.append(held.body.mass)
    return Rows(np.concatenate(cases), np.stack(elements), np.array(masses))
