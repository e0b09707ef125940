"""Rocking bodies that a tie holds: independent integration, and the static force of engineering practice."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from setups import STICKING, G, block, constant, still

import stayput as sp
from devices import LEFT, TILT, axial, held, planar

FLOOR = sp.Room(STICKING)


def about_right_corner(b, h, tie_at, anchor, k, c, slack, a):
    """Rates of (θ, θ̇) of a block of half sizes b and h on B, tied from a point (from G) to an anchor."""
    inertia = 4.0 / 3.0 * (b * b + h * h)

    def rates(_t, y):
        theta, omega = y
        sin, cos = math.sin(theta), math.cos(theta)
        x, z = b - b * cos + h * sin, b * sin + h * cos  # G: B stands at (b, 0)
        u, v = tie_at
        px, pz = x + u * cos + v * sin, z + v * cos - u * sin
        dx, dz = px - anchor[0], pz - anchor[1]
        far = math.hypot(dx, dz)
        wx, wz = omega * pz, -omega * (px - b)
        rate = (dx * wx + dz * wz) / far
        stretch = far - abs(tie_at[0] - anchor[0]) - slack
        pull = max(0.0, k * stretch + c * rate) if stretch > 0.0 else 0.0
        fx, fz = -pull * dx / far, -pull * dz / far
        moment = -(x - b) * -G + z * -a + fx * pz - fz * (px - b)
        return [omega, moment / inertia]

    return rates


@pytest.mark.parametrize(("slack", "c"), [(0.0, 0.0), (0.02, 0.0), (0.01, 1.0)])
def test_a_tied_block_follows_the_equations(slack, c):
    """A belt from the top back edge to the wall, 0.3 m behind; the block is thrown forward."""
    b, h, k = 0.2, 0.8, 60.0
    point, anchor = (-b, h), (-b - 0.3, 2 * h)
    belt = axial(point, anchor, length=0.3, stiffness=k, damping=c, slack_plus=slack)
    motion = still(0.6, 0.002)
    found = held(block(b, h), FLOOR, motion, belt, tilt_rate=1.2)
    rates = about_right_corner(b, h, point, anchor, k, c, slack, 0.0)

    def landing(_t, y):
        return y[0]

    landing.terminal, landing.direction = True, -1
    exact = solve_ivp(
        rates,
        (0, 0.6),
        [0.0, 1.2],
        events=landing,
        max_step=1e-3,
        rtol=1e-10,
        atol=1e-13,
        dense_output=True,
    )
    end = exact.t_events[0][0]
    impacts = [event.time for event in found.events if event.kind == 3]
    assert impacts[0] == pytest.approx(end, abs=2e-7)
    time = 0.002 * np.arange(len(found.history))
    before = time < end
    assert found.history[before, TILT] == pytest.approx(exact.sol(time[before])[0], abs=2e-7)


def test_without_a_tie_the_same_block_overturns():
    assert held(block(0.2, 0.8), FLOOR, still(3.0), tilt_rate=1.2).result["outcome"] == 4


@pytest.mark.parametrize("z", [1.6, 1.2])
def test_static_force_of_a_tie(z):
    """F = m (a h − g b)/z of a block of half sizes b and h under a steady acceleration, in small tilts."""
    b, h, a = 0.2, 0.8, 0.6 * G
    k = 3e5
    tie = planar((-b, z - h), LEFT, stiffness=k, damping=2 * math.sqrt(k), slack_plus=0.0)
    found = held(block(b, h), FLOOR, constant(-a, 3.0), tie)
    assert found.forces[-1, 0, 0] == pytest.approx((a * h - G * b) / z, rel=1e-4)
    assert found.result["residual_tilt"] == pytest.approx((a * h - G * b) / z / (k * z), rel=1e-3)
    # below the threshold it bears nothing, and the body rests
    quiet = held(block(b, h), FLOOR, constant(-0.24 * G, 3.0), tie)
    assert quiet.result["outcome"] == 0
    assert quiet.devices["peak_pull"][0] == 0.0


def test_convergence():
    """The error of a run falls with the tolerance."""
    b, h = 0.2, 0.8
    belt = axial((-b, h), (-b - 0.3, 2 * h), length=0.3, stiffness=600.0, slack_plus=0.01)
    tilts = [
        held(block(b, h), FLOOR, still(0.3, 0.05), belt, tilt_rate=1.2, tolerance=tolerance).history[-1, TILT]
        for tolerance in (1e-5, 1e-7, 1e-9, 1e-13)
    ]
    errors = np.abs(np.array(tilts[:-1]) - tilts[-1])
    assert errors[0] < 1e-3
    assert errors[1] < 1e-5
    assert errors[2] < 1e-7
