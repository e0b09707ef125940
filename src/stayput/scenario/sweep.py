"""`sweep`: a case or a scenario along axes, as a labelled dataset."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from itertools import product
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, word_of
from stayput.execution import Pool
from stayput.measures.element import utilisation
from stayput.mechanics.devices.columns import HOLDS
from stayput.progress import bar
from stayput.scenario.scenario import Scenario
from stayput.scenario.toml import with_value
from stayput.simulation.case import Case
from stayput.simulation.grid import make_grid
from stayput.simulation.many import SweepOptions, run_grid, sweep_case
from stayput.simulation.outcome import QUANTITIES, columns_of
from stayput.simulation.space import results_of, trace_scene
from stayput.simulation.space_engine import SpaceShaking

if TYPE_CHECKING:
    import xarray as xr


ABOUT = {column.name: column for column in QUANTITIES}
OF_A_PIECE = (
    *("outcome", "overturned", "overturn_time", "peak_slide", "residual_slide"),
    *("peak_tilt", "residual_tilt", "floor_impacts", "wall_impacts"),
)
"""Results of each of several pieces."""


def sweep(case: Case | Scenario, axes: Mapping[Any, Any], **options: Unpack[SweepOptions]) -> xr.Dataset:
    """Simulate a case or a scenario along axes; the result has a dimension for each.

    Parameters
    ----------
    case : Case or Scenario
        What no axis changes.
    axes : mapping
        Dotted paths and their values; the cases are all combinations. Of a case they are those of
        `simulate_many`: ``{"body.width": [...], "room.right_wall.gap": [...]}``; a tuple of paths with a
        tuple of lists is one axis, along which the values change together, and its dimension has the name of
        the first. Of a scenario they are keys of its file: ``{"shaking.scale": [...]}``;
        ``joints.strength`` changes all joints, ``joints[0].strength`` one.
    histories : sequence of str
        Histories to keep of every case: ``slide``, ``slide_rate``, ``tilt``, ``tilt_rate``, ``x``, ``z``;
        over ``time``, NaN after the end of a case. They need motions of one time step, and a case.
    threads, executor, chunk, progress
        As for `simulate_many`.

    Returns
    -------
    xarray.Dataset
        Results over the axes, with units and meanings in the attributes; of several pieces also over
        ``piece``. ``outcome`` is a flag whose meanings are in its attributes.

    Raises
    ------
    InputError
        As for `simulate_many`; an unknown history; a key that there is not, or a value that the file may not
        have.

    Examples
    --------
    >>> import stayput as sp
    >>> case = sp.Case(sp.Body(0.4, 1.8, 100.0), sp.Room(), sp.near_fault().component("x"))
    >>> data = sp.sweep(case, {"body.width": [0.3, 0.4, 0.5], "motion.scale": [0.4, 0.6, 1.2]})
    >>> data.overturned.to_pandas()
    motion.scale    0.4    0.6   1.2
    body.width
    0.3            True   True  True
    0.4           False   True  True
    0.5           False  False  True
    """
    instance_of("case", case, (Case, Scenario))
    for name in options:
        word_of("option", name, SweepOptions.__annotations__)
    if isinstance(case, Case):
        return sweep_case(case, axes, **options)
    return _sweep_scenario(case, axes, options)


def _sweep_scenario(scenario: Scenario, axes: Mapping[Any, Any], options: SweepOptions) -> xr.Dataset:
    import xarray as xr

    for name, value in options.items():
        if name not in ("threads", "progress") and (value or value == 0):
            raise InputError("common.left_out", name, where=phrase("scenario.sweep_of_a_case"))
    lists: dict[str, list[Any]] = {}
    instance_of("axes", axes, Mapping)
    for path, values in axes.items():
        if not isinstance(path, str):
            raise InputError("scenario.no_such_path", "axes", path=path)
        lists[path] = [
            value.item() if isinstance(value, np.generic) else value for value in list_of(path, values)
        ]
        if not lists[path]:
            raise InputError("common.empty", path)
    cases = [_changed(scenario, dict(zip(lists, values, strict=True))) for values in product(*lists.values())]
    rows: list[dict[str, NDArray[Any]]] = [{} for _ in cases]

    def run(number: int) -> None:
        rows[number] = _results(cases[number])

    threads, progress = options.get("threads"), options.get("progress")
    with bar(len(cases), "progress.simulating", progress) as advance, Pool(threads) as pool:
        for _ in pool.as_completed(partial(run, number) for number in range(len(cases))):
            advance(1)
    of_pieces = len(scenario.names) > 1
    coords: dict[str, Any] = {
        path: range(len(values)) if any(isinstance(value, list | dict) for value in values) else values
        for path, values in lists.items()
    }
    data = xr.Dataset(coords=coords | ({"piece": [*scenario.names]} if of_pieces else {}))
    shape = tuple(map(len, lists.values()))
    for name in rows[0]:
        by_piece = of_pieces and name in OF_A_PIECE
        values = np.stack([row[name] for row in rows]).reshape((*shape, *(-1,) * by_piece))
        data[name] = ((*lists, *("piece",) * by_piece), values, ABOUT[name].attributes)
    return data


def _changed(scenario: Scenario, values: dict[str, Any]) -> Scenario:
    """Return a scenario with other values at paths, and the same Python objects."""
    kept = scenario.kept()
    for path, value in values.items():
        kept["data"] = with_value(kept["data"], path, value)
    return Scenario.of_kept(kept)


def _results(scenario: Scenario) -> dict[str, NDArray[Any]]:
    """Return what became of each piece, how many devices failed, and the largest utilisation, by column."""
    if scenario.alone:
        return run_grid(make_grid(scenario.case(), {}), threads=1, progress=False)
    shaking, scene = SpaceShaking.of(scenario.motion()), scenario.scene()
    with scenario.naming_keys():
        traced = trace_scene(scene, shaking, scenario.gravity)
    devices, results = traced.trace.devices, results_of(traced, shaking.dt)
    used = utilisation(traced.trace.springs, devices).max(initial=0.0)
    return {
        **columns_of(results, [ABOUT[name] for name in OF_A_PIECE]),
        "device_failures": np.array((devices["failure"] != HOLDS).sum(), np.int32),
        "device_utilisation": np.array(float(used)),
    }
