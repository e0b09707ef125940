"""Step screening is conservative: where it skips a step, no margin changes sign inside it."""

import numpy as np
import pytest
from mechanics_runs import case_of, plate
from numba import njit

from stayput.mechanics.devices import columns as el
from stayput.mechanics.devices import lines, stepper

GRID = np.linspace(0.0, 1.0, 41)


@njit
def screened(case, rows, links, works, start, end, h):
    """Whether a step from one (x, ẋ) to another is skipped, and where a crossing is suspected."""
    work = works[0]
    work.slack_factor = 1.0
    lines.set_lines(rows, links, case, -1, 0.0, 0.0, work)
    lines.evaluate_lines(work, 0.0, 1.0, True, start[0], 0.0, start[1], 0.0, 0.0)
    lines.begin_step(work)
    lines.evaluate_lines(work, 0.0, 1.0, True, end[0], 0.0, end[1], 0.0, 0.0)
    skipped, _ = stepper.no_line_event(work, h, 0.0)
    (x0, v0), (x1, v1) = start, end
    x, v = 0.5 * (x0 + x1) + 0.125 * h * (v0 - v1), 1.5 * (x1 - x0) / h - 0.25 * (v0 + v1)
    candidate = lines.first_crossing_candidate(work, 0.0, 1.0, True, x, 0.0, v, 0.0, 0.0)
    return skipped, h * candidate


@njit
def least(case, rows, links, works, x, v):
    work = works[0]
    work.slack_factor = 1.0
    lines.set_lines(rows, links, case, -1, 0.0, 0.0, work)
    for r in range(work.lines):
        work.line[r].low = work.line[r].high = 0.0
    return lines.evaluate_lines(work, 0.0, 1.0, True, x, 0.0, v, 0.0, 0.0)[3]


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
