"""Places of persons on a plan, as simple shapes of their kinds."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.model.floor_plan import rectangle
from stayput.report.room.sheet import titled

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.model.floor_plan import PersonPlace
    from stayput.report.room.sheet import PlanSheet

PlaceShape = tuple["NDArray[np.float64]", str]
"""Points in the frame of a place [m], and the class of what is drawn through them."""


def place_svg(sheet: PlanSheet, place: PersonPlace, kind: str, title: str) -> str:
    """Return a place, drawn as what a person of its kind lies or sits on.

    Parameters
    ----------
    sheet : PlanSheet
        Where it is drawn.
    place : PersonPlace
        The place.
    kind : str
        Of `stayput.model.floor_plan.PLACES`.
    title : str
        What a screen reader says.
    """
    cos, sin = math.cos(place.heading), math.sin(place.heading)
    turn = np.array([[cos, sin], [-sin, cos]])
    parts = [sheet.polygon(place.corners, "place" if place.blocks else "place flat")]
    for points, class_ in _INSIDE[kind](place.width, place.length):
        draw = sheet.polyline if class_ == "fold" else sheet.polygon
        parts.append(draw(points @ turn + np.asarray(place.at), class_))
    return titled(title, *parts)


def _lying(width: float, length: float) -> list[PlaceShape]:
    """Return a pillow at the head, which is at −y, and the edge of the blanket."""
    head = -0.5 * length
    pillow = rectangle((0.0, head + 0.12 * length), 0.62 * width, 0.14 * length)
    edge = np.array([[-0.5 * width, head + 0.27 * length], [0.5 * width, head + 0.27 * length]])
    return [(pillow, "soft"), (edge, "fold")]


def _cot(width: float, length: float) -> list[PlaceShape]:
    """Return a pillow, and bars on both sides."""
    bars = [
        (np.array([[side * 0.5 * width, y], [side * 0.4 * width, y]]), "fold")
        for side in (-1.0, 1.0)
        for y in np.linspace(-0.4 * length, 0.4 * length, 7).tolist()
    ]
    return [(rectangle((0.0, -0.36 * length), 0.5 * width, 0.14 * length), "soft"), *bars]


def _chair(width: float, length: float) -> list[PlaceShape]:
    """Return a chair with its back at −x."""
    return [
        (rectangle((0.04 * width, 0.0), 0.6 * width, 0.62 * length), "soft"),
        (rectangle((-0.34 * width, 0.0), 0.12 * width, 0.7 * length), "soft"),
    ]


def _sofa(width: float, length: float) -> list[PlaceShape]:
    """Return a back at −x, and arms."""
    arms = [
        (rectangle((0.1 * width, side * 0.45 * length), 0.8 * width, 0.1 * length), "soft")
        for side in (-1, 1)
    ]
    return [(rectangle((-0.39 * width, 0.0), 0.22 * width, length), "soft"), *arms]


def _ball(width: float, length: float) -> list[PlaceShape]:
    """Return a ball."""
    angle = np.linspace(0.0, 2.0 * math.pi, 24, endpoint=False)
    radius = 0.12 * min(width, length)
    middle = np.array([0.28 * width, 0.28 * length])
    return [(middle + radius * np.column_stack([np.cos(angle), np.sin(angle)]), "soft")]


_INSIDE: dict[str, Callable[[float, float], list[PlaceShape]]] = {
    "bed": _lying,
    "futon": _lying,
    "cot": _cot,
    "desk": _chair,
    "sofa": _sofa,
    "play area": _ball,
}
"""What is drawn in a place of each kind."""
