"""The part of runs in which something happens, for films and reports."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.motion import Motion
    from stayput.report.history import History
    from stayput.simulation.run import Run
    from stayput.simulation.space_run import SpaceRun

BEFORE, AFTER, LONGEST = 2.0, 4.0, 60.0
"""What is shown before anything moves and after the last thing of note, and at most in all [s]."""

MOVED = 1e-3
"""Tilt [rad] and slide [m] from which something moves."""


def window_of(
    runs: Sequence[tuple[Run, History]], motion: Motion, longest: float = LONGEST
) -> tuple[float, float]:
    """Return the start and the end of the time in which something moves [s].

    Parameters
    ----------
    runs : sequence of (Run, History)
        Runs in the plane, with what is shown of them.
    motion : Motion
        How the floor moves.
    longest : float
        How long it may be [s].
    """
    first = motion.duration
    for _, shown in runs:
        moved = (np.abs(shown.tilt - shown.tilt[0]) > MOVED) | (np.abs(shown.slide) > MOVED)
        if moved.any():
            first = min(first, float(shown.time[int(moved.argmax())]))
    falls = [run.overturn_time for run, _ in runs if run.overturned]
    peaks = [
        float(shown.time[int(np.abs(values).argmax())])
        for _, shown in runs
        for values in (shown.tilt, shown.slide)
    ]
    last = max(falls or peaks)
    if first >= last:  # nothing moves: show the strongest shaking
        first = last = float(motion.time[int(np.abs(motion.x).argmax())])
    return _around(first, last, motion.duration, longest)


def window_in_space(runs: Sequence[SpaceRun], longest: float = LONGEST) -> tuple[float, float]:
    """Return the start and the end of the time in which something moves in space [s]; see `window_of`."""
    times = runs[0].time
    first, last = float(times[-1]), 0.0
    for run in runs:
        tilt, slide = run.tilt.max(axis=0), np.hypot(run.slide[..., 0], run.slide[..., 1]).max(axis=0)
        moved = np.flatnonzero((tilt > MOVED) | (slide > MOVED))
        if len(moved):
            first = min(first, float(times[moved[0]]))
        fell = run.overturn_time[run.overturned]
        last = max(last, float(fell.max()) if len(fell) else float(times[tilt.argmax()]))
    if first >= last:  # nothing moves: the strongest shaking is shown
        first = last = float(times[np.abs(runs[0].motion.x).argmax()])
    return _around(first, last, float(times[-1]), longest)


def _around(first: float, last: float, duration: float, longest: float) -> tuple[float, float]:
    end = min(duration, last + min(AFTER, 0.4 * longest))
    return math.floor(10.0 * max(0.0, first - BEFORE, end - longest)) / 10.0, end


def cut_run(run: SpaceRun, start: float, end: float) -> SpaceRun:
    """Return the part of a run between two times [s]."""
    kept = (run.time >= start - 1e-9) & (run.time <= end + 1e-9)
    return replace(
        run,
        time=run.time[kept],
        place=run.place[:, kept],
        attitude=run.attitude[:, kept],
        velocity=run.velocity[:, kept],
        rotation_rate=run.rotation_rate[:, kept],
        force=run.force[:, kept],
    )
