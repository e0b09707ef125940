"""N. M. Newmark (1965), Effects of earthquakes on dams and embankments, Géotechnique 15(2), 139-160.

The rigid block that slides: its displacement under a rectangular pulse in closed form, stops and starts.
"""

import math

import pytest
from setups import G, both_laws, constant, first, room, simulate

import stayput as sp

WIDE = sp.Body(1.0, 0.5, 100.0)  # does not rock below 2 g


@both_laws
def test_rectangular_pulse(law):
    mu, A, length = 0.3, 0.6, 0.3
    motion = sp.pulse("rectangular", A * G, length, dt=1e-4, quiet=0.5)
    run = simulate(WIDE, room(mu), motion, law)
    assert run.outcome is sp.Outcome.SLID
    assert A * (A - mu) * G * length**2 / (2 * mu) == pytest.approx(0.264870, abs=1e-6)
    assert -run.residual_slide == pytest.approx(0.264870, abs=1e-6)
    assert run.peak_slide == pytest.approx(0.264870, abs=1e-6)
    rest = first(run, sp.EventKind.REST)
    assert rest.time == pytest.approx(A * length / mu, abs=1e-6)
    assert rest.slide_rate == 0.0


@both_laws
@pytest.mark.parametrize(("static", "kinetic"), [(0.5, 0.5), (0.5, 0.2)])
def test_a_base_that_is_thrown_stops(law, static, kinetic):
    """Without shaking: v²/(2μ'g), in v/(μ'g)."""
    run = simulate(WIDE, room(static, kinetic), constant(0.0, 2.0), law, slide_rate=1.5)
    rest = first(run, sp.EventKind.REST)
    assert rest.time == pytest.approx(1.5 / (kinetic * G), abs=1e-12)
    assert run.residual_slide == pytest.approx(1.5**2 / (2 * kinetic * G), rel=1e-12)


@both_laws
def test_slip_under_a_ramp_in_closed_form(law):
    """Floor acceleration q·t: slip starts at μg/q with the kinetic coefficient from then on."""
    q, mu, kinetic = 10.0, 0.4, 0.25
    start, end = mu * G / q, 1.0
    ramp = sp.Motion(1.0, [0.0, q])
    run = simulate(WIDE, room(mu, kinetic), ramp, law)
    slip = first(run, sp.EventKind.SLIP)
    assert slip.time == pytest.approx(start, abs=1e-12)
    expected = q * (end**3 - start**3) / 6 - kinetic * G * (end - start) ** 2 / 2
    expected -= q * start**2 / 2 * (end - start)
    assert -run.residual_slide == pytest.approx(expected, rel=1e-12)
    assert math.copysign(1.0, run.slide_rate[-1]) == -1.0


def test_vertical_shaking_changes_the_pressure():
    """Under a constant z̈ the slip starts at μ(g+z̈) and stops as under that gravity."""
    mu, up = 0.3, -4.0
    held = constant(mu * (G + up) * (1 - 1e-9), 0.1, up=up)
    assert simulate(WIDE, room(mu), held).outcome is sp.Outcome.RESTED
    slips = constant(mu * (G + up) * (1 + 1e-9), 0.1, up=up)
    assert simulate(WIDE, room(mu), slips).outcome is sp.Outcome.SLID
    run = simulate(WIDE, room(mu), constant(0.0, 2.0, up=up), slide_rate=1.0)
    assert run.residual_slide == pytest.approx(1.0 / (2 * mu * (G + up)), rel=1e-12)
