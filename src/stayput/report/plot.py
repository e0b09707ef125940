"""Plots of a run and of a motion: one history on axes, or all in a figure.

The figures are made without pyplot, so that they work in threads and without a screen.
"""

from __future__ import annotations

import math
from itertools import islice
from typing import TYPE_CHECKING, Any, get_args

import numpy as np
from matplotlib.patches import Patch

from stayput.catalogue import say
from stayput.catalogue.names import EVENTS, MODES
from stayput.errors import word_of
from stayput.model.state import State, standing_corners, wall_faces
from stayput.motion.measures import DisplacementPeak
from stayput.motion.record import MotionHistory
from stayput.report.figures import (
    FONT,
    LINE,
    colour_beside,
    label_axes,
    legend_within,
    new_figure,
    saved,
    style,
)
from stayput.report.fonts import drawable
from stayput.report.history import history
from stayput.report.names import acceleration_label, motion_label
from stayput.report.palette import ALARM, COMPONENT_COLOURS, EVENT_MARKERS, INK, MODE_COLOURS, MUTED
from stayput.simulation.outcome import EventKind, Mode
from stayput.simulation.run import RunHistory

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.run import Run

_AFTER = 1.2  # the time axis goes on after overturning by this factor
BAND = 0.25
"""Opacity of the modes' bands behind a history."""

_TILT_SHOWN = 3.0  # the tilt axis ends here, in critical angles; a fall beyond it is marked, not followed


def plot_run(run: Run, path: str | Path | None = None, *, title: str = "", language: str = "en") -> Figure:
    """Plot the floor's acceleration, the tilt and the slide, with the modes as bands and the events marked.

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
    figure = new_figure(9.5, 7.2, title)
    axes = figure.subplots(4, 1, sharex=True, height_ratios=[1.0, 1.6, 1.0, 0.16])
    acceleration, tilt, slide, strip = axes
    _draw_acceleration(acceleration, run, language)
    name = drawable(motion_label(run.motion, language))
    acceleration.set_title(name, fontsize=FONT - 0.5, color=MUTED, loc="left")
    _draw_tilt(tilt, run, language)
    _draw_slide(slide, run, language)
    _draw_modes(strip, _draw_bands((tilt, slide), run), language)
    strip.set_xlim(0.0, _last_time(run))
    label_axes(strip, language, x="report.axis_time")
    figure.align_ylabels(axes[:3])
    return saved(figure, path)


def draw_run(axis: Axes, run: Run, what: RunHistory, language: str, **line: Any) -> None:
    """Draw one history of a run on axes, with the modes as bands behind a tilt or a slide.

    On axes that have a run already only the line is drawn.

    Parameters
    ----------
    axis : Axes
        Where to draw.
    run : Run
        The run.
    what : str
        "tilt", "slide" or "acceleration".
    language : str
        "en" or "ja".
    **line
        How the line looks, as for ``Axes.plot``.

    Raises
    ------
    InputError
        Another history.
    """
    word_of("plots.what", what, get_args(RunHistory), "what")
    further = any(one.get_gid() == LINE for one in axis.lines)
    if further:
        looks: dict[str, Any] = {"linewidth": 1.3, "gid": LINE, "color": colour_beside(axis, INK)} | line
        drawn, legend = axis.plot(*_values(run, what), **looks), axis.get_legend()
        handles: list[Any] = [] if legend is None else [*legend.legend_handles]
        handles += drawn if "label" in line else []
    else:
        draw = {"acceleration": _draw_acceleration, "tilt": _draw_tilt, "slide": _draw_slide}[what]
        draw(axis, run, language)
        axis.lines[1].set(**({"gid": LINE} | line))  # the one before it is at zero
        bands = _draw_bands((axis,), run) if what != "acceleration" else ()
        present = [mode for mode in bands if mode not in (Mode.REST, Mode.OVERTURNED)]  # which have no band
        handles = [*axis.get_legend_handles_labels()[0], *_mode_handles(present, language, alpha=BAND)]
    if handles:
        # as small as it can be read, since it lies within the axes
        axis.legend(
            handles=handles, loc="best", fontsize=FONT - 2.5, framealpha=0.7, ncols=1 + len(handles) // 5
        )
    axis.set_xlim(0.0, max(_last_time(run), axis.get_xlim()[1] if further else 0.0))
    label_axes(axis, language, x="report.axis_time")


def _values(run: Run, what: RunHistory) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return times [s] and what is drawn over them: tilt [°], slide [cm] or the acceleration of x [m/s²]."""
    if what == "acceleration":
        return run.motion.time, run.motion.x
    shown = history(run)
    return shown.time, np.degrees(shown.tilt) if what == "tilt" else 100.0 * shown.slide


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
        if what == "displacement" and DisplacementPeak.of(part).drifts:
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
    """Return the end of the time axis [s]: the record's, or some time after the body turned over."""
    duration = run.motion.duration
    return min(duration, _AFTER * run.overturn_time) if run.overturned else duration


def _draw_acceleration(axis: Axes, run: Run, language: str) -> None:
    style(axis)
    motion = run.motion
    for component, a in (("x", motion.x), ("z", motion.z)):
        if a is not None:
            label = say(f"plots.floor_{component}", language)
            axis.plot(motion.time, a, color=COMPONENT_COLOURS[component], linewidth=0.9, label=label)
    axis.set_ylabel(acceleration_label(motion, language), fontsize=FONT)
    legend_within(axis, "upper right")


def _draw_tilt(axis: Axes, run: Run, language: str) -> None:
    style(axis)
    axis.plot(*_values(run, "tilt"), color=INK, linewidth=1.3)
    label_axes(axis, language, y="plots.tilt")
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
    if axis.get_legend_handles_labels()[0]:
        legend_within(axis)


def _tilt_limits(run: Run) -> tuple[float, float]:
    """Return the tilt axis' ends [°]: with the critical angles once they matter, but not all of a fall."""
    low, high = (angle for angle, *_ in islice(_angles(run), 2))  # the critical ones
    tilt = np.degrees(history(run).tilt)
    below, above = float(tilt.min()), float(tilt.max())
    peak = max(-below, above, 0.1)
    if peak < 0.25 * min(-low, high):
        return -1.3 * peak, 1.3 * peak
    return (
        max(_TILT_SHOWN * low, min(1.15 * below, 1.25 * low)),
        min(_TILT_SHOWN * high, max(1.15 * above, 1.25 * high)),
    )


def _draw_slide(axis: Axes, run: Run, language: str) -> None:
    style(axis)
    axis.plot(*_values(run, "slide"), color=INK, linewidth=1.3)
    label_axes(axis, language, y="plots.slide")
    if run.peak_slide < 1e-3:
        axis.set_ylim(-0.1, 0.1)


def _draw_bands(bands: tuple[Axes, ...], run: Run) -> dict[Mode, list[tuple[float, float]]]:
    """Draw the modes as faint bands behind histories; return when and how long the body was in each [s]."""
    spans = history(run).spans()
    found = {mode: [(start, end - start) for start, end, one in spans if one is mode] for mode in Mode}
    present = {mode: widths for mode, widths in found.items() if widths}
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
