"""H. W. Shenton III (1996), Criteria for initiation of slide, rock, and slide-rock rigid-body modes,
J. Eng. Mech. 122(7), 690-693.

Which mode a step of the floor's acceleration starts, with what accelerations, and how slide-rock goes on.
Half sizes b, h; γ = h/b; the step is A·g and μ = μ'.
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from setups import G, block, both_laws, constant, room, simulate

import stayput as sp

MOMENT = 1e-4  # s; the accelerations change by less than 1e-6 in it
STARTS = [  # A, μ, mode, rotation [rad/s²], slip [m/s²]
    (0.4, 0.20, sp.Mode.SLIDE, 0.0, -1.962),
    (0.4, 0.26, sp.Mode.SLIDE_ROCK, 0.3487, -1.0763),
    (0.4, 0.28, sp.Mode.SLIDE_ROCK, 1.0612, -0.2688),
    (0.4, 0.60, sp.Mode.ROCK, 1.2984, 0.0),
    (0.6, 0.30, sp.Mode.SLIDE_ROCK, 1.7945, -1.3997),
]


def begin(gamma: float, A: float, mu: float, law: str) -> sp.Run:
    return simulate(block(0.2, 0.2 * gamma), room(mu), constant(A * G, 2 * MOMENT, MOMENT), law)


def rock_boundary(gamma: float, A: float) -> float:
    """Least friction with which the fulcrum sticks at the start of rocking."""
    return ((4 + gamma**2) * A + 3 * gamma) / (1 + 4 * gamma**2 + 3 * gamma * A)


@both_laws
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize(("A", "mu", "mode", "rotation", "slip"), STARTS)
def test_mode_and_accelerations_at_the_start(law, side, A, mu, mode, rotation, slip):
    run = begin(4.0, side * A, mu, law)
    assert list(run.mode) == [mode] * 3
    assert -side * run.rotation_rate[0, 1, 1] / MOMENT == pytest.approx(rotation, abs=6e-5)
    assert side * run.slide_rate[1] / MOMENT == pytest.approx(slip, abs=6e-5)


@both_laws
@pytest.mark.parametrize("gamma", [1.5, 2.0, 4.0, 8.0])
@pytest.mark.parametrize("excess", [1.001, 1.2, 2.0, 4.0])
def test_boundary_of_rock_and_slide_rock(law, gamma, excess):
    A = excess / gamma
    mu = rock_boundary(gamma, A)
    assert 1 / gamma < mu < A or excess == 1.001
    assert begin(gamma, A, mu * (1 + 1e-6), law).mode[0] == sp.Mode.ROCK
    below = begin(gamma, A, mu * (1 - 1e-6), law).mode[0]
    assert below == (sp.Mode.SLIDE_ROCK if mu * (1 - 1e-6) > 1 / gamma else sp.Mode.SLIDE)


@both_laws
@pytest.mark.parametrize("gamma", [1.5, 2.0, 4.0])
@pytest.mark.parametrize("excess", [1.2, 2.0])
def test_boundary_of_slide_and_slide_rock(law, gamma, excess):
    A = excess / gamma
    assert begin(gamma, A, (1 - 1e-6) / gamma, law).mode[0] == sp.Mode.SLIDE
    assert begin(gamma, A, (1 + 1e-6) / gamma, law).mode[0] == sp.Mode.SLIDE_ROCK


@both_laws
def test_rest_rock_and_slide_meet(law):
    gamma = 4.0
    assert begin(gamma, (1 - 1e-9) / gamma, 0.5, law).mode[0] == sp.Mode.REST
    assert begin(gamma, (1 + 1e-9) / gamma, 0.5, law).mode[0] == sp.Mode.ROCK
    assert begin(gamma, 0.2 * (1 - 1e-9), 0.2, law).mode[0] == sp.Mode.REST
    assert begin(gamma, 0.2 * (1 + 1e-9), 0.2, law).mode[0] == sp.Mode.SLIDE


@both_laws
def test_finite_slide_rock(law):
    run = simulate(block(0.2, 0.8), room(0.3), constant(0.6 * G, 0.3, 0.01), law)
    at = [10, 20, 30]
    assert list(run.mode[at]) == [sp.Mode.SLIDE_ROCK] * 3
    assert -run.tilt[at] == pytest.approx([0.009270, 0.040824, 0.107112], abs=1e-6)
    assert -1e3 * run.slide[at] == pytest.approx([6.745, 23.794, 40.724], abs=6e-4)


def slide_rock_by_newton(state, floor, mu, b, h):
    """Rates of θ, θ̇, slip, slip rate about the left corner, slipping to the left: Newton's three equations.

    Unknowns: acceleration of G to the right and up, θ̈, N and T, with the corner kept on the floor.
    """
    theta, omega, _, slip_rate = state
    c, s = math.cos(theta), math.sin(theta)
    px, pz = -b * c - h * s, -h * c + b * s  # the left corner from G; clockwise is positive
    inertia = (b * b + h * h) / 3
    # v_P = v_G + θ̇(p_z, −p_x);  a_P = a_G + θ̈(p_z, −p_x) − θ̇²p
    matrix = np.array(
        [[1, 0, 0, 0, -1], [0, 1, 0, -1, 0], [0, 0, inertia, px, -pz], [0, 1, -px, 0, 0], [0, 0, 0, -mu, 1]]
    )
    right = np.array([-floor, -G, 0.0, omega**2 * pz, 0.0])
    ax, _, alpha, normal, _ = np.linalg.solve(matrix, right)
    assert normal > 0
    return [omega, alpha, slip_rate, ax + alpha * pz - omega**2 * px]


@both_laws
def test_finite_slide_rock_by_newtons_equations(law):
    b, h, mu, floor = 0.2, 0.8, 0.3, 0.6 * G
    solution = solve_ivp(
        lambda _, y: slide_rock_by_newton(y, floor, mu, b, h), (0, 0.3), [0, 0, 0, 0], rtol=1e-11, atol=1e-13
    )
    run = simulate(block(b, h), room(mu), constant(floor, 0.3), law)
    found = run.tilt[-1], run.rotation_rate[0, -1, 1], run.slide[-1], run.slide_rate[-1]
    assert found == pytest.approx(solution.y[:, -1], abs=1e-9)
