"""Floors of a building under many motions of the ground, over threads, a few motions at a time."""

from __future__ import annotations

import os
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from stayput.building.histories import component_response, horizontal
from stayput.building.response import floor_motions_of
from stayput.compiled import entry
from stayput.errors import InputError, within

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from numpy.typing import NDArray

    from stayput.building.model import ShearModel
    from stayput.motion.record import Motion

T = TypeVar("T")


@dataclass(frozen=True, slots=True, eq=False)
class FloorPeaks:
    """Peaks of all floors under many motions.

    Parameters
    ----------
    storeys : ndarray, shape (storeys + 1,)
        1, 2, ...; the last is the roof.
    acceleration : ndarray, shape (motions, storeys + 1)
        Largest magnitude of the absolute acceleration [m/s²].
    velocity : ndarray, shape (motions, storeys + 1)
        Largest magnitude of the absolute velocity, between the samples too [m/s].
    """

    storeys: NDArray[np.int64]
    acceleration: NDArray[np.float64]
    velocity: NDArray[np.float64]


@entry
def column_peaks(
    a: NDArray[np.float64], dt: float, v: NDArray[np.float64], peaks: NDArray[np.float64]
) -> None:
    """Find the peaks of accelerations that are linear between samples, and of their integrals.

    Parameters
    ----------
    a : ndarray, shape (n, floors)
        Accelerations [m/s²].
    dt : float
        Time step [s].
    v : ndarray, shape (floors,)
        Room to work in.
    peaks : ndarray, shape (2, floors)
        Filled with the largest magnitudes of acceleration [m/s²] and velocity [m/s].
    """
    for r in range(a.shape[1]):
        v[r], peaks[0, r], peaks[1, r] = 0.0, abs(a[0, r]), 0.0
    for k in range(1, len(a)):
        for r in range(a.shape[1]):
            a0, a1 = a[k - 1, r], a[k, r]
            if a0 * a1 < 0.0:  # the velocity turns in between
                peaks[1, r] = max(peaks[1, r], abs(v[r] + 0.5 * dt * a0 * a0 / (a0 - a1)))
            v[r] += 0.5 * dt * (a0 + a1)
            peaks[0, r] = max(peaks[0, r], abs(a1))
            peaks[1, r] = max(peaks[1, r], abs(v[r]))


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _in_order(work: Callable[[Motion], T], motions: Iterable[Motion], threads: int | None) -> Iterator[T]:
    """Give the results in the motions' order; at most two motions a thread are under way or wait."""
    count = _cores() if threads is None else int(within("Threads", threads, 1, 4096))
    todo = iter(motions)
    with ThreadPoolExecutor(count) as pool:
        try:
            waiting: deque[Future[T]] = deque(pool.submit(work, m) for m in islice(todo, 2 * count))
            while waiting:
                result = waiting.popleft().result()
                waiting.extend(pool.submit(work, m) for m in islice(todo, 1))
                yield result
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def floor_motions(
    model: ShearModel, motions: Iterable[Motion], storeys: Sequence[int], threads: int | None
) -> Iterator[tuple[Motion, ...]]:
    """Give, motion by motion, the floor motions of the wanted storeys."""
    wanted = tuple(storeys)
    for storey in wanted:
        model.place(storey)
    _ = model.modes  # once, not in every thread
    return _in_order(lambda motion: floor_motions_of(model, motion, wanted), motions, threads)


def floor_peaks(
    model: ShearModel, motions: Iterable[Motion], component: str, threads: int | None
) -> FloorPeaks:
    """Return the peaks of all floors under many motions."""
    storeys = range(1, model.storeys + 2)
    _ = model.modes

    def work(motion: Motion) -> NDArray[np.float64]:
        rows = horizontal(motion)
        if component not in rows:
            raise InputError(f"The component is {component!r}; the motion has {', '.join(rows)}.")
        found = component_response(model, rows[component], motion.dt, storeys)
        peaks = np.empty((2, len(storeys)))
        column_peaks(found.acceleration, found.dt, np.empty(len(storeys)), peaks)
        return peaks

    peaks = np.array(list(_in_order(work, motions, threads))).reshape(-1, 2, len(storeys))
    return FloorPeaks(np.array(storeys), peaks[:, 0], peaks[:, 1])
