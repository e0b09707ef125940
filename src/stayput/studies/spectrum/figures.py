"""Figures of the spectra."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.ticker import NullFormatter

from stayput.motion.units import STANDARD_GRAVITY
from stayput.report.figures import FONT, new_figure, plain_log, style
from stayput.report.palette import ALARM, INK, MUTED
from stayput.studies.spectrum.branches import falling_ranges, outer_edges, pulse_branches
from stayput.studies.spectrum.runs import (
    PULSE_E,
    PULSE_PERIOD,
    PULSE_SLENDERNESS,
    REFERENCE_EDGES,
    REFERENCE_RATIO,
)

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.motion import Motion

WITH_IMPACT, WITHOUT_IMPACT = "#e69f00", "#0072b2"
"""Colours of the two ways to fall."""

LINES = (("#0072b2", "-", "o"), ("#d55e00", "--", "s"), ("#009e73", "-.", "^"), ("#cc79a7", ":", "D"))
"""Colour, line and marker of each slenderness, in turn."""


def _size_ticks(axis: Axes, period: NDArray[np.float64]) -> None:
    """Label 2π/p below and the diagonal 2R above."""
    plain_log(axis, y=False)
    ticks = [t for t in (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0) if period[0] <= t <= period[-1]]
    axis.set_xticks(ticks)
    axis.set_xlim(period[0], period[-1])
    k = 3.0 * STANDARD_GRAVITY / (8.0 * math.pi**2)  # 2R = k (2π/p)²
    above = axis.secondary_xaxis(
        "top", functions=(lambda t: k * np.asarray(t) ** 2, lambda d: np.sqrt(np.abs(d) / k))
    )
    shown = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
    above.set_xticks(shown, [f"{d:g}" for d in shown])
    above.xaxis.set_minor_formatter(NullFormatter())
    above.tick_params(labelsize=FONT - 1.0, colors=INK)
    above.set_xlabel("Diagonal 2R [m]", fontsize=FONT)


def pulse_figure(pulse: xr.Dataset) -> Figure:
    """Draw the two branches under the one-cycle sine over ωp/p."""
    figure = new_figure(7.2, 5.0)
    axis = figure.subplots()
    style(axis, zero=False)
    ratio = pulse["period"].values / PULSE_PERIOD
    lower, upper, without = pulse_branches(pulse)
    top = 1.3 * float(np.nanmax([np.nanmax(pulse["amplitude"].values), *REFERENCE_EDGES]))
    axis.fill_between(
        ratio,
        lower,
        upper,
        color=WITH_IMPACT,
        alpha=0.35,
        hatch="//",
        linewidth=0.0,
        label="falls after an impact",
    )
    axis.fill_between(
        ratio, without, top, color=WITHOUT_IMPACT, alpha=0.25, linewidth=0.0, label="falls without impact"
    )
    axis.plot(ratio, lower, color=WITH_IMPACT, linewidth=2.0, label="with impact, lower edge")
    axis.plot(ratio, upper, color=WITH_IMPACT, linewidth=2.0, linestyle="--", label="with impact, upper edge")
    axis.plot(ratio, without, color=WITHOUT_IMPACT, linewidth=2.0, linestyle="-.", label="without impact")
    axis.plot(
        [REFERENCE_RATIO] * len(REFERENCE_EDGES),
        REFERENCE_EDGES,
        "o",
        color="white",
        markeredgecolor=INK,
        markersize=7.0,
        label="reference values",
    )
    plain_log(axis, x=False)
    axis.set_yticks([1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0])
    axis.set_ylim(0.9, top)
    axis.set_xlim(ratio[0], ratio[-1])
    axis.set_xlabel("ωp/p [–]", fontsize=FONT)
    axis.set_ylabel("Amplitude of the sine, a_p/(αg) [–]", fontsize=FONT)
    axis.set_title(
        f"One full sine, α = {PULSE_SLENDERNESS:g} rad, e = {PULSE_E:g}, nonlinear; white: it stands",
        fontsize=FONT + 1.0,
        color=INK,
    )
    axis.legend(loc="upper left", fontsize=FONT - 1.0)
    return figure


def record_figure(under: xr.Dataset, record: Motion) -> Figure:
    """Draw where bodies fall over their size and the factor on the record, a panel for each slenderness."""
    count = under.sizes["slenderness"]
    columns = min(2, count)
    rows = math.ceil(count / columns)
    figure = new_figure(1.0 + 4.4 * columns, 0.8 + 3.6 * rows)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False).ravel()
    period = under["period"].values
    first, last = outer_edges(under)
    for place, axis in enumerate(panels):
        if place >= count:
            axis.set_visible(False)
            continue
        style(axis, zero=False)
        of_alpha = under.isel(slenderness=place)
        axis.add_collection(
            PolyCollection(_bars(of_alpha), facecolor=ALARM, alpha=0.45, edgecolor="none", label="falls")
        )
        axis.plot(period, first[place], color=INK, linewidth=1.6, label="first edge: below it all stand")
        axis.plot(period, last[place], "_", color=INK, markersize=7.0, label="last edge: above it all fall")
        axis.axhline(1.0, color=MUTED, linewidth=1.2, linestyle=":", label="the record as it is")
        _size_ticks(axis, period)
        plain_log(axis, x=False)
        axis.set_yticks((0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0))
        axis.set_ylim(_bottom(first, under), under.attrs["highest_amplitude"])
        alpha = float(of_alpha["slenderness"])
        axis.set_title(f"α = {alpha:g} rad (b/h = {math.tan(alpha):.2f})", fontsize=FONT)
        if place >= count - columns:
            axis.set_xlabel("2π/p [s]", fontsize=FONT)
        if place % columns == 0:
            axis.set_ylabel("Factor on the record [–]", fontsize=FONT)
    panels[0].legend(loc="upper left", fontsize=FONT - 2.0)
    name, peak = record.name or "the record", record.pga / STANDARD_GRAVITY
    figure.suptitle(f"Overturning under {name} (peak {peak:.2f} g)", fontsize=FONT + 1.0, color=INK)
    return figure


def _bottom(first: NDArray[np.float64], under: xr.Dataset) -> float:
    """Return where the panels begin: below the lowest edge that is drawn."""
    if np.isnan(first).all():
        return float(under.attrs["lowest_amplitude"])
    return 0.8 * float(np.nanmin(first))


def _bars(of_alpha: xr.Dataset) -> list[NDArray[np.float64]]:
    """Return rectangles over size and factor in which the bodies of one slenderness fall."""
    t = of_alpha["period"].values
    middle = np.sqrt(t[1:] * t[:-1])
    sides = np.concatenate((t[:1], middle, t[-1:]))
    return [
        np.array([(left, low), (right, low), (right, high), (left, high)])
        for place, (left, right) in enumerate(pairwise(sides.tolist()))
        for low, high in falling_ranges(of_alpha.isel(period=place))
    ]


def rocking_figure(under: xr.Dataset, record: Motion) -> Figure:
    """Draw the peak tilt over α under the record as it is, a line for each slenderness."""
    figure = new_figure(7.4, 4.8)
    axis = figure.subplots()
    style(axis)
    period = under["period"].values
    count = under.sizes["slenderness"]
    relative = (under["peak_tilt"] / under["slenderness"]).where(~under["overturned"])
    top = max(1.0, 1.05 * float(relative.max())) if bool(relative.notnull().any()) else 1.0
    for place in range(count):
        colour, line, marker = LINES[place % len(LINES)]
        alpha = float(under["slenderness"][place])
        axis.plot(
            period,
            relative.isel(slenderness=place),
            color=colour,
            linestyle=line,
            marker=marker,
            markersize=3.5,
            label=f"α = {alpha:g} rad",
        )
        fallen = period[under["overturned"].isel(slenderness=place).values]
        axis.plot(
            fallen, np.full(len(fallen), top + 0.05 * (count - place)), marker, color=colour, markersize=4.5
        )
    axis.axhline(top, color=MUTED, linewidth=0.8)
    axis.text(
        period[-1],
        top + 0.05 * (count + 1),
        "above the line: it falls ",
        ha="right",
        va="center",
        fontsize=FONT - 1.0,
        color=INK,
    )
    axis.set_ylim(0.0, top + 0.05 * (count + 2))
    _size_ticks(axis, period)
    axis.set_xlabel("2π/p [s]", fontsize=FONT)
    axis.set_ylabel("Peak tilt / α [–]", fontsize=FONT)
    axis.set_title(f"Rocking under {record.name or 'the record'} as it is", fontsize=FONT + 1.0, color=INK)
    axis.legend(loc="lower left", fontsize=FONT - 1.0)
    return figure
