"""From the user's axes, dotted paths and their values, to a grid of cases."""

from __future__ import annotations

from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from stayput.body import Body
from stayput.cases import SURFACES, leaves, leaves_of_body, leaves_of_floor, leaves_of_room, leaves_of_surface
from stayput.ensemble.grid import LAW, MOTION, Axis, Columns, Grid
from stayput.errors import InputError
from stayput.motion import Motion
from stayput.room import Ceiling, Floor, Room, Wall
from stayput.simulation import law_number

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from numpy.typing import NDArray

    from stayput.simulation import Case

Axes: TypeAlias = "Mapping[str | tuple[str, ...], Any]"

UNITS = {
    "width": "m",
    "height": "m",
    "mass": "kg",
    "inertia": "kg m2",
    "x": "m",
    "z": "m",
    "left": "m",
    "right": "m",
    "gap": "m",
    "tilt": "rad",
    "tilt_rate": "rad/s",
    "slide": "m",
    "slide_rate": "m/s",
    "gravity": "m/s2",
}
"""Units by the last word of a path; the other numbers have none."""

WHOLE: dict[str, tuple[type | tuple[type, ...], Callable[[Any], dict[str, float]]]] = {
    "body": (Body, leaves_of_body),
    "room": (Room, leaves_of_room),
    "room.floor": (Floor, leaves_of_floor),
    "room.left_wall": ((Wall, type(None)), lambda wall: leaves_of_surface("left_wall", wall)),
    "room.right_wall": ((Wall, type(None)), lambda wall: leaves_of_surface("right_wall", wall)),
    "room.ceiling": ((Ceiling, type(None)), lambda ceiling: leaves_of_surface("ceiling", ceiling)),
}
"""Paths whose values are objects: what they must be, and their numbers."""


def unit_of(path: str) -> str:
    """Return the unit of a path's numbers, empty where they have none."""
    return UNITS.get(path.rsplit(".", 1)[-1], "")


def base_numbers(case: Case) -> dict[str, float]:
    """Return a case's numbers by path; its motion is the first of the list."""
    numbers = leaves(case.body, case.room, case.initial, case.gravity)
    return {**numbers, MOTION: 0.0, LAW: float(law_number(case.contact))}


def make_grid(case: Case, axes: Axes) -> Grid:
    """Return the product of axes; a tuple of paths is one axis along which their values go together.

    Raises
    ------
    InputError
        An unknown path, one that is on two axes, values that are none, or cases that are not possible.
    """
    base = base_numbers(case)
    motions: list[Motion] = [case.motion]
    made: list[Axis] = []
    for paths, values in axes.items():
        names = (paths,) if isinstance(paths, str) else tuple(paths)
        given = (values,) if isinstance(paths, str) else tuple(values)
        if len(names) != len(given) or not names:
            raise InputError(
                f"The axis {names} has values for {len(given)} paths; it must have one list for each path."
            )
        made.append(_axis(names, given, base, motions))
    _refuse_repeats(made)
    _refuse_missing_surfaces(base, made)
    grid = Grid(base, tuple(made), tuple(motions), tuple(case.measures))
    grid.refuse_bad_cases()
    return grid


def _axis(
    names: tuple[str, ...], given: tuple[Any, ...], base: dict[str, float], motions: list[Motion]
) -> Axis:
    columns: Columns = {}
    labels: dict[str, Any] = {}
    for name, values in zip(names, given, strict=True):
        found, label = _columns(name, values, base, motions)
        repeated = columns.keys() & found.keys()
        if repeated:
            raise InputError(f"The axis {names} sets {min(repeated)!r} twice; each path must be there once.")
        columns |= found
        labels[name] = label
    lengths = {name: len(label) for name, label in labels.items()}
    if len(set(lengths.values())) > 1:
        raise InputError(f"The axis {names} has {lengths} values; paths on one axis must have as many.")
    return Axis(names[0], columns, labels)


def _columns(
    name: str, values: Any, base: dict[str, float], motions: list[Motion]
) -> tuple[Columns, Sequence[Any] | NDArray[Any]]:
    """Return what a path's values change, and how they are labelled."""
    if name in WHOLE or name in (MOTION, LAW):
        items = list(values)
        _refuse_empty(name, len(items))
        if name == LAW:
            return {LAW: np.array([law_number(item) for item in items])}, items
        if name == MOTION:
            _refuse_other(name, items, Motion)
            place = {key: len(motions) + n for n, key in enumerate(dict.fromkeys(map(id, items)))}
            motions.extend({id(item): item for item in items}.values())  # each is prepared once
            return {MOTION: np.array([place[id(item)] for item in items])}, [item.name for item in items]
        kind, numbers_of = WHOLE[name]
        _refuse_other(name, items, kind)
        table = [numbers_of(item) for item in items]
        return {path: np.array([row[path] for row in table]) for path in table[0]}, np.arange(len(items))
    if name not in base:
        known = sorted({*base, *WHOLE})
        near = get_close_matches(name, known, 1)
        hint = f" (did you mean {near[0]!r}?)" if near else ""
        raise InputError(f"{name!r} is no path of a case{hint}; it must be one of {', '.join(known)}.")
    try:
        numbers = np.array(values, np.float64)
    except (TypeError, ValueError):
        raise InputError(f"The values of {name!r} are not numbers; they must be a list of numbers.") from None
    if numbers.ndim != 1:
        raise InputError(f"The values of {name!r} have {numbers.ndim} dimensions; they must be a list.")
    _refuse_empty(name, len(numbers))
    if not np.isfinite(numbers).all():
        bad = numbers[~np.isfinite(numbers)][0]
        raise InputError(f"{name!r} has the value {bad}; its values must be finite numbers.")
    return {name: numbers}, numbers


def _refuse_empty(name: str, count: int) -> None:
    if count == 0:
        raise InputError(f"{name!r} has no values; it must have at least one.")


def _refuse_other(name: str, items: list[Any], kind: type | tuple[type, ...]) -> None:
    for item in items:
        if not isinstance(item, kind):
            wanted = (kind if isinstance(kind, type) else kind[0]).__name__
            raise InputError(f"{name!r} has the value {item!r}; its values must be of type {wanted}.")


def _refuse_repeats(axes: list[Axis]) -> None:
    seen: set[str] = set()
    for axis in axes:
        repeated = seen & axis.columns.keys()
        if repeated:
            raise InputError(f"{min(repeated)!r} is on two axes; each path must be on one.")
        seen |= axis.columns.keys()


def _refuse_missing_surfaces(base: dict[str, float], axes: list[Axis]) -> None:
    changed = {path for axis in axes for path in axis.columns}
    for name in SURFACES:
        distance = f"room.{name}.{'height' if name == 'ceiling' else 'gap'}"
        touched = [path for path in changed if path.startswith(f"room.{name}.")]
        if touched and distance not in changed and np.isinf(base[distance]):
            raise InputError(
                f"{min(touched)!r} changes a {name.replace('_', ' ')} that is not there; "
                f"give the room one, or set {distance!r} too."
            )
