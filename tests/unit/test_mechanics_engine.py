"""Event loop and its interface: initial states, the clock, batches, and runs that cannot be finished."""

import numpy as np
import pytest
from mechanics_runs import case_of, kinds, modes, steady, traced
from numba import njit

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics import engine, records
from stayput.mechanics.devices import columns as el
from stayput.mechanics.flat import BLOCK
from stayput.mechanics.runner import extremes, run_cases, shaking, trace

RECORD = 4.0 * np.sin(0.06 * np.arange(500))


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


@pytest.mark.parametrize("law", [0, 1])
def test_a_batch_gives_the_bits_of_each_case_alone_and_of_its_history(law):
    motion = shaking(RECORD, 0.3 * RECORD, 0.01, law)
    assert motion.floor.az.any() == (law == 0)  # the paper's rules have no vertical motion
    cases = np.array([case_of(tilt=tilt) for tilt in (0.0, 0.02, -0.1)])
    results = run_cases(cases, motion)
    for n in range(3):
        assert results[n].tobytes() == run_cases(cases[n : n + 1], motion)[0].tobytes()
        run = trace(cases[n], motion)
        assert run.result.tobytes() == results[n].tobytes()
        assert len(run.events) == results["events"][n]


@pytest.mark.parametrize("n", [2, BLOCK, BLOCK + 1, BLOCK + 2, 5 * BLOCK + 3])
def test_extremes_cover_the_segments_of_each_block(n):
    values = np.random.default_rng(n).normal(size=n)
    low, high = extremes(values)
    for block in range(len(low)):
        part = values[block * BLOCK : (block + 1) * BLOCK + 1]  # segments share their ends
        assert (low[block], high[block]) == (part.min(), part.max())
    assert (len(low) - 1) * BLOCK < n - 1 <= len(low) * BLOCK


@njit
def clock(states, dt, steps):
    s = states[0]
    s.k, s.tau = 0, 0.0
    return [records.advance_clock(s, h, dt) for h in steps], s.k, s.tau


def test_the_clock_reaches_a_sample_in_spite_of_rounding():
    reached, k, tau = clock(np.zeros(1, col.STATE), 0.3, np.array([0.1, 0.1, 0.1, 0.3, 0.2]))
    assert reached == [False, False, True, True, False]
    assert (k, tau) == (2, 0.2)


@njit
def slack_factors(states, works, times):
    s, work = states[0], works[0]
    work.slack_factor, work.crowded_events = 1.0, 0
    s.k, before = 0, -1.0
    found = np.zeros(len(times))
    for n in range(len(times)):
        s.tau = times[n]
        engine.relax_event_thresholds(s, work, 0.01, before)
        before, found[n] = times[n], work.slack_factor
    return found


def test_thresholds_grow_while_events_are_nearly_simultaneous():
    times = np.append(1e-10 * np.arange(40), 1e-6)
    found = slack_factors(np.zeros(1, col.STATE), np.zeros(1, el.WORK), times)
    first = engine.CROWDED_EVENTS + 1
    assert (found[:first] == 1.0).all()
    assert found[first : first + 3].tolist() == [10.0, 100.0, 1000.0]
    assert found.max() == engine.MAX_SLACK_FACTOR
    assert found[-1] == 1.0
