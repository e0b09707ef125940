"""What happens within one step of a record: as by other integrators, and whatever the step is."""

import math

import numpy as np
import pytest
from equations import Rocking
from setups import G, block, events, room, simulate
from time_stepping import time_stepping

import stayput as sp


def finer(motion: sp.Motion, parts: int = 8) -> sp.Motion:
    """The same piecewise linear record on a finer grid."""
    n = len(motion.x)
    at = np.arange((n - 1) * parts + 1) / parts
    x, z = (None if v is None else np.interp(at, np.arange(n), v) for v in (motion.x, motion.z))
    return sp.Motion(motion.dt / parts, x, z=z)


def flush(normal: float = 0.3) -> sp.Room:
    return room(3.0, left_wall=sp.Wall(0.0, normal, 0.0))


def test_a_slow_landing_goes_on_rocking_where_the_load_hardly_resists():
    """The load rises past (b/h)g as the body lands: what little rate is left to it is what tips it."""
    body, dt = block(0.2, 0.8), 0.02
    along = -G * 0.25 * np.linspace(0.995, 1.03, 21)
    for rate in (1e-3, 2e-3):  # rad/s: the other corner opens at 0.4 and 0.8 mm/s
        run = simulate(body, room(3.0), sp.Motion(dt, along), tilt=-1e-7, tilt_rate=rate)
        times = np.arange(len(along)) * dt
        exact = Rocking(body, lambda t: float(np.interp(t, times, along)), lambda _: 0.0, times[1:])
        states = exact.run(-1e-7, rate, -1)
        assert run.tilt[-1] == pytest.approx(states[0][-1], rel=1e-4)


def test_a_body_between_smooth_flush_walls_is_held_up_by_the_ceiling():
    """It only moves up and down: whichever wall the load presses it to, and its mirror image."""
    t = np.arange(0.0, 2.0, 0.005)
    smooth = sp.Wall(0.0, 0.0, 0.0)
    place = sp.Room(sp.Floor(0.0, 0.0), smooth, smooth, sp.Ceiling(1.62, 0.0, 0.0))
    up = 15.0 * np.sin(4.0 * np.pi * t)
    hits = []
    for side in (1.0, -1.0):
        motion = sp.Motion(0.005, side * 0.5 * np.sin(2.0 * np.pi * t), z=up)
        run = sp.simulate(sp.Body(1.0, 1.6), place, motion)
        assert run.outcome != "failed"
        assert np.abs(run.tilt).max() == 0.0 == np.abs(run.slide).max()
        hits.append([e.time for e in events(run, sp.EventKind.CEILING_IMPACT)])
    assert len(hits[0]) == 4 and hits[0] == pytest.approx(hits[1], abs=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_a_flush_wall_is_not_hit_by_the_corner_that_lands_beside_it(seed):
    """Its gap b(1 − cos θ) is never negative; rounding must not close it at any step of the record."""
    rng = np.random.default_rng(seed)
    motion = sp.Motion(0.02, 4.0 * np.sin(np.cumsum(rng.uniform(0.0, 0.5, 600))))
    left = sp.simulate(sp.Body(0.4, 1.6), flush(), motion)
    right = sp.simulate(sp.Body(0.4, 1.6), flush(), finer(motion, 3))
    hits = [len(events(run, sp.EventKind.WALL_IMPACT)) for run in (left, right)]
    assert len(events(left, sp.EventKind.FLOOR_IMPACT)) > 10
    assert hits[0] == hits[1]


def test_the_peak_of_an_excursion_that_turns_in_the_step_it_began_in():
    """From rest at the start of a step, uplift and return before its end: the peak lies in between."""
    body = block(0.2, 0.8)
    for dt, along in ((0.02, [-3.0, 6.0, 0.0, 0.0]), (0.05, [-2.8, 4.0, 0.0, 0.0])):
        motion = sp.Motion(dt, np.array(along))
        coarse, fine = (sp.simulate(body, room(3.0), m).peak_tilt for m in (motion, finer(motion, 200)))
        assert 0.0 < fine < 4e-4
        assert coarse == pytest.approx(fine, rel=1e-4)


def test_a_leaning_slip_that_stops_within_a_step_ends_there():
    """A ladder whose slip stops, and is carried on the other way or not at all, whatever the step."""
    body = sp.Body(0.3, 1.8)
    gap = 0.25
    place = room(0.3, 0.25, right_wall=sp.Wall(gap, 0.0, 0.2))
    found = 0
    for push in np.linspace(2.0, 9.0, 15):
        x = np.zeros(26)
        x[2::4], x[4::4] = push, -push
        motion = sp.Motion(0.04, x)
        start = sp.State(tilt=0.12, tilt_rate=0.9)
        one, other = (sp.simulate(body, place, m, initial=start) for m in (motion, finer(motion)))
        found += (one.mode == "lean").any()
        stepped = time_stepping(body, place, motion.x, motion.dt, initial=start, step=2e-5)
        if abs(stepped.slide[-1] - other.slide[-1]) < 1e-3 and other.outcome != "overturned":
            assert one.slide[-1] == pytest.approx(other.slide[-1], abs=1e-4), (push, math.degrees(push))
    assert found
