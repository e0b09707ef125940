"""The histories of runs for display, and the part of them in which something happens."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from stayput.simulation.outcome import EventKind, Mode

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.run import Run


BEFORE, AFTER, LONGEST = 2.0, 4.0, 60.0
"""What is shown before anything moves and after the last thing of note, and at most in all [s]."""

MOVED = 1e-3
"""Tilt [rad] and slide [m] from which something moves."""


@dataclass(frozen=True, slots=True, eq=False)
class History:
    """Histories, shape (n,) each.

    Parameters
    ----------
    time : ndarray
        Times [s].
    x, z : ndarray
        Centre of gravity in the room [m].
    tilt : ndarray
        Tilt from rest [rad].
    slide : ndarray
        Slide [m].
    mode : tuple of Mode
        How the body moves from each instant on.
    """

    time: NDArray[np.float64]
    x: NDArray[np.float64]
    z: NDArray[np.float64]
    tilt: NDArray[np.float64]
    slide: NDArray[np.float64]
    mode: tuple[Mode, ...]

    @property
    def end(self) -> float:
        """Time of the last instant [s]."""
        return float(self.time[-1])

    def spans(self) -> list[tuple[float, float, Mode]]:
        """Return when the body was in which mode: (start [s], end [s], mode), one after the other."""
        starts = [i for i, mode in enumerate(self.mode) if i == 0 or mode is not self.mode[i - 1]]
        times = self.time[[*starts, -1]].tolist()
        return [(start, end, self.mode[i]) for i, (start, end) in zip(starts, pairwise(times), strict=True)]


def history(run: Run) -> History:
    """Return the histories of a run.

    A run's own end with the last sample before the body turned over. The instant of overturning follows
    it here: 90°, on the side where it lies, with the corner it turned about on the floor.
    """
    mode = tuple(Mode(str(value)) for value in run.mode)
    x, _, z = run.place[0].T
    shown = History(run.time, x, z, run.tilt, run.slide, mode)
    if not run.overturned or run.overturn_time <= shown.end:
        return shown
    tilt = float(run.tilt[-1])
    corner = run.body.corners_at_rest[1 if tilt > 0.0 else 0]
    across, _ = turned(corner, tilt)
    last = next((event for event in reversed(run.events) if event.kind is EventKind.OVERTURNED), None)
    moved = 0.0 if last is None else last.slide - float(run.slide[-1])
    lying = math.copysign(math.pi / 2, tilt) - run.body.resting_tilt
    right, up = turned(corner, lying)
    return History(
        np.append(run.time, run.overturn_time),
        np.append(x, float(x[-1]) + across + moved - right),
        np.append(z, -up),
        np.append(run.tilt, lying),
        np.append(run.slide, float(run.slide[-1]) + moved),
        (*mode, Mode.OVERTURNED),
    )


def turned(corner: tuple[float, float], tilt: float) -> tuple[float, float]:
    """Return where a point of the body lies from G [m], right and up, when the body is tilted."""
    u, v = corner
    cos, sin = math.cos(tilt), math.sin(tilt)
    return u * cos + v * sin, v * cos - u * sin


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


def window_in_space(runs: Sequence[Run], longest: float = LONGEST) -> tuple[float, float]:
    """Return the start and the end of the time in which something moves in space [s]; see `window_of`."""
    times = runs[0].time
    first, last = float(times[-1]), 0.0
    for run in runs:
        tilt = np.max([piece.tilt for piece in run.pieces], axis=0)
        slide = np.max([piece.slide for piece in run.pieces], axis=0)
        moved = np.flatnonzero((tilt > MOVED) | (slide > MOVED))
        if len(moved):
            first = min(first, float(times[moved[0]]))
        falls = [piece.overturn_time for piece in run.pieces if piece.overturned]
        last = max(last, *falls or [float(times[tilt.argmax()])])
    if first >= last:  # nothing moves: the strongest shaking is shown
        first = last = float(times[np.abs(runs[0].motion.x).argmax()])
    return _around(first, last, float(times[-1]), longest)


def _around(first: float, last: float, duration: float, longest: float) -> tuple[float, float]:
    end = min(duration, last + min(AFTER, 0.4 * longest))
    return math.floor(10.0 * max(0.0, first - BEFORE, end - longest)) / 10.0, end


def cut_run(run: Run, start: float, end: float) -> Run:
    """Return the part of a run in space between two times [s]; numbers stay those of the whole."""
    kept = (run.time >= start - 1e-9) & (run.time <= end + 1e-9)
    along = ("place", "attitude", "velocity", "rotation_rate", "force")
    of_piece = ("tilt", "slide", "slide_in_plan", "yaw")
    cut = [{name: getattr(piece, name)[kept] for name in of_piece} for piece in run.pieces]
    pieces = tuple(replace(piece, **parts) for piece, parts in zip(run.pieces, cut, strict=True))
    poses = {name: getattr(run, name)[:, kept] for name in along}
    return replace(run, time=run.time[kept], pieces=pieces, **poses)


def peak_of(motion: Motion) -> float:
    """Return the largest acceleration of the floor, all components together [m/s²]."""
    return float(np.linalg.norm(list(motion.components.values()), axis=0).max())
