"""Force law of one line: branches, slip, rupture, interaction."""

import numpy as np
import pytest
from mechanics_runs import plate
from numba import njit

from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import device_law as law

NORMAL, TANGENT = el.NORMAL, el.TANGENT


@njit
def path(rows, links, devices, i, elongations, rates):
    """Force and branch of a line along a path of elongations, its branch updated at each point."""
    element, link, device = rows[0], links[0], devices[0]
    link.lines = 2
    law.reset_branch(element, link, 0)
    law.reset_branch(element, link, 1)
    forces, branches = np.zeros(len(elongations)), np.zeros(len(elongations))
    for n in range(len(elongations)):
        if link.lines == 0:
            break
        link.e[i], link.rate[i] = elongations[n], rates[n]
        law.update_element(element, link, device, float(n))
        forces[n], branches[n] = link.force[i], link.branch[i]
    return forces, branches


def run(rows, i, elongations, rates=None):
    links, devices = np.zeros(1, el.LINK), np.zeros(1, el.DEVICE)
    e = np.array(elongations, float)
    rates = np.gradient(e) if rates is None else np.array(rates, float)
    forces, branches = path(rows, links, devices, i, e, rates)
    return forces, branches, links[0], devices[0]


def test_a_bonded_line_is_one_spring_to_both_sides():
    forces, branches, _, _ = run(plate((0.0, 0.0)), NORMAL, [0.0, 0.01, -0.02])
    assert forces == pytest.approx([0.0, 10.0, -20.0])
    assert set(branches) == {el.BOND}


def test_a_line_with_slack_pulls_only_beyond_it():
    rows = plate((0.0, 0.0), slack_plus=0.01, slack_minus=np.inf)
    forces, branches, _, _ = run(rows, NORMAL, [0.0, 0.005, 0.02, 0.005, -0.1], [1.0, 1.0, 1.0, -1.0, -1.0])
    assert forces == pytest.approx([0.0, 0.0, 10.0, 0.0, 0.0])
    assert branches.tolist() == [el.OPEN, el.OPEN, el.PLUS, el.OPEN, el.OPEN]


def test_a_damper_never_turns_a_ties_force_round():
    rows = plate((0.0, 0.0), slack_plus=0.0, slack_minus=np.inf, damping=50.0)
    forces, branches, _, _ = run(rows, NORMAL, [0.01, 0.01], [0.1, -1.0])
    assert forces == pytest.approx([15.0, 0.0])
    assert branches[-1] == el.OPEN


def test_a_ductile_line_yields_and_keeps_its_plastic_elongation():
    rows = plate((0.0, 0.0), limit_plus=10.0, limit_minus=10.0, ultimate=0.1)
    # loaded to 30 mm, of which 20 mm are plastic, and unloaded
    forces, branches, link, _ = run(rows, NORMAL, [0.0, 0.011, 0.03, 0.03, 0.02], [1.0, 1.0, 1.0, -1.0, -1.0])
    assert forces[1:3] == pytest.approx([10.0, 10.0])
    assert branches[1:3].tolist() == [el.SLIP_PLUS, el.SLIP_PLUS]
    assert link["plastic"][NORMAL] == pytest.approx(0.02)
    assert link["plastic_sum"][NORMAL] == pytest.approx(0.02)
    assert forces[-1] == pytest.approx(0.0, abs=1e-12)


def test_a_ductile_line_ruptures_where_its_plastic_elongation_is_used_up():
    rows = plate((0.0, 0.0), limit_plus=10.0, limit_minus=10.0, ultimate=0.01)
    *_, link, device = run(rows, NORMAL, [0.0, 0.015, 0.021], [1.0, 1.0, 1.0])
    assert link["lines"] == 0
    assert (device["failure"], device["failure_time"]) == (el.DRAWN_OUT, 2.0)


@pytest.mark.parametrize(
    ("line", "elongation", "failure"),
    [(NORMAL, 0.02, el.PULLED), (NORMAL, -0.02, el.PUSHED), (TANGENT, 0.02, el.SHEARED)],
)
def test_a_brittle_line_fails_at_its_strength(line, elongation, failure):
    rows = plate((0.0, 0.0), limit_plus=10.0, limit_minus=10.0)
    *_, link, device = run(rows, line, [0.0, elongation])
    assert link["lines"] == 0
    assert device["failure"] == failure
    peak = {el.PULLED: "peak_pull", el.PUSHED: "peak_push", el.SHEARED: "peak_shear"}[failure]
    assert device[peak] == 10.0


def test_pull_and_shear_together_break_below_either_strength():
    @njit
    def used(rows, links, pull, shear):
        normal, tangent = law.branch_of(rows[0], links[0], 0), law.branch_of(rows[0], links[0], 1)
        return law.utilization_of(normal, pull) + law.utilization_of(tangent, shear)

    def margin(rows, pull, shear):
        return 1.0 - used(rows, np.zeros(1, el.LINK), pull, shear)

    rows = plate((0.0, 0.0), limit_plus=10.0, limit_minus=10.0, interaction=1)
    assert margin(rows, 6.0, 8.0) == pytest.approx(0.0, abs=1e-15)
    assert margin(rows, 7.0, 8.0) < 0.0
    assert margin(rows, -50.0, 8.0) == pytest.approx(0.36)
    assert margin(plate((0.0, 0.0)), 50.0, 50.0) == 1.0
