"""Plot of a motion's spectra."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import say
from stayput.motion.frequency import fourier_amplitude, konno_ohmachi
from stayput.motion.intensity import LONG_PERIOD_BOUNDS, LONG_PERIODS
from stayput.motion.spectrum import DAMPING, PERIODS, response_spectrum
from stayput.report.figures import FONT, new_figure, plain_log, saved, style
from stayput.report.fonts import drawable
from stayput.report.names import motion_label
from stayput.report.palette import COMPONENT_COLOURS, INK, MUTED

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.motion import Motion

LINES = {"x": "-", "y": "--", "z": ":"}
"""Line of each component, beside its colour."""


def plot_spectra(
    motion: Motion, path: str | Path | None = None, damping: float = DAMPING, *, language: str = "en"
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
    language : str
        "en" or "ja".

    Raises
    ------
    InputError
        A damping out of range, or a path that cannot be written.
    """
    figure = new_figure(10.0, 7.6)
    axes = figure.subplots(2, 2)
    title = say("plots.spectra", language, name=motion_label(motion, language), damping=100.0 * damping)
    figure.suptitle(drawable(title), fontsize=FONT + 2.0, color=INK)
    acceleration, velocity, absolute, fourier = axes.ravel()
    shown = np.geomspace(0.1, 0.5 / motion.dt, 200)
    for name, a in motion.components.items():
        response = response_spectrum(motion, PERIODS, damping, name)
        drawn = {
            "color": COMPONENT_COLOURS[name],
            "linestyle": LINES[name],
            "label": say(f"plots.component_{name}", language),
        }
        acceleration.plot(response.periods, response.sa, linewidth=1.4, **drawn)
        velocity.plot(response.periods, 100.0 * response.psv, linewidth=1.4, **drawn)
        f, amplitude = fourier_amplitude(a, motion.dt)
        smooth = konno_ohmachi(f, amplitude, shown, 40.0)
        faint = {"color": COMPONENT_COLOURS[name], "linewidth": 0.4, "alpha": 0.3, "zorder": 1}
        fourier.plot(f[1:], 100.0 * amplitude[1:], **faint)
        fourier.plot(shown, 100.0 * smooth, linewidth=1.4, zorder=3, **drawn)
        if name != "z":
            absolute.plot(response.periods, 100.0 * response.sva, linewidth=1.4, **drawn)
    _label_long_period_classes(absolute, language)
    for axis, label in (
        (acceleration, "plots.spectrum_sa"),
        (velocity, "plots.spectrum_psv"),
        (absolute, "plots.spectrum_sva"),
        (fourier, "plots.spectrum_fourier"),
    ):
        style(axis, zero=False)
        plain_log(axis)
        axis.set_ylabel(say(label, language), fontsize=FONT)
        axis.set_xlabel(say("plots.period", language), fontsize=FONT)
        axis.set_xlim(PERIODS[0], PERIODS[-1])
    fourier.set_xlabel(say("plots.frequency", language), fontsize=FONT)
    fourier.set_xlim(shown[0], shown[-1])
    _end_fourier_axis(fourier)
    acceleration.legend(loc="best", fontsize=FONT - 1.0, framealpha=0.85)
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
