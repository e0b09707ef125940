"""Runs made by hand, in closed form, for the tests of what is shown of a run."""

import dataclasses
import math

import numpy as np

import stayput as sp
from stayput.measures.measure import Held
from stayput.model.state import State
from stayput.simulation.outcome import Event, EventKind, Mode, Outcome
from stayput.simulation.run import PieceRun, Run

DT = 0.01
BODY = sp.Body(0.3, 1.8, 200.0)
ROOM = sp.Room(left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
SHAKE = sp.sine(5.0, 0.8, 4.0, dt=DT)


def made(tilt, slide, mode, events=(), *, overturn_time=math.nan, outcome=Outcome.ROCKED):
    """Return a run about B where the tilt is ≥ 0 and about A elsewhere, from its tilts and slides."""
    a, b = BODY.corners[:2]
    corner = np.where(tilt[:, None] >= 0.0, np.array(b), np.array(a))
    u, v, cos, sin = corner[:, 0], corner[:, 1], np.cos(tilt), np.sin(tilt)
    overturned = outcome is Outcome.OVERTURNED
    none = np.zeros_like(tilt)
    piece = PieceRun(
        outcome, overturn_time, math.nan,
        peak_slide=float(np.abs(slide).max()), residual_slide=float(slide[-1]),
        peak_tilt=math.pi / 2 if overturned else float(np.abs(tilt).max()), residual_tilt=float(tilt[-1]),
        floor_impacts=sum(e.kind is EventKind.FLOOR_IMPACT for e in events),
        wall_impacts=sum(e.kind in (EventKind.WALL_IMPACT, EventKind.CEILING_IMPACT) for e in events),
        body_impacts=0, tilt=tilt, slide=slide, slide_in_plan=np.column_stack((slide, none)), yaw=none,
        held=Held(BODY, ROOM),
    )  # fmt: skip
    place = np.column_stack((slide + u - u * cos - v * sin, none, u * sin - v * cos))
    still, half = np.zeros((1, len(tilt), 3)), 0.5 * tilt
    return Run(
        "plane", ("body",), (piece,), ROOM, SHAKE, DT * np.arange(len(tilt)), place[np.newaxis],
        np.column_stack((np.cos(half), none, np.sin(half), none))[np.newaxis], still, still,
        initial=State(), gravity=9.80665, slide_rate=none, mode=np.array(mode), events=tuple(events),
    )  # fmt: skip


def event(time, kind, mode, tilt=0.0, slide=0.0):
    return Event(time, kind, mode, tilt, 0.0, slide, 0.0)


def falling(sign=1.0):
    """Slides 5 cm from 0.5 to 1 s, hits the wall at 1.2 s, falls from 1.5 s to 2.505 s."""
    t = DT * np.arange(251)
    slide = 0.05 * np.clip((t - 0.5) / 0.5, 0.0, 1.0)
    tilt = sign * math.pi / 2 * np.clip((t - 1.5) / 1.005, 0.0, 1.0) ** 2
    mode = ["slide" if 0.5 <= time < 1.0 else "rock" if time >= 1.5 else "rest" for time in t]
    events = (
        event(0.5, EventKind.SLIP, Mode.SLIDE),
        event(1.2, EventKind.WALL_IMPACT, Mode.REST),
        event(2.505, EventKind.OVERTURNED, Mode.OVERTURNED, sign * math.pi / 2, 0.06),
    )
    return made(tilt, slide, mode, events, overturn_time=2.505, outcome=Outcome.OVERTURNED)


def rocking(peak=0.05):
    t = DT * np.arange(401)
    return made(peak * np.sin(3.0 * t), 0.02 * t / 4.0, ["rock"] * 401)


def changed(run, **values):
    """Return a run of one piece with other results of the piece."""
    return dataclasses.replace(run, pieces=(dataclasses.replace(run.piece, **values),))
