"""Event loop: initial states, the order of events, and runs that cannot be finished."""

import numpy as np
import pytest
from mechanics_runs import G, case_of, kinds, modes, steady, traced

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics.runner import run_cases, shaking


def test_an_initial_tilt_is_held_by_the_right_corner():
    for tilt in (0.05, -0.05):
        run = traced(steady(0.0, 0.05), tilt=tilt, slide=0.02)
        assert run.history[0, [col.H_TILT, col.H_SLIDE]] == pytest.approx([tilt, 0.02])
        assert modes(run)[0] is sp.Mode.ROCK


def test_an_initial_slide_rate_under_a_tilt_slips():
    run = traced(steady(0.0, 0.05), room=sp.Room(sp.Floor(0.1, 0.1)), tilt=0.05, slide_rate=0.5)
    assert modes(run)[0] is sp.Mode.SLIDE_ROCK
    assert run.history[0, col.H_SLIDE_RATE] == pytest.approx(0.5)


def test_events_follow_one_another_in_time_up_to_the_end():
    run = traced(steady(0.0, 8.0), tilt=0.1)
    times = [event.time for event in run.events]
    assert times == sorted(times)
    assert kinds(run)[0] is sp.EventKind.FLOOR_IMPACT
    assert modes(run)[-1] is sp.Mode.REST
    assert run.result["floor_impacts"] == kinds(run).count(sp.EventKind.FLOOR_IMPACT)


def test_overturning_ends_the_run_at_a_right_angle():
    run = traced(steady(0.5 * G, 5.0))
    assert list(sp.Outcome)[run.result["outcome"]] is sp.Outcome.OVERTURNED
    assert kinds(run)[-1] is sp.EventKind.OVERTURNED
    assert run.result["peak_tilt"] == pytest.approx(np.pi / 2, abs=1e-9)
    assert run.result["end"] < 5.0


@pytest.mark.parametrize("law", [0, 1])
def test_too_many_events_end_a_run_as_failed(law):
    cases = np.array([case_of(tilt=0.1)])
    motion = steady(0.0, 8.0, law=law)
    (result,) = run_cases(cases, motion, max_events=3)
    assert (result["outcome"], result["events"]) == (col.FAILED_OUTCOME, 3)


def test_a_motion_of_one_step_is_run():
    motion = shaking(np.zeros(2), None, 0.01, 0)
    (result,) = run_cases(np.array([case_of()]), motion)
    assert (result["outcome"], result["end"]) == (col.RESTED, 0.01)
