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

SIZES = [(0.3, 1.8), (0.4, 1.8), (0.6, 1.9), (0.68, 1.82), (1.0, 2.0)]


def test_west_by_hand() -> None:
    # 40/180 of 980.665 gal
    assert 100.0 * rocking_acceleration(sp.Body(0.40, 1.80, 100.0)) == pytest.approx(217.926, abs=1e-3)


def test_ishiyama_by_hand() -> None:
    # B 40, H 180 cm: R = 92.195 cm, cos α = 180/184.391 = 0.976187, so
    # 8 · 980.665 · 92.195 · 0.023813 / (3 · 0.952941) = 6024.9, its root 77.620, times 0.4: 31.05 cm/s
    assert 100.0 * ishiyama_velocity(sp.Body(0.40, 1.80, 100.0)) == pytest.approx(31.05, abs=0.01)


@pytest.mark.parametrize(("width", "height"), SIZES[:3])
def test_ishiyamas_approximation(width: float, height: float) -> None:
    approximation = 10.0 * (100.0 * width) / math.sqrt(100.0 * height)  # cm/s
    assert 100.0 * ishiyama_velocity(sp.Body(width, height, 100.0)) == pytest.approx(approximation, rel=0.12)


def test_kaneko_hayashi_by_hand() -> None:
    # B 40, H 180 cm: Fb = 15.6/13.4164 · 1.22222^−1.5 = 0.86053 Hz
    assert kaneko_hayashi_branch(sp.Body(0.40, 1.80, 100.0)) == pytest.approx(0.86053, abs=1e-5)
    # low branch 980.665 · 0.222222 · 1.222222 = 266.35 gal
    assert 100.0 * kaneko_hayashi_median(sp.Body(0.40, 1.80, 100.0), 0.5) == pytest.approx(266.35, abs=0.01)
    # high branch at 2 Hz: 2π · 2 · 10 · 40/13.4164 · 1.22222^2.5 = 618.73 gal
    assert 100.0 * kaneko_hayashi_median(sp.Body(0.40, 1.80, 100.0), 2.0) == pytest.approx(618.7, abs=0.1)
    # 800 gal and 60 cm/s: Fe = 2.1221 Hz, A50 = 656.5 gal, Φ(ln(800/656.5)/0.5) = Φ(0.3954) = 0.6537
    found = kaneko_hayashi(sp.Body(0.40, 1.80, 100.0), 8.0, 0.60)
    assert found.equivalent_frequency == pytest.approx(2.1221, abs=1e-4)
    assert 100.0 * found.median == pytest.approx(656.5, abs=0.1)
    assert found.ratio == pytest.approx(0.6537, abs=2e-4)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_branches_meet(width: float, height: float) -> None:
    fb = kaneko_hayashi_branch(sp.Body(width, height, 100.0))
    low, high = (
        kaneko_hayashi_median(sp.Body(width, height, 100.0), fb * factor)
        for factor in (1.0 - 1e-9, 1.0 + 1e-9)
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
    assert sp.holding_force(sp.Body(0.40, 1.80, 100.0), 8.0 / 9.80665) == pytest.approx(by_hand)
