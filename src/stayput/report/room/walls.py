"""Walls with their openings and the scale of a plan."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import say
from stayput.model.room import WALLS_AROUND
from stayput.report.room.sheet import WALL, titled
from stayput.report.verdict import svg

if TYPE_CHECKING:
    from stayput.model.floor_plan import Door, Window
    from stayput.report.room.sheet import PlanSheet

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
    panes = [
        sheet.polyline(
            [sheet.plan.on_wall(wall, along, -part * WALL / sheet.scale) for along in ends], "pane"
        )
        for part in (0.1, 0.5, 0.9)
    ]
    title = say("room_report.window", language, width=window.width)
    return titled(title, _hole(sheet, wall, window.start, window.width), *panes)


def door_svg(sheet: PlanSheet, door: Door, title: str) -> str:
    """Return a door: its leaf where it stands open, and the arc of its edge; two panels of a sliding one."""
    hole = _hole(sheet, door.wall, door.start, door.width)
    return titled(title, hole, *(_panels(sheet, door) if door.opens == "sliding" else _leaf(sheet, door)))


def _panels(sheet: PlanSheet, door: Door) -> list[str]:
    part = 0.55 * door.width
    ends = (
        (door.start, door.start + part, 0.3),
        (door.start + door.width - part, door.start + door.width, 0.7),
    )
    return [
        sheet.polyline(
            [sheet.plan.on_wall(door.wall, along, -depth * WALL / sheet.scale) for along in (low, high)],
            "leaf",
        )
        for low, high, depth in ends
    ]


def _leaf(sheet: PlanSheet, door: Door) -> list[str]:
    angle = np.linspace(0.0, 0.5 * math.pi, ARC + 1)
    into = np.sin(angle) * (-door.width if door.opens == "outwards" else door.width)
    reach = np.cos(angle) * door.width
    along = door.start + (reach if door.hinge == "start" else door.width - reach)
    edge = [
        sheet.plan.on_wall(door.wall, *point) for point in zip(along.tolist(), into.tolist(), strict=True)
    ]
    hinge = sheet.plan.on_wall(door.wall, along[-1].item())
    return [sheet.polyline(edge, "swing"), sheet.polyline([hinge, edge[-1]], "leaf")]


def scale_svg(sheet: PlanSheet, language: str) -> str:
    """Return metres along the near and the left wall, and the names of all walls."""
    plan, (x0, y0, x1, y1) = sheet.plan, sheet.floor
    low, left = y1 + WALL + sheet.beyond("near_side_wall"), x0 - WALL - sheet.beyond("left_wall")
    count = 1 + round(5.0 * max(plan.width, plan.length) / (plan.width + plan.length))
    parts: list[str] = []
    for value in svg.ticks(0.0, max(plan.width, plan.length), 2 * count):
        told = say("room_report.metres", language, value=round(value, 6))
        if value <= plan.width + 1e-9:
            x, _ = sheet.place(value, 0.0)
            parts += [svg.line(x, low, x, low + 5.0, "axis"), svg.label(x, low + 18.0, told)]
        if value <= plan.length + 1e-9:
            _, y = sheet.place(0.0, value)
            parts += [
                svg.line(left - 5.0, y, left, y, "axis"),
                svg.label(left - 8.0, y + 4.0, told, anchor="end"),
            ]
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
