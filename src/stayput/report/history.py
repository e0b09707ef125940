"""The histories of a run for display: with the final pose of an overturned body."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.simulation.outcome import EventKind, Mode

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.simulation.run import Run


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
        spans: list[tuple[float, float, Mode]] = []
        start = 0
        for i in range(1, len(self.mode) + 1):
            if i == len(self.mode) or self.mode[i] is not self.mode[start]:
                end = min(i, len(self.mode) - 1)
                spans.append((float(self.time[start]), float(self.time[end]), self.mode[start]))
                start = i
        return spans


def history(run: Run) -> History:
    """Return the histories of a run.

    A run's own end with the last sample before the body turned over. The instant of overturning follows
    it here: 90°, on the side where it lies, with the corner it turned about on the floor.
    """
    mode = tuple(Mode(str(value)) for value in run.mode)
    shown = History(run.time, run.x, run.z, run.tilt, run.slide, mode)
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
        np.append(run.x, float(run.x[-1]) + across + moved - right),
        np.append(run.z, -up),
        np.append(run.tilt, lying),
        np.append(run.slide, float(run.slide[-1]) + moved),
        (*mode, Mode.OVERTURNED),
    )


def turned(corner: tuple[float, float], tilt: float) -> tuple[float, float]:
    """Return where a point of the body lies from G [m], right and up, when the body is tilted."""
    u, v = corner
    cos, sin = math.cos(tilt), math.sin(tilt)
    return u * cos + v * sin, v * cos - u * sin
