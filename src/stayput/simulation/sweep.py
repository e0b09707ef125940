"""A case along axes as a labelled dataset, on request with the histories of every case."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from functools import partial
from typing import TYPE_CHECKING, Any, TypedDict, Unpack

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from stayput.errors import InputError, list_of, too_many, word_of
from stayput.execution import Pool
from stayput.mechanics.runner import trace
from stayput.model.flat_fields import unit_of
from stayput.simulation.grid import Axes, Grid, make_grid
from stayput.simulation.many import groups_of, prepared_motions, run_grid
from stayput.simulation.outcome import HISTORIES, QUANTITIES

if TYPE_CHECKING:
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
