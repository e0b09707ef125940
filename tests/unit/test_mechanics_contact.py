"""Contact problem: the loads that friction can balance, and consistent active sets."""

import math

import numpy as np
import pytest
from numba import njit

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics import contact, geometry
from stayput.simulation.flat_fields import case_columns

G = 9.81


@njit
def cone(case, contacts, rows, states):
    """Ratios ẍ_G/G between which both base corners hold the body."""
    s = states[0]
    geometry.set_up(case, contacts, s)
    count = contact.fill_rows(rows, contacts, 3, s.sin, s.cos, case)
    exists, lx, lz, hx, hz = contact.holding_cone(rows, 0, count, -1)
    return exists, lx / lz, hx / hz


@njit
def active_sets(case, contacts, rows, states, a, g):
    """Consistency of B sticking, B slipping left, no contact, under the load (a, g) on a body at rest."""
    s = states[0]
    geometry.set_up(case, contacts, s)
    count = contact.fill_rows(rows, contacts, 3, s.sin, s.cos, case)
    for k in range(count):
        rows[k].bias_n, rows[k].bias_t = -g, -a
        rows[k].target = rows[k].slipping = 0.0
    sticks = contact.one_sticks(rows, count, 1, case.inertia, 1e-11)
    slips = contact.one_slips(rows, count, 1, 1.0, case.inertia, 1e-11)
    return sticks, slips, contact.no_contact_closes(rows, count, 1e-11)


def tables():
    return np.zeros(col.CONTACTS, col.CONTACT), np.zeros(col.CONTACTS, col.ROW), np.zeros(1, col.STATE)


@pytest.mark.parametrize("mu", [0.0, 0.1, 0.24, 0.26, 0.8])
@pytest.mark.parametrize("offset", [0.0, 0.05])
def test_a_body_rests_below_friction_and_slenderness(mu, offset):
    body = sp.Body(0.4, 1.6, 100.0, cg_offset=(offset, 0.0))
    (case,) = case_columns(body, sp.Room(sp.Floor(mu, mu)), sp.State(), G)
    exists, low, high = cone(case, *tables())
    assert exists
    assert low == pytest.approx(-min(mu, (0.2 - offset) / 0.8), abs=1e-12)
    assert high == pytest.approx(min(mu, (0.2 + offset) / 0.8), abs=1e-12)


def test_rocking_starts_where_the_sticking_corner_alone_is_consistent():
    (case,) = case_columns(sp.Body(0.4, 1.6, 100.0), sp.Room(sp.Floor(0.6, 0.6)), sp.State(), G)
    sticks, _, opens = active_sets(case, *tables(), -0.4 * G, G)
    ok, fx, fz, moment = sticks
    assert ok
    assert not opens
    alpha = moment / case["inertia"]
    # §3: (I + r²) θ̈ = −κ A − σ Γ, 1.2984 rad/s² for this block at 0.4 g
    assert abs(alpha) == pytest.approx(1.2984, abs=1e-4)
    assert fz > 0.0
    assert abs(fx) <= 0.6 * fz


def test_slide_rock_starts_where_the_slipping_corner_alone_is_consistent():
    (case,) = case_columns(sp.Body(0.4, 1.6, 100.0), sp.Room(sp.Floor(0.26, 0.26)), sp.State(), G)
    (sticks, *_), (slips, _, _, moment), _ = active_sets(case, *tables(), -0.4 * G, G)
    assert not sticks
    assert slips
    assert abs(moment / case["inertia"]) == pytest.approx(0.3487, abs=1e-4)


def test_without_weight_every_contact_opens():
    (case,) = case_columns(sp.Body(0.4, 1.6, 100.0), sp.Room(), sp.State(), G)
    assert active_sets(case, *tables(), 0.0, -1.0)[2]
    assert math.isclose(case["gravity"], G)
