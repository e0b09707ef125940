"""Measures on columns of cases: the rows of bodies and rooms with measures in place, and their elements."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.cases import case_rows, from_leaves, leaves_of_body, leaves_of_room, refuse_penetration
from stayput.measures.measure import element_rows, hold
from stayput.mechanics.restrained.columns import ELEMENT

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from stayput.cases import Numbers
    from stayput.measures import Measure


def held_rows(
    numbers: Mapping[str, Numbers], count: int, measures: tuple[Measure, ...]
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Return ``count`` rows of CASE, and of ELEMENT, shape [count, n].

    Measures are put in place once for each body and room that differ.

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
        return case_rows(numbers, count), np.zeros((count, 0), ELEMENT)
    varied = [
        path
        for path, values in numbers.items()
        if path.startswith(("body.", "room.")) and np.size(values) > 1 and count > 1
    ]
    table = np.stack([np.asarray(numbers[path]) for path in varied], 1) if varied else np.zeros((count, 0))
    first, which = _distinct(table)
    pairs = [_put_in_place({k: _one(v, row) for k, v in numbers.items()}, measures) for row in first]
    changed = {path: np.array([leaves[path] for leaves, _ in pairs])[which] for path in pairs[0][0]}
    return case_rows({**numbers, **changed}, count), np.stack([rows for _, rows in pairs])[which]


def _distinct(table: NDArray[np.float64]) -> tuple[list[int], NDArray[np.intp]]:
    """Return the first place of each row that differs, and which of them every row is."""
    seen: dict[bytes, int] = {}
    first: list[int] = []
    which = np.empty(len(table), np.intp)
    for n, row in enumerate(table):
        key = row.tobytes()
        if key not in seen:
            seen[key] = len(first)
            first.append(n)
        which[n] = seen[key]
    return first, which


def _one(values: Numbers, row: int) -> float:
    return (
        float(values) if np.ndim(values) == 0 else float(np.ravel(values)[row if np.size(values) > 1 else 0])
    )


def _put_in_place(
    numbers: dict[str, float], measures: tuple[Measure, ...]
) -> tuple[dict[str, float], NDArray[np.void]]:
    body, room, start = from_leaves(numbers)
    held = hold(body, room, measures)
    refuse_penetration(held.body, held.room, start)
    return {**leaves_of_body(held.body), **leaves_of_room(held.room)}, element_rows(held)
