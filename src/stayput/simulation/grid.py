"""Grids of cases: a base case, and the axes of a user (paths and their values) along which it varies."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, instance_of, list_of, no_length, not_allowed, shown, unknown
from stayput.errors import numbers as array_of
from stayput.measures.measure import element_rows, hold
from stayput.mechanics.devices.columns import ELEMENT
from stayput.model import flat_fields as flat_field
from stayput.model.body import Body
from stayput.model.room import WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.model.state import refuse_bad_start
from stayput.motion.record import Motion
from stayput.simulation.case import Case, law_number

if TYPE_CHECKING:
    from stayput.measures import Measure


Columns: TypeAlias = "dict[str, NDArray[np.float64] | NDArray[np.int64]]"

MOTION, LAW = "motion", "contact"
"""Columns of whole numbers: the place of a case's motion in the list of motions, and its contact law."""

CHECKED_AT_ONCE = 2**15
"""Cases whose numbers are checked together, before any is run."""


@dataclass(frozen=True, slots=True, eq=False)
class Axis:
    """Cases along one dimension: columns of numbers by path, with the user's labels."""

    name: str
    columns: Columns
    labels: Mapping[str, Sequence[Any] | NDArray[Any]]

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))


@dataclass(frozen=True, slots=True, eq=False)
class CaseBlock:
    """Consecutive cases of a grid: what one call of an executor computes."""

    count: int
    base: dict[str, float]
    columns: Columns
    measures: tuple[Measure, ...] = ()
    dimensions: int = 2

    def held(self) -> tuple[NDArray[np.void], NDArray[np.void]]:
        """Return the rows with the measures in place, shape [count], and the elements, shape [count, n]."""
        numbers: Any = self.base | self.columns
        return held_rows(numbers, self.count, self.measures)

    def numbers(self, place: int) -> dict[str, float]:
        """Return the numbers of one case by path."""
        varied = {path: _number(values.astype(np.float64), place) for path, values in self.columns.items()}
        return self.base | varied

    def group(self) -> NDArray[np.int64]:
        """Return 2·motion + law for each case, shape [count]: cases of one group are run together."""
        motion, law = (np.broadcast_to(self.columns[name], self.count) for name in (MOTION, LAW))
        return 2 * motion.astype(np.int64) + law.astype(np.int64)


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """A product of axes over a base case; the last axis varies fastest.

    Parameters
    ----------
    base : dict
        Numbers of the base case by path, among them its ``contact`` law's.
    axes : tuple of Axis
        What changes.
    motions : tuple of Motion
        The motions that the column ``motion`` points at.
    measures : tuple of Measure
        The measures of all cases.
    dimensions : int
        2 in the plane, 3 in space.
    """

    base: dict[str, float]
    axes: tuple[Axis, ...]
    motions: tuple[Motion, ...]
    measures: tuple[Measure, ...] = ()
    dimensions: int = 2

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of cases along each axis."""
        return tuple(len(axis) for axis in self.axes)

    def __len__(self) -> int:
        return math.prod(self.shape)

    def block(self, start: int, stop: int) -> CaseBlock:
        """Return the cases from ``start`` to before ``stop``."""
        places = np.unravel_index(np.arange(start, stop), self.shape) if self.axes else ()
        columns: Columns = {name: np.array([int(self.base[name])]) for name in (MOTION, LAW)}
        for axis, place in zip(self.axes, places, strict=True):
            columns |= {path: values[place] for path, values in axis.columns.items()}
        base = {path: value for path, value in self.base.items() if path not in columns}
        return CaseBlock(stop - start, base, columns, self.measures, self.dimensions)

    def refuse_bad_cases(self) -> None:
        """Raise `InputError` for a case that is not possible.

        The limits are those of `Body`, `Room` and `State`, and to make these objects for every case would
        take too long. Each limit is an interval of one number, or of one quantity made of several. So if any
        case breaks it, one does where the quantity is smallest or largest, and only these cases are made.
        """
        for start in range(0, len(self), CHECKED_AT_ONCE):
            block = self.block(start, min(start + CHECKED_AT_ONCE, len(self)))
            for row in sorted(_extreme_rows(block)):
                try:
                    self._refuse_bad_case(block.numbers(row))
                except InputError as error:
                    if len(self) == 1:
                        raise
                    where = phrase("simulation.case_number", number=start + row, count=len(self))
                    raise error.at(where) from None

    def _refuse_bad_case(self, numbers: dict[str, float]) -> None:
        body, room, _ = flat_field.from_flat_fields(numbers)
        if self.dimensions == 3:
            if body.length is None:
                raise no_length()
            if numbers[LAW] != 0.0:
                raise not_allowed("model.contact", repr("paper"), "model.coulomb_in_space", LAW)
            hold(body, room, self.measures, dimensions=3)
            return
        room.refuse_side_walls()
        _, elements = held_rows(numbers, 1, self.measures)
        if elements.size and numbers[LAW] != 0.0:
            raise not_allowed("model.contact", repr("paper"), "mechanics.elements_need_coulomb", LAW)


def _extreme_rows(block: CaseBlock) -> set[int]:
    """Return the rows at which a limited quantity is smallest, largest or NaN, which argmin finds as well."""
    numbers = block.base | block.columns
    b, h = numbers["body.width"], numbers["body.height"]
    rows = flat_field.case_rows(numbers, block.count)  # type: ignore[arg-type]
    limited = [column for path, column in block.columns.items() if path not in (MOTION, LAW)]
    limited += [
        np.abs(numbers["body.cg_offset.x"]) - b / 2,
        np.abs(numbers["body.cg_offset.z"]) - h / 2,
        rows["inertia"] / (b**2 + h**2),
        rows["static_friction"] - rows["kinetic_friction"],
        rows["edge_static_friction"] - rows["edge_kinetic_friction"],
    ]
    for side in ("left", "right"):
        static, kinetic = (
            np.where(
                np.isnan(edge := rows[f"{side}_edge_{kind}_friction"]), rows[f"edge_{kind}_friction"], edge
            )
            for kind in ("static", "kinetic")
        )
        limited.append(static - kinetic)
        height = numbers[f"body.base_heights.{side}"]
        limited += [height + b / 2, height - np.minimum(b, h) / 4]
    limited += _initial_clearances(rows)
    extreme: set[int] = set()
    for quantity in limited:
        values = np.broadcast_to(quantity, block.count)
        extreme |= {int(np.argmin(values)), int(np.argmax(values))}
    return extreme


def _initial_clearances(rows: NDArray[np.void]) -> list[NDArray[np.float64]]:
    """Return the tilt [rad] and the distances to right wall, left wall and ceiling [m] at the start."""
    u, v = rows["u"], rows["v"]
    rest = np.arctan2(v[:, 1] - v[:, 0], u[:, 1] - u[:, 0])
    right = (rows["tilt"] > 0.0) | ((rows["tilt"] == 0.0) & (rows["tilt_rate"] > 0.0))
    half = 0.5 * np.hypot(u[:, 1] - u[:, 0], v[:, 1] - v[:, 0])

    def corners(tilt: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        sin, cos = np.sin(tilt)[:, None], np.cos(tilt)[:, None]
        across, above = u * cos + v * sin, v * cos - u * sin
        x = np.where(right, half - across[:, 1], -half - across[:, 0])[:, None] + across
        return x, above - np.where(right, above[:, 1], above[:, 0])[:, None]

    still, _ = corners(rest)
    x, z = corners(rest + rows["tilt"])
    x = x + rows["slide"][:, None]
    with np.errstate(invalid="ignore"):
        return [
            rest + rows["tilt"],
            still.max(1) + rows["right_distance"] - x.max(1),
            x.min(1) - still.min(1) + rows["left_distance"],
            rows["ceiling_distance"] - z.max(1),
        ]


def held_rows(
    numbers: Mapping[str, flat_field.NumberOrColumn], count: int, measures: tuple[Measure, ...]
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Return rows of cases in the plane with measures in place: CASE, shape [count], and ELEMENT, [count, n].

    Putting measures in place makes objects, so it is done once for each combination of body and room.

    Parameters
    ----------
    numbers : mapping
        Numbers by path, each one value or ``count`` of them.
    count : int
        Number of cases.
    measures : tuple of Measure
        The measures, the same for all.

    Raises
    ------
    InputError
        Measures that cannot be put in place.
    """
    if not measures:
        return flat_field.case_rows(numbers, count), np.zeros((count, 0), ELEMENT)
    varied = [
        path
        for path, values in numbers.items()
        if path.startswith(("body.", "room.")) and np.size(values) > 1 and count > 1
    ]
    table = np.stack([np.asarray(numbers[path]) for path in varied], 1) if varied else np.zeros((count, 0))
    # by their bytes, so that NaN, which stands for "not given", equals itself
    keys = np.array([row.tobytes() for row in table])
    _, first, which = np.unique(keys, return_index=True, return_inverse=True)
    pairs = [
        _put_in_place({k: _number(v, row) for k, v in numbers.items()}, measures) for row in first.tolist()
    ]
    changed = {path: np.array([fields[path] for fields, _ in pairs])[which] for path in pairs[0][0]}
    return flat_field.case_rows({**numbers, **changed}, count), np.stack([rows for _, rows in pairs])[which]


def _number(values: flat_field.NumberOrColumn, row: int) -> float:
    """Return the number of one row; a single number is that of all rows."""
    every = np.ravel(values)
    return float(every[row if every.size > 1 else 0])


def _put_in_place(
    numbers: dict[str, float], measures: tuple[Measure, ...]
) -> tuple[dict[str, float], NDArray[np.void]]:
    body, room, start = flat_field.from_flat_fields(numbers)
    held = hold(body, room, measures)
    refuse_bad_start(held.body, held.room, start)
    return {
        **flat_field.fields_of("body", held.body),
        **flat_field.fields_of("room", held.room),
    }, element_rows(held)


Axes: TypeAlias = "Mapping[str | tuple[str, ...], Any]"

OBJECT_PATHS: dict[str, type | tuple[type, ...]] = {
    "body": Body,
    "room": Room,
    "room.floor": Floor,
    **{f"room.{name}": (Wall, type(None)) for name in WALLS_AROUND},
    "room.ceiling": (Ceiling, type(None)),
}
"""Paths whose values are objects, and the types of these."""


def make_grid(case: Case, axes: Axes) -> Grid:
    """Return the grid of all combinations of the axes' values.

    A tuple of paths is one axis, along which their values change together.

    Raises
    ------
    InputError
        An unknown path, a path on two axes, values of the wrong kind, or cases that are not possible.
    """
    instance_of("case", case, Case)
    base = flat_field.flat_fields(case.body, case.room, case.initial, case.gravity)
    base |= {MOTION: 0.0, LAW: float(law_number(case.contact))}  # the motion is the first of the list
    motions: list[Motion] = [case.motion]
    grid_axes: list[Axis] = []
    changed: set[str] = set()
    instance_of("axes", axes, Mapping)
    for paths, values in axes.items():
        names = (paths,) if isinstance(paths, str) else tuple(paths)
        value_lists = (values,) if isinstance(paths, str) else list_of("axes", values)
        if len(names) != len(value_lists) or not names:
            raise InputError("simulation.axis_lists", "axes", names=str(names), count=len(value_lists))
        grid_axes.append(_axis(names, value_lists, base, motions, changed))
    _refuse_missing_surfaces(base, changed)
    dimensions = 3 if case.in_space else 2
    grid = Grid(base, tuple(grid_axes), tuple(motions), tuple(case.measures), dimensions)
    grid.refuse_bad_cases()
    return grid


def _axis(
    names: tuple[str, ...],
    value_lists: tuple[Any, ...],
    base: dict[str, float],
    motions: list[Motion],
    changed: set[str],
) -> Axis:
    """Return an axis; motions and the paths that it changes are added to those of the axes before."""
    columns: Columns = {}
    labels: dict[str, Any] = {}
    for name, values in zip(names, value_lists, strict=True):
        added, label = _columns(name, values, base, motions)
        if repeated := changed & added.keys():
            raise InputError("common.twice", min(repeated), name=repr(min(repeated)))
        changed.update(added)
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
        if not items:
            raise InputError("common.empty", name)
        if name == LAW:
            return {LAW: np.array([law_number(item) for item in items])}, items
        if name == MOTION:
            list_of(name, items, Motion)
            place = {key: len(motions) + n for n, key in enumerate(dict.fromkeys(map(id, items)))}
            motions.extend({id(item): item for item in items}.values())
            return {MOTION: np.array([place[id(item)] for item in items])}, [item.name for item in items]
        list_of(name, items, OBJECT_PATHS[name])
        table = [flat_field.fields_of(name, item) for item in items]
        return {path: np.array([row[path] for row in table]) for path in table[0]}, np.arange(len(items))
    if name not in base:
        raise unknown("simulation.path", name, sorted({*base, *OBJECT_PATHS}), name)
    listed = finite_numbers(repr(name), values, name)
    return {name: listed}, listed


def finite_numbers(name: str | Phrase, values: Any, field: str, least: int = 1) -> NDArray[np.float64]:
    """Return a list of so many finite numbers or more as an array, or raise `InputError`."""
    listed = array_of(name, values, field)
    if listed.ndim != 1 or len(listed) < least:
        allowed = phrase("simulation.list_of_numbers", least=least)
        raise not_allowed(name, shown(listed.tolist()), allowed, field)
    if not np.isfinite(listed).all():
        raise not_allowed(name, str(listed[~np.isfinite(listed)][0]), "common.finite_number", field)
    return listed


def _refuse_missing_surfaces(base: dict[str, float], changed: set[str]) -> None:
    for name in flat_field.WALLS_AND_CEILING:
        distance = flat_field.distance_to(name)
        touched = [path for path in changed if path.startswith(f"room.{name}.")]
        if touched and distance not in changed and np.isinf(base[distance]):
            path, surface = min(touched), phrase(f"simulation.{name}")
            values: dict[str, Any] = {"path": path, "surface": surface, "distance": distance}
            raise InputError("simulation.surface_missing", path, **values)
