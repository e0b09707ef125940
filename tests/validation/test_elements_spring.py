"""Force laws of elements on a body that slides without friction: an oscillator, known in closed form."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from setups import G, room, still

import stayput as sp
from devices import CEILING, RIGHT, SLIDE, SLIDE_RATE, axial, held, planar

BODY = sp.Body(1.0, 0.5, 100.0)
SMOOTH = room(0.0)
K = 40.0  # N/(kg m)


def oscillator(time, x0, zeta):
    """Free damped vibration from x0, at rest."""
    w = math.sqrt(K)
    wd = w * math.sqrt(1.0 - zeta**2)
    return x0 * np.exp(-zeta * w * time) * (np.cos(wd * time) + zeta * w / wd * np.sin(wd * time))


@pytest.mark.parametrize("zeta", [0.0, 0.05, 0.6])
def test_a_bonded_spring_makes_an_oscillator(zeta):
    spring = planar(
        (0.0, 0.0), RIGHT, stiffness=K, damping=2 * zeta * math.sqrt(K), slack_plus=0.0, slack_minus=0.0
    )
    found = held(BODY, SMOOTH, still(5.0), spring, slide=0.05)
    time = 0.01 * np.arange(501)
    assert found.history[:, SLIDE] == pytest.approx(oscillator(time, 0.05, zeta), abs=1e-8)
    assert found.result["end"] == 5.0


def test_a_tie_along_the_slide_is_the_same_both_ways():
    """A strut of any length pulls and pushes; a belt only pulls, so the body runs on to the other side."""
    anchor = (-2.0, 0.25)
    strut = axial((0.0, 0.0), anchor, length=2.0, stiffness=K, slack_minus=0.0)
    time = 0.01 * np.arange(201)
    found = held(BODY, SMOOTH, still(2.0), strut, slide=0.05)
    assert found.history[:, SLIDE] == pytest.approx(oscillator(time, 0.05, 0.0), abs=1e-8)
    belt = axial((0.0, 0.0), anchor, length=2.0, stiffness=K)
    found = held(BODY, SMOOTH, still(2.0), belt, slide=0.05)
    quarter = 0.5 * math.pi / math.sqrt(K)
    after = time > quarter
    free = -0.05 * math.sqrt(K) * (time[after] - quarter)
    assert found.history[after, SLIDE] == pytest.approx(free, abs=1e-8)
    assert found.devices["peak_pull"][0] == pytest.approx(K * 0.05, rel=1e-6)
    assert found.devices["peak_push"][0] == pytest.approx(0.0, abs=1e-7)


def test_slack_is_a_run_without_force():
    """A stop on either side, s away: half a vibration in the spring, and 2s at a constant rate between."""
    s, v = 0.03, 0.4
    stop = planar((0.0, 0.0), RIGHT, stiffness=K, slack_plus=s, slack_minus=s)
    found = held(BODY, SMOOTH, still(3.0), stop, slide_rate=v)
    w = math.sqrt(K)
    period = 4 * s / v + 2 * math.pi / w
    phase = np.mod(0.01 * np.arange(301), period)
    half = phase > period / 2
    phase[half] -= period / 2
    into = phase - s / v
    x = np.where(
        into < 0,
        v * phase,
        np.where(into < math.pi / w, s + v / w * np.sin(w * into), s - v * (into - math.pi / w)),
    )
    assert found.history[:, SLIDE] == pytest.approx(np.where(half, -x, x), abs=2e-8)
    assert found.result["peak_slide"] == pytest.approx(s + v / w, abs=1e-8)
    assert found.devices["peak_pull"][0] == pytest.approx(K * v / w, rel=1e-5)


def test_a_damped_belt_never_pushes():
    """Its damper would push before it is slack; the body leaves with the rate that it has then."""
    c, v = 6.0, 0.5
    belt = axial((0.0, 0.0), (-1.0, 0.25), length=1.0, stiffness=K, damping=c)
    found = held(BODY, SMOOTH, still(1.0, 0.001), belt, slide_rate=v)

    def force(_t, y):
        return K * y[0] + c * y[1]

    force.terminal, force.direction = True, -1
    free = solve_ivp(
        lambda t, y: [y[1], -K * y[0] - c * y[1]],
        (0, 1),
        [0, v],
        events=force,
        max_step=1e-3,
        rtol=1e-12,
        atol=1e-14,
    )
    x, rate = free.y_events[0][0]
    time = 0.001 * np.arange(1001)
    after = time > free.t_events[0][0]
    on = x + rate * (time[after] - free.t_events[0][0])
    assert found.history[after, SLIDE] == pytest.approx(on, abs=1e-8)
    assert found.devices["peak_push"][0] == pytest.approx(0.0, abs=1e-7)
    assert found.forces[0, 0, 0] == 0.0
    assert found.devices["peak_pull"][0] == pytest.approx((K * free.y[0] + c * free.y[1]).max(), rel=1e-3)
    assert found.forces[:, 0, 0].min() >= -1e-7


def test_friction_and_a_spring():
    """Sliding on dry friction against a spring: each half swing is about ∓μg/k; it sticks where kx ≤ μg."""
    mu, x0 = 0.02, 0.05
    spring = planar((0.0, 0.0), RIGHT, stiffness=K, slack_plus=0.0, slack_minus=0.0)
    found = held(BODY, room(mu), still(5.0), spring, slide=x0)
    loss = 2 * mu * G / K
    swings, x = 0, x0
    while abs(x) > mu * G / K:
        x, swings = -math.copysign(abs(x) - loss, x), swings + 1
    assert found.result["residual_slide"] == pytest.approx(x, abs=1e-9)
    rest = [event for event in found.events if event.kind == 8]
    assert rest[-1].time == pytest.approx(swings * math.pi / math.sqrt(K), abs=1e-7)
    assert set(found.history[-100:, SLIDE_RATE]) == {0.0}


def test_shear_of_a_ceiling_piece():
    """The tangential line along a ceiling bears as the normal one of a wall does."""
    spring = planar(
        (0.0, 0.25), CEILING, stiffness=(0.0, K), slack_plus=(np.inf, 0.0), slack_minus=(np.inf, 0.0)
    )
    heavy = sp.Body(4.0, 0.5, 100.0)
    found = held(heavy, SMOOTH, still(2.0), spring, slide=0.05)
    time = 0.01 * np.arange(201)
    assert found.history[:, SLIDE] == pytest.approx(oscillator(time, 0.05, 0.0), abs=1e-8)
    assert found.devices["peak_shear"][0] == pytest.approx(K * 0.05, rel=1e-6)


def test_a_hanging_body_swings_as_the_equations_say():
    """Flight on a tie: two bodies' worth of freedom, integrated independently with finite rotation."""
    body, anchor = sp.Body(0.4, 0.6, 100.0), (0.3, 2.0)
    tie = axial((0.1, 0.3), anchor, length=1.0, stiffness=300.0, damping=1.0)
    inertia = body.inertia_about_cg / body.mass

    def rates(_t, y):
        x, z, tilt, vx, vz, w = y
        px, pz = 0.1 * math.cos(tilt) + 0.3 * math.sin(tilt), 0.3 * math.cos(tilt) - 0.1 * math.sin(tilt)
        dx, dz = x + px - anchor[0], z + pz - anchor[1]
        far = math.hypot(dx, dz)
        rate = (dx * (vx + w * pz) + dz * (vz - w * px)) / far
        pull = max(0.0, 300.0 * (far - 1.0) + rate) if far > 1.0 else 0.0
        fx, fz = -pull * dx / far, -pull * dz / far
        return [vx, vz, w, fx, fz - G, (fx * pz - fz * px) / inertia]

    lift = sp.Motion(0.005, np.zeros(71), z=np.full(71, -2 * G))  # the floor falls away from it
    found = held(body, room(0.5), lift, tie)

    def falling(t, y):
        dx = rates(t, y)
        dx[4] += 2 * G
        return dx

    times = 0.005 * np.arange(71)
    start = [0, 0.3, 0, 0, 0, 0]
    exact = solve_ivp(falling, (0, 0.4), start, t_eval=times, max_step=2e-4, rtol=1e-9, atol=1e-12).y
    assert found.history[:, 0] == pytest.approx(exact[0], abs=1e-7)
    assert found.history[:, 1] == pytest.approx(exact[1], abs=1e-7)
    assert found.history[:, 2] == pytest.approx(exact[2], abs=1e-7)
