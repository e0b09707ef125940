"""How large letters and drawings of the card are on paper: the fewer steps there are, the larger."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from stayput.report.action_plan.elevation import size_on_paper

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from stayput.rooms.steps import ActionPlan, Fix

PLAN_SCALES = (25, 40, 50, 75, 100, 150, 200, 300, 500, 1000)
"""Scales that a plan is drawn to: metres of the room in a metre of paper."""

ELEVATION_SCALES = (20, 25, 30, 40, 50, 75, 100)
"""The same of the elevations."""


class CardSizes(NamedTuple):
    """Sizes on paper, which suit so many blocks of text.

    Parameters
    ----------
    blocks : float
        Most blocks of text: a step is one, and another way to do it is one more.
    letters : float
        Size of the letters [pt].
    plan : tuple of float
        Most that the plan takes up, wide and high [m].
    elevations : tuple of float
        Most width of an elevation, and most height of all together [m].
    """

    blocks: float
    letters: float
    plan: tuple[float, float]
    elevations: tuple[float, float]


SIZES = (
    CardSizes(2, 10.0, (0.104, 0.086), (0.075, 0.092)),
    CardSizes(4, 8.6, (0.090, 0.068), (0.070, 0.092)),
    CardSizes(6, 7.7, (0.084, 0.062), (0.060, 0.125)),
    CardSizes(math.inf, 7.2, (0.080, 0.058), (0.060, 0.130)),
)
"""Sizes for few blocks, and for more of them."""


def sizes_of(plan: ActionPlan) -> CardSizes:
    """Return the sizes that suit a plan."""
    blocks = len(plan.steps) + sum(step.instead is not None for step in plan.steps) + len(plan.drilled)
    return next(sizes for sizes in SIZES if blocks <= sizes.blocks)


def is_dense(sizes: CardSizes) -> bool:
    """Return whether lines of text are to be saved: with the smallest letters."""
    return sizes == SIZES[-1]


def plan_scale(metres: Sequence[float], sizes: CardSizes) -> int:
    """Return the largest scale of a plan that is so wide and so high with its margins [m]."""
    return _first(
        PLAN_SCALES,
        (
            all(size / one <= most for size, most in zip(metres, sizes.plan, strict=True))
            for one in PLAN_SCALES
        ),
    )


def elevation_scale(fixes: Sequence[Fix], sizes: CardSizes) -> int:
    """Return the largest scale to which all elevations are drawn."""
    wide, high = sizes.elevations
    drawn = ([size_on_paper(fix, scale) for fix in fixes] for scale in ELEVATION_SCALES)
    return _first(
        ELEVATION_SCALES,
        (
            all(width <= wide for width, _ in own) and sum(height for _, height in own) <= high
            for own in drawn
        ),
    )


def _first(scales: Sequence[int], fits: Iterable[bool]) -> int:
    """Return the first scale that fits, or else the last."""
    return next((scale for scale, fit in zip(scales, fits, strict=True) if fit), scales[-1])
