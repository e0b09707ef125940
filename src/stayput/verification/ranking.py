"""How options are ranked, and which of their runs are shown."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.montecarlo.counting import DEVICE_FAILED, HIT_WALL, OVERTURNED, SLID
from stayput.verification.verdict import Member

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.fragility import Probability
    from stayput.montecarlo.counting import Outcomes

RANKING_ORDER = (OVERTURNED, SLID, DEVICE_FAILED, HIT_WALL)
"""Events by which options are ranked, the most important first."""

RANKING_RESOLUTION = 0.005
"""Probabilities that differ by no more than this are equal in the ranking: half a per cent."""


def severity(probabilities: Mapping[str, Probability], cost: int) -> tuple[float, ...]:
    """Return the sort key of an option: its probabilities in `RANKING_ORDER`, then its number of measures."""
    shares = (probabilities[event].estimate for event in RANKING_ORDER)
    return (
        *(
            round(share / RANKING_RESOLUTION) * RANKING_RESOLUTION if np.isfinite(share) else 1.0
            for share in shares
        ),
        float(cost),
    )


def members(runs: Outcomes) -> tuple[Member, Member]:
    """Return the run of median severity, and the worst: by overturning, then by tilt, then by slide."""
    order = np.lexsort((runs.slide.ravel(), runs.tilt.ravel(), runs.overturned.ravel()))
    completed = order[~runs.missing.ravel()[order]]
    ranked = completed if len(completed) else order
    samples = runs.tilt.shape[1]

    def member(place: int) -> Member:
        number = int(ranked[place])
        return Member(number // samples, number % samples)

    return member((len(ranked) - 1) // 2), member(len(ranked) - 1)
