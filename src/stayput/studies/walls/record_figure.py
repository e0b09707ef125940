"""Figure of the study of walls under a record: ranges of wall distance that turn a body over."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK
from stayput.simulation import LAWS
from stayput.studies.walls.map import WALLS
from stayput.studies.walls.ranges import of_paper
from stayput.studies.walls.record_text import polarity_name, rows_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FILL = "#f2b48a"
"""Inside of a range that turns a body over."""

WIDEST_STEP = 0.02
"""Width of a bar of one distance, unless the distances are closer [m]."""

REACH = "#0072b2"
"""How far a body without a wall comes."""

SIDES = {"left": "wall on the left", "right": "wall on the right", "both": "walls on both sides"}


def draw_ranges(data: xr.Dataset) -> Figure:
    """Draw a panel for each law, polarity and wall: distance across, a row for each width."""
    variants = [(law, float(scale)) for law in LAWS[::-1] for scale in data["motion.scale"].to_numpy()]
    figure = new_figure(12.0, 3.0 * len(variants) + 0.9)
    panels = figure.subplots(len(variants), len(WALLS), sharex=True, sharey=True, squeeze=False)
    for row, (law, polarity) in zip(panels, variants, strict=True):
        for axis, wall in zip(row, WALLS, strict=True):
            _panel(axis, data, (law, polarity, wall))
            axis.set_title(f"law “{law}”, {polarity_name(polarity)}\n{SIDES[wall]}", fontsize=FONT)
        row[0].set_ylabel("width [m]", fontsize=FONT)
    for axis in panels[-1]:
        axis.set_xlabel("distance to the wall [m]", fontsize=FONT)
    figure.legend(
        handles=[
            Patch(facecolor=FILL, edgecolor=ALARM, hatch="////", label="turns over (T)"),
            Line2D([], [], color=ALARM, marker="X", linestyle="", label="turns over without a wall, too"),
            Patch(facecolor="none", edgecolor=INK, linewidth=1.5, label="the paper's Table 4.3 (its record)"),
            Line2D([], [], color=REACH, marker="d", linestyle="", label="how far it comes without a wall"),
        ],
        loc="outside lower center",
        ncols=4,
        fontsize=FONT,
        frameon=False,
    )
    return figure


def _panel(axis: Axes, data: xr.Dataset, variant: tuple[str, float, str]) -> None:
    law, polarity, wall = variant
    end = float(data["gap"].max())
    half = 0.5 * float(np.diff(data["gap"].to_numpy()).min(initial=WIDEST_STEP))
    for place, (b, spans, free) in enumerate(rows_of(data, variant)):
        for first, last in spans:
            low, high = max(first - half, 0.0), min(last + half, end)
            bar = (low, place - 0.27), high - low, 0.54
            axis.add_patch(Rectangle(*bar, facecolor=FILL, edgecolor=ALARM, hatch="////", linewidth=0.8))
        paper = of_paper(b)[1]
        if paper is not None:
            width = (end if math.isinf(paper[1]) else paper[1]) - paper[0]
            axis.add_patch(Rectangle((paper[0], place - 0.4), width, 0.8, fill=False, edgecolor=INK, lw=1.5))
        if free:
            axis.plot(1.04 * end, place, "X", color=ALARM, markersize=7)
    for side in ("left", "right") if wall == "both" else (wall,):
        reach = data[f"reach_{side}"].sel({"contact": law, "motion.scale": polarity}).to_numpy()
        axis.plot(reach, range(len(reach)), "d", color=REACH, markersize=5)
    axis.set_xlim(0.0, 1.08 * end)
    axis.set_yticks(range(data.sizes["body.width"]), [f"{b:g}" for b in data["body.width"].to_numpy()])
    axis.set_ylim(-0.6, data.sizes["body.width"] - 0.4)
    style(axis, zero=False)
