"""Fragility curves by isotonic regression: the probability of falling over an intensity, and capacities."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import instance_of, within
from stayput.fragility.lognormal import LognormalFit, lognormal
from stayput.fragility.trials import Isotonic, Level, Trials, observed_levels
from stayput.saved import InJson
from stayput.wording import check_language, counted

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.fragility.intensity_measures import IntensityMeasure

METHOD = "isotonic"
"""Name of the method by which every curve is fitted, in data and texts."""


class CurveState(StrEnum):
    """Whether there is a curve, and why not."""

    FITTED = "fitted"
    NONE_FELL = "none fell"
    ALL_FELL = "all fell"
    ABRUPT = "abrupt"
    ONE_LEVEL = "one level"
    NO_TREND = "no trend"

    @property
    def phrase(self) -> Phrase:
        """What it is called, in both languages."""
        return phrase(f"fragility.state_{self.value.replace(' ', '_')}")


@dataclass(frozen=True, slots=True)
class Capacity:
    """The intensity at which a given share falls; outside the intensities that were run it is no number.

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
    one_motion : bool
        Whether all runs were of one motion, which says nothing of others: the interval is open.
    """

    measure: IntensityMeasure
    share: float
    estimate: float
    above: float
    below: float
    low: float
    high: float
    one_motion: bool = False

    @property
    def sure(self) -> bool:
        """Whether the bounds of a capacity without an estimate hold with 95 % confidence."""
        return self.low >= self.above and self.high <= self.below

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
    def texts(self) -> Phrase:
        """The capacity in both languages: "6.12 (5.95 to 6.33)", "> 6.90", "between 5.50 and 5.75"."""
        show, least = self.measure.text, self.measure.least
        if not math.isnan(self.estimate):
            if self.one_motion:
                return phrase("fragility.capacity_one_motion", value=show(self.estimate))
            return phrase("fragility.capacity", value=show(self.estimate), ends=self.ends)
        bounds = (self.above > least, math.isfinite(self.below))
        if not any(bounds):
            return phrase("common.unknown")
        key = "between" if all(bounds) else "above" if bounds[0] else "below"
        doubt = "one_motion" if self.one_motion else "unsure"
        return phrase(
            f"fragility.capacity_{key}",
            above=show(self.above, unit=key != "between"),
            below=show(self.below),
            doubt="" if self.sure and not self.one_motion else phrase(f"fragility.doubt_{doubt}"),
        )

    @property
    def text(self) -> str:
        """The capacity in English words; see `texts`."""
        return self.texts[0]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class FragilityCurve(InJson):
    """The probability of falling over an intensity, by isotonic regression; see `stayput.fragility.trials`.

    Parameters
    ----------
    name : str
        What it is the curve of.
    trials : Trials
        What it was fitted to.
    state : State
        Whether there is a curve; its probability is NaN where there is none.
    levels : tuple of Level
        Observed shares, from the weakest level to the strongest.
    rising : Isotonic
        The rising shares nearest to them, and their band.
    lognormal : LognormalFit, optional
        The lognormal curve for loss tools, and whether it fits; none where there is no curve.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.fragility.intensity_measures import PGA
    >>> trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    >>> curve = sp.fragility_curve(trials, "bookcase")
    >>> curve.name, curve.levels[1].probability.text
    ('bookcase', 'about 50 % (33 to 63 %)')
    """

    name: str
    trials: Trials
    state: CurveState
    levels: tuple[Level, ...] = field(repr=False)
    rising: Isotonic = field(repr=False)
    lognormal: LognormalFit | None = None

    def __repr__(self) -> str:
        return (
            f"FragilityCurve({self.name!r}, {self.measure.key}, {self.state.value}; {self.capacity().text})"
        )

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

    @property
    def one_motion(self) -> bool:
        """Whether all runs are of one motion: there is no band then, since nothing is known of others."""
        return self.trials.one_motion

    def grid(self, points: int) -> NDArray[np.float64]:
        """Return intensities [SI], shape (points,), evenly spread over the levels as the curve is drawn."""
        u = self.rising.u
        return self.measure.value(np.linspace(float(u[0]), float(u[-1]), points))

    def probability(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return the probability of falling at intensities [SI]; NaN outside what was run."""
        u = self._inside(im)
        return self.rising.at(u) if self.state is CurveState.FITTED else np.full(u.shape, math.nan)

    def band(self, im: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the ends of the 95 % interval of the probability at each intensity [SI].

        They are NaN outside what was run, and where there is one motion only.
        """
        u = self._inside(im)
        if self.state is not CurveState.FITTED or self.one_motion:
            return np.full(u.shape, math.nan), np.full(u.shape, math.nan)
        return self.rising.band(u)

    def _inside(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return coordinates; those that rounding has put just outside the levels are put on their ends."""
        u, ends = self.measure.coordinate(im), self.rising.u
        near = 1e-9 * max(float(ends[-1] - ends[0]), 1e-300)
        clipped = np.clip(u, ends[0], ends[-1])
        return np.where(np.abs(u - clipped) <= near, clipped, u)

    def capacity(self, share: float = 0.5) -> Capacity:
        """Return the intensity at which a share of the pieces falls.

        Raises
        ------
        InputError
            A share that is not between 0.001 and 0.999.
        """
        share, rising = within("fragility.share", share, 1e-3, 1.0 - 1e-3), self.rising
        u, above, below, low, high = math.nan, -math.inf, math.inf, -math.inf, math.inf
        if self.state is not CurveState.NO_TREND:
            u = rising.crossing(share)
            above = float(max(rising.u[rising.share < share], default=-math.inf))
            below = float(min(rising.u[rising.share >= share], default=math.inf))
            if not self.one_motion:
                low, high = rising.interval(share)
        estimate = math.nan
        if math.isfinite(u):
            # straight lines of the share and of its band's Φ⁻¹ part by a little; the estimate stays inside
            estimate, low, high = u, min(low, u), max(high, u)
        estimate, above, below, low, high = (
            float(self.measure.value(end)) for end in (estimate, above, below, low, high)
        )
        return Capacity(self.measure, share, estimate, above, below, low, high, self.one_motion)

    @property
    def texts(self) -> Phrase:
        """The result in a sentence or two, in both languages."""
        show, count = self.measure.text, int(self.trials.runs.sum())
        first, last = self.levels[0], self.levels[-1]
        return phrase(
            f"fragility.curve_{self.state.value.replace(' ', '_')}",
            measure=(self.measure.key, self.measure.names[1]),
            runs=(counted(count, "run"), f"{count:,}件"),
            half=self.capacity(0.5).texts,
            tenth=self.capacity(0.1).texts,
            lowest=show(first.lowest),
            highest=show(last.highest),
            level=show(first.im),
            probability=first.probability.texts,
            intervals=phrase("fragility.no_intervals") if self.one_motion else "",
        )

    @property
    def text(self) -> str:
        """The result in a sentence or two, in English."""
        return self.texts[0]


def fragility_curve(trials: Trials, name: str = "") -> FragilityCurve:
    """Fit a fragility curve by isotonic regression.

    Parameters
    ----------
    trials : Trials
        What was run.
    name : str
        What it is the curve of.

    Returns
    -------
    FragilityCurve
        Its ``state`` says whether there is a curve, its ``lognormal`` whether loss tools can be given one.

    Examples
    --------
    >>> from stayput.fragility.intensity_measures import PGA
    >>> from stayput.fragility.trials import Trials
    >>> curve = fragility_curve(Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40]))
    >>> curve.capacity(0.5).text
    '4.17 m/s² (3.22 to 5.23)'
    >>> curve.lognormal.text
    'A lognormal curve fits: median 4.07 m/s², dispersion 0.541 (p = 0.82, at most 1 points off).'
    """
    levels = observed_levels(instance_of("trials", trials, Trials))
    rising = Isotonic.of(trials.measure, levels)
    state = _state(trials, rising.share)
    wanted = state is CurveState.FITTED and not trials.one_motion
    return FragilityCurve(name, trials, state, levels, rising, lognormal(trials, levels) if wanted else None)


def _state(trials: Trials, share: NDArray[np.float64]) -> CurveState:
    if not trials.fell.any():
        return CurveState.NONE_FELL
    if (trials.fell == trials.runs).all():
        return CurveState.ALL_FELL
    if len(share) == 1:
        return CurveState.ONE_LEVEL
    if share[0] == share[-1]:
        return CurveState.NO_TREND
    return CurveState.FITTED if ((share > 0.0) & (share < 1.0)).any() else CurveState.ABRUPT
