r"""A probability from counts, with an interval that knows that runs of one motion are alike.

Wilson's score interval (Wilson 1927; recommended by Brown, Cai and DasGupta 2001) with the number of
independent runs in place of the number of runs, n* = n / deff, and Student's t in place of the normal
quantile (Korn and Graubard 1998; compared with others by Franco, Little, Louis and Slud 2019). The design
effect deff (Kish 1965) is estimated from the scatter of the motions' own counts, with one motion that
falls always and one that never does added, so that counts without a scatter, such as none of 640, count as
no more than one run a motion.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import stdtrit

from stayput.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

CONFIDENCE = 0.95
"""Confidence of every interval."""


@dataclass(frozen=True, slots=True)
class Probability:
    """A probability with its 95 % interval.

    Parameters
    ----------
    estimate : float
        Share of the runs; NaN without any.
    low, high : float
        Ends of the interval. A run that was given up counts as standing for ``low`` and as fallen for
        ``high``.
    fell, runs : int
        Counts, without those given up.
    motions : int
        Motions of these runs.
    missing : int
        Runs that were given up.
    design_effect : float
        Runs over independent runs that would tell as much.
    """

    estimate: float
    low: float
    high: float
    fell: int
    runs: int
    motions: int
    missing: int
    design_effect: float

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return 0.5 * (self.high - self.low)

    @property
    def text(self) -> str:
        """Probability and interval in words: "12 % (7 to 20 %)"."""
        if self.runs == 0:
            return "unknown (no run)"
        return f"{percent(self.estimate)} % ({percent(self.low)} to {percent(self.high)} %)"


def percent(share: float) -> str:
    """Return a share in per cent, with a decimal where it is below 1 or above 99 %."""
    value = 100.0 * share
    fine = 0.0 < abs(value) < 0.95 or 99.05 < abs(value) < 100.0
    rounded = f"{value:.1f}" if fine else f"{value:.0f}"
    return rounded.replace("-", "−")


def probability(fallen: ArrayLike, missing: ArrayLike | None = None) -> Probability:
    """Return the probability that something happens, from whether it did.

    Parameters
    ----------
    fallen : array_like of bool, shape (motions, samples)
        Whether it happened in each run.
    missing : array_like of bool, same shape, optional
        Runs that were given up, and tell nothing.

    Returns
    -------
    Probability
        With only one motion the samples are taken as independent: the interval is then one for that motion.

    Raises
    ------
    InputError
        Arrays of another shape.

    Examples
    --------
    >>> import numpy as np
    >>> probability(np.arange(40).reshape(40, 1) < 8).text
    '20 % (10 to 35 %)'
    """
    fell, given_up = checked_runs(fallen, missing)
    runs = (~given_up).sum(axis=1)
    return probability_of_counts((fell & ~given_up).sum(axis=1), runs, given_up.sum(axis=1))


def checked_runs(
    fallen: ArrayLike, missing: ArrayLike | None, dimensions: int = 2
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return both arrays as of bool, ``missing`` filled in.

    Raises
    ------
    InputError
        Another number of dimensions, no runs, or shapes that differ.
    """
    fell = np.asarray(fallen)
    if fell.dtype != np.bool_:
        raise InputError(f"The type of fallen is {fell.dtype}; it must be bool, and missing runs go apart.")
    if fell.ndim != dimensions or fell.size == 0:
        raise InputError(f"The shape of fallen is {fell.shape}; it must have {dimensions} axes, none empty.")
    given_up = np.zeros(fell.shape, np.bool_) if missing is None else np.asarray(missing, np.bool_)
    if given_up.shape != fell.shape:
        raise InputError(
            f"The shape of missing is {given_up.shape}; it must be that of fallen, {fell.shape}."
        )
    return fell, given_up


def probability_of_counts(fell: ArrayLike, runs: ArrayLike, missing: ArrayLike = 0) -> Probability:
    """Return the probability from the counts of each motion.

    Parameters
    ----------
    fell, runs : array_like of int, shape (motions,)
        Runs of each motion in which it happened, and all that were not given up.
    missing : array_like of int, shape (motions,), optional
        Runs of each motion that were given up.
    """
    k, n = np.asarray(fell, np.float64), np.asarray(runs, np.float64)
    gone = np.broadcast_to(np.asarray(missing, np.float64), n.shape)
    if not n.sum() > 0.0:
        return Probability(math.nan, 0.0, 1.0, 0, 0, 0, int(gone.sum()), math.nan)
    low, _ = _interval(k, n + gone)
    _, high = _interval(k + gone, n + gone)
    effect = design_effect(k, n)
    counts = int(k.sum()), int(n.sum()), int((n > 0.0).sum()), int(gone.sum())
    return Probability(float(k.sum() / n.sum()), low, high, *counts, effect)


def _interval(k: NDArray[np.float64], n: NDArray[np.float64]) -> tuple[float, float]:
    total, units = float(n.sum()), int((n > 0.0).sum())
    independent = total / design_effect(k, n)
    # of one motion its runs are the units
    t = student(units if units > 1 else round(total))
    return wilson(float(k.sum()) / total * independent, independent, t)


def student(units: int) -> float:
    """Return the quantile of Student's t for the 95 % interval from a number of independent units."""
    return float(stdtrit(max(units - 1, 1), 0.5 + 0.5 * CONFIDENCE))


def design_effect(fell: NDArray[np.float64], runs: NDArray[np.float64]) -> float:
    """Return the design effect of counts by motion: 1 if runs are independent, runs a motion if all alike.

    Of one motion it is 1.
    """
    k, n = fell[runs > 0.0], runs[runs > 0.0]
    if len(n) == 1:
        return 1.0
    size = float(n.mean())
    k, n = np.append(k, (size, 0.0)), np.append(n, (size, size))
    p = float(k.sum() / n.sum())
    effect = float(((k - p * n) ** 2).sum() / n.sum() / (p * (1.0 - p)))
    return min(max(effect, 1.0), max(size, 1.0))


def wilson(k: float, n: float, quantile: float | None = None) -> tuple[float, float]:
    """Return Wilson's score interval of k of n independent runs.

    Parameters
    ----------
    k, n : float
        Counts; they need not be whole.
    quantile : float, optional
        Quantile of the interval, by default the normal one for 95 %.

    Examples
    --------
    >>> [round(end, 4) for end in wilson(0, 10)]
    [0.0, 0.2775]
    """
    z = float(stdtrit(np.inf, 0.5 + 0.5 * CONFIDENCE)) if quantile is None else quantile
    p, q = k / n, z * z / n
    middle = (p + 0.5 * q) / (1.0 + q)
    half = math.sqrt(q * p * (1.0 - p) + 0.25 * q * q) / (1.0 + q)
    low = 0.0 if k <= 0.0 else max(middle - half, 0.0)
    high = 1.0 if k >= n else min(middle + half, 1.0)
    return low, high
