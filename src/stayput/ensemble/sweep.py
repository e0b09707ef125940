"""`sweep`: a case along axes, as a labelled dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from stayput.ensemble.axes import make_grid, unit_of
from stayput.ensemble.histories import histories_of
from stayput.ensemble.many import run_grid
from stayput.ensemble.results import OUTCOMES, QUANTITIES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.ensemble.axes import Axes
    from stayput.ensemble.grid import Grid
    from stayput.simulation import Case


def sweep(
    case: Case,
    axes: Axes,
    *,
    histories: Sequence[str] = (),
    threads: int | None = None,
    client: Any = None,
    chunk: int | None = None,
    progress: bool | None = None,
) -> xr.Dataset:
    """Simulate a case along axes; the result has a dimension for each.

    Parameters
    ----------
    case : Case
        What no axis changes.
    axes : mapping
        Dotted paths and their values: ``{"body.width": [...], "room.right_wall.gap": [...]}``. The cases
        are all combinations. A tuple of paths with a tuple of lists is one axis, along which the values go
        together; its dimension has the name of the first. Paths are those of `simulate_many`.
    histories : sequence of str
        Histories to keep of every case: ``slide``, ``slide_rate``, ``tilt``, ``tilt_rate``, ``x``, ``z``;
        over ``time``, NaN after the end of a case. They need motions of one time step.
    threads, client, chunk, progress
        As for `simulate_many`.

    Returns
    -------
    xarray.Dataset
        Results over the axes, with units and meanings in the attributes; ``outcome`` is a flag whose
        meanings are in its attributes.

    Raises
    ------
    InputError
        As for `simulate_many`, or an unknown history.
    """
    grid = make_grid(case, axes)
    times, kept = histories_of(grid, tuple(histories), threads) if histories else (None, {})
    columns = run_grid(grid, threads=threads, client=client, chunk=chunk, progress=progress)
    data = _frame(grid, case)
    dims = [axis.name for axis in grid.axes]
    for quantity in QUANTITIES:
        attributes: dict[str, Any] = {"long_name": quantity.meaning}
        if quantity.unit:
            attributes["units"] = quantity.unit
        if quantity.name == "outcome":
            attributes |= {"flag_values": np.arange(len(OUTCOMES), dtype=np.int8)}
            attributes |= {"flag_meanings": " ".join(OUTCOMES)}
        data[quantity.name] = (dims, columns[quantity.name].reshape(grid.shape), attributes)
    if times is not None:
        data = data.assign_coords(time=("time", times, {"units": "s"}))
        for name, (values, attributes) in kept.items():
            data[name] = ((*dims, "time"), values, attributes)
    return data


def _frame(grid: Grid, case: Case) -> xr.Dataset:
    """Return the dataset with its coordinates, and no data yet."""
    data = xr.Dataset(attrs={"contact": case.contact, "motion": case.motion.name})
    for axis in grid.axes:
        for path, labels in axis.labels.items():
            unit = unit_of(path)
            data = data.assign_coords(
                {path: (axis.name, np.asarray(labels), {"units": unit} if unit else {})}
            )
    return data
