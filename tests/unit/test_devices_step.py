"""One integration step: the constraints of the mode."""

import numpy as np
import pytest
from mechanics_runs import case_of
from numba import njit

from stayput.mechanics import columns as col
from stayput.mechanics import geometry
from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import step


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


@pytest.mark.parametrize("kind", [col.ROCK, col.SLIDE_ROCK])
def test_the_state_is_projected_onto_the_contacts_of_the_mode(kind):
    tables = np.zeros(col.CONTACTS, col.CONTACT), np.zeros(1, col.STATE), np.zeros(1, el.WORK)
    gap, gap_rate, slip, omega = projected(case_of(), *tables, kind, 1)
    assert gap == pytest.approx(0.0, abs=1e-15)
    assert gap_rate == pytest.approx(0.0, abs=1e-15)
    assert omega == 0.2
    assert (abs(slip) < 1e-15) == (kind == col.ROCK)
