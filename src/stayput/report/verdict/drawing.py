"""The piece, its room and its devices, to scale and from the side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.measures import Held, hold, sketch
from stayput.measures.element import at_rest
from stayput.model.state import State, standing_corners, wall_faces
from stayput.report.names import named
from stayput.report.verdict import svg
from stayput.report.verdict.numbers import word

if TYPE_CHECKING:
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

HIGH = 250.0
"""Height of a drawing without its margins [px]."""

MARGIN = 30.0


@dataclass(frozen=True, slots=True)
class Sheet:
    """Extent and scale of the drawing.

    Parameters
    ----------
    left, right, top : float
        Ends of what is shown [m]; the floor is at 0.
    scale : float
        Pixels a metre.
    """

    left: float
    right: float
    top: float
    scale: float

    def place(self, x: float, z: float) -> tuple[float, float]:
        """Return where a point of the room lies [px]."""
        return MARGIN + (x - self.left) * self.scale, 8.0 + (self.top - z) * self.scale

    @property
    def width(self) -> float:
        """Width of the drawing [px]."""
        return 2.0 * MARGIN + (self.right - self.left) * self.scale

    @property
    def height(self) -> float:
        """Height of the drawing [px]."""
        return 8.0 + MARGIN + self.top * self.scale


def sheet_of(held: Held) -> Sheet:
    """Return the extent of a body's drawing: with walls and ceiling where they are near."""
    body, room = held.body, held.room
    size = max(body.width, body.height)
    half, high = 0.5 * body.width, body.height
    left, right = -half - 0.12 * size, half + 0.22 * size
    at_left, at_right = wall_faces(body, room)
    if room.left_wall is not None and room.left_wall.gap <= 0.5 * size:
        left = min(left, at_left - 0.04 * size)
    if room.right_wall is not None and room.right_wall.gap <= 0.5 * size:
        right = max(right, at_right + 0.04 * size)
    near = room.ceiling is not None and room.ceiling.height <= high + 0.8 * size
    top = room.ceiling.height + 0.03 * size if near and room.ceiling is not None else 1.06 * high
    return Sheet(left, right, top, HIGH / top)


def drawing_svg(verdict: Verdict, result: OptionVerdict, language: str, label: str) -> str:
    """Return a drawing of the piece with measures in place, in the colour of how firmly it then stands.

    Parameters
    ----------
    verdict : Verdict
        Whose scenario is drawn, as it is stated.
    result : OptionVerdict
        The result with the measures.
    language : str
        "en" or "ja".
    label : str
        What the measures are called.
    """
    scenario = verdict.scenario
    held = hold(scenario.piece.body(), scenario.room.room(), result.option.measures)
    sheet, piece = sheet_of(held), named(scenario.piece.title, language)
    width, height = (f"{100.0 * size:.3g}" for size in (held.body.width, held.body.height))
    name = word("drawing_alt", language, piece=piece, width=width, height=height, label=label)
    parts = [*_room(held, sheet), *piece_svg(held, sheet.place), *_centre(held, sheet), *_sizes(held, sheet)]
    look = f"--piece: var(--{result.pieces[0].stability})"
    return svg.drawing(sheet.width, sheet.height, parts, name, "plan", style=look)


def _room(held: Held, sheet: Sheet) -> list[str]:
    room = held.room
    at_left, at_right = wall_faces(held.body, room)
    far_left, floor = sheet.place(sheet.left, 0.0)
    far_right, top = sheet.place(sheet.right, sheet.top)
    parts = [
        svg.box(far_left, floor, far_right, floor + 8.0, "room"),
        svg.line(far_left, floor, far_right, floor, "face"),
    ]
    for wall, x, edge in ((room.left_wall, at_left, far_left), (room.right_wall, at_right, far_right)):
        if wall is not None and sheet.left < x < sheet.right:
            across = sheet.place(x, 0.0)[0]
            parts += [svg.box(edge, top, across, floor, "room"), svg.line(across, top, across, floor, "face")]
    if room.ceiling is not None and room.ceiling.height < sheet.top:
        high = sheet.place(0.0, room.ceiling.height)[1]
        parts.append(svg.box(far_left, top, far_right, high, "room"))
        parts.append(svg.line(far_left, high, far_right, high, "face"))
    return parts


def piece_svg(held: Held, place: Callable[[float, float], tuple[float, float]]) -> list[str]:
    """Return a piece at rest with its devices, whose points of the room [m] are placed on a drawing."""
    body = held.body
    a, b, c, d = standing_corners(body, State())
    parts = [svg.polygon([place(*corner) for corner in (a, b, d, c)], "piece")]
    for shape in sketch(held):
        points = [place(*point) for point in shape.points]
        if shape.kind == "polygon":
            parts.append(svg.polygon(points, f"shape {shape.role}"))
        else:
            across, up = zip(*points, strict=True)
            parts.append(svg.polyline(across, up, f"shape {shape.role} open"))
    return parts


def _centre(held: Held, sheet: Sheet) -> list[str]:
    """Return the mark of the centre of gravity."""
    u, v = sheet.place(*at_rest(held.body, held.body.centre_of_gravity))
    return [
        svg.element("circle", cx=u, cy=v, r=3.5, class_="centre"),
        svg.line(u - 6.0, v, u + 6.0, v, "axis"),
        svg.line(u, v - 6.0, u, v + 6.0, "axis"),
    ]


def _sizes(held: Held, sheet: Sheet) -> list[str]:
    """Return the piece's depth below it and its height beside it."""
    body = held.body
    left, floor = sheet.place(-0.5 * body.width, 0.0)
    right, top = sheet.place(0.5 * body.width, body.height)
    across = min(right + 16.0, sheet.width - 14.0)
    size = svg.label(0.0, 0.0, f"{100.0 * body.height:.3g} cm")
    middle = 0.5 * (floor + top)
    return [
        svg.label(0.5 * (left + right), floor + 24.0, f"{100.0 * body.width:.3g} cm"),
        svg.line(across, floor, across, top, "size"),
        svg.line(across - 3.0, top, across + 3.0, top, "size"),
        svg.line(across - 3.0, floor, across + 3.0, floor, "size"),
        svg.element("g", size, transform=f"translate({across + 13.0:.1f} {middle:.1f}) rotate(-90)"),
    ]
