"""Accelerations with element forces: friction of a base whose load is shifted, and agreement with modes."""

import numpy as np
import pytest
from mechanics_runs import G, case_of, plate, steady
from numba import njit

import stayput as sp
from stayput.mechanics.columns import H_SLIDE_RATE
from stayput.mechanics.devices import step
from stayput.mechanics.runner import trace

FLAT = sp.Body(1.0, 0.5, 100.0)


@njit
def shared(case, mu_a, mu_b, d, shift):
    a, b = (mu_a, -0.5, 0.25), (mu_b, 0.5, 0.25)
    return step.shared_friction(case, a, b, d, shift)


def test_a_centred_load_has_the_friction_of_the_base():
    case = case_of(FLAT, sp.Room(sp.Floor(0.4, 0.3, 0.9, 0.9)))
    assert shared(case, 0.9, 0.9, 1.0, 0.0) == 0.3


@pytest.mark.parametrize(("shift", "expected"), [(0.3, 0.4), (0.45, 0.2), (0.49, 0.1), (0.6, 0.1)])
def test_a_load_near_the_leading_corner_has_the_friction_of_its_edge(shift, expected):
    """The body tips where μ > (0.5 − shift)/0.25; the edge, 0.1, is too smooth to keep it tipped."""
    case = case_of(FLAT, sp.Room(sp.Floor(0.4, 0.4, 0.1, 0.1)))
    assert shared(case, 0.1, 0.1, 1.0, shift) == pytest.approx(expected)
    assert shared(case, 0.1, 0.1, -1.0, -shift) == pytest.approx(expected)


def test_a_sliding_body_feels_its_spring():
    """The first acceleration of a body that slides against a spring: −ẍ_G + μ'g − k x / m."""
    case = case_of(FLAT, sp.Room(sp.Floor(0.3, 0.2)), slide=0.0, slide_rate=-1.0)
    rows = plate((0.0, 0.0))
    rows["stiffness"][:, 0] = 0.0
    rows["stiffness"][:, 1] = 100.0
    rows["slack_plus"][:, 0] = rows["slack_minus"][:, 0] = np.inf
    run = trace(case, steady(0.0, 0.1, dt=1e-3), rows)
    time = 1e-3 * np.arange(40)
    # x'' = μ'g − 100 x from x(0) = 0, x'(0) = −1
    omega, offset = 10.0, 0.2 * G / 100.0
    expected = -np.cos(omega * time) + offset * omega * np.sin(omega * time)
    assert run.history[:40, H_SLIDE_RATE] == pytest.approx(expected, abs=1e-6)
