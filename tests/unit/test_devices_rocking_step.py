"""Rocking on a sticking fulcrum with a device, against a numerical solution."""

import math

import numpy as np
import pytest
from mechanics_runs import G, case_of, steady, tie
from scipy.integrate import solve_ivp

from stayput.mechanics.columns import H_TILT, H_TILT_RATE
from stayput.mechanics.runner import trace


def test_rocking_against_a_tie_agrees_with_a_numerical_solution():
    h, dt = 0.8, 0.01
    rows = tie((0.0, 0.8), (-0.5, 1.6), stiffness=np.array([[30.0, 0.0]]))
    run = trace(case_of(tilt=0.02, tilt_rate=0.5), steady(0.0, 0.2), rows, error=1e-11)
    r, alpha = math.hypot(0.2, h), math.atan(0.25)
    inertia = 4.0 / 3.0 * r**2
    length = float(rows["length"][0])

    def rates(_, y):
        tilt, rate = y
        # the point (0, 0.8) from G is at (−0.2, 1.6) from the corner B, which stands at (0.2, 0)
        px, pz = -0.2 * math.cos(tilt) + 1.6 * math.sin(tilt), 1.6 * math.cos(tilt) + 0.2 * math.sin(tilt)
        dx, dz = 0.2 + px + 0.5, pz - 1.6
        far = math.hypot(dx, dz)
        F = 30.0 * max(0.0, far - length)
        moment = -F * (dx / far * pz - dz / far * px)
        return [rate, (moment - G * r * math.sin(alpha - tilt)) / inertia]

    time = dt * np.arange(len(run.history))
    expected = solve_ivp(rates, (0.0, time[-1]), [0.02, 0.5], t_eval=time, rtol=1e-11, atol=1e-13).y
    assert run.history[:, H_TILT] == pytest.approx(expected[0], abs=1e-8)
    assert run.history[:, H_TILT_RATE] == pytest.approx(expected[1], abs=1e-7)
