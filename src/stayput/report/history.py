"""What of a run is shown: its fall, its modes, and the part of it in which something happens."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.simulation.outcome import EventKind, Mode

if TYPE_CHECKING:
    from stayput.simulation.run import Run


BEFORE, AFTER, LONGEST = 2.0, 4.0, 60.0
"""What is shown before anything moves and after the last thing of note, and at most in all [s]."""

MOVED = 1e-3
"""Tilt [rad] and slide [m] from which something moves."""

OF_PIECES = ("tilt", "slide", "slide_in_plan", "yaw")
"""Histories of a piece."""


def sampled(run: Run, samples: NDArray[np.intp] | NDArray[np.bool_]) -> Run:
    """Return what pictures show of a run at some of its samples: numbers or a mask, shape (n,)."""
    pieces = tuple(
        replace(piece, **{name: getattr(piece, name)[samples] for name in OF_PIECES}) for piece in run.pieces
    )
    poses = {name: getattr(run, name)[:, samples] for name in ("place", "attitude")}
    mode = run.mode[samples] if len(run.mode) else run.mode
    return replace(run, time=run.time[samples], pieces=pieces, mode=mode, **poses)


def with_overturning(run: Run) -> Run:
    """Return a run with the instant of overturning, where that comes after its last sample.

    In the plane samples end before the body turned over. The instant of overturning follows them here: 90°,
    on the side where it lies, with the corner it turned about on the floor.
    """
    if not run.mode.size or not run.overturned or run.overturn_time <= float(run.time[-1]):
        return run
    tilt = float(run.tilt[-1])
    corner = run.body.corners_at_rest[1 if tilt > 0.0 else 0]
    across, _ = turned(corner, tilt)
    last = next((event for event in reversed(run.events) if event.kind is EventKind.OVERTURNED), None)
    moved = 0.0 if last is None else last.slide - float(run.slide[-1])
    flat = math.copysign(math.pi / 2, tilt)
    right, up = turned(corner, flat - run.body.resting_tilt)
    longer = sampled(run, np.append(np.arange(len(run.time)), -1))
    longer.time[-1] = run.overturn_time
    longer.place[0, -1] = float(run.place[0, -1, 0]) + across + moved - right, 0.0, -up
    longer.attitude[0, -1] = math.cos(0.5 * flat), 0.0, math.sin(0.5 * flat), 0.0
    longer.tilt[-1] = flat - run.body.resting_tilt
    longer.slide[-1] += moved
    return replace(longer, mode=np.append(run.mode, Mode.OVERTURNED.value))


def turned(corner: tuple[float, float], tilt: float) -> tuple[float, float]:
    """Return where a point of the body lies from G [m], right and up, when the body is tilted."""
    u, v = corner
    cos, sin = math.cos(tilt), math.sin(tilt)
    return u * cos + v * sin, v * cos - u * sin


def spans(run: Run) -> list[tuple[float, float, Mode]]:
    """Return when the body was in which mode: (start [s], end [s], mode) in order; nothing in space."""
    if not len(run.mode):
        return []
    starts = [0, *(np.flatnonzero(run.mode[1:] != run.mode[:-1]) + 1).tolist()]
    modes = [Mode(mode) for mode in run.mode[starts].tolist()]
    times = run.time[[*starts, -1]].tolist()
    return [(start, end, mode) for mode, (start, end) in zip(modes, pairwise(times), strict=True)]


def telling(run: Run) -> float:
    """Return the most telling moment [s]: halfway through the first fall, else the largest tilt or slide."""
    tilt, _ = _largest(run)
    if any(piece.overturned for piece in run.pieces) and tilt.max() > 0.5:
        return float(run.time[int((tilt > 0.5).argmax())])
    return _peak(run)


def _largest(run: Run) -> list[NDArray[np.float64]]:
    """Return the largest tilt [rad] and slide [m] of all pieces over time, shape (samples,) each."""
    return [
        np.max([np.abs(getattr(piece, name)) for piece in run.pieces], axis=0) for name in ("tilt", "slide")
    ]


def _peak(run: Run) -> float:
    tilt, slide = _largest(run)
    return float(run.time[int((tilt if tilt.max() > MOVED else slide).argmax())])


def window_of(runs: Sequence[Run], longest: float = LONGEST) -> tuple[float, float]:
    """Return the start and the end of the time in which something moves [s].

    Parameters
    ----------
    runs : sequence of Run
        Runs under one motion.
    longest : float
        How long it may be [s].
    """
    first, last, motion = math.inf, 0.0, runs[0].motion
    for run in runs:
        tilt, slide = _largest(run)
        moved = run.time[(tilt > MOVED) | (slide > MOVED)]
        first = min(first, *moved[:1].tolist(), math.inf)
        falls = [piece.overturn_time for piece in run.pieces if piece.overturned]
        last = max(last, *falls or [_peak(run)])
    if first >= last:  # nothing moves: the strongest shaking is shown
        first = last = float(motion.time[np.abs(motion.x).argmax()])
    end = min(motion.duration, last + min(AFTER, 0.4 * longest))
    return math.floor(10.0 * max(0.0, first - BEFORE, end - longest)) / 10.0, end


def cut_run(run: Run, start: float, end: float) -> Run:
    """Return the part of a run between two times [s]; numbers stay those of the whole."""
    cut = sampled(run, (run.time >= start - 1e-9) & (run.time <= end + 1e-9))
    return replace(cut, events=tuple(event for event in run.events if start <= event.time <= end))


def peak_told(run: Run) -> Phrase:
    """Return the largest acceleration of the floor: in the plane along the depth, else of all components."""
    if run.engine == "plane":
        return phrase("runs.peak_along_depth", peak=run.motion.pga)
    peak = np.linalg.norm(list(run.motion.components.values()), axis=0).max()
    return phrase("space.peak_of_all", peak=float(peak))
