"""Plots of a building's floors: profiles of their peaks, and their spectra."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.ticker import MaxNLocator

from stayput.catalogue import phrase, say
from stayput.motion.spectrum import DAMPING, PERIODS, response_spectrum
from stayput.report.figures import FONT, new_figure, plain_log, saved, style
from stayput.report.fonts import drawable
from stayput.report.names import given_name, motion_label
from stayput.report.palette import ALARM, COMPONENT_COLOURS, INK, MUTED

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.building.model import FloorResponse
    from stayput.motion import Motion

LINES = (
    ("#0072b2", "-"),
    ("#e69f00", "--"),
    ("#009e73", "-."),
    ("#cc79a7", ":"),
    ("#56b4e9", (0, (5, 1, 1, 1))),
)
"""Colour and line of each storey's spectrum, in turn."""

HORIZONTAL = {"x": "o", "y": "s"}
"""Marker of each horizontal component, beside its colour."""


def height_factor(response: FloorResponse) -> NDArray[np.float64]:
    """Return 1 + 2z/h at the floors, shape (storeys + 1,): a rule of thumb for the peak over the ground's."""
    return 1.0 + 2.0 * (response.storeys - 1.0) / response.model.storeys


def shown_storeys(response: FloorResponse) -> tuple[int, ...]:
    """Return the floors whose spectra are drawn where nothing is said: in the middle, and the roof."""
    roof = response.model.storeys + 1
    return (roof,) if roof == 2 else ((roof + 1) // 2, roof)


def plot_building(
    response: FloorResponse,
    path: str | Path | None = None,
    storeys: Sequence[int] | None = None,
    *,
    language: str = "en",
) -> Figure:
    """Plot peak floor acceleration and velocity over the storeys, and floor spectra beside the ground's.

    The acceleration stands beside the ground's times 1 + 2z/h. The spectra are of x, at 5 % damping.

    Parameters
    ----------
    response : FloorResponse
        What the floors do.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
    storeys : sequence of int, optional
        Floors whose spectra are drawn; default one in the middle, and the roof.
    language : str
        "en" or "ja".

    Raises
    ------
    InputError
        A storey that the building has not, or a path that cannot be written.
    """
    figure = new_figure(12.0, 5.0)
    acceleration, velocity, spectra = figure.subplots(1, 3, width_ratios=[1.0, 1.0, 1.35])
    model = response.model
    title = say(
        "plots.building",
        language,
        name=given_name(model.name, language),
        period=model.periods[0],
        kind=phrase("plots.yielding" if model.yields else "plots.linear"),
        motion=motion_label(response.motion, language),
    )
    figure.suptitle(drawable(title), fontsize=FONT + 1.0, color=INK)
    ground = response.motion.peaks()
    for name in response.acceleration:
        drawn = {
            "color": COMPONENT_COLOURS[name],
            "marker": HORIZONTAL[name],
            "markersize": 4.0,
            "linewidth": 1.4,
        }
        acceleration.plot(
            response.peak_acceleration(name),
            response.storeys,
            label=say("plots.floors", language, component=name),
            **drawn,
        )
        velocity.plot(
            100.0 * response.peak_velocity(name),
            response.storeys,
            label=say("plots.floors", language, component=name),
            **drawn,
        )
    reference = {"color": MUTED, "linestyle": "--", "linewidth": 1.3}
    thumb = ground["x"].pga * height_factor(response)
    acceleration.plot(thumb, response.storeys, label=say("plots.thumb", language), **reference)
    velocity.axvline(100.0 * ground["x"].pgv, label=say("plots.ground_x", language), **reference)
    for axis, label in (
        (acceleration, "plots.peak_acceleration"),
        (velocity, "plots.peak_velocity"),
    ):
        _storey_axis(axis, response, language)
        axis.set_xlabel(say(label, language), fontsize=FONT)
        axis.legend(loc="best", fontsize=FONT - 1.5, framealpha=0.85)
    _draw_spectra(spectra, response, shown_storeys(response) if storeys is None else storeys, language)
    return saved(figure, path)


def _storey_axis(axis: Axes, response: FloorResponse, language: str) -> None:
    style(axis, zero=False)
    axis.set_xlim(left=0.0)
    axis.yaxis.set_major_locator(MaxNLocator(integer=True))
    axis.set_ylim(0.7, response.model.storeys + 1.3)
    axis.set_ylabel(say("plots.storey", language, roof=response.model.storeys + 1), fontsize=FONT)


def _draw_spectra(axis: Axes, response: FloorResponse, storeys: Sequence[int], language: str) -> None:
    style(axis, zero=False)
    ground = response_spectrum(response.motion)
    axis.plot(ground.periods, ground.sa, color=INK, linewidth=1.6, label=say("plots.ground", language))
    for i, storey in enumerate(storeys):
        colour, line = LINES[i % len(LINES)]
        spectrum = response_spectrum(response.floor(storey))
        label = given_name(response.model.place(storey), language)
        axis.plot(spectrum.periods, spectrum.sa, color=colour, linestyle=line, linewidth=1.6, label=label)
    for i, period in enumerate(response.model.periods[:3]):
        if PERIODS[0] <= period <= PERIODS[-1]:
            label_of_periods = say("plots.periods", language) if i == 0 else None
            axis.axvline(period, color=MUTED, linewidth=0.9, linestyle=":", label=label_of_periods)
    plain_log(axis)
    axis.set_xlim(PERIODS[0], PERIODS[-1])
    axis.set_xlabel(say("plots.period", language), fontsize=FONT)
    axis.set_ylabel(say("plots.floor_sa", language, damping=100.0 * DAMPING), fontsize=FONT)
    axis.legend(loc="best", fontsize=FONT - 1.5, framealpha=0.85)


def plot_recorded_floor(
    response: FloorResponse, storey: int, recorded: Motion, path: str | Path | None = None
) -> Figure:
    """Plot a recorded floor beside the computed one: accelerations over time, and spectra.

    Parameters
    ----------
    response : FloorResponse
        What the floors do under the record of the ground.
    storey : int
        Storey whose floor was recorded.
    recorded : Motion
        Its record.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.

    Raises
    ------
    InputError
        A storey that the building has not, or a path that cannot be written.
    """
    computed = response.floor(storey)
    figure = new_figure(11.0, 5.2)
    grid = figure.add_gridspec(3, 2, width_ratios=[1.3, 1.0])
    place, model = response.model.place(storey), response.model
    title = say("plots.recorded", name=model.name, period=model.periods[0], place=place)
    figure.suptitle(drawable(title), fontsize=FONT + 1.0, color=INK)
    spectra = figure.add_subplot(grid[:, 1])
    shown = (
        (say("plots.ground_recorded"), response.motion, INK, "-"),
        (say("plots.place_recorded", place=place), recorded, COMPONENT_COLOURS["x"], "-"),
        (say("plots.place_computed", place=place), computed, ALARM, "--"),
    )
    limit = 1.1 * max(motion.pga for _, motion, _, _ in shown)
    first: Axes | None = None
    for row, (label, motion, colour, line) in enumerate(shown):
        axis = figure.add_subplot(grid[row, 0], sharex=first)
        first = first or axis
        style(axis)
        peaks = say("plots.peaks", label=label, pga=motion.pga, pgv=100.0 * motion.pgv)
        axis.plot(motion.time, motion.x, color=colour, linewidth=0.9)
        axis.set_title(drawable(peaks), fontsize=FONT - 0.5, color=INK, loc="left")
        axis.set_ylim(-limit, limit)
        axis.tick_params(labelbottom=row == len(shown) - 1)
        spectrum = response_spectrum(motion)
        spectra.plot(spectrum.periods, spectrum.sa, color=colour, linestyle=line, linewidth=1.6, label=label)
        if row == 1:
            axis.set_ylabel(say("plots.acceleration"), fontsize=FONT)
        if row == len(shown) - 1:
            axis.set_xlabel(say("report.axis_time"), fontsize=FONT)
    style(spectra, zero=False)
    plain_log(spectra)
    spectra.set_xlim(PERIODS[0], PERIODS[-1])
    spectra.set_xlabel(say("plots.period"), fontsize=FONT)
    spectra.set_ylabel(say("plots.sa", damping=100.0 * DAMPING), fontsize=FONT)
    spectra.legend(loc="lower left", fontsize=FONT - 1.0, framealpha=0.85)
    return saved(figure, path)
