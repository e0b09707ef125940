"""The difference of two probabilities from runs with the same motions and the same draws.

The adjusted Wald interval of Bonett and Price (2012) for paired proportions, with the motions as the units
that are independent: one motion in which every run is for the one and one in which every run is for the
other are added before the mean and its standard error are taken. With one run a motion it is theirs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.fragility.probabilities import checked_runs, percent, student

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, slots=True)
class Difference:
    """A difference of two probabilities with its 95 % interval.

    Parameters
    ----------
    estimate : float
        First less second; NaN without any pair of runs.
    low, high : float
        Ends of the interval.
    more, fewer : int
        Pairs of runs in which it happened in the first only, and in the second only.
    pairs : int
        Pairs of which neither run was given up.
    missing : int
        Pairs of which a run was given up; they do not count.
    """

    estimate: float
    low: float
    high: float
    more: int
    fewer: int
    pairs: int
    missing: int

    @property
    def clear(self) -> bool:
        """Whether the interval leaves out 0, so that the sign is sure."""
        return self.low > 0.0 or self.high < 0.0

    @property
    def text(self) -> str:
        """Difference and interval in words: "−35 points (−48 to −20)", points being per cent."""
        if self.pairs == 0:
            return "unknown (no pair of runs)"
        return f"{percent(self.estimate)} points ({percent(self.low)} to {percent(self.high)})"


def difference(first: ArrayLike, second: ArrayLike, missing: ArrayLike | None = None) -> Difference:
    """Return how much likelier something is in the first runs than in the second.

    Parameters
    ----------
    first, second : array_like of bool, shape (motions, samples)
        Whether it happened, run by run with the same motion and the same draw.
    missing : array_like of bool, same shape, optional
        Pairs of which a run was given up.

    Raises
    ------
    InputError
        Arrays of another shape.

    Examples
    --------
    >>> import numpy as np
    >>> bare = np.arange(40).reshape(40, 1) < 20
    >>> held = np.arange(40).reshape(40, 1) < 8
    >>> difference(held, bare).text
    '−30 points (−44 to −13)'
    """
    a, given_up = checked_runs(first, missing)
    b, _ = checked_runs(second, missing)
    if a.shape != b.shape:
        raise InputError(
            f"The shapes are {a.shape} and {b.shape}; both must have the same motions and samples."
        )
    more, fewer = a & ~b & ~given_up, b & ~a & ~given_up
    d = more.astype(np.float64) - fewer
    n = (~given_up).astype(np.float64)
    if a.shape[0] > 1:
        d, n = d.sum(axis=1), n.sum(axis=1)
    d, n = d[n > 0.0].ravel(), n[n > 0.0].ravel()
    lost, pairs = int(given_up.sum()), int(n.sum())
    if pairs == 0:
        return Difference(math.nan, -1.0, 1.0, 0, 0, 0, lost)
    size = float(n.mean())
    d_added, n_added = np.append(d, (size, -size)), np.append(n, (size, size))
    middle = float(d_added.sum() / n_added.sum())
    error = math.sqrt(float(((d_added - middle * n_added) ** 2).sum())) / float(n_added.sum())
    half = student(len(n)) * error
    low, high = max(middle - half, -1.0), min(middle + half, 1.0)
    return Difference(float(d.sum() / n.sum()), low, high, int(more.sum()), int(fewer.sum()), pairs, lost)
