"""Figures of the friction study."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import MaxNLocator

from stayput.motion.units import STANDARD_GRAVITY
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from stayput.studies.friction.runs import PAPER_ROWS, Nearest, deviation, effects, in_words

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.contour import ContourSet
    from matplotlib.figure import Figure

WORST = 1.0
"""Deviations from the paper are coloured up to this."""


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
    figure, axes = _panels(len(maps), f"Peak slide under a sine of {in_words(sine)}")
    largest = max(float(found.peak_slide.max()) for found in maps.values())
    levels = MaxNLocator(12).tick_values(0.0, 100.0 * max(largest, 1e-6))
    drawn: list[ContourSet] = []
    for axis, (name, found) in zip(axes, maps.items(), strict=True):
        mu = found.static_friction.to_numpy()
        slides = 100.0 * found.peak_slide.transpose("kinetic_friction", "static_friction").to_numpy()
        drawn.append(axis.contourf(mu, mu, slides, levels, cmap="cividis"))
        rocks = found.rocks.transpose("kinetic_friction", "static_friction").to_numpy()
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
    for axis, (name, found) in zip(axes, searched.items(), strict=True):
        sine = nearest[name]
        far = deviation(found).sel(phase=sine.phase).transpose("amplitude", "frequency")
        levels = np.linspace(0.0, WORST, 11)
        drawn.append(
            axis.contourf(found.frequency, found.amplitude, far, levels, cmap="cividis_r", extend="max")
        )
        axis.plot(sine.frequency, sine.amplitude, "*", color=ALARM, markeredgecolor="white", markersize=16.0)
        axis.set_title(
            f"{name}\nnearest: {in_words(sine)}: {100.0 * sine.deviation:.0f} %",
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
    for axis, (name, found) in zip(axes, searched.items(), strict=True):
        static, kinetic = effects(found.sel(phase=phase))
        base = found.sel(phase=phase).peak_slide.isel(row=0)
        more = ((static - kinetic) / base.where(base > 0.0)).transpose("amplitude", "frequency")
        levels = np.linspace(-1.0, 1.0, 11)
        f, A = found.frequency, found.amplitude / STANDARD_GRAVITY
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
