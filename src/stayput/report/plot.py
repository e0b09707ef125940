"""Plots of a run and of a motion: one history on axes, or all in a figure.

The figures are made without pyplot, so that they work in threads and without a screen.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from stayput.catalogue import say
from stayput.catalogue.names import EVENTS, MODES, OUTCOMES
from stayput.errors import word_of
from stayput.model.state import State, standing_corners, wall_faces
from stayput.motion.record import Motion, MotionHistory
from stayput.report.figures import (
    FONT,
    LINE,
    colour_beside,
    drawable,
    grey_after_fall,
    label_axes,
    legend_within,
    new_figure,
    saved,
    style,
    with_face,
    wrapped,
)
from stayput.report.film.shape import OPENINGS, STILL_LOOKS, still_of
from stayput.report.history import spans, with_overturning
from stayput.report.names import acceleration_label, motion_label, names_of
from stayput.report.palette import (
    ALARM,
    COMPONENT_COLOURS,
    EVENT_MARKERS,
    INK,
    LINE_COLOURS,
    MODE_COLOURS,
    MUTED,
    ROOM,
)
from stayput.simulation.outcome import EventKind, Mode
from stayput.simulation.run import Run, RunHistory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_AFTER = 1.2  # the time axis goes on after overturning by this factor
BAND = 0.25
"""Opacity of the modes' bands behind a history."""

_OVERTURNED, _FELL_OFF = "X", "v"
"""Marks of when a piece overturned and fell off."""

_SMALLEST = 0.1
"""Half the range of an axis on which nothing happens [° or cm]."""

_TILT_SHOWN = 3.0  # the tilt axis ends here, in critical angles; a fall beyond it is marked, not followed


def plot_run(run: Run, path: str | Path | None = None, *, title: str = "", language: str = "en") -> Figure:
    """Plot the floor's acceleration, the tilts and the slides of the pieces over time.

    In the plane with the modes as bands and the events marked; in space with the ways of the pieces in plan.

    Parameters
    ----------
    run : Run
        The run.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
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
        A path that cannot be written.
    """
    in_plan, several = run.engine == "space", len(run.pieces) > 1
    width = 12.0 if in_plan else 9.5
    figure = new_figure(width, 7.2)
    if title:
        text, face = with_face(title, FONT + 2.0)
        lines = wrapped(text, face, 0.96 * 72.0 * width).replace("$", r"\$")
        figure.suptitle(lines, fontsize=FONT + 2.0, color=INK)
    heights = [1.0, 1.6, 1.0, *([] if in_plan else [0.16])]
    widths = [1.35, 1.0] if in_plan else [1.0]
    grid = figure.add_gridspec(len(heights), len(widths), width_ratios=widths, height_ratios=heights)
    first = figure.add_subplot(grid[0, 0])
    axes = [first, *(figure.add_subplot(grid[row, 0], sharex=first) for row in range(1, len(heights)))]
    acceleration, tilt, slide = axes[:3]
    _draw_acceleration(acceleration, run, language)
    motion, face = with_face(motion_label(run.motion, language), FONT - 0.5)
    beside = 72.0 * (0.85 * width * widths[0] / sum(widths) - 2.5)  # the legend
    title = wrapped(motion, face, beside).replace("$", r"\$")
    acceleration.set_title(title, fontsize=FONT - 0.5, color=MUTED, loc="left")
    _draw_pieces(tilt, run, "tilt", language)
    if not several and tilt.get_legend_handles_labels()[0]:
        legend_within(tilt)
    _draw_pieces(slide, run, "slide", language)
    if in_plan:
        plan = figure.add_subplot(grid[:, 1])
        _draw_plan(plan, run, language)
        if several:
            _draw_names_below(figure, run, width, language)
        else:
            legend_within(plan)
    else:
        _draw_modes(axes[3], _draw_bands((tilt, slide), run), language)
    for axis in axes[:-1]:
        axis.tick_params(labelbottom=False)
    first.set_xlim(float(run.time[0]), _last_time(run))
    label_axes(axes[-1], language, x="report.axis_time")
    figure.align_ylabels(axes[:3])
    return saved(figure, path)


def draw_run(axis: Axes, run: Run, what: RunHistory, language: str, **line: Any) -> None:
    """Draw one history of a run on axes, with the modes as bands behind a tilt or a slide in the plane.

    On axes that have a run already only the lines are drawn.

    Parameters
    ----------
    axis : Axes
        Where to draw.
    run : Run
        The run.
    what : str
        "tilt", "slide", "yaw", "plan" or "acceleration".
    language : str
        "en" or "ja".
    **line
        How the line of a single piece looks, as for ``Axes.plot``.

    Raises
    ------
    InputError
        Something else to draw; the turn in plan and the ways in plan are of runs in space.
    """
    in_plane = ("tilt", "slide", "acceleration")
    word_of("plots.what", what, in_plane if run.engine == "plane" else get_args(RunHistory), "what")
    if what == "plan":
        _draw_plan(axis, run, language)
        axis.legend(handles=_piece_handles(run, language), fontsize=FONT - 1.0, framealpha=0.85)
        return
    further = any(artist.get_gid() == LINE for artist in axis.lines)
    several, alone = len(run.pieces) > 1 and what != "acceleration", {"gid": LINE, **line}
    if further:
        legend = axis.get_legend()
        handles: list[Any] = [] if legend is None else [*legend.legend_handles]
        looks: dict[str, Any] = {"linewidth": 1.3, "color": colour_beside(axis, INK)} | alone
        for times, values in _histories(run, what):
            drawn = axis.plot(times, values, **looks)
            handles += drawn if "label" in line else []
    else:
        if what == "acceleration":
            _draw_acceleration(axis, run, language)
        else:
            _draw_pieces(axis, run, what, language)
        axis.lines[1].set(**alone)  # the one before it is at zero
        bands = _draw_bands((axis,), run) if run.engine == "plane" and what != "acceleration" else ()
        present = [mode for mode in bands if mode not in (Mode.REST, Mode.OVERTURNED)]  # which have no band
        shown = _piece_handles(run, language) if several else axis.get_legend_handles_labels()[0]
        handles = [*shown, *_mode_handles(present, language, alpha=BAND)]
    if handles:
        # as small as it can be read, since it lies within the axes
        axis.legend(
            handles=handles, loc="best", fontsize=FONT - 2.5, framealpha=0.7, ncols=1 + len(handles) // 5
        )
    axis.set_xlim(0.0, max(_last_time(run), axis.get_xlim()[1] if further else 0.0))
    label_axes(axis, language, x="report.axis_time")


def _histories(run: Run, what: RunHistory) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Return times [s] and values of each piece: tilt [°], slide [cm], yaw [°]; or acceleration [m/s²]."""
    if what == "acceleration":
        return [(run.motion.time, run.motion.x)]
    scale, shown = 100.0 if what == "slide" else math.degrees(1.0), with_overturning(run)
    return [(shown.time, scale * getattr(piece, what)) for piece in shown.pieces]


def plot_motion(
    motion: Motion, path: str | Path | None = None, *, title: str = "", language: str = "en"
) -> Figure:
    """Plot acceleration, velocity and displacement of every component of a motion.

    Velocity and displacement are integrals of the record as it is, without any correction.

    Parameters
    ----------
    motion : Motion
        The motion.
    path : str or Path, optional
        Where to save it: PNG, SVG or PDF, by its ending.
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
        A path that cannot be written.
    """
    parts = motion.components
    figure = new_figure(4.0 + 3.6 * len(parts), 6.6, title)
    histories: tuple[MotionHistory, ...] = get_args(MotionHistory)
    axes = figure.subplots(len(histories), len(parts), sharex=True, sharey="row", squeeze=False)
    for column, component in zip(axes.T, parts, strict=True):
        for axis, what in zip(column, histories, strict=True):
            draw_motion(axis, motion, what, component, language)
            axis.label_outer()
        column[0].set_title(say(f"plots.component_{component}", language), fontsize=FONT, color=INK)
    figure.align_ylabels(axes[:, 0])
    return saved(figure, path)


def draw_motion(
    axis: Axes, motion: Motion, what: MotionHistory, component: str, language: str, **line: Any
) -> None:
    """Draw one history of one component on axes, with its peak marked.

    Parameters
    ----------
    axis : Axes
        Where to draw.
    motion : Motion
        The motion.
    what : str
        "acceleration", "velocity" or "displacement".
    component : str
        "x", "y" or "z".
    language : str
        "en" or "ja".
    **line
        How the line looks, as for ``Axes.plot``. With a label there is no mark of the peak.

    Raises
    ------
    InputError
        Another history, or a component that is not there.
    """
    part = motion.component(component)
    word_of("plots.what", what, get_args(MotionHistory), "what")
    match what:
        case "acceleration":
            values, peak, unit = part.x, part.pga, "m/s²"
        case "velocity":
            values, peak, unit = 100.0 * part.velocity, 100.0 * part.pgv, "cm/s"
        case "displacement":
            values, peak, unit = 100.0 * part.displacement, 100.0 * part.pgd, "cm"
    style(axis)
    looks: dict[str, Any] = {"linewidth": 0.9, "gid": LINE} | line
    looks.setdefault("color", colour_beside(axis, COMPONENT_COLOURS[component]))
    axis.plot(part.time, values, **looks)
    if "label" not in line:
        place = int(np.argmax(np.abs(values)))
        if what == "displacement" and part.peaks()["x"].displacement_drifts:
            label = say("plots.drifts", language)
        else:  # the peaks themselves lie between the samples
            label = f"{math.copysign(peak, values[place]):.3g} {unit}"
        axis.plot(part.time[place], values[place], "o", color=INK, markersize=4.0, label=label)
    axis.legend(loc="upper right", fontsize=FONT - 1.5, framealpha=0.85, handletextpad=0.2)
    label_axes(axis, language, "report.axis_time", f"plots.{what}")


def _angles(run: Run) -> Iterator[tuple[float, str, str, str]]:
    """Yield angles to mark [°] with line, colour and text: of falling by itself, and of reaching a wall."""
    left, right = run.body.slenderness
    for critical in (-left - run.body.resting_tilt, right - run.body.resting_tilt):
        yield math.degrees(critical), "--", MUTED, "plots.critical"
    a, b, c, d = standing_corners(run.body, State())
    for foot, top, face in zip((a, b), (c, d), wall_faces(run.body, run.room), strict=True):
        across, up = top[0] - foot[0], top[1] - foot[1]
        sine = (face - foot[0]) / math.hypot(across, up)
        if abs(sine) < 1.0:  # else the top corner stays before the wall, at slide 0
            colour = EVENT_MARKERS[EventKind.WALL_IMPACT][1]
            yield math.degrees(math.asin(sine) - math.atan2(across, up)), ":", colour, "plots.wall_reached"


def _last_time(run: Run) -> float:
    """Return the end of the time axis [s]: the run's, or where it ends with a fall a little after that."""
    last = float(run.time[-1])
    return last if run.end <= last else min(run.motion.duration, _AFTER * run.end)


def _draw_acceleration(axis: Axes, run: Run, language: str) -> None:
    style(axis)
    motion, parts = run.motion, run.motion.components
    for name, a in parts.items():
        if name != "y" or run.engine == "space":
            label = say("space.floor_z", language) if name == "z" else name
            axis.plot(motion.time, a, color=COMPONENT_COLOURS[name], linewidth=0.9, label=label)
    axis.set_ylabel(acceleration_label(motion, language), fontsize=FONT)
    axis.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), fontsize=FONT - 1.5, frameon=False, ncols=3)


def _draw_pieces(axis: Axes, run: Run, what: RunHistory, language: str) -> None:
    """Draw one history of each piece over time, and when it overturned and fell off."""
    style(axis)
    histories, most = _histories(run, what), 0.0
    for b, (piece, (times, values)) in enumerate(zip(run.pieces, histories, strict=True)):
        axis.plot(times, values, linestyle=_dashes(b), color=_colour(run, b), linewidth=1.3)
        grey_after_fall(axis, piece, times, times, values)
        most = max(most, float(np.abs(values).max()))
        for time, text, marker in (
            (piece.overturn_time, "plots.overturned", _OVERTURNED),
            (piece.fall_time, "plots.fell_off", _FELL_OFF),
        ):
            if run.engine == "space" and math.isfinite(time):
                looks: dict[str, Any] = {"color": _colour(run, b), "label": say(text, language, time=time)}
                looks |= {"markersize": 8.0, "markeredgecolor": INK, "markeredgewidth": 0.8}
                axis.plot(time, float(np.interp(time, times, values)), marker, zorder=5, **looks)
    signed = run.engine == "plane" and what != "yaw"
    label_axes(axis, language, y=f"plots.{what}" if signed else f"space.axis_{what}")
    if most < _SMALLEST:
        axis.set_ylim(-_SMALLEST, _SMALLEST)
    if signed and what == "tilt":
        _mark_tilt(axis, run, language)


def _mark_tilt(axis: Axes, run: Run, language: str) -> None:
    """Mark the critical angles and the events on the tilt of a run in the plane."""
    low, high = _tilt_limits(run)
    axis.set_ylim(low, high)
    for angle, dashes, colour, text in _angles(run):
        if low < angle < high:
            label = say(text, language, angle=abs(angle))
            once = "" if label in axis.get_legend_handles_labels()[1] else label
            axis.axhline(angle, linewidth=1.1, color=colour, linestyle=dashes, label=once)
    for kind, (marker, colour) in EVENT_MARKERS.items():
        events = [event for event in run.events if event.kind is kind]
        if not events:
            continue
        name = kind.value if language == "en" else say(EVENTS[kind.value], language)
        label = f"{name} × {len(events)}" if len(events) > 1 else name
        if kind is EventKind.OVERTURNED:
            label = say("plots.overturned", language, time=run.overturn_time)
        marks: dict[str, Any] = {"color": colour, "label": label, "clip_on": False, "zorder": 5}
        marks |= {"markersize": 6.0, "markeredgecolor": "white", "markeredgewidth": 0.6}
        tilts = np.clip([math.degrees(event.tilt) for event in events], low, high)
        axis.plot([event.time for event in events], tilts, marker, **marks)


def _tilt_limits(run: Run) -> tuple[float, float]:
    """Return the tilt axis' ends [°]: with the critical angles once they matter, but not all of a fall."""
    low, high = (angle for angle, *_ in islice(_angles(run), 2))  # the critical ones
    tilt = np.degrees(with_overturning(run).tilt)
    below, above = float(tilt.min()), float(tilt.max())
    peak = max(-below, above, 0.1)
    if peak < 0.25 * min(-low, high):
        return -1.3 * peak, 1.3 * peak
    return (
        max(_TILT_SHOWN * low, min(1.15 * below, 1.25 * low)),
        min(_TILT_SHOWN * high, max(1.15 * above, 1.25 * high)),
    )


def _draw_bands(bands: tuple[Axes, ...], run: Run) -> dict[Mode, list[tuple[float, float]]]:
    """Draw the modes as faint bands behind histories; return when and how long the body was in each [s]."""
    parts = spans(with_overturning(run))
    bars = {mode: [(start, end - start) for start, end, m in parts if m is mode] for mode in Mode}
    present = {mode: widths for mode, widths in bars.items() if widths}
    for axis in bands:
        for mode, widths in present.items():
            if mode is not Mode.REST:
                looks: dict[str, Any] = {"facecolors": MODE_COLOURS[mode], "alpha": BAND, "linewidth": 0.0}
                axis.broken_barh(widths, (0.0, 1.0), transform=axis.get_xaxis_transform(), zorder=0, **looks)
        if run.overturned:
            axis.axvline(run.overturn_time, color=ALARM, linewidth=1.0)
    return present


def _mode_handles(modes: Iterable[Mode], language: str, alpha: float = 1.0) -> list[Patch]:
    return [
        Patch(facecolor=MODE_COLOURS[mode], alpha=alpha, label=say(MODES[mode], language)) for mode in modes
    ]


def _draw_modes(strip: Axes, present: dict[Mode, list[tuple[float, float]]], language: str) -> None:
    """Draw as a strip when and how long the body was in each mode [s], with a legend."""
    for mode, widths in present.items():
        strip.broken_barh(widths, (0.0, 1.0), facecolors=MODE_COLOURS[mode], linewidth=0.0)
    strip.set_yticks([])
    strip.set_ylim(0.0, 1.0)
    strip.set_ylabel(say("plots.mode", language), fontsize=FONT, rotation=0, ha="right", va="center")
    strip.tick_params(labelsize=FONT - 1.0, colors=INK)
    below: dict[str, Any] = {"loc": "upper center", "bbox_to_anchor": (0.5, -2.6), "ncols": len(present)}
    strip.legend(handles=_mode_handles(present, language), fontsize=FONT - 1.0, frameon=False, **below)


def _colour(run: Run, piece: int) -> str:
    """Return the colour of a piece; one alone in the plane has that of ink."""
    return INK if run.engine == "plane" else LINE_COLOURS[piece % len(LINE_COLOURS)]


def _dashes(body: int) -> Any:
    """Return the line style of a body, which tells apart bodies of one colour."""
    return ("-", "--", ":")[body // len(LINE_COLOURS) % 3]


def _piece_handles(run: Run, language: str) -> list[Line2D]:
    """Return the legend of several pieces: their names, and what the marks on their lines mean."""
    shown = [
        Line2D([], [], color=_colour(run, b), linestyle=_dashes(b), linewidth=2.0, label=drawable(name))
        for b, name in enumerate(names_of(run, language))
    ]
    for happened, outcome, marker in (
        (any(piece.overturned for piece in run.pieces), "overturned", _OVERTURNED),
        (any(piece.fell_off for piece in run.pieces), "fell off", _FELL_OFF),
    ):
        if happened:
            looks: dict[str, Any] = {"markersize": 8.0, "markeredgecolor": INK, "color": "none"}
            shown.append(Line2D([], [], marker=marker, label=say(OUTCOMES[outcome], language), **looks))
    return shown


def _draw_names_below(figure: Figure, run: Run, width: float, language: str) -> None:
    """Explain the lines of several pieces below a figure of a width [inches]."""
    shown, size = _piece_handles(run, language), FONT - 0.5
    labels = [str(line.get_label()) for line in shown]
    widest = max(with_face(label, size)[1].getlength(label) for label in labels)
    columns = int(72.0 * width // (widest + 5.5 * size))  # with the line and the space around it
    place: dict[str, Any] = {"loc": "outside lower center", "ncols": max(1, min(5, columns, len(shown)))}
    figure.legend(handles=shown, fontsize=size, frameon=False, **place)


def _draw_plan(axis: Axes, run: Run, language: str) -> None:
    """Draw the ways of the bodies from above, with their outlines at first and at the end, and the walls."""
    style(axis, zero=False)
    turns = run.turn
    for b, name in enumerate(names_of(run, language)):
        solid, colour = run.standing[b].solid, _colour(run, b)
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
        grey_after_fall(axis, run.pieces[b], run.time, *way)
        axis.plot(*run.place[b, -1, :2], "o", color=colour, markersize=6.0, markeredgecolor=INK, zorder=5)
    for still in still_of(run):
        look, of_wall = STILL_LOOKS[still.role].colour, still.role in OPENINGS
        for line in still.lines:
            in_wall = of_wall and np.ptp(line[:, 2]) > 0.0
            axis.plot(*line[:, :2].T, color=look, linewidth=2.5 if in_wall else 0.8, zorder=1.5)
    if run.plan is None:
        _draw_walls(axis, run)
        axis.set_aspect("equal", adjustable="datalim")
        label_axes(axis, language, "space.axis_x", "space.axis_y")
    else:
        width, length = run.plan.width, run.plan.length
        axis.add_patch(Rectangle((0.0, 0.0), width, length, fill=False, color=ROOM, linewidth=4.0))
        axis.set_aspect("equal", adjustable="box")
        label_axes(axis, language, "space.axis_x_room", "space.axis_y_room")
    axis.set_title(say("space.plan", language), fontsize=FONT - 0.5, color=MUTED, loc="left")


def _draw_walls(axis: Axes, run: Run) -> None:
    """Draw the walls of a run without a plan, which have no ends."""
    for plane in run.planes[1:]:
        nx, ny, offset = (float(plane[name]) for name in ("nx", "ny", "offset"))
        if abs(nx) + abs(ny) > 0.5:
            x, y = offset * nx, offset * ny
            axis.axline((x, y), (x + ny, y + nx), color=ROOM, linewidth=4.0, zorder=1)
