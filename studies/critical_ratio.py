"""The critical amplitude of a sine over aspect ratio and frequency (the paper, §4.3 and Eq. 4.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib import colormaps

from stayput.errors import InputError, within
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import INK, MUTED
from stayput.simulation.run import LAWS
from studies.critical_ratio_runs import (
    EQUATION_4_1,
    STICKING,
    Conditions,
    Fit,
    all_conditions,
    critical_amplitudes,
    fitted,
    regression,
    rows_of,
)
from studies.study import Quantity, Study, rising

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

RATIOS = np.round(np.linspace(0.2, 0.6, 9), 3)
"""Aspect ratios b/h [–]."""

FREQUENCIES = np.round(np.arange(0.5, 2.01, 0.25), 3)
"""Frequencies [Hz]."""

UNITS = {
    "frequency": "Hz",
    "height": "m",
    "phase": "degree",
    "duration": "s",
    "critical": "m/s2",
    "last_safe": "m/s2",
    "eq_4_1": "m/s2",
    "fit": "m/s2",
}

MARKERS = "osD^vPX<>*"
DASHES = ("-", "--", "-.", ":")
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")
"""Okabe and Ito's, for the values that an influence takes."""


def critical_ratio(
    *,
    ratios: ArrayLike = RATIOS,
    frequencies: ArrayLike = FREQUENCIES,
    height: float = 1.4,
    restitution: float = 0.3,
    phase: float = 90.0,
    duration: float = 10.0,
    step: float = 0.02,
) -> Study:
    """Study the critical amplitude of turnover under a sine, as the paper's §4.3.

    Rocking only, under the paper's contact law; the critical amplitude is the first that turns the body over.

    Parameters
    ----------
    ratios, frequencies : array_like
        Aspect ratios b/h [–] and frequencies [Hz]; at least two of each, rising.
    height : float
        Height of the bodies [m].
    restitution : float
        Restitution e of the floor [–].
    phase : float
        Phase of the sine [°]; 90 is a cosine.
    duration : float
        Length of the shaking [s].
    step : float
        Step of the amplitudes that are run, in g·b/h; a band of turnover narrower than it may be missed.

    Returns
    -------
    Study
        Figures "main" (critical amplitude over b/h beside Eq. 4.1), "residuals", "scale_free" (the dependence
        on size) and "influences" (restitution, phase, sway). The data have a row for each critical amplitude.

    Raises
    ------
    InputError
        Values that do not rise, fewer than two of them, a case that is not possible, or fewer than five
        bodies that turn over at all.

    Examples
    --------
    >>> import studies
    >>> quick = studies.critical_ratio(ratios=[0.3, 0.4, 0.5], frequencies=[0.8, 1.0], step=0.1)
    >>> main = quick.data.to_dataframe().query("part == 'main'").set_index("ratio")
    >>> main[["frequency", "critical", "eq_4_1"]].round(1)  # ours and the paper's amplitudes [m/s²]
           frequency  critical  eq_4_1
    ratio
    0.3          0.8       4.6     5.1
    0.4          0.8       6.5     6.9
    0.5          0.8       8.8     8.8
    0.3          1.0       7.1     6.3
    0.4          1.0       9.1     8.6
    0.5          1.0      11.9    11.0
    """
    b_h, f = rising("studies.ratios", ratios), rising("studies.frequencies", frequencies)
    base = Conditions(height=height, restitution=restitution, phase=phase, duration=duration)
    step = within("studies.amplitude_step", step, 1e-3, 1.0, "g·b/h")
    table = critical_amplitudes(list(all_conditions(base, b_h, f)), step)
    turned = rows_of(table, part="main").dropna(subset="critical")
    if len(turned) < 5:
        raise InputError("studies.few_overturn", count=len(turned))
    values = [turned[name].to_numpy() for name in ("ratio", "frequency", "critical")]
    fit, absolute = fitted(*values), fitted(*values, relative=False)
    table["fit"] = regression(fit.coefficients, table["ratio"].to_numpy(), table["frequency"].to_numpy())
    return Study(
        name="critical-ratio",
        title="The critical amplitude of turnover under a sine",
        quantities=_quantities(rows_of(table, part="main"), fit),
        data=_dataset(table),
        figures={
            "main": draw_critical(table, fit),
            "residuals": draw_residuals(table),
            "scale_free": draw_scale_free(table),
            "influences": draw_influences(table),
        },
        tables={
            "S₁ = c₁ exp(c₂ S₂)·(b/h) + c₃ S₂ + c₄, with 95 % confidence intervals": _coefficients(
                fit, absolute
            ),
            "Mean deviation of our critical amplitudes by frequency [%]": _by_frequency(table),
        },
    )


def _quantities(main: pd.DataFrame, fit: Fit) -> dict[str, Quantity]:
    quantities = {
        f"c{place}": Quantity(f"c{'₁₂₃₄'[place - 1]} of the regression", ours, paper, ".3f")
        for place, (ours, paper) in enumerate(zip(fit.coefficients.tolist(), EQUATION_4_1, strict=True), 1)
    }
    off = 100.0 * (main["critical"] / main["eq_4_1"] - 1.0)
    for key, label, value, form in (
        ("off", "Mean size of the deviation from Eq. 4.1 [%]", off.abs().mean(), ".1f"),
        ("off_signed", "Mean deviation from Eq. 4.1 [%]", off.mean(), "+.1f"),
        ("off_worst", "Largest deviation from Eq. 4.1 [%]", off.loc[off.abs().idxmax()], "+.1f"),
        (
            "fit_off",
            "Mean size of the deviation from our fit [%]",
            100.0 * np.abs(fit.residuals).mean(),
            ".1f",
        ),
        ("never", "Bodies that never turn over", int(off.isna().sum()), "d"),
        ("islands", "Bodies with safe islands", int((main["safe_share"] > 0.0).sum()), "d"),
    ):
        quantities[key] = Quantity(label, value, form=form)
    return quantities


def _coefficients(fit: Fit, absolute: Fit) -> pd.DataFrame:
    def with_intervals(which: Fit) -> list[str]:
        pairs = zip(which.coefficients, which.half_widths, strict=True)
        return [f"{value:.3f} ± {half:.3f}" for value, half in pairs]

    return pd.DataFrame(
        {
            "coefficient": ["c₁ [m/s²]", "c₂ [s]", "c₃ [m/s]", "c₄ [m/s²]"],
            "Eq. 4.1": EQUATION_4_1,
            "ours": with_intervals(fit),
            "ours, of absolute residuals": with_intervals(absolute),
        }
    )


def _by_frequency(table: pd.DataFrame) -> pd.DataFrame:
    main = rows_of(table, part="main")
    from_paper = 100.0 * (main["critical"] / main["eq_4_1"] - 1.0)
    from_fit = 100.0 * (main["critical"] / main["fit"] - 1.0)
    grouped = pd.DataFrame(
        {
            "f [Hz]": main["frequency"],
            "from Eq. 4.1, size": from_paper.abs(),
            "from Eq. 4.1, signed": from_paper,
            "from our fit, size": from_fit.abs(),
        }
    )
    return grouped.groupby("f [Hz]").mean().reset_index()


def _dataset(table: pd.DataFrame) -> xr.Dataset:
    data = xr.Dataset.from_dataframe(table.rename_axis("case"))
    for name, unit in UNITS.items():
        data[name].attrs["units"] = unit
    return data


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
        rows = rows_of(main, frequency=f)
        axis.plot(rows["ratio"], rows["critical"], marker, color=colour, markersize=6.0, label=f"{f:g} Hz")
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
            rows = rows_of(main, frequency=f)
            off = 100.0 * (rows["critical"] / rows[against] - 1.0)
            axis.plot(rows["ratio"], off, f"-{marker}", color=colour, linewidth=1.0, label=f"{f:g} Hz")
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
            rows = rows_of(sizes, ratio=ratio, height=height)
            axis.plot(
                rows["omega_over_p"],
                rows["scaled"],
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
        rows = rows_of(part.assign(name=names), name=name)
        label = f"{name}: never turns over" if rows["critical"].isna().all() else name
        axis.plot(
            rows["frequency"], rows["critical"], marker=marker, linestyle=dashes, color=colour, label=label
        )
    once = part.drop_duplicates("frequency")
    axis.plot(once["frequency"], once["eq_4_1"], color=MUTED, linewidth=3.0, alpha=0.4, label="Eq. 4.1")
    axis.legend(fontsize=FONT - 1.5)
