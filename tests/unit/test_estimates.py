"""Quick estimates: limits, symmetry of the formulas, and what they refuse."""

from __future__ import annotations

import math

import numpy as np
import pytest

from stayput import Body, InputError, holding_force
from stayput.estimates import (
    ishiyama_velocity,
    kaneko_hayashi,
    kaneko_hayashi_branch,
    kaneko_hayashi_median,
    rocking_acceleration,
)
from stayput.model.parameters import STANDARD_GRAVITY

SIZES = [(0.3, 1.8), (0.4, 1.8), (0.6, 1.9), (0.68, 1.82), (1.0, 2.0)]


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_tie_is_needed_from_the_rocking_acceleration_on(width: float, height: float) -> None:
    body, limit = (
        Body(width, height, 100.0),
        rocking_acceleration(Body(width, height, 100.0)) / STANDARD_GRAVITY,
    )
    assert holding_force(body, 0.999 * limit) == 0.0
    assert holding_force(body, 1.001 * limit) > 0.0
    high, low = (holding_force(body, 2.0 * limit, z) for z in (height, 0.5 * height))
    assert low == pytest.approx(2.0 * high)


def test_ishiyama_of_a_slender_body_goes_as_width_over_root_height() -> None:
    # α → 0: 0.4 √(8 g (H/2)(B/H)²/2 / 3) = 0.4 √(2g/3) B/√H
    for height in (2.0, 8.0, 50.0):
        width = 1e-2 * height
        limit = 0.4 * math.sqrt(2.0 * STANDARD_GRAVITY / 3.0) * width / math.sqrt(height)
        assert ishiyama_velocity(Body(width, height, 100.0)) == pytest.approx(limit, rel=2e-4)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_overturning_ratio_at_and_about_the_median(width: float, height: float) -> None:
    for v in (0.2, 1.0):
        # the same motion scaled keeps Fe, and so the median
        first = kaneko_hayashi(Body(width, height, 100.0), 4.0, v)
        factor = first.median / 4.0
        half = kaneko_hayashi(Body(width, height, 100.0), 4.0 * factor, v * factor)
        assert half.ratio == pytest.approx(0.5)
        assert half.median == pytest.approx(first.median)
        up = math.exp(0.5)
        assert kaneko_hayashi(
            Body(width, height, 100.0), half.median * up, v * factor * up
        ).ratio == pytest.approx(0.841345, abs=1e-6)


def test_above_the_branch_only_the_velocity_counts() -> None:
    ratios = [kaneko_hayashi(Body(0.4, 1.8, 100.0), a, 0.5).ratio for a in (6.0, 8.0, 16.0)]
    assert np.ptp(ratios) < 1e-12
    below = [kaneko_hayashi(Body(0.4, 1.8, 100.0), 2.0, v).ratio for v in (0.6, 1.0, 2.0)]
    assert np.ptp(below) < 1e-12
    assert kaneko_hayashi(Body(0.4, 1.8, 100.0), 2.0, 0.6).equivalent_frequency < kaneko_hayashi_branch(
        Body(0.4, 1.8, 100.0)
    )


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: kaneko_hayashi_median(Body(0.4, 1.8, 100.0), -1.0), "-1 Hz"),
        (lambda: kaneko_hayashi(Body(0.4, 1.8, 100.0), 0.0, 1.0), "PGA is 0"),
        (lambda: kaneko_hayashi(Body(0.4, 1.8, 100.0), 1.0, 1.0, scatter=0.0), "ζ is 0"),
        (lambda: rocking_acceleration(Body(0.4, 1.8, 100.0), math.nan), "Gravity is nan"),
        (lambda: kaneko_hayashi(Body(0.4, 1.8, 100.0), 1.0, 1.0, -1.0), "Gravity is -1"),
        (lambda: kaneko_hayashi(Body(0.4, 1.8, 100.0), 1.0, 1.0, scatter="x"), "ζ is 'x'"),  # type: ignore[arg-type]
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(InputError, match=part):
        call()  # type: ignore[operator]
