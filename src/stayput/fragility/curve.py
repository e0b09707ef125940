"""A fragility curve: the probability of falling over an intensity, fitted by maximum likelihood."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from enum import StrEnum
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import ndtr

from stayput.errors import within
from stayput.fragility.capacity import (
    Capacity,
    bracketed_capacity,
    fitted_capacity,
    unknown_capacity,
)
from stayput.fragility.observed import Level, observed_levels
from stayput.fragility.probabilities import student
from stayput.fragility.probit import derivatives, fit, information, separated, solved

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.trials import Trials


_DECISIVE = 1e-6
"""Share of the information's determinant that must be left without any one motion."""

_UNKNOWN = 1e12
"""Variance of a parameter that is not known."""


class State(StrEnum):
    """Whether there is a curve, and why not."""

    FITTED = "fitted"
    NONE_FELL = "none fell"
    ALL_FELL = "all fell"
    ABRUPT = "abrupt"
    ONE_LEVEL = "one level"
    NO_TREND = "no trend"


@dataclass(frozen=True, slots=True, eq=False)
class FragilityCurve:
    """The probability of falling p = Φ((u − μ)/β), with u the intensity I or the logarithm of a peak.

    Parameters
    ----------
    name : str
        What it is the curve of.
    trials : Trials
        What it was fitted to.
    state : State
        Whether there is a curve; what follows is NaN where there is none.
    ab, covariance : ndarray, shapes (2,), (2, 2)
        Parameters of p = Φ(a + b u), and their covariance.
    levels : tuple of Level
        Observed shares, from the weakest level to the strongest.
    """

    name: str
    trials: Trials
    state: State
    ab: NDArray[np.float64]
    covariance: NDArray[np.float64]
    levels: tuple[Level, ...] = field(repr=False)

    @property
    def measure(self) -> IntensityMeasure:
        """What the curve is drawn against."""
        return self.trials.measure

    @property
    def median(self) -> float:
        """Parameter θ [SI], or μ of an intensity. It may lie outside what was run: `capacity` never does."""
        return float(self.measure.value(-self.ab[0] / self.ab[1]))

    @property
    def dispersion(self) -> float:
        """Parameter β: standard deviation of the logarithm of the peak, or of the intensity, at falling."""
        return float(1.0 / self.ab[1])

    @property
    def dispersion_interval(self) -> tuple[float, float]:
        """95 % interval of β."""
        half = self._quantile * math.sqrt(self.covariance[1, 1])
        slope = float(self.ab[1])
        return 1.0 / (slope + half), 1.0 / (slope - half) if slope > half else math.inf

    @property
    def log_dispersion(self) -> float:
        """Standard deviation of the logarithm of the shaking: β of a peak, β ln(10)/2 of an intensity."""
        return self.dispersion * (0.5 * math.log(10.0) if self.measure.is_logarithm else 1.0)

    @property
    def _quantile(self) -> float:
        motion = self.trials.motion
        return student(round(float(self.trials.runs.sum())) if motion is None else int(motion.max()) + 1)

    def _linear(self, im: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        u = self.measure.coordinate(im)
        v = self.covariance
        variance = v[0, 0] + 2.0 * u * v[0, 1] + u * u * v[1, 1]
        return self.ab[0] + self.ab[1] * u, self._quantile * np.sqrt(np.maximum(variance, 0.0))

    def probability(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return the probability of falling at intensities [SI]."""
        return ndtr(self._linear(im)[0])

    def band(self, im: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the ends of the 95 % interval of the probability at each intensity [SI]."""
        middle, half = self._linear(im)
        return ndtr(middle - half), ndtr(middle + half)

    def capacity(self, share: float = 0.5) -> Capacity:
        """Return the intensity at which a share of the pieces falls.

        Raises
        ------
        InputError
            A share that is not between 0.001 and 0.999.
        """
        share = within("Share", share, 1e-3, 1.0 - 1e-3)
        if self.state is State.FITTED:
            return fitted_capacity(self.trials, share, self.ab, self.covariance, self._quantile)
        if self.state is State.NO_TREND:
            return unknown_capacity(self.trials, share)
        return bracketed_capacity(self.trials, self.levels, share)

    @property
    def misfit(self) -> float:
        """Largest difference between an observed share and the curve."""
        return max(
            abs(level.probability.estimate - float(self.probability(level.im))) for level in self.levels
        )

    @property
    def text(self) -> str:
        """What the runs say, in a sentence."""
        measure = self.measure
        runs, first, last = f"{int(self.trials.runs.sum())} runs", self.levels[0], self.levels[-1]
        if self.state is State.FITTED:
            return f"Half fall at {measure.key} {self.capacity(0.5).text}, 10 % at {self.capacity(0.1).text}."
        if self.state is State.NONE_FELL:
            return f"None of {runs} fell, up to {measure.key} {measure.text(last.highest)}."
        if self.state is State.ALL_FELL:
            return f"All of {runs} fell, from {measure.key} {measure.text(first.lowest)} on."
        if self.state is State.ONE_LEVEL:
            return (
                f"At {measure.key} {measure.text(first.im)} {first.probability.text} fell; no other was run."
            )
        if self.state is State.ABRUPT:
            return (
                "No level has falls and a higher one runs that stood, so there is no curve: "
                f"half fall at {measure.key} {self.capacity(0.5).text}."
            )
        return f"The share of falls does not grow with {measure.key} in {runs}, so there is no curve."


def fragility_curve(trials: Trials, name: str = "") -> FragilityCurve:
    """Fit a fragility curve by maximum likelihood.

    Runs of one motion are alike, so the covariance of the parameters is that of the jackknife over the
    motions, to first order (MacKinnon, Nielsen and Webb 2023); without motions it is the inverse of the
    observed information.

    Parameters
    ----------
    trials : Trials
        What was run.
    name : str
        What it is the curve of.

    Returns
    -------
    FragilityCurve
        Its ``state`` says whether there is a curve.

    Examples
    --------
    >>> from stayput.fragility import PGA, Trials
    >>> curve = fragility_curve(Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 20, 36], [40, 40, 40]))
    >>> round(curve.median, 3), round(curve.dispersion, 3)
    (4.0, 0.541)
    """
    u = trials.measure.coordinate(trials.im)
    levels = observed_levels(trials)
    fell, stood = trials.fell[np.newaxis], (trials.runs - trials.fell)[np.newaxis]
    state = _state(u, fell, stood)
    nothing = np.full(2, np.nan), np.full((2, 2), np.nan)
    if state is not State.FITTED:
        return FragilityCurve(name, trials, state, *nothing, levels)
    middle, spread = float(u.mean()), float(u.std())
    v = (u - middle) / spread
    ab = fit(v, fell, stood)
    if not ab[0, 1] > 0.0:
        return FragilityCurve(name, trials, State.NO_TREND, *nothing, levels)
    slope, curvature = derivatives(v, fell, stood, ab)
    covariance = _covariance(v, slope[0], curvature[0], trials.motion)
    # from v to u: b_u = b_v / spread, a_u = a_v − b_u middle
    turn = np.array([[1.0, -middle / spread], [0.0, 1.0 / spread]])
    in_u = np.einsum("ij,jk,lk->il", turn, covariance, turn)
    return FragilityCurve(name, trials, state, np.einsum("ij,j->i", turn, ab[0]), in_u, levels)


def _determinant(matrices: NDArray[np.float64]) -> NDArray[np.float64]:
    return matrices[:, 0, 0] * matrices[:, 1, 1] - matrices[:, 0, 1] * matrices[:, 1, 0]


def _state(u: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64]) -> State:
    if fell.sum() == 0.0:
        return State.NONE_FELL
    if stood.sum() == 0.0:
        return State.ALL_FELL
    if u.min() == u.max():
        return State.ONE_LEVEL
    (first_fall,), (last_fall,), (first_stand,), (last_stand,) = separated(u, fell, stood)
    if last_stand <= first_fall:
        return State.ABRUPT
    return State.NO_TREND if last_fall <= first_stand else State.FITTED


def _covariance(
    v: NDArray[np.float64],
    slope: NDArray[np.float64],
    curvature: NDArray[np.float64],
    motion: NDArray[np.intp] | None,
) -> NDArray[np.float64]:
    """Return the covariance of (a, b): without motions H⁻¹; with them (M − 1)/M Σ δ δᵀ, δ = (H − H_m)⁻¹ s_m.

    H is the information, H_m and s_m a motion's part of it and its score; δ is the change of (a, b) when
    the motion is left out, by one step of Newton's. Where all hangs on one motion it is as good as infinite.
    """
    whole = information(v, curvature[np.newaxis])
    if motion is None:
        (p, q), (_, r) = whole[0].tolist()
        return np.array([[r, -q], [-q, p]]) / (p * r - q * q)
    terms = (slope, slope * v, curvature, curvature * v, curvature * v * v)
    s_a, s_b, h_aa, h_ab, h_bb = (np.bincount(motion, term).astype(np.float64) for term in terms)
    part = np.stack((h_aa, h_ab, h_ab, h_bb), axis=1).reshape(-1, 2, 2)
    left = whole - part
    if _determinant(left).min() < _DECISIVE * float(_determinant(whole)[0]):
        return np.diag((_UNKNOWN, _UNKNOWN))
    change = solved(left, np.stack((s_a, s_b), axis=1))
    count = len(change)
    return (count - 1.0) / count * np.einsum("mi,mj->ij", change, change)
