"""Event loop with devices: internal events, failures, and taking over from the solver without devices."""

import math

import numpy as np
from mechanics_runs import case_of, kinds, plate, steady, tie

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import no_elements, run_cases_with_devices, shaking, trace


def test_internal_events_are_counted_but_not_listed():
    rows = tie((0.0, 0.8), (-0.5, 1.6), slack_plus=np.array([[0.001, np.inf]]))
    motion = shaking(3.5 * np.sin(0.1 * np.arange(600)), None, 0.01, 0)
    results, _ = run_cases_with_devices(np.array([case_of()]), rows[None], motion)
    run = trace(case_of(), motion, rows)
    assert results["events"][0] > len(run.events)
    assert sp.EventKind.FAILED not in kinds(run)


def test_after_the_last_failure_the_solver_without_devices_takes_over():
    rows = tie((0.0, 0.8), (-0.5, 1.6), limit_plus=1.0)
    found = trace(case_of(), steady(-3.5, 1.0), rows)
    assert found.devices["failure"][0] == el.PULLED
    assert kinds(found).count(sp.EventKind.DEVICE_FAILURE) == 1
    assert not found.forces[math.ceil(found.devices["failure_time"][0] / 0.01) :].any()


def test_without_elements_the_bits_are_those_of_the_solver_without_devices():
    motion = steady(-3.0, 1.0)
    one, other = trace(case_of(), motion), trace(case_of(), motion, no_elements(2))
    assert one.history.tobytes() == other.history.tobytes()


def test_an_impact_is_before_the_branches_of_its_rates():
    """A damper's force jumps in a landing; no device bears more than its strength."""
    rows = plate((0.0, -0.8), damping=100.0, limit_plus=2.0, limit_minus=2.0)
    found = trace(case_of(tilt=0.1), steady(0.0, 1.0), rows)
    assert found.devices["peak_pull"][0] <= 2.0 * (1 + 1e-12)
    assert found.devices["peak_shear"][0] <= 2.0 * (1 + 1e-12)
