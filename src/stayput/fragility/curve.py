"""Fragility curves: the probability of falling over an intensity, and the capacities that it gives."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import instance_of, within
from stayput.fragility.fit import EFOLDS, LogitFit
from stayput.fragility.trials import Level, Trials, observed_levels
from stayput.saved import InJson
from stayput.wording import check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.fragility.intensity_measures import IntensityMeasure

METHOD = "logit"
"""Name of the method by which every curve is fitted, in data and texts."""

REACH = 0.41
"""How far a curve goes beyond what was run, in e-folds of the shaking: 0.36 of JMA's intensity.

The usual runs are at the stated shaking and at 0.4 of intensity to either side, so that the curve is told to
within 0.75 of the stated one. Farther out the prior of the slope says more than the runs."""

PROBIT = 1.702
"""Slope of a logit curve over that of the nearest probit curve, from which it is nowhere 1 % off."""


@dataclass(frozen=True, slots=True)
class Capacity:
    """The intensity at which a given share falls; no number where it lies beyond the curve.

    Parameters
    ----------
    measure : IntensityMeasure
        What the values are.
    share : float
        The share that falls.
    estimate : float
        The intensity [SI]; NaN where it lies beyond the curve.
    low, high : float
        Ends of the 95 % interval [SI]; −∞ (0 of a peak) or ∞ where they lie beyond the curve.
    bound : float or None
        The end of the curve beyond which the estimate lies [SI]; None where it lies on the curve.
    """

    measure: IntensityMeasure
    share: float
    estimate: float
    low: float
    high: float
    bound: float | None = None

    @property
    def ends(self) -> Phrase:
        """The interval in both languages: "5.95 to 6.33"; "at most 6.33" where its low end was not run."""
        low = None if self.low <= self.measure.least else self.measure.text(self.low, unit=False)
        high = None if math.isinf(self.high) else self.measure.text(self.high, unit=False)
        if low is None and high is None:
            return phrase("fragility.ends_not_run")
        if low is None:
            return phrase("fragility.at_most", high=high)
        return phrase("fragility.more_than" if high is None else "fragility.ends", low=low, high=high)

    @property
    def value(self) -> Phrase:
        """The capacity without its interval: "6.12", or "> 6.36" where it lies beyond the curve."""
        show = self.measure.text
        if self.bound is None:
            return show(self.estimate), show(self.estimate)
        if math.isinf(self.high) and self.low > self.measure.least:
            return phrase("fragility.capacity_above", above=show(max(self.low, self.bound)))
        if math.isfinite(self.high):
            return phrase("fragility.capacity_below", below=show(min(self.high, self.bound)))
        return phrase("common.unknown")

    @property
    def has_interval(self) -> bool:
        """Whether its interval says anything: not where it all lies beyond the curve, or is unknown."""
        bound, least = self.bound, self.measure.least
        return bound is None or least < self.low < bound or bound < self.high < math.inf

    @property
    def texts(self) -> Phrase:
        """The capacity in both languages: "6.12 (5.95 to 6.33)", "> 6.36 (more than 6.21)", "< 5.3"."""
        if not self.has_interval:
            return self.value
        return phrase("fragility.capacity", value=self.value, ends=self.ends)

    @property
    def text(self) -> str:
        """The capacity in English words; see `texts`."""
        return self.texts[0]


class LognormalParameters(NamedTuple):
    """The curve Φ((u − μ)/β) nearest to a fit: lognormal over a peak, normal over an intensity.

    Parameters
    ----------
    median : float
        Parameter θ = exp μ [SI], or μ of an intensity.
    dispersion : float
        Parameter β: standard deviation of the logarithm of the peak, or of the intensity, at falling.
    """

    median: float
    dispersion: float


@dataclass(frozen=True, eq=False, repr=False)
class FragilityCurve(InJson):
    """The probability of falling over an intensity: a fit to runs, see `stayput.fragility.fit`.

    Parameters
    ----------
    name : str
        What it is the curve of.
    trials : Trials
        What it is fitted to.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.fragility.intensity_measures import PGA
    >>> trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    >>> curve = sp.FragilityCurve("bookcase", trials)
    >>> curve.capacity(0.5).text, curve.levels[1].probability.text
    ('4.04 m/s² (3.46 to 4.72)', 'about 50 % (33 to 63 %)')
    >>> f"median {curve.lognormal.median:.2f} m/s², dispersion {curve.lognormal.dispersion:.2f}"
    'median 4.04 m/s², dispersion 0.49'
    """

    name: str
    trials: Trials

    def __post_init__(self) -> None:
        instance_of("name", self.name, str)
        instance_of("trials", self.trials, Trials)

    def __repr__(self) -> str:
        return f"FragilityCurve({self.name!r}, {self.measure.key}; {self.capacity().text})"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import curve_html

        return curve_html(self)

    def plot(self, ax: Axes | None = None, *, language: str = "en", **line: Any) -> Axes:
        """Draw the curve with its 95 % band, and the observed shares with their 95 % intervals.

        Drawn on the axes of other curves it looks different from them and joins their legend.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        language : str
            Language of the texts, "en" or "ja".
        **line
            How the line looks, as for ``Axes.plot``: ``label``, ``color``, ...

        Raises
        ------
        InputError
            The axes hold a curve over another intensity measure.
        """
        from stayput.report.figures import plotted
        from stayput.report.fragility import draw_curve

        return plotted(ax, draw_curve, self, check_language(language), **line)

    @property
    def measure(self) -> IntensityMeasure:
        """The intensity measure of the curve."""
        return self.trials.measure

    @cached_property
    def levels(self) -> tuple[Level, ...]:
        """Observed shares, from the weakest level to the strongest."""
        return observed_levels(self.trials)

    @cached_property
    def fit(self) -> LogitFit:
        """The fit."""
        trials = self.trials
        u = self.measure.coordinate(trials.im)
        return LogitFit.of(self.measure, u, trials.fell, trials.runs, trials.motion)

    @property
    def one_motion(self) -> bool:
        """Whether all runs are of one motion: the intervals are then for it alone."""
        return self.trials.one_motion

    @cached_property
    def ends(self) -> tuple[float, float]:
        """The coordinates between which there is a curve."""
        u = self.measure.coordinate(self.trials.im)
        beyond = REACH / EFOLDS if self.measure.is_logarithm else REACH
        return float(u.min()) - beyond, float(u.max()) + beyond

    def grid(self, points: int) -> NDArray[np.float64]:
        """Return intensities [SI], shape (points,), evenly spread over the curve as it is drawn."""
        return self.measure.value(np.linspace(*self.ends, points))

    def probability(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return the probability of falling at intensities [SI]; NaN beyond the curve."""
        return self._quantiles(im)[1]

    def band(self, im: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the ends of the 95 % interval at intensities [SI]; NaN beyond the curve."""
        low, _, high = self._quantiles(im)
        return low, high

    def _quantiles(self, im: ArrayLike) -> NDArray[np.float64]:
        u, (first, last) = self.measure.coordinate(im), self.ends
        near = 1e-9 * (last - first)  # what rounding has put just outside is on the curve
        return np.where((u >= first - near) & (u <= last + near), self.fit.probability(u), math.nan)

    def capacity(self, share: float = 0.5) -> Capacity:
        """Return the intensity at which a share of the pieces falls.

        Raises
        ------
        InputError
            A share that is not between 0.001 and 0.999.
        """
        first, last = self.ends
        low, u, high = self.fit.coordinate(within("fragility.share", share, 1e-3, 1.0 - 1e-3)).tolist()
        inside = first <= u <= last
        value = self.measure.value
        return Capacity(
            self.measure,
            share,
            estimate=float(value(u)) if inside else math.nan,
            low=float(value(low if low >= first else -math.inf)),
            high=float(value(high if high <= last else math.inf)),
            bound=None if inside else float(value(min(max(u, first), last))),
        )

    @cached_property
    def lognormal(self) -> LognormalParameters | None:
        """The lognormal curve nearest to the fit, for loss tools; none where its median was not run."""
        median, im = self.capacity().estimate, self.trials.im
        if not im.min() <= median <= im.max():  # nor where it is not known
            return None
        return LognormalParameters(median, PROBIT / self.fit.slope)

    @property
    def lognormal_texts(self) -> Phrase:
        """The parameters of that curve in a sentence, in both languages; empty where there is none."""
        if self.lognormal is None:
            return ("", "")
        return phrase(
            "fragility.lognormal_curve",
            family=phrase("fragility.normal" if self.measure.is_logarithm else "fragility.lognormal"),
            median=self.measure.text(self.lognormal.median),
            dispersion=self.lognormal.dispersion,
        )

    @property
    def texts(self) -> Phrase:
        """The result in a sentence or two, in both languages."""
        return phrase(
            "fragility.curve",
            measure=(self.measure.key, self.measure.names[1]),
            half=self.capacity(0.5).texts,
            tenth=self.capacity(0.1).texts,
            intervals=phrase("fragility.of_one_motion") if self.one_motion else "",
        )

    @property
    def text(self) -> str:
        """The result in a sentence or two, in English."""
        return self.texts[0]
