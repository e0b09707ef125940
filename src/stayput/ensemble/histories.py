"""Histories of every case of a grid, for grids that are small enough to keep them."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.ensemble.tasks import groups_of, prepared, thread_count
from stayput.errors import InputError
from stayput.mechanics import columns as col
from stayput.quantities import HISTORIES
from stayput.simulation import trace_held

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.ensemble.grid import Grid

COLUMNS = {
    "slide": col.H_SLIDE,
    "slide_rate": col.H_SLIDE_RATE,
    "tilt": col.H_TILT,
    "tilt_rate": col.H_TILT_RATE,
    "x": col.H_X,
    "z": col.H_Z,
}
"""Columns of the histories in the mechanics."""

MOST = 2**27
"""Numbers that histories may have in all: 1 GiB."""


def histories_of(
    grid: Grid, names: tuple[str, ...], threads: int | None
) -> tuple[NDArray[np.float64], dict[str, tuple[NDArray[np.float64], dict[str, Any]]]]:
    """Return times, and histories over the grid's axes and time, NaN after a case's end, with attributes.

    Raises
    ------
    InputError
        An unknown name, motions of different time steps, or more numbers than `MOST`.
    """
    for name in names:
        if name not in HISTORIES:
            raise InputError(f"History is {name!r}; it must be one of {', '.join(HISTORIES)}.")
    shakings = prepared(grid.motions, groups_of(grid))
    steps = sorted({motion.dt for motion in shakings.values()})
    if len(steps) > 1:
        raise InputError(f"The motions' time steps are {steps} s; histories need motions of one time step.")
    samples = max(len(motion.along) for motion in shakings.values())
    numbers = len(grid) * samples * len(names)
    if numbers > MOST:
        raise InputError(f"The histories have {numbers:,} numbers; they must be no more than {MOST:,}.")
    kept = {name: np.full((len(grid), samples), np.nan) for name in names}

    def run(place: int) -> None:
        part = grid.part(place, place + 1)
        (cases, elements), motion = part.held(), shakings[int(part.group()[0])]
        found = trace_held(cases[0], elements[0], motion)[0].history
        for name in names:
            kept[name][place, : len(found)] = found[:, COLUMNS[name]]

    with ThreadPoolExecutor(thread_count(threads)) as pool:
        list(pool.map(run, range(len(grid))))
    shape = (*grid.shape, samples)
    return np.arange(samples, dtype=np.float64) * steps[0], {
        name: (values.reshape(shape), {"units": HISTORIES[name][0], "long_name": HISTORIES[name][1]})
        for name, values in kept.items()
    }
