"""A piece with its devices from the front and from the side, to scale on paper."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from stayput.catalogue import say
from stayput.measures import Held, Shape, sketch
from stayput.model.state import State, standing_corners, wall_faces
from stayput.report.verdict import svg
from stayput.rooms.step_words import held_by
from stayput.verification.room_words import piece_name

if TYPE_CHECKING:
    from stayput.rooms.steps import ActionPlan, Fix


UNIT = 1e-4
"""A unit of the drawing on paper [m]: a tenth of a millimetre."""

MARGIN, ABOVE, BELOW = 75.0, 14.0, 60.0
"""Space at the sides for heights, above, and below for lengths and names."""

HEAD = 0.08
"""What is seen above a piece and its devices [m]."""


PLAN_SCALES = (25, 40, 50, 75, 100, 150, 200, 300, 500, 1000)
"""Scales that a plan is drawn to: metres of the room in a metre of paper."""

ELEVATION_SCALES = (20, 25, 30, 40, 50, 75, 100)
"""The same of the elevations."""


class CardSizes(NamedTuple):
    """Sizes on paper, which suit so many blocks of text.

    Parameters
    ----------
    blocks : float
        Most blocks of text: a step is one, and another way to do it is one more.
    letters : float
        Size of the letters [pt].
    plan : tuple of float
        Most that the plan takes up, wide and high [m].
    elevations : tuple of float
        Most width of an elevation, and most height of all together [m].
    """

    blocks: float
    letters: float
    plan: tuple[float, float]
    elevations: tuple[float, float]


SIZES = (
    CardSizes(2, 10.0, (0.104, 0.086), (0.075, 0.092)),
    CardSizes(4, 8.6, (0.090, 0.068), (0.070, 0.092)),
    CardSizes(6, 7.7, (0.084, 0.062), (0.060, 0.125)),
    CardSizes(math.inf, 6.9, (0.080, 0.058), (0.060, 0.130)),
)
"""Sizes for few blocks, and for more of them."""


def elevation_svg(fix: Fix, name: str, scale: int, language: str) -> str:
    """Return a piece with its measures in place, from the front and from the side.

    Parameters
    ----------
    fix : Fix
        The measures, and the piece with them.
    name : str
        The piece.
    scale : int
        Metres of the room in a metre of paper.
    language : str
        "en" or "ja".
    """
    view = _view(fix, scale)
    wide, high = (1e3 * UNIT * size for size in (view.width, view.height))
    return svg.drawing(
        view.width,
        view.height,
        [*view.front(fix), *view.side(), *view.names(language)],
        say("action_plan.elevation_alt", language, piece=say(piece_name(name), language)),
        "elevation",
        style=f"width:{wide:.1f}mm;height:{high:.1f}mm",
    )


def _view(fix: Fix, scale: int) -> _View:
    return _View(held_by(fix), fix.piece.at[2], 1.0 / (scale * UNIT))


class _View:
    """Where front and side stand on the paper.

    Parameters
    ----------
    held : Held
        The piece with its devices, each by itself.
    base : float
        How high its base is above the floor [m].
    metre : float
        A metre of the room in units of the drawing.
    """

    def __init__(self, held: Held, base: float, metre: float) -> None:
        self.held, self.base, self.metre = held, base, metre
        body = held.body
        self.length, self.depth = body.length or body.width, body.width
        ends = (element.point[1] + element.rise for element in held.elements)
        ceiling = held.room.ceiling
        poles = any(measure.needs == "ceiling" for measure in held.measures)
        self.ceiling = ceiling.height if poles and ceiling is not None else None
        self.top = (self.ceiling or base + max([body.height, *ends])) + HEAD
        behind, _ = wall_faces(body, held.room) if held.room.left_wall is not None else (-0.5 * self.depth, 0)
        self.wall = behind
        self.front_at = MARGIN + 0.5 * self.metre * self.length
        self.side_at = MARGIN + self.metre * (self.length + 0.12) - self.metre * self.wall + 30.0
        self.width = self.side_at + self.metre * (0.5 * self.depth + 0.1) + 12.0
        self.height = ABOVE + self.metre * self.top + BELOW

    def up(self, z: float) -> float:
        """Return where a height above the floor [m] is on the paper."""
        return ABOVE + self.metre * (self.top - z)

    def front(self, fix: Fix) -> Iterator[str]:
        """Yield the front, with the devices where they are along it, and their heights and distances."""
        half, high, held = 0.5 * self.length, self.base + self.held.body.height, self.held
        left, right = self.front_at - self.metre * half, self.front_at + self.metre * half
        yield svg.line(left - 25.0, self.up(0.0), right + 25.0, self.up(0.0), "face")
        if self.ceiling is not None:
            yield svg.line(left - 25.0, self.up(self.ceiling), right + 25.0, self.up(self.ceiling), "face")
        yield svg.box(left, self.up(self.base), right, self.up(high), "piece")
        heights, dimension = {high}, ""
        for measure in (purchase.measure for purchase in fix.purchases):
            for shape in measure.outlines(held.body):
                yield self._from_the_front(shape, at_corners=measure.base == "feet")
            for element in held.devices(measure.kind):
                x = self.front_at + self.metre * element.across
                shapes = measure.device_shapes(element, held.body, held.room)
                for shape in shapes:
                    low, top = self._heights(shape)
                    yield svg.box(x - 3.0, low, x + 3.0, top, f"shape {shape.role}")
                if measure.needs:
                    heights.add(self.base + max(z for shape in shapes for _, z in shape.points))
                    dimension = measure.kind
        for height in sorted(heights):
            yield svg.line(left - 22.0, self.up(height), left - 4.0, self.up(height), "size")
            yield svg.label(left - 24.0, self.up(height) + 7.0, f"{height:.2f}", anchor="end")
        if dimension:
            yield from self._distances(dimension)

    def _heights(self, shape: Shape) -> tuple[float, float]:
        """Return between which heights a shape is on the paper."""
        heights = [self.up(self.base + z) for _, z in shape.points]
        return max(heights), min(heights)

    def _from_the_front(self, shape: Shape, *, at_corners: bool) -> str:
        """Return what is under or in the piece: at its corners as from the side, else from end to end."""
        more, kind = 0.5 * (self.length - self.depth), f"shape {shape.role}"
        if at_corners:
            across = (self.front_at + self.metre * (x + math.copysign(more, x)) for x, _ in shape.points)
            return svg.polygon(
                [(x, self.up(self.base + z)) for x, (_, z) in zip(across, shape.points, strict=True)], kind
            )
        half = 0.5 * self.metre * self.length
        low, high = self._heights(shape)
        return svg.box(self.front_at - half, low, self.front_at + half, high, kind)

    def _distances(self, kind: str) -> Iterator[str]:
        """Yield marks below the floor where devices are, and how far they are apart."""
        places = sorted({element.across for element in self.held.devices(kind)})
        marks = [self.front_at + self.metre * x for x in (-0.5 * self.length, *places, 0.5 * self.length)]
        level = self.up(0.0) + 10.0
        yield svg.line(marks[0], level, marks[-1], level, "size")
        for x in marks:
            yield svg.line(x, level - 4.0, x, level + 4.0, "size")
        if len(places) > 1:
            yield svg.label(
                0.5 * (marks[1] + marks[2]), level + 22.0, f"{places[1] - places[0]:.3g}", anchor="middle"
            )

    def side(self) -> Iterator[str]:
        """Yield the side, with the wall behind, and the piece at rest with the devices as they are."""
        held, (a, b, c, d) = self.held, standing_corners(self.held.body, State())
        wall = self.side_at + self.metre * self.wall
        right = self.side_at + self.metre * (0.5 * self.depth + 0.1)
        yield svg.line(wall, self.up(0.0), right, self.up(0.0), "face")
        if held.room.left_wall is not None:
            yield svg.box(wall - 10.0, self.up(self.top), wall, self.up(0.0), "room")
            yield svg.line(wall, self.up(self.top), wall, self.up(0.0), "face")
        if self.ceiling is not None:
            yield svg.line(wall, self.up(self.ceiling), right, self.up(self.ceiling), "face")

        def place(x: float, z: float) -> tuple[float, float]:
            return self.side_at + self.metre * x, self.up(self.base + z)

        yield svg.polygon([place(*corner) for corner in (a, b, d, c)], "piece")
        for shape in sketch(held):
            points = [place(*point) for point in shape.points]
            if shape.kind == "polygon":
                yield svg.polygon(points, f"shape {shape.role}")
            else:
                across, up = zip(*points, strict=True)
                yield svg.polyline(across, up, f"shape {shape.role} open")

    def names(self, language: str) -> Iterator[str]:
        """Yield which view is which."""
        level = self.height - 3.0
        yield svg.label(self.front_at, level, say("action_plan.front", language))
        yield svg.label(self.side_at, level, say("action_plan.side", language))


def sizes_of(plan: ActionPlan) -> CardSizes:
    """Return the sizes that suit a plan."""
    blocks = len(plan.steps) + sum(step.instead is not None for step in plan.steps) + len(plan.drilled)
    return next(sizes for sizes in SIZES if blocks <= sizes.blocks)


def plan_scale(metres: Sequence[float], sizes: CardSizes) -> int:
    """Return the largest scale of a plan that is so wide and so high with its margins [m]."""
    (wide, high), (most_wide, most_high) = metres, sizes.plan
    fitting = (scale for scale in PLAN_SCALES if wide / scale <= most_wide and high / scale <= most_high)
    return next(fitting, PLAN_SCALES[-1])


def elevation_scale(fixes: Sequence[Fix], sizes: CardSizes) -> int:
    """Return the largest scale to which all elevations are drawn."""
    wide, high = (size / UNIT for size in sizes.elevations)

    def fits(scale: int) -> bool:
        views = [_view(fix, scale) for fix in fixes]
        return all(view.width <= wide for view in views) and sum(view.height for view in views) <= high

    return next(filter(fits, ELEVATION_SCALES), ELEVATION_SCALES[-1])
