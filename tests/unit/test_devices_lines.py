"""The lines' forces and margins are those of the law as it is written, about G and about a fulcrum."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mechanics_runs import case_of, plate
from numba import njit

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices.device_law import SLIP_RATE_TIME
from stayput.mechanics.devices.elements import evaluate_elements
from stayput.mechanics.devices.lines import (
    begin_step,
    evaluate_lines,
    first_crossing_candidate,
    line_force,
    set_lines,
)
from stayput.mechanics.devices.stepper import no_line_event
from stayput.mechanics.runner import no_elements
from stayput.model.flat_fields import case_columns

BRANCHES = (el.OPEN, el.PLUS, el.MINUS, el.BOND, el.SLIP_PLUS, el.SLIP_MINUS)


@njit
def by_elements(elements, links, state):
    """Force and moment about G; elongations, rates and forces are stored in the links."""
    sin, cos, x, z, vx, vz, omega = state
    return evaluate_elements(elements, links, sin, cos, x, z, vx, vz, omega)


def law(element, link, i):
    """Force of a line and its margins, branch by branch as the law is written."""
    k, c, mu = element["stiffness"][i], element["damping"][i], element["friction"]
    plus, minus = element["limit_plus"][i], element["limit_minus"][i]
    e, rate, p = link["e"][i], link["rate"][i], link["plastic"][i]
    above, below = e - p - element["slack_plus"][i], e - p + element["slack_minus"][i]
    rubs = i == 1 and not math.isnan(mu)
    if rubs:
        plus = minus = mu * link["push"]
    if element["interaction"]:
        plus, minus = math.inf, math.inf if i == 1 else minus
    branch = link["branch"][i]
    if branch == el.OPEN:
        over, under = k * above, k * below
        return 0.0, (-min(over, over + c * rate), max(under, under + c * rate))
    if branch in (el.PLUS, el.BOND):
        F = k * above + c * rate
        return F, (F if branch == el.PLUS else minus + F, plus - F)
    if branch == el.MINUS:
        F = k * below + c * rate
        return F, (-F, minus + F)
    side, most, spring = (1.0, plus, k * above) if branch == el.SLIP_PLUS else (-1.0, minus, -k * below)
    if rubs:
        return side * most, (SLIP_RATE_TIME * (k * side * rate - mu * link["push_rate"]), math.inf)
    back = min(spring - most, 0.0) + (c or k * SLIP_RATE_TIME) * side * rate
    left = k * (element["ultimate"][i] - link["plastic_sum"][i])
    return side * most, (back, left - max(spring - most, 0.0))


def by_law(elements, links):
    """The two margins of each line and the joint one; the stored forces follow the law."""
    both = np.full((len(elements), 5), np.nan)
    for element, link, row in zip(elements, links, both, strict=True):
        for i in range(link["lines"]):
            F, row[2 * i : 2 * i + 2] = law(element, link, i)
            assert link["force"][i] == pytest.approx(F, rel=1e-9, abs=1e-9)
        if element["interaction"]:
            pull, shear = link["force"]
            part = shear / element["limit_plus" if shear > 0.0 else "limit_minus"][1]
            row[4] = 1.0 - (max(0.0, pull) / element["limit_plus"][0]) ** 2 - part**2
    return both


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
@pytest.mark.parametrize("seed", range(12))
def test_rows_of_lines_follow_the_elements(kind, seed):
    rng = np.random.default_rng(seed)
    rows, links = random_rows(rng, kind)
    case = case_columns(sp.Body(width=0.4, height=1.8, mass=100.0), sp.Room(), sp.State(), 9.81)[0]
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
    fx, fz, about_G = by_elements(rows, links, state)
    found, margins_found, pulled, least, lowest = by_lines(
        rows, links, np.zeros(1, el.WORK), case, corner, tuple(foot), state
    )
    lever = 0.0 if corner < 0 else fx * (z - foot[1]) - fz * (x - foot[0])
    assert found == pytest.approx((fx, fz, about_G + lever), rel=1e-9, abs=1e-9)
    assert pulled == pytest.approx(found, rel=1e-12, abs=1e-12)
    np.testing.assert_allclose(margins_found, by_law(rows, links), rtol=1e-9, atol=1e-9)
    assert least == lowest


GRID = np.linspace(0.0, 1.0, 41)


@njit
def screened(case, rows, links, works, start, end, h):
    """Whether a step from one (x, ẋ) to another is skipped, and where a crossing is suspected."""
    work = works[0]
    work.slack_factor = 1.0
    set_lines(rows, links, case, -1, 0.0, 0.0, work)
    evaluate_lines(work, 0.0, 1.0, True, start[0], 0.0, start[1], 0.0, 0.0)
    begin_step(work)
    evaluate_lines(work, 0.0, 1.0, True, end[0], 0.0, end[1], 0.0, 0.0)
    skipped, _ = no_line_event(work, h, 0.0)
    (x0, v0), (x1, v1) = start, end
    x, v = 0.5 * (x0 + x1) + 0.125 * h * (v0 - v1), 1.5 * (x1 - x0) / h - 0.25 * (v0 + v1)
    candidate = first_crossing_candidate(work, 0.0, 1.0, True, x, 0.0, v, 0.0, 0.0)
    return skipped, h * candidate


@njit
def least(case, rows, links, works, x, v):
    work = works[0]
    work.slack_factor = 1.0
    set_lines(rows, links, case, -1, 0.0, 0.0, work)
    for r in range(work.lines):
        work.line[r].low = work.line[r].high = 0.0
    return evaluate_lines(work, 0.0, 1.0, True, x, 0.0, v, 0.0, 0.0)[3]


def cubic(x0, v0, x1, v1, h):
    """Place and rate of the cubic through both ends of a step."""
    u = GRID
    x = (
        x0 * (1 + 2 * u) * (1 - u) ** 2
        + h * v0 * u * (1 - u) ** 2
        + x1 * u**2 * (3 - 2 * u)
        + h * v1 * u**2 * (u - 1)
    )
    v = (x1 - x0) / h * 6 * u * (1 - u) + v0 * (1 - u) * (1 - 3 * u) + v1 * u * (3 * u - 2)
    return x, v


@pytest.mark.parametrize("slack", [0.0, 0.01])
def test_a_step_that_is_skipped_has_no_event(slack):
    case = case_of()
    rows = plate((0.0, 0.0), slack_plus=slack, slack_minus=slack, limit_plus=20.0, limit_minus=20.0)
    rows["damping"] = 3.0
    rng = np.random.default_rng(5)
    skipped_steps = 0
    for _ in range(400):
        links, works = np.zeros(1, el.LINK), np.zeros(1, el.WORK)
        links["lines"] = 2
        links["branch"] = el.BOND if slack == 0.0 else el.OPEN
        h = 0.01
        (x0, x1), (v0, v1) = rng.uniform(-0.02, 0.02, 2), rng.uniform(-1.0, 1.0, 2)
        if min(least(case, rows, links, works, x, v) for x, v in ((x0, v0), (x1, v1))) < 0.0:
            continue
        skipped, candidate = screened(case, rows, links, works, (x0, v0), (x1, v1), h)
        if skipped:
            skipped_steps += 1
            inside = [
                least(case, rows, links, works, x, v) for x, v in zip(*cubic(x0, v0, x1, v1, h), strict=True)
            ]
            assert min(inside) >= 0.0
        assert 0.0 < candidate <= h
    assert skipped_steps > 20
