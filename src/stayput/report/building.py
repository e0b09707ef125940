"""Plots of a building's floors: profiles of their peaks, and their spectra."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

import numpy as np
from matplotlib.ticker import MaxNLocator

from stayput.building.response import FloorDrawing, FloorResponse
from stayput.catalogue import phrase, say
from stayput.errors import word_of
from stayput.motion.response import DAMPING, PERIODS
from stayput.report.figures import drawable, label_axes, legend_within, new_figure, plain_log, saved, style
from stayput.report.names import given_name, motion_label
from stayput.report.palette import COMPONENT_COLOURS, INK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.building.model import ShearModel

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


def plot_building(
    response: FloorResponse,
    path: str | Path | None = None,
    storeys: Sequence[int] | None = None,
    *,
    title: str = "",
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
    title : str
        Title; none by default.
    language : str
        "en" or "ja".

    Raises
    ------
    InputError
        A storey that the building has not, or a path that cannot be written.
    """
    figure = new_figure(12.0, 5.0, title)
    axes = figure.subplots(1, 3, width_ratios=[1.0, 1.0, 1.35])
    for axis, what in zip(axes, get_args(FloorDrawing), strict=True):
        draw_floors(axis, response, what, storeys, language)
    return saved(figure, path)


def building_title(response: FloorResponse, language: str) -> str:
    """Return the title of a picture: the building and its first period, and the motion of the ground."""
    model = response.model
    return say(
        "plots.building",
        language,
        name=given_name(model.name, language),
        period=model.periods[0],
        kind=phrase("plots.yielding" if model.yields else "plots.linear"),
        motion=motion_label(response.motion, language),
    )


def draw_floors(
    axis: Axes, response: FloorResponse, what: FloorDrawing, storeys: Sequence[int] | None, language: str
) -> None:
    """Draw the floors' peak acceleration or velocity over the storeys, or floor spectra, on axes.

    Raises
    ------
    InputError
        Something else, or a storey that the building has not.
    """
    word_of("plots.what", what, get_args(FloorDrawing), "what")
    style(axis, zero=False)
    roof = response.model.storeys + 1
    if what == "spectra":
        usual = (roof,) if roof == 2 else ((roof + 1) // 2, roof)
        _draw_spectra(axis, response, usual if storeys is None else storeys, language)
        return
    for name in response.acceleration:
        fast = what == "velocity"
        peaks = 100.0 * response.peak_velocity(name) if fast else response.peak_acceleration(name)
        looks: dict[str, Any] = {"color": COMPONENT_COLOURS[name], "marker": HORIZONTAL[name]}
        looks |= {"markersize": 4.0, "linewidth": 1.4, "label": say("plots.floors", language, component=name)}
        axis.plot(peaks, response.storeys, **looks)
    reference: dict[str, Any] = {"color": MUTED, "linestyle": "--", "linewidth": 1.3}
    ground = response.motion.peaks()["x"]
    if what == "acceleration":
        # a rule of thumb: 1 + 2z/h
        thumb = ground.pga * (1.0 + 2.0 * (response.storeys - 1.0) / response.model.storeys)
        axis.plot(thumb, response.storeys, label=say("plots.thumb", language), **reference)
    else:
        axis.axvline(100.0 * ground.pgv, label=say("plots.ground_x", language), **reference)
    axis.set_xlim(left=0.0)
    axis.yaxis.set_major_locator(MaxNLocator(integer=True))
    axis.set_ylim(0.7, roof + 0.3)
    label_axes(axis, language, f"plots.peak_{what}", "plots.storey", roof=roof)
    legend_within(axis)


def draw_modes(axis: Axes, model: ShearModel, modes: int, language: str) -> None:
    """Draw the slowest mode shapes of a building over its masses, times their participation factors.

    Their sum over all modes is 1 at every mass.
    """
    style(axis, zero=False)
    axis.axvline(0.0, color=MUTED, linewidth=0.6)
    modal = model.modes
    floors = np.arange(len(model.masses) + 1)
    for i in range(min(modes, len(model.masses))):
        colour, line = LINES[i % len(LINES)]
        percent = 100.0 * modal.effective_mass[i]
        label = say("plots.mode_shape", language, number=i + 1, period=modal.periods[i], percent=percent)
        values = np.append(0.0, modal.participation[i] * modal.shapes[:, i])
        axis.plot(values, floors, color=colour, linestyle=line, marker="o", markersize=4.0, label=label)
    axis.yaxis.set_major_locator(MaxNLocator(integer=True))
    label_axes(axis, language, "plots.mode_shapes", "plots.floor")
    legend_within(axis)


def _draw_spectra(axis: Axes, response: FloorResponse, storeys: Sequence[int], language: str) -> None:
    ground = response.motion.spectrum()
    axis.plot(ground.periods, ground.sa, color=INK, linewidth=1.6, label=say("report.ground_name", language))
    for i, storey in enumerate(storeys):
        colour, line = LINES[i % len(LINES)]
        spectrum = response.floor(storey).spectrum()
        label = drawable(given_name(response.model.place(storey), language))
        axis.plot(spectrum.periods, spectrum.sa, color=colour, linestyle=line, linewidth=1.6, label=label)
    for i, period in enumerate(response.model.periods[:3]):
        if PERIODS[0] <= period <= PERIODS[-1]:
            label_of_periods = say("plots.periods", language) if i == 0 else None
            axis.axvline(period, color=MUTED, linewidth=0.9, linestyle=":", label=label_of_periods)
    plain_log(axis)
    axis.set_xlim(PERIODS[0], PERIODS[-1])
    label_axes(axis, language, "plots.period", "plots.floor_sa", damping=100.0 * DAMPING)
    legend_within(axis)
