"""Histories second by second: the floor, the piece without and with measures, and the devices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import say
from stayput.report.charts.chart import Chart
from stayput.report.figures import FONT, style
from stayput.report.fonts import drawable
from stayput.report.history import history
from stayput.report.names import place_named
from stayput.report.palette import ALARM, COMPONENT_COLOURS, INK, MUTED
from stayput.report.space.histories import slid
from stayput.report.space.scene import body_colour
from stayput.simulation.run import Run

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.measures.results import DeviceResult
    from stayput.motion import Motion
    from stayput.report.charts.chart import ChartSource
    from stayput.simulation.space_run import SpaceRun

MOST_DEVICES = 4
"""Devices whose forces are drawn, those that used most of their strength; the table has all."""

_DASHES = ("-", (0, (5.0, 2.0)), (0, (1.5, 1.5)), (0, (6.0, 1.5, 1.5, 1.5)))


@dataclass(frozen=True, slots=True, eq=False)
class _Line:
    key: str
    name: str
    time: NDArray[np.float64]
    values: NDArray[np.float64]
    colour: str
    dash: object = "-"
    drawn: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class _Panel:
    label: str
    factor: float
    lines: list[_Line]
    most: float = np.inf


def histories_chart(
    runs: Sequence[Run] | Sequence[SpaceRun], names: Sequence[str], said: Sequence[str], source: ChartSource
) -> Chart:
    """Return the histories of a run, or of two: without and with measures.

    Parameters
    ----------
    runs : sequence of Run or SpaceRun
        The runs, under one motion.
    names : sequence of str
        What the pieces in them are called.
    said : sequence of str
        What became of the pieces in each run, in a sentence.
    source : ChartSource
        What it is of.
    """
    motion, language = runs[0].motion, source.language
    flat = [run for run in runs if isinstance(run, Run)]
    panels = [_acceleration(motion, "xz" if flat else "xyz", language)]
    if flat:
        panels += _in_plane(flat, language)
    else:
        panels += _in_space([run for run in runs if not isinstance(run, Run)], names, language)
    forces = _forces(runs[-1], language)
    panels += [forces] if forces.lines else []
    titles = [say(f"figures.{key}", language) for key in ("without", "with")]
    colon = say("common.colon", language)
    several = len(names) > 1
    caption = say("page.space", language).join(
        text if several else f"{title}{colon}{text}" for title, text in zip(titles, said, strict=False)
    )
    columns = {"time_s": motion.time.tolist()} | {
        line.key: np.interp(motion.time, line.time, line.values, right=np.nan).tolist()
        for panel in panels
        for line in panel.lines
    }

    def draw(figure: Figure) -> None:
        end = min(motion.duration, _end(runs))
        axes = np.atleast_1d(figure.subplots(len(panels), 1, sharex=True))
        for axis, panel in zip(axes, panels, strict=True):
            _draw(axis, panel, end)
        axes[-1].set_xlim(0.0, end)
        axes[-1].set_xlabel(say("report.axis_time", language), fontsize=FONT)
        figure.align_ylabels(list(axes))

    title = say("figures.histories", language)
    return Chart(title, caption, source, columns, draw, (8.4, 1.0 + 1.7 * len(panels)))


def _end(runs: Sequence[Run] | Sequence[SpaceRun]) -> float:
    """Return the end of the time axis: that of the longest run [s]."""
    return max(history(run).end if isinstance(run, Run) else float(run.time[-1]) for run in runs)


def _acceleration(motion: Motion, axes: str, language: str) -> _Panel:
    felt = {axis: values for axis, values in motion.components.items() if axis in axes}
    lines = [
        _Line(
            f"floor_{axis}_acceleration_m_s2",
            say(f"plots.component_{axis}", language) if len(felt) > 1 else "",
            motion.time,
            values,
            COMPONENT_COLOURS[axis],
        )
        for axis, values in felt.items()
    ]
    return _Panel(say("report.axis_acceleration", language), 1.0, lines)


def _look(number: int, language: str) -> tuple[str, str, str, object]:
    """Return key, name, colour and dash of a run: the first is without measures, the second with them."""
    key = ("without", "with")[number]
    return key, say(f"figures.{key}", language), (ALARM, COMPONENT_COLOURS["x"])[number], _DASHES[number]


def _in_plane(runs: Sequence[Run], language: str) -> list[_Panel]:
    tilt, slide = list[_Line](), list[_Line]()
    for number, run in enumerate(runs):
        shown = history(run)
        key, name, colour, dash = _look(number, language)
        tilt.append(_Line(f"tilt_{key}_rad", name, shown.time, shown.tilt, colour, dash))
        slide.append(_Line(f"slide_{key}_m", name, shown.time, shown.slide, colour, dash))
    most = 3.0 * float(np.degrees(min(runs[0].body.slenderness)))
    return [
        _Panel(say("report.axis_tilt", language), 180.0 / np.pi, tilt, most),
        _Panel(say("report.axis_slide", language), 100.0, slide),
    ]


def _in_space(runs: Sequence[SpaceRun], names: Sequence[str], language: str) -> list[_Panel]:
    lines: dict[str, list[_Line]] = {"tilt": [], "slide": [], "yaw": []}
    units = {"tilt": "rad", "slide": "m", "yaw": "rad"}
    for number, run in enumerate(runs):
        values = {"tilt": run.tilt, "slide": slid(run), "yaw": run.yaw}
        for body, own in enumerate(names):
            key, name, colour, dash = _look(number, language)
            if len(names) > 1:
                key, name, colour, dash = f"{body + 1}", own, body_colour(body), _DASHES[body % len(_DASHES)]
            for what, histories in values.items():
                column = f"{what}_{key}_{units[what]}"
                lines[what].append(_Line(column, name, run.time, histories[body], colour, dash))
    return [
        _Panel(say("report.axis_tilt", language), 180.0 / np.pi, lines["tilt"]),
        _Panel(say("report.axis_slide", language), 100.0, lines["slide"]),
        _Panel(say("figures.axis_yaw", language), 180.0 / np.pi, lines["yaw"]),
    ]


def _forces(run: Run | SpaceRun, language: str) -> _Panel:
    used = [-np.inf if np.isnan(one.utilisation) else one.utilisation for one in run.devices]
    most = sorted(range(len(used)), key=lambda number: -used[number])[:MOST_DEVICES]
    lines = [
        _Line(
            f"device_{number + 1}_force_n",
            _called(device, language),
            run.time,
            np.hypot(device.pull, device.shear),
            COMPONENT_COLOURS["x"],
            _DASHES[most.index(number)] if number in most else "-",
            number in most,
        )
        for number, device in enumerate(run.devices)
    ]
    return _Panel(say("figures.axis_force", language), 1.0, lines)


def _called(device: DeviceResult, language: str) -> str:
    place = place_named(device.place, language) if device.place else ""
    return " ".join(filter(None, (say(device.label, language), place)))


def _draw(axis: Axes, panel: _Panel, end: float) -> None:
    style(axis)
    low = high = 0.0
    for line in panel.lines:
        if not line.drawn:
            continue
        shown = line.time <= end
        values = panel.factor * line.values[shown]
        low, high = min(low, float(values.min())), max(high, float(values.max()))
        axis.plot(
            line.time[shown],
            values,
            color=line.colour,
            linestyle=line.dash,  # pyright: ignore[reportArgumentType] - dashes are a pair
            linewidth=1.1,
            label=drawable(line.name),
        )
    if max(high, -low) > panel.most:
        axis.set_ylim(max(-panel.most, 1.05 * low), min(panel.most, 1.05 * high))
        value = high if high > panel.most else low
        axis.annotate(
            f"{value:.0f}", (1.0, 1.02), xycoords="axes fraction", ha="right", fontsize=FONT - 1.5, color=INK
        )
    axis.set_ylabel(drawable(panel.label), fontsize=FONT - 1.0, color=INK)
    if any(line.name for line in panel.lines) and len(panel.lines) > 1:
        axis.legend(loc="upper right", fontsize=FONT - 2.0, framealpha=0.85, labelcolor=MUTED)
