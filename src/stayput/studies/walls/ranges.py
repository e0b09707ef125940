"""The paper's Table 4.3, and ranges of wall distance at which a body turns over."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

Range = tuple[float, float]
"""First and last distance [m]."""

TABLE_4_3: dict[float, Range | None] = {
    0.1: (0.0, math.inf),
    0.2: (0.0, 0.50),
    0.3: (0.0, 0.77),
    0.4: (0.02, 0.85),
    0.5: (0.05, 0.93),
    0.6: None,
    0.7: None,
    0.8: None,
    0.9: None,
    1.0: None,
}
"""The paper's Table 4.3: width [m], and the wall distances that turn it over; infinite: with any wall."""


def of_paper(width: float) -> tuple[bool, Range | None]:
    """Return whether a width is in Table 4.3, and the paper's range for it."""
    for listed, found in TABLE_4_3.items():
        if abs(listed - width) < 1e-9:
            return True, found
    return False, None


def paper_words(width: float) -> str:
    """Return the paper's result for a width in its own manner; empty where it has none."""
    listed, found = of_paper(width)
    if not listed:
        return ""
    if found is None:
        return "N"
    first, last = found
    if math.isinf(last):
        return "T, without influence of wall"
    return f"T, {first:.2f}–{last:.2f}" if first else f"T, up to {last:.2f}"


def ranges(gaps: NDArray[np.float64], fallen: NDArray[np.bool_]) -> list[Range]:
    """Return first and last distance of each unbroken range of distances that turn a body over.

    Parameters
    ----------
    gaps : ndarray, shape [gap]
        Distances [m].
    fallen : ndarray of bool, shape [gap]
        Whether the body turns over.

    Examples
    --------
    >>> import numpy as np
    >>> ranges(np.array([0.0, 0.1, 0.2]), np.array([True, False, True]))
    [(0.0, 0.0), (0.2, 0.2)]
    """
    edges = np.diff(np.concatenate(([False], fallen, [False])).astype(np.int8))
    firsts, lasts = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
    return [(float(gaps[i]), float(gaps[j])) for i, j in zip(firsts, lasts, strict=True)]


def words(found: list[Range], free: bool) -> str:
    """Return T or N, and the ranges; ``free`` is a body that turns over without a wall, too."""
    if not found:
        return "T without a wall only" if free else "N"
    spans = ", ".join(f"{first:.2f}–{last:.2f}" if last > first else f"{first:.2f}" for first, last in found)
    return f"T, {spans}; also without a wall" if free else f"T, {spans}"
