"""Event detection within a step: the time of an event is exact."""

import numpy as np
import pytest
from mechanics_runs import BLOCK, case_of, kinds, plate, steady

import stayput as sp
from stayput.mechanics.runner import trace


def test_a_slack_tie_becomes_taut_at_the_exact_time():
    """On a free slide the elongation is v t: the force begins at slack/v, whatever the samples."""
    room = sp.Room(sp.Floor(0.0, 0.0))
    rows = plate((0.0, -0.8), slack_plus=0.01, slack_minus=np.inf)
    rows["stiffness"][:, 0], rows["slack_plus"][:, 0] = 0.0, np.inf
    rows["limit_plus"][:, 1] = 1e-9  # it breaks as it begins to pull
    found = trace(case_of(BLOCK, room, slide_rate=0.3), steady(0.0, 0.2), rows)
    assert found.devices["failure_time"][0] == pytest.approx(0.01 / 0.3, abs=1e-8)


def test_a_gap_closes_at_the_exact_time():
    """A free slide towards a wall: the impact is at gap/v, whatever the samples."""
    room = sp.Room(sp.Floor(0.0, 0.0), right_wall=sp.Wall(0.01, 0.5, 0.0))
    rows = plate((0.0, -0.8), slack_plus=1.0, slack_minus=1.0)
    run = trace(case_of(BLOCK, room, slide_rate=0.3), steady(0.0, 0.2), rows)
    hit = run.events[0]
    assert kinds(run)[0] is sp.EventKind.WALL_IMPACT
    assert hit.time == pytest.approx(0.01 / 0.3, abs=1e-9)
    assert hit.slide == pytest.approx(0.01, abs=1e-10)
