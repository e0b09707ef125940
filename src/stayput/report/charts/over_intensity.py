"""What overturns against the intensity of the ground: curves, and a map of sizes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import say
from stayput.fragility import JMA_INTENSITY
from stayput.fragility.curve import CurveState
from stayput.report.charts.chart import Chart
from stayput.report.figures import FONT, shaded_classes, style
from stayput.report.fonts import drawable
from stayput.report.palette import ALARM, COMPONENT_COLOURS, FAINT, INK, MUTED
from stayput.report.verdict import numbers
from stayput.verification.words import title

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.report.charts.chart import ChartSource
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

_POINTS = 96
_LOOKS = ((ALARM, "-", "o"), (COMPONENT_COLOURS["x"], "--", "s"), (COMPONENT_COLOURS["y"], "-.", "^"))
_COLOURS = "cividis_r"  # told apart with any colour blindness, and in print


def fragility_chart(verdict: Verdict, shown: Sequence[OptionVerdict], source: ChartSource) -> Chart:
    """Return the curves of some options, with their bands and what the runs gave.

    Parameters
    ----------
    verdict : Verdict
        A verdict with curves.
    shown : sequence of OptionVerdict
        Three options at most.
    source : ChartSource
        What it is of.
    """
    language = source.language
    rows: list[tuple[object, ...]] = []
    for option in shown:
        curve = option.curves[JMA_INTENSITY]
        name = option.option.name
        for level in curve.levels:
            chance = level.probability
            rows.append((name, "runs", level.im, chance.estimate, chance.low, chance.high))
        if curve.state is CurveState.FITTED:
            grid = curve.grid(_POINTS)
            low, high = curve.band(grid)
            points = zip(
                grid.tolist(), curve.probability(grid).tolist(), low.tolist(), high.tolist(), strict=True
            )
            rows += [(name, "curve", *point) for point in points]
    intensity = "floor_jma" if verdict.floor else "jma_intensity"
    names = ("option", "from", intensity, "overturned", "overturned_low", "overturned_high")

    def draw(figure: Figure) -> None:
        axis: Axes = figure.subplots()
        style(axis, zero=False)
        for option, look in zip(shown, _LOOKS, strict=False):
            _draw_curve(axis, option, title(option.option, verdict, language), look, language)
        first, last = (float(end) for end in (verdict.levels[0] - 0.1, verdict.levels[-1] + 0.1))
        _finish(axis, first, last, language, floor=verdict.floor)
        if first <= verdict.intensity <= last:
            axis.axvline(verdict.intensity, color=INK, linewidth=1.4, linestyle=":")
        axis.set_ylim(-2.0, 102.0)
        axis.set_ylabel(drawable(say("figures.axis_overturned", language)), fontsize=FONT)
        axis.legend(loc="upper left", fontsize=FONT - 1.0, framealpha=0.85, handlelength=3.6)

    columns = {name: [row[place] for row in rows] for place, name in enumerate(names)}
    caption = (
        verdict.sentence(language) + say("page.space", language) + say("figures.fragility_note", language)
    )
    return Chart(say("figures.fragility", language), caption, source, columns, draw, (8.4, 5.4))


def _draw_curve(
    axis: Axes, option: OptionVerdict, label: str, look: tuple[str, str, str], language: str
) -> None:
    colour, line, marker = look
    curve = option.curves[JMA_INTENSITY]
    half = numbers.capacity(option.capacities.get(0.5), language)
    named = say("plots.half", language, name=label, half=half)
    fitted = curve.state is CurveState.FITTED
    if fitted:
        grid = curve.grid(_POINTS)
        if not curve.one_motion:
            low, high = curve.band(grid)
            axis.fill_between(grid, 100.0 * low, 100.0 * high, color=colour, alpha=0.13, linewidth=0.0)
        axis.plot(grid, 100.0 * curve.probability(grid), color=colour, linestyle=line, linewidth=2.0)
    axis.plot(
        [level.im for level in curve.levels],
        [100.0 * level.probability.estimate for level in curve.levels],
        linestyle="none",
        marker=marker,
        markersize=5.0,
        color=colour,
        markerfacecolor="white",
        clip_on=False,
        zorder=4,
    )
    axis.plot(
        [],
        [],
        color=colour,
        linestyle=line if fitted else "none",
        marker=marker,
        markerfacecolor="white",
        label=drawable(named),
    )


def _finish(axis: Axes, first: float, last: float, language: str, floor: str = "") -> None:
    """Shade every second class of JMA's intensity, and write their names along the top; none of a floor."""
    for middle, name in () if floor else shaded_classes(axis, first, last, language):
        axis.annotate(
            name,
            (middle, 1.01),
            xycoords=("data", "axes fraction"),
            ha="center",
            fontsize=FONT - 2.0,
            color=MUTED,
        )
    axis.set_xlim(first, last)
    label = "fragility.floor_jma" if floor else "report.axis_intensity"
    axis.set_xlabel(drawable(say(label, language)), fontsize=FONT)


@dataclass(frozen=True, slots=True, eq=False)
class MappedSizes:
    """Shares that overturn by size and intensity.

    Parameters
    ----------
    axis : str
        What grows: "height", "width" or "size", which is both.
    intensity : ndarray, shape (n,)
        JMA intensities of the ground.
    width, height : ndarray, shape (k,)
        Sizes of the pieces [m].
    overturned : ndarray, shape (k, n)
        Shares; nan where such a piece is not possible, or no run of it ended.
    runs : int
        Runs of each size at each intensity.
    own : tuple of (float or None, float, float)
        Intensity, width and height of the user's own piece.
    """

    axis: str
    intensity: NDArray[np.float64]
    width: NDArray[np.float64]
    height: NDArray[np.float64]
    overturned: NDArray[np.float64]
    runs: int
    own: tuple[float | None, float, float]


def sizes_chart(sizes: MappedSizes, source: ChartSource) -> Chart:
    """Return the map of what overturns by size and intensity.

    Parameters
    ----------
    sizes : MappedSizes
        The shares.
    source : ChartSource
        What it is of.
    """
    language = source.language
    wide = sizes.axis == "width"
    up = 100.0 * (sizes.width if wide else sizes.height)
    k, n = sizes.overturned.shape
    columns = {
        "width_m": np.repeat(sizes.width, n).tolist(),
        "height_m": np.repeat(sizes.height, n).tolist(),
        "jma_intensity": np.tile(sizes.intensity, k).tolist(),
        "overturned": sizes.overturned.ravel().tolist(),
    }

    def draw(figure: Figure) -> None:
        axis: Axes = figure.subplots()
        axis.set_facecolor(FAINT)
        xs, ys = _edges(sizes.intensity), _edges(up)
        shares = np.ma.masked_invalid(100.0 * sizes.overturned)
        cells = axis.pcolormesh(xs, ys, shares, cmap=_COLOURS, vmin=0.0, vmax=100.0)
        bar = figure.colorbar(cells, ax=axis)
        bar.set_label(drawable(say("figures.axis_overturned", language)), fontsize=FONT)
        own, width, height = sizes.own
        if own is not None:
            at = min(max(own, float(xs[0])), float(xs[-1]))
            label = drawable(say("figures.own_piece", language))
            axis.plot(at, 100.0 * (width if wide else height), "*", color=ALARM, markersize=14.0, label=label)
            axis.legend(loc="upper left", fontsize=FONT - 1.0)
        axis.tick_params(labelsize=FONT - 1.0, colors=INK)
        axis.set_ylim(float(ys[0]), float(ys[-1]))
        axis.set_ylabel(
            drawable(say("figures.axis_depth" if wide else "figures.axis_height", language)), fontsize=FONT
        )
        _finish(axis, float(xs[0]), float(xs[-1]), language)

    caption = say("figures.sizes_note", language, runs=sizes.runs)
    return Chart(say("figures.sizes", language), caption, source, columns, draw, (8.4, 5.0))


def _edges(middles: ArrayLike) -> NDArray[np.float64]:
    """Return the edges of cells around their middles."""
    values = np.asarray(middles, dtype=np.float64)
    between = 0.5 * (values[1:] + values[:-1])
    return np.concatenate([[2.0 * values[0] - between[0]], between, [2.0 * values[-1] - between[-1]]])
