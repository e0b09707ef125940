"""The picture of fragility curves: observed shares, curves, and their 95 % bands."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unicodedata import east_asian_width

import numpy as np
from matplotlib.ticker import LogLocator

from stayput.catalogue import say
from stayput.errors import InputError, within
from stayput.fragility.intensity_measures import JMA_INTENSITY, IntensityMeasure
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.figures import (
    FONT,
    drawable,
    label_axes,
    new_figure,
    plain_log,
    saved,
    shaded_classes,
    style,
)
from stayput.report.palette import COMPONENT_COLOURS, INK, MUTED
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import motions_told

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.fragility.curve import FragilityCurve
    from stayput.verification import Verdict


_LOOKS = (
    ("#1f2933", "-", "o"),
    ("#0072b2", "--", "s"),
    ("#d55e00", "-.", "^"),
    ("#009e73", (0, (1.0, 1.0)), "D"),
    ("#cc79a7", (0, (6.0, 1.5)), "v"),
    ("#e69f00", (0, (4.0, 1.5, 1.0, 1.5, 1.0, 1.5)), "P"),
    ("#56b4e9", (0, (8.0, 2.0, 2.0, 2.0)), "X"),
    ("#7f5539", (0, (2.0, 2.0)), "*"),
)
"""Colour, line and marker of each curve; the colours are those of Okabe and Ito, and a brown."""

_BANDS = 3
"""Most curves that all have their intervals; of more the first two have them, which others would hide."""

_POINTS = 381
_TOP = 1.1

_DIGITS = (1.0, 2.0, 3.0, 5.0)
"""First digits of the numbers along a logarithmic axis."""

_SHARES = "observed shares over "
"""What marks the observed shares of a curve on axes, with its measure's key; curves there are counted."""


def plot_fragility(
    curves: Sequence[FragilityCurve],
    path: str | Path | None = None,
    *,
    here: float | None = None,
    title: str = "",
    subtitle: str = "",
    language: str = "en",
) -> Figure:
    """Plot fragility curves with their 95 % bands and the observed shares with their 95 % intervals.

    Of one motion bands and bars are for it alone, which is said below the title.

    Parameters
    ----------
    curves : sequence of FragilityCurve
        One to eight curves over the same measure; of more than three the first two have their intervals.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
    here : float, optional
        Intensity of the shaking in question [SI], drawn as a vertical line.
    title, subtitle : str
        Title, and what was run (whether motions are synthetic among it).
    language : str
        "en" or "ja".

    Returns
    -------
    Figure
        The Matplotlib figure.

    Raises
    ------
    InputError
        No curve or more than eight, curves over different measures, or a path that cannot be written.
    """
    within("plots.curves_number", len(curves), 1, len(_LOOKS))
    _refuse_other_measures([curve.measure.key for curve in curves])
    measure = curves[0].measure
    figure = new_figure(8.4, 5.4, title)
    axis: Axes = figure.subplots()
    style(axis, zero=False)
    steps = [
        float(np.diff(measure.coordinate([level.im for level in curve.levels])).min())
        for curve in curves
        if len(curve.levels) > 1
    ]
    shift = 0.6 * min(steps, default=0.0) / len(_LOOKS)  # moves the markers of the curves apart
    for place, curve in enumerate(curves):
        shows = len(curves) <= _BANDS or place < 2
        _draw(axis, curve, place, shift * (place - 0.5 * (len(curves) - 1)), language, shows)
    _finish(axis, curves, measure, language)
    if here is not None:
        label = say("report.here", language, value=measure.text(here))
        x = here * measure.shown
        axis.plot([x, x], [-0.02, 1.02], color=INK, linewidth=1.6, linestyle=":", zorder=2, label=label)
    alone = say("plots.no_bands", language) if any(curve.one_motion for curve in curves) else ""
    label = say("plots.fitted", language, alone=alone)
    below = "\n".join((drawable(subtitle), label)) if subtitle else label
    axis.set_title(below, fontsize=FONT - 1.0, color=MUTED, loc="left")
    widest = max(_cells(_legend_label(curve, language)) for curve in curves)
    legend: dict[str, Any] = {"loc": "outside lower center", "frameon": False, "handlelength": 3.6}
    figure.legend(ncols=1 if widest > 52 or len(curves) < 3 else 2, fontsize=FONT - 1.0, **legend)
    return saved(figure, path)


def plot_options(
    verdict: Verdict, measure: IntensityMeasure, path: Path | None = None, language: str = "en"
) -> Figure:
    """Plot a verdict's curves over one of its measures: that of no measure, and those of the best seven."""
    bare = verdict.without
    best = [result for result in verdict.options if result is not bare][: len(_LOOKS) - 1]
    curves = [
        replace(result.curves[measure], name=verdict.label(result, language)) for result in (bare, *best)
    ]
    motions = say(motions_told(verdict.scenario, verdict.motions)[0], language)
    return plot_fragility(
        curves,
        path,
        here=verdict.intensity if measure == JMA_INTENSITY else None,
        title=verdict.scenario.title or "",
        subtitle=say("report.motions_shown", language, motions=motions),
        language=language,
    )


def draw_curve(axis: Axes, curve: FragilityCurve, language: str, **line: Any) -> None:
    """Draw one curve on axes, which may hold others over the same measure.

    Parameters
    ----------
    axis : Axes
        Where to draw.
    curve : FragilityCurve
        The curve.
    language : str
        "en" or "ja".
    **line
        How the line looks, as for ``Axes.plot``; by default each curve of the axes looks different, and is
        called by its name and the intensity at which half fall.

    Raises
    ------
    InputError
        The axes hold a curve over another measure.
    """
    over = [
        gid.removeprefix(_SHARES) for each in axis.lines if (gid := each.get_gid() or "").startswith(_SHARES)
    ]
    _refuse_other_measures([*over, curve.measure.key])
    style(axis, zero=False)
    _draw(axis, curve, len(over) % len(_LOOKS), 0.0, language, True, **line)
    _label(axis, curve.measure, language)
    if not curve.measure.is_logarithm:
        axis.xaxis.set_major_locator(LogLocator(subs=_DIGITS))
    axis.legend(loc="best", fontsize=FONT - 1.0, framealpha=0.85, handlelength=3.6)


def _refuse_other_measures(keys: Sequence[str]) -> None:
    """Refuse curves over different measures on the same axes."""
    if len(measures := dict.fromkeys(keys)) > 1:
        raise InputError("plots.curves_measures", measures=", ".join(measures))


def _cells(text: str) -> int:
    """Return the width of a text, in which a Japanese letter has two cells."""
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def _legend_label(curve: FragilityCurve, language: str) -> str:
    name, half = curve.name or say("plots.curve", language), say(curve.capacity(0.5).texts, language)
    return say("plots.half", language, name=name, half=half)


def _draw(
    axis: Axes, curve: FragilityCurve, place: int, shift: float, language: str, ends_shown: bool, **line: Any
) -> None:
    colour, dashes, marker = _LOOKS[place]
    looks: dict[str, Any] = {"color": colour, "linestyle": dashes, "marker": marker}
    looks |= {"linewidth": 2.0, "markersize": 5.0} | line
    colour, label = looks["color"], looks.pop("label", None) or drawable(_legend_label(curve, language))
    measure = curve.measure
    middles = measure.value(measure.coordinate([level.im for level in curve.levels]) + shift) * measure.shown
    probabilities = [level.probability for level in curve.levels]
    shares = np.array([p.estimate for p in probabilities])
    ends = np.array([[p.estimate - p.low, p.high - p.estimate] for p in probabilities]).T
    grid = curve.grid(_POINTS)
    x = grid * measure.shown
    if ends_shown:
        axis.fill_between(x, *curve.band(grid), color=colour, alpha=0.13, linewidth=0.0)
    line_alone: dict[str, Any] = looks | {"marker": "none"}
    axis.plot(x, curve.probability(grid), **line_alone)
    if ends_shown:
        bars: dict[str, Any] = {"fmt": "none", "ecolor": colour, "elinewidth": 0.8, "alpha": 0.45}
        axis.errorbar(middles, shares, yerr=ends, zorder=3, **bars)
    with_marks: dict[str, Any] = looks | {"markerfacecolor": "white", "zorder": 4}
    marks_alone: dict[str, Any] = with_marks | {"linestyle": "none"}
    axis.plot(middles, shares, gid=_SHARES + measure.key, **marks_alone)
    axis.plot([], [], label=label, **with_marks)


def _label(axis: Axes, measure: IntensityMeasure, language: str) -> None:
    """Label axes of the probability over an intensity measure."""
    if not measure.is_logarithm:
        plain_log(axis, y=False)
    axis.set_ylim(-0.02, _TOP)
    ticks = np.linspace(0.0, 1.0, 6)
    axis.set_yticks(ticks, [say("plots.per_cent", language, value=100.0 * share) for share in ticks])
    axis.set_xlabel(say(measure.labels, language), fontsize=FONT)
    label_axes(axis, language, y="plots.probability")


def _finish(axis: Axes, curves: Sequence[FragilityCurve], measure: IntensityMeasure, language: str) -> None:
    """End the axis where the curves do, with round numbers, and JMA's classes along the top."""
    u = np.array([curve.ends for curve in curves])
    margin = 0.03 * (float(np.ptp(u)) or 1.0)
    ends = measure.value(np.array([u.min() - margin, u.max() + margin]))
    first, last = (ends * measure.shown).tolist()
    _label(axis, measure, language)
    if not measure.is_logarithm:
        tens = 10.0 ** np.arange(math.floor(math.log10(first)), math.ceil(math.log10(last)) + 1)
        axis.set_xticks([tick for tick in np.outer(tens, _DIGITS).ravel() if first <= tick <= last])
    axis.set_xlim(first, last)
    for middle, name in shaded_classes(axis, first, last, language) if measure == JMA_INTENSITY else ():
        axis.text(middle, 1.06, name, ha="center", va="center", fontsize=FONT - 1.5, color=MUTED)


def draw_ranking(axis: Axes, verdict: Verdict, language: str) -> None:
    """Draw the share that overturns with each option, with its 95 % interval and value, the best first."""
    style(axis, zero=False)
    for place, option in enumerate(verdict.options):
        chance = option.probabilities[OVERTURNED]
        if chance.runs == 0:
            continue
        low, estimate, high = (100.0 * value for value in (chance.low, chance.estimate, chance.high))
        ends = [[max(0.0, estimate - low)], [max(0.0, high - estimate)]]
        axis.barh(place, estimate, 0.55, color=COMPONENT_COLOURS["x"])
        axis.errorbar(estimate, place, xerr=ends, color=INK, capsize=3.0, linewidth=1.0)
        axis.text(high + 1.5, place, numbers.probability(chance, language), va="center", fontsize=FONT - 1.0)
    labels = [drawable(verdict.label(option, language)) for option in verdict.options]
    axis.set_yticks(range(len(labels)), labels, fontsize=FONT - 1.0)
    axis.set_ylim(len(labels) - 0.4, -0.6)
    axis.set_xlim(0.0, 112.0)
    axis.set_xticks(range(0, 101, 20))
    axis.set_xlabel(drawable(say("plots.axis_overturned", language)), fontsize=FONT)
