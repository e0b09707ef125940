"""From the axes that a user gives, dotted paths and their values, to a grid of cases."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, near_miss
from stayput.model.body import Body
from stayput.model.room import WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.motion import Motion
from stayput.simulation.case import Case, law_number
from stayput.simulation.flat_fields import (
    WALLS_AND_CEILING,
    body_fields,
    distance_to,
    flat_fields,
    floor_fields,
    room_fields,
    surface_fields,
)
from stayput.simulation.grid import LAW, MOTION, Axis, Columns, Grid

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray


Axes: TypeAlias = "Mapping[str | tuple[str, ...], Any]"

OBJECT_PATHS: dict[str, tuple[type | tuple[type, ...], Callable[[Any], dict[str, float]]]] = {
    "body": (Body, body_fields),
    "room": (Room, room_fields),
    "room.floor": (Floor, floor_fields),
    **{f"room.{name}": ((Wall, type(None)), partial(surface_fields, name)) for name in WALLS_AROUND},
    "room.ceiling": ((Ceiling, type(None)), partial(surface_fields, "ceiling")),
}
"""Paths whose values are objects: the types of these, and the function that returns an object's numbers."""


def base_numbers(case: Case) -> dict[str, float]:
    """Return a case's numbers by path; its motion is the first in the grid's list of motions."""
    numbers = flat_fields(case.body, case.room, case.initial, case.gravity)
    return {**numbers, MOTION: 0.0, LAW: float(law_number(case.contact))}


def make_grid(case: Case, axes: Axes) -> Grid:
    """Return the grid of all combinations of the axes' values.

    A tuple of paths is one axis, along which their values change together.

    Raises
    ------
    InputError
        An unknown path, a path on two axes, values of the wrong kind, or cases that are not possible.
    """
    base = base_numbers(instance_of("case", case, Case))
    motions: list[Motion] = [case.motion]
    grid_axes: list[Axis] = []
    instance_of("axes", axes, Mapping)
    for paths, values in axes.items():
        names = (paths,) if isinstance(paths, str) else tuple(paths)
        value_lists = (values,) if isinstance(paths, str) else list_of("axes", values)
        if len(names) != len(value_lists) or not names:
            raise InputError("simulation.axis_lists", "axes", names=str(names), count=len(value_lists))
        grid_axes.append(_axis(names, value_lists, base, motions))
    _refuse_repeats(grid_axes)
    _refuse_missing_surfaces(base, grid_axes)
    dimensions = 3 if case.in_space else 2
    grid = Grid(base, tuple(grid_axes), tuple(motions), tuple(case.measures), dimensions)
    grid.refuse_bad_cases()
    return grid


def _axis(
    names: tuple[str, ...], value_lists: tuple[Any, ...], base: dict[str, float], motions: list[Motion]
) -> Axis:
    columns: Columns = {}
    labels: dict[str, Any] = {}
    for name, values in zip(names, value_lists, strict=True):
        added, label = _columns(name, values, base, motions)
        repeated = columns.keys() & added.keys()
        if repeated:
            raise InputError("simulation.path_twice", min(repeated), names=str(names), path=min(repeated))
        columns |= added
        labels[name] = label
    lengths = {name: len(label) for name, label in labels.items()}
    if len(set(lengths.values())) > 1:
        raise InputError("simulation.axis_lengths", names[0], names=str(names), lengths=lengths)
    return Axis(names[0], columns, labels)


def _columns(
    name: str, values: Any, base: dict[str, float], motions: list[Motion]
) -> tuple[Columns, Sequence[Any] | NDArray[Any]]:
    """Return the columns that a path's values change, and the labels of the values.

    Motions are appended to ``motions``, each object once however often it is a value.
    """
    if name in OBJECT_PATHS or name in (MOTION, LAW):
        items = list(list_of(name, values))
        _refuse_empty(name, len(items))
        if name == LAW:
            return {LAW: np.array([law_number(item) for item in items])}, items
        if name == MOTION:
            _refuse_other(name, items, Motion)
            place = {key: len(motions) + n for n, key in enumerate(dict.fromkeys(map(id, items)))}
            motions.extend({id(item): item for item in items}.values())
            return {MOTION: np.array([place[id(item)] for item in items])}, [item.name for item in items]
        kind, numbers_of = OBJECT_PATHS[name]
        _refuse_other(name, items, kind)
        table = [numbers_of(item) for item in items]
        return {path: np.array([row[path] for row in table]) for path in table[0]}, np.arange(len(items))
    if name not in base:
        known = sorted({*base, *OBJECT_PATHS})
        hint = near_miss(name, known)
        raise InputError("simulation.unknown_path", name, path=name, hint=hint, known=", ".join(known))
    try:
        numbers = np.array(values, np.float64)
    except (TypeError, ValueError):
        raise InputError("simulation.values_not_numbers", name, path=name) from None
    if numbers.ndim != 1:
        raise InputError("simulation.values_not_a_list", name, path=name, dimensions=numbers.ndim)
    _refuse_empty(name, len(numbers))
    if not np.isfinite(numbers).all():
        bad = numbers[~np.isfinite(numbers)][0]
        raise InputError("simulation.value_not_finite", name, path=name, value=bad)
    return {name: numbers}, numbers


def _refuse_empty(name: str, count: int) -> None:
    if count == 0:
        raise InputError("simulation.no_values", name, path=name)


def _refuse_other(name: str, items: list[Any], kind: type | tuple[type, ...]) -> None:
    for item in items:
        if not isinstance(item, kind):
            wanted = (kind if isinstance(kind, type) else kind[0]).__name__
            raise InputError("simulation.value_type", name, path=name, value=repr(item), wanted=wanted)


def _refuse_repeats(axes: list[Axis]) -> None:
    seen: set[str] = set()
    for axis in axes:
        repeated = seen & axis.columns.keys()
        if repeated:
            raise InputError("simulation.path_on_two_axes", min(repeated), path=min(repeated))
        seen |= axis.columns.keys()


def _refuse_missing_surfaces(base: dict[str, float], axes: list[Axis]) -> None:
    changed = {path for axis in axes for path in axis.columns}
    for name in WALLS_AND_CEILING:
        distance = distance_to(name)
        touched = [path for path in changed if path.startswith(f"room.{name}.")]
        if touched and distance not in changed and np.isinf(base[distance]):
            raise InputError(
                "simulation.surface_missing",
                min(touched),
                path=min(touched),
                surface=phrase(f"simulation.{name}"),
                distance=distance,
            )
