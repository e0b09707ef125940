r"""A probability from counts, with an interval that accounts for correlation of the runs of one motion.

Wilson's score interval (Wilson 1927; recommended by Brown, Cai and DasGupta 2001) with the number of
independent runs in place of the number of runs, n* = n / deff, and Student's t in place of the normal
quantile (Korn and Graubard 1998; compared with others by Franco, Little, Louis and Slud 2019). The design
effect deff (Kish 1965) is estimated from the scatter of the motions' own counts, with one motion that
falls always and one that never does added, each with the weight of a run: enough that counts without a
scatter, such as none of 640, count as no more than one run a motion, and that five motions that happen to
agree are not taken for many. The two count among the units of Student's t. How often the intervals hold the
truth is on the documentation's calibration page.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import stdtrit

from stayput.catalogue import Phrase, phrase
from stayput.errors import not_allowed

CONFIDENCE = 0.95
"""Confidence of every interval."""

UNITS = (1, 5, 10)
"""Units to which probabilities are rounded where they are told [per cent]."""

WIDE = 25.0
"""Half-width of the interval above which its ends stand for a probability [per cent]."""

_WEIGHT = 1.0
"""Weight, in runs, of each of the two motions that are added before the design effect is estimated.

Found by trial: less makes five motions that happen to agree too sure, more makes all intervals wider.
"""


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

    Examples
    --------
    >>> import numpy as np
    >>> from stayput.fragility.probabilities import probability
    >>> apart = probability(np.arange(40).reshape(4, 10) % 4 == 0)  # 10 of 40 fell, spread over 4 motions
    >>> alike = probability(np.arange(40).reshape(4, 10) < 10)  # 10 of 40, all under one of them
    >>> apart.text, alike.text
    ('about 30 % (12 to 45 %)', '3 to 78 %')
    >>> alike.fell, alike.runs, round(alike.half_width / apart.half_width, 1)
    (10, 40, 2.3)
    """

    estimate: float
    low: float
    high: float
    fell: int
    runs: int
    motions: int
    missing: int
    design_effect: float

    def __float__(self) -> float:
        """Return the estimate."""
        return self.estimate

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return 0.5 * (self.high - self.low)

    @property
    def brief(self) -> str:
        """The probability in per cent, as finely as its interval allows: "25", "<9", ">82", "8–75".

        It is rounded to the first of `UNITS` that is not finer than the interval's half-width, or the last,
        or to a finer unit where that leaves the interval. Where that moves it by more than half of how far it
        is from 0 or 100, an end of the interval stands for it; where that is wider than `WIDE`, both do.
        """
        width = round(100.0 * self.half_width, 7)
        if width == 0.0:
            return percent(self.estimate)
        if width > WIDE and 0.0 < self.estimate < 1.0:
            return f"{percent(self.low)}–{percent(self.high)}"
        for unit in reversed(UNITS[: bisect_left(UNITS, width) + 1]):
            rounded = unit * math.floor(round(100.0 * self.estimate / unit, 7) + 0.5)
            moved = abs(rounded - 100.0 * self.estimate)
            if rounded in (0, 100) or moved > 50.0 * min(self.estimate, 1.0 - self.estimate):
                break
            if self.low <= rounded / 100.0 <= self.high:
                return str(rounded)
        if self.estimate < 0.5:
            return f"<{_upwards(self.high):g}"
        return f">{100.0 - _upwards(1.0 - self.low):g}"

    def scaled(self, factor: float) -> Probability:
        """Return the probability and its interval times a factor that is known."""
        estimate, low, high = (factor * part for part in (self.estimate, self.low, self.high))
        return replace(self, estimate=estimate, low=low, high=high)

    @property
    def share(self) -> Phrase:
        """The same in words: "about 30 %", "under 9 %", "over 82 %", "8 to 75 %"."""
        if self.runs == 0:
            return phrase("fragility.probability_unknown")
        key = {"<": "common.under", ">": "common.over"}.get(self.brief[0], "common.about")
        if "–" in self.brief:
            return self._ends
        share = self.brief.lstrip("<>")
        return phrase(key, share=(f"{share} %", f"{share}%"))

    @property
    def ends(self) -> Phrase:
        """The interval in both languages, "7 to 20 %"; empty where `share` tells an end of it."""
        return self._ends if self.runs and self.brief.isdigit() else ("", "")

    @property
    def _ends(self) -> Phrase:
        low, high = percent(self.low), percent(self.high)
        return phrase("fragility.ends", low=low, high=(f"{high} %", f"{high}%"))

    @property
    def texts(self) -> Phrase:
        """Probability and interval in both languages: "about 10 % (7 to 20 %)"."""
        aside = phrase("common.aside", content=self.ends) if self.ends[0] else ("", "")
        return self.share[0] + aside[0], self.share[1] + aside[1]

    @property
    def text(self) -> str:
        """Probability and interval in English words; see `texts`."""
        return self.texts[0]


def percent(share: float) -> str:
    """Return a share in per cent, finer below 1 and above 99 %; never 0 or 100 where it is not quite that."""
    # without the last digits of a difference, by which 31 of 40 would be 77 in one place and 78 in another
    value = round(100.0 * share, 7)
    if 0.0 < abs(value) < 0.05:
        return f"{'−' if value < 0.0 else ''}<0.1"
    if 99.95 < abs(value) < 100.0:
        return f"{'−' if value < 0.0 else ''}>99.9"
    fine = 0.0 < abs(value) < 0.95 or 99.05 < abs(value) < 100.0
    # halves away from zero, as the page rounds: 62.5 is 63, where Python's own rounding gives 62
    steps = 10.0 if fine else 1.0
    rounded = math.copysign(math.floor(steps * abs(value) + 0.5) / steps, value)
    return (f"{rounded:.1f}" if fine else f"{rounded:z.0f}").replace("-", "−")


def _upwards(share: float) -> float:
    """Return a share rounded up to whole per cent, or to tenths below 1 %."""
    value = round(100.0 * share, 7)
    return math.ceil(value) if value > 1.0 else math.ceil(round(10.0 * value, 6)) / 10.0


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
    'about 20 % (10 to 35 %)'
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
        raise not_allowed("fallen", str(fell.dtype), "fragility.booleans", "fallen")
    if fell.ndim != dimensions or fell.size == 0:
        axes = phrase("fragility.axes", dimensions=dimensions)
        raise not_allowed(phrase("common.shape_of", name="fallen"), str(fell.shape), axes, "fallen")
    given_up = np.zeros(fell.shape, np.bool_) if missing is None else np.asarray(missing, np.bool_)
    if given_up.shape != fell.shape:
        name = phrase("common.shape_of", name="missing")
        raise not_allowed(name, str(given_up.shape), str(fell.shape), "missing")
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
    given_up = np.broadcast_to(np.asarray(missing, np.float64), n.shape)
    if not n.sum() > 0.0:
        return Probability(math.nan, 0.0, 1.0, 0, 0, 0, int(given_up.sum()), math.nan)
    low, _ = _interval(k, n + given_up)
    _, high = _interval(k + given_up, n + given_up)
    effect = design_effect(k, n)
    counts = int(k.sum()), int(n.sum()), int((n > 0.0).sum()), int(given_up.sum())
    return Probability(float(k.sum() / n.sum()), low, high, *counts, effect)


def _interval(k: NDArray[np.float64], n: NDArray[np.float64]) -> tuple[float, float]:
    total, motions = float(n.sum()), int((n > 0.0).sum())
    independent = total / design_effect(k, n)
    return wilson(float(k.sum()) / total * independent, independent, quantile(motions, round(total)))


def quantile(motions: int, runs: int) -> float:
    """Return the quantile of Student's t that the interval of a probability has.

    Its units are the motions and the two that are added to them; of one motion they are its runs.
    """
    return student(motions + 2 if motions > 1 else runs)


def student(units: int, confidence: float = CONFIDENCE) -> float:
    """Return the quantile of Student's t for an interval from a number of independent units."""
    return float(stdtrit(max(units - 1, 1), 0.5 + 0.5 * confidence))


def design_effect(
    sums: NDArray[np.float64],
    runs: NDArray[np.float64],
    added: float = _WEIGHT,
    least: float = 0.0,
    squares: float | None = None,
) -> float:
    """Return the design effect of runs by motion: 1 if they are independent, runs a motion if all alike.

    Parameters
    ----------
    sums, runs : ndarray, shape (motions,)
        Sum of what each motion's runs gave, from ``least`` to 1, and their number. Of one motion the effect
        is 1.
    added : float
        Weight, in runs, of each of the two motions that are added.
    least : float
        What a run gives at least: 0 of a count, −1 of a difference.
    squares : float, optional
        Sum of the squares of what all runs gave; default that of a count.
    """
    x, n = sums[runs > 0.0], runs[runs > 0.0]
    if len(n) == 1:
        return 1.0
    size, total = float(n.mean()), float(n.sum()) + 2.0 * added
    mean = (float(x.sum()) + added * (least + 1.0)) / total
    square = float(x.sum()) if squares is None else squares
    variance = (square + added * (least * least + 1.0)) / total - mean * mean
    scatter = float(((x - mean * n) ** 2).sum()) + added * size * ((least - mean) ** 2 + (1.0 - mean) ** 2)
    return min(max(scatter / total / variance, 1.0), max(size, 1.0))


def effect_of_residuals(
    residuals: NDArray[np.float64],
    runs: NDArray[np.float64],
    expected: NDArray[np.float64],
    motion: NDArray[np.intp],
) -> float:
    """Return the design effect of counts from how far they are from those expected; see `design_effect`.

    Parameters
    ----------
    residuals, runs, expected : ndarray, shape (cells,)
        Counts less the expected ones, runs, and the expected share.
    motion : ndarray of int, shape (cells,)
        The number of each cell's motion. Of one motion the effect is 1.
    """
    n = np.bincount(motion, runs)
    if np.count_nonzero(n) < 2:
        return 1.0
    size, mean = float(n[n > 0.0].mean()), float(np.average(expected, weights=runs))
    two_motions = _WEIGHT * (mean * mean + (1.0 - mean) ** 2)
    scatter = float((np.bincount(motion, residuals) ** 2).sum()) + size * two_motions
    variance = float((runs * expected * (1.0 - expected)).sum()) + two_motions
    return min(max(scatter / variance, 1.0), max(size, 1.0))


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
