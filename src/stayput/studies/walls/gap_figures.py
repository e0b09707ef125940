"""Figures of the study of walls under a sine: the map, and the 15 % rule under other inputs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon, Rectangle

from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from stayput.simulation import LAWS
from stayput.studies.walls.gap_text import in_words
from stayput.studies.walls.map import WALLS
from stayput.studies.walls.rule import NEAR, SHARES, TURNS_OVER, WIDE

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

FALLEN = "#f2b48a"
"""A body that turns over."""

SIDES = {"left": "wall on the left", "right": "wall on the right", "both": "walls on both sides"}

STILL, STANDS, HOLDS, BROKEN, ANYWAY = range(5)
"""Kinds of inputs under which the rule is tested."""

KINDS = (
    ("none tilts without a wall", "#dfe3e8", ""),
    ("none turns over", "#ffffff", ""),
    ("turnover at some distance, none nearer than 15 %", "#bfe0f2", "..."),
    ("rule broken; none turns over without a wall", "#f7d08a", "///"),
    ("rule broken; some turn over without a wall", "#e8946a", "xxx"),
)
"""Label, colour and hatch of each kind."""


def draw_map(data: xr.Dataset) -> Figure:
    """Draw turnover over width and distance, a panel for each law and wall; without a wall on top."""
    figure = new_figure(12.0, 7.6)
    panels = figure.subplots(len(LAWS), len(WALLS), sharex=True, sharey=True)
    for row, law in zip(panels, LAWS[::-1], strict=True):
        for axis, wall in zip(row, WALLS, strict=True):
            _map_panel(axis, data, law, wall)
            axis.set_title(f"law “{law}”, {SIDES[wall]}", fontsize=FONT)
        row[0].set_ylabel("distance to the wall [m]", fontsize=FONT)
    for axis in panels[-1]:
        axis.set_xlabel("width [m]", fontsize=FONT)
    figure.suptitle(f"{data.attrs['motion']}, b/h = {data.attrs['map_aspect_ratio']:g}", fontsize=FONT + 1.0)
    figure.legend(
        handles=[
            Patch(facecolor=FALLEN, edgecolor=ALARM, label="turns over"),
            Line2D([], [], color=ALARM, marker="X", linestyle="", label="turns over without a wall"),
            Line2D([], [], color=INK, linestyle="--", label=f"distance = {100 * NEAR:.0f} % of the width"),
            Patch(facecolor="none", edgecolor=INK, linewidth=1.6, label="paper: no turnover here"),
            Line2D([], [], color=INK, linewidth=4.0, label="paper: turns over even at a small distance"),
        ],
        loc="outside lower center",
        ncols=3,
        fontsize=FONT,
        frameon=False,
    )
    return figure


def _map_panel(axis: Axes, data: xr.Dataset, law: str, wall: str) -> None:
    widths, gaps = data["body.width"].to_numpy(), data["gap"].to_numpy()
    fallen = data["overturned"].sel(contact=law, wall=wall).to_numpy().T
    edges = _edges(widths), _edges(gaps)
    axis.pcolormesh(*edges, np.where(fallen, 0.0, np.nan), cmap=ListedColormap([FALLEN]))
    axis.plot(widths, NEAR * widths, color=INK, linestyle="--", linewidth=1.0)
    last = max(widths[-1], WIDE)
    corners = [(WIDE, 0.0), (last, 0.0), (last, NEAR * last), (WIDE, NEAR * WIDE)]
    axis.add_patch(Polygon(corners, fill=False, edgecolor=INK, linewidth=1.6))
    axis.plot(TURNS_OVER, (0.0, 0.0), color=INK, linewidth=4.0, solid_capstyle="butt", clip_on=False)
    free = widths[data["overturned_free"].sel(contact=law).to_numpy()]
    top = 1.05 * gaps[-1]
    axis.plot(free, np.full(len(free), top), "X", color=ALARM, markersize=5)
    axis.set_xlim(edges[0][0], edges[0][-1])
    axis.set_ylim(0.0, 1.1 * gaps[-1])
    style(axis, zero=False)


def _edges(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the limits of cells about increasing values; the first cell starts at no less than 0."""
    middles = 0.5 * (values[1:] + values[:-1])
    half = 0.5 * np.diff(values) if len(values) > 1 else np.array([0.01])
    return np.concatenate(([max(values[0] - half[0], 0.0)], middles, [values[-1] + half[-1]]))


def draw_rule(data: xr.Dataset) -> Figure:
    """Draw the kind of each input and the nearest wall that turns a body over, by law and aspect ratio."""
    ratios = data["aspect_ratio"].to_numpy()
    figure = new_figure(max(2.6 * len(ratios) + 0.6, 8.0), 6.6)
    panels = figure.subplots(len(LAWS), len(ratios), sharex=True, sharey=True, squeeze=False)
    for row, law in zip(panels, LAWS[::-1], strict=True):
        for axis, ratio in zip(row, ratios, strict=True):
            _rule_panel(axis, data.sel(contact=law, aspect_ratio=ratio))
            axis.set_title(f"law “{law}”, b/h = {ratio:g}", fontsize=FONT)
        row[0].set_ylabel("frequency [Hz]", fontsize=FONT)
    for axis in panels[-1]:
        axis.set_xlabel("amplitude [m/s²]", fontsize=FONT)
    figure.suptitle(
        "Nearest wall that turns over a body wider than 1 m [% of its width]; "
        f"–: none up to {100 * SHARES[-1]:.0f} %; *: some turn over without a wall",
        fontsize=FONT + 1.0,
    )
    handles = [
        Patch(facecolor=colour, edgecolor=MUTED, hatch=hatch, label=label) for label, colour, hatch in KINDS
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=FONT, frameon=False)
    return figure


def _rule_panel(axis: Axes, data: xr.Dataset) -> None:
    amplitudes, frequencies = data["amplitude"].to_numpy(), data["frequency"].to_numpy()
    for i, frequency in enumerate(frequencies):
        for j, amplitude in enumerate(amplitudes):
            cell = data.sel(frequency=frequency, amplitude=amplitude)
            _, colour, hatch = KINDS[_kind(cell)]
            place = (j - 0.5, i - 0.5), 1.0, 1.0
            axis.add_patch(Rectangle(*place, facecolor=colour, edgecolor=MUTED, hatch=hatch, linewidth=0.6))
            box = {"facecolor": "white", "edgecolor": "none", "pad": 1.2}
            axis.text(j, i, in_words(cell), ha="center", va="center", fontsize=FONT, color=INK, bbox=box)
    axis.set_xticks(range(len(amplitudes)), [f"{value:g}" for value in amplitudes])
    axis.set_yticks(range(len(frequencies)), [f"{value:g}" for value in frequencies])
    axis.set_xlim(-0.5, len(amplitudes) - 0.5)
    axis.set_ylim(-0.5, len(frequencies) - 0.5)
    axis.tick_params(labelsize=FONT - 1.0, colors=INK)


def _kind(cell: xr.Dataset) -> int:
    if float(cell["broken_share"]) > 0.0:
        return ANYWAY if float(cell["free_share"]) > 0.0 else BROKEN
    if float(cell["free_share"]) > 0.0 or not np.isnan(float(cell["nearest_wall"])):
        return HOLDS
    return STANDS if float(cell["free_tilt"]) > 0.0 else STILL
