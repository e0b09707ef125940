"""The fast path of a landing gives what the general impact and mode selection give."""

import numpy as np
import pytest
from mechanics_runs import case_of
from numba import njit

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics import geometry, impact, modes
from stayput.mechanics.records import Scratch


@njit
def both_ways(case, contacts, rows, states, rate):
    """Rates after a landing on B by the fast path and by the general case, and whether it applied."""
    s = states[0]
    geometry.set_up(case, contacts, s)
    s.alpha = 0.0
    s.kind, s.i, s.j, s.closed, s.hit, s.omega = col.ROCK, 0, -1, 1, 2, rate
    geometry.set_pivot_velocity(contacts[0], s)
    before = s.vx, s.vz, s.omega
    applied = impact.pivot_on_landing(contacts, 3, case, s, 0.0, case.gravity)
    fast = s.vx, s.vz, s.omega, s.kind, s.i
    s.vx, s.vz, s.omega = before
    s.kind, s.i, s.closed = col.ROCK, 0, 1
    impact.land(rows, contacts, 1, 2, case, s)
    load = 0.0, 0.0, case.gravity, 0.0
    modes.choose_mode(Scratch(contacts, rows), 3, s.settle_rate, case, s, None, load, 0.0)
    return applied, fast, (s.vx, s.vz, s.omega, s.kind, s.i)


def landing(floor, rate):
    tables = np.zeros(col.CONTACTS, col.CONTACT), np.zeros(col.CONTACTS, col.ROW), np.zeros(1, col.STATE)
    return both_ways(case_of(room=sp.Room(floor)), *tables, rate)


@pytest.mark.parametrize("restitution", [1.0, 0.6])
def test_a_plain_landing_is_that_of_the_general_case(restitution):
    applied, fast, general = landing(sp.Floor(0.6, 0.6, restitution=restitution), 1.0)
    assert applied
    assert fast == pytest.approx(general, abs=1e-12)


@pytest.mark.parametrize(
    "floor", [sp.Floor(0.05, 0.05), sp.Floor(0.6, 0.6, normal_restitution=0.5)], ids=["slips", "bounces"]
)
def test_a_landing_that_slips_or_bounces_is_left_to_the_general_case(floor):
    applied, fast, _ = landing(floor, 1.0)
    assert not applied
    assert fast[2:] == (1.0, col.ROCK, 0)  # the state is as it was
