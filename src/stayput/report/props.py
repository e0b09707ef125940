"""The devices in a picture: each shape with its points in the frames of body and room, and when it shows."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.measures.sketch import sketch
from stayput.report.history import turned

if TYPE_CHECKING:
    from stayput.report.film import Pose
    from stayput.simulation import Run


@dataclass(frozen=True, slots=True)
class Prop:
    """A shape of a device.

    Parameters
    ----------
    filled : bool
        Whether it is an outline to be filled; else a line.
    points : tuple of tuple
        Its points: whether it goes with the body; right and up, from G or in the room [m].
    role : str
        What it is made of, or "broken" for what is left of a device that failed.
    start, end : float
        When it shows [s].
    """

    filled: bool
    points: tuple[tuple[bool, float, float], ...]
    role: str
    start: float = -math.inf
    end: float = math.inf

    def shows(self, time: float) -> bool:
        """Tell whether it shows at a time [s]."""
        return self.start <= time < self.end

    def placed(self, pose: Pose) -> list[tuple[float, float]]:
        """Return its points in the room [m]."""
        places: list[tuple[float, float]] = []
        for on_body, right, up in self.points:
            u, v = turned((right, up), pose.tilt) if on_body else (right, up)
            places.append((pose.x + u, pose.z + v) if on_body else (u, v))
        return places


def props_of(run: Run) -> tuple[Prop, ...]:
    """Return the devices of a run, whole until each fails, and what is left of them after."""
    if run.held is None:
        return ()
    x_g, z_g = run.body.centre_of_gravity
    found: list[Prop] = []
    for shape in sketch(run.held):
        points = tuple(
            (True, x - x_g, z - z_g) if frame == "body" else (False, x, z) for frame, x, z in shape.points
        )
        start, end = -math.inf, math.inf
        if shape.element is not None and shape.when != "always":
            failed = run.devices[shape.element].failure_time
            failed = math.inf if math.isnan(failed) else failed
            start, end = (failed, math.inf) if shape.when == "broken" else (-math.inf, failed)
        role = "broken" if shape.when == "broken" else shape.role
        if start < math.inf:
            found.append(Prop(shape.kind == "polygon", points, role, start, end))
    return tuple(found)
