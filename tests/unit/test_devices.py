"""The solver with devices: what is refused, batches and traces, failures, friction under a shifted load."""

import math

import numpy as np
import pytest
from mechanics_runs import case_of, kinds, plate, steady, tie

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import check_elements, no_elements, shaking, trace

CASE = case_of(sp.Body(0.4, 1.8, 100.0), sp.Room())
MOTION = shaking(4.0 * np.sin(0.05 * np.arange(400)), None, 0.01, 0)
FLAT = sp.Body(1.0, 0.5, 100.0)


def bracket(**fields):
    rows = no_elements(1)
    rows["kind"], rows["cos"], rows["sin"] = el.PLANAR, 0.0, -1.0
    rows["u"], rows["v"] = -0.2, 0.9
    rows["stiffness"], rows["slack_plus"], rows["slack_minus"] = 3000.0, 0.0, 0.0
    rows["limit_plus"] = 20.0
    for name, value in fields.items():
        rows[name] = value
    return rows


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"kind": 7}, "kind is 7; it must be 1"),
        ({"u": np.nan}, "u is nan; it must be finite"),
        ({"x": np.inf}, "x is inf; it must be finite, or NaN"),
        ({"stiffness": -1.0}, "stiffness is -1; it must be 0 or more"),
        ({"stiffness": np.inf}, "stiffness is inf"),
        ({"damping": np.nan}, "damping is nan"),
        ({"slack_plus": -np.inf}, "slack_plus is -inf"),
        ({"slack_plus": -0.1}, r"slack_plus \+ slack_minus is -0.1"),
        ({"limit_plus": -2.0}, "limit_plus is -2"),
        ({"ultimate": np.nan}, "ultimate is nan"),
        ({"friction": -0.5}, "friction is -0.5"),
        # combinations that the laws do not cover
        ({"friction": 0.3, "damping": 5.0}, "damping is 5; it must be 0 where the tangent slips"),
        ({"interaction": 1, "ultimate": 0.01}, r"ultimate is 0\.01; it must be 0 where pull and shear"),
        ({"stiffness": 0.0, "damping": 1.0}, "damping is 1; it must be 0 where there is no stiffness"),
    ],
)
def test_bad_elements_are_refused(fields, words):
    with pytest.raises(sp.InputError, match=words):
        trace(CASE, MOTION, bracket(**fields))


def test_what_the_solver_with_devices_does_not_take():
    paper = shaking(MOTION.floor.ax, None, 0.01, 1)
    with pytest.raises(sp.InputError, match="'paper'; it must be 'coulomb' with measures of force elements"):
        trace(CASE, paper, bracket())
    check_elements(no_elements(el.MAX_ELEMENTS))
    with pytest.raises(sp.InputError, match=f"13 force elements; it must have at most {el.MAX_ELEMENTS}"):
        check_elements(no_elements(el.MAX_ELEMENTS + 1))


def test_rows_of_no_kind_fill_up():
    padded = np.concatenate((no_elements(1), bracket(), no_elements(2)))
    alone, found = (trace(CASE, MOTION, rows) for rows in (bracket(), padded))
    assert np.array_equal(found.history, alone.history)
    assert found.devices[1].tobytes() == alone.devices[0].tobytes()
    assert np.isnan(found.devices["failure_time"][[0, 2, 3]]).all()
    assert not found.forces[:, [0, 2, 3]].any()


def test_internal_events_are_counted_but_not_listed():
    rows = tie((0.0, 0.8), (-0.5, 1.6), slack_plus=np.array([[0.001, np.inf]]))
    run = trace(case_of(), shaking(3.5 * np.sin(0.1 * np.arange(600)), None, 0.01, 0), rows)
    assert run.result["events"] > len(run.events)
    assert sp.EventKind.FAILED not in kinds(run)


def test_after_the_last_failure_the_solver_without_devices_takes_over():
    rows = tie((0.0, 0.8), (-0.5, 1.6), limit_plus=1.0)
    found = trace(case_of(), steady(-3.5, 1.0), rows)
    assert found.devices["failure"][0] == el.PULLED
    (failure,) = (
        event for event, kind in zip(found.events, kinds(found), strict=True) if kind == "device failure"
    )
    assert failure.time == found.devices["failure_time"][0]
    assert not found.forces[math.ceil(failure.time / 0.01) :].any()


def test_the_peak_force_is_found_between_the_samples():
    """A body slides into a spring and turns back: the peak is v √(k/m), between two coarse samples."""
    rows = plate((0.0, 0.0))
    rows["stiffness"][:, 0] = 0.0
    rows["slack_plus"][:, 0] = rows["slack_minus"][:, 0] = np.inf
    rows["stiffness"][:, 1] = 5.0
    smooth = sp.Room(sp.Floor(0.0, 0.0))
    found = trace(case_of(FLAT, smooth, slide_rate=0.1), steady(0.0, 1.2, dt=0.1), rows)
    assert found.devices["peak_shear"][0] == pytest.approx(0.1 * math.sqrt(5.0), rel=1e-5)
    assert np.abs(found.forces[:, 0, 1]).max() < found.devices["peak_shear"][0]
