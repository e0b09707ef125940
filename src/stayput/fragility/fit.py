r"""A logit fit of what happens over an intensity: the posterior of its parameters on a grid.

    p(u) = γ + (δ − γ) / (1 + exp(−(a + b (u − u₀))))

u is the intensity, or the logarithm of a peak, and u₀ its mean over the runs. A share γ falls however weak
the shaking is: without it a single fall far below the others would flatten the whole curve. A share 1 − δ
stands however strong it is: on a slippery floor some draws slide and do not rock. The prior of a is that of
Jeffreys for the share at u₀. That of the slope b is wide, but says what the curves of much furniture have in
common: few runs at few levels do not tell it by themselves. Each of `LIMITS` is as likely as the others.

Runs of one motion are alike. The log-likelihood is therefore divided by their design effect (Kish 1965),
estimated from how far the counts of each motion are from the curve as in `stayput.fragility.probabilities`,
and by the squared ratio of the quantiles of Student's t and of the normal distribution, as motions are few.

The difference of two shares at u = 0 has the interval of Zou and Donner (2008), whose ends come from those of
the two and from their correlation, as Newcombe's (1998) of paired proportions do.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import expit, log_expit, logit, ndtri

from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY
from stayput.fragility.paired import Difference
from stayput.fragility.probabilities import CONFIDENCE, Probability, effect_of_residuals, quantile

if TYPE_CHECKING:
    from stayput.fragility.intensity_measures import IntensityMeasure

LIMITS = ((0.0, 1.0), (0.01, 0.99), (0.03, 0.97), (0.0, 0.85), (0.0, 0.65))
"""Pairs of γ and δ."""

SLOPE, SLOPE_SCATTER = 4.8, 0.45
"""Median of b for each e-fold of the shaking, and the standard deviation of its logarithm.

Counted curves of furniture in space have 5.6 to 6.6 for a unit of JMA's intensity, which is 1.15 e-folds."""

PEAK_SLOPE, PEAK_SCATTER = 3.3, 0.6
"""The same over any other measure, in which motions of the same JMA intensity differ."""

EFOLDS = 0.5 * math.log(10.0)
"""E-folds of the shaking in a unit of an intensity: JMA's is 2 log10 of it and a constant."""

_FINDING, _POINTS = (25, 13), (61, 25)
"""Points along a and ln b of two grids that find where there is weight, and of the one over that part."""

_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
"""The golden section, of which multiples are spread evenly over a step."""

_MOST_CELLS = 64
"""Most coordinates of runs that are told apart: a verification has three levels of JMA's intensity, and as
many peaks as motions at each."""

_NO_WEIGHT = 1e-6
"""Weight of a point, in that of the likeliest, below which it is left out."""

_LARGEST_LOGIT = 9.0
"""Logit of the share at u₀ beyond which no grid reaches: 1 in 8,000."""

_STEEPEST = 700.0
"""Logit beyond which a share would round to 0, which has no logarithm."""

_SHRINKS = 4.0
"""Runs without a correlation that are added before that of two options is estimated."""


def _cells(u: NDArray[np.float64], runs: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Return different coordinates, and of which of them each is; where they are many, means of near ones."""
    x, of_cell = np.unique(u, return_inverse=True)
    if len(x) <= _MOST_CELLS:
        return x, of_cell
    _, of_cell = np.unique(np.rint((u - x[0]) / (x[-1] - x[0]) * _MOST_CELLS), return_inverse=True)
    return np.bincount(of_cell, u * runs) / np.bincount(of_cell, runs), of_cell


def _staggered(
    first: NDArray[np.float64], second: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the points of a grid of even axes, each row and column shifted by another part of a step.

    So no two points have the same coordinate, and quantiles of each are as fine as there are points.
    """
    rows, columns = (np.arange(len(axis)) * _GOLDEN % 1.0 - 0.5 for axis in (first, second))
    a = first[:, np.newaxis] + (first[1] - first[0]) * columns
    b = second + (second[1] - second[0]) * rows[:, np.newaxis]
    return a, b


@dataclass(frozen=True, slots=True, eq=False)
class LogitFit:
    """The posterior of the parameters of a curve, by points.

    Parameters
    ----------
    middle : float
        u₀.
    a, b, gamma, delta, weight : ndarray, shape (points,)
        Parameters of each point, and its probability.
    design_effect : float
        Runs over independent runs that would tell as much.
    """

    middle: float
    a: NDArray[np.float64]
    b: NDArray[np.float64]
    gamma: NDArray[np.float64]
    delta: NDArray[np.float64]
    weight: NDArray[np.float64]
    design_effect: float = 1.0

    @classmethod
    def of(
        cls,
        measure: IntensityMeasure,
        u: NDArray[np.float64],
        fell: NDArray[np.float64],
        runs: NDArray[np.float64],
        motion: NDArray[np.intp] | None = None,
    ) -> Self:
        """Fit a curve to counts.

        Parameters
        ----------
        measure : IntensityMeasure
            Of which u are coordinates.
        u, fell, runs : ndarray, shape (cells,)
            Coordinate, falls and runs of each cell; each has runs.
        motion : ndarray of int, shape (cells,), optional
            The number of each cell's motion; None where all runs are independent.
        """
        middle = float(np.average(u, weights=runs))
        x, of_cell = _cells(u - middle, runs)
        falls, stands = (np.bincount(of_cell, k).astype(np.float64) for k in (fell, runs - fell))
        if motion is None:
            return cls._posterior(measure, middle, x, falls, stands)
        motions, effect = len(np.unique(motion)), 1.0
        if runs.sum() > motions:  # runs that have a motion each are independent
            expected = cls._posterior(measure, middle, x, falls, stands).mean(middle + x)[of_cell]
            effect = effect_of_residuals(fell - runs * expected, runs, expected, motion)
        few = quantile(motions, round(runs.sum())) / float(ndtri(0.5 + 0.5 * CONFIDENCE))
        loss = effect * few * few
        return cls._posterior(measure, middle, x, falls / loss, stands / loss, effect)

    @classmethod
    def _posterior(
        cls,
        measure: IntensityMeasure,
        middle: float,
        x: NDArray[np.float64],
        falls: NDArray[np.float64],
        stands: NDArray[np.float64],
        effect: float = 1.0,
    ) -> Self:
        of_jma = measure in (JMA_INTENSITY, FLOOR_JMA)
        slope, scatter = (SLOPE, SLOPE_SCATTER) if of_jma else (PEAK_SLOPE, PEAK_SCATTER)
        usual = math.log(slope * (EFOLDS if measure.is_logarithm else 1.0))

        gamma, delta = np.transpose(LIMITS)[:, :, np.newaxis, np.newaxis]

        def weights(a: NDArray[np.float64], log_b: NDArray[np.float64]) -> NDArray[np.float64]:
            """Return the posterior at each pair of limits and each point of a grid, the largest being 1."""
            each = 0.5 * (log_expit(a) + log_expit(-a)) - 0.5 * ((log_b - usual) / scatter) ** 2
            for of_cell, fallen, standing in zip(x, falls, stands, strict=True):
                z = (a + np.exp(log_b) * of_cell).clip(-_STEEPEST, _STEEPEST)
                if fallen > 0.0:
                    each = each + fallen * np.log(gamma + (delta - gamma) * expit(z))
                if standing > 0.0:  # not of 1 − p, which rounding loses where p is nearly 1
                    each = each + standing * np.log((1.0 - delta) + (delta - gamma) * expit(-z))
            return np.exp(each - each.max())

        ends = [(-_LARGEST_LOGIT, _LARGEST_LOGIT), (usual - 4.0 * scatter, usual + 4.0 * scatter)]
        for _ in range(2):
            axes = [np.linspace(*end, points) for end, points in zip(ends, _FINDING, strict=True)]
            weight = weights(*_staggered(*axes))
            for axis, others in enumerate(((0, 2), (0, 1))):
                some = np.flatnonzero(weight.max(axis=others) > _NO_WEIGHT)
                first, last = max(int(some[0]) - 1, 0), min(int(some[-1]) + 1, len(axes[axis]) - 1)
                ends[axis] = float(axes[axis][first]), float(axes[axis][last])
        a, log_b = _staggered(*(np.linspace(*end, points) for end, points in zip(ends, _POINTS, strict=True)))
        weight = weights(a, log_b)
        chosen = weight > _NO_WEIGHT
        points = np.broadcast_arrays(a, np.exp(log_b), gamma, delta)
        a, b, gamma, delta = (column[chosen] for column in points)
        return cls(middle, a, b, gamma, delta, weight[chosen] / weight[chosen].sum(), effect)

    def _shares(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return p of each point at each coordinate, shape (points, coordinates)."""
        z = self.a[:, np.newaxis] + self.b[:, np.newaxis] * (u - self.middle)
        gamma, delta = self.gamma[:, np.newaxis], self.delta[:, np.newaxis]
        return gamma + (delta - gamma) * expit(z)

    def mean(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the mean of the probability at coordinates."""
        different, of_each = np.unique(u, return_inverse=True)  # runs are at a few levels
        return (self.weight @ self._shares(different))[of_each]

    def probability(self, u: ArrayLike, confidence: float = CONFIDENCE) -> NDArray[np.float64]:
        """Return lower end, median and upper end of the probability at coordinates, shape (3, ...)."""
        at = np.asarray(u, np.float64)
        each = [self._quantiles(shares, confidence) for shares in self._shares(at.ravel()).T]
        return np.array(each).reshape(-1, 3).T.reshape(3, *at.shape)

    def coordinate(self, share: float) -> NDArray[np.float64]:
        """Return lower end, median and upper end of where a share is reached; ±∞ where nowhere."""
        with np.errstate(invalid="ignore", divide="ignore"):
            risen = np.clip((share - self.gamma) / (self.delta - self.gamma), 0.0, 1.0)
            return self._quantiles(self.middle + (logit(risen) - self.a) / self.b)

    @property
    def slope(self) -> float:
        """Median of b."""
        return float(self._quantiles(self.b)[1])

    def _quantiles(self, values: NDArray[np.float64], confidence: float = CONFIDENCE) -> NDArray[np.float64]:
        order = np.argsort(values, kind="stable")
        tails = 0.5 * (1.0 - confidence), 0.5, 0.5 * (1.0 + confidence)
        place = np.searchsorted(np.cumsum(self.weight[order]), tails)
        return values[order][place.clip(max=len(order) - 1)]


@dataclass(frozen=True, slots=True, eq=False)
class RunsAround:
    """Whether something happened in runs at several levels around one in question.

    Parameters
    ----------
    measure : IntensityMeasure
        Of which u are coordinates.
    u : ndarray, shape (runs,)
        Coordinate of each run; 0 is that in question.
    happened, missing : ndarray of bool, shape (runs,)
        Whether it happened; whether the run was given up.
    motion : ndarray of int, shape (runs,)
        The number of each run's motion.
    """

    measure: IntensityMeasure
    u: NDArray[np.float64]
    happened: NDArray[np.bool_]
    missing: NDArray[np.bool_]
    motion: NDArray[np.intp]

    def fit(self, *, missing_as: bool | None = None) -> LogitFit:
        """Return the fit to the runs, those given up left out, or counted as having it happen or not."""
        happened = np.where(self.missing, bool(missing_as), self.happened)
        used = ~self.missing if missing_as is None else np.ones_like(self.missing)
        columns = (self.u[used], happened[used], self.motion[used])
        return _fit(self.measure, *(np.ascontiguousarray(column).tobytes() for column in columns))

    def probability(self) -> Probability:
        """Return the probability at coordinate 0; the counts are of the runs there."""
        here, known = self.u == 0.0, ~self.missing
        lost, runs = int((here & self.missing).sum()), here & known
        if not known.any():
            return Probability(math.nan, 0.0, 1.0, 0, 0, 0, lost, math.nan)
        fit = self.fit()
        each = self.fit(missing_as=False), fit, self.fit(missing_as=True)
        low, estimate, high = (_at_zero(fitted, CONFIDENCE)[end] for end, fitted in enumerate(each))
        counts = int((self.happened & runs).sum()), int(runs.sum()), len(np.unique(self.motion[runs]))
        return Probability(estimate, low, high, *counts, lost, fit.design_effect)

    def difference(self, other: RunsAround, comparisons: int = 1) -> Difference:
        """Return how much likelier it is at coordinate 0 than in other runs.

        Parameters
        ----------
        other : RunsAround
            The others: those with the same place in both arrays have the same motion, draw and level. One may
            have more.
        comparisons : int
            As of `stayput.fragility.paired.difference`.
        """
        both = slice(min(len(self.u), len(other.u)))
        known = ~(self.missing[both] | other.missing[both])
        here = known & (self.u[both] == 0.0)
        first, second = self.happened[both] & here, other.happened[both] & here
        more, fewer = int((first & ~second).sum()), int((second & ~first).sum())
        lost = int((~known & (self.u[both] == 0.0)).sum())
        if not known.any():
            return Difference(math.nan, -1.0, 1.0, 0, 0, 0, lost)
        confidence = 1.0 - (1.0 - CONFIDENCE) / comparisons
        fits, u = (self.fit(), other.fit()), self.u[both][known]
        (l1, p1, u1), (l2, p2, u2) = (_at_zero(fit, confidence) for fit in fits)
        expected = [fit.mean(u) for fit in fits]
        r1, r2 = (runs.happened[both][known] - p for runs, p in zip((self, other), expected, strict=True))
        scatter = np.prod([_SHRINKS * 0.25 + (p * (1.0 - p)).sum() for p in expected])
        alike = max(0.0, float((r1 * r2).sum()) / math.sqrt(scatter))
        alike *= math.sqrt(min(len(self.u), len(other.u)) / max(len(self.u), len(other.u)))

        def side(first: float, second: float) -> float:
            return math.sqrt(max(first * first + second * second - 2.0 * alike * first * second, 0.0))

        low, high = p1 - p2 - side(p1 - l1, u2 - p2), p1 - p2 + side(u1 - p1, p2 - l2)
        return Difference(p1 - p2, low, high, more, fewer, int(here.sum()), lost)


@lru_cache(maxsize=4096)
def _fit(measure: IntensityMeasure, u: bytes, happened: bytes, motion: bytes) -> LogitFit:
    """Return the fit to runs; cached, as the same is often asked of a piece and of all pieces."""
    x, fell = np.frombuffer(u), np.frombuffer(happened, np.bool_).astype(np.float64)
    return LogitFit.of(measure, x, fell, np.ones(len(x)), np.frombuffer(motion, np.intp))


@lru_cache(maxsize=4096)
def _at_zero(fit: LogitFit, confidence: float) -> list[float]:
    """Return the probability at coordinate 0; cached for the same reason."""
    return fit.probability(0.0, confidence).tolist()
