"""Python's way into the compiled functions: one case with its history, or a batch of cases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.mechanics import columns as col
from stayput.mechanics.engine import run_batch
from stayput.mechanics.flat import BLOCK, block_extremes

if TYPE_CHECKING:
    from numpy.typing import NDArray

MAX_EVENTS = 1_000_000
"""Events after which a run is given up, reported as failed."""

TOLERANCE = 1e-10
"""Largest last term of the tilt's series in a step [rad]."""

LISTED_EVENTS = 4096
"""Events that there is room for at first; a run with more is run again with room for all."""


@dataclass(frozen=True, slots=True)
class TracedEvent:
    """An event in numbers."""

    time: float
    kind: int
    mode: int
    tilt: float
    tilt_rate: float
    slide: float
    slide_rate: float


@dataclass(frozen=True, slots=True, eq=False)
class Traced:
    """A run in numbers: the kinds, modes and outcomes by their place in the user's lists."""

    outcome: int
    end: float
    peak_slide: float
    peak_tilt: float
    slide: float
    tilt: float
    floor_impacts: int
    wall_impacts: int
    steps: int
    history: NDArray[np.float64]
    events: tuple[TracedEvent, ...]


def extremes(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the smallest and largest value over blocks of segments, so that rest can be skipped."""
    blocks = max(1, -(-(len(values) - 1) // BLOCK))
    low, high = np.empty(blocks), np.empty(blocks)
    block_extremes(values, low, high)
    return low, high


@dataclass(frozen=True, slots=True, eq=False)
class Shaking:
    """A motion as the compiled code reads it, for one contact law."""

    along: NDArray[np.float64]
    up: NDArray[np.float64]
    dt: float
    law: int
    bounds: tuple[NDArray[np.float64], ...]


def shaking(along: NDArray[np.float64], up: NDArray[np.float64] | None, dt: float, law: int) -> Shaking:
    """Prepare a motion: once for all cases under it.

    Parameters
    ----------
    along, up : ndarray of float64, shape [n]
        Acceleration of the floor, + right and + up [m/s²]; without ``up`` there is no vertical one.
    dt : float
        Time between samples [s].
    law : int
        0 for "coulomb", 1 for "paper", whose rules know no vertical motion.
    """
    along = np.array(along, np.float64)  # copied: compiled code is for writable arrays
    up = np.zeros(len(along)) if up is None or law == 1 else np.array(up, np.float64)
    return Shaking(along, up, dt, law, (*extremes(along), *extremes(up)))


def traced_events(listed: NDArray[np.float64]) -> tuple[TracedEvent, ...]:
    """Return listed events, one row each, as values."""
    return tuple(
        TracedEvent(float(row[0]), int(row[1]), int(row[2]), *(float(value) for value in row[3:]))
        for row in listed
    )


def _room_for_contacts() -> tuple[NDArray[np.void], NDArray[np.void]]:
    return np.zeros(col.CONTACTS, col.CONTACT), np.zeros(col.CONTACTS, col.ROW)


def trace(
    case: np.void,
    motion: Shaking,
    *,
    tolerance: float = TOLERANCE,
    max_step: float = np.inf,
) -> Traced:
    """Run one case and keep its history and events.

    Parameters
    ----------
    case : CASE record
        The case.
    motion : Shaking
        How the floor moves, and the contact law.
    tolerance, max_step : float
        Largest last term of the series in a step [rad], longest step [s].
    """
    cases = np.array([case])
    loads = motion.along, motion.up, motion.dt, motion.bounds, motion.law
    room = *_room_for_contacts(), np.zeros(1, col.STATE)
    history = np.zeros((len(motion.along), col.HISTORY))
    listed = np.zeros((LISTED_EVENTS, col.EVENT))
    results = np.zeros(1, col.RESULT)
    while True:
        run_batch(cases, *loads, tolerance, max_step, MAX_EVENTS, *room, history, listed, results)
        if results["events"][0] <= len(listed):
            break
        listed = np.zeros((results["events"][0], col.EVENT))
        history[:] = 0.0
    return traced(results[0], history, listed)


def traced(result: np.void, history: NDArray[np.float64], listed: NDArray[np.float64]) -> Traced:
    """Return a run in numbers, from its row of results, its history and its list of events."""
    reached = int(history[:, col.H_REACHED].sum())
    return Traced(
        outcome=int(result["outcome"]),
        end=float(result["end"]),
        peak_slide=float(result["peak_slide"]),
        peak_tilt=float(result["peak_tilt"]),
        slide=float(result["residual_slide"]),
        tilt=float(result["residual_tilt"]),
        floor_impacts=int(result["floor_impacts"]),
        wall_impacts=int(result["wall_impacts"]),
        steps=int(result["steps"]),
        history=history[:reached],
        events=traced_events(listed[: int(result["events"])]),
    )


def run_cases(
    cases: NDArray[np.void],
    motion: Shaking,
    *,
    tolerance: float = TOLERANCE,
    max_step: float = np.inf,
    max_events: int = MAX_EVENTS,
) -> NDArray[np.void]:
    """Run a column of cases under one motion on this thread; return a column of `columns.RESULT`.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    motion, tolerance, max_step
        As for `trace`.
    max_events : int
        Events after which a case is given up.
    """
    loads = motion.along, motion.up, motion.dt, motion.bounds, motion.law
    results = np.zeros(len(cases), col.RESULT)
    nothing = np.zeros((0, col.HISTORY)), np.zeros((0, col.EVENT))
    room = _room_for_contacts()
    states = np.zeros(1, col.STATE)
    run_batch(cases, *loads, tolerance, max_step, max_events, *room, states, *nothing, results)
    return results
