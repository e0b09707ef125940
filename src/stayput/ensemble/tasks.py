"""The work of an ensemble, in pieces of some cases each; threads here, or whoever is given."""

from __future__ import annotations

import os
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.ensemble.columns import run_rows
from stayput.ensemble.grid import LAW, MOTION
from stayput.ensemble.results import KEPT, kept
from stayput.errors import within
from stayput.mechanics.runner import Shaking, shaking

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from numpy.typing import NDArray

    from stayput.ensemble.grid import Grid, Part
    from stayput.motion import Motion

Shakings: TypeAlias = "dict[int, Shaking]"


def prepared(motions: tuple[Motion, ...], groups: set[int]) -> Shakings:
    """Prepare the motions that are met, for the law of each `Part.group`."""
    return {
        group: shaking(motions[group // 2].x, motions[group // 2].z, motions[group // 2].dt, group % 2)
        for group in sorted(groups)
    }


def run_part(part: Part, shakings: Shakings) -> NDArray[np.void]:
    """Run some cases on this thread; return rows of `KEPT`, in their order."""
    (rows, elements), group = part.held(), part.group()
    results = np.zeros(part.count, KEPT)
    for number in np.unique(group):
        mine = np.flatnonzero(group == number)
        found = run_rows(rows[mine], elements[mine], shakings[int(number)])
        results[mine] = kept(elements[mine], *found)
    return results


def pieces(count: int, chunk: int) -> Iterator[tuple[int, int]]:
    """Split ``count`` cases into pieces: first and last but one of each."""
    for start in range(0, count, chunk):
        yield start, min(start + chunk, count)


def groups_of(grid: Grid) -> set[int]:
    """Return all groups of a grid's cases, without going through the cases."""
    laws = [values for axis in grid.axes for path, values in axis.columns.items() if path == LAW]
    motions = [values for axis in grid.axes for path, values in axis.columns.items() if path == MOTION]
    numbers = {int(n) for values in motions for n in values} or {int(grid.base[MOTION])}
    kinds = {int(n) for values in laws for n in values} or {int(grid.base[LAW])}
    return {2 * number + kind for number in numbers for kind in kinds}


def cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def thread_count(threads: int | None) -> int:
    """Return the number of threads asked for, or one for each core; raise `InputError` where it is none."""
    return cores() if threads is None else int(within("Threads", threads, 1, 4096))


def run_on_threads(
    grid: Grid, chunk: int, threads: int, done: Callable[[int, NDArray[np.void]], None]
) -> None:
    """Run all cases over threads; ``done(start, results)`` is called on this thread, in any order.

    A few pieces are under way at a time, so memory does not grow with the number of cases. On an exception,
    Ctrl-C among them, pieces not begun are dropped and those under way, a moment's work, are waited for.
    """
    shakings = prepared(grid.motions, groups_of(grid))
    todo = pieces(len(grid), chunk)
    under_way: dict[Future[NDArray[np.void]], int] = {}

    def run(start: int, stop: int) -> NDArray[np.void]:
        return run_part(grid.part(start, stop), shakings)

    with ThreadPoolExecutor(threads) as pool:
        try:
            while True:
                while len(under_way) < 2 * threads and (piece := next(todo, None)) is not None:
                    under_way[pool.submit(run, *piece)] = piece[0]
                if not under_way:
                    return
                for future in wait(under_way, return_when=FIRST_COMPLETED).done:
                    done(under_way.pop(future), future.result())
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
