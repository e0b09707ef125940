"""Shared by all plots: figures without pyplot (thread-safe, headless), their style and files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from stayput.files import PLOT_SUFFIXES, check_target, draft
from stayput.report.fonts import with_fallback
from stayput.report.palette import FAINT, INK, MUTED

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes

FONT = 10.0
"""Size of the labels [points]."""


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of a size in inches."""
    figure = Figure(figsize=(width, height), dpi=120, layout="constrained", facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def saved(figure: Figure, path: str | Path | None) -> Figure:
    """Save a figure atomically where a path is given: PNG, SVG or PDF by its ending."""
    with_fallback(figure)
    if path is not None:
        target = check_target(path, PLOT_SUFFIXES)
        with draft(target) as unfinished:
            figure.savefig(unfinished)
    return figure


def style(axis: Axes, *, zero: bool = True) -> None:
    """Give an axis the grid and the sizes of all plots, and a line at zero where that means something."""
    axis.tick_params(labelsize=FONT - 1.0, colors=INK)
    axis.grid(True, color=FAINT, linewidth=0.7)
    axis.set_axisbelow(True)
    if zero:
        axis.axhline(0.0, color=MUTED, linewidth=0.6)
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)


def _plain_number(value: float, _: int | None = None) -> str:
    return f"{value:g}"


def plain_log(axis: Axes, *, x: bool = True, y: bool = True) -> None:
    """Make axes logarithmic, with numbers instead of powers."""
    if x:
        axis.set_xscale("log")
    if y:
        axis.set_yscale("log")
    for wanted, line in ((x, axis.xaxis), (y, axis.yaxis)):
        if wanted:
            line.set_major_formatter(FuncFormatter(_plain_number))
            line.set_minor_formatter(NullFormatter())
