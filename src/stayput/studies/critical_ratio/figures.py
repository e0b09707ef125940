"""Figures of the critical-ratio study."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib import colormaps

from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import INK, MUTED
from stayput.simulation import LAWS
from stayput.studies.critical_ratio.cases import STICKING, rows_of
from stayput.studies.critical_ratio.fit import EQUATION_4_1, Fit, regression

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MARKERS = "osD^vPX<>*"
DASHES = ("-", "--", "-.", ":")
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")
"""Okabe and Ito's, for the values that an influence takes."""


def _shades(count: int) -> list[tuple[float, float, float, float]]:
    """Return colours from dark to light, of a map that reads without colour too."""
    return [colormaps["viridis"](x) for x in np.linspace(0.0, 0.85, count)]


def draw_critical(table: pd.DataFrame, fit: Fit) -> Figure:
    """Draw the critical amplitude over b/h for each frequency: ours, our fit, and Eq. 4.1."""
    main = rows_of(table, part="main")
    frequencies = main["frequency"].unique().tolist()
    figure = new_figure(7.6, 6.0)
    axis = figure.subplots()
    style(axis, zero=False)
    line = np.linspace(float(main["ratio"].min()), float(main["ratio"].max()), 50)
    for f, colour, marker in zip(frequencies, _shades(len(frequencies)), MARKERS * 9, strict=False):
        mine = rows_of(main, frequency=f)
        axis.plot(mine["ratio"], mine["critical"], marker, color=colour, markersize=6.0, label=f"{f:g} Hz")
        axis.plot(line, regression(fit.coefficients, line, np.full(50, f)), color=colour, linewidth=1.4)
        axis.plot(line, regression(EQUATION_4_1, line, np.full(50, f)), "--", color=colour, linewidth=1.4)
    axis.plot([], [], "o", color=INK, label="ours")
    axis.plot([], [], color=INK, label="our fit")
    axis.plot([], [], "--", color=INK, label="the paper's Eq. 4.1")
    axis.set_xlabel("Aspect ratio b/h [–]", fontsize=FONT)
    axis.set_ylabel("Critical amplitude S₁ [m/s²]", fontsize=FONT)
    axis.set_title("First amplitude of a sine that turns the body over", fontsize=FONT + 1.0, color=INK)
    axis.legend(fontsize=FONT - 1.0, ncols=2)
    return figure


def draw_residuals(table: pd.DataFrame) -> Figure:
    """Draw how far our critical amplitudes are from our fit and from Eq. 4.1."""
    main = rows_of(table, part="main")
    frequencies = main["frequency"].unique().tolist()
    figure = new_figure(10.0, 4.4)
    axes = figure.subplots(1, 2, sharey=True)
    for axis, against, name in zip(axes, ("fit", "eq_4_1"), ("our fit", "the paper's Eq. 4.1"), strict=True):
        style(axis)
        for f, colour, marker in zip(frequencies, _shades(len(frequencies)), MARKERS * 9, strict=False):
            mine = rows_of(main, frequency=f)
            off = 100.0 * (mine["critical"] / mine[against] - 1.0)
            axis.plot(mine["ratio"], off, f"-{marker}", color=colour, linewidth=1.0, label=f"{f:g} Hz")
        axis.set_title(f"Against {name}", fontsize=FONT)
        axis.set_xlabel("Aspect ratio b/h [–]", fontsize=FONT)
    axes[0].set_ylabel("Our critical amplitude, deviation [%]", fontsize=FONT)
    axes[0].legend(fontsize=FONT - 1.0, ncols=2)
    return figure


def draw_scale_free(table: pd.DataFrame) -> Figure:
    """Draw the critical amplitude in g·b/h over ω/p, for several sizes and aspect ratios."""
    sizes = rows_of(table, part="size")
    figure = new_figure(7.6, 5.2)
    axis = figure.subplots()
    style(axis, zero=False)
    for ratio, colour, dashes in zip(sorted(sizes["ratio"].unique()), COLOURS, DASHES, strict=False):
        for height, marker, large in zip(
            sorted(sizes["height"].unique()), "ox^", (13.0, 8.0, 5.0), strict=True
        ):
            mine = rows_of(sizes, ratio=ratio, height=height)
            axis.plot(
                mine["omega_over_p"],
                mine["scaled"],
                marker=marker,
                markersize=large,
                fillstyle="none" if marker == "o" else "full",
                linestyle=dashes if marker == "o" else "none",
                color=colour,
                label=f"b/h = {ratio:g}, h = {height:g} m",
            )
    axis.set_xlabel("Frequency ω/p [–],  p² = 3g/4R", fontsize=FONT)
    axis.set_ylabel("Critical amplitude S₁ / (g·b/h) [–]", fontsize=FONT)
    axis.set_title("The scale-free form: three sizes, one curve for each b/h", fontsize=FONT + 1.0, color=INK)
    axis.legend(fontsize=FONT - 1.0)
    return figure


def draw_influences(table: pd.DataFrame) -> Figure:
    """Draw the critical amplitude over frequency for restitutions, phases and coefficients of friction."""
    figure = new_figure(10.0, 7.6)
    axes = figure.subplots(2, 2, sharex=True, sharey=True).ravel()
    parts = {name: rows_of(table, part=name) for name in ("restitution", "phase", "sway")}
    named = [
        ("Restitution e", parts["restitution"], parts["restitution"]["restitution"].map("e = {:g}".format)),
        ("Phase of the sine", parts["phase"], parts["phase"]["phase"].map("{:g}°".format)),
    ]
    for law in LAWS[::-1]:
        of_law = rows_of(parts["sway"], contact=law)
        title = "Sway, law of the paper" if law == "paper" else "Sway, Coulomb law"
        named.append((title, of_law, _friction_names(of_law)))
    for axis, (title, part, names) in zip(axes, named, strict=True):
        _influence(axis, part, names)
        axis.set_title(title, fontsize=FONT)
    for axis in axes[2:]:
        axis.set_xlabel("Frequency [Hz]", fontsize=FONT)
    for axis in axes[::2]:
        axis.set_ylabel("Critical amplitude S₁ [m/s²]", fontsize=FONT)
    ratio = parts["phase"]["ratio"].iloc[0]
    figure.suptitle(f"What Eq. 4.1 leaves out, at b/h = {ratio:g}", fontsize=FONT + 1.0, color=INK)
    return figure


def _friction_names(sway: pd.DataFrame) -> pd.Series[str]:
    base, corner = sway["friction"] / sway["ratio"], sway["corner_friction"] / sway["ratio"]
    names = "μ = " + base.map("{:.2f} b/h".format)
    names = names.where(base == corner, names + corner.map(", corner {:.2f} b/h".format))
    return names.where(sway["friction"] != STICKING, "it never slips")


def _influence(axis: Axes, part: pd.DataFrame, names: pd.Series[str]) -> None:
    style(axis, zero=False)
    for name, colour, dashes, marker in zip(
        sorted(set(names), key=list(names).index), COLOURS, DASHES, MARKERS, strict=False
    ):
        mine = rows_of(part.assign(name=names), name=name)
        told = f"{name}: never turns over" if mine["critical"].isna().all() else name
        axis.plot(
            mine["frequency"], mine["critical"], marker=marker, linestyle=dashes, color=colour, label=told
        )
    once = part.drop_duplicates("frequency")
    axis.plot(once["frequency"], once["eq_4_1"], color=MUTED, linewidth=3.0, alpha=0.4, label="Eq. 4.1")
    axis.legend(fontsize=FONT - 1.5)
