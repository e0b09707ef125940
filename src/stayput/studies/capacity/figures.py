"""Figures of the study of capacities: medians over Fe, and shares over the amplitude."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from scipy.special import ndtr

from stayput.estimates import SCATTER, kaneko_hayashi_median
from stayput.report.figures import FONT, new_figure, plain_log, style
from stayput.report.palette import INK, MUTED
from stayput.studies.capacity.tables import BAND, stated

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

LOOKS = (("#0072b2", "-", "o"), ("#d55e00", "--", "s"), ("#009e73", "-.", "^"), ("#cc79a7", ":", "D"))
"""Colour, line and marker of each size, in turn."""

SPECTRA = ("#0072b2", "#009e73", "#e69f00", "#d55e00", "#cc79a7")
"""Colours of the spectra, from the shortest corner period."""

_TICKS = (0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0)

MARKERS = ("o", "s", "^", "D", "v")
"""Their markers."""


def draw_medians(data: xr.Dataset) -> Figure:
    """Draw A₅₀ over Fe beside both branches of the formula, and both scaled to where the branches meet."""
    main = stated(data)
    figure = new_figure(11.0, 5.0)
    left, right = figure.subplots(1, 2)
    fe = main["frequency"].to_numpy()
    over: NDArray[np.float64] = np.geomspace(0.7 * float(fe.min()), 1.4 * float(fe.max()), 200)
    ends: list[float] = []
    for place, size in enumerate(main["body"].to_numpy()):
        colour, line, marker = LOOKS[place % len(LOOKS)]
        one = main.sel(body=size)
        b, h, fb = (float(one[name]) for name in ("width", "height", "branch"))
        formula = np.array([kaneko_hayashi_median(b, h, float(f)) for f in over.tolist()])
        floor = float(formula.min())
        median, error = _with_error(one)
        look = {"fmt": marker, "color": colour, "markersize": 6.0, "capsize": 2.5, "elinewidth": 1.0}
        left.plot(over, formula, color=colour, linestyle=line, linewidth=1.6)
        left.errorbar(fe, median, error, label=f"{size}, {100 * b:g} × {100 * h:g} cm", **look)
        right.errorbar(fe / fb, median / floor, error / floor, label=str(size), **look)
        ends += [float(over[0]) / fb, float(over[-1]) / fb]
    x = np.geomspace(min(ends), max(ends), 200)
    unit = np.maximum(1.0, x)
    right.fill_between(x, (1 - BAND) * unit, (1 + BAND) * unit, color=MUTED, alpha=0.2, label="±20 %")
    right.plot(x, unit, color=INK, linewidth=1.6, label="formula")
    labels = (
        ("Fe = A/(2πV) [Hz]", "A₅₀ [m/s²]", "Points: simulation, synthetic motions (95 %); lines: formula"),
        (
            "Fe/Fb [–]",
            "A₅₀ over the formula's level branch [–]",
            "The same, scaled to where the branches meet",
        ),
    )
    for axis, (below, beside, title) in zip((left, right), labels, strict=True):
        across, up = (over[0], over[-1]) if axis is left else (x[0], x[-1]), axis.get_ylim()
        _finish(axis, below, beside, title)
        axis.set_xlim(*across)
        axis.set_ylim(*up)
    left.legend(loc="upper left", fontsize=FONT - 1.0)
    right.legend(loc="upper left", fontsize=FONT - 1.0)
    return figure


def _with_error(one: xr.Dataset) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return medians [m/s²] and their distances to the ends of the intervals, shape [2, run]."""
    ratio, low, high = (one[name].to_numpy() for name in ("ratio", "ratio_low", "ratio_high"))
    known = np.isfinite(low) & np.isfinite(high)
    error = np.where(known, np.stack((ratio - low, high - ratio)), 0.0)
    formula = one["formula"].to_numpy()
    return ratio * formula, np.maximum(error, 0.0) * formula


def _finish(axis: Axes, below: str, beside: str, title: str) -> None:
    plain_log(axis)
    axis.set_xticks(_TICKS)
    axis.set_yticks(_TICKS)
    style(axis, zero=False)
    axis.set_xlabel(below, fontsize=FONT)
    axis.set_ylabel(beside, fontsize=FONT)
    axis.set_title(title, fontsize=FONT, color=INK)


def draw_shares(data: xr.Dataset) -> Figure:
    """Draw the share that overturns over A/A₅₀, a panel for each size, beside the formula's curve."""
    main = stated(data)
    count = main.sizes["body"]
    columns = min(2, count)
    figure = new_figure(5.2 * columns, 3.4 * (-(-count // columns)) + 0.6)
    panels = figure.subplots(-(-count // columns), columns, sharex=True, sharey=True, squeeze=False).ravel()
    r = main["amplitude"].to_numpy()
    for place, axis in enumerate(panels):
        axis.set_visible(place < count)
        if place >= count:
            continue
        axis.plot(r, ndtr(np.log(r) / SCATTER), color=INK, linewidth=2.2, label=f"formula, ζ = {SCATTER:g}")
        for run in range(main.sizes["run"]):
            one = main.isel(run=run, body=place)
            axis.plot(
                r,
                one["share"],
                color=SPECTRA[run % len(SPECTRA)],
                marker=MARKERS[run % len(MARKERS)],
                markevery=(run % 5, 5),
                markersize=4.5,
                linewidth=1.2,
                label=f"Fe = {float(one['frequency']):.2f} Hz (corner {float(one['corner']):g} s)",
            )
        plain_log(axis, y=False)
        axis.set_xticks([tick for tick in _TICKS if r[0] <= tick <= r[-1]])
        style(axis, zero=False)
        axis.set_ylim(-0.02, 1.02)
        axis.set_title(str(main["body"].to_numpy()[place]), fontsize=FONT, color=INK)
        if place >= count - columns:
            axis.set_xlabel("A/A₅₀ of the formula [–]", fontsize=FONT)
        if place % columns == 0:
            axis.set_ylabel("share that overturns [–]", fontsize=FONT)
    panels[0].legend(loc="upper left", fontsize=FONT - 2.0)
    figure.suptitle(f"{main.sizes['motion']} synthetic motions of each spectrum", fontsize=FONT, color=INK)
    return figure
