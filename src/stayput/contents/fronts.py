"""Doors and drawers: when a catch lets go, and how far sliding doors run open.

A hinged door with its contents behind it pushes on its catch with, at the free edge of each of two leaves,

    F = ¼ (m_d [−a]⁺ + Σ m_i [−a − μ' n]⁺)

with a along the shelves and n perpendicular to them, as `stayput.contents.carrier` has them: the door by its
inertia, the contents with what friction on their shelves does not hold; half of each on a leaf, at its
middle. A drawer pushes on its own catch with m [−a − μ' n]⁺. The catch lets go where the mean of this force
over `CATCH_TIME` is more than it holds. Blows of sliding contents on a door are left out, and a door that has
opened stays open.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.mechanics.runner import run_cases
from stayput.model.body import Body
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.simulation.flat_fields import case_columns

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.contents.carrier import PointMotion
    from stayput.contents.contents import Contents
    from stayput.mechanics.runner import Shaking

CATCH_TIME = 0.02
"""Time over which the force on a catch is averaged [s]; low confidence.

A catch lets go over a way of some 2 mm, which takes so long at 1 g: a blow that is shorter does not open it.
"""

GROOVE = (0.15, 0.12)
"""Static and kinetic friction of sliding doors in their grooves; low confidence."""


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
