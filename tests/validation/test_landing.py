"""Impulse and momentum at a landing, and a fall without friction: closed forms of the mechanics page.

With friction μ a block of slenderness γ = h/b that turns about one corner and lands on the other keeps
the part 1 − 3 sin²α/2 of its rate where the new corner sticks, μ ≥ 3γ/(1+4γ²), and
(γ²−2+3μγ)/(γ²+4−3μγ) where it slips in the impact. Newton's restitution lets both corners bounce.
"""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from setups import G, block, both_laws, constant, first, impacts, room, simulate, still

import stayput as sp

ALMOST = 1e-7  # rad: the rate hardly changes before the landing


def ratio_after_landing(gamma: float, mu: float, side: float, **floor: float) -> float:
    run = simulate(
        block(0.2, 0.2 * gamma), room(mu, **floor), still(0.02), tilt=side * ALMOST, tilt_rate=-side
    )
    return -side * impacts(run)[0].tilt_rate


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize(
    ("mu", "reference"), [(0.6, 0.91176), (0.1847, 0.91176), (0.1, 0.80851), (0.0, 0.70000)]
)
def test_rate_ratio_of_gamma_four(side, mu, reference):
    assert ratio_after_landing(4.0, mu, side) == pytest.approx(reference, abs=6e-6)


@pytest.mark.parametrize("gamma", [2.0, 3.0, 4.0, 9.0])
@pytest.mark.parametrize("part", [0.0, 0.3, 0.9, 0.999, 1.001, 2.0])
def test_rate_ratio(gamma, part):
    limit = 3 * gamma / (1 + 4 * gamma**2)
    mu = part * limit
    sticks = 1 - 1.5 * math.sin(math.atan(1 / gamma)) ** 2
    slips = (gamma**2 - 2 + 3 * mu * gamma) / (gamma**2 + 4 - 3 * mu * gamma)
    expected = sticks if part > 1 else slips
    assert ratio_after_landing(gamma, mu, 1.0) == pytest.approx(expected, abs=2e-6)


@pytest.mark.parametrize("mu", [0.0, 0.1, 0.6])
def test_floor_restitution_multiplies_the_rate(mu):
    plain = ratio_after_landing(4.0, mu, 1.0)
    assert ratio_after_landing(4.0, mu, 1.0, restitution=0.6) == pytest.approx(0.6 * plain, rel=1e-6)


def test_squat_block_does_not_turn_on():
    """Below γ = √2 without friction the ratio would be negative: both corners stay down; G goes on."""
    run = simulate(block(0.5, 0.5), room(0.0), still(0.02), tilt=ALMOST, tilt_rate=-1.0)
    assert run.mode[-1] == sp.Mode.SLIDE
    assert (run.residual_tilt, run.rotation_rate[0, -1, 1]) == (0.0, 0.0)
    assert run.slide_rate[-1] == pytest.approx(-0.5, abs=1e-6)


def test_a_corner_bounces_by_newtons_restitution():
    """Frictionless impact of one corner: its normal rate turns round, multiplied by e_n; G moves by it."""
    b, h, e_n, rate = 0.2, 0.4, 0.5, -1.0
    body = block(b, h)
    run = simulate(body, room(0.0, normal_restitution=e_n), still(0.02), tilt=ALMOST, tilt_rate=rate)
    inertia = (b * b + h * h) / 3
    # turning about B at −1 rad/s before; A comes down at 2b; rate of A per unit impulse 1 + b²/I
    impulse = (1 + e_n) * 2 * b / (1 + b * b / inertia)
    expected = rate + impulse * b / inertia
    landing = impacts(run)[0]
    assert landing.mode is sp.Mode.FLIGHT
    assert landing.tilt_rate == pytest.approx(expected, abs=1e-6)


def fall_rate(tilt: float, start: float, b: float, h: float) -> float:
    """Rate of a block whose slipping corner takes no force along the floor: G falls straight down."""
    radius, alpha = math.hypot(b, h), math.atan2(b, h)
    inertia = radius**2 / 3
    energy = G * radius * (math.cos(alpha - start) - math.cos(alpha - tilt))
    return math.sqrt(max(0.0, 2 * energy / (inertia + (radius * math.sin(alpha - tilt)) ** 2)))


@both_laws
def test_frictionless_release(law):
    b, h = 0.2, 0.8
    start = math.atan(b / h) / 2
    run = simulate(block(b, h), room(0.0), still(0.3, 0.001), law, tilt=start)
    landing = impacts(run)[0]
    # t = ∫dθ/θ̇, with θ = start − u² because the rate is zero at the start
    time, _ = quad(
        lambda u: 2 * u / fall_rate(start - u * u, start, b, h),
        0,
        math.sqrt(start),
        epsabs=1e-13,
        epsrel=1e-13,
    )
    assert landing.time == pytest.approx(time, abs=1e-9)
    assert landing.time == pytest.approx(0.229554, abs=1e-6)
    rate = -landing.tilt_rate / (0.7 if law == "coulomb" else 1 - 1.5 / 17)
    assert rate == pytest.approx(fall_rate(0.0, start, b, h), rel=1e-9)
    assert rate == pytest.approx(1.164870, abs=1e-6)
    before = run.time < landing.time
    assert np.abs(run.place[0, before, 0] - run.place[0, 0, 0]).max() < 1e-12  # G falls straight down
    assert np.interp(landing.time, run.time[before], run.place[0, before, 2]) > h


@both_laws
def test_a_landing_under_shaking_that_sticks_is_housners(law):
    """The floor's acceleration is no impulse."""
    b, h = 0.2, 0.8
    run = simulate(block(b, h), room(1.0), constant(0.1 * G, 0.02, 1e-3), law, tilt=ALMOST, tilt_rate=-1.0)
    assert -first(run, sp.EventKind.FLOOR_IMPACT).tilt_rate == pytest.approx(1 - 1.5 / 17, abs=1e-6)
