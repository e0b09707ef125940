"""Runs of a scene in the plane without and with measures, their histories at the frame rate of a screen."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app.motions import class_of, intensity_of
from stayput.app.refusals import RefusedError
from stayput.app.replies import Words
from stayput.app.run_replies import (
    BuildingReply,
    EventReply,
    FloorReply,
    MotionOfRun,
    RunReply,
    SimulateReply,
    ViewReply,
)
from stayput.errors import InputError
from stayput.report.scene import TIME_DIGITS, frames, ground_displacement, rounded, scene_of
from stayput.report.summary import piece_sentences
from stayput.simulation.case import simulate
from stayput.verification.options import YOURS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.measures import Measure
    from stayput.motion import Motion
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.scenario.shaking import ShakingTable
    from stayput.simulation.run import Run

RATE = 60.0
"""Frames a second."""

MOST_EVENTS = 2000
"""Events of a run that are sent: the first ones, and the last."""


def own_measures(scenario: Scenario) -> tuple[Measure, ...]:
    """Return the user's own set of measures."""
    return next((measure_set.measures for measure_set in scenario.measures if measure_set.name == YOURS), ())


def run_of(scenario: Scenario, motion: Motion, measures: tuple[Measure, ...]) -> Run:
    """Run a scene under a motion.

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
            measures=measures,
            dimensions=2,
            initial=scenario.initial.state(),
            gravity=scenario.gravity,
            most_events=MOST_EVENTS,
        )
    except InputError as error:
        raise RefusedError(422, error.about("measures" if measures else "scene")) from None


def simulated(scenario: Scenario) -> SimulateReply:
    """Run a scene without and with the user's measures.

    Raises
    ------
    RefusedError
        As `run_of`.
    """
    measures, (ground, motion) = own_measures(scenario), ground_and_floor(scenario)
    runs = [run_of(scenario, motion, measures) for measures in ([(), measures] if measures else [()])]
    scene = scene_of(runs, end=motion.duration)
    data = scene.data(RATE)
    replies = [run_reply(run, run_data, scenario) for run, run_data in zip(runs, data["runs"], strict=True)]
    return SimulateReply(
        motion=motion_of_run(ground, motion),
        floor=FloorReply(**data["floor"]),
        view=ViewReply(**data["view"]),
        building=building_reply(
            scenario.shaking, ground, frames(0.0, motion.duration, RATE), scene.shift_scale
        ),
        without=replies[0],
        with_=replies[1] if measures else None,
    )


def run_reply(run: Run, data: dict[str, Any], scenario: Scenario) -> RunReply:
    """Return a run as arrays for a picture: its data in a scene, and what happened."""
    return RunReply(
        **data,
        sentence=Words.of(piece_sentences(run, scenario.furniture.preset, scenario.furniture.name)),
        events=[
            EventReply(time_s=round(event.time, TIME_DIGITS), kind=event.kind.value, mode=event.mode.value)
            for event in run.events
        ],
        events_total=run.events_total,
        events_cut=bool(run.unlisted),
    )


def ground_and_floor(scenario: Scenario | AssemblyScenario) -> tuple[Motion, Motion]:
    """Return the motions of the ground and under the piece, along the axes of the piece."""
    shaking = scenario.shaking
    if shaking.building is None:
        ground = scenario.motion()
        return ground, ground
    bare = shaking.model_copy(update={"building": None, "storey": None})
    return scenario.model_copy(update={"shaking": bare}).motion(), scenario.motion()


def motion_of_run(ground: Motion, motion: Motion) -> MotionOfRun:
    """Return the motion under the furniture, beside that of the ground."""
    ground_intensity, floor_intensity = intensity_of(ground), intensity_of(motion)
    return MotionOfRun(
        name=motion.name,
        synthetic=motion.synthetic,
        duration_s=motion.duration,
        dt_s=motion.dt,
        pga_m_s2=motion.pga,
        pgv_m_s=motion.pgv,
        ground_intensity=ground_intensity,
        ground_class=class_of(ground_intensity),
        floor_intensity=floor_intensity,
        floor_class=class_of(floor_intensity),
    )


def building_reply(
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
