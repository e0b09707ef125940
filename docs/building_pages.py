"""Run buildings, and write the figures and tables of the page about them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import validation_run

import stayput as sp
import workload
from stayput.building.building import STRUCTURES, Building
from stayput.motion.response import PERIODS
from stayput.report.building import plot_building
from stayput.report.figures import FONT, label_axes, new_figure, plain_log, saved, style
from stayput.report.palette import ALARM, COMPONENT_COLOURS, INK
from stayput.vocabulary import also_called

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.building.response import FloorResponse

GROUND_FILE, FLOOR_FILE = "market575_1989_ground_gal_dt0.01.csv", "market575_1989_floor42_gal_dt0.01.csv"
TOP, PERIOD = 42, 6.4
"""Storey of the record on the top floor of 575 Market Street, and the building's measured period [s]."""


def structures() -> str:
    """Return the table of defaults by structure."""
    rows = [
        [
            name,
            ", ".join(also_called([name])),
            f"{s.period_per_height:g} H",
            f"{s.damping:g}",
            f"{s.yield_coefficient:g} Rt",
            f"{s.post_yield:g}",
        ]
        for name, s in STRUCTURES.items()
    ]
    values = ["first period [s], H in m", "damping ratio", "yield coefficient", "after yielding"]
    heads = ["structure", "also called", *values]
    return validation_run.markdown(heads, rows, "llrrrr")


def _image(folder: Path, name: str, about: str) -> str:
    return f"```{{image}} {folder.name}/{name}\n:alt: {about}\n```\n"


def profiles(folder: Path) -> str:
    """Draw a building on fixed ground and one on isolators."""
    ground = sp.near_fault()
    plot_building(Building(10, nonlinear=False).respond(ground), folder / "building_rc.png")
    isolated = Building(10, "base-isolated")
    plot_building(isolated.respond(ground), folder / "building_isolated.png", (1, 11))
    return "\n".join(
        (
            _image(folder, "building_rc.png", "Peaks over the storeys and floor spectra of an RC building"),
            _image(folder, "building_isolated.png", "The same of a base-isolated building"),
        )
    )


def yielding() -> str:
    """Return the table of roofs, linear and yielding, over the strength of the ground's motion."""
    ground = sp.near_fault().component("x")
    rows = []
    for factor in (0.1, 0.3, 1.0, 2.0):
        scaled = ground.scaled(factor)
        linear = Building(10, nonlinear=False).respond(scaled).peak_acceleration()[-1]
        response = Building(10).respond(scaled)
        energy = response.energy["x"]
        rows.append(
            [
                f"{scaled.pga:.2f}",
                f"{linear:.2f}",
                f"{response.peak_acceleration()[-1]:.2f}",
                f"{energy.plastic[-1] / energy.input[-1]:.0%}",
                f"{energy.imbalance:.0e}",
            ]
        )
    heads = [
        "ground [m/s²]",
        "roof, linear [m/s²]",
        "roof, yielding [m/s²]",
        "energy into yielding",
        "imbalance",
    ]
    return validation_run.markdown(heads, rows, "rrrrr")


def strongest(motion: sp.Motion, shortest: float, longest: float) -> float:
    """Return the period between two [s] at which a motion's Fourier amplitude is largest."""
    n = len(motion)
    f = np.fft.rfftfreq(16 * n, motion.dt)
    amplitude = np.abs(np.fft.rfft(motion.x * np.hanning(n), 16 * n))
    inside = (f > 1.0 / longest) & (f < 1.0 / shortest)
    return float(1.0 / f[inside][amplitude[inside].argmax()])


def draw_recorded_floor(response: FloorResponse, storey: int, recorded: sp.Motion) -> Figure:
    """Draw a recorded floor beside the computed one: accelerations over time, and spectra."""
    computed = response.floor(storey)
    place, model = response.model.place(storey), response.model
    title = f"{model.name}, T1 = {model.periods[0]:.3g} s: {place}, recorded and computed"
    figure = new_figure(11.0, 5.2, title)
    grid = figure.add_gridspec(3, 2, width_ratios=[1.3, 1.0])
    spectra = figure.add_subplot(grid[:, 1])
    shown = (
        ("ground, recorded", response.motion, INK, "-"),
        (f"{place}, recorded", recorded, COMPONENT_COLOURS["x"], "-"),
        (f"{place}, computed", computed, ALARM, "--"),
    )
    limit = 1.1 * max(motion.pga for _, motion, _, _ in shown)
    axes: list[Axes] = []
    for row, (label, motion, colour, line) in enumerate(shown):
        axis = figure.add_subplot(grid[row, 0], sharex=axes[0] if axes else None)
        axes.append(axis)
        style(axis)
        peaks = f"{label}: {motion.pga:.2f} m/s², {100.0 * motion.pgv:.0f} cm/s"
        axis.plot(motion.time, motion.x, color=colour, linewidth=0.9)
        axis.set_title(peaks, fontsize=FONT - 0.5, color=INK, loc="left")
        axis.set_ylim(-limit, limit)
        axis.tick_params(labelbottom=row == len(shown) - 1)
        spectrum = motion.spectrum()
        spectra.plot(spectrum.periods, spectrum.sa, color=colour, linestyle=line, linewidth=1.6, label=label)
    label_axes(axes[1], "en", y="plots.acceleration")
    label_axes(axes[-1], "en", x="report.axis_time")
    style(spectra, zero=False)
    plain_log(spectra)
    spectra.set_xlim(PERIODS[0], PERIODS[-1])
    label_axes(spectra, "en", x="plots.period")
    spectra.set_ylabel("Sa, 5 % damping [m/s²]", fontsize=FONT)
    spectra.legend(loc="lower left", fontsize=FONT - 1.0, framealpha=0.85)
    return figure


def market_street(folder: Path) -> str:
    """Draw 575 Market Street's top floor beside the model's; say so where the records are absent."""
    files = [workload.RECORD.parent / name for name in (GROUND_FILE, FLOOR_FILE)]
    if not all(file.is_file() for file in files):
        return "The records were not at hand when this page was built, so there is no picture.\n"
    ground, recorded = (sp.read_motion(file, unit="gal") for file in files)
    response = Building(TOP, "steel", PERIOD, nonlinear=False).respond(ground)
    saved(draw_recorded_floor(response, TOP, recorded), folder / "building_market.png")
    computed = response.floor(TOP)
    band = (PERIODS >= 0.1) & (PERIODS <= 8.0)
    ratio = computed.spectrum().sa[band] / recorded.spectrum().sa[band]
    worst = int(np.abs(np.log(ratio)).argmax())
    rule = ground.pga * (1.0 + 2.0 * (TOP - 1) / TOP)
    found = strongest(recorded, 4.0, 10.0), strongest(recorded, 1.4, 3.0)
    text = (
        f"The top floor's peak acceleration was {recorded.pga:.2f} m/s², and {computed.pga:.2f} m/s² is "
        f"computed; its peak velocity {100.0 * recorded.pgv:.0f} and {100.0 * computed.pgv:.0f} cm/s. "
        f"The rule 1 + 2z/h would say {rule:.2f} m/s². The computed floor spectrum is on average "
        f"{np.exp(np.log(ratio).mean()):.2f} times the recorded one between 0.1 and 8 s, and farthest "
        f"from it ({ratio[worst]:.2f} times) at {PERIODS[band][worst]:.1f} s. In the recorded floor the "
        f"first two modes show at {found[0]:.1f} and {found[1]:.1f} s; the model's first natural periods "
        f"are {', '.join(f'{t:.1f}' for t in response.model.periods[:3])} s.\n"
    )
    image = _image(folder, "building_market.png", "Recorded and computed top floor of 575 Market Street")
    return f"{image}\n{text}"


def write(folder: Path) -> None:
    """Write the parts of ``buildings.md`` into a folder."""
    (folder / "buildings_structures.md").write_text(structures(), encoding="utf-8")
    (folder / "buildings_profiles.md").write_text(profiles(folder), encoding="utf-8")
    (folder / "buildings_yielding.md").write_text(yielding(), encoding="utf-8")
    (folder / "buildings_market.md").write_text(market_street(folder), encoding="utf-8")
