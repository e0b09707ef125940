"""From which level on each draw falls, found by halves of the levels."""

import numpy as np
import pytest

import stayput as sp
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME, RESULT, ROCKED
from stayput.mechanics.devices.columns import DEVICE
from stayput.mechanics.runner import no_elements
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.state import State
from stayput.montecarlo import runs as module
from stayput.montecarlo.runs import run_levels
from stayput.montecarlo.sampling import Rows
from stayput.montecarlo.scaled_motions import FloorMotions

LEVELS = np.linspace(5.0, 6.2, 9)
LIMITS = 5.0 + 0.1 * np.arange(16)


@pytest.mark.parametrize("given_up", [False, True])
def test_bisection_finds_where_each_draw_begins_to_fall(monkeypatch, given_up):
    made = []

    def run_columns(cases, elements, motions, motion, *, threads, on_progress):
        assert np.array_equal(motion, cases["slide_rate"].astype(int) // 8)
        results = np.zeros(len(cases), RESULT)
        fell = cases["scale"] > LIMITS[cases["slide_rate"].astype(int)]
        results["outcome"] = np.where(fell, OVERTURNED_OUTCOME, ROCKED)
        if given_up:
            results["outcome"][cases["scale"] < 5.3] = FAILED_OUTCOME
        made.append(len(cases))
        return results, np.zeros(elements.shape, DEVICE)

    monkeypatch.setattr(module, "run_columns", run_columns)
    case = case_columns(sp.Body(0.4, 1.6, 100.0), sp.Room(), State(), STANDARD_GRAVITY)
    rows = Rows(np.repeat(case, 16), no_elements(0, 16), np.full(16, 100.0))
    rows.cases["slide_rate"] = np.arange(16)  # the number of the draw
    (falls,) = run_levels(
        [rows],
        LEVELS,
        lambda level: FloorMotions((None,) * 2, np.full(2, level), {}),
        progress=lambda _: None,
    )
    known = ~falls.missing
    assert known.all() == (not given_up)
    assert known[LEVELS > 5.5].all()
    expected = LEVELS[:, np.newaxis, np.newaxis] > LIMITS.reshape(2, 8)
    assert np.array_equal(falls.overturned & known, expected & known)
    assert sum(made) <= 16 * 4  # 2⁴ > 9 levels
