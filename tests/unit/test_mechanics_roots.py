"""Zero crossings within a step: polynomials whose zeros are known."""

import numpy as np
import pytest
from numba import njit

from stayput.mechanics import roots


@njit
def first_zero(ends, h):
    g0, v0, c0, g1, v1, c1 = ends
    return roots.first_closing(g0, v0, c0, g1, v1, c1, h)[0], roots.stays_positive(g0, v0, c0, g1, v1, c1, h)


@njit
def negative_at(f0, fm, f1):
    return roots.parabola_negative_at(f0, fm, f1)


def ends(p: np.polynomial.Polynomial, h: float) -> tuple[float, ...]:
    return tuple(float(p.deriv(k)(t)) if k else float(p(t)) for t in (0.0, h) for k in (0, 1, 2))


@pytest.mark.parametrize("h", [1e-3, 0.02, 1.0])
@pytest.mark.parametrize("zero", [0.05, 0.5, 0.99])
def test_the_zero_of_a_line_a_parabola_and_a_quintic(h, zero):
    u = np.polynomial.Polynomial([0.0, 1.0 / h])
    for p in (zero - u, (zero - u) * (2.0 + u), (zero - u) * (1.0 + u**2) * (3.0 - u**2)):
        t, positive = first_zero(ends(p, h), h)
        assert t == pytest.approx(zero * h, rel=1e-6)  # the callers refine it on the motion itself
        assert not positive


def test_the_first_of_two_zeros_between_positive_ends():
    p = np.polynomial.Polynomial.fromroots([0.3, 0.4])
    t, _ = first_zero(ends(p, 1.0), 1.0)
    assert t == pytest.approx(0.3, rel=1e-10)


def test_a_function_that_only_comes_near_has_no_zero():
    p = np.polynomial.Polynomial([0.26, -1.0, 1.0])  # least value 0.01
    assert first_zero(ends(p, 1.0), 1.0)[0] == -1.0


def test_no_zero_is_a_proof_only_when_true():
    """The test for no zero may be inconclusive, but never denies a zero that is there."""
    rng = np.random.default_rng(1)
    grid = np.linspace(0.0, 1.0, 2001)
    proved = 0
    for _ in range(300):
        p = np.polynomial.Polynomial(rng.normal(size=4))
        p -= p(0.0) - rng.uniform(0.01, 1.0)
        if first_zero(ends(p, 1.0), 1.0)[1]:
            proved += 1
            assert p(grid).min() >= 0.0
    assert proved > 50


def test_a_gap_that_opens_and_closes_within_a_step_closes_at_zero():
    p = np.polynomial.Polynomial.fromroots([0.0, 0.7]) * -1e-3
    assert first_zero(ends(p, 1.0), 1.0)[0] == pytest.approx(0.7, rel=1e-9)
    assert first_zero(ends(p, 0.6), 0.6)[0] == -1.0
    deep = p - 1e-5  # a closed gap may be a little below zero
    assert first_zero(ends(deep, 1.0), 1.0)[0] == pytest.approx(max(deep.roots()), rel=1e-6)


def test_a_corner_that_goes_up_and_returns_through_its_lowest_place_is_found():
    """Gap ½θ² − ½θ₀² while θ rises from θ₀, turns and falls through −θ₀: negative between θ₀ and −θ₀."""
    for start in (1e-4, 3e-4, 1e-3):
        theta = np.polynomial.Polynomial([start, 0.01, -5.0])
        p = 0.5 * (theta**2 - start**2)
        assert first_zero(ends(p, 0.03), 0.03)[0] == pytest.approx(0.002, rel=1e-6)


def test_where_a_parabola_is_negative():
    assert negative_at(1.0, -1.0, 1.0) == 0.5
    assert negative_at(1.0, 1.0, 1.0) == -1.0
    assert negative_at(1.0, 0.4, -0.2) == 1.0
    assert 0.15 <= negative_at(0.03, 0.08, 0.63) <= 0.35  # (u − 0.2)² − 0.01
    assert negative_at(0.05, 0.1, 0.65) == -1.0  # (u − 0.2)² + 0.01
