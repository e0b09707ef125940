"""The moment of all lines about a fulcrum, as a few coefficients, and the series of the tilt."""

import math

import numpy as np
import pytest
from mechanics_runs import case_of, plate, tie
from numba import njit

from stayput.mechanics import columns as col
from stayput.mechanics import geometry
from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import moment
from stayput.mechanics.devices.lines import line_force
from stayput.mechanics.devices.step import set_about_fulcrum


@njit
def stand(case, contacts, states, works, elements, links, theta):
    """Tilt the body about corner B, with the lines set about it."""
    s, work = states[0], works[0]
    geometry.set_up(case, contacts, s)
    s.kind, s.i, s.closed = col.ROCK, 1, 2
    geometry.turn_to(s, theta)
    s.x, s.z = s.foot_b - geometry.corner_right(case, 1, s), -geometry.corner_up(case, 1, s)
    set_about_fulcrum(elements, links, contacts, case, s, work)


@njit
def by_lines(works, theta, omega):
    return line_force(works[0], math.sin(theta), math.cos(theta), False, 0.0, 0.0, 0.0, 0.0, omega)[2]


@njit
def expanded(case, contacts, works, load, theta, omega, h, tolerance):
    con = contacts[1]
    q = 1.0 / (case.inertia + con.sigma * con.sigma + con.kappa * con.kappa)
    sin, cos = math.sin(theta), math.cos(theta)
    return moment.expand_tilt(works[0], con, q, load, theta, omega, sin, cos, h, tolerance)


@njit
def tilt_at(works, t):
    return moment.tilt_at(works[0], t)


@njit
def bound(works, h):
    return moment.deviation_from_cubic(works[0], h)


def tables():
    return np.zeros(col.CONTACTS, col.CONTACT), np.zeros(1, col.STATE), np.zeros(1, el.WORK)


def linked(rows, *branches, force=0.0):
    """Links of elements, each with its branches on both lines."""
    links = np.zeros(len(rows), el.LINK)
    links["lines"] = np.where(rows["kind"] == el.AXIAL, 1, 2)
    links["branch"] = branches
    links["x"], links["z"] = -0.3, 1.2
    links["force"][:, 0] = force
    return links


PLATES = np.concatenate([plate((0.1, 0.7), damping=7.0), plate((-0.2, 0.3), cos=0.8, sin=0.6, damping=3.0)])
POLE = plate((-0.1, 0.8), cos=-1.0, slack_minus=np.array([[0.01, 0.0]]), friction=0.4)
BONDED = plate((-0.1, 0.8), cos=-1.0, friction=0.4)
TIE = tie((0.0, 0.8), (-0.5, 1.6), damping=np.array([[9.0, 0.0]]))

HELD = {
    "bonded": (PLATES, linked(PLATES, (el.BOND, el.BOND), (el.BOND, el.BOND))),
    "one slack": (PLATES, linked(PLATES, (el.PLUS, el.OPEN), (el.OPEN, el.BOND))),
    "yielding": (PLATES, linked(PLATES, (el.SLIP_PLUS, el.BOND), (el.BOND, el.BOND))),
    "rubbing": (POLE, linked(POLE, (el.MINUS, el.SLIP_PLUS), force=-10.0)),
    "rubbing beside a bond": (BONDED, linked(BONDED, (el.BOND, el.SLIP_MINUS), force=-10.0)),
    "tied": (TIE, linked(TIE, (el.PLUS, el.OPEN))),
}


@pytest.mark.parametrize("name", HELD)
def test_the_series_obeys_the_equation_of_motion_with_the_moments_of_all_lines(name):
    rows, links = HELD[name]
    rows = rows.copy()
    rows["limit_plus"] = rows["limit_minus"] = np.where(np.isnan(rows["friction"]), 30.0, np.inf)[:, None]
    case, (contacts, states, works) = case_of(), tables()
    theta, omega, load = 0.02, 0.3, (1.5, -20.0, 9.0, 4.0)
    stand(case, contacts, states, works, rows, links, theta)
    h = expanded(case, contacts, works, load, theta, omega, 0.004, 1e-13)
    assert 0.0005 < h <= 0.004
    assert tilt_at(works, 0.0) == (theta, omega)
    sigma, kappa = contacts[1]["sigma"], contacts[1]["kappa"]
    for t in (0.0, 0.4 * h, h):
        tilt, rate = tilt_at(works, t)
        d = 1e-6
        acceleration = (tilt_at(works, t + d)[1] - tilt_at(works, t - d)[1]) / (2 * d)
        lever_x = kappa * math.cos(tilt) + sigma * math.sin(tilt)
        lever_z = sigma * math.cos(tilt) - kappa * math.sin(tilt)
        M = by_lines(works, tilt, rate)
        weight = lever_x * (load[0] + load[1] * t) + lever_z * (load[2] + load[3] * t)
        inertia = case["inertia"] + sigma**2 + kappa**2
        assert inertia * acceleration == pytest.approx(M - weight, rel=1e-7, abs=1e-6)


def test_a_step_that_needs_fewer_terms_has_fewer():
    case, (contacts, states, works) = case_of(), tables()
    rows, links = HELD["bonded"]
    stand(case, contacts, states, works, rows, links, 0.02)
    for h in (1e-4, 0.02):
        assert expanded(case, contacts, works, (0.0, 0.0, 9.8, 0.0), 0.02, 0.3, h, 1e-9) <= h
        assert works["order"][0] == (moment.LEAST_ORDER if h < 1e-3 else el.ORDER)


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
