"""Plots of spectra: of one response on axes, and all of a motion in a figure."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import say
from stayput.errors import word_of
from stayput.motion.intensity import LONG_PERIOD_BOUNDS, LONG_PERIODS
from stayput.motion.spectrum import DAMPING, PERIODS, fourier_amplitude, konno_ohmachi, response_spectrum
from stayput.report.figures import FONT, LINE, colour_beside, new_figure, plain_log, saved, style
from stayput.report.fonts import drawable
from stayput.report.palette import COMPONENT_COLOURS, INK, MUTED

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.motion import Motion
    from stayput.motion.response import ResponseSpectrum, SpectralResponse

LINES = {"x": "-", "y": "--", "z": ":"}
"""Line of each component, beside its colour."""


RESPONSES: dict[SpectralResponse, tuple[float, str]] = {
    "sa": (1.0, "plots.spectrum_sa"),
    "sv": (100.0, "plots.spectrum_sv"),
    "sd": (100.0, "plots.spectrum_sd"),
    "psa": (1.0, "plots.spectrum_psa"),
    "psv": (100.0, "plots.spectrum_psv"),
    "sva": (100.0, "plots.spectrum_sva"),
}
"""Size of the unit that is drawn, and the label, of each response."""


def draw_spectrum(
    axis: Axes, spectrum: ResponseSpectrum, what: SpectralResponse, language: str, **line: Any
) -> None:
    """Draw one response over the period on logarithmic axes.

    Raises
    ------
    InputError
        Another response.
    """
    word_of("plots.what", what, RESPONSES, "what")
    scale, label = RESPONSES[what]
    style(axis, zero=False)
    values = scale * getattr(spectrum, what)
    looks: dict[str, Any] = {"linewidth": 1.4, "gid": LINE} | line
    looks.setdefault("color", colour_beside(axis, COMPONENT_COLOURS["x"]))
    axis.plot(spectrum.periods, values, **looks)
    plain_log(axis)
    axis.set_xlabel(say("plots.period", language), fontsize=FONT)
    axis.set_ylabel(say(label, language), fontsize=FONT)
    if "label" in line:
        axis.legend(loc="best", fontsize=FONT - 1.0, framealpha=0.85)


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
    figure = new_figure(10.0, 7.6)
    axes = figure.subplots(2, 2)
    if title:
        figure.suptitle(drawable(title), fontsize=FONT + 2.0, color=INK)
    acceleration, velocity, absolute, fourier = axes.ravel()
    shown = np.geomspace(0.1, 0.5 / motion.dt, 200)
    for name, a in motion.components.items():
        response = response_spectrum(motion, PERIODS, damping, name)
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
    style(fourier, zero=False)
    plain_log(fourier)
    fourier.set_ylabel(say("plots.spectrum_fourier", language), fontsize=FONT)
    fourier.set_xlabel(say("plots.frequency", language), fontsize=FONT)
    fourier.set_xlim(shown[0], shown[-1])
    _end_fourier_axis(fourier)
    return saved(figure, path)


def _label_long_period_classes(axis: Axes, language: str) -> None:
    """Mark where JMA's classes of long-period motion begin."""
    first, last = float(LONG_PERIODS[0]), float(LONG_PERIODS[-1])
    for number, bound in enumerate(LONG_PERIOD_BOUNDS, start=1):
        axis.plot([first, last], [100.0 * bound] * 2, color=MUTED, linewidth=1.0)
        axis.annotate(
            say("plots.long_period_class", language, number=number),
            (last, 100.0 * bound),
            xytext=(-2.0, 2.0),
            textcoords="offset points",
            ha="right",
            fontsize=FONT - 2.0,
            color=MUTED,
        )
    axis.set_title(say("plots.long_period", language), fontsize=FONT - 1.0, color=MUTED)


def _end_fourier_axis(axis: Axes) -> None:
    """Limit the axis to four decades: below lie round-off and filter noise."""
    top = max((float(np.max(line.get_ydata())) for line in axis.lines), default=1.0)  # pyright: ignore[reportArgumentType, reportCallIssue]
    if top > 0.0:
        axis.set_ylim(1e-4 * top, 1.5 * top)
