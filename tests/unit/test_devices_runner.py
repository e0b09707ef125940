"""Python interface of the solver with devices: validation, padding, results."""

import subprocess
import sys

import numpy as np
import pytest

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import (
    check_elements,
    no_elements,
    run_cases,
    run_cases_with_devices,
    shaking,
    trace,
)
from stayput.model.state import State
from stayput.simulation.flat_fields import case_columns

CASE = case_columns(sp.Body(0.4, 1.8, 100.0), sp.Room(), State(), 9.80665)
MOTION = shaking(4.0 * np.sin(0.05 * np.arange(400)), None, 0.01, 0)


def bracket():
    rows = no_elements(1)
    rows["kind"], rows["cos"], rows["sin"] = el.PLANAR, 0.0, -1.0
    rows["u"], rows["v"] = -0.2, 0.9
    rows["stiffness"], rows["slack_plus"], rows["slack_minus"] = 3000.0, 0.0, 0.0
    rows["limit_plus"] = 20.0
    return rows


@pytest.mark.parametrize(
    ("field", "value", "words"),
    [
        ("kind", 7, "kind is 7; it must be 1"),
        ("u", np.nan, "u is nan; it must be finite"),
        ("x", np.inf, "x is inf; it must be finite, or NaN"),
        ("stiffness", -1.0, "stiffness is -1; it must be 0 or more"),
        ("stiffness", np.inf, "stiffness is inf"),
        ("damping", np.nan, "damping is nan"),
        ("slack_plus", -np.inf, "slack_plus is -inf"),
        ("slack_plus", -0.1, r"slack_plus \+ slack_minus is -0.1"),
        ("limit_plus", -2.0, "limit_plus is -2"),
        ("ultimate", np.nan, "ultimate is nan"),
        ("friction", -0.5, "friction is -0.5"),
    ],
)
def test_bad_elements_are_refused(field, value, words):
    rows = bracket()
    rows[field] = value
    with pytest.raises(sp.InputError, match=words):
        trace(CASE[0], MOTION, rows)


def test_combinations_that_the_laws_do_not_cover_are_refused():
    rows = bracket()
    rows["friction"], rows["damping"] = 0.3, 5.0
    with pytest.raises(sp.InputError, match="damping is 5; it must be 0 where the tangent slips"):
        check_elements(rows)
    rows = bracket()
    rows["interaction"], rows["ultimate"] = 1, 0.01
    with pytest.raises(sp.InputError, match=r"ultimate is 0\.01; it must be 0 where pull and shear"):
        check_elements(rows)
    rows = bracket()
    rows["stiffness"], rows["damping"] = 0.0, 1.0
    with pytest.raises(sp.InputError, match="damping is 1; it must be 0 where there is no stiffness"):
        check_elements(rows)


def test_the_papers_law_has_no_elements():
    paper = shaking(MOTION.floor.ax, None, 0.01, 1)
    with pytest.raises(sp.InputError, match="'paper'; measures with force elements need 'coulomb'"):
        trace(CASE[0], paper, bracket())


def test_no_more_elements_than_there_is_room_for_are_taken():
    check_elements(no_elements(el.MAX_ELEMENTS))
    with pytest.raises(sp.InputError, match=f"13 elements; there may be {el.MAX_ELEMENTS} at most"):
        check_elements(no_elements(el.MAX_ELEMENTS + 1))


def test_there_is_a_row_of_elements_for_each_case():
    with pytest.raises(sp.InputError, match="elements for 1 cases; there must be one row for each of 2"):
        run_cases_with_devices(np.repeat(CASE, 2), bracket()[None], MOTION)


def test_rows_of_no_kind_fill_up():
    padded = np.concatenate((no_elements(1), bracket(), no_elements(2)))
    alone = trace(CASE[0], MOTION, bracket())
    found = trace(CASE[0], MOTION, padded)
    assert np.array_equal(found.history, alone.history)
    assert found.devices[1].tobytes() == alone.devices[0].tobytes()
    assert np.isnan(found.devices["failure_time"][[0, 2, 3]]).all()
    assert not found.forces[:, [0, 2, 3]].any()


def test_batches_hold_what_traces_say():
    cases, elements = np.repeat(CASE, 3), np.stack([bracket()] * 3)
    cases["scale"] = 0.5, 1.0, 1.5
    results, devices = run_cases_with_devices(cases, elements, MOTION)
    for n in range(3):
        found = trace(cases[n], MOTION, elements[n])
        assert found.result["outcome"] == results["outcome"][n]
        assert found.result["peak_tilt"] == results["peak_tilt"][n]
        assert found.result["steps"] == results["steps"][n]
        assert found.devices[0].tobytes() == devices[n, 0].tobytes()
        assert np.abs(found.forces[:, 0, 0]).max() <= devices["peak_pull"][n, 0] + devices["peak_push"][n, 0]


def test_without_elements_results_are_those_of_the_solver_without_devices_to_the_bit():
    cases = np.repeat(CASE, 4)
    cases["scale"] = 0.3, 0.8, 1.2, 2.0
    results, _ = run_cases_with_devices(cases, no_elements(2, 4), MOTION)
    assert results.tobytes() == run_cases(cases, MOTION).tobytes()


def test_a_failure_is_an_event():
    weak = bracket()
    weak["limit_plus"] = 0.5
    weak["limit_minus"] = 0.5
    strong = case_columns(sp.Body(0.4, 1.8, 100.0), sp.Room(sp.Floor(0.2, 0.15)), State(), 9.80665)[0]
    found = trace(strong, MOTION, weak)
    failure = next(event for event in found.events if list(sp.EventKind)[int(event.kind)] == "device failure")
    assert failure.time == found.devices["failure_time"][0]


def test_simulate_does_not_load_the_solver_with_devices():
    code = "import sys, stayput as sp; sp.simulate; print('stayput.mechanics.devices.engine' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
