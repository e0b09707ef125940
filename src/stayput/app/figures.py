"""Charts of the page that a reader keeps: what the page shows, drawn anew with caption and inputs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy as np

from stayput.app.refusals import refused
from stayput.app.running import ground_and_floor, own_measures, run_of
from stayput.app.space_running import name_in, pieces_run, space_run_of
from stayput.catalogue import say
from stayput.fragility import JMA_INTENSITY
from stayput.report.charts.chances import ranking_chart, tens_chart
from stayput.report.charts.chart import ChartSource
from stayput.report.charts.histories import histories_chart
from stayput.report.charts.over_intensity import MappedSizes, fragility_chart, sizes_chart
from stayput.report.charts.rooms import changes_chart, hits_chart, plan_chart
from stayput.report.names import motion_label
from stayput.report.space.said import became, piece_became
from stayput.report.summary import piece_sentences
from stayput.report.verdict.assumptions import (
    floor_assumption,
    furniture_assumption,
    room_assumptions,
    shaking_assumptions,
)
from stayput.rooms.verdict import RoomVerdict
from stayput.rooms.words import names_in
from stayput.scenario import AssemblyScenario, Scenario
from stayput.scenario.room import RoomScenario
from stayput.verification.options import YOURS

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.app.jobs import AnyVerdict
    from stayput.app.run_replies import SizeMapReply
    from stayput.catalogue import Language
    from stayput.report.charts.chart import Chart
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

FigureName = Literal["tens", "ranking", "fragility", "room_plan", "room_hits", "room_changes"]
"""Charts of a verdict: on one piece, and on a room."""

ROOM_CHARTS = {"room_plan": plan_chart, "room_hits": hits_chart, "room_changes": changes_chart}
"""Those on a room."""

FigureKind = Literal["svg", "pdf", "csv"]


def run_figure(
    scenario: Scenario | AssemblyScenario, language: Language, named: Callable[[str], str]
) -> Chart:
    """Return the histories of a scene, run without and with the user's measures.

    Parameters
    ----------
    scenario : Scenario or AssemblyScenario
        The scene.
    language : str
        "en" or "ja".
    named : callable
        Puts the users' names for their files into a text.
    """
    place = ("en", "ja").index(language)
    ground, motion = ground_and_floor(scenario)
    shaken = say("figures.shaken", language, name=motion_label(ground, language), peak=motion.pga)
    source = _source(scenario, language, named, motion=named(shaken))
    if isinstance(scenario, AssemblyScenario):
        run = pieces_run(scenario)
        called = names_in(scenario, language)
        return histories_chart([run], called, [became(run, called)[place]], source)
    measures, piece = own_measures(scenario), scenario.furniture
    in_place = [(), measures] if measures else [()]
    names = [name_in(scenario, language)]
    if scenario.dimensions == 3:
        solid = [space_run_of(scenario, motion, held) for held in in_place]
        told = [piece_became(run, piece.preset, piece.name)[place] for run in solid]
        return histories_chart(solid, names, told, source)
    flat = [run_of(scenario, motion, held) for held in in_place]
    said = [piece_sentences(run, piece.preset, piece.name)[place] for run in flat]
    return histories_chart(flat, names, said, source)


def map_figure(
    scenario: Scenario, reply: SizeMapReply, language: Language, named: Callable[[str], str]
) -> Chart:
    """Return the map of sizes of a scene; see `run_figure`."""
    sizes = MappedSizes(
        reply.axis,
        np.array(reply.intensity),
        np.array(reply.width_m),
        np.array(reply.height_m),
        np.array(reply.overturned, dtype=np.float64),
        reply.runs,
        (reply.here.intensity, reply.here.width_m, reply.here.height_m),
    )
    return sizes_chart(sizes, _source(scenario, language, named, count=reply.motions))


def verdict_figure(
    verdict: AnyVerdict, name: FigureName, language: Language, named: Callable[[str], str]
) -> Chart:
    """Return a chart of a verdict.

    Parameters
    ----------
    verdict : Verdict or RoomVerdict
        The verdict.
    name : str
        Which one.
    language : str
        "en" or "ja".
    named : callable
        Puts the users' names for their files into a text.

    Raises
    ------
    RefusedError
        Curves of a verdict that has none, or a chart that is there for other verdicts.
    """
    source = _source(verdict.scenario, language, named, count=verdict.motions)
    if isinstance(verdict, RoomVerdict):
        if name not in ROOM_CHARTS:
            raise refused(409, "app.of_a_room")
        return ROOM_CHARTS[name](verdict, source)
    if name in ROOM_CHARTS:
        raise refused(409, "figures.of_one_piece")
    looked_at = [verdict.without, *_yours(verdict)]
    if name == "ranking":
        return ranking_chart(verdict, source)
    if name == "tens":
        return tens_chart(verdict, looked_at, source)
    shown = [*looked_at, *([] if verdict.best in looked_at else [verdict.best])]
    drawn = [option for option in shown if JMA_INTENSITY in option.curves]
    if not drawn:
        raise refused(409, "figures.no_curves")
    return fragility_chart(verdict, drawn, source)


def _yours(verdict: Verdict) -> list[OptionVerdict]:
    return [one for one in verdict.options if one.option.name == YOURS and one.option.measures]


def _source(
    scenario: Scenario | AssemblyScenario,
    language: Language,
    named: Callable[[str], str],
    *,
    motion: str = "",
    count: int = 1,
) -> ChartSource:
    """Return what a chart is of: one motion that is named, or so many of the scene's."""
    piece = [furniture_assumption(scenario)] if isinstance(scenario, Scenario) else []
    shaking = [
        (one.what(language), named(one.value(language))) for one in shaking_assumptions(scenario, count)
    ]
    if motion:
        shaking[0] = (shaking[0][0], motion)
    around = (
        [floor_assumption(scenario, scenario.surroundings().floor)]
        if isinstance(scenario, RoomScenario)
        else room_assumptions(scenario)
    )
    still = [(one.what(language), one.value(language)) for one in (*piece, *around)]
    held = own_measures(scenario) if isinstance(scenario, Scenario) else ()
    labels = " + ".join(say(measure.label, language) for measure in held)
    measures = [(say("figures.measures", language), labels)] if held else []
    return ChartSource(
        (*still, *shaking, *measures), named(scenario.to_toml()), scenario.uncertainty.seed, language
    )
