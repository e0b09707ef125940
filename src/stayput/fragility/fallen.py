"""How likely counts of fallen pieces are at each intensity, from runs of such pieces under many motions.

All pieces of a place are shaken by one motion, and nobody knows which: the likelihood is the mean over the
motions of the product over the kinds of pieces, so that the scatter from record to record makes the counts
as overdispersed as it does. Under one motion a kind's count is beta-binomial, for its share is known from
some runs only; what all motions of the level say of it counts as one run more. The interval is of the
likelihood ratio: where ln L is less than 1.92 below its peak; of a bound, 3.00.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import betaln, gammaln

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

DROP = 1.92
"""ln L of the peak less that at the ends of a 95 % interval: half the 95 % quantile of χ² with 1 degree."""

BOUND_DROP = -math.log(0.05)
"""The same at a bound: beyond it what was seen is less than a twentieth as likely as at the peak."""


@dataclass(frozen=True, slots=True, eq=False)
class IntensityEstimate:
    """An intensity and its interval from what fell and what stood.

    Parameters
    ----------
    intensity : float
        Mean of the levels, weighted by their likelihood; NaN where an end of the interval is open: there
        `most_likely` tells where the peak is.
    low, high : float
        Ends of the 95 % interval; −∞ or ∞ where even the weakest or the strongest level fits.
    levels : ndarray, shape (levels,)
        JMA intensities that were run.
    log_likelihood : ndarray, shape (levels,)
        ln L there, 0 at its peak.
    shares : ndarray, shape (kinds, levels)
        Share of each kind that falls at each level, over all motions.
    """

    intensity: float
    low: float
    high: float
    levels: NDArray[np.float64]
    log_likelihood: NDArray[np.float64]
    shares: NDArray[np.float64]

    @property
    def most_likely(self) -> float:
        """The level at which what was seen is most likely; the first or the last where it is beyond them."""
        return float(self.levels[np.argmax(self.log_likelihood)])


def estimate_from_counts(
    levels: NDArray[np.float64],
    runs_fell: NDArray[np.float64],
    runs: NDArray[np.float64],
    fell: Sequence[int],
    totals: Sequence[int],
    scatter: float,
) -> IntensityEstimate:
    """Return the intensity from counts of fallen pieces.

    Parameters
    ----------
    levels : ndarray, shape (levels,)
        Intensities, increasing.
    runs_fell, runs : ndarray, shape (kinds, levels, motions)
        Runs in which a piece of a kind fell, and all runs.
    fell, totals : sequence of int, length kinds
        Pieces that fell, and all pieces.
    scatter : float
        Standard deviation of the intensity from piece to piece.
    """
    near = _kernel(levels, scatter)
    fell_near, runs_near = near @ runs_fell, near @ runs
    before = (fell_near.sum(axis=2, keepdims=True) + 0.5) / (runs_near.sum(axis=2, keepdims=True) + 1.0)
    a, b = fell_near + before, runs_near - fell_near + (1.0 - before)
    k, n = (np.asarray(counts, np.float64)[:, np.newaxis, np.newaxis] for counts in (fell, totals))
    choices = gammaln(n + 1.0) - gammaln(k + 1.0) - gammaln(n - k + 1.0)
    by_kind = choices + betaln(k + a, n - k + b) - betaln(a, b)
    summed = np.logaddexp.reduce(by_kind.sum(axis=0), axis=1)
    log_l = summed - summed.max()
    low, high = _ends(levels, log_l)
    closed = math.isfinite(low) and math.isfinite(high)
    weights = np.exp(log_l) * np.gradient(levels)
    intensity = float(np.average(levels, weights=weights)) if closed else math.nan
    shares = fell_near.sum(axis=2) / runs_near.sum(axis=2)
    return IntensityEstimate(intensity, low, high, levels, log_l, shares)


def _kernel(levels: NDArray[np.float64], scatter: float) -> NDArray[np.float64]:
    """Return the weights of each level's neighbours for a normal scatter, shape (levels, levels)."""
    if scatter == 0.0:
        return np.eye(len(levels))
    apart = (levels[:, np.newaxis] - levels) / scatter
    weights = np.exp(-0.5 * apart**2) * np.gradient(levels)
    return weights / weights.sum(axis=1, keepdims=True)


def _ends(levels: NDArray[np.float64], log_l: NDArray[np.float64]) -> tuple[float, float]:
    """Return where ln L first and last comes within `DROP` of its peak; ±∞ beyond the levels.

    The only end of an interval that is open to the other side is where it comes within `BOUND_DROP`.
    """

    def reach(drop: float) -> tuple[float, float]:
        inside = np.flatnonzero(log_l >= -drop)
        first, last = int(inside[0]), int(inside[-1])

        def crossing(out: int, within: int) -> float:
            part = (-drop - log_l[out]) / (log_l[within] - log_l[out])
            return float(levels[out] + part * (levels[within] - levels[out]))

        low = -math.inf if first == 0 else crossing(first - 1, first)
        return low, math.inf if last == len(levels) - 1 else crossing(last + 1, last)

    ends = reach(DROP)
    return ends if all(map(math.isfinite, ends)) else reach(BOUND_DROP)
