"""Shared by all plots: figures without pyplot (thread-safe, headless), their style and files."""

from __future__ import annotations

import base64
import math
from collections.abc import Callable, Iterator
from io import BytesIO
from pathlib import Path
from typing import Any, Literal

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter, StrMethodFormatter

from stayput.catalogue import say
from stayput.catalogue.names import INTENSITIES
from stayput.errors import InputError
from stayput.files import PLOT_SUFFIXES, check_target, draft
from stayput.motion.intensity import CLASSES
from stayput.report.fonts import drawable, with_fallback
from stayput.report.palette import FAINT, INK, MUTED

LINE = "drawn"
"""What marks the line of a value on axes, by which the lines there are counted."""

_ZERO = "zero"
"""What marks the line at zero."""

LINE_COLOURS = ("#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#0072b2")
"""Colours of further lines on the same axes, of Okabe and Ito."""

FONT = 10.0
"""Size of the labels [points]."""


def new_figure(width: float, height: float, title: str = "") -> Figure:
    """Return a figure of a size in inches, empty but for a title."""
    figure = Figure(figsize=(width, height), dpi=120, layout="constrained", facecolor="white")
    FigureCanvasAgg(figure)
    if title:
        figure.suptitle(drawable(title), fontsize=FONT + 2.0, color=INK)
    return figure


def label_axes(axis: Axes, language: str, x: str = "", y: str = "", **values: object) -> None:
    """Label an axis along x, y or both, by the ids of the texts and the values in them."""
    if x:
        axis.set_xlabel(say(x, language, **values), fontsize=FONT)
    if y:
        axis.set_ylabel(say(y, language, **values), fontsize=FONT)


def legend_within(axis: Axes, place: Literal["best", "upper right", "lower left"] = "best") -> None:
    """Explain the lines of an axis within it."""
    axis.legend(loc=place, fontsize=FONT - 1.5, framealpha=0.85)


def axes_of(ax: Axes | None) -> Axes:
    """Return the axes to draw on: those given, or those of a new figure of pyplot, which notebooks show.

    Raises
    ------
    InputError
        Something else than axes, such as the array of them that ``subplots`` returns; axes of another
        projection, such as polar ones.
    """
    if ax is None:
        from matplotlib import pyplot  # which chooses how figures are shown, and is slow to load

        return pyplot.subplots(layout="constrained")[1]
    if not isinstance(ax, Axes):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InputError("plots.not_axes", "ax", kind=type(ax).__name__)
    if ax.name != "rectilinear":
        raise InputError("plots.projection", "ax", projection=repr(ax.name))
    return ax


def plotted(ax: Axes | None, draw: Callable[..., Any], *arguments: Any, **line: Any) -> Axes:
    """Draw on axes, or on those of a new figure, by a function that takes them first; return them."""
    axis = axes_of(ax)
    draw(axis, *arguments, **line)
    return drawn(axis)


def drawn(ax: Axes) -> Axes:
    """Return axes once they are drawn: with fonts that have the letters of their texts.

    Texts that are written later, such as those of a legend that is made anew, find the same fonts.
    """
    for family in with_fallback(ax):
        if family not in mpl.rcParams["font.family"]:
            mpl.rcParams["font.family"] = [*mpl.rcParams["font.family"], family]
    return ax


def colour_beside(axis: Axes, first: str) -> str:
    """Return the colour of the next line of axes: the first one's own, then others in turn."""
    lines = sum(line.get_gid() == LINE for line in axis.lines)
    return LINE_COLOURS[(lines - 1) % len(LINE_COLOURS)] if lines else first


def saved(figure: Figure, path: str | Path | None) -> Figure:
    """Save a figure atomically where a path is given: PNG, SVG or PDF by its ending."""
    with_fallback(figure)
    if path is not None:
        target = check_target(path, PLOT_SUFFIXES)
        content = BytesIO()  # Matplotlib's PDF and SVG of a disk that gets full end in errors of their own
        figure.savefig(content, format=target.suffix[1:].lower())
        with draft(target) as unfinished:
            unfinished.write_bytes(content.getbuffer())
    return figure


def embedded(figure: Figure, form: Literal["png", "svg"]) -> str:
    """Return a figure as the address of an image that holds it, the same for the same figure."""
    content = BytesIO()
    with mpl.rc_context({"svg.hashsalt": "stayput"}):
        figure.savefig(content, format=form, metadata={"Date": None} if form == "svg" else None)
    kind = "svg+xml" if form == "svg" else form
    return f"data:image/{kind};base64,{base64.b64encode(content.getvalue()).decode('ascii')}"


def style(axis: Axes, *, zero: bool = True) -> None:
    """Give an axis the grid and the sizes of all plots, and a line at zero where that means something."""
    axis.tick_params(labelsize=FONT - 1.0, colors=INK)
    axis.grid(True, color=FAINT, linewidth=0.7)
    axis.set_axisbelow(True)
    if zero and not any(line.get_gid() == _ZERO for line in axis.lines):
        axis.axhline(0.0, color=MUTED, linewidth=0.6, gid=_ZERO)
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)


def plain_log(axis: Axes, *, x: bool = True, y: bool = True) -> None:
    """Make axes logarithmic, with numbers instead of powers."""
    if x:
        axis.set_xscale("log")
    if y:
        axis.set_yscale("log")
    for wanted, line in ((x, axis.xaxis), (y, axis.yaxis)):
        if wanted:
            line.set_major_formatter(StrMethodFormatter("{x:g}"))
            line.set_minor_formatter(NullFormatter())


def shaded_classes(axis: Axes, first: float, last: float, language: str) -> Iterator[tuple[float, str]]:
    """Shade every second class of JMA's intensity along x, and yield where the names of wide ones stand.

    Parameters
    ----------
    axis : Axes
        The axis, along whose x are intensities.
    first, last : float
        Its ends.
    language : str
        "en" or "ja", of the names.

    Yields
    ------
    tuple
        The middle of a class within the ends, and its name.
    """
    for shaded, name, low, high in classes_between(first, last):
        if shaded:
            axis.axvspan(low, high, color=FAINT, alpha=0.35, linewidth=0.0, zorder=0)
        if high - low > 0.05 * (last - first):
            yield 0.5 * (low + high), drawable(say(INTENSITIES[name], language).removeprefix("震度"))


def classes_between(first: float, last: float) -> Iterator[tuple[bool, str, float, float]]:
    """Yield JMA's classes between two intensities: whether one is shaded, every second, its name and ends."""
    ends = [start for _, start in CLASSES[1:]] + [math.inf]
    for place, ((name, start), end) in enumerate(zip(CLASSES, ends, strict=True)):
        low, high = max(start, first), min(end, last)
        if high > low:
            yield place % 2 == 1, name, low, high
