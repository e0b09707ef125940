"""The smallest amplitude that turns a body over, and the safe islands above it.

Overturning is not monotonic in amplitude, so a bisection from any two amplitudes can end on any edge. Here
all amplitudes of a grid are run and the first that overturns is refined; what is above it is kept as well.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.ensemble import simulate_many

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from stayput.simulation import Case

PARTS, ROUNDS = 8, 4
"""Each round of refinement splits a bracket in these parts: the edge is known to 8⁻⁴ of the grid's step."""


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """Where cases turn over, over amplitude; each of shape [cases].

    Attributes
    ----------
    first : ndarray
        Smallest factor on the motion that overturns; NaN where none of the grid does.
    last_safe : ndarray
        Largest factor of the grid that does not overturn, islands included.
    safe_share : ndarray
        Share of the grid's factors from the first on that do not overturn: the islands.
    """

    first: NDArray[np.float64]
    last_safe: NDArray[np.float64]
    safe_share: NDArray[np.float64]


def first_overturning(case: Case, columns: Mapping[str, Any], scales: NDArray[np.float64]) -> Edges:
    """Find the first overturning amplitude of columns of cases.

    Parameters
    ----------
    case : Case
        What no column changes.
    columns : mapping of str to sequence, each of length n
        As for `stayput.simulate_many`.
    scales : ndarray, shape (n, k)
        Rising factors on the motion, for each case; at the first the body must stand.

    Returns
    -------
    Edges
        The edge is the first of the grid: an overturning band narrower than a step may be passed over, and
        edges of rocking can be ragged at every scale.
    """
    over = _overturned(case, columns, scales)
    found = over.any(axis=1)
    place = np.maximum(over.argmax(axis=1), 1)
    rows = np.arange(len(scales))
    since = np.logical_or.accumulate(over, axis=1)
    islands = np.sum(since & ~over, axis=1) / np.maximum(1, np.sum(since, axis=1))
    low, high = scales[rows, place - 1], scales[rows, place]
    for _ in range(ROUNDS):
        inner = np.linspace(low, high, PARTS + 1, axis=1)
        over_inner = _overturned(case, columns, inner[:, 1:-1])
        step = np.where(over_inner.any(axis=1), over_inner.argmax(axis=1), PARTS - 1)
        low, high = inner[rows, step], inner[rows, step + 1]
    return Edges(
        first=np.where(found, 0.5 * (low + high), np.nan),
        last_safe=np.where(over, -np.inf, scales).max(axis=1),
        safe_share=np.where(found, islands, np.nan),
    )


def _overturned(case: Case, columns: Mapping[str, Any], scales: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether cases turn over at some scales each, shape [n, k]."""
    count, each = scales.shape
    repeated = {name: [v for v in values for _ in range(each)] for name, values in columns.items()}
    found = simulate_many(case, {**repeated, "motion.scale": scales.ravel()}, progress=False)
    return found["overturned"].reshape(count, each)
