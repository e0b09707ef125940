"""Shared by the studies of walls (the paper, §4.4 and §4.5): Table 4.2, and turnover beside walls."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from stayput.model.body import Body
from stayput.model.room import Floor, Room, Wall
from stayput.simulation.case import Case
from stayput.simulation.outcome import Outcome
from stayput.simulation.results import OUTCOMES
from stayput.simulation.run import LAWS
from stayput.simulation.sweep import sweep

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.axes import Axes

RATIO = 0.339
"""Aspect ratio b/h of Table 4.2 [–]."""

MASS = 100.0
"""Mass of Table 4.2 [kg]."""

FLOOR = Floor(0.2, 0.1, edge_static_friction=0.4, edge_kinetic_friction=0.3, restitution=0.6)
"""Floor of Table 4.2."""

WALL_RESTITUTION = 0.6
"""Collision coefficient of the wall of Table 4.2 [–]."""

DURATION = 30.0
"""Analysis time of Table 4.2 [s]."""

SIDES = {"left": "wall on the left", "right": "wall on the right", "both": "walls on both sides"}
WALLS = tuple(SIDES)
"""Where a wall stands; with both, at the same distance."""

FALLEN = "#f2b48a"
"""Colour of a body that turns over."""

GIVEN_UP = OUTCOMES.index(Outcome.FAILED.value)


@dataclass(frozen=True, slots=True, eq=False)
class Turnover:
    """Which bodies turn over.

    Attributes
    ----------
    free : ndarray of bool, shape [..., width]
        Without a wall; the first dimensions are those of the other axes.
    free_tilt : ndarray, shape [..., width]
        Largest tilt without a wall [rad].
    walled : ndarray of bool, shape [..., wall, width, gap]
        With a wall.
    given_up : int
        Number of runs that were given up; they count as turned over.
    """

    free: NDArray[np.bool_]
    free_tilt: NDArray[np.float64]
    walled: NDArray[np.bool_]
    given_up: int


def table_4_2(motion: Motion, ratio: float = RATIO) -> Case:
    """Return a case with Table 4.2's coefficients under the paper's law; no wall yet."""
    return Case(Body(1.0, 1.0 / ratio, MASS), Room(FLOOR), motion, "paper")


def turnover(
    case: Case,
    widths: NDArray[np.float64],
    gaps: NDArray[np.float64],
    others: Axes,
    walls: Sequence[str] = WALLS,
) -> Turnover:
    """Simulate bodies of a case's aspect ratio beside walls, and without one.

    Parameters
    ----------
    case : Case
        What no axis changes.
    widths : ndarray, shape [width]
        Widths b [m].
    gaps : ndarray, shape [gap] or [width, gap]
        Distances l_w to the wall [m].
    others : mapping
        Further axes, as for `sweep`.
    walls : sequence of str
        Some of `WALLS`.
    """
    ratio = case.body.width / case.body.height
    rows = np.broadcast_to(gaps, (len(widths), gaps.shape[-1]))
    bodies: list[float] = []
    rooms: list[tuple[Wall | None, Wall | None]] = []
    for width, distances in zip(widths, rows, strict=True):
        rooms.append((None, None))
        for where, gap in product(walls, distances):
            wall = Wall(float(gap), WALL_RESTITUTION)
            rooms.append((None if where == "right" else wall, None if where == "left" else wall))
        bodies += [float(width)] * (1 + len(walls) * len(distances))
    cell = ("body.width", "body.height", "room.left_wall", "room.right_wall")
    columns = (bodies, [width / ratio for width in bodies], *zip(*rooms, strict=True))
    data = sweep(case, {**others, cell: columns})
    given_up = data["outcome"].to_numpy() == GIVEN_UP
    fallen, tilt = data["overturned"].to_numpy() | given_up, data["peak_tilt"].to_numpy()
    fallen, tilt = (values.reshape(*values.shape[:-1], len(widths), -1) for values in (fallen, tilt))
    walled = fallen[..., 1:].reshape(*fallen.shape[:-1], len(walls), gaps.shape[-1])
    return Turnover(fallen[..., 0], tilt[..., 0], np.moveaxis(walled, -2, -3), int(given_up.sum()))


def results_about(
    widths: NDArray[np.float64], gaps: NDArray[np.float64]
) -> tuple[dict[str, dict[str, str]], dict[str, object]]:
    """Return the descriptions of the results, and the coordinates, that both studies of walls have."""
    about = {
        "overturned": {"long_name": "whether it turns over"},
        "overturned_free": {"long_name": "whether it turns over without a wall"},
    }
    return about, {
        "contact": list(LAWS),
        "wall": list(WALLS),
        "body.width": ("body.width", widths, {"units": "m"}),
        "gap": ("gap", gaps, {"units": "m", "long_name": "distance from the body to the wall"}),
    }
