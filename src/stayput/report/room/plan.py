"""The plan of a room as SVG: walls, openings, places of persons, pieces, and where the pieces come to lie."""

from __future__ import annotations

import math
from dataclasses import dataclass
from string import ascii_lowercase
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.catalogue import say
from stayput.report.room.labels import FONT, PlanLabel, names_svg, overlap, places_of_names, wrapped
from stayput.report.room.places import place_svg
from stayput.report.room.sheet import PlanSheet, titled
from stayput.report.room.walls import door_svg, scale_svg, walls_svg, window_svg
from stayput.report.verdict import svg
from stayput.rooms.events import CELL
from stayput.rooms.words import door_name, piece_name, place_name

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from numpy.typing import NDArray

    from stayput.model.floor_plan import FloorPlan
    from stayput.report.room.sheet import Box

STEPS = 10
"""Steps of the share of the runs in which a piece ends on a spot."""

HUES = 7
"""Colours of pieces; after them come stripes of the same colours."""


@dataclass(frozen=True, slots=True, eq=False)
class DrawnPiece:
    """A piece on a plan.

    Parameters
    ----------
    name : str
        What it is called.
    look : int
        Number of its colour.
    outline : ndarray, shape (n, 2)
        As it stands, counter-clockwise [m].
    heading : float
        Where its front faces [rad].
    covers : ndarray, shape (nx, ny), optional
        Share of the runs in which it ends on each cell of the floor.
    """

    name: str
    look: int
    outline: NDArray[np.float64]
    heading: float
    covers: NDArray[np.float64] | None = None


class DrawnPlan(NamedTuple):
    """A plan as SVG, and what the marks mean that stand on it in the place of names, if any."""

    svg: str
    legend: tuple[tuple[str, str], ...] = ()


def plan_svg(
    plan: FloorPlan,
    pieces: Sequence[DrawnPiece],
    kinds: Sequence[str],
    language: str,
    *,
    notes: Mapping[str, str] | None = None,
    moved: Iterable[tuple[NDArray[np.float64], NDArray[np.float64]]] = (),
    numbered: Mapping[str, str] | None = None,
    letters: float = FONT,
) -> DrawnPlan:
    """Return the plan of a room, to scale and with y upwards; its style is canvas/plan.css.

    Where it has numbers and names would lie on one another, these numbers stand in their place, and letters
    for what has no number.

    Parameters
    ----------
    plan : FloorPlan
        Walls, doors, windows and places.
    pieces : sequence of DrawnPiece
        The pieces, those that stand on others after these.
    kinds : sequence of str
        The kind of each place, of `stayput.model.floor_plan.PLACES`.
    language : str
        "en" or "ja".
    notes : mapping of str, optional
        What is told of a piece, a place or a door, by its name.
    moved : iterable of tuple of ndarray
        Outlines before and after of what is moved [m].
    numbered : mapping of str, optional
        The number before the name of a piece or a place.
    letters : float
        Size of the letters of names [px].
    """
    sheet, told, marks = PlanSheet(plan), notes or {}, numbered or {}

    def marked(key: str, name: str) -> str:
        return f"{marks[key]} {name}" if key in marks else name

    places = [marked(place.name, say(place_name(place), language)) for place in plan.places]
    doors = [say(door_name(door), language) for door in plan.doors]
    called = [marked(piece.name, say(piece_name(piece.name), language)) for piece in pieces]
    colon = say("common.colon", language)

    def title(name: str, key: str) -> str:
        return f"{name}{colon}{told[key]}" if key in told else name

    labels: list[PlanLabel] = []
    content = [walls_svg(sheet)]
    for place, kind, name in zip(plan.places, kinds, places, strict=True):
        content.append(place_svg(sheet, place, kind, title(name, place.name)))
        labels.append(PlanLabel(wrapped(name), told.get(place.name, ""), sheet.box_of(place.corners)))
    content += [
        titled(title(name, piece.name), covers_svg(sheet, piece.covers, piece.look))
        for piece, name in zip(pieces, called, strict=True)
        if piece.covers is not None
    ]
    for piece, name in zip(pieces, called, strict=True):
        content.append(titled(title(name, piece.name), _piece_svg(sheet, piece)))
        labels.append(PlanLabel(wrapped(name), told.get(piece.name, ""), sheet.box_of(piece.outline)))
    content += [window_svg(sheet, window, language) for window in plan.windows]
    for door, name in zip(plan.doors, doors, strict=True):
        opens = say(f"room_report.{door.opens}", language)
        name_of = say("common.aside", language, content=opens)
        content.append(door_svg(sheet, door, title(name + name_of, door.name)))
        labels.append(
            PlanLabel(
                wrapped(name), told.get(door.name, ""), _before(sheet, door.wall, door.start, door.width)
            )
        )
    things = [label.box for label in labels[: len(plan.places) + len(pieces)]]
    boxes = places_of_names(labels, things, sheet.floor, letters)
    keys = [*(place.name for place in plan.places), *(piece.name for piece in pieces), *("" for _ in doors)]
    legend: list[tuple[str, str]] = []
    if marks and overlap(boxes):
        short = iter(ascii_lowercase)
        for i, (key, name) in enumerate(zip(keys, (*places, *called, *doors), strict=True)):
            if (mark := marks.get(key) or next(short, None)) is not None:
                labels[i] = labels[i]._replace(lines=(mark,))
                legend += [] if key in marks else [(mark, name)]
        boxes = places_of_names(labels, things, sheet.floor, letters)
    content += [_moved_svg(sheet, before, after) for before, after in moved]
    content += [scale_svg(sheet, language), names_svg(labels, boxes, letters)]
    listed = say("common.listed", language).join((*places, *called, *doors))
    name = say("room_report.plan_alt", language, width=plan.width, length=plan.length, content=listed)
    return DrawnPlan(svg.drawing(*sheet.size, content, name, "plan-room"), tuple(legend))


def _before(sheet: PlanSheet, wall: str, start: float, width: float) -> Box:
    """Return the floor before a door."""
    ends = [
        sheet.plan.on_wall(wall, along, into) for along in (start, start + width) for into in (0.0, width)
    ]
    return sheet.box_of(ends)


def _piece_svg(sheet: PlanSheet, piece: DrawnPiece) -> str:
    outline = sheet.polygon(piece.outline, f"standing hue{piece.look % HUES}")
    sides = zip(piece.outline, np.roll(piece.outline, -1, axis=0), strict=True)
    faces = np.array([math.cos(piece.heading), math.sin(piece.heading)])
    front = [
        sheet.polyline(np.array([start, end]) - inwards * faces, "front")
        for start, end in sides
        if _is_front(end - start, faces, float(np.ptp(piece.outline @ [-faces[1], faces[0]])))
        for inwards in (2.0 / sheet.scale,)
    ]
    return outline + "".join(front)


def _is_front(side: NDArray[np.float64], faces: NDArray[np.float64], across: float) -> bool:
    """Return whether a side of an outline faces to the front and is most of the piece's length."""
    length = float(np.hypot(*side))
    return length > 0.5 * across and float(side[1] * faces[0] - side[0] * faces[1]) > 0.99 * length


def covers_svg(sheet: PlanSheet, covers: NDArray[np.float64], look: int) -> str:
    """Return the cells on which a piece comes to lie, darker where it does so more often.

    From the eighth piece on colours come back, in stripes of cells: along x, then along y.
    """
    steps = np.ceil(STEPS * covers - 1e-9).astype(np.intp)
    if look >= HUES:
        across = look // HUES % 2
        steps = steps * (np.indices(steps.shape)[across] % 3 > 0)
    return "".join(
        svg.element("path", d=_cells(sheet, steps == step), class_=f"cover hue{look % HUES} step{step}")
        for step in range(1, STEPS + 1)
        if (steps == step).any()
    )


def _cells(sheet: PlanSheet, chosen: NDArray[np.bool_]) -> str:
    """Return the outline of cells of the floor: one rectangle for those that are side by side along x."""
    padded = np.pad(chosen, ((1, 1), (0, 0))).astype(np.int8)
    change = np.diff(padded, axis=0).T
    rows, starts = np.nonzero(change == 1)
    _, ends = np.nonzero(change == -1)
    found: list[str] = []
    for row, start, end in zip(rows.tolist(), starts.tolist(), ends.tolist(), strict=True):
        x0, y1 = sheet.place(start * CELL, row * CELL)
        x1, y0 = sheet.place(min(end * CELL, sheet.plan.width), min((row + 1) * CELL, sheet.plan.length))
        found.append(f"M{x0:.1f} {y0:.1f}H{x1:.1f}V{y1:.1f}H{x0:.1f}Z")
    return "".join(found)


def _moved_svg(sheet: PlanSheet, before: NDArray[np.float64], after: NDArray[np.float64]) -> str:
    """Return where something was moved from, and an arrow from there."""
    start, end = (np.array(sheet.place(*corners.mean(axis=0).tolist())) for corners in (before, after))
    away = end - start
    length = float(np.hypot(*away))
    parts = [sheet.polygon(before, "was")]
    if length > 1.0:
        along = away / length
        across = np.array([-along[1], along[0]])
        back = end - 10.0 * along
        head = [end, back + 5.0 * across, back - 5.0 * across]
        parts += [
            svg.polyline([start[0], back[0]], [start[1], back[1]], "move"),
            svg.polygon([(float(x), float(y)) for x, y in head], "head"),
        ]
    return "".join(parts)


def swatch_svg(look: int) -> str:
    """Return the steps of a piece's colour, for a legend."""
    boxes = (
        svg.element(
            "rect", x=8 * step - 8, y=0, width=8, height=12, class_=f"cover hue{look % HUES} step{step}"
        )
        for step in range(1, STEPS + 1)
    )
    return svg.element("svg", "".join(boxes), viewBox="0 0 80 12", class_="steps", aria_hidden="true")
