"""How far a body slides over its static and kinetic friction (the paper, §4.2).

The paper does not give its input (Fig. 4.2), so the sine is searched whose three slides come nearest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.ticker import MaxNLocator

from stayput.model.gravity import STANDARD_GRAVITY
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from studies.friction_runs import (
    FREE,
    HELD,
    PAPER_ROWS,
    PAPER_SLIDES,
    PHASES,
    Nearest,
    deviation,
    effects,
    models,
    nearest_sine,
    slide_map,
    slides_under,
    unit_sine,
)
from studies.study import Quantity, Study, rising

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.contour import ContourSet
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

AMPLITUDES = np.round(np.arange(4.0, 15.01, 0.2), 1)
"""Amplitudes that are searched [m/s²]: from 0.4 g, where the paper's first body begins to slide."""

FREQUENCIES = np.round(np.arange(0.5, 6.01, 0.1), 1)
"""Frequencies that are searched [Hz]."""

COEFFICIENTS = np.linspace(0.05, 0.8, 31)
"""Coefficients of friction of the map."""

WORST = 1.0
"""Deviations from the paper are coloured up to this."""

PAIRS = [f"({static:g}, {kinetic:g})" for static, kinetic in PAPER_ROWS]
"""The paper's pairs of coefficients as they are printed."""

UNITS = {"phase": "degree", "frequency": "Hz", "amplitude": "m/s2", "peak_slide": "m"}


def friction(
    *,
    amplitudes: ArrayLike = AMPLITUDES,
    frequencies: ArrayLike = FREQUENCIES,
    coefficients: ArrayLike = COEFFICIENTS,
    duration: float = 10.0,
) -> Study:
    """Study the slide over static and kinetic friction, as the paper's §4.2.

    Parameters
    ----------
    amplitudes, frequencies : array_like
        The sines that are searched [m/s², Hz]; at least two of each, rising.
    coefficients : array_like
        Coefficients of friction of the map, static and kinetic; at least two, rising.
    duration : float
        Length of the shaking [s].

    Returns
    -------
    Study
        Figures "map" (peak slide over μ and μ'), "search" (how near each sine comes to the paper) and
        "effects" (which coefficient matters more). The data have a row for each case: the searched sines
        under the paper's three pairs of coefficients, and the map.

    Raises
    ------
    InputError
        Values that do not rise, fewer than two of them, or a case that is not possible.

    Examples
    --------
    >>> import studies
    >>> sines = {"amplitudes": [8.0, 10.0], "frequencies": [1.5, 2.0], "duration": 5.0}
    >>> quick = studies.friction(**sines, coefficients=[0.1, 0.3])
    >>> quick.quantities["sine_held"].value
    '6.19 m/s², 2.59 Hz, phase 90°'
    >>> for name in ("slide_1_held", "slide_2_held"):  # cm
    ...     quantity = quick.quantities[name]
    ...     print(f"{quantity.label}: {quantity.value:.1f}; in the paper {quantity.published:.1f}")
    Peak slide at (μ, μ') = (0.4, 0.1), only slides [cm]: 5.4; in the paper 5.4
    Peak slide at (μ, μ') = (0.4, 0.3), only slides [cm]: 2.1; in the paper 3.1
    """
    A, f = rising("studies.amplitudes", amplitudes), rising("studies.frequencies", frequencies)
    mu = rising("studies.coefficients", coefficients)
    searched: dict[str, xr.Dataset] = {}
    nearest: dict[str, Nearest] = {}
    for name, case in models(unit_sine(f[0], duration, 0.0)).items():
        searched[name] = slides_under(case, PHASES, f, A)
        nearest[name] = nearest_sine(case, searched[name])
    chosen = nearest[HELD]
    stated = models(unit_sine(chosen.frequency, duration, chosen.phase))
    rows = {
        name: slides_under(case, (chosen.phase,), np.array([chosen.frequency]), np.array([chosen.amplitude]))
        for name, case in stated.items()
    }
    maps = {name: slide_map(case, chosen.amplitude, mu) for name, case in stated.items()}
    return Study(
        name="friction",
        title="Sliding and the coefficients of friction",
        quantities=_quantities(nearest),
        data=_tidy(searched, maps, chosen),
        figures={
            "map": draw_map(maps, chosen),
            "search": draw_search(searched, nearest),
            "effects": draw_effects(searched, chosen.phase),
        },
        tables={
            f"Peak slide [cm] under the sine nearest for the body that {HELD}": _rows_table(rows),
            "The nearest sine for each model, with its three slides [cm]": _nearest_table(nearest),
        },
    )


def _quantities(nearest: dict[str, Nearest]) -> dict[str, Quantity]:
    quantities: dict[str, Quantity] = {}
    first, second, third = (100.0 * slide for slide in PAPER_SLIDES)
    for key, (name, sine) in zip(("held", *FREE), nearest.items(), strict=True):
        quantities[f"sine_{key}"] = Quantity(f"Nearest sine, {name}", str(sine))
        deviation = 100.0 * sine.deviation
        quantities[f"deviation_{key}"] = Quantity(f"Its largest deviation, {name} [%]", deviation, form=".0f")
        slides: list[float] = (100.0 * sine.slides).tolist()
        for row, (pair, ours, paper) in enumerate(zip(PAIRS, slides, PAPER_SLIDES, strict=True), 1):
            label = f"Peak slide at (μ, μ') = {pair}, {name} [cm]"
            quantities[f"slide_{row}_{key}"] = Quantity(label, ours, 100.0 * paper, ".2f")
        for effect, row, paper in (("μ", 2, first - third), ("μ'", 1, first - second)):
            label = f"0.2 more {effect} shortens it by, {name} [cm]"
            effect_key = f"by_{'static' if effect == 'μ' else 'kinetic'}_{key}"
            quantities[effect_key] = Quantity(label, slides[0] - slides[row], paper, ".2f")
    return quantities


def _rows_table(rows: dict[str, xr.Dataset]) -> pd.DataFrame:
    table = pd.DataFrame(PAPER_ROWS, columns=["μ", "μ'"])
    paper = np.array(PAPER_SLIDES)
    table["the paper"] = 100.0 * paper
    for name, row in rows.items():
        slides = row.peak_slide.to_numpy().ravel()
        table[name] = (100.0 * slides).round(6)
        table[f"{name}, against the paper [%]"] = 100.0 * (slides / paper - 1.0)
    return table


def _nearest_table(nearest: dict[str, Nearest]) -> pd.DataFrame:
    rows: list[dict[str, object]] = [
        {
            "model": name,
            "A [m/s²]": sine.amplitude,
            "f [Hz]": sine.frequency,
            "phase [°]": sine.phase,
            **dict(zip(PAIRS, 100.0 * sine.slides, strict=True)),
            "largest deviation [%]": 100.0 * sine.deviation,
            "rocks": "yes" if sine.rocks else "no",
        }
        for name, sine in nearest.items()
    ]
    paper = dict(zip(PAIRS, 100.0 * np.array(PAPER_SLIDES), strict=True))
    return pd.DataFrame([*rows, {"model": "the paper", **paper, "rocks": "not stated"}])


def _tidy(searched: dict[str, xr.Dataset], maps: dict[str, xr.Dataset], chosen: Nearest) -> xr.Dataset:
    """Return a row for each case: the search and the map, of all models."""
    columns = ["static_friction", "kinetic_friction", "phase", "frequency", "amplitude"]
    columns += ["peak_slide", "rocks", "overturned"]
    sine = {name: getattr(chosen, name) for name in ("phase", "frequency", "amplitude")}
    parts: list[pd.DataFrame] = []
    for name in searched:
        for part, grid, settings in (("search", searched[name], {}), ("map", maps[name], sine)):
            table = grid.to_dataframe().reset_index().assign(**settings)
            parts.append(table[columns].assign(part=part, body=name))
    table = pd.concat(parts).dropna(subset="overturned").reset_index(drop=True).rename_axis("case")
    data = xr.Dataset.from_dataframe(table.astype({"rocks": bool, "overturned": bool}))
    for column, unit in UNITS.items():
        data[column].attrs["units"] = unit
    return data


def _panels(count: int, title: str) -> tuple[Figure, list[Axes]]:
    """Return a figure of panels side by side with common axes."""
    figure = new_figure(4.1 * count, 4.4)
    figure.suptitle(title, fontsize=FONT + 1.0, color=INK)
    axes = figure.subplots(1, count, sharex=True, sharey=True)
    for axis in axes:
        style(axis, zero=False)
    return figure, list(axes)


def draw_map(maps: dict[str, xr.Dataset], sine: Nearest) -> Figure:
    """Draw the peak slide over static and kinetic friction, a panel for each model."""
    figure, axes = _panels(len(maps), f"Peak slide under a sine of {sine}")
    largest = max(float(grid.peak_slide.max()) for grid in maps.values())
    levels = MaxNLocator(12).tick_values(0.0, 100.0 * max(largest, 1e-6))
    drawn: list[ContourSet] = []
    for axis, (name, grid) in zip(axes, maps.items(), strict=True):
        mu = grid.static_friction.to_numpy()
        slides = 100.0 * grid.peak_slide.transpose("kinetic_friction", "static_friction").to_numpy()
        drawn.append(axis.contourf(mu, mu, slides, levels, cmap="cividis"))
        rocks = grid.rocks.transpose("kinetic_friction", "static_friction").to_numpy()
        axis.contourf(mu, mu, rocks, [0.5, 1.5], colors="none", hatches=["//"])
        for static, kinetic in PAPER_ROWS:
            axis.plot(static, kinetic, "o", color="white", markeredgecolor=INK, markersize=8.0)
        axis.set_title(name + (", hatched: rocks" if np.nanmax(rocks) > 0.0 else ""), fontsize=FONT)
        axis.set_xlabel("Static friction μ [–]", fontsize=FONT)
    axes[0].set_ylabel("Kinetic friction μ' [–]", fontsize=FONT)
    axes[0].plot([], [], "o", color="white", markeredgecolor=INK, markersize=8.0, label="the paper's rows")
    axes[0].legend(loc="upper left", fontsize=FONT - 1.0)
    figure.colorbar(drawn[0], ax=axes, label="Peak slide [cm]")
    return figure


def draw_search(searched: dict[str, xr.Dataset], nearest: dict[str, Nearest]) -> Figure:
    """Draw how near each sine comes to the paper's three slides, a panel for each model."""
    figure, axes = _panels(len(searched), "Largest deviation of the three slides from the paper's")
    drawn: list[ContourSet] = []
    for axis, (name, grid) in zip(axes, searched.items(), strict=True):
        sine = nearest[name]
        far = deviation(grid).sel(phase=sine.phase).transpose("amplitude", "frequency")
        levels = np.linspace(0.0, WORST, 11)
        drawn.append(
            axis.contourf(grid.frequency, grid.amplitude, far, levels, cmap="cividis_r", extend="max")
        )
        axis.plot(sine.frequency, sine.amplitude, "*", color=ALARM, markeredgecolor="white", markersize=16.0)
        axis.set_title(
            f"{name}\nnearest: {sine}: {100.0 * sine.deviation:.0f} %",
            fontsize=FONT - 1.0,
            color=INK,
        )
        axis.set_xlabel("Frequency [Hz]", fontsize=FONT)
    axes[0].set_ylabel("Amplitude [m/s²]", fontsize=FONT)
    figure.colorbar(drawn[0], ax=axes, label="Largest relative deviation [–]")
    return figure


def draw_effects(searched: dict[str, xr.Dataset], phase: float) -> Figure:
    """Draw which coefficient matters more over amplitude and frequency, a panel for each model."""
    figure, axes = _panels(
        len(searched),
        f"Which 0.2 more friction shortens the slide more (μ .4 → .6 or μ' .1 → .3), phase {phase:.0f}°",
    )
    drawn: list[ContourSet] = []
    for axis, (name, grid) in zip(axes, searched.items(), strict=True):
        static, kinetic = effects(grid.sel(phase=phase))
        base = grid.sel(phase=phase).peak_slide.isel(row=0)
        more = ((static - kinetic) / base.where(base > 0.0)).transpose("amplitude", "frequency")
        levels = np.linspace(-1.0, 1.0, 11)
        f, A = grid.frequency, grid.amplitude / STANDARD_GRAVITY
        drawn.append(axis.contourf(f, A, more, levels, cmap="PuOr_r", extend="both"))
        if float(more.min()) < 0.0 < float(more.max()):
            axis.contour(f, A, more, [0.0], colors=INK, linewidths=1.4)
        axis.set_facecolor("#ededed")
        axis.axhline(
            PAPER_ROWS[2][0],
            color=MUTED,
            linestyle="--",
            linewidth=1.2,
            label=f"{PAPER_ROWS[2][0]:g} g: μ of the third row",
        )
        axis.set_title(name, fontsize=FONT)
        axis.set_xlabel("Frequency [Hz]", fontsize=FONT)
    axes[0].set_ylabel("Amplitude [g]", fontsize=FONT)
    axes[0].legend(loc="lower right", fontsize=FONT - 2.0)
    bar = figure.colorbar(drawn[0], ax=axes)
    bar.set_label(
        "Difference of the effects / slide at (.4, .1) [–]\n< 0: μ' matters more;  > 0: μ", fontsize=FONT
    )
    return figure
