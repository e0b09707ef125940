"""What was observed, level by level, beside what a curve says."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.fragility.probabilities import Probability, probability_of_counts

if TYPE_CHECKING:
    from stayput.fragility.trials import Trials


@dataclass(frozen=True, slots=True)
class Level:
    """A group of cells of about one intensity.

    Parameters
    ----------
    im, lowest, highest : float
        Mean (of the logarithm, for a peak), smallest and largest intensity [SI].
    probability : Probability
        What was observed.
    """

    im: float
    lowest: float
    highest: float
    probability: Probability


def observed_levels(trials: Trials) -> tuple[Level, ...]:
    """Return the levels of some trials, from the weakest to the strongest."""
    found: list[Level] = []
    u = trials.measure.coordinate(trials.im)
    for number in np.unique(trials.level):
        inside = trials.level == number
        k, n = trials.fell[inside], trials.runs[inside]
        if trials.motion is not None:
            names = trials.motion[inside]
            k, n = np.bincount(names, k), np.bincount(names, n)
        else:
            k, n = k.sum(keepdims=True), n.sum(keepdims=True)
        middle = trials.measure.value(np.average(u[inside], weights=trials.runs[inside]))
        ends = trials.im[inside].min(), trials.im[inside].max()
        found.append(Level(float(middle), float(ends[0]), float(ends[1]), probability_of_counts(k, n)))
    return tuple(sorted(found, key=lambda level: level.im))
