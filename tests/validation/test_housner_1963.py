"""G. W. Housner (1963), The behavior of inverted pendulum structures during earthquakes, BSSA 53(2), 403-417.

Free rocking with impacts that keep the moment of momentum about the new corner, the quarter period of the
linearised equation, overturning by a sudden base velocity and by a rectangular pulse. Numbers are those of
the nonlinear equations; only the quarter period is Housner's linear one.
"""

import math

import numpy as np
import pytest
from setups import STICKING, G, block, both_laws, extrema, impacts, simulate, still, threshold

import stayput as sp

ON_STICKING = sp.Room(STICKING)


def overturns(body: sp.Body, motion: sp.Motion, law: str, **state: float) -> bool:
    return simulate(body, ON_STICKING, motion, law, **state).overturned


@both_laws
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_free_rocking_from_half_of_alpha(law, side):
    alpha = math.atan(0.2 / 0.8)
    run = simulate(block(0.2, 0.8), ON_STICKING, still(3.0, 0.001), law, tilt=side * alpha / 2)
    assert [e.time for e in impacts(run)[:3]] == pytest.approx([0.441671, 1.160493, 1.770421], abs=1e-6)
    peaks = extrema(run.time, np.abs(run.tilt))
    assert [peak / alpha for peak in peaks[:3]] == pytest.approx([0.386714, 0.306397, 0.246057], abs=1e-6)


@both_laws
def test_every_landing_keeps_the_moment_of_momentum(law):
    alpha = math.atan(0.2 / 0.8)
    run = simulate(block(0.2, 0.8), ON_STICKING, still(3.0), law, tilt=alpha / 2)
    rates = [abs(e.tilt_rate) for e in impacts(run)]
    ratio = 1.0 - 1.5 * math.sin(alpha) ** 2
    assert len(rates) >= 4
    # the body comes down as fast as it went up
    assert rates[1:4] == pytest.approx([ratio * rate for rate in rates[:3]], rel=1e-9)
    fall = G * math.hypot(0.2, 0.8) * (math.cos(alpha / 2) - math.cos(alpha))  # energy of the first fall
    assert rates[0] == pytest.approx(ratio * math.sqrt(2 * fall / (4 / 3 * (0.2**2 + 0.8**2))), rel=1e-9)


@both_laws
@pytest.mark.parametrize("part", [0.2, 0.5, 0.9])
def test_quarter_period_of_a_slender_block_is_the_linear_one(law, part):
    b, h = 0.002, 1.0  # the nonlinear terms are of the order α² = 4e-6
    run = simulate(block(b, h), ON_STICKING, still(2.0), law, tilt=part * math.atan(b / h))
    p = math.sqrt(3.0 * G / (4.0 * math.hypot(b, h)))
    assert impacts(run)[0].time == pytest.approx(math.acosh(1.0 / (1.0 - part)) / p, rel=1e-5)


@both_laws
@pytest.mark.parametrize(("b", "h", "reference"), [(0.2, 0.8, 0.827251), (0.1, 0.9, 0.382983)])
def test_sudden_base_velocity_overturns(law, b, h, reference):
    radius, alpha = math.hypot(b, h), math.atan(b / h)
    motion = still(10.0, 0.02)

    def falls(velocity: float) -> bool:
        rate = 3.0 * velocity * math.cos(alpha) / (4.0 * radius)
        return overturns(block(b, h), motion, law, tilt_rate=rate)

    found = threshold(falls, 0.9 * reference, 1.1 * reference, halvings=24)
    closed_form = math.sqrt(8 * G * radius * (1 - math.cos(alpha)) / (3 * math.cos(alpha) ** 2))
    assert found == pytest.approx(reference, abs=1e-6)
    assert found == pytest.approx(closed_form, rel=1e-6)


@both_laws
@pytest.mark.parametrize("length", [0.002, 0.001])
def test_a_short_hard_push_is_a_sudden_base_velocity(law, length):
    """The rate that the velocity gives, θ̇ = 3V cos α/(4R), comes out of the record itself."""
    radius, alpha, velocity = math.hypot(0.2, 0.8), math.atan(0.2 / 0.8), 0.8
    steps = 20
    dt = length / steps
    push = np.zeros(2 * steps)
    push[:steps], push[steps] = -velocity / length, -0.5 * velocity / length
    run = simulate(block(0.2, 0.8), ON_STICKING, sp.Motion(dt, push), law)
    given = 3.0 * velocity * math.cos(alpha) / (4.0 * radius)
    taken = 3.0 * G * math.sin(alpha) / (4.0 * radius) * dt * (steps + 1)  # by gravity meanwhile
    assert run.rotation_rate[0, steps + 1, 1] == pytest.approx(given - taken, abs=0.1 * length)


@both_laws
@pytest.mark.parametrize(("length", "reference"), [(0.1, 0.97221), (0.2, 0.55697), (0.5, 0.32219)])
def test_rectangular_pulse_overturns(law, length, reference):
    """The pulse ends in a ramp over two steps of 0.1 ms; its impulse is exact and its moment to 1e-8."""

    def falls(part_of_g: float) -> bool:
        step = 1e-4 if length < 0.3 else 2e-4
        motion = sp.pulse("rectangular", part_of_g * G, length, dt=step, quiet=0.02)
        still_on = sp.Motion(0.02, np.zeros(500))
        run = simulate(block(0.2, 0.8), ON_STICKING, motion, law)
        return overturns(
            block(0.2, 0.8),
            still_on,
            law,
            tilt=run.residual_tilt,
            tilt_rate=float(run.rotation_rate[0, -1, 1]),
        )

    found = threshold(falls, 0.95 * reference, 1.05 * reference)
    assert found == pytest.approx(reference, rel=5e-5)
