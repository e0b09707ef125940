"""Flight: a body off the floor falls freely in the floor's frame, and bounces by Newton's restitution.

Closed forms (Galilei): z̈ = −(g + z̈_G) integrated exactly over a piecewise linear record, bounces of e_n² in
height and e_n in time.
"""

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from setups import G, block, events, extrema, first, impacts, room, simulate, turned

import stayput as sp


def shaken_up(samples: list[float], dt: float, quiet: int) -> sp.Motion:
    up = np.concatenate((samples, np.zeros(quiet)))
    return sp.Motion(dt, np.zeros(len(up)), z=up)


def risen(motion: sp.Motion, time: float, start: float) -> tuple[float, float]:
    """Height and rate at a time of a point left behind by the floor at ``start``: exact for the record."""
    height = rate = 0.0
    for k in range(len(motion) - 1):
        t0, t1 = max(start, k * motion.dt), min(time, (k + 1) * motion.dt)
        if t1 <= t0:
            continue
        slope = (motion.z[k + 1] - motion.z[k]) / motion.dt
        a = -(G + motion.z[k] + slope * (t0 - k * motion.dt))
        t = t1 - t0
        height += rate * t + a * t * t / 2 - slope * t**3 / 6
        rate += a * t - slope * t * t / 2
    return height, rate


MOTION = shaken_up([0.0, -20.0, -20.0, 0.0], 0.05, 60)


@pytest.mark.parametrize("body", [block(0.2, 0.8), sp.Body(0.5, 0.5, 100.0, cg_offset=(0.1, 0.1))])
def test_a_floor_that_drops_leaves_the_body_behind(body):
    run = simulate(body, room(0.4), MOTION)
    leaves = first(run, sp.EventKind.LIFT_OFF)
    assert leaves.time == pytest.approx(0.05 * G / 20.0, abs=1e-12)
    landing = brentq(lambda t: risen(MOTION, t, leaves.time)[0], 0.15, 2.0, xtol=1e-14)
    assert impacts(run)[0].time == pytest.approx(landing, abs=1e-11)
    flying = run.mode == sp.Mode.FLIGHT
    heights = [risen(MOTION, t, leaves.time)[0] for t in run.time[flying]]
    assert run.place[0, flying, 2] - run.place[0, 0, 2] == pytest.approx(heights, abs=1e-13)
    assert set(run.tilt[flying]) == {0.0}


def test_the_papers_rules_know_no_vertical_motion():
    assert simulate(block(0.2, 0.8), room(0.4), MOTION, "paper").outcome is sp.Outcome.RESTED


@pytest.mark.parametrize("e_n", [0.3, 0.5, 0.8])
def test_bounces(e_n):
    motion = shaken_up([0.0, -20.0, -20.0, 0.0], 0.05, 80)
    fine = np.linspace(0.0, motion.duration, 20 * (len(motion) - 1) + 1)
    motion = sp.Motion(0.0025, np.zeros(len(fine)), z=np.interp(fine, motion.time, motion.z))
    run = simulate(block(0.2, 0.8), room(0.4, normal_restitution=e_n), motion)
    leaves, landings = first(run, sp.EventKind.LIFT_OFF).time, [e.time for e in impacts(run)]
    rate = -risen(motion, landings[0], leaves)[1]
    flights = np.diff(landings)[:4]
    assert len(flights) == 4
    assert flights == pytest.approx([2 * rate * e_n ** (n + 1) / G for n in range(4)], abs=2e-11)
    peaks = np.array(extrema(run.time, run.place[0, :, 2] - 0.8))[1:3]
    assert peaks == pytest.approx([(rate * e_n ** (n + 1)) ** 2 / (2 * G) for n in range(2)], rel=1e-6)


def test_bounces_die_out():
    """Infinitely many bounces in a finite time: v/g·2e/(1−e), and then it rests for good."""
    e_n = 0.5
    run = simulate(block(0.2, 0.8), room(0.4, normal_restitution=e_n), MOTION)
    leaves, landing = first(run, sp.EventKind.LIFT_OFF).time, impacts(run)[0].time
    rate = -risen(MOTION, landing, leaves)[1]
    rest = events(run, sp.EventKind.REST) or [e for e in run.events if e.mode is sp.Mode.REST]
    # the bounces lower than 1e-9 of the base, which is 0.4 m long, are left out: 2√(2h/g)/(1−e)
    missing = 2 * math.sqrt(2 * 0.4e-9 / G) / (1 - e_n)
    assert rest[-1].time == pytest.approx(landing + 2 * rate / G * e_n / (1 - e_n), abs=missing)
    assert run.mode[-1] == sp.Mode.REST
    assert run.residual_slide == 0.0


def test_a_tilted_body_turns_on_in_flight():
    """The rotation rate keeps its value in the air, and G falls freely; it lands on a corner."""
    body, tilt, rate = block(0.2, 0.8), 0.1, -0.5
    motion = shaken_up([-30.0, -30.0, -30.0, 0.0], 0.05, 60)
    run = simulate(body, room(0.4), motion, tilt=tilt, tilt_rate=rate)
    flying = run.mode == sp.Mode.FLIGHT
    flying[np.argmin(flying) :] = False  # the first flight
    assert flying.sum() >= 4
    n = int(flying.sum())
    assert run.tilt[:n] == pytest.approx(tilt + rate * run.time[:n], abs=1e-13)
    corner = turned(body.corners[1], tilt)
    # G turns about the corner B at the start
    start = np.array([-corner[1] * rate, corner[0] * rate])
    assert run.place[0, :n, 0] - run.place[0, 0, 0] == pytest.approx(start[0] * run.time[:n], abs=1e-13)
    heights = [risen(motion, t, 0.0)[0] + start[1] * t for t in run.time[:n]]
    assert run.place[0, :n, 2] - run.place[0, 0, 2] == pytest.approx(heights, abs=1e-12)
