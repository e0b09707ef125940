"""What notebooks show of a value: a picture, a sentence, and its key numbers, as HTML."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from markupsafe import escape

from stayput.catalogue import say
from stayput.errors import InputError
from stayput.model.room import Room
from stayput.montecarlo.counting import DEVICE_FAILED, EVENTS
from stayput.report.building import draw_modes
from stayput.report.figures import embedded, figure_of
from stayput.report.fragility import draw_curve, draw_ranking
from stayput.report.names import motion_label
from stayput.report.page import rendered
from stayput.report.plot import plot_motion, plot_run
from stayput.report.section import draw_body_in_room
from stayput.report.spectra import draw_spectrum, draw_suite, suite_title
from stayput.report.summary import rows, sentence
from stayput.report.verdict.numbers import NO_NUMBER, length, word

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from stayput.building.building import Building
    from stayput.fragility.curve import FragilityCurve
    from stayput.model.body import Body
    from stayput.motion.record import Motion
    from stayput.motion.response import ResponseSpectrum
    from stayput.motion.suites.suite import Suite
    from stayput.simulation.run import Run
    from stayput.verification import Verdict

MOST_ROWS = 10
"""Motions of a suite that are listed."""


def run_html(run: Run) -> str:
    """Return a run as its sentence, histories and results."""
    return _shown(sentence(run), plot_run(run), rows(run))


def verdict_html(verdict: Verdict) -> str:
    """Return a verdict as its sentence, the chances of its options, and their ranking."""
    figure = figure_of(lambda axis: draw_ranking(axis, verdict, "en"), 8.4, 1.2 + 0.42 * len(verdict.options))
    events = [event for event in EVENTS if event in verdict.best.probabilities]
    limit = length(verdict.slide_limit, "en")
    heads = [word(key, "en", limit=limit) for key in ("rank", "measure", *events, "why")]
    table = [
        (
            str(option.rank),
            verdict.label(option),
            *(
                option.probabilities[event].text if event != DEVICE_FAILED or option.devices else NO_NUMBER
                for event in events
            ),
            verdict.reason(option),
        )
        for option in verdict.options
    ]
    return _shown(verdict.sentence(), figure, table, heads)


def curve_html(curve: FragilityCurve) -> str:
    """Return a fragility curve as its sentence and picture, and the intensities at which shares fall."""
    table = [
        (say("notebook.capacity", percent=100.0 * share), curve.capacity(share).text)
        for share in (0.1, 0.5, 0.9)
    ]
    if curve.lognormal is not None:
        table.append((say("fragility.lognormal"), say(curve.lognormal_texts)))
    return _shown(curve.text, figure_of(lambda axis: draw_curve(axis, curve, "en"), 7.0, 4.4), table)


def motion_html(motion: Motion) -> str:
    """Return a motion as its histories and the measures of its components."""
    peaks = motion.peaks()
    heads = ["", *peaks]
    intensity = _intensity(motion)
    table: list[Sequence[str]] = [
        (say("cli.pga"), *(f"{peak.pga:.3g}" for peak in peaks.values())),
        (say("cli.pgv"), *(f"{100.0 * peak.pgv:.3g}" for peak in peaks.values())),
        (say("notebook.duration"), f"{motion.duration:.4g}"),
        (say("notebook.step"), f"{motion.dt:g}"),
    ]
    if intensity:
        label = "fragility.floor_jma" if motion.floor else "notebook.intensity"
        table.append((say(label), intensity))
    return _shown(motion_label(motion), plot_motion(motion), table, heads)


def spectrum_html(spectrum: ResponseSpectrum) -> str:
    """Return a response spectrum as the picture of its Sa."""
    figure = figure_of(lambda axis: draw_spectrum(axis, spectrum, "sa", "en"), 6.4, 4.2)
    return _shown(repr(spectrum), figure, ())


def suite_html(suite: Suite) -> str:
    """Return a suite as its spectra and a list of its first motions."""
    figure = figure_of(lambda axis: draw_suite(axis, suite, "spectra", None, "x", "en"), 6.8, 4.6)
    heads = ("notebook.name", "cli.pga", "cli.pgv", "notebook.intensity", "notebook.duration")
    table = [
        (
            motion.name,
            f"{motion.pga:.3g}",
            f"{100.0 * motion.pgv:.3g}",
            _intensity(motion) or NO_NUMBER,
            f"{motion.duration:.4g}",
        )
        for motion in suite[:MOST_ROWS]
    ]
    if len(suite) > MOST_ROWS:
        table.append((say("inventory_tables.more_doubts", count=len(suite) - MOST_ROWS), "", "", "", ""))
    return _shown(suite_title(suite, "en"), figure, table, list(map(say, heads)))


def building_html(building: Building) -> str:
    """Return a building as its mode shapes and what is known or assumed of it."""
    model = building.model
    figure = figure_of(lambda axis: draw_modes(axis, model, 3, "en"), 5.2, 4.6)
    periods = ", ".join(f"{period:.3g}" for period in model.periods[:3])
    table = [
        (say("notebook.structure"), building.structure),
        (say("notebook.storeys"), str(building.storeys)),
        (say("notebook.height"), f"{building.height:.3g}"),
        (say("notebook.periods"), periods),
    ]
    return _shown(building.name, figure, table)


def body_html(body: Body) -> str:
    """Return a body as a drawing and the quantities of the rocking literature about its base corners."""
    figure = figure_of(lambda axis: draw_body_in_room(axis, body, Room(), "en"), 5.6, 4.6)
    table: list[Sequence[str]] = [
        ("R [m]", *(f"{value:.4g}" for value in body.size)),
        ("α [rad]", *(f"{value:.4g}" for value in body.slenderness)),
        ("p [rad/s]", *(f"{value:.4g}" for value in body.frequency_parameter())),
        ("g tan α [m/s²]", *(f"{value:.4g}" for value in body.overturning_acceleration())),
    ]
    return _shown(repr(body), figure, table, ["", "A", "B"])


def room_html(room: Room) -> str:
    """Return a room as a drawing with a piece of usual size in it."""
    figure = figure_of(lambda axis: draw_body_in_room(axis, None, room, "en"), 5.6, 4.6)
    table = [(say("notebook.friction"), f"{room.floor.static_friction:g}, {room.floor.kinetic_friction:g}")]
    return _shown(repr(room), figure, table)


def _intensity(motion: Motion) -> str:
    """Return the intensity of a motion; nothing for a still one, or one too short to have an intensity."""
    try:
        intensity = motion.intensity
    except InputError:
        return ""
    return f"{intensity:.2f}" if math.isfinite(intensity) else ""


def _shown(said: str, figure: Figure, table: Iterable[Sequence[str]], heads: Sequence[str] = ()) -> str:
    """Return a sentence, a picture and a table as HTML that needs nothing else."""
    head, *body = [[escape(cell) for cell in row] for row in (heads, *table)]
    content = {"said": escape(said), "picture": embedded(figure, "png"), "heads": head, "table": body}
    return rendered("notebook.html", content)
