"""Python interface of the compiled solver: one case with its history, or a batch of cases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from stayput.mechanics import columns as col
from stayput.mechanics.devices.columns import FORCES
from stayput.mechanics.engine import run_batch
from stayput.mechanics.flat import BLOCK, block_extremes
from stayput.mechanics.records import BatchDevices, Excitation, Output, Scratch, SolverSettings

if TYPE_CHECKING:
    from numpy.typing import NDArray

MAX_EVENTS = 1_000_000
"""Events after which a run is stopped and reported as failed."""

TOLERANCE = 1e-10
"""Largest last term of the tilt's Taylor series in a step [rad]."""

DEVICE_TOLERANCE = 1e-7
"""Largest error of a step with devices [m, rad]."""


@dataclass(frozen=True, slots=True)
class TracedEvent:
    """One event as returned by the solver, its kind and mode as integer codes."""

    time: float
    kind: int
    mode: int
    tilt: float
    tilt_rate: float
    slide: float
    slide_rate: float


@dataclass(frozen=True, slots=True, eq=False)
class Traced:
    """A run as returned by the solver: modes, event kinds and outcome as integer codes (see `columns`).

    ``history`` has shape [samples, HISTORY], ``listed`` one row per event, shape [events, EVENT].
    """

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
    listed: NDArray[np.float64]

    @property
    def events(self) -> tuple[TracedEvent, ...]:
        """The events as objects."""
        return tuple(
            TracedEvent(time, int(kind), int(mode), *state)
            for time, kind, mode, *state in self.listed.tolist()
        )


def extremes(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return minimum and maximum over blocks of the record, by which rest is skipped."""
    blocks = max(1, -(-(len(values) - 1) // BLOCK))
    low, high = np.empty(blocks), np.empty(blocks)
    block_extremes(values, low, high)
    return low, high


@dataclass(frozen=True, slots=True, eq=False)
class Shaking:
    """A motion prepared for the solver, for one contact law."""

    floor: Excitation
    law: int


def shaking(along: NDArray[np.float64], up: NDArray[np.float64] | None, dt: float, law: int) -> Shaking:
    """Prepare a motion for the solver, once for all cases under it.

    Parameters
    ----------
    along, up : ndarray of float64, shape [n]
        Acceleration of the floor, + right and + up [m/s²]; without ``up`` there is no vertical one.
    dt : float
        Time between samples [s].
    law : int
        0 for "coulomb", 1 for "paper", whose rules have no vertical motion.
    """
    along = np.array(along, np.float64)  # copied: compiled code is for writable arrays
    up = np.zeros(len(along)) if up is None or law == 1 else np.array(up, np.float64)
    return Shaking(Excitation(along, up, dt, (*extremes(along), *extremes(up))), law)


class BatchArguments(NamedTuple):
    """The arguments of `engine.run_batch`."""

    cases: NDArray[np.void]
    held: BatchDevices | None
    motion: Excitation
    settings: SolverSettings
    scratch: Scratch
    states: NDArray[np.void]
    output: Output
    results: NDArray[np.void]


def arguments(
    cases: NDArray[np.void],
    held: BatchDevices | None,
    motion: Shaking,
    *,
    tolerance: float = TOLERANCE,
    error: float = DEVICE_TOLERANCE,
    max_step: float = np.inf,
    max_events: int = MAX_EVENTS,
    records: bool = False,
) -> BatchArguments:
    """Return what `engine.run_batch` takes.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
        The cases; a single one where ``records`` are kept.
    held : BatchDevices or None
        Their devices, whose results are written into it.
    motion : Shaking
        How the floor moves, and the contact law.
    tolerance : float
        Largest last term of the tilt's Taylor series in a step [rad].
    error : float
        Largest error of a step with devices [m, rad].
    max_step : float
        Longest step [s].
    max_events : int
        Events after which a case is stopped and reported as failed.
    records : bool
        Whether history, forces and events are kept.
    """
    samples, listed = (len(motion.floor.ax), MAX_EVENTS) if records else (0, 0)
    devices = 0 if held is None else len(held.links)
    return BatchArguments(
        cases=cases,
        held=held,
        motion=motion.floor,
        settings=SolverSettings(motion.law, tolerance, error, max_step, max_events),
        scratch=Scratch(np.zeros(col.CONTACTS, col.CONTACT), np.zeros(col.CONTACTS, col.ROW)),
        states=np.zeros(1, col.STATE),
        output=Output(
            history=np.zeros((samples, col.HISTORY)),
            forces=np.zeros((samples, devices, FORCES)),
            events=np.zeros((listed, col.EVENT)),  # pages that are not written take no memory
        ),
        results=np.zeros(len(cases), col.RESULT),
    )


def solve(
    cases: NDArray[np.void], held: BatchDevices | None, motion: Shaking, **settings: Any
) -> tuple[NDArray[np.void], Output]:
    """Run cases under one motion on this thread; arguments as for `arguments`.

    Returns
    -------
    tuple
        A column of `columns.RESULT`, and what was recorded.
    """
    batch = arguments(cases, held, motion, **settings)
    run_batch(*batch)
    return batch.results, batch.output


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
    results, output = solve(
        np.array([case]), None, motion, tolerance=tolerance, max_step=max_step, records=True
    )
    return traced(results[0], output)


def traced(result: np.void, output: Output) -> Traced:
    """Assemble a run from its row of results and what was recorded, without internal events."""
    reached = int(output.history[:, col.H_REACHED].sum())
    listed = output.events[: result["events"]]
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
        history=output.history[:reached],
        listed=listed[listed[:, col.E_KIND] != col.INTERNAL_EVENT],  # a view would keep the whole buffer
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
        Events after which a case is stopped and reported as failed.
    """
    return solve(cases, None, motion, tolerance=tolerance, max_step=max_step, max_events=max_events)[0]
