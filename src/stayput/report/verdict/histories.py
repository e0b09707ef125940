"""Time histories of a pair of runs: the floor's acceleration, tilts and slides."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.report.verdict import svg
from stayput.report.verdict.words import word

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.report.verdict.pairs import RunPair

WIDTH, HEIGHT = 900.0, 430.0
LEFT, RIGHT = 62.0, 890.0
PANELS = ((26.0, 116.0), (148.0, 262.0), (294.0, 384.0))
"""Upper and lower edge of each panel [px]."""

_TILT_SHOWN = 3.0
"""Tilts beyond this are cut, in critical angles, so that the rocking before a fall is seen."""


def histories_svg(pair: RunPair, language: str, outcomes: str) -> str:
    """Return the picture of a pair's histories over the time that is shown.

    Parameters
    ----------
    pair : Pair
        The runs.
    language : str
        "en" or "ja".
    outcomes : str
        What became of them, for those who do not see it.
    """
    x = svg.PixelAxis(pair.start, pair.end, LEFT, RIGHT)
    motion = pair.motion
    inside = (motion.time >= pair.start) & (motion.time <= pair.end)
    floor = [(motion.time[inside], motion.x[inside], 0)]
    tilts = [(side.history.time, np.degrees(side.history.tilt), n) for n, side in enumerate(pair.sides)]
    slides = [(side.history.time, 100.0 * side.history.slide, n) for n, side in enumerate(pair.sides)]
    limit = _TILT_SHOWN * math.degrees(max(pair.sides[0].run.body.slenderness))
    parts = [
        *_panel(x, PANELS[0], floor, word("axis_acceleration", language), "floor", math.inf),
        *_panel(x, PANELS[1], tilts, word("axis_tilt", language), "run", limit),
        *_panel(x, PANELS[2], slides, word("axis_slide", language), "run", math.inf),
        *_times(x, language),
        *_failures(x, pair, language),
        svg.element("line", x1=LEFT, x2=LEFT, y1=PANELS[0][0], y2=PANELS[2][1], class_="now"),
    ]
    return svg.drawing(
        WIDTH, HEIGHT, parts, word("histories_alt", language, outcomes=outcomes), "chart histories"
    )


def _panel(
    x: svg.PixelAxis,
    edges: tuple[float, float],
    lines: list[tuple[NDArray[np.float64], NDArray[np.float64], int]],
    name: str,
    class_: str,
    limit: float,
) -> list[str]:
    top, bottom = edges
    shown = [(t[(t >= x.low) & (t <= x.high)], v[(t >= x.low) & (t <= x.high)], n) for t, v, n in lines]
    peak = max((float(np.abs(v).max(initial=0.0)) for _, v, _ in shown), default=0.0)
    most = 1.08 * (min(peak, limit) or 1.0)
    y = svg.PixelAxis(-most, most, bottom, top)
    parts = [svg.label(LEFT, top - 8.0, name, "name", "start")]
    for value in svg.ticks(-most, most, 5):  # one at least on each side of 0
        level = y.place(value)
        parts.append(svg.line(LEFT, level, RIGHT, level, "grid"))
        parts.append(svg.label(LEFT - 7.0, level + 4.5, f"{value:z.4g}".replace("-", "−"), anchor="end"))
    inside: list[str] = []
    for time, values, number in reversed(shown):
        across, up = svg.thinned(time, np.clip(values, -2.0 * most, 2.0 * most))
        inside.append(svg.polyline(x.at(across), y.at(up), f"{class_} side{number}"))
    wide, high = RIGHT - LEFT, bottom - top
    window = f"{LEFT:g} {top:g} {wide:g} {high:g}"
    clip = svg.element("svg", "".join(inside), x=LEFT, y=top, width=wide, height=high, viewBox=window)
    return [*parts, clip]


def _times(x: svg.PixelAxis, language: str) -> list[str]:
    bottom = PANELS[-1][1]
    parts = [svg.line(LEFT, bottom, RIGHT, bottom, "axis")]
    for value in svg.ticks(x.low, x.high, 8):
        across = x.place(value)
        parts.append(svg.line(across, bottom, across, bottom + 5.0, "axis"))
        parts.append(svg.label(across, bottom + 19.0, f"{value:g}"))
    return [*parts, svg.label(0.5 * (LEFT + RIGHT), bottom + 38.0, word("axis_time", language), "name")]


def _failures(x: svg.PixelAxis, pair: RunPair, language: str) -> list[str]:
    """Return a line and a word where a device fails."""
    top, bottom = PANELS[1][0], PANELS[2][1]
    times = sorted({d.failure_time for side in pair.sides for d in side.run.devices if d.failed})
    parts = [svg.line(x.place(t), top, x.place(t), bottom, "broken") for t in times if x.low <= t <= x.high]
    if parts:
        right = times[0] < 0.5 * (x.low + x.high)
        across = x.place(times[0]) + (5.0 if right else -5.0)
        text = word("device_failure", language)
        parts.append(svg.label(across, top + 12.0, text, "name halo", "start" if right else "end"))
    return parts
