"""Loads between samples, the clock, and the history."""

import numpy as np
import pytest
from mechanics_runs import case_of, traced
from numba import njit

from stayput.mechanics import columns as col
from stayput.mechanics import records
from stayput.mechanics.runner import shaking


@njit
def loads_at(case, ax, az, dt, k, tau):
    return records.loads(case, ax, az, case.scale / dt, k, tau)


@njit
def clock(states, dt, steps):
    s = states[0]
    s.k, s.tau = 0, 0.0
    return [records.advance_clock(s, h, dt) for h in steps], s.k, s.tau


def test_loads_are_linear_between_the_samples():
    case = case_of()
    case["scale"] = 2.0
    ax, az = np.array([0.0, 1.0, 4.0]), np.array([0.0, -1.0, 1.0])
    assert loads_at(case, ax, az, 0.5, 1, 0.25) == pytest.approx((5.0, 12.0, 9.81, 8.0))


def test_the_clock_reaches_a_sample_in_spite_of_rounding():
    states = np.zeros(1, col.STATE)
    reached, k, tau = clock(states, 0.3, np.array([0.1, 0.1, 0.1, 0.3, 0.2]))
    assert reached == [False, False, True, True, False]
    assert (k, tau) == (2, 0.2)


def test_the_history_ends_where_the_body_overturns():
    run = traced(shaking(np.full(1001, 6.0), None, 0.01, 0))
    assert len(run.history) < 1001
    assert run.history[:, col.H_REACHED].all()
    assert len(run.history) == int(run.result["end"] / 0.01) + 1
