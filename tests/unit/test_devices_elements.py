"""Elements at an event: anchors, force and moment on the body."""

import numpy as np
import pytest
from mechanics_runs import case_of, plate, tie
from numba import njit

from stayput.mechanics import columns as col
from stayput.mechanics import geometry
from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import elements


@njit
def forces(case, contacts, states, rows, links, devices, x, tilt):
    s = states[0]
    geometry.set_up(case, contacts, s)
    elements.set_up_elements(rows, links, devices, case, s)
    place = s.x + x, s.z
    wrench = (0.0, 0.0, 0.0)
    for _ in range(2):  # the branches follow the elongations
        wrench = elements.evaluate_elements(
            rows, links, np.sin(tilt), np.cos(tilt), place[0], place[1], 0.0, 0.0, 0.0
        )
        elements.update_elements(rows, links, devices, 0.0)
    return wrench, elements.no_element_left(links)


def run(rows, x=0.0, tilt=0.0):
    tables = np.zeros(col.CONTACTS, col.CONTACT), np.zeros(1, col.STATE)
    links, devices = np.zeros(len(rows), el.LINK), np.zeros(len(rows), el.DEVICE)
    wrench, none_left = forces(case_of(), *tables, rows, links, devices, x, tilt)
    return wrench, none_left, links


def test_elements_are_without_force_at_rest():
    for rows in (plate((0.0, -0.8)), tie((0.2, 0.8), (1.0, 1.6))):
        wrench, none_left, _ = run(rows)
        assert wrench == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
        assert not none_left


def test_a_displaced_plate_pulls_the_body_back_with_its_moment_about_g():
    wrench, _, links = run(plate((0.1, -0.8)), x=0.01)
    assert wrench == pytest.approx((-10.0, 0.0, 8.0))  # force −10 N/kg, 0.8 m below G
    assert links["force"][0].tolist() == pytest.approx([0.0, 10.0])


def test_a_tie_pulls_along_itself():
    wrench, _, _ = run(tie((0.2, 0.8), (1.0, 1.6)), x=-0.01)
    assert wrench[:2] == pytest.approx((10.0, 0.0))
    assert wrench[2] == pytest.approx(8.0)
    slack, _, _ = run(tie((0.2, 0.8), (1.0, 1.6)), x=0.01)
    assert slack == (0.0, 0.0, 0.0)


def test_rows_of_no_kind_do_nothing():
    from stayput.mechanics.runner import no_elements

    wrench, none_left, _ = run(no_elements(3), x=0.1, tilt=0.1)
    assert wrench == (0.0, 0.0, 0.0)
    assert none_left
