"""Capacity: the intensity at which a share of the pieces falls, with its interval."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.isotonic import Isotonic


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


def capacity_of(measure: IntensityMeasure, rising: Isotonic, share: float, one_motion: bool) -> Capacity:
    """Return the capacity where a rising share reaches a given one, and where its band does.

    Parameters
    ----------
    measure : IntensityMeasure
        What the levels are.
    rising : Isotonic
        The share that falls, level by level.
    share : float
        The share that falls.
    one_motion : bool
        Whether all runs are of one motion.
    """
    u = rising.crossing(share)
    smaller = rising.u[rising.share < share]
    larger = rising.u[rising.share >= share]
    above = float(smaller[-1]) if len(smaller) else -math.inf
    below = float(larger[0]) if len(larger) else math.inf
    low, high = (-math.inf, math.inf) if one_motion else rising.interval(share)
    estimate = math.nan
    if math.isfinite(u):
        # straight lines of the share and of its band's Φ⁻¹ part by a little; the estimate stays inside
        estimate, low, high = u, min(low, u), max(high, u)
    value = measure.value
    above, below, low, high = (float(value(end)) for end in (above, below, low, high))
    return Capacity(measure, share, float(value(estimate)), above, below, low, high, one_motion)


def unknown_capacity(measure: IntensityMeasure, share: float, one_motion: bool) -> Capacity:
    """Return a capacity that is unknown."""
    return Capacity(measure, share, math.nan, measure.least, math.inf, measure.least, math.inf, one_motion)
