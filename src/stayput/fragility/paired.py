"""The difference of two probabilities from runs with the same motions and the same draws.

The interval is the wider of two. One is Student's t of the motions' own mean differences (Donner and Klar
2000), which is right wherever there are enough pairs that differ. The other is the score interval of paired
proportions (Tango 1998), which holds for few such pairs and for none, with the number of pairs divided by
their design effect. That effect is estimated as that of a probability is, with one motion in which every
pair is for the one and one in which every pair is for the other added, so that pairs that are all equal
count as no more than one a motion.

Where several are compared with the same one, the intervals hold together: each has the confidence
1 − 0.05 / m of m comparisons (Bonferroni; Dunn 1961), so that it also holds for the best of them, chosen by
the same runs.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtri

from stayput.catalogue import Phrase, phrase
from stayput.errors import not_allowed
from stayput.fragility.probabilities import CONFIDENCE, checked_runs, design_effect, percent, student

_WEIGHT = 0.2
"""Weight, in pairs, of each of the two motions that are added before the design effect is estimated.

Found by trial: less makes five motions that happen to agree too sure, more makes all intervals wider.
"""

_HALVINGS = 50
"""Bisections of the range of differences for an end of the score interval, to about 1e-15."""


@dataclass(frozen=True, slots=True)
class Difference:
    """A difference of two probabilities with its 95 % interval.

    Parameters
    ----------
    estimate : float
        First less second; NaN without any pair of runs.
    low, high : float
        Ends of the interval; of several comparisons of intervals that hold together.
    more, fewer : int
        Pairs of runs in which it happened in the first only, and in the second only.
    pairs : int
        Pairs of which neither run was given up.
    missing : int
        Pairs of which a run was given up; they do not count.

    Examples
    --------
    >>> import numpy as np
    >>> from stayput.fragility.paired import difference
    >>> falls = np.arange(200).reshape(20, 10) % 4 == 0  # 20 motions, 10 samples each
    >>> gain = difference(falls & (np.arange(10) < 5), falls)  # with a device, and without
    >>> gain.fewer, gain.more, gain.clear
    (20, 0, True)
    >>> [round(end, 2) for end in (gain.low, gain.estimate, gain.high)]
    [-0.15, -0.1, -0.07]
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
        """Whether the interval excludes 0, so that the sign is significant."""
        return self.low > 0.0 or self.high < 0.0

    @property
    def texts(self) -> Phrase:
        """The interval where it excludes 0, in both languages: "−48 to −20 points", points being per cent."""
        if self.pairs == 0:
            return phrase("fragility.difference_unknown")
        if not self.clear:
            return phrase("fragility.no_clear_difference")
        return phrase("fragility.difference", low=percent(self.low), high=percent(self.high))

    @property
    def text(self) -> str:
        """The difference in English words; see `texts`."""
        return self.texts[0]


def difference(
    first: ArrayLike, second: ArrayLike, missing: ArrayLike | None = None, *, comparisons: int = 1
) -> Difference:
    """Return how much likelier something is in the first runs than in the second.

    Parameters
    ----------
    first, second : array_like of bool, shape (motions, samples)
        Whether it happened, run by run with the same motion and the same draw.
    missing : array_like of bool, same shape, optional
        Pairs of which a run was given up.
    comparisons : int
        How many are compared with the second runs: their 95 % intervals hold together, and so for the best.

    Returns
    -------
    Difference
        With only one motion the pairs are taken as independent: the interval is then one for that motion.

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
    '−45 to −15 points'
    """
    a, given_up = checked_runs(first, missing)
    b, _ = checked_runs(second, missing)
    if a.shape != b.shape:
        raise not_allowed(phrase("common.shape_of", name="second"), str(b.shape), str(a.shape))
    motion = np.indices(a.shape)[0].ravel()
    return difference_of_runs(a.ravel(), b.ravel(), given_up.ravel(), motion, comparisons=comparisons)


def difference_of_runs(
    first: NDArray[np.bool_],
    second: NDArray[np.bool_],
    missing: NDArray[np.bool_],
    motion: NDArray[np.intp],
    *,
    comparisons: int = 1,
) -> Difference:
    """Return the same from pairs of runs one by one.

    Parameters
    ----------
    first, second, missing : ndarray of bool, shape (pairs,)
        As of `difference`.
    motion : ndarray of int, shape (pairs,)
        The number of each pair's motion.
    comparisons : int
        As of `difference`.
    """
    more, fewer = first & ~second & ~missing, second & ~first & ~missing
    d = np.bincount(motion, more.astype(np.float64) - fewer).astype(np.float64)
    n = np.bincount(motion, ~missing).astype(np.float64)
    d, n = d[n > 0.0], n[n > 0.0]
    lost, pairs, up, down = int(missing.sum()), int(n.sum()), int(more.sum()), int(fewer.sum())
    if pairs == 0:
        return Difference(math.nan, -1.0, 1.0, 0, 0, 0, lost)
    independent = pairs / design_effect(d, n, _WEIGHT, -1.0, up + down)
    share, confidence = independent / pairs, 1.0 - (1.0 - CONFIDENCE) / comparisons
    low, high = score_interval(up * share, down * share, independent, confidence)
    if len(n) > 1:
        half = _student_half_width(d, n, confidence)
        middle = float(d.sum() / n.sum())
        low, high = min(low, max(middle - half, -1.0)), max(high, min(middle + half, 1.0))
    return Difference((up - down) / pairs, low, high, up, down, pairs, lost)


def _student_half_width(d: NDArray[np.float64], n: NDArray[np.float64], confidence: float) -> float:
    """Return the half width of Student's t interval of the ratio of the motions' sums of d and n."""
    count, total = len(n), float(n.sum())
    scatter = float(((d - float(d.sum()) / total * n) ** 2).sum())
    return student(count, confidence) * math.sqrt(count / (count - 1.0) * scatter) / total


def score_interval(
    more: float, fewer: float, pairs: float, confidence: float = CONFIDENCE
) -> tuple[float, float]:
    """Return the score interval of a difference of paired proportions (Tango 1998, equations 8 to 11).

    Parameters
    ----------
    more, fewer : float
        Pairs in which it happened in the first only, and in the second only; they need not be whole.
    pairs : float
        All pairs, independent of each other.
    confidence : float
        How often the interval holds the truth.

    Examples
    --------
    >>> [round(end, 4) for end in score_interval(0, 0, 10)]
    [-0.2775, 0.2775]
    """
    z = float(ndtri(0.5 + 0.5 * confidence))
    middle = (more - fewer) / pairs

    def inside(difference: float) -> bool:
        # 2 n q² + (−b − c + (2 n − b + c) δ) q − c δ (1 − δ) = 0 has the likeliest share q of pairs that
        # differ for the second only, if the difference is δ
        linear = -more - fewer + (2.0 * pairs - more + fewer) * difference
        root = math.sqrt(max(linear**2 + 8.0 * pairs * fewer * difference * (1.0 - difference), 0.0))
        q = (root - linear) / (4.0 * pairs)
        variance = pairs * max(2.0 * q + difference * (1.0 - difference), 0.0)
        return (more - fewer - pairs * difference) ** 2 <= z * z * variance

    return _edge(inside, middle, -1.0), _edge(inside, middle, 1.0)


def _edge(inside: Callable[[float], bool], start: float, end: float) -> float:
    """Return the boundary of a range between ``start``, which is inside, and ``end``."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (start + end)
        start, end = (middle, end) if inside(middle) else (start, middle)
    return end
