"""Plots of a run in space, as Matplotlib figures made without pyplot (thread-safe, headless)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import ConvexHull

from stayput.catalogue import say
from stayput.report.figures import FONT, new_figure, saved, style
from stayput.report.fonts import drawable
from stayput.report.names import motion_label
from stayput.report.palette import COMPONENT_COLOURS, INK, MUTED, ROOM
from stayput.report.space.histories import at_time
from stayput.report.space.said import became, names_of
from stayput.report.space.scene import body_colour
from stayput.simulation.space_records import matrices
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.simulation.space_run import SpaceRun

_SMALLEST = 0.1
"""Half the range of an axis on which nothing happens [°]."""


def plot_space_run(
    run: SpaceRun,
    path: str | Path | None = None,
    *,
    names: Sequence[str] | None = None,
    language: str = "en",
) -> Figure:
    """Plot the floor's acceleration, tilt and turn in plan of each body, and their ways as seen from above.

    Parameters
    ----------
    run : SpaceRun
        The run.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
    names : sequence of str, optional
        What the bodies are called; by default by their numbers.
    language : str
        Language of the texts, "en" or "ja".

    Returns
    -------
    Figure
        The Matplotlib figure.

    Raises
    ------
    InputError
        Another language, not a name for each body, or a path that cannot be written.
    """
    check_language(language)
    called = names_of(run, names, language)
    figure = new_figure(12.0, 6.6)
    figure.suptitle(drawable(say(became(run, called), language)), fontsize=FONT + 2.0, color=INK)
    grid = figure.add_gridspec(3, 2, width_ratios=[1.35, 1.0], height_ratios=[1.0, 1.3, 1.0])
    acceleration = figure.add_subplot(grid[0, 0])
    tilt = figure.add_subplot(grid[1, 0], sharex=acceleration)
    turn = figure.add_subplot(grid[2, 0], sharex=acceleration)
    _draw_acceleration(acceleration, run, language)
    _draw_of_bodies(tilt, run, np.degrees(run.tilt), say("space.axis_tilt", language), language)
    if run.overturned.any() or run.fell_off.any():
        tilt.legend(loc="best", fontsize=FONT - 1.5, framealpha=0.85)
    _draw_of_bodies(turn, run, np.degrees(run.yaw), say("space.axis_yaw", language), language)
    turn.set_xlim(float(run.time[0]), float(run.time[-1]))
    turn.set_xlabel(say("report.axis_time", language), fontsize=FONT)
    for axis in (acceleration, tilt):
        axis.tick_params(labelbottom=False)
    figure.align_ylabels([acceleration, tilt, turn])
    _draw_plan(figure.add_subplot(grid[:, 1]), run, called, language)
    return saved(figure, path)


def _draw_acceleration(axis: Axes, run: SpaceRun, language: str) -> None:
    style(axis)
    for name, a in run.motion.components.items():
        label = say(f"space.floor_{name}", language)
        axis.plot(run.motion.time, a, color=COMPONENT_COLOURS[name], linewidth=0.9, label=label)
    axis.set_ylabel(say("plots.floor_acceleration", language), fontsize=FONT)
    title = drawable(motion_label(run.motion, language))
    axis.set_title(title, fontsize=FONT - 0.5, color=MUTED, loc="left")
    axis.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), fontsize=FONT - 1.5, frameon=False, ncols=3)


def _draw_of_bodies(
    axis: Axes, run: SpaceRun, values: NDArray[np.float64], label: str, language: str
) -> None:
    """Draw one history for each body, shape (bodies, samples), and when it overturned and fell off."""
    style(axis)
    for b, history in enumerate(values):
        axis.plot(run.time, history, color=body_colour(b), linewidth=1.6)
    for times, said, marker in (
        (run.overturn_time, "plots.overturned", "X"),
        (run.fall_time, "plots.fell_off", "v"),
    ):
        for b, time in enumerate(times.tolist()):
            if math.isnan(time):
                continue
            axis.plot(
                time,
                at_time(time, run, values[b]),
                marker,
                color=body_colour(b),
                markersize=8.0,
                markeredgecolor=INK,
                markeredgewidth=0.8,
                zorder=5,
                label=say(said, language, time=time),
            )
    axis.set_ylabel(label, fontsize=FONT)
    largest = float(np.abs(values).max())
    if largest < _SMALLEST:
        axis.set_ylim(-_SMALLEST, _SMALLEST)


def _draw_plan(axis: Axes, run: SpaceRun, names: Sequence[str], language: str) -> None:
    """Draw the ways of the bodies from above, with their outlines at first and at the end, and the walls."""
    style(axis, zero=False)
    turns = matrices(run.attitude)
    for b, name in enumerate(names):
        solid, colour = run.standing[b].solid, body_colour(b)
        arms = solid.vertices - solid.centre_of_gravity
        for sample, dashes in ((0, "--"), (-1, "-")):
            seen = run.place[b, sample, :2] + arms @ turns[b, sample, :2].T
            outline = seen[ConvexHull(seen).vertices]
            closed = np.concatenate([outline, outline[:1]])
            if sample:
                axis.fill(*outline.T, color=colour, alpha=0.3, linewidth=0.0, zorder=2)
            axis.plot(*closed.T, dashes, color=colour, linewidth=1.4, zorder=3)
        axis.plot(*run.place[b, :, :2].T, color=INK, linewidth=2.4, zorder=4)
        axis.plot(*run.place[b, :, :2].T, color=colour, linewidth=1.4, zorder=4, label=drawable(name))
        axis.plot(*run.place[b, -1, :2], "o", color=colour, markersize=6.0, markeredgecolor=INK, zorder=5)
    for plane in run.planes[1:]:
        nx, ny, offset = (float(plane[name]) for name in ("nx", "ny", "offset"))
        if abs(nx) + abs(ny) > 0.5:
            x, y = offset * nx, offset * ny
            axis.axline((x, y), (x + ny, y + nx), color=ROOM, linewidth=4.0, zorder=1)
    axis.set_aspect("equal", adjustable="datalim")
    axis.set_xlabel(say("space.axis_x", language), fontsize=FONT)
    axis.set_ylabel(say("space.axis_y", language), fontsize=FONT)
    axis.set_title(say("space.plan", language), fontsize=FONT - 0.5, color=MUTED, loc="left")
    axis.legend(loc="best", fontsize=FONT - 1.0, framealpha=0.85)
