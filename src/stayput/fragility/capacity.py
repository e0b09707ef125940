"""The intensity at which a share of the pieces falls, with an interval, and in words where there is none."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import ndtri

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.observed import Level
    from stayput.fragility.trials import Trials


@dataclass(frozen=True, slots=True)
class Capacity:
    """An intensity at which a given share falls. Nothing outside what was run is ever given as a number.

    Parameters
    ----------
    measure : IntensityMeasure
        What the values are.
    share : float
        The share that falls.
    estimate : float
        The intensity [SI]; NaN where the runs only say that it lies above, below or between others.
    above, below : float
        The intensities that were run and that it lies between, as far as seen: −∞ (0 for a peak) or ∞
        where none.
    low, high : float
        Ends of the 95 % interval [SI]; −∞ (0) or ∞ where it is open within what was run.
    """

    measure: IntensityMeasure
    share: float
    estimate: float
    above: float
    below: float
    low: float
    high: float

    @property
    def sure(self) -> bool:
        """Whether what the text says of a capacity without an estimate holds with 95 % confidence."""
        return self.low >= self.above and self.high <= self.below

    @property
    def text(self) -> str:
        """The capacity in words: "6.12 (5.95 to 6.33)", "> 6.90", "between 5.50 and 5.75"."""
        show = self.measure.text
        least = -math.inf if self.measure.is_logarithm else 0.0
        if not math.isnan(self.estimate):
            low = "below what was run" if self.low <= least else show(self.low, unit=False)
            high = "beyond what was run" if math.isinf(self.high) else show(self.high, unit=False)
            return f"{show(self.estimate)} ({low} to {high})"
        unsure = "" if self.sure else " (unsure)"
        if self.above > least and math.isfinite(self.below):
            return f"between {show(self.above, unit=False)} and {show(self.below)}{unsure}"
        if self.above > least:
            return f"> {show(self.above)}{unsure}"
        if math.isfinite(self.below):
            return f"< {show(self.below)}{unsure}"
        return "unknown"


def fitted_capacity(
    trials: Trials, share: float, ab: NDArray[np.float64], covariance: NDArray[np.float64], t: float
) -> Capacity:
    """Return the capacity of a fitted curve p = Φ(a + b u), with Fieller's interval (Fieller 1954).

    The interval holds the u at which the band about a + b u has the share's quantile z inside:
    (a + b u − z)² ≤ t² (V_aa + 2 u V_ab + u² V_bb).

    Parameters
    ----------
    trials : Trials
        What was run.
    share : float
        The share that falls.
    ab, covariance : ndarray, shapes (2,), (2, 2)
        Parameters in the measure's coordinate u, and their covariance.
    t : float
        Quantile of the interval.
    """
    z = float(ndtri(share))
    a, b = float(ab[0]) - z, float(ab[1])
    (v_aa, v_ab), (_, v_bb) = (t * t * covariance).tolist()
    two, one, zero = b * b - v_bb, a * b - v_ab, a * a - v_aa
    low, high = -math.inf, math.inf
    if two > 0.0:
        root = math.sqrt(max(one * one - two * zero, 0.0))
        low, high = (-one - root) / two, (-one + root) / two
    u = -a / b
    runs = trials.measure.coordinate(trials.im)
    first, last = float(runs.min()), float(runs.max())
    low, high = low if low >= first else -math.inf, high if high <= last else math.inf
    above, below = -math.inf if u < first else first, math.inf if u > last else last
    if u < first:
        below = first
    if u > last:
        above = last
    estimate = u if first <= u <= last else math.nan
    # what is said where there is no estimate is sure only as far as the interval reaches
    if u > last:
        low = last if _reaches(a, b, v_aa, v_ab, v_bb, last) > 0.0 else low
    if u < first:
        high = first if _reaches(a, b, v_aa, v_ab, v_bb, first) > 0.0 else high
    ends = (float(trials.measure.value(end)) for end in (estimate, above, below, low, high))
    return Capacity(trials.measure, share, *ends)


def _reaches(a: float, b: float, v_aa: float, v_ab: float, v_bb: float, u: float) -> float:
    """Return by how much the curve at u differs from the share, squared, less the same of the band."""
    return (a + b * u) ** 2 - (v_aa + 2.0 * u * v_ab + u * u * v_bb)


def bracketed_capacity(trials: Trials, levels: tuple[Level, ...], share: float) -> Capacity:
    """Return the capacity without a curve: between the highest intensity with a smaller and the lowest with
    a larger share of falls; the interval is between those whose own intervals leave the share out.
    """  # noqa: D205
    least = -math.inf if trials.measure.is_logarithm else 0.0
    values, place = np.unique(trials.im, return_inverse=True)
    shares = np.bincount(place, trials.fell) / np.bincount(place, trials.runs)
    above = max((float(im) for im, p in zip(values, shares, strict=True) if p < share), default=least)
    below = min((float(im) for im, p in zip(values, shares, strict=True) if p >= share), default=math.inf)
    low = max((level.lowest for level in levels if level.probability.high < share), default=least)
    high = min((level.highest for level in levels if level.probability.low > share), default=math.inf)
    return Capacity(trials.measure, share, math.nan, above, below, low, high)


def unknown_capacity(trials: Trials, share: float) -> Capacity:
    """Return the capacity of which the runs say nothing."""
    least = -math.inf if trials.measure.is_logarithm else 0.0
    return Capacity(trials.measure, share, math.nan, least, math.inf, least, math.inf)
