"""Runs of a scene in space: one piece without and with measures, or several pieces."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app.refusals import RefusedError
from stayput.app.replies import Words
from stayput.app.running import (
    MOST_EVENTS,
    building_reply,
    ground_and_floor,
    motion_of_run,
    own_measures,
)
from stayput.app.space_replies import (
    HitReply,
    RunInRoomReply,
    SpaceEventReply,
    SpaceRunReply,
    SpaceSimulateReply,
)
from stayput.errors import InputError
from stayput.model.room import WALLS_AROUND
from stayput.report.history import slid
from stayput.report.scene import TIME_DIGITS, rounded
from stayput.report.space.scene import space_scene
from stayput.report.space.summary import became, piece_became, space_summary
from stayput.report.summary import device_results, number, piece_name, place_called
from stayput.rooms.events import happens_in
from stayput.rooms.words import names_in
from stayput.scenario.room import RoomScenario
from stayput.simulation.case import simulate
from stayput.simulation.outcome import EventKind
from stayput.simulation.space_fate import ROCKED, SLID

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.measures import Measure
    from stayput.measures.element import DeviceResult
    from stayput.motion import Motion
    from stayput.report.space.scene import SpaceScene
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.simulation.space_run import SpaceRun

HITS = {"floor": EventKind.FLOOR_IMPACT, "ceiling": EventKind.CEILING_IMPACT} | dict.fromkeys(
    WALLS_AROUND, EventKind.WALL_IMPACT
)
"""Kinds of hits on the room."""


def space_run_of(scenario: Scenario, motion: Motion, measures: tuple[Measure, ...]) -> SpaceRun:
    """Run a piece in space under a motion.

    Raises
    ------
    RefusedError
        Measures that cannot be applied, or what the simulation refuses.
    """
    try:
        return simulate(
            scenario.furniture.body(),
            scenario.room.room(),
            motion,
            measures,
            dimensions=3,
            initial=scenario.initial.state(),
            gravity=scenario.gravity,
        )
    except InputError as error:
        raise RefusedError(422, error.about("measures" if measures else "scene")) from None


def name_in(scenario: Scenario, language: str) -> str:
    """Return what the piece of a scene is called in pictures."""
    piece = scenario.furniture
    english, japanese = piece_name(piece.preset, piece.name)
    return japanese if language == "ja" else english


def simulated_in_space(scenario: Scenario) -> SpaceSimulateReply:
    """Run a scene in space without and with the user's measures.

    Raises
    ------
    RefusedError
        As `space_run_of`.
    """
    measures, (ground, motion) = own_measures(scenario), ground_and_floor(scenario)
    piece, names = scenario.furniture, (name_in(scenario, "en"),)
    runs = [space_run_of(scenario, motion, in_place) for in_place in ([(), measures] if measures else [()])]
    told = [piece_became(run, piece.preset, piece.name) for run in runs]
    return _reply(scenario, [space_scene(run, names, runs) for run in runs], told, ground)


def simulated_pieces(scenario: AssemblyScenario) -> SpaceSimulateReply:
    """Run several pieces."""
    ground, _ = ground_and_floor(scenario)
    run = pieces_run(scenario)
    told = became(run, names_in(scenario, "en"))[0], became(run, names_in(scenario, "ja"))[1]
    reply = _reply(scenario, [space_scene(run, scenario.names)], [told], ground)
    if isinstance(scenario, RoomScenario):
        hits, blocked, shut_in = happens_in(run, scenario)
        each = [HitReply(piece=piece, place=place) for piece, place in hits]
        reply.in_room = RunInRoomReply(hits=each, blocked=[*blocked], shut_in=[*shut_in])
    return reply


def pieces_run(scenario: AssemblyScenario) -> SpaceRun:
    """Run several pieces.

    Raises
    ------
    RefusedError
        Pieces that are not possible.
    """
    try:
        return scenario.run()
    except InputError as error:
        raise RefusedError(422, error.about("scene")) from None


def _reply(
    scenario: Scenario | AssemblyScenario,
    scenes: Sequence[SpaceScene],
    sentences: Sequence[Phrase],
    ground: Motion,
) -> SpaceSimulateReply:
    """Return the reply about a run without measures, and about one with them where there is one."""
    data = [scene.data() for scene in scenes]
    floor, *_ = [each.pop("floor") for each in data]  # which all runs share
    replies = [_run_reply(*each) for each in zip(scenes, data, sentences, strict=True)]
    return SpaceSimulateReply(
        motion=motion_of_run(ground, scenes[0].run.motion),
        floor=floor,
        building=building_reply(scenario.shaking, ground, scenes[0].time, scenes[0].shift_scale),
        without=replies[0],
        with_=replies[1] if len(replies) > 1 else None,
    )


def _run_reply(scene: SpaceScene, data: dict[str, Any], sentence: Phrase) -> SpaceRunReply:
    run = scene.run
    return SpaceRunReply(
        outcome=run.outcome.value,
        sentence=Words.of(sentence),
        overturned=bool(run.overturned.any()),
        overturn_time_s=number(float(min(run.overturn_time, key=_or_never))),
        pieces=space_summary(run, scene.names)["bodies"],
        events=_events(run),
        devices=[_device(device, run, scene) for device in run.devices],
        scene=data,
    )


def _or_never(time: float) -> float:
    return math.inf if math.isnan(time) else time


def _device(device: DeviceResult, run: SpaceRun, scene: SpaceScene) -> Any:
    forces = {"pull_n": device.pull, "shear_n": device.shear}
    at_poses = {name: rounded(np.interp(scene.time, run.time, values), 1) for name, values in forces.items()}
    return {**device_results(device), "name": place_called(device, scene.names), **at_poses}


def _events(run: SpaceRun) -> list[SpaceEventReply]:
    """Return when each piece first slides and lifts an edge, its hits on the room, and when it overturns."""
    found: list[tuple[float, EventKind, int]] = [
        (hit.time, HITS[hit.surface], hit.body) for hit in run.hits[:MOST_EVENTS] if hit.surface
    ]
    slides, tilts = slid(run), run.tilt
    for piece, fell in enumerate(run.overturn_time.tolist()):
        first = {
            EventKind.SLIP: _first(run.time, slides[piece] > SLID),
            EventKind.UPLIFT: _first(run.time, tilts[piece] > ROCKED),
            EventKind.OVERTURNED: fell,
        }
        found += [(time, kind, piece) for kind, time in first.items() if not math.isnan(time)]
    found.sort(key=lambda event: event[0])
    return [
        SpaceEventReply(time_s=round(time, TIME_DIGITS), kind=kind.value, piece=piece)
        for time, kind, piece in found
    ]


def _first(time: NDArray[np.float64], moves: NDArray[np.bool_]) -> float:
    """Return the first time at which something is so [s]; else nan."""
    return float(time[moves.argmax()]) if moves.any() else math.nan
