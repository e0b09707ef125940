"""A scene run without and with measures, and its histories at the rate of a screen."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.app.fields import Words
from stayput.app.run_replies import (
    BodyReply,
    BuildingReply,
    DeviceReply,
    EventReply,
    FloorReply,
    MotionOfRun,
    RoomReply,
    RunReply,
    ShapeReply,
    SimulateReply,
)
from stayput.app.scenes import YOURS, refusal
from stayput.app.sentences import told
from stayput.cases import wall_faces
from stayput.errors import InputError
from stayput.measures import sketch
from stayput.motion.intensity import EXCEEDED, intensity_class
from stayput.report.film import ground_displacement
from stayput.report.history import history
from stayput.simulation import simulate

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.measures import Measure
    from stayput.motion import Motion
    from stayput.report.history import History
    from stayput.scenario import Scenario
    from stayput.simulation import Run

RATE = 60.0
"""Frames a second."""

MOST_EVENTS = 2000
"""Events of a run that are sent."""

FARTHEST_SHIFT = 0.5
"""Largest displacement of the floor that is drawn, in heights of the body; a larger one is drawn smaller."""


def yours(scenario: Scenario) -> tuple[Measure, ...]:
    """Return the user's own set of measures."""
    return next((one.measures for one in scenario.measures if one.name == YOURS), ())


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
            contact=scenario.contact,
            initial=scenario.initial.state(),
            gravity=scenario.gravity,
        )
    except InputError as error:
        refused = refusal(error)
        refused.field = "measures" if measures else "scene"
        raise refused from None


def simulated(scenario: Scenario) -> SimulateReply:
    """Run a scene without and with the user's measures.

    Raises
    ------
    RefusedError
        As `run_of`.
    """
    own, shaking = yours(scenario), scenario.shaking
    ground = shaking.model_copy(update={"building": None, "storey": None}).motion(scenario.folder)
    motion = ground if shaking.building is None else shaking.motion(scenario.folder)
    without = run_of(scenario, motion, ())
    held = run_of(scenario, motion, own) if own else None
    floor = _floor(motion, max(without.body.width, without.body.height))
    return SimulateReply(
        motion=_motion_of(ground, motion),
        floor=floor,
        building=_building(scenario, ground, floor.scale_shown),
        without=run_reply(without, scenario),
        with_=None if held is None else run_reply(held, scenario),
    )


def run_reply(run: Run, scenario: Scenario) -> RunReply:
    """Return a run as arrays for a picture."""
    shown = history(run)
    frames = _frames(shown.end)
    x, z, tilt, slide = (
        np.interp(frames, shown.time, values) for values in (shown.x, shown.z, shown.tilt, shown.slide)
    )
    return RunReply(
        outcome=run.outcome.value,
        sentence=told(run, scenario.furniture),
        overturned=run.overturned,
        overturn_time_s=_finite(run.overturn_time),
        peak_slide_m=run.peak_slide,
        residual_slide_m=run.residual_slide,
        peak_tilt_rad=run.peak_tilt,
        residual_tilt_rad=run.residual_tilt,
        floor_impacts=run.floor_impacts,
        wall_impacts=run.wall_impacts,
        body=_body(run),
        room=_room(run),
        time_s=_rounded(frames, 4),
        x_m=_rounded(x, 5),
        z_m=_rounded(z, 5),
        tilt_rad=_rounded(tilt, 5),
        slide_m=_rounded(slide, 5),
        modes=[(round(start, 4), mode.value) for start, _, mode in shown.spans()],
        events=[
            EventReply(time_s=round(event.time, 4), kind=event.kind.value, mode=event.mode.value)
            for event in run.events[:MOST_EVENTS]
        ],
        events_total=len(run.events),
        devices=_devices(run, shown, frames),
        shapes=_shapes(run),
    )


def _frames(end: float) -> NDArray[np.float64]:
    """Return the times of the frames, with the end itself."""
    frames = np.arange(0.0, end, 1.0 / RATE)
    return np.append(frames, end)


def _body(run: Run) -> BodyReply:
    a, b, c, d = run.body.corners
    return BodyReply(
        width_m=run.body.width,
        height_m=run.body.height,
        mass_kg=run.body.mass,
        inertia_kg_m2=run.body.inertia_about_cg,
        centre_of_gravity_m=run.body.centre_of_gravity,
        corners_m=[a, b, d, c],
        base_heights_m=run.body.base_heights,
        slenderness_rad=min(run.body.slenderness),
    )


def _room(run: Run) -> RoomReply:
    """Return where the faces stand: gaps are from the sides of the body as it stands at rest."""
    left, right, ceiling = run.room.left_wall, run.room.right_wall, run.room.ceiling
    at_left, at_right = wall_faces(run.body, run.room)
    return RoomReply(
        left_wall_x_m=None if left is None else at_left,
        right_wall_x_m=None if right is None else at_right,
        ceiling_z_m=None if ceiling is None else ceiling.height,
    )


def _devices(run: Run, shown: History, frames: NDArray[np.float64]) -> list[DeviceReply]:
    return [
        DeviceReply(
            kind=device.kind,
            label=Words.of(device.label),
            name=device.place,
            peak_pull_n=device.peak_pull,
            peak_push_n=device.peak_push,
            peak_shear_n=device.peak_shear,
            utilisation=_finite(device.utilisation),
            failed=device.failed,
            failure_time_s=_finite(device.failure_time),
            cause=device.cause,
            pull_n=_rounded(np.interp(frames, run.time, device.pull), 1),
            shear_n=_rounded(np.interp(frames, run.time, device.shear), 1),
        )
        for device in run.devices
    ]


def _shapes(run: Run) -> list[ShapeReply]:
    if run.held is None:
        return []
    return [
        ShapeReply(
            kind=shape.kind, points=list(shape.points), role=shape.role, device=shape.element, when=shape.when
        )
        for shape in sketch(run.held)
    ]


def intensity_of(motion: Motion) -> float | None:
    """Return the JMA intensity of a motion, if it has one: it is long enough and not still."""
    return _finite(motion.intensity) if motion.duration > 2.0 * EXCEEDED else None


def _motion_of(ground: Motion, motion: Motion) -> MotionOfRun:
    below, felt = intensity_of(ground), intensity_of(motion)
    return MotionOfRun(
        name=motion.name,
        synthetic=motion.synthetic,
        duration_s=motion.duration,
        dt_s=motion.dt,
        pga_m_s2=motion.pga,
        pgv_m_s=motion.pgv,
        ground_intensity=below,
        ground_class=class_of(below),
        floor_intensity=felt,
        floor_class=class_of(felt),
    )


def class_of(intensity: float | None) -> str | None:
    """Return the class of an intensity, if it has one."""
    return None if intensity is None else intensity_class(intensity)


def _floor(motion: Motion, size: float) -> FloorReply:
    frames = _frames(motion.duration)
    shift = ground_displacement(motion)
    largest = float(np.abs(shift).max())
    scale = min(1.0, FARTHEST_SHIFT * size / largest) if largest > 0.0 else 1.0
    return FloorReply(
        time_s=_rounded(frames, 4),
        x_m=_rounded(scale * np.interp(frames, motion.time, shift), 5),
        acceleration_m_s2=_rounded(_largest_of_each(motion, frames), 3),
        scale_shown=scale,
    )


def _largest_of_each(motion: Motion, frames: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the acceleration of largest size in the piece of time around each frame."""
    if motion.dt >= 1.0 / RATE:
        return np.interp(frames, motion.time, motion.x)
    nearest = np.minimum(np.rint(motion.time * RATE).astype(np.intp), len(frames) - 1)
    starts = np.flatnonzero(np.diff(nearest, prepend=-1))
    high, low = np.maximum.reduceat(motion.x, starts), np.minimum.reduceat(motion.x, starts)
    found = np.zeros(len(frames))
    found[nearest[starts]] = np.where(high >= -low, high, low)
    return found


def _building(scenario: Scenario, ground: Motion, scale: float) -> BuildingReply | None:
    table, storey = scenario.shaking.building, scenario.shaking.storey
    if table is None or storey is None:
        return None
    structure = None if table.masses is not None else table.structure or "RC"
    roof = table.floor_motion(ground, table.highest())
    return BuildingReply(
        storeys=table.highest() - 1,
        storey=storey,
        structure=structure,
        ground_x_m=_shift(ground, scale),
        roof_x_m=_shift(roof, scale),
    )


def _shift(motion: Motion, scale: float) -> list[float]:
    """Return a displacement for a picture at the frames [m]."""
    frames = _frames(motion.duration)
    return _rounded(scale * np.interp(frames, motion.time, ground_displacement(motion)), 5)


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


def _rounded(values: NDArray[np.float64], digits: int) -> list[float]:
    return (np.round(values, digits) + 0.0).tolist()
