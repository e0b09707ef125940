"""Rocking and slide-rocking about one fulcrum: times, energy and limits."""

import math

import numpy as np
import pytest
from mechanics_runs import G, kinds, modes, steady, traced

import stayput as sp
from stayput.mechanics.columns import H_SLIDE, H_TILT, H_TILT_RATE
from stayput.mechanics.runner import trace

ALPHA = math.atan(0.25)


def test_free_rocking_lands_and_turns_as_the_reference_says():
    run = traced(steady(0.0, 2.0), tilt=ALPHA / 2)
    landings = [e.time for e in run.events if list(sp.EventKind)[int(e.kind)] is sp.EventKind.FLOOR_IMPACT]
    assert landings[:3] == pytest.approx([0.441671, 1.160493, 1.770421], abs=2e-6)


def test_energy_is_conserved_on_a_fulcrum_that_sticks():
    run = traced(steady(0.0, 0.4), tilt=ALPHA / 2)
    tilt, rate = run.history[:, H_TILT], run.history[:, H_TILT_RATE]
    r, inertia = math.hypot(0.2, 0.8), 4.0 / 3.0 * (0.2**2 + 0.8**2)
    energy = 0.5 * inertia * rate**2 + G * r * np.cos(ALPHA - tilt)
    assert energy == pytest.approx(energy[0], rel=1e-10)


def test_a_sustained_slide_rock_follows_its_reference():
    run = traced(steady(0.6 * G, 0.3, dt=0.1), room=sp.Room(sp.Floor(0.3, 0.3)))
    assert np.abs(run.history[1:, H_TILT]) == pytest.approx([0.009270, 0.040824, 0.107112], abs=2e-6)
    assert np.abs(run.history[1:, H_SLIDE]) == pytest.approx([0.006745, 0.023794, 0.040724], abs=2e-6)


def test_shorter_steps_change_nothing_that_is_seen():
    from mechanics_runs import case_of

    motion = steady(0.0, 1.5)
    one, other = (trace(case_of(tilt=0.1), motion, max_step=h) for h in (math.inf, 1e-3))
    assert other.result["steps"] > one.result["steps"]
    assert np.abs(one.history - other.history).max() < 1e-8


def test_the_peak_is_found_between_the_samples():
    run = traced(steady(0.0, 0.4, dt=0.1), tilt=0.1, tilt_rate=0.2)
    fine = traced(steady(0.0, 0.4, dt=1e-4), tilt=0.1, tilt_rate=0.2)
    assert run.result["peak_tilt"] == pytest.approx(fine.history[:, H_TILT].max(), abs=1e-8)
    assert run.result["peak_tilt"] > run.history[:, H_TILT].max()


def test_the_fulcrum_slips_where_friction_is_too_little():
    run = traced(steady(0.0, 0.4), room=sp.Room(sp.Floor(0.05, 0.05)), tilt=ALPHA / 2)
    assert sp.Mode.SLIDE_ROCK in modes(run)
    assert sp.EventKind.FAILED not in kinds(run)
