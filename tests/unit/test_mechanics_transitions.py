"""Zeno guard: event thresholds are relaxed while events are nearly simultaneous."""

import numpy as np
from numba import njit

from stayput.mechanics import columns as col
from stayput.mechanics import engine
from stayput.mechanics.devices import columns as el


@njit
def factors(states, works, times):
    s, work = states[0], works[0]
    work.slack_factor, work.crowded_events = 1.0, 0
    s.k, before = 0, -1.0
    found = np.zeros(len(times))
    for n in range(len(times)):
        s.tau = times[n]
        engine.relax_event_thresholds(s, work, 0.01, before)
        before, found[n] = times[n], work.slack_factor
    return found


def run(times):
    return factors(np.zeros(1, col.STATE), np.zeros(1, el.WORK), np.array(times))


def test_thresholds_grow_tenfold_from_the_ninth_simultaneous_event_to_a_limit():
    found = run([1e-10 * n for n in range(40)])
    first = engine.CROWDED_EVENTS + 1
    assert (found[:first] == 1.0).all()
    assert found[first : first + 3].tolist() == [10.0, 100.0, 1000.0]
    assert found.max() == engine.MAX_SLACK_FACTOR


def test_an_event_well_apart_resets_them():
    times = [1e-10 * n for n in range(15)]
    assert run([*times, times[-1] + 1e-6])[-1] == 1.0
