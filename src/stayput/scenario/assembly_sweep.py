"""Sweeps of several pieces: their scenario along axes of its own keys, as a labelled dataset."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from functools import partial
from itertools import product
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from stayput.errors import InputError, instance_of, list_of
from stayput.execution import Pool
from stayput.measures.results import utilisation
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import HOLDS
from stayput.progress import bar
from stayput.simulation.outcome import OUTCOMES, QUANTITIES
from stayput.simulation.space import trace_assembly
from stayput.simulation.space_case import SpaceShaking, acceleration_of, results_of

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from stayput.scenario.assembly import AssemblyScenario

_PART = re.compile(r"([^\[\]]+)(?:\[(\d+)\])?")
"""A part of a path: a key, and which item of its list; without that, all items."""

OF_PIECES = ("peak_slide", "residual_slide", "peak_tilt", "residual_tilt", "floor_impacts", "wall_impacts")
"""Results of each piece that are columns of `stayput.simulation.outcome`, beside outcome and overturning."""


def sweep_assembly(
    scenario: AssemblyScenario,
    axes: Mapping[str, Any],
    *,
    threads: int | None = None,
    progress: bool | None = None,
) -> xr.Dataset:
    """Simulate several pieces along axes; see `AssemblyScenario.sweep`."""
    import xarray as xr

    instance_of("axes", axes, Mapping)
    lists = {path: list_of(path, values) for path, values in axes.items()}
    for path, values in lists.items():
        if not values:
            raise InputError("simulation.no_values", path, path=path)
    stated = scenario.model_dump(mode="json", exclude_unset=True, exclude_none=True, by_alias=True)
    cases = [
        _changed(scenario, stated, dict(zip(lists, values, strict=True)))
        for values in product(*lists.values())
    ]
    results = np.zeros((len(cases), len(scenario.names)), RESULT)
    failures, used = np.zeros(len(cases), np.int32), np.zeros(len(cases))

    def run(number: int) -> None:
        results[number], failures[number], used[number] = _run(cases[number])

    with bar(len(cases), "progress.simulating", progress) as advance, Pool(threads) as pool:
        for _ in pool.as_completed(partial(run, number) for number in range(len(cases))):
            advance(1)
    shape = tuple(len(values) for values in lists.values())
    dims = (*lists, "piece")
    data = xr.Dataset(
        coords={path: list(values) for path, values in lists.items()} | {"piece": list(scenario.names)}
    )
    about = {column.name: column for column in QUANTITIES}
    overturned = results["outcome"] == OVERTURNED_OUTCOME
    columns = {
        "outcome": results["outcome"],
        "overturned": overturned,
        "overturn_time": np.where(overturned, results["end"], math.nan),
        **{name: results[name] for name in OF_PIECES},
    }
    for name, values in columns.items():
        data[name] = (dims, values.reshape(*shape, -1), _attributes(about[name].meaning, about[name].unit))
    data["outcome"].attrs |= {
        "flag_values": np.arange(len(OUTCOMES), dtype=np.int8),
        "flag_meanings": " ".join(OUTCOMES),
    }
    for name, values in (("device_failures", failures), ("device_utilisation", used)):
        data[name] = (tuple(lists), values.reshape(shape), _attributes(about[name].meaning, about[name].unit))
    return data


def _attributes(meaning: str, unit: str) -> dict[str, str]:
    return {"long_name": meaning} | ({"units": unit} if unit else {})


def _changed(scenario: AssemblyScenario, stated: dict[str, Any], values: dict[str, Any]) -> AssemblyScenario:
    """Return a scenario with other values at paths."""
    data = stated
    for path, value in values.items():
        data = _with(data, path.split("."), value, path)
    return type(scenario).parse(data, scenario.folder)


def _with(node: Any, parts: list[str], value: Any, path: str) -> Any:
    """Return a node with another value at a path below it; the node itself stays as it is."""
    if not parts:
        return value
    found = _PART.fullmatch(parts[0])
    if found is None or not isinstance(node, dict):
        raise InputError("scenario.no_such_path", path, path=path)
    table, (key, place) = cast("dict[str, Any]", node), found.groups()
    below: Any = table.get(key, {} if len(parts) > 1 else None)
    if isinstance(below, list) and (place is not None or len(parts) > 1):
        items = cast("list[Any]", below)
        if place is not None and int(place) >= len(items):
            raise InputError("scenario.no_such_path", path, path=path)
        chosen = range(len(items)) if place is None else (int(place),)
        return {
            **table,
            key: [
                _with(item, parts[1:], value, path) if number in chosen else item
                for number, item in enumerate(items)
            ],
        }
    return {**table, key: _with(below, parts[1:], value, path)}


def _run(scenario: AssemblyScenario) -> tuple[NDArray[np.void], int, float]:
    """Return what became of each piece, how many devices failed, and the largest utilisation."""
    motion = scenario.motion()
    shaking = SpaceShaking(acceleration_of(motion), motion.dt)
    assembly = scenario.assembly()
    with scenario.naming_pieces():
        traced = trace_assembly(assembly, scenario.surroundings(), shaking, scenario.gravity)
    devices = traced.trace.devices
    failed = int((devices["failure"] != HOLDS).sum())
    standing = [one.standing for one in traced.bodies]
    results = results_of(standing, traced.trace, shaking.times)
    return results, failed, float(utilisation(traced.trace.springs, devices).max(initial=0.0))
