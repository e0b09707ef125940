"""Taylor series of the tilt against the numerical solution of the same equations of motion."""

import math

import numpy as np
import pytest
from numba import njit
from scipy.integrate import solve_ivp

from stayput.mechanics import series

I, R, ALPHA = 0.17, 0.8, 0.25  # I = J_G/m [m²], fulcrum to G [m], its angle from the vertical [rad]
LOAD = (2.0, -30.0, 9.0, 15.0)  # A, its rate, Γ, its rate


@njit
def sticking(q, sigma, kappa, theta, omega, load, h):
    return series.tilt_after(series.rock_series(q, sigma, kappa, theta, omega, load), h)


@njit
def slipping(inertia, mu_d, sigma, kappa, theta, omega, load, h):
    return series.tilt_after(series.slide_rock_series(inertia, mu_d, sigma, kappa, theta, omega, load), h)


@njit
def step_length(h, coefficients, tolerance):
    return series.step_within(h, coefficients, tolerance)


def integrated(acceleration, theta, omega, h):
    found = solve_ivp(
        lambda t, y: [y[1], acceleration(t, *y)], (0.0, h), [theta, omega], rtol=1e-12, atol=1e-14
    )
    return found.y[:, -1]


@pytest.mark.parametrize(("theta", "omega"), [(0.0, 0.4), (0.1, -1.0), (-0.05, 0.0)])
def test_rocking_on_a_sticking_fulcrum(theta, omega):
    h = 0.01

    def acceleration(t, tilt, _):
        sigma, kappa = R * math.sin(ALPHA - tilt), R * math.cos(ALPHA - tilt)
        return -(kappa * (LOAD[0] + LOAD[1] * t) + sigma * (LOAD[2] + LOAD[3] * t)) / (I + R**2)

    sigma, kappa = R * math.sin(ALPHA - theta), R * math.cos(ALPHA - theta)
    found = sticking(-1.0 / (I + R**2), sigma, kappa, theta, omega, LOAD, h)
    assert found == pytest.approx(integrated(acceleration, theta, omega, h), abs=1e-11)


@pytest.mark.parametrize("mu_d", [0.0, 0.3, -0.5])
def test_rocking_on_a_slipping_fulcrum(mu_d):
    theta, omega, h = 0.05, 0.7, 0.002

    def acceleration(t, tilt, rate):
        sigma, kappa = R * math.sin(ALPHA - tilt), R * math.cos(ALPHA - tilt)
        k = sigma - mu_d * kappa
        return -k * (LOAD[2] + LOAD[3] * t - kappa * rate**2) / (I + k * sigma)

    sigma, kappa = R * math.sin(ALPHA - theta), R * math.cos(ALPHA - theta)
    found = slipping(I, mu_d, sigma, kappa, theta, omega, LOAD, h)
    assert found == pytest.approx(integrated(acceleration, theta, omega, h), abs=1e-11)


def test_a_step_is_shortened_until_its_last_term_is_within_the_tolerance():
    coefficients = (0.0, 1.0, 0.5, 0.1, 0.1, 0.1, 3.0, 50.0)
    assert step_length(1e-3, coefficients, 1e-10) == 1e-3
    h = step_length(0.5, coefficients, 1e-10)
    assert 50.0 * h**7 <= 1e-10
    assert h > 0.01


def test_a_series_without_odd_terms_is_not_taken_to_be_exact():
    even = (0.1, 0.0, 0.5, 0.0, 2.0, 0.0, 300.0, 0.0)  # as at a release from rest
    assert step_length(1.0, even, 1e-10) < 0.1
    assert np.isfinite(step_length(1.0, (0.0,) * 8, 1e-10))
