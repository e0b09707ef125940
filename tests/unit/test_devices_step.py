"""One integration step: dense output, and the constraints of the mode."""

import math

import numpy as np
import pytest
from mechanics_runs import case_of, state_of_fifth_degree
from numba import njit

from stayput.mechanics import columns as col
from stayput.mechanics import geometry
from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import events, step


@njit
def interpolated(states, works, y0, k0, y1, k1, h, t):
    """The state inside a step in flight, by its dense output."""
    s, work = states[0], works[0]
    s.kind = col.FLIGHT
    events.set_dense_output(s, work, (y0, k0), (y1, k1), h)
    events.set_inside(s, work, (y0[2], math.sin(y0[2]), math.cos(y0[2])), h, t)
    return step.state_of(s), s.sin


@njit
def projected(case, contacts, states, works, kind, i):
    """Gap, gap rate and slip rate after a disturbed state is projected onto the mode's constraints."""
    s, work = states[0], works[0]
    geometry.set_up(case, contacts, s)
    work.foot = s.foot_b
    geometry.turn_to(s, 0.05)
    s.kind, s.i = kind, i
    s.x, s.z, s.vx, s.vz, s.omega = s.x + 1e-3, s.z + 1e-3, 0.4, 0.3, 0.2
    step.project_on_constraints(contacts, case, s, work)
    con = contacts[i]
    return geometry.gap(con, s), geometry.gap_rate(con, s), geometry.slip_rate(con, s), s.omega


@pytest.mark.parametrize("t", [0.0, 0.013, 0.05])
def test_dense_output_is_exact_for_motions_of_fifth_degree(t):
    h = 0.05
    records = np.zeros(1, col.STATE), np.zeros(1, el.WORK)
    found, sine = interpolated(*records, *state_of_fifth_degree(0.0), *state_of_fifth_degree(h), h, t)
    assert found == pytest.approx(state_of_fifth_degree(t)[0], abs=1e-12)
    assert sine == pytest.approx(math.sin(found[2]), abs=1e-12)


@pytest.mark.parametrize("kind", [col.ROCK, col.SLIDE_ROCK])
def test_the_state_is_projected_onto_the_contacts_of_the_mode(kind):
    tables = np.zeros(col.CONTACTS, col.CONTACT), np.zeros(1, col.STATE), np.zeros(1, el.WORK)
    gap, gap_rate, slip, omega = projected(case_of(), *tables, kind, 1)
    assert gap == pytest.approx(0.0, abs=1e-15)
    assert gap_rate == pytest.approx(0.0, abs=1e-15)
    assert omega == 0.2
    assert (abs(slip) < 1e-15) == (kind == col.ROCK)
