"""The sheet that a plan is drawn on: metres of the room to pixels, y upwards; and where names stand on it.

Names are placed so that they overlap as little as can be.
"""

from __future__ import annotations

import itertools
import math
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from stayput.catalogue import say
from stayput.model.floor_plan import Door, FloorPlan, PersonPlace, Window, rectangle
from stayput.model.room import WALLS_AROUND
from stayput.report.film.shape import swing_of
from stayput.report.verdict import svg

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


def titled(title: str, *content: str) -> str:
    """Return parts of a picture as a group that a screen reader and the pointer name."""
    return svg.element("g", svg.element("title", escape(title)) + "".join(content))


ARC = 24
"""Parts of the arc of a door."""


def walls_svg(sheet: PlanSheet) -> str:
    """Return the floor with its walls."""
    x0, y0, x1, y1 = sheet.floor
    return svg.box(x0 - WALL, y0 - WALL, x1 + WALL, y1 + WALL, "walls") + svg.box(x0, y0, x1, y1, "ground")


def _hole(sheet: PlanSheet, wall: str, start: float, width: float) -> str:
    depth = WALL / sheet.scale
    corners = ((start, 0.0), (start + width, 0.0), (start + width, -depth), (start, -depth))
    return sheet.polygon([sheet.plan.on_wall(wall, *corner) for corner in corners], "ground")


def window_svg(sheet: PlanSheet, window: Window, language: str) -> str:
    """Return a window: an opening with a pane in it."""
    wall, ends = window.wall, (window.start, window.start + window.width)
    panes = [_in_wall(sheet, wall, ends, part, "pane") for part in (0.1, 0.5, 0.9)]
    title = say("room_report.window", language, width=window.width)
    return titled(title, _hole(sheet, wall, window.start, window.width), *panes)


def door_svg(sheet: PlanSheet, door: Door, title: str) -> str:
    """Return a door: its leaf where it stands open, and the arc of its edge; two panels of a sliding one."""
    hole = _hole(sheet, door.wall, door.start, door.width)
    if door.opens == "sliding":
        return titled(title, hole, *_panels(sheet, door))
    edge, leaf = swing_of(sheet.plan, door, ARC)
    return titled(title, hole, sheet.polyline(edge, "swing"), sheet.polyline(leaf, "leaf"))


def _in_wall(sheet: PlanSheet, wall: str, ends: tuple[float, float], part: float, class_: str) -> str:
    """Return a line along a wall, at a part of its thickness."""
    depth = -part * WALL / sheet.scale
    return sheet.polyline([sheet.plan.on_wall(wall, along, depth) for along in ends], class_)


def _panels(sheet: PlanSheet, door: Door) -> list[str]:
    part, end = 0.55 * door.width, door.start + door.width
    return [
        _in_wall(sheet, door.wall, (door.start, door.start + part), 0.3, "leaf"),
        _in_wall(sheet, door.wall, (end - part, end), 0.7, "leaf"),
    ]


def scale_svg(sheet: PlanSheet, language: str) -> str:
    """Return metres along the near and the left wall, and the names of all walls."""
    plan, (x0, y0, x1, y1) = sheet.plan, sheet.floor
    low, left = y1 + WALL + sheet.beyond("near_side_wall"), x0 - WALL - sheet.beyond("left_wall")
    count = 1 + round(5.0 * max(plan.width, plan.length) / (plan.width + plan.length))
    parts: list[str] = []
    for value in svg.ticks(0.0, max(plan.width, plan.length), 2 * count):
        text = say("room_report.metres", language, value=round(value, 6))
        if value <= plan.width + 1e-9:
            x, _ = sheet.place(value, 0.0)
            parts += [svg.line(x, low, x, low + 5.0, "axis"), svg.label(x, low + 18.0, text)]
        if value <= plan.length + 1e-9:
            _, y = sheet.place(0.0, value)
            parts.append(svg.line(left - 5.0, y, left, y, "axis"))
            parts.append(svg.label(left - 8.0, y + 4.0, text, anchor="end"))
    middle_x, middle_y = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    width, height = sheet.size
    at = {
        "left_wall": (11.0, middle_y, -90.0),
        "right_wall": (width - 8.0, middle_y, -90.0),
        "near_side_wall": (middle_x, height - 6.0, 0.0),
        "far_side_wall": (middle_x, 14.0, 0.0),
    }
    for wall in WALLS_AROUND:
        x, y, turn = at[wall]
        name = svg.label(0.0, 0.0, say(f"rooms.{wall}", language))
        parts.append(svg.element("g", name, transform=f"translate({x:.1f} {y:.1f}) rotate({turn:g})"))
    return "".join(parts)


_LYING: list[tuple[ArrayLike, str]] = [
    (rectangle((0.0, -0.38), 0.62, 0.14), "soft"),
    (((-0.5, -0.23), (0.5, -0.23)), "fold"),
]
_BARS = [
    (((0.5 * side, y), (0.4 * side, y)), "fold")
    for side in (-1.0, 1.0)
    for y in np.linspace(-0.4, 0.4, 7).tolist()
]
_INSIDE: dict[str, list[tuple[ArrayLike, str]]] = {
    **dict.fromkeys(("bed", "futon"), _LYING),
    "cot": [(rectangle((0.0, -0.36), 0.5, 0.14), "soft"), *_BARS],
    "desk": [(rectangle((0.04, 0.0), 0.6, 0.62), "soft"), (rectangle((-0.34, 0.0), 0.12, 0.7), "soft")],
    "sofa": [
        (rectangle((-0.39, 0.0), 0.22, 1.0), "soft"),
        *((rectangle((0.1, end), 0.8, 0.1), "soft") for end in (-0.45, 0.45)),
    ],
    "play area": [],
}
"""What is drawn in a place of each kind: points as parts of its width and length, and their class.

A pillow at the head, which is at −y, and the edge of the blanket; bars of a cot; a chair with its back at −x;
a back and arms.
"""


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
    for points, class_ in _INSIDE[kind]:
        draw = sheet.polyline if class_ == "fold" else sheet.polygon
        inside = np.asarray(points) * [place.width, place.length]
        parts.append(draw(inside @ turn + np.asarray(place.at), class_))
    if kind == "play area":  # with a ball
        angle = np.linspace(0.0, 2.0 * math.pi, 24, endpoint=False)
        round_it = 0.12 * min(place.width, place.length) * np.column_stack([np.cos(angle), np.sin(angle)])
        ball = 0.28 * np.array([place.width, place.length]) + round_it
        parts.append(sheet.polygon(ball @ turn + np.asarray(place.at), "soft"))
    return titled(title, *parts)


FONT = 13.0
"""Size of the letters [px]; that of ``.plan-room text`` in canvas/plan.css."""

LINE = 16.0 / 13.0
"""Height of a line, in sizes of the letters."""

LONGEST = 11.0
"""Longest line, in widths of a full-width letter."""

NARROW = 0.56
"""Width of a letter that is not full-width, in the same."""

WIDER = 1.2
"""How much wider names may be in the fonts of some systems."""

OTHER_NAME, OUTSIDE, OTHER_THING, FARTHER = 30.0, 20.0, 2.0, 0.15
"""What it costs that a name lies on another, beyond the floor, on another thing; and each next place."""


class PlanLabel(NamedTuple):
    """A name and where what it names is.

    Parameters
    ----------
    lines : tuple of str
        Its lines.
    note : str
        What is told below it; empty for nothing.
    box : tuple of float
        The rectangle of what it names [px].
    """

    lines: tuple[str, ...]
    note: str
    box: Box

    @property
    def texts(self) -> list[tuple[str, str]]:
        """All lines with their classes."""
        lines = [(line, "name halo") for line in self.lines]
        return [*lines, (self.note, "note halo")] if self.note else lines


def wrapped(name: str) -> tuple[str, ...]:
    """Return a name as at most two lines, cut where it is longer."""
    words, lines = name.split(), [""]
    for word in words:
        joined = f"{lines[-1]} {word}".strip()
        if lines[-1] and _width(joined) > LONGEST:
            lines.append(word)
        else:
            lines[-1] = joined
    kept = lines[:2]
    if len(lines) > 2:
        kept[-1] += "…"
    return tuple(_cut(line) for line in kept)


def _cut(line: str) -> str:
    if _width(line) <= LONGEST:
        return line
    while _width(line + "…") > LONGEST:
        line = line[:-1]
    return f"{line.rstrip('…')}…"


def _width(text: str) -> float:
    return sum(1.0 if unicodedata.east_asian_width(letter) in "WF" else NARROW for letter in text)


def names_svg(labels: Sequence[PlanLabel], boxes: Sequence[Box], letters: float = FONT) -> str:
    """Return names as texts in the rectangles where they stand, with letters of a size [px]."""
    line = LINE * letters
    return "".join(
        svg.label(0.5 * (box[0] + box[2]), box[1] + line * (row + 0.78), text, class_)
        for label, box in zip(labels, boxes, strict=True)
        for row, (text, class_) in enumerate(label.texts)
    )


def overlap(boxes: Sequence[Box]) -> bool:
    """Return whether any two rectangles share an area."""
    return any(_shared(first, second) > 0.0 for first, second in itertools.combinations(boxes, 2))


def places_of_names(
    labels: Sequence[PlanLabel], things: Sequence[Box], floor: Box, letters: float = FONT
) -> list[Box]:
    """Return rectangles in which names stand, the first of them placed first.

    Parameters
    ----------
    labels : sequence of PlanLabel
        The names.
    things : sequence of tuple of float
        Rectangles on which they rather do not stand [px].
    floor : tuple of float
        The rectangle that they should not leave [px].
    letters : float
        Size of the letters [px].
    """
    taken: list[Box] = []
    for label in labels:
        others = [thing for thing in things if thing != label.box]
        candidates = _candidates(label, letters)
        costs = [_cost(box, taken, others, floor) + FARTHER * place for place, box in enumerate(candidates)]
        taken.append(candidates[costs.index(min(costs))])
    return taken


def _candidates(label: PlanLabel, letters: float) -> list[Box]:
    """Return rectangles for a name: in the middle of what it names, then at its sides."""
    x0, y0, x1, y1 = label.box
    wide = WIDER * letters * max(_width(line) for line, _ in label.texts) + 4.0
    high = LINE * letters * len(label.texts)
    x, y = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    dx, dy, gap = 0.5 * wide, 0.5 * high, 3.0
    middles = [
        (x, y),
        *((x, end) for end in (y0 + dy, y1 - dy)),
        *((end, y) for end in (x1 + dx + gap, x0 - dx - gap, x0 + dx, x1 - dx)),
        *((x, end) for end in (y1 + dy + gap, y0 - dy - gap)),
        *((across, end) for across in (x1 + dx + gap, x0 - dx - gap) for end in (y0 + dy, y1 - dy)),
        *((across, end) for across in (x0 + dx, x1 - dx) for end in (y1 + dy + gap, y0 - dy - gap)),
    ]
    return [(a - dx, b - dy, a + dx, b + dy) for a, b in middles]


def _cost(box: Box, taken: Sequence[Box], others: Sequence[Box], floor: Box) -> float:
    area = (box[2] - box[0]) * (box[3] - box[1])
    on_names = sum(_shared(box, other) for other in taken)
    on_things = sum(_shared(box, other) for other in others)
    return (OTHER_NAME * on_names + OTHER_THING * on_things + OUTSIDE * (area - _shared(box, floor))) / area


def _shared(first: Box, second: Box) -> float:
    """Return the area that two rectangles share [px²]."""
    wide = min(first[2], second[2]) - max(first[0], second[0])
    high = min(first[3], second[3]) - max(first[1], second[1])
    return max(0.0, wide) * max(0.0, high)
