"""What happens in a scene: its runs without and with measures, and how strongly the ground shakes."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from stayput.app.messages import RefusedError, Reply, TwoNumbers, Words, refused
from stayput.app.motions import class_of, intensity_of
from stayput.catalogue import Phrase, phrase
from stayput.catalogue.names import ANY_PIECE
from stayput.errors import InputError
from stayput.mechanics.columns import ROCKING_TILT
from stayput.model.room import WALLS_AROUND
from stayput.montecarlo.counting import Member
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.motion.intensity import intensity_class, published_intensity
from stayput.report.film.scene import TIME_DIGITS, ground_displacement, posed, scene_of
from stayput.report.film.shape import rounded
from stayput.report.summary import device_results, piece_results, place_called, sentences_of_piece
from stayput.scenario.measures import YOURS
from stayput.simulation.outcome import EventKind
from stayput.simulation.space_fate import SLID
from stayput.verification.events import happens_in
from stayput.verification.option_runner import drawn_run
from stayput.verification.words import class_phrase

if TYPE_CHECKING:
    from stayput.measures import Measure
    from stayput.measures.element import DeviceResult
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.scenario.shaking import ShakingTable
    from stayput.simulation.run import Run

MOST_EVENTS = 2000
"""Events of a run that are sent: the first ones, and the last."""


HITS = {"floor": EventKind.FLOOR_IMPACT, "ceiling": EventKind.CEILING_IMPACT} | dict.fromkeys(
    WALLS_AROUND, EventKind.WALL_IMPACT
)
"""Kinds of hits on the room."""

ALIKE = 0.05
"""A standard deviation of intensities that is not mentioned."""


class EventReply(Reply):
    """What happened to a piece at an instant."""

    time_s: float
    kind: str
    piece: int = Field(description="Its number, from 0 on.")


class DeviceReply(Reply):
    """What became of a device."""

    kind: str
    label: Words
    name: str
    peak_pull_n: float = Field(description="Largest that it bore, until it failed if it did.")
    peak_push_n: float
    peak_shear_n: float
    utilisation: float | None
    failed: bool
    failure_time_s: float | None
    cause: str | None
    weakest: Words | None = Field(description="What gave way, or would first.")
    pull_n: list[float] = Field(description="At the poses.")
    shear_n: list[float]


class FateReply(Reply):
    """What became of a piece, or of the one that fared worst."""

    outcome: str
    overturned: bool | None
    overturn_time_s: float | None


class PieceReply(FateReply):
    """What became of one piece."""

    name: str
    fell_off: bool | None = Field(description="Whether it came off what it stood on.")
    fall_time_s: float | None
    peak_tilt_rad: float | None = Field(description="Largest angle to how it stood, in any direction.")
    peak_slide_m: float | None = Field(description="Farthest from where it stood, in plan.")
    residual_tilt_rad: float | None
    residual_slide_m: TwoNumbers | None = Field(description="Along x and y, until it fell.")
    residual_yaw_rad: float | None = Field(description="Turn about the vertical, at the end.")
    floor_impacts: int
    wall_impacts: int
    impacts_on_bodies: int


class RunReply(FateReply):
    """What became of the pieces of a run, and when the first one overturned."""

    sentence: Words
    pieces: list[PieceReply]
    events: list[EventReply] = Field(
        description="In the plane all; in space when each piece first slides, lifts an edge and overturns, "
        "and first hits on the room."
    )
    events_total: int = Field(description="How many there were.")
    events_cut: bool = Field(description="Whether only some are listed: in the plane the first and the last.")
    devices: list[DeviceReply]
    scene: dict[str, Any] = Field(
        description="Bodies and room, as the method `data` of `stayput.report.film.scene.FilmScene` "
        "describes them; long histories are the base 64 of 32-bit floating-point numbers, least byte first."
    )


class MotionOfRun(Reply):
    """The motion under the furniture, and the ground's intensity."""

    name: str
    synthetic: bool
    duration_s: float
    dt_s: float
    pga_m_s2: float
    pgv_m_s: float
    ground_intensity: float | None
    ground_class: str | None
    floor_intensity: float | None
    floor_class: str | None


class BuildingReply(Reply):
    """The building between the ground and the furniture."""

    storeys: int
    storey: int
    structure: str | None
    ground_x_m: list[float] = Field(description="Displacement of the ground, as the floor's.")
    roof_x_m: list[float] = Field(description="Displacement of the roof, as the floor's.")


class HitReply(Reply):
    """A piece that comes into the place of a person."""

    piece: str
    place: str


class RunInRoomReply(Reply):
    """What happens to people, doors and ways out in a run of a room."""

    hits: list[HitReply]
    blocked: list[str] = Field(description="Doors that are blocked at the end.")
    shut_in: list[str] = Field(description="Places from which no way leads out at the end.")


class SimulateReply(Reply):
    """A scene run without and with measures, or several pieces."""

    engine: Literal["plane", "space"]
    motion: MotionOfRun
    floor: dict[str, Any] = Field(description="How the floor moves, of the same form as the runs' scenes.")
    building: BuildingReply | None
    in_room: RunInRoomReply | None = Field(default=None, description="Of a room: what happens in it.")
    without: RunReply
    with_: RunReply | None = Field(default=None, serialization_alias="with")


class ShakingReply(Reply):
    """How strongly the ground shakes in a scene: the motions as strong as a verification has them."""

    intensity: float = Field(description="Median JMA intensity of the motions.")
    deviation: float = Field(description="Standard deviation of their JMA intensities.")
    intensity_class: str | None
    sentence: Words = Field(description="The same in words.")
    about: Words | None = Field(description="What was stated, and the source of what it amounts to.")


def own_measures(scenario: Scenario) -> tuple[Measure, ...]:
    """Return the user's own set of measures."""
    return next((measure_set.measures for measure_set in scenario.options if measure_set.name == YOURS), ())


def runs_of(scenario: Scenario, *sets: tuple[Measure, ...], sample: int | None = None) -> list[Run]:
    """Run a piece with each of some sets of measures, in the plane or in space; or several pieces, once.

    Parameters
    ----------
    scenario : Scenario
        What stands.
    *sets : tuple of Measure
        Measures on a lone piece.
    sample : int, optional
        Of several pieces: the run of a verdict with this sample, from 0, of the motion that is shown; else
        what stands runs as it is stated.

    Raises
    ------
    RefusedError
        Measures that cannot be applied, or what the simulation refuses.
    """
    runs: list[Run] = []
    place = "scene"
    try:
        if not scenario.alone and sample is not None and scenario.shaking.suite is not None:
            member = Member((scenario.shaking.member or 1) - 1, sample)
            return [drawn_run(scenario, scenario.stated, member)]
        if not scenario.alone:
            return [scenario.run()]
        case, piece = scenario.case(), scenario.piece
        held = replace(case, measures=own_measures(scenario))  # both are shown side by side, by one engine
        for measures in sets:
            place = "measures" if measures else "scene"
            run = replace(case, measures=measures, dimensions=3 if held.in_space else 2).run(MOST_EVENTS)
            runs.append(run.named([piece.name or piece.preset or ANY_PIECE[0]]))
    except InputError as error:
        raise RefusedError(422, error.about(place)) from None
    return runs


def simulated(scenario: Scenario, sample: int | None = None) -> SimulateReply:
    """Run a scene: one piece without and with the user's measures, or several pieces.

    Raises
    ------
    RefusedError
        As `runs_of`.
    """
    shaking, measures = scenario.shaking, own_measures(scenario)
    bare = shaking.model_copy(update={"building": None, "storey": None})
    ground = scenario.model_copy(update={"shaking": bare}).motion()
    runs = runs_of(scenario, (), *([measures] if measures else []), sample=sample)
    drawn = [posed(run) for run in runs]
    scenes = [scene_of(shown, shown.names, drawn) for shown in drawn]
    data = [scene.data() for scene in scenes]
    floor, *_ = [each.pop("floor") for each in data]  # which all runs share
    replies = [
        _run_reply(run, scene.time, scene_data)
        for run, scene, scene_data in zip(runs, scenes, data, strict=True)
    ]
    reply = SimulateReply(
        engine=runs[0].engine,
        motion=_motion_of_run(ground, runs[0].motion),
        floor=floor,
        building=_building_reply(shaking, ground, scenes[0].time, scenes[0].shift_scale),
        without=replies[0],
        with_=replies[1] if len(replies) > 1 else None,
    )
    if scenario.plan is not None:
        hits, blocked, shut_in = happens_in(runs[0])
        each = [HitReply(piece=piece, place=place) for piece, place in hits]
        reply.in_room = RunInRoomReply(hits=each, blocked=[*blocked], shut_in=[*shut_in])
    return reply


def _run_reply(run: Run, times: NDArray[np.float64], scene: dict[str, Any]) -> RunReply:
    """Return what became of the pieces of a run, with the scene that shows it at some times [s]."""
    pieces, events = piece_results(run), _events(run)
    total = len(events) + sum(run.unlisted.values())
    return RunReply(
        outcome=run.outcome.value,
        sentence=Words.of(sentences_of_piece(run)),
        overturned=any(p.overturned for p in run.pieces),
        overturn_time_s=min((p.overturn_time for p in run.pieces if p.overturned), default=None),
        pieces=[PieceReply(**piece) for piece in pieces],
        events=events[:MOST_EVENTS],
        events_total=total,
        events_cut=total > MOST_EVENTS,
        devices=[_device(device, run, times) for device in run.devices],
        scene=scene,
    )


def _motion_of_run(ground: Motion, motion: Motion) -> MotionOfRun:
    """Return the motion under the furniture, beside that of the ground."""
    ground_intensity, floor_intensity = intensity_of(ground), intensity_of(motion)
    return MotionOfRun.from_attributes(
        motion,
        ground_intensity=ground_intensity,
        ground_class=class_of(ground_intensity),
        floor_intensity=floor_intensity,
        floor_class=class_of(floor_intensity),
    )


def _building_reply(
    shaking: ShakingTable, ground: Motion, times: NDArray[np.float64], scale: float
) -> BuildingReply | None:
    """Return how the building of a scene moves in a picture, if there is one.

    Parameters
    ----------
    shaking : ShakingTable
        The scene's shaking.
    ground : Motion
        The motion of the ground.
    times : ndarray
        When the picture shows it [s].
    scale : float
        What part of the displacements the picture shows.
    """
    table, storey = shaking.building, shaking.storey
    if table is None or storey is None:
        return None
    structure = None if table.masses is not None else table.structure or "RC"
    roof = table.building().floor_motion(ground, table.highest())
    return BuildingReply(
        storeys=table.highest() - 1,
        storey=storey,
        structure=structure,
        ground_x_m=_shift(ground, times, scale),
        roof_x_m=_shift(roof, times, scale),
    )


def _shift(motion: Motion, times: NDArray[np.float64], scale: float) -> list[float]:
    """Return a displacement for a picture at some times [m]."""
    return rounded(scale * np.interp(times, motion.time, ground_displacement(motion)))


def _device(device: DeviceResult, run: Run, times: NDArray[np.float64]) -> Any:
    forces = {"pull_n": device.pull, "shear_n": device.shear}
    at_poses = {name: rounded(np.interp(times, run.time, values), 1) for name, values in forces.items()}
    return {**device_results(device), "name": place_called(device, run.names), **at_poses}


def _events(run: Run) -> list[EventReply]:
    """Return the events of a run in order.

    In space: when each piece first slides and lifts an edge, its hits on the room, and when it overturns.
    """
    if run.engine == "plane":
        events = [(event.time, event.kind, 0) for event in run.events]
    else:
        events = [(hit.time, HITS[hit.surface], hit.body) for hit in run.hits if hit.surface]
        for number, piece in enumerate(run.pieces):
            first = {
                EventKind.SLIP: _first(run.time, piece.slide > SLID),
                EventKind.UPLIFT: _first(run.time, piece.tilt > ROCKING_TILT),
                EventKind.OVERTURNED: piece.overturn_time,
            }
            events += [(time, kind, number) for kind, time in first.items() if not math.isnan(time)]
        events.sort(key=lambda event: event[0])
    return [
        EventReply(time_s=round(time, TIME_DIGITS), kind=kind.value, piece=piece)
        for time, kind, piece in events
    ]


def _first(time: NDArray[np.float64], moves: NDArray[np.bool_]) -> float:
    """Return the first time at which something is so [s]; else nan."""
    return float(time[moves.argmax()]) if moves.any() else math.nan


def shaking_reply(scenario: Scenario) -> ShakingReply:
    """Return how strongly the ground shakes in a scene.

    Raises
    ------
    RefusedError
        A motion that is still.
    """
    motions = ScaledMotions(scenario.ground())
    shaking, strength = scenario.shaking, scenario.shaking.strength
    factors = motions.stated_factors(strength, shaking.scale, scenario.uncertainty.seed)
    intensities = motions.intensities(factors)
    if not np.isfinite(intensities).all():
        raise refused(422, "motion.still_floor", "scene.shaking")
    middle, deviation = float(np.median(intensities)), float(np.std(intensities))
    text = None if strength is None else phrase("verification.strength", strength=strength.told(len(factors)))
    return ShakingReply(
        intensity=middle,
        deviation=deviation,
        intensity_class=None if motions.ground.floor else intensity_class(middle),
        sentence=Words.of(_sentence(middle, deviation, motions.ground.floor)),
        about=None if text is None else Words.of(text),
    )


def _sentence(middle: float, deviation: float, floor: str) -> Phrase:
    """Return an intensity in words, with the classes within a standard deviation."""
    at = published_intensity(middle)
    low, high = class_phrase(middle - deviation, floor), class_phrase(middle + deviation, floor)
    if deviation < ALIKE:
        return phrase("earthquake.amounts", at=at, strength=class_phrase(middle, floor))
    if low == high:
        return phrase("earthquake.amounts_about", at=at, deviation=deviation, strength=low)
    return phrase("earthquake.amounts_between", at=at, deviation=deviation, low=low, high=high)
