"""Plots of a run in space, as Matplotlib figures made without pyplot (thread-safe, headless)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, get_args

import numpy as np
from matplotlib.lines import Line2D
from scipy.spatial import ConvexHull

from stayput.catalogue import say
from stayput.catalogue.names import OUTCOMES
from stayput.errors import word_of
from stayput.report.figures import FONT, label_axes, legend_within, new_figure, saved, style
from stayput.report.fonts import drawable, with_face, wrapped
from stayput.report.history import at_time
from stayput.report.names import acceleration_label, motion_label
from stayput.report.palette import BODY_COLOURS, COMPONENT_COLOURS, INK, MUTED, ROOM
from stayput.report.space.scene import body_colour
from stayput.report.space.shape import STILL_LOOKS, still_of
from stayput.report.space.summary import names_of
from stayput.simulation.space_records import matrices
from stayput.simulation.space_run import SpaceDrawing
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.simulation.space_run import SpaceRun

_WIDTH = 12.0
"""Width of the figure [inches]."""

_OVERTURNED, _FELL_OFF = "X", "v"
"""Marks of when a body overturned and fell off."""

_SMALLEST = 0.1
"""Half the range of an axis on which nothing happens [°]."""


def plot_space_run(
    run: SpaceRun,
    path: str | Path | None = None,
    *,
    names: Sequence[str] | None = None,
    title: str = "",
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
    title : str
        Title; none by default.
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
    figure, several = new_figure(_WIDTH, 6.6), len(called) > 1
    if title:
        said, face = with_face(title, FONT + 2.0)
        lines = wrapped(said, face, 0.96 * 72.0 * _WIDTH).replace("$", r"\$")
        figure.suptitle(lines, fontsize=FONT + 2.0, color=INK)
    grid = figure.add_gridspec(3, 2, width_ratios=[1.35, 1.0], height_ratios=[1.0, 1.3, 1.0])
    acceleration = figure.add_subplot(grid[0, 0])
    tilt = figure.add_subplot(grid[1, 0], sharex=acceleration)
    turn = figure.add_subplot(grid[2, 0], sharex=acceleration)
    _draw_acceleration(acceleration, run, language)
    _draw_of_bodies(tilt, run, "tilt", language)
    if not several and run.overturned.any():
        legend_within(tilt)
    _draw_of_bodies(turn, run, "yaw", language)
    turn.set_xlim(float(run.time[0]), float(run.time[-1]))
    label_axes(turn, language, x="report.axis_time")
    for axis in (acceleration, tilt):
        axis.tick_params(labelbottom=False)
    figure.align_ylabels([acceleration, tilt, turn])
    plan = figure.add_subplot(grid[:, 1])
    _draw_plan(plan, run, called, language)
    if several:
        shown, size = _body_handles(run, called, language), FONT - 0.5
        labels = [str(line.get_label()) for line in shown]
        widest = max(with_face(label, size)[1].getlength(label) for label in labels)
        columns = int(72.0 * _WIDTH // (widest + 5.5 * size))  # with the line and the space around it
        place: dict[str, Any] = {"loc": "outside lower center", "ncols": max(1, min(5, columns, len(shown)))}
        figure.legend(handles=shown, fontsize=size, frameon=False, **place)
    else:
        legend_within(plan)
    return saved(figure, path)


def draw_space_run(
    axis: Axes, run: SpaceRun, what: SpaceDrawing, names: Sequence[str] | None, language: str
) -> None:
    """Draw the tilts or turns of the bodies over time, the floor's acceleration, or their ways in plan.

    Raises
    ------
    InputError
        Something else, another language, or not a name for each body.
    """
    check_language(language)
    called = names_of(run, names, language)
    match word_of("plots.what", what, get_args(SpaceDrawing), "what"):
        case "plan":
            _draw_plan(axis, run, called, language)
        case "acceleration":
            _draw_acceleration(axis, run, language)
        case _:
            _draw_of_bodies(axis, run, what, language)
    if what != "plan":
        axis.set_xlim(float(run.time[0]), float(run.time[-1]))
        label_axes(axis, language, x="report.axis_time")
    if what != "acceleration" and (len(called) > 1 or what == "plan"):
        axis.legend(handles=_body_handles(run, called, language), fontsize=FONT - 1.0, framealpha=0.85)


def _dashes(body: int) -> Any:
    """Return the line style of a body, which tells apart bodies of one colour."""
    return ("-", "--", ":")[body // len(BODY_COLOURS) % 3]


def _body_handles(run: SpaceRun, names: Sequence[str], language: str) -> list[Line2D]:
    """Return the legend of several bodies: their names, and what the marks on their lines mean."""
    shown = [
        Line2D([], [], color=body_colour(b), linestyle=_dashes(b), linewidth=2.0, label=drawable(name))
        for b, name in enumerate(names)
    ]
    for happened, outcome, marker in (
        (run.overturned, "overturned", _OVERTURNED),
        (run.fell_off, "fell off", _FELL_OFF),
    ):
        if happened.any():
            looks: dict[str, Any] = {"markersize": 8.0, "markeredgecolor": INK, "color": "none"}
            shown.append(Line2D([], [], marker=marker, label=say(OUTCOMES[outcome], language), **looks))
    return shown


def _draw_acceleration(axis: Axes, run: SpaceRun, language: str) -> None:
    style(axis)
    for name, a in run.motion.components.items():
        label = say(f"space.floor_{name}", language)
        axis.plot(run.motion.time, a, color=COMPONENT_COLOURS[name], linewidth=0.9, label=label)
    axis.set_ylabel(acceleration_label(run.motion, language), fontsize=FONT)
    title = drawable(motion_label(run.motion, language))
    axis.set_title(title, fontsize=FONT - 0.5, color=MUTED, loc="left")
    axis.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), fontsize=FONT - 1.5, frameon=False, ncols=3)


def _draw_of_bodies(axis: Axes, run: SpaceRun, what: SpaceDrawing, language: str) -> None:
    """Draw one angle of each body over time [°], and when it overturned and fell off."""
    values: NDArray[np.float64] = np.degrees(getattr(run, what))
    style(axis)
    for b, history in enumerate(values):
        axis.plot(run.time, history, linestyle=_dashes(b), color=body_colour(b), linewidth=1.6)
    for times, said, marker in (
        (run.overturn_time, "plots.overturned", _OVERTURNED),
        (run.fall_time, "plots.fell_off", _FELL_OFF),
    ):
        for b, time in enumerate(times.tolist()):
            if math.isnan(time):
                continue
            looks: dict[str, Any] = {"color": body_colour(b), "label": say(said, language, time=time)}
            looks |= {"markersize": 8.0, "markeredgecolor": INK, "markeredgewidth": 0.8}
            axis.plot(time, at_time(time, run, values[b]), marker, zorder=5, **looks)
    label_axes(axis, language, y=f"space.axis_{what}")
    if np.abs(values).max() < _SMALLEST:
        axis.set_ylim(-_SMALLEST, _SMALLEST)


def _draw_plan(axis: Axes, run: SpaceRun, names: Sequence[str], language: str) -> None:
    """Draw the ways of the bodies from above, with their outlines at first and at the end, and the walls."""
    style(axis, zero=False)
    turns = matrices(run.attitude)
    for b, name in enumerate(names):
        solid, colour = run.pieces[b].solid, body_colour(b)
        arms = solid.vertices - solid.centre_of_gravity
        for sample, dashes in ((0, "--"), (-1, "-")):
            seen = run.place[b, sample, :2] + arms @ turns[b, sample, :2].T
            outline = seen[ConvexHull(seen).vertices]
            closed = np.concatenate([outline, outline[:1]])
            if sample:
                axis.fill(*outline.T, color=colour, alpha=0.3, linewidth=0.0, zorder=2)
            axis.plot(*closed.T, dashes, color=colour, linewidth=1.4, zorder=3)
        way = run.place[b, :, :2].T
        axis.plot(*way, color=INK, linewidth=2.4, zorder=4)
        axis.plot(*way, linestyle=_dashes(b), color=colour, linewidth=1.4, zorder=4, label=drawable(name))
        axis.plot(*run.place[b, -1, :2], "o", color=colour, markersize=6.0, markeredgecolor=INK, zorder=5)
    for still in still_of(run):
        for line in still.lines:
            axis.plot(*line[:, :2].T, color=STILL_LOOKS[still.role].colour, linewidth=0.8, zorder=1)
    for plane in run.planes[1:]:
        nx, ny, offset = (float(plane[name]) for name in ("nx", "ny", "offset"))
        if abs(nx) + abs(ny) > 0.5:
            x, y = offset * nx, offset * ny
            axis.axline((x, y), (x + ny, y + nx), color=ROOM, linewidth=4.0, zorder=1)
    axis.set_aspect("equal", adjustable="datalim")
    label_axes(axis, language, "space.axis_x", "space.axis_y")
    axis.set_title(say("space.plan", language), fontsize=FONT - 0.5, color=MUTED, loc="left")
