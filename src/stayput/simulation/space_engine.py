"""A run of the engine in space, from its records to its histories."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from stayput.mechanics.devices.columns import DEVICE, FORCES
from stayput.mechanics.space.columns import HISTORY, HIT, POSE, PULL
from stayput.mechanics.space.engine import MOST_WORK, run_in_space
from stayput.simulation.space_devices import longest_step
from stayput.simulation.space_gaps import Gaps, gaps_of, refuse_overlaps
from stayput.simulation.space_records import scratch_of

if TYPE_CHECKING:
    from collections.abc import Generator

    from numpy.typing import NDArray

STEP = 1e-3
"""Longest step [s]."""

MOST_HITS = 10_000
"""Most hits that are listed."""


_STOP: ContextVar[Stop | None] = ContextVar("stop", default=None)


class Stop(threading.Event):
    """Ends runs of another thread once it is set: they are given up at the next sample."""

    def __init__(self) -> None:
        super().__init__()
        self._works: list[NDArray[np.float64]] = []

    def set(self) -> None:
        """End the runs, and those that are still to come."""
        super().set()
        for work in self._works:
            work[2] = np.inf

    def watch(self, work: NDArray[np.float64]) -> None:
        """Let a run that begins be ended: by its work, at which the engine looks."""
        self._works.append(work)
        if self.is_set():
            self.set()

    @contextmanager
    def ending_runs(self) -> Generator[None]:
        """End the runs of this thread within the block."""
        token = _STOP.set(self)
        try:
            yield
        finally:
            _STOP.reset(token)


class SpaceTrace(NamedTuple):
    """What the engine returns.

    Parameters
    ----------
    place : ndarray, shape (bodies, samples, 3)
        Of the centres of gravity [m].
    attitude : ndarray, shape (bodies, samples, 4)
        Unit quaternions that turn the bodies' principal axes into the room's.
    velocity, rotation_rate : ndarray, shape (bodies, samples, 3)
        In the room's axes [m/s, rad/s].
    pressing : ndarray, shape (bodies, samples, 2, 3)
        What pressed on the bodies in the step before: the room, and other bodies [N].
    forces : ndarray, shape (samples, devices, 2)
        Of the devices, along the normal and the plane [N].
    springs : ndarray of SPRING, shape (devices,)
        The devices.
    devices : ndarray of DEVICE, shape (devices,)
        What became of them; forces in newtons.
    hits : ndarray of HIT
        The first hits.
    hit_numbers : ndarray of int64, shape (bodies + 1, 3)
        Hits of each body on floor, walls and ceiling, and other bodies; in the last row of all.
    peak_tilt : ndarray, shape (bodies,)
        Largest tilt at any step [rad].
    gaps : tuple of Gaps
        At first and at the end.
    steps, unconverged : int
        Steps, and those whose contact forces did not converge.
    given_up : bool
        Whether it took too much work: bodies stay where they were then.
    """

    place: NDArray[np.float64]
    attitude: NDArray[np.float64]
    velocity: NDArray[np.float64]
    rotation_rate: NDArray[np.float64]
    pressing: NDArray[np.float64]
    forces: NDArray[np.float64]
    springs: NDArray[np.void]
    devices: NDArray[np.void]
    hits: NDArray[np.void]
    hit_numbers: NDArray[np.int64]
    peak_tilt: NDArray[np.float64]
    gaps: tuple[Gaps, Gaps]
    steps: int
    unconverged: int
    given_up: bool


def run_world(
    world: tuple[Any, ...],
    poses: NDArray[np.void],
    springs: NDArray[np.void],
    acceleration: NDArray[np.float64],
    dt: float,
    step: float,
    gravity: float,
) -> SpaceTrace:
    """Run bodies in a room.

    Parameters
    ----------
    world : tuple
        Bodies and room, from `world_of`.
    poses : ndarray of POSE, shape (bodies,)
        Where the bodies are at first.
    springs : ndarray of SPRING
        What holds them.
    acceleration : ndarray, shape (samples, 3)
        Of the floor [m/s²].
    dt, step : float
        Time between samples, and longest step [s].
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        Bodies that begin inside each other, the floor or the ceiling.
    """
    bodies, samples = len(poses), len(acceleration)
    both = np.zeros((2, bodies), POSE)
    both[0] = poses
    held = springs, np.zeros(len(springs), PULL), np.zeros(len(springs), DEVICE)
    held[2]["failure_time"] = np.nan
    histories = np.zeros((bodies, samples, len(HISTORY)))
    forces, hits = np.zeros((samples, len(springs), FORCES)), np.zeros(MOST_HITS, HIT)
    numbers, peaks, work = np.zeros((bodies + 1, 3), np.int64), np.zeros(bodies), np.zeros(3)
    if (stop := _STOP.get()) is not None:
        stop.watch(work)
    output = histories, forces, hits, numbers, peaks, work
    times = np.array([dt, longest_step(springs, world[0], step), gravity])
    scratch = scratch_of(world, len(springs))
    run_in_space(world, held, both, acceleration[:1], times, scratch, output)  # notes gaps, takes no step
    first = gaps_of(world, scratch[2][0])
    refuse_overlaps(world[3], first)
    run_in_space(world, held, both, acceleration, times, scratch, output)
    return SpaceTrace(
        histories[..., 0:3],
        histories[..., 3:7],
        histories[..., 7:10],
        histories[..., 10:13],
        histories[..., 13:19].reshape(bodies, samples, 2, 3),
        forces,
        springs,
        held[2],
        hits[: min(len(hits), numbers[-1, 0])].copy(),
        numbers,
        2.0 * np.arcsin(np.sqrt(0.5 * peaks)),
        (first, gaps_of(world, scratch[2][0])),
        int(work[0]),
        int(work[1]),
        bool(work[2] > MOST_WORK),
    )
