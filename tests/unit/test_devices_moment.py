"""The moment of all lines about a fulcrum, as a few coefficients, and the series of the tilt."""

import numpy as np
import pytest
from numba import njit

from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import moment


@njit
def tilt_at(works, t):
    return moment.tilt_at(works[0], t)


@njit
def bound(works, h):
    return moment.deviation_from_cubic(works[0], h)


def test_the_bound_of_the_deviation_from_a_cubic_holds():
    works = np.zeros(1, el.WORK)
    rng = np.random.default_rng(1)
    u = np.linspace(0.0, 1.0, 201)
    h = 0.02
    for _ in range(50):
        works["order"] = order = int(rng.integers(6, el.ORDER + 1))
        terms = rng.normal(size=order + 1)
        works["tilt"][0, : order + 1] = terms / h ** np.arange(order + 1)
        works["rate"][0, :order] = works["tilt"][0, 1 : order + 1] * np.arange(1, order + 1)
        y = np.polynomial.Polynomial(terms)
        (y0, y1), (v0, v1) = y(np.array([0.0, 1.0])), y.deriv()(np.array([0.0, 1.0]))
        cubic = (
            y0 * (1 + 2 * u) * (1 - u) ** 2
            + v0 * u * (1 - u) ** 2
            + y1 * u**2 * (3 - 2 * u)
            + v1 * u**2 * (u - 1)
        )
        assert np.abs(y(u) - cubic).max() <= bound(works, h) * (1 + 1e-12)
        assert tilt_at(works, 0.3 * h)[0] == pytest.approx(y(0.3), rel=1e-12)
        assert tilt_at(works, 0.3 * h)[1] == pytest.approx(y.deriv()(0.3) / h, rel=1e-11, abs=1e-9)
