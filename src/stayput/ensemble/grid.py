"""Grids of cases: a base case, and axes along which numbers of it, its motion or its contact law change."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from stayput.cases import case_rows, from_leaves
from stayput.ensemble.holding import held_rows
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from stayput.measures import Measure
    from stayput.motion import Motion

Columns: TypeAlias = "dict[str, NDArray[np.float64] | NDArray[np.int64]]"

MOTION, LAW = "motion", "contact"
"""Columns of whole numbers: the place of a case's motion in the list of motions, and its contact law."""

CHECKED_AT_ONCE = 2**15
"""Cases whose numbers are looked at together before any is run."""


@dataclass(frozen=True, slots=True, eq=False)
class Axis:
    """Cases along one dimension: columns of numbers by path, and how the user labels them."""

    name: str
    columns: Columns
    labels: Mapping[str, Sequence[Any] | NDArray[Any]]

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """Some of a grid's cases, one after another; this is what a task gets."""

    count: int
    base: dict[str, float]
    columns: Columns
    measures: tuple[Measure, ...] = ()

    def rows(self) -> NDArray[np.void]:
        """Return the rows that the mechanics read of the cases without measures, shape [count]."""
        return case_rows(self.base | self.columns, self.count)  # type: ignore[operator]

    def held(self) -> tuple[NDArray[np.void], NDArray[np.void]]:
        """Return the rows with the measures in place, shape [count], and the elements, shape [count, n]."""
        return held_rows(self.base | self.columns, self.count, self.measures)  # type: ignore[operator]

    def group(self) -> NDArray[np.int64]:
        """Return a number for each case, the same for cases of one motion and one law, shape [count]."""
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
    """

    base: dict[str, float]
    axes: tuple[Axis, ...]
    motions: tuple[Motion, ...]
    measures: tuple[Measure, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of cases along each axis."""
        return tuple(len(axis) for axis in self.axes)

    def __len__(self) -> int:
        return math.prod(self.shape)

    def part(self, start: int, stop: int) -> Part:
        """Return the cases from ``start`` to before ``stop``."""
        places = np.unravel_index(np.arange(start, stop), self.shape) if self.axes else ()
        columns: Columns = {name: np.array([int(self.base[name])]) for name in (MOTION, LAW)}
        for axis, place in zip(self.axes, places, strict=True):
            columns |= {path: values[place] for path, values in axis.columns.items()}
        base = {path: value for path, value in self.base.items() if path not in columns}
        return Part(stop - start, base, columns, self.measures)

    def refuse_bad_cases(self) -> None:
        """Raise `InputError` for the first case found that is not possible.

        The limits are those of `Body`, `Room` and `State`. Each limits one number, or one quantity of
        several; so the cases are made where one of these is smallest or largest.
        """
        for start in range(0, len(self), CHECKED_AT_ONCE):
            part = self.part(start, min(start + CHECKED_AT_ONCE, len(self)))
            for row in sorted(_witnesses(part)):
                numbers = {k: float(v[row]) for k, v in part.columns.items() if len(v) == part.count}
                try:
                    self._refuse_bad_case(self.base | numbers)
                except InputError as error:
                    if len(self) == 1:
                        raise
                    raise InputError(f"Case {start + row} of {len(self)}: {error}") from None

    def _refuse_bad_case(self, numbers: dict[str, float]) -> None:
        from_leaves(numbers)
        _, elements = held_rows(numbers, 1, self.measures)
        if elements.size and numbers[LAW] != 0.0:
            raise InputError("Contact is 'paper'; measures with force elements need 'coulomb'.")


def _witnesses(part: Part) -> set[int]:
    """Return the rows at which a limited quantity is smallest, largest or not a number."""
    numbers = part.base | part.columns
    b, h = numbers["body.width"], numbers["body.height"]
    rows = part.rows()
    limited = [column for path, column in part.columns.items() if path not in (MOTION, LAW)]
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
                np.isnan(own := rows[f"{side}_edge_{kind}_friction"]), rows[f"edge_{kind}_friction"], own
            )
            for kind in ("static", "kinetic")
        )
        limited.append(static - kinetic)
        height = numbers[f"body.base_heights.{side}"]
        limited += [height + b / 2, height - np.minimum(b, h) / 4]
    limited += _clearances(rows)
    found: set[int] = set()
    for quantity in limited:
        values = np.broadcast_to(quantity, part.count)
        found |= {int(np.argmin(values)), int(np.argmax(values))}
    return found


def _clearances(rows: NDArray[np.void]) -> list[NDArray[np.float64]]:
    """Return the clear distances to the right wall, the left wall and the ceiling at the start [m]."""
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
            still.max(1) + rows["right_distance"] - x.max(1),
            x.min(1) - still.min(1) + rows["left_distance"],
            rows["ceiling_distance"] - z.max(1),
        ]
