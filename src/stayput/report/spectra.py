"""The picture of a suite: its response spectra, and how much they vary from motion to motion."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

import numpy as np
from matplotlib.ticker import LogLocator
from numpy.typing import NDArray

from stayput.catalogue import phrase, say
from stayput.errors import word_of
from stayput.motion.intensity import LONG_PERIOD_BOUNDS, LONG_PERIODS
from stayput.motion.response import DAMPING, PERIODS, SpectralResponse, fourier_amplitude, konno_ohmachi
from stayput.motion.suites.suite import Suite, SuiteSpectra
from stayput.report import figures
from stayput.report.figures import drawable
from stayput.report.names import given_name
from stayput.report.palette import ALARM, COMPONENT_COLOURS, MUTED
from stayput.wording import counted

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.motion.record import Motion
    from stayput.motion.response import ResponseSpectrum
    from stayput.motion.suites.target import TargetSpectrum


USUAL_SCATTER = (0.5, 0.7)
"""Standard deviations of ln Sa in ground-motion models (common knowledge, not re-checked)."""

_DECADES = 3.5
"""How many factors of ten the axis of Sa shows at most, below its top."""


def plot_suite(
    suite: Suite,
    path: str | Path | None = None,
    target: TargetSpectrum | None = None,
    component: str = "x",
    *,
    title: str = "",
    language: str = "en",
) -> Figure:
    """Plot all spectra of a suite, their median and scatter, and the standard deviation of ln Sa below.

    Parameters
    ----------
    suite : Suite
        The suite.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
    target : TargetSpectrum, optional
        Drawn too; its damping is then that of the spectra.
    component : str
        "x", "y" or "z".
    title : str
        Title; none by default.
    language : str
        "en" or "ja".

    Returns
    -------
    Figure
        The Matplotlib figure.

    Raises
    ------
    InputError
        A path that cannot be written; a component that is not there.
    """
    figure = figures.new_figure(7.6, 7.4, title)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=[2.4, 1.0])
    draw_suite(upper, suite, "spectra", target, component, language)
    draw_suite(lower, suite, "scatter", target, component, language)
    upper.set_xlabel("")
    figure.align_ylabels([upper, lower])
    return figures.saved(figure, path)


def suite_title(suite: Suite, language: str) -> str:
    """Return what a suite is called in the title of a picture, and whether it was computed."""
    kind = "whole" if all(motion.synthetic for motion in suite) else "part"
    return say(
        "plots.suite",
        language,
        name=given_name(suite.name, language) or phrase("plots.suite_unnamed"),
        count=(counted(len(suite), "motion"), f"{len(suite)}本"),
        kind=phrase(f"plots.suite_{kind}") if suite.synthetic else "",
    )


def draw_suite(
    axis: Axes,
    suite: Suite,
    what: SuiteSpectra,
    target: TargetSpectrum | None,
    component: str,
    language: str,
    **line: Any,
) -> None:
    """Draw a suite's spectra, or the standard deviation of ln Sa, on axes.

    A further suite on the same axes has a colour of its own, and is named in the legend.

    Raises
    ------
    InputError
        Something else, or a component that is not there.
    """
    word_of("plots.what", what, get_args(SuiteSpectra), "what")
    damping = DAMPING if target is None else target.damping
    sa = suite.spectra(PERIODS, damping, component)
    first = COMPONENT_COLOURS[component]
    looks: dict[str, Any] = {"color": figures.colour_beside(axis, first), "gid": figures.LINE} | line
    if _holds_suite(axis):
        looks.setdefault("label", given_name(suite.name, language))
    if what == "spectra":
        _draw_spectra(axis, sa, looks, language)
        if target is not None:
            inside = (target.periods >= PERIODS[0]) & (target.periods <= PERIODS[-1])
            label = drawable(say("plots.target", language, name=given_name(target.name, language)))
            dashed: dict[str, Any] = {"color": ALARM, "linewidth": 2.0, "linestyle": "-.", "zorder": 5}
            axis.plot(target.periods[inside], target.sa[inside], label=label, **dashed)
        figures.label_axes(axis, language, y="plots.sa_of", component=component, damping=100.0 * damping)
    else:
        _draw_scatter(axis, sa, looks, language)
        figures.plain_log(axis, y=False)
    figures.label_axes(axis, language, x="plots.period")
    named: dict[str, Any] = {}  # what is drawn for every suite alike stands once in the legend
    for handle, label in zip(*axis.get_legend_handles_labels(), strict=True):
        named.setdefault(label, handle)
    place = "lower left" if what == "spectra" else "best"
    axis.legend(named.values(), named.keys(), loc=place, fontsize=figures.FONT - 1.0, framealpha=0.9)


def _holds_suite(axis: Axes) -> bool:
    return any(line.get_gid() == figures.LINE for line in axis.lines)


def _logs(sa: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64] | None]:
    """Return mean and standard deviation of ln Sa at each period; no deviation of one motion."""
    logs = np.log(np.maximum(sa, 1e-12))
    return logs.mean(axis=0), logs.std(axis=0, ddof=1) if len(sa) > 1 else None


def _draw_spectra(axis: Axes, sa: NDArray[np.float64], looks: dict[str, Any], language: str) -> None:
    mean, scatter = _logs(sa)
    median = np.exp(mean)
    figures.style(axis, zero=False)
    low, high = axis.get_ylim() if _holds_suite(axis) else (math.inf, 0.0)
    for place, row in enumerate(sa):
        label = say("plots.each_motion", language) if place == 0 else None
        axis.plot(PERIODS, row, color=MUTED, linewidth=0.6, alpha=0.45, label=label)
    looks = {"linewidth": 2.4, "label": say("plots.median", language)} | looks
    axis.plot(PERIODS, median, **looks)
    if scatter is not None:
        for sign, label in ((1.0, say("plots.spread", language)), (-1.0, None)):
            edge = median * np.exp(sign * scatter)
            axis.plot(PERIODS, edge, color=looks["color"], linewidth=1.4, linestyle="--", label=label)
    figures.plain_log(axis)
    top = max(high, 1.4 * float(sa.max()))
    axis.set_ylim(max(min(low, 0.7 * float(sa.min())), top * 10.0**-_DECADES), top)
    axis.set_xlim(float(PERIODS[0]), float(PERIODS[-1]))
    axis.set_xticks((0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0))
    axis.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))


def _draw_scatter(axis: Axes, sa: NDArray[np.float64], looks: dict[str, Any], language: str) -> None:
    _, scatter = _logs(sa)
    figures.style(axis)
    low, high = USUAL_SCATTER
    usual = say("plots.usual_scatter", language, low=low, high=high)
    if usual not in axis.get_legend_handles_labels()[1]:
        axis.axhspan(low, high, color=MUTED, alpha=0.22, linewidth=0.0, label=usual)
    top = axis.get_ylim()[1] if _holds_suite(axis) else 1.0
    if scatter is not None:
        looks = {"linewidth": 2.0, "label": say("plots.this_suite", language)} | looks
        axis.plot(PERIODS, scatter, **looks)
        top = max(top, 1.15 * float(scatter.max()))
    axis.set_ylim(0.0, top)
    figures.label_axes(axis, language, y="plots.scatter")


LINES = {"x": "-", "y": "--", "z": ":"}
"""Line of each component, beside its colour."""


def draw_spectrum(
    axis: Axes, spectrum: ResponseSpectrum, what: SpectralResponse, language: str, **line: Any
) -> None:
    """Draw one response over the period on logarithmic axes.

    Raises
    ------
    InputError
        Another response.
    """
    word_of("plots.what", what, get_args(SpectralResponse), "what")
    figures.style(axis, zero=False)
    values = getattr(spectrum, what) * (1.0 if what in ("sa", "psa") else 100.0)  # m/s², cm/s or cm
    looks: dict[str, Any] = {"linewidth": 1.4, "gid": figures.LINE} | line
    looks.setdefault("color", figures.colour_beside(axis, COMPONENT_COLOURS["x"]))
    axis.plot(spectrum.periods, values, **looks)
    figures.plain_log(axis)
    figures.label_axes(axis, language, "plots.period", f"plots.spectrum_{what}")
    if "label" in line:
        figures.legend_within(axis)


def plot_spectra(
    motion: Motion,
    path: str | Path | None = None,
    damping: float = DAMPING,
    *,
    title: str = "",
    language: str = "en",
) -> Figure:
    """Plot Sa, pseudo-velocity, absolute velocity and the Fourier spectrum of every component.

    Parameters
    ----------
    motion : Motion
        The motion.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
    damping : float
        Damping ratio of the oscillators.
    title : str
        Title; none by default.
    language : str
        "en" or "ja".

    Raises
    ------
    InputError
        A damping out of range, or a path that cannot be written.
    """
    figure = figures.new_figure(10.0, 7.6, title)
    axes = figure.subplots(2, 2)
    acceleration, velocity, absolute, fourier = axes.ravel()
    shown = np.geomspace(0.1, 0.5 / motion.dt, 200)
    for name, a in motion.components.items():
        response = motion.spectrum(PERIODS, damping, name)
        drawn: dict[str, Any] = {"color": COMPONENT_COLOURS[name], "linestyle": LINES[name]}
        label = say(f"plots.component_{name}", language)
        draw_spectrum(acceleration, response, "sa", language, label=label, **drawn)
        draw_spectrum(velocity, response, "psv", language, **drawn)
        f, amplitude = fourier_amplitude(a, motion.dt)
        smooth = konno_ohmachi(f, amplitude, shown, 40.0)
        faint = {"color": COMPONENT_COLOURS[name], "linewidth": 0.4, "alpha": 0.3, "zorder": 1}
        fourier.plot(f[1:], 100.0 * amplitude[1:], **faint)
        fourier.plot(shown, 100.0 * smooth, linewidth=1.4, zorder=3, **drawn)
        if name != "z":
            draw_spectrum(absolute, response, "sva", language, **drawn)
    _label_long_period_classes(absolute, language)
    for axis in (acceleration, velocity, absolute):
        axis.set_xlim(PERIODS[0], PERIODS[-1])
    figures.style(fourier, zero=False)
    figures.plain_log(fourier)
    figures.label_axes(fourier, language, "plots.frequency", "plots.spectrum_fourier")
    fourier.set_xlim(shown[0], shown[-1])
    top = max(float(np.max(line.get_ydata())) for line in fourier.lines)  # pyright: ignore[reportArgumentType, reportCallIssue]
    if top > 0.0:
        fourier.set_ylim(1e-4 * top, 1.5 * top)  # below lie round-off and filter noise
    return figures.saved(figure, path)


def _label_long_period_classes(axis: Axes, language: str) -> None:
    """Mark where JMA's classes of long-period motion begin."""
    first, last = float(LONG_PERIODS[0]), float(LONG_PERIODS[-1])
    for number, bound in enumerate(LONG_PERIOD_BOUNDS, start=1):
        axis.plot([first, last], [100.0 * bound] * 2, color=MUTED, linewidth=1.0)
        name = say("plots.long_period_class", language, number=number)
        looks: dict[str, Any] = {"textcoords": "offset points", "ha": "right", "color": MUTED}
        axis.annotate(name, (last, 100.0 * bound), (-2.0, 2.0), fontsize=figures.FONT - 2.0, **looks)
    axis.set_title(say("plots.long_period", language), fontsize=figures.FONT - 1.0, color=MUTED)
