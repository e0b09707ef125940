"""Impacts: none creates energy, and the fast path of a landing is the general case."""

import numpy as np
import pytest
from numba import njit

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics import geometry, impact, modes
from stayput.mechanics.records import Scratch
from stayput.model.flat_fields import case_columns

BODY = sp.Body(0.4, 1.6, 100.0)


def tables():
    return np.zeros(col.CONTACTS, col.CONTACT), np.zeros(col.CONTACTS, col.ROW), np.zeros(1, col.STATE)


def case_on(floor):
    return case_columns(BODY, sp.Room(floor), sp.State(), 9.81)[0]


@njit
def struck(case, contacts, rows, states, corner, closed, theta, velocity):
    """Energy after an impact over that before it."""
    s = states[0]
    geometry.set_up(case, contacts, s)
    geometry.turn_to(s, theta)
    s.x, s.z = -geometry.corner_right(case, corner, s), -geometry.corner_up(case, corner, s)
    s.vx, s.vz, s.omega = velocity
    before = s.vx**2 + s.vz**2 + case.inertia * s.omega**2
    impact.collide(rows, contacts, closed, case, s)
    return (s.vx**2 + s.vz**2 + case.inertia * s.omega**2) / before


def test_no_impact_creates_energy():
    """Walls, floor and ceiling of any friction and restitution, at any of their contacts at once."""
    rng = np.random.default_rng(5)
    for _ in range(2000):
        rebound, rub, grip = (
            rng.choice([0.0, 0.3, 0.9, 1.0]),
            rng.choice([0.0, 0.3, 3.0, 10.0]),
            rng.exponential(),
        )
        wall = sp.Wall(0.0, rebound, rub)
        floor = sp.Floor(grip, grip, normal_restitution=rng.choice([0.0, 0.5, 1.0]))
        room = sp.Room(floor, left_wall=wall, right_wall=wall, ceiling=sp.Ceiling(3.0, rebound, grip))
        body = sp.Body(rng.uniform(0.2, 1.5), rng.uniform(0.3, 2.0), 100.0)
        case = case_columns(body, room, sp.State(), 9.81)[0]
        velocity, closed = tuple(rng.normal(size=3)), int(rng.integers(1, 256))
        assert struck(case, *tables(), 0, closed, rng.uniform(-1.2, 1.2), velocity) <= 1.0 + 1e-9


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
    return both_ways(case_on(floor), *tables(), rate)


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
