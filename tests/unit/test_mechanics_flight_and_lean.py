"""Flight as a free fall; lean as sliding on floor and wall at once."""

import math

import numpy as np
import pytest
from mechanics_runs import G, kinds, modes, steady, traced

import stayput as sp
from stayput.mechanics.columns import H_TILT, H_X, H_Z


def test_a_body_in_flight_falls_freely_and_turns_steadily():
    run = traced(steady(2.0, 0.2, up=-2.0 * G), slide_rate=0.3)
    assert modes(run)[-1] is sp.Mode.FLIGHT
    time = 0.01 * np.arange(len(run.history))
    assert run.history[:, H_Z] == pytest.approx(0.8 + 0.5 * G * time**2, abs=1e-9)
    assert run.history[:, H_X] == pytest.approx(0.3 * time - time**2, abs=1e-8)
    assert run.history[:, H_TILT] == pytest.approx(0.0, abs=1e-8)


def test_a_flight_ends_where_a_corner_reaches_the_ceiling():
    room = sp.Room(sp.Floor(0.5, 0.5), ceiling=sp.Ceiling(1.7))
    run = traced(steady(0.0, 0.3, up=-2.0 * G), room=room)
    hit = next(e for e in run.events if list(sp.EventKind)[int(e.kind)] is sp.EventKind.CEILING_IMPACT)
    assert hit.time == pytest.approx(math.sqrt(2.0 * 0.1 / G), abs=1e-8)


def test_a_frictionless_body_slides_down_a_wall_as_a_ladder_does():
    """Floor and wall without friction: energy is conserved while both corners slide."""
    room = sp.Room(sp.Floor(0.0, 0.0), right_wall=sp.Wall(0.4, 0.0, 0.0))
    body = sp.Body(0.1, 2.0, 100.0)
    start = math.asin((0.4) / 2.0)  # about the tilt at which the top meets the wall
    run = traced(steady(0.0, 1.5), body=body, room=room, tilt=0.9 * start, tilt_rate=0.2)
    assert sp.EventKind.WALL_IMPACT in kinds(run)
    assert sp.Mode.LEAN in modes(run)
    assert sp.EventKind.FAILED not in kinds(run)


def test_a_body_leans_at_rest_where_friction_holds_it():
    room = sp.Room(sp.Floor(0.8, 0.8), right_wall=sp.Wall(0.2, 0.0, 0.8))
    run = traced(steady(0.0, 3.0), body=sp.Body(0.1, 2.0, 100.0), room=room, tilt=0.09)
    assert list(sp.Outcome)[run.result["outcome"]] is sp.Outcome.LEANING
    assert modes(run)[-1] is sp.Mode.LEAN
    assert np.ptp(run.history[-50:, H_TILT]) == 0.0
