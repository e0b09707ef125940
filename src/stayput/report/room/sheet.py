"""The sheet that a plan is drawn on: metres of the room to pixels, y upwards."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from stayput.report.verdict import svg

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import ArrayLike

    from stayput.model.floor_plan import FloorPlan

LARGEST = 460.0
"""Longest side of a room [px]."""

WALL = 8.0
"""Thickness of a wall [px]."""

MARGIN = {"left_wall": 82.0, "right_wall": 30.0, "near_side_wall": 50.0, "far_side_wall": 30.0}
"""Space beyond each wall, for its name and the scale [px]."""

Box = tuple[float, float, float, float]
"""Least x and y, and greatest x and y [px]."""


@dataclass(frozen=True, slots=True)
class PlanSheet:
    """Scale and margins of a plan.

    Parameters
    ----------
    plan : FloorPlan
        The room.
    """

    plan: FloorPlan

    @property
    def scale(self) -> float:
        """Pixels a metre."""
        return LARGEST / max(self.plan.width, self.plan.length)

    def beyond(self, wall: str) -> float:
        """Return how far doors swing outwards beyond a wall [px]."""
        doors = (door for door in self.plan.doors if door.wall == wall and door.opens == "outwards")
        return self.scale * max((door.width for door in doors), default=0.0)

    def margin(self, wall: str) -> float:
        """Return the space beyond a wall [px]."""
        return MARGIN[wall] + self.beyond(wall)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the picture [px]."""
        return (
            self.margin("left_wall") + self.scale * self.plan.width + self.margin("right_wall"),
            self.margin("far_side_wall") + self.scale * self.plan.length + self.margin("near_side_wall"),
        )

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Return where a point of the plan lies [px]."""
        return (
            self.margin("left_wall") + self.scale * x,
            self.margin("far_side_wall") + self.scale * (self.plan.length - y),
        )

    def polygon(self, points: ArrayLike, class_: str) -> str:
        """Return a filled outline through points of the plan."""
        return svg.polygon(self._places(points), class_)

    def polyline(self, points: ArrayLike, class_: str) -> str:
        """Return a line through points of the plan."""
        places = list(self._places(points))
        return svg.polyline([x for x, _ in places], [y for _, y in places], class_)

    def box_of(self, points: ArrayLike) -> Box:
        """Return the smallest upright rectangle around points of the plan [px]."""
        places = np.array(list(self._places(points)))
        (x0, y0), (x1, y1) = places.min(axis=0).tolist(), places.max(axis=0).tolist()
        return x0, y0, x1, y1

    @property
    def floor(self) -> Box:
        """The floor of the room [px]."""
        return self.box_of([(0.0, 0.0), (self.plan.width, self.plan.length)])

    def _places(self, points: ArrayLike) -> Iterable[tuple[float, float]]:
        return (self.place(x, y) for x, y in np.asarray(points, np.float64).tolist())


def titled(title: str, *content: str, class_: str = "") -> str:
    """Return parts of a picture as a group that a screen reader and the pointer name."""
    attributes = {"class_": class_} if class_ else {}
    return svg.element("g", svg.element("title", escape(title)) + "".join(content), **attributes)
