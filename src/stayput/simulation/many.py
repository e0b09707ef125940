"""Many cases on threads or any executor: `simulate_many`, grids, `sweep`, rows of cases and devices."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any, TypeAlias, TypedDict, Unpack

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError, instance_of, list_of, too_many, whole_within, word_of
from stayput.execution import Pool, Shared
from stayput.mechanics.columns import RESULT
from stayput.mechanics.devices.columns import DEVICE, ELEMENT, NONE
from stayput.mechanics.runner import Shaking, run_cases, run_cases_with_devices, shaking, trace
from stayput.model.flat_fields import unit_of
from stayput.progress import bar
from stayput.simulation.grid import LAW, MOTION, Axes, CaseBlock, Grid, make_grid
from stayput.simulation.outcome import CASE_RESULT, HISTORIES, QUANTITIES, case_results, columns_of

if TYPE_CHECKING:
    import xarray as xr

    from stayput.motion.record import Motion
    from stayput.simulation.case import Case


MOST_NUMBERS = 2**27
"""Most numbers in all histories together: 1 GiB."""


class RunOptions(TypedDict, total=False):
    """How cases are run; see `stayput.simulate_many`."""

    threads: int | None
    executor: Executor | None
    chunk: int | None
    progress: bool | None


class SweepOptions(RunOptions, total=False):
    """Options of a sweep; see `stayput.sweep`."""

    histories: Sequence[str]


def sweep_case(
    case: Case, axes: Axes, *, histories: Sequence[str] = (), **options: Unpack[RunOptions]
) -> xr.Dataset:
    """Simulate a case along axes; see `stayput.sweep`."""
    grid = make_grid(case, axes)
    wanted = list_of("histories", histories, str)
    times, traced = _histories(grid, wanted, options.get("threads")) if wanted else (None, {})
    columns = run_grid(grid, **options)
    data = _frame(grid, case)
    dims = [axis.name for axis in grid.axes]
    for column in QUANTITIES:
        data[column.name] = (dims, columns[column.name].reshape(grid.shape), column.attributes)
    if times is not None:
        data = data.assign_coords(time=("time", times, {"units": "s"}))
        for name, (values, attributes) in traced.items():
            data[name] = ((*dims, "time"), values, attributes)
    return data


def _frame(grid: Grid, case: Case) -> xr.Dataset:
    """Return the dataset with its coordinates, and no data yet."""
    import xarray as xr  # which takes its time to load

    coordinates = {
        path: (axis.name, np.asarray(labels), {"units": unit} if (unit := unit_of(path)) else {})
        for axis in grid.axes
        for path, labels in axis.labels.items()
    }
    return xr.Dataset(coords=coordinates, attrs={"contact": case.contact, "motion": case.motion.name})


def _histories(
    grid: Grid, names: tuple[str, ...], threads: int | None
) -> tuple[NDArray[np.float64], dict[str, tuple[NDArray[np.float64], dict[str, Any]]]]:
    """Return the times [s], and by name the values over the grid's axes and time, with their attributes.

    Values after the end of a case are NaN.

    Raises
    ------
    InputError
        An unknown name, motions of different time steps, or more numbers than `MOST_NUMBERS`.
    """
    for name in names:
        word_of("simulation.history", name, HISTORIES, "histories")
    if grid.dimensions == 3:
        raise InputError("simulation.histories_in_space", "histories")
    motions = prepared_motions(grid.motions, groups_of(grid), 2)
    steps = sorted({motion.floor.dt for motion in motions.values()})
    if len(steps) > 1:
        raise InputError("simulation.time_steps_differ", "motion", steps=steps)
    samples = max(len(motion.floor.ax) for motion in motions.values())
    numbers = len(grid) * samples * len(names)
    if numbers > MOST_NUMBERS:
        raise too_many("histories", numbers, "common.numbers_in", MOST_NUMBERS, "histories")
    tables = {name: np.full((len(grid), samples), np.nan) for name in names}

    def run(place: int) -> None:
        block = grid.block(place, place + 1)
        (cases, elements), motion = block.held(), motions[int(block.group()[0])]
        history = trace(cases[0], motion, elements[0]).history
        for name in names:
            tables[name][place, : len(history)] = history[:, HISTORIES[name][0]]

    with Pool(threads) as pool:
        for _ in pool.as_completed(partial(run, place) for place in range(len(grid))):
            pass
    shape = (*grid.shape, samples)
    return np.arange(samples, dtype=np.float64) * steps[0], {
        name: (values.reshape(shape), {"units": HISTORIES[name][1], "long_name": HISTORIES[name][2]})
        for name, values in tables.items()
    }


CHUNK = 64
"""Most cases in a call of the executor: cases with devices take a millisecond or so each."""


def run_rows(
    cases: NDArray[np.void], elements: NDArray[np.void], motion: Shaking
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases in the plane under one motion on this thread; those without devices run as free bodies do.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    elements : ndarray of ELEMENT, shape [m, n]
    motion : Shaking

    Returns
    -------
    tuple
        RESULT, shape [m], and DEVICE, shape [m, n].
    """
    if (elements["kind"] != NONE).any():
        return run_cases_with_devices(cases, elements, motion)
    devices = np.zeros(elements.shape, DEVICE)
    devices["failure_time"] = np.nan
    return run_cases(cases, motion), devices


@lru_cache(maxsize=128)
def plane_shaking(motion: Motion, law: int = 0) -> Shaking:
    """Return a motion as the mechanics in the plane read it, with the number of a contact law."""
    return shaking(motion.x, motion.z, motion.dt, law)


def run_columns(
    cases: NDArray[np.void],
    elements: NDArray[np.void] | None,
    motions: Sequence[Motion],
    motion: NDArray[np.int64],
    *,
    threads: int | None = None,
    on_progress: Callable[[int], None] | None = None,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases in the plane on threads, each with its own devices and motion, under the "coulomb" law.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
        The cases, as `stayput.model.flat_fields.case_columns` makes them of a body and a room with
        measures in place.
    elements : ndarray of ELEMENT, shape [m, n], or None
        Their devices, as `stayput.measures.element_rows` makes them, filled up with elements of kind NONE.
    motions : sequence of Motion
        The motions; each is prepared once.
    motion : ndarray of int, shape [m]
        Index of each case's motion.
    threads : int, optional
        Threads; default one for each core that this process may use.
    on_progress : callable, optional
        Called on this thread with the number of cases just done; an exception that it raises stops the work.

    Returns
    -------
    tuple
        RESULT, shape [m], and DEVICE, shape [m, n] (`stayput.mechanics`); the bits do not depend on the
        threads. Forces are per unit mass; `stayput.simulation.outcome.case_results` sums the devices up.

    Raises
    ------
    InputError
        Elements that are not possible.
    """
    rows = np.zeros((len(cases), 0), ELEMENT) if elements is None else elements
    used: list[int] = np.unique(motion).tolist()
    prepared = {number: plane_shaking(motions[number]) for number in used}
    results, devices = np.zeros(len(cases), RESULT), np.zeros(rows.shape, DEVICE)

    def run(chunk: NDArray[np.intp]) -> int:
        starts = np.flatnonzero(np.diff(motion[chunk])) + 1
        for group in np.split(chunk, starts):
            shaken = prepared[int(motion[group[0]])]
            results[group], devices[group] = run_rows(cases[group], rows[group], shaken)
        return len(chunk)

    with Pool(threads) as pool:
        by_motion = np.argsort(motion, kind="stable")
        chunks = (by_motion[start : start + CHUNK] for start in range(0, len(cases), CHUNK))
        for _, done in pool.as_completed(partial(run, chunk) for chunk in chunks):
            if on_progress is not None:
                on_progress(done)
    return results, devices


PreparedMotions: TypeAlias = "dict[int, Any]"
"""Motions as the mechanics in the plane or in space read them, by the groups of `CaseBlock.group`."""

LARGEST_CHUNK = 2048
"""Most cases in a call of the executor by default: some tens of milliseconds."""


def simulate_many(
    case: Case,
    columns: Mapping[str, Any],
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    chunk: int | None = None,
    progress: bool | None = None,
) -> dict[str, NDArray[Any]]:
    """Simulate columns of cases: the n-th case has the n-th value of each column.

    Parameters
    ----------
    case : Case
        The base case: what no column changes.
    columns : mapping of str to array_like, shape (n,)
        Values by path, such as ``body.width``, ``room.right_wall.gap``, ``motion.scale``; also ``motion``
        (of `Motion`, of any lengths and steps), ``contact``, ``body``, ``room`` and its parts (of objects).
        A table of pandas will do.
    threads : int, optional
        Threads; default one for each core that this process may use.
    executor : concurrent.futures.Executor, optional
        Runs the cases instead, on processes or on the machines of a cluster; Dask's is
        ``client.get_executor()``. Then `threads` is how many calls it computes at a time, by default 128.
    chunk : int, optional
        Cases that a thread runs at a time; by default up to 2048.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.

    Returns
    -------
    dict of str to ndarray, shape (n,)
        The columns of `stayput.simulation.outcome.QUANTITIES`; they do not depend on threads,
        executor or chunk.

    Raises
    ------
    InputError
        An unknown path, columns of different lengths, a case that is not possible, or an executor
        that is lost.

    Examples
    --------
    >>> import pandas as pd
    >>> import stayput as sp
    >>> pieces = pd.DataFrame({"body.width": [0.5, 0.4, 0.3], "body.height": [0.7, 1.2, 1.8]})
    >>> case = sp.Case(sp.Body(0.4, 1.8, 100.0), sp.Room(), sp.near_fault())
    >>> results = pd.DataFrame(sp.simulate_many(case, pieces))  # a row for each piece
    >>> results[["overturned", "peak_slide", "floor_impacts"]].round(2)
       overturned  peak_slide  floor_impacts
    0       False        0.17              0
    1       False        0.14             55
    2        True        0.03              1
    """
    if not hasattr(columns, "keys"):  # which a table of pandas has, too
        instance_of("columns", columns, Mapping)
    names = tuple(columns)
    grid = make_grid(case, {names: tuple(columns[name] for name in names)})
    return run_grid(grid, threads=threads, executor=executor, chunk=chunk, progress=progress)


def run_grid(
    grid: Grid,
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    chunk: int | None = None,
    progress: bool | None = None,
) -> dict[str, NDArray[np.generic]]:
    """Run a grid's cases; return the columns of results, in the grid's order. See `simulate_many`."""
    count = len(grid)
    rows = np.zeros(count, CASE_RESULT)
    motions = Shared(prepared_motions, grid.motions, groups_of(grid), grid.dimensions)
    with Pool(threads, executor) as pool, bar(count, "progress.simulating", progress) as advance:
        if chunk is None:
            # At least eight for each thread, so that all threads end at about the same time.
            chunk = min(LARGEST_CHUNK, -(-count // (8 * pool.width)))
        size = whole_within("simulation.chunk", chunk, 1, 10**9, "cases", "chunk")
        starts = range(0, count, size)

        def run(start: int) -> NDArray[np.void]:
            return run_block(grid.block(start, min(start + size, count)), motions)

        def call(start: int) -> Callable[[], NDArray[np.void]]:
            if executor is None:
                return partial(run, start)  # the block is made on its thread
            return partial(run_block, grid.block(start, min(start + size, count)), motions)

        for number, results in pool.as_completed(map(call, starts)):
            rows[starts[number] : starts[number] + len(results)] = results
            advance(len(results))
    return columns_of(rows)


def run_block(block: CaseBlock, motions: Shared[PreparedMotions]) -> NDArray[np.void]:
    """Run some cases on this thread; return rows of `CASE_RESULT`, in their order."""
    results, groups = np.zeros(block.count, CASE_RESULT), block.group()
    if block.dimensions == 3:
        from stayput.simulation.space import run_case  # SciPy takes its time to load

        for place, group in enumerate(groups.tolist()):
            results[place] = run_case(block.numbers(place), block.measures, motions.value[group])[0]
        return results
    rows, elements = block.held()
    for group in np.unique(groups):
        chosen = np.flatnonzero(groups == group)
        outcome = run_rows(rows[chosen], elements[chosen], motions.value[int(group)])
        results[chosen] = case_results(elements[chosen], *outcome)
    return results


def prepared_motions(motions: tuple[Motion, ...], groups: set[int], dimensions: int) -> PreparedMotions:
    """Prepare the motions that are used, for the engine and the contact law of each group."""
    if dimensions == 3:
        from stayput.simulation.space_engine import SpaceShaking

        return {group: SpaceShaking.of(motions[group // 2]) for group in sorted(groups)}
    return {group: plane_shaking(motions[group // 2], group % 2) for group in sorted(groups)}


def groups_of(grid: Grid) -> set[int]:
    """Return all groups of a grid's cases, from its axes alone: a grid may have millions of cases."""
    laws = [values for axis in grid.axes for path, values in axis.columns.items() if path == LAW]
    motions = [values for axis in grid.axes for path, values in axis.columns.items() if path == MOTION]
    numbers = {int(n) for values in motions for n in values} or {int(grid.base[MOTION])}
    kinds = {int(n) for values in laws for n in values} or {int(grid.base[LAW])}
    return {2 * number + kind for number in numbers for kind in kinds}
