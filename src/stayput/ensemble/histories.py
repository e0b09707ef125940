"""Histories of every case of a grid, for grids that are small enough to keep them."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.ensemble.tasks import cores, groups_of, prepared
from stayput.errors import InputError
from stayput.mechanics import columns as col
from stayput.mechanics.runner import trace

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.ensemble.grid import Grid

HISTORIES: dict[str, tuple[int, str, str]] = {
    "slide": (col.H_SLIDE, "m", "displacement of the base relative to the floor, + right"),
    "slide_rate": (col.H_SLIDE_RATE, "m/s", "rate of the slide"),
    "tilt": (col.H_TILT, "rad", "rotation, + clockwise"),
    "tilt_rate": (col.H_TILT_RATE, "rad/s", "rate of the tilt"),
    "x": (col.H_X, "m", "centre of gravity right of where the middle of the base stood"),
    "z": (col.H_Z, "m", "centre of gravity above the floor"),
}
"""Histories by name: their column in the mechanics, unit and meaning."""

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
        found = trace(part.rows()[0], shakings[int(part.group()[0])]).history
        for name in names:
            kept[name][place, : len(found)] = found[:, HISTORIES[name][0]]

    with ThreadPoolExecutor(cores() if threads is None else threads) as pool:
        list(pool.map(run, range(len(grid))))
    shape = (*grid.shape, samples)
    return np.arange(samples, dtype=np.float64) * steps[0], {
        name: (values.reshape(shape), {"units": HISTORIES[name][1], "long_name": HISTORIES[name][2]})
        for name, values in kept.items()
    }
