"""Event loop and its interface: initial states, the clock, batches, and runs that cannot be finished."""

import numpy as np
import pytest
from mechanics_runs import case_of, kinds, modes, steady, traced

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics.runner import run_cases, shaking


def test_an_initial_state_is_held_by_the_corner_that_it_tilts_to():
    for tilt in (0.05, -0.05):
        run = traced(steady(0.0, 0.05), tilt=tilt, slide=0.02)
        assert run.history[0, [col.H_TILT, col.H_SLIDE]] == pytest.approx([tilt, 0.02])
        assert modes(run)[0] is sp.Mode.ROCK
    slips = traced(steady(0.0, 0.05), room=sp.Room(sp.Floor(0.1, 0.1)), tilt=0.05, slide_rate=0.5)
    assert modes(slips)[0] is sp.Mode.SLIDE_ROCK
    assert slips.history[0, col.H_SLIDE_RATE] == pytest.approx(0.5)


def test_events_carry_the_state_just_after_them():
    run = traced(steady(0.0, 3.0), tilt=0.1)
    assert kinds(run)[0] is sp.EventKind.FLOOR_IMPACT
    assert run.events[0].tilt == pytest.approx(0.0, abs=1e-12)
    assert run.events[0].mode == col.ROCK_MODE
    assert run.result["floor_impacts"] == kinds(run).count(sp.EventKind.FLOOR_IMPACT)


def test_the_history_ends_where_the_body_overturns():
    run = traced(shaking(np.full(1001, 6.0), None, 0.01, 0))
    assert kinds(run)[-1] is sp.EventKind.OVERTURNED
    assert run.result["peak_tilt"] == pytest.approx(np.pi / 2, abs=1e-9)
    assert len(run.history) == int(run.result["end"] / 0.01) + 1 < 1001
    assert run.history[:, col.H_REACHED].all()


@pytest.mark.parametrize("law", [0, 1])
def test_too_many_events_end_a_run_as_failed(law):
    (result,) = run_cases(np.array([case_of(tilt=0.1)]), steady(0.0, 8.0, law=law), max_events=3)
    assert (result["outcome"], result["events"]) == (col.FAILED_OUTCOME, 3)


def test_a_motion_of_one_step_is_run():
    (result,) = run_cases(np.array([case_of()]), shaking(np.zeros(2), None, 0.01, 0))
    assert (result["outcome"], result["end"]) == (col.RESTED, 0.01)
