"""Branch coefficients agree with the force law that they stand for, about G and about a fulcrum."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numba import njit

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices.active_elements import evaluate_lines, line_force
from stayput.mechanics.devices.branch_law import set_lines
from stayput.mechanics.devices.device_law import interaction_margin, margins
from stayput.mechanics.devices.elements import evaluate_elements
from stayput.mechanics.devices.runner import no_elements
from stayput.simulation.flat_fields import case_columns

BRANCHES = (el.OPEN, el.PLUS, el.MINUS, el.BOND, el.SLIP_PLUS, el.SLIP_MINUS)


@njit
def by_elements(elements, links, state):
    """Force and moment about G, with the two margins of each line and the joint one."""
    sin, cos, x, z, vx, vz, omega = state
    found = evaluate_elements(elements, links, sin, cos, x, z, vx, vz, omega)
    both = np.full((len(elements), 5), np.nan)
    for n in range(len(elements)):
        element, link = elements[n], links[n]
        for i in range(link.lines):
            e, rate = link.e[i], link.rate[i]
            both[n, 2 * i], both[n, 2 * i + 1] = margins(element, link, i, e, rate, link.push, link.push_rate)
        if link.lines == 2 and element.interaction != 0:
            both[n, 4] = interaction_margin(element, link.force[0], link.force[1])
    return found, both


@njit
def by_lines(elements, links, works, case, corner, origin, state):
    """The same of the lines' rows, with the moment about the origin."""
    sin, cos, x, z, vx, vz, omega = state
    work, moves = works[0], corner < 0
    set_lines(elements, links, case, corner, origin[0], origin[1], work)
    fx, fz, moment, least = evaluate_lines(work, sin, cos, moves, x, z, vx, vz, omega)
    both = np.full((len(elements), 5), np.nan)
    lowest = math.inf
    for r in range(work.lines):
        line = work.line[r]
        n, i = line.element, line.tangent
        both[n, 2 * i], both[n, 2 * i + 1] = line.low1, line.high1
        lowest = min(lowest, line.low1, line.high1)
        if line.interacts != 0:
            both[n, 4] = line.joint1
            lowest = min(lowest, line.joint1)
    return (fx, fz, moment), both, line_force(work, sin, cos, moves, x, z, vx, vz, omega), least, lowest


def random_rows(rng: np.random.Generator, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Return one element of a kind somewhere on the body, and a link on a random branch that it can have."""
    rows, links = no_elements(1), np.zeros(1, el.LINK)
    row, link = rows[0], links[0]
    axial = kind == "tie"
    row["kind"] = el.AXIAL if axial else el.PLANAR
    angle = rng.uniform(0.0, 2.0 * math.pi)
    row["cos"], row["sin"], row["length"] = math.cos(angle), math.sin(angle), rng.uniform(0.1, 0.5)
    row["u"], row["v"] = rng.uniform(-0.5, 0.5, 2)
    row["stiffness"], row["damping"] = rng.uniform(100.0, 3000.0, 2), rng.uniform(0.0, 20.0, 2)
    row["slack_plus"], row["slack_minus"] = rng.uniform(-1e-3, 5e-3, 2), rng.uniform(2e-3, 8e-3, 2)
    row["limit_plus"], row["limit_minus"] = rng.uniform(5.0, 50.0, 2), rng.uniform(5.0, 50.0, 2)
    if kind == "ductile":
        row["ultimate"] = rng.uniform(0.01, 0.1, 2)
    if kind == "pole":
        row["friction"], row["damping"] = rng.uniform(0.1, 1.0), 0.0
    if kind == "gel":
        row["interaction"] = 1
    link["lines"] = 1 if axial else 2
    link["x"], link["z"] = rng.uniform(-0.5, 0.5, 2)
    link["branch"] = rng.choice(BRANCHES, 2)
    link["plastic"], link["plastic_sum"] = rng.uniform(-2e-3, 2e-3, 2), rng.uniform(0.0, 5e-3, 2)
    if kind == "gel":  # it breaks, and never slips
        link["branch"] = rng.choice(BRANCHES[:4], 2)
    return rows, links


@pytest.mark.parametrize("kind", ["tie", "bracket", "ductile", "pole", "gel"])
@pytest.mark.parametrize("seed", range(40))
def test_rows_of_lines_follow_the_elements(kind, seed):
    rng = np.random.default_rng(seed)
    rows, links = random_rows(rng, kind)
    case = case_columns(sp.Body(width=0.4, height=1.8), sp.Room(), sp.State(), 9.81)[0]
    theta, omega = rng.uniform(-0.3, 0.3), rng.uniform(-1.0, 1.0)
    sin, cos = math.sin(theta), math.cos(theta)
    corner = int(rng.integers(4)) if seed % 2 else -1
    foot = rng.uniform(-0.3, 0.3, 2) if corner >= 0 else np.zeros(2)
    if corner < 0:
        x, z, vx, vz = rng.uniform(-0.5, 0.5, 4)
    else:  # turns about the corner, which stays
        u, v = case["u"][corner], case["v"][corner]
        right, up = u * cos + v * sin, v * cos - u * sin
        x, z, vx, vz = foot[0] - right, foot[1] - up, -omega * up, omega * right
    state = (sin, cos, x, z, vx, vz, omega)
    (fx, fz, about_G), expected = by_elements(rows, links, state)
    found, margins_found, pulled, least, lowest = by_lines(
        rows, links, np.zeros(1, el.WORK), case, corner, tuple(foot), state
    )
    lever = 0.0 if corner < 0 else fx * (z - foot[1]) - fz * (x - foot[0])
    assert found == pytest.approx((fx, fz, about_G + lever), rel=1e-9, abs=1e-9)
    assert pulled == pytest.approx(found, rel=1e-12, abs=1e-12)
    np.testing.assert_allclose(margins_found, expected, rtol=1e-9, atol=1e-9)
    assert least == lowest
