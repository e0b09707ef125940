"""The order of the options, the best first."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.verification.verdict import DEVICE_FAILED, HIT_WALL, OVERTURNED, SLID, Member

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.fragility import Probability
    from stayput.verification.runs import Runs

ORDER = (OVERTURNED, SLID, DEVICE_FAILED, HIT_WALL)
"""What counts first, and what decides where that is equal."""

EQUAL = 0.005
"""Probabilities that differ by no more than this are equal: half a per cent."""


def severity(probabilities: Mapping[str, Probability], cost: int) -> tuple[float, ...]:
    """Return what options are sorted by: the probabilities in `ORDER`, then the number of measures."""
    shares = (probabilities[event].estimate for event in ORDER)
    return (*(round(share / EQUAL) * EQUAL if np.isfinite(share) else 1.0 for share in shares), float(cost))


def members(runs: Runs) -> tuple[Member, Member]:
    """Return the run of median severity, and the worst: by overturning, then by tilt, then by slide."""
    order = np.lexsort((runs.slide.ravel(), runs.tilt.ravel(), runs.overturned.ravel()))
    given = order[~runs.missing.ravel()[order]]
    kept = given if len(given) else order
    samples = runs.tilt.shape[1]

    def member(place: int) -> Member:
        number = int(kept[place])
        return Member(number // samples, number % samples)

    return member((len(kept) - 1) // 2), member(len(kept) - 1)
