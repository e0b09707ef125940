"""Quick estimates against their sources' own units (cm, gal), computed by hand, and against statics.

West after Milne (1885); Ishiyama (1982), equations for a₀ and v₀ and the approximation 10 B/√H; Kaneko and
Hayashi (2004), whose coefficients are common knowledge that was not re-checked against the paper.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import stayput as sp
from stayput.estimates import (
    ishiyama_velocity,
    kaneko_hayashi,
    kaneko_hayashi_branch,
    kaneko_hayashi_median,
    rocking_acceleration,
)
from stayput.model.parameters import STANDARD_GRAVITY

BOOKCASE = sp.Body(0.4, 1.8, 100.0)
SIZES = [(0.3, 1.8), (0.4, 1.8), (0.6, 1.9), (0.68, 1.82), (1.0, 2.0)]


def test_west_by_hand() -> None:
    # 40/180 of 980.665 gal
    assert 100.0 * rocking_acceleration(BOOKCASE) == pytest.approx(217.926, abs=1e-3)


def test_ishiyama_by_hand() -> None:
    # B 40, H 180 cm: R = 92.195 cm, cos α = 180/184.391 = 0.976187, so
    # 8 · 980.665 · 92.195 · 0.023813 / (3 · 0.952941) = 6024.9, its root 77.620, times 0.4: 31.05 cm/s
    assert 100.0 * ishiyama_velocity(BOOKCASE) == pytest.approx(31.05, abs=0.01)


@pytest.mark.parametrize(("width", "height"), SIZES[:3])
def test_ishiyamas_approximation(width: float, height: float) -> None:
    approximation = 10.0 * (100.0 * width) / math.sqrt(100.0 * height)  # cm/s
    assert 100.0 * ishiyama_velocity(sp.Body(width, height, 100.0)) == pytest.approx(approximation, rel=0.12)


def test_kaneko_hayashi_by_hand() -> None:
    # B 40, H 180 cm: Fb = 15.6/13.4164 · 1.22222^−1.5 = 0.86053 Hz
    assert kaneko_hayashi_branch(BOOKCASE) == pytest.approx(0.86053, abs=1e-5)
    # low branch 980.665 · 0.222222 · 1.222222 = 266.35 gal
    assert 100.0 * kaneko_hayashi_median(BOOKCASE, 0.5) == pytest.approx(266.35, abs=0.01)
    # high branch at 2 Hz: 2π · 2 · 10 · 40/13.4164 · 1.22222^2.5 = 618.73 gal
    assert 100.0 * kaneko_hayashi_median(BOOKCASE, 2.0) == pytest.approx(618.7, abs=0.1)
    # 800 gal and 60 cm/s: Fe = 2.1221 Hz, A50 = 656.5 gal, Φ(ln(800/656.5)/0.5) = Φ(0.3954) = 0.6537
    found = kaneko_hayashi(BOOKCASE, 8.0, 0.60)
    assert found.equivalent_frequency == pytest.approx(2.1221, abs=1e-4)
    assert 100.0 * found.median == pytest.approx(656.5, abs=0.1)
    assert found.ratio == pytest.approx(0.6537, abs=2e-4)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_branches_meet(width: float, height: float) -> None:
    fb = kaneko_hayashi_branch(sp.Body(width, height, 100.0))
    low, high = (
        kaneko_hayashi_median(sp.Body(width, height, 100.0), fb * k) for k in (1.0 - 1e-9, 1.0 + 1e-9)
    )
    # 2π · 15.6 · 10 = 980.2 against 980.665: the sources' rounding
    assert high == pytest.approx(low, rel=6e-4)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_ishiyamas_limit_lies_below_half_of_all(width: float, height: float) -> None:
    # v50 = (B/√H)(1 + B/H)^2.5 is the high branch's A50/(2π Fe)
    v50 = kaneko_hayashi_median(sp.Body(width, height, 100.0), 5.0) / (10.0 * math.pi)
    assert ishiyama_velocity(sp.Body(width, height, 100.0)) < v50


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_simulated_body_starts_to_rock_at_wests_acceleration(width: float, height: float) -> None:
    body, room = sp.Body(width, height, 100.0), sp.Room(sp.Floor(3.0, 3.0))
    a = rocking_acceleration(sp.Body(width, height, 100.0))
    for factor, rocks in ((0.995, False), (1.005, True)):
        motion = sp.Motion(dt=0.01, x=np.full(60, factor * a))
        assert (sp.simulate(body, room, motion).peak_tilt > 0.0) == rocks


def test_tie_force_by_hand() -> None:
    # moments about the rear edge, 100 kg: 8.0 m/s² at 0.9 m, weight at 0.2 m, tie at 1.8 m
    by_hand = (100.0 * 8.0 * 0.9 - 100.0 * 9.80665 * 0.2) / 1.8
    assert sp.holding_force(BOOKCASE, 8.0 / 9.80665) == pytest.approx(by_hand)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_tie_is_needed_from_the_rocking_acceleration_on(width: float, height: float) -> None:
    body = sp.Body(width, height, 100.0)
    limit = rocking_acceleration(body) / STANDARD_GRAVITY
    assert sp.holding_force(body, 0.999 * limit) == 0.0
    assert sp.holding_force(body, 1.001 * limit) > 0.0
    high, low = (sp.holding_force(body, 2.0 * limit, z) for z in (height, 0.5 * height))
    assert low == pytest.approx(2.0 * high)


def test_ishiyama_of_a_slender_body_goes_as_width_over_root_height() -> None:
    # α → 0: 0.4 √(8 g (H/2)(B/H)²/2 / 3) = 0.4 √(2g/3) B/√H
    for height in (2.0, 8.0, 28.0):
        width = 1e-2 * height
        limit = 0.4 * math.sqrt(2.0 * STANDARD_GRAVITY / 3.0) * width / math.sqrt(height)
        assert ishiyama_velocity(sp.Body(width, height, 100.0)) == pytest.approx(limit, rel=2e-4)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_overturning_ratio_at_and_about_the_median(width: float, height: float) -> None:
    body, up = sp.Body(width, height, 100.0), math.exp(0.5)
    for v in (0.2, 1.0):
        # the same motion scaled keeps Fe, and so the median
        first = kaneko_hayashi(body, 4.0, v)
        factor = first.median / 4.0
        half = kaneko_hayashi(body, 4.0 * factor, v * factor)
        assert half.ratio == pytest.approx(0.5)
        assert half.median == pytest.approx(first.median)
        more = kaneko_hayashi(body, half.median * up, v * factor * up)
        assert more.ratio == pytest.approx(0.841345, abs=1e-6)


def test_above_the_branch_only_the_velocity_counts() -> None:
    ratios = [kaneko_hayashi(BOOKCASE, a, 0.5).ratio for a in (6.0, 8.0, 16.0)]
    assert np.ptp(ratios) < 1e-12
    below = [kaneko_hayashi(BOOKCASE, 2.0, v) for v in (0.6, 1.0, 2.0)]
    assert np.ptp([one.ratio for one in below]) < 1e-12
    assert below[0].equivalent_frequency < kaneko_hayashi_branch(BOOKCASE)


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: kaneko_hayashi_median(BOOKCASE, -1.0), "-1 Hz"),
        (lambda: kaneko_hayashi(BOOKCASE, 0.0, 1.0), "PGA is 0"),
        (lambda: kaneko_hayashi(BOOKCASE, 1.0, 1.0, scatter=0.0), "ζ is 0"),
        (lambda: rocking_acceleration(BOOKCASE, math.nan), "Gravity is nan"),
        (lambda: kaneko_hayashi(BOOKCASE, 1.0, 1.0, -1.0), "Gravity is -1"),
        (lambda: kaneko_hayashi(BOOKCASE, 1.0, 1.0, scatter="x"), "ζ is 'x'"),  # type: ignore[arg-type]
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(sp.InputError, match=part):
        call()  # type: ignore[operator]
