"""Elementary functions of the mechanics: within a unit in the last place of the C library's."""

import math

import numpy as np
import pytest
from numba import njit

from stayput.mechanics import elementary


@njit
def sines(x):
    return [elementary.sine_and_cosine(value) for value in x]


@njit
def exponentials(x):
    return [elementary.exponential(value) for value in x]


@njit
def angles(run, rise):
    return [elementary.slope_angle(a, b) for a, b in zip(run, rise)]  # noqa: B905 - not known to Numba


@njit
def roots(x):
    return [(elementary.fifth_root(value), elementary.sixth_root(value)) for value in x]


def units(found, truth):
    return np.abs(found - truth) / np.spacing(np.abs(truth))


@pytest.mark.parametrize("reach", [1e-8, 0.01, 0.8, 2.0, 100.0])
def test_sine_and_cosine_are_within_a_unit(reach):
    x = np.random.default_rng(1).uniform(-reach, reach, 20_000)
    sin, cos = np.array(sines(x)).T
    assert units(sin, np.sin(x)).max() <= 1.0
    assert units(cos, np.cos(x)).max() <= 1.0


def test_sine_and_cosine_where_they_are_zero_or_one():
    assert sines(np.zeros(1)) == [(0.0, 1.0)]
    x = np.arange(-8, 9) * math.pi / 2
    assert pytest.approx(np.array([np.sin(x), np.cos(x)]), rel=1e-16, abs=1e-25) == np.array(sines(x)).T


def test_sine_and_cosine_of_what_is_not_finite_are_not_numbers():
    assert np.isnan(sines(np.array([math.nan, math.inf]))).all()


def test_sine_and_cosine_of_any_angle_are_no_more_than_one():
    x = np.concatenate([np.geomspace(1e3, 1e300, 2000), -np.geomspace(1e3, 1e300, 2000)])
    assert np.abs(sines(x)).max() <= 1.0 + 1e-6


def test_angles_of_slopes_are_within_two_units():
    rng = np.random.default_rng(2)
    run, rise = rng.uniform(1e-3, 1.0, 20_000), rng.uniform(-3.0, 3.0, 20_000)
    assert units(np.array(angles(run, rise)), np.arctan2(rise, run)).max() <= 2.0
    assert angles(np.ones(1), np.zeros(1)) == [0.0]


def test_roots_are_within_a_hundredth():
    x = np.geomspace(1e-7, 1e4, 1000)
    fifth, sixth = np.array(roots(x)).T
    assert fifth == pytest.approx(x**0.2, rel=0.015)
    assert sixth == pytest.approx(x ** (1 / 6), rel=0.015)


@pytest.mark.parametrize("reach", [1e-9, 0.3, 1.0, 30.0, 700.0])
def test_the_exponential_is_within_a_unit(reach):
    x = np.random.default_rng(3).uniform(-reach, reach, 20_000)
    assert units(np.array(exponentials(x)), np.exp(x)).max() <= 1.0


def test_the_exponential_at_its_ends():
    x = np.array([-math.inf, -800.0, -745.13, -708.5, 0.0, 709.78, 710.0, math.inf, math.nan])
    with np.errstate(over="ignore"):
        truth = np.exp(x)
    assert np.array(exponentials(x)) == pytest.approx(truth, rel=1e-15, abs=1e-323, nan_ok=True)
