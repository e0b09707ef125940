"""Tension poles: preload in the static limits of sliding and tipping, friction at the ceiling, drop-out."""

import math

import numpy as np
import pytest
from setups import G, block, constant, room, still, threshold

import stayput as sp
from devices import CEILING, SLIDE, SLIDE_RATE, held, planar
from stayput.measures import TensionPole
from stayput.mechanics.devices import columns as el

K = 2000.0


def pole(point, preload, *, mu=0.4, shear=500.0, **fields):
    return planar(
        point,
        CEILING,
        stiffness=(K, shear),
        slack_plus=(np.inf, 0.0),
        slack_minus=(-preload / K, 0.0),
        friction=mu,
        **fields,
    )


def ramp(to, seconds):
    """Load that grows slowly to a value."""
    return sp.Motion(0.01, np.linspace(0.0, to, round(100 * seconds) + 1))


def test_preload_adds_to_the_friction_of_the_floor():
    """The floor bears g + P; sliding starts at μ(g + P), and the ceiling adds μ_c P once its shoe slips."""
    body, mu, P = sp.Body(1.0, 0.5, 100.0), 0.3, 4.0
    found = held(body, room(mu), ramp(8.0, 80.0), pole((0.0, 0.25), P), tolerance=1e-9)
    starts = next(event.time for event in found.events if event.kind == 0)
    assert 0.1 * starts == pytest.approx(mu * (G + P), rel=1e-6)
    away = found.history[:, SLIDE]
    runs = 0.1 * 0.01 * np.argmax(np.abs(away) > 0.004)  # the shoe's spring gives 3.2 mm
    assert runs == pytest.approx(mu * (G + P) + 0.4 * P, rel=0.01)
    assert found.devices["failure"][0] == el.HOLDS


@pytest.mark.parametrize("place", [-0.15, 0.0, 0.15])
def test_preload_adds_to_the_weight_against_tipping(place):
    """a h = g b + P (b + c) for a pole c behind G and a load that tips the block forward."""
    b, h, P = 0.2, 0.8, 3.0
    found = held(block(b, h), room(3.0), ramp(-8.0, 40.0), pole((place, h), P, mu=0.0))
    starts = next(event.time for event in found.events if event.kind == 2)
    assert 0.2 * starts == pytest.approx((G * b + P * (b - place)) / h, rel=1e-6)


def test_a_pole_drops_out_when_the_top_moves_away():
    """A body that tips away under the pole's foot lowers it: the push is lost at once where it is shallow."""
    b, h, P = 0.2, 0.8, 0.5
    body = block(b, h)
    found = held(body, room(3.0), still(0.3, 0.001), pole((b, h), P, mu=0.0, drops_out=1), tilt_rate=0.6)
    device = found.devices[0]
    assert device["failure"] == el.DROPPED_OUT
    # the corner over the fulcrum sinks by 2h (1 − cos θ)
    tilt = math.acos(1.0 - P / K / (2.0 * h))
    k = int(device["failure_time"] / 0.001)
    assert found.history[k, 2] <= tilt <= found.history[k + 1, 2]
    assert set(found.forces[k + 1 :, 0, 0]) == {0.0}


def test_the_ceiling_gives_way_at_its_strength():
    b, h = 0.2, 0.8
    weak = pole((-b, h), 0.5, mu=0.0, limit_minus=6.0)
    found = held(block(b, h), room(3.0), still(0.5), weak, tilt_rate=1.5)
    assert found.devices["failure"][0] == el.PUSHED
    assert found.devices["peak_push"][0] == pytest.approx(6.0, rel=1e-6)
    strong = pole((-b, h), 0.5, mu=0.0)
    assert held(block(b, h), room(3.0), still(0.5), strong, tilt_rate=1.5).devices["failure"][0] == el.HOLDS


def test_a_strong_pole_holds_what_would_overturn():
    b, h = 0.2, 0.8
    shaken = sp.sine(amplitude=0.6 * G, frequency=1.0, duration=4.0)
    alone = held(block(b, h), room(3.0), shaken)
    assert alone.result["outcome"] == 4
    found = held(block(b, h), room(3.0), shaken, pole((-b, h), 3.0), pole((b, h), 3.0), tolerance=1e-8)
    assert found.result["outcome"] == 2
    assert found.result["peak_tilt"] < 0.02


def test_the_shoe_of_a_pole_slips_by_friction():
    """On a smooth floor the ceiling's friction alone stops the body: v²/(2 μ P), beside the shoe's spring."""
    P, mu, v, shear = 5.0, 0.3, 0.7, 4000.0
    found = held(
        sp.Body(4.0, 0.5, 100.0),
        room(0.0),
        still(2.0),
        pole((0.0, 0.25), P, mu=mu, shear=shear),
        slide_rate=v,
    )
    limit = mu * P
    farthest = (0.5 * v * v - 0.5 * limit**2 / shear) / limit + limit / shear
    assert found.result["peak_slide"] == pytest.approx(farthest, rel=1e-6)
    assert found.devices["peak_shear"][0] == pytest.approx(limit, rel=1e-6)


def test_a_pole_is_lost_where_its_head_has_walked_by_the_width_of_its_pad():
    """½v² = ½S²/k + S w + ½v₁²: on a smooth floor the body slides on at v₁ from there, S = μ P."""
    P, mu, v, shear, pad = 5.0, 0.3, 0.7, 4000.0, 0.05
    head = pole((0.0, 0.25), P, mu=mu, shear=shear, ultimate=(0.0, pad))
    found = held(sp.Body(4.0, 0.5, 100.0), room(0.0), still(0.3, 0.001), head, slide_rate=v)
    limit, device = mu * P, found.devices[0]
    assert device["failure"] == el.DROPPED_OUT
    rate = math.sqrt(v * v - limit**2 / shear - 2.0 * limit * pad)
    assert found.history[-1, SLIDE_RATE] == pytest.approx(rate, rel=1e-6)
    # friction alone from S/k on: the time to slip by w at −S
    start = math.sqrt(v * v - limit**2 / shear)
    stuck = math.asin(limit / shear * math.sqrt(shear) / v) / math.sqrt(shear)
    assert device["failure_time"] == pytest.approx(stuck + (start - rate) / limit, rel=1e-6)
    wider = pole((0.0, 0.25), P, mu=mu, shear=shear, ultimate=(0.0, 1.01 * 0.5 * v * v / limit))
    again = held(sp.Body(4.0, 0.5, 100.0), room(0.0), still(1.0), wider, slide_rate=v)
    assert again.devices["failure"][0] == el.HOLDS


def walked(motion, P, mu, shear, pad, dt=2e-6):
    """When a body on a smooth floor under a pole loses it, and its slide there, by its own law and steps.

    The head walks to and fro: only how far it is from where it was counts.
    """
    x = v = slip = path = 0.0
    times = np.arange(0.0, motion.duration, dt)
    for t, a in zip(times.tolist(), np.interp(times, motion.time, motion.x).tolist(), strict=True):
        if abs(slip) >= pad:
            return t, x, path
        pull = shear * (x - slip)
        if abs(pull) > mu * P:
            kept = math.copysign(mu * P, pull)
            path += abs(pull - kept) / shear
            slip += (pull - kept) / shear
            pull = kept
        v += dt * (-a - pull)
        x += dt * v
    raise AssertionError("It is not lost.")


def test_a_pole_that_walks_to_and_fro_is_lost_by_where_it_is():
    P, mu, shear, pad = 5.0, 0.3, 2000.0, 0.06
    t = np.arange(0.0, 4.0, 0.005)
    motion = sp.Motion(0.005, (1.0 + 1.5 * t) * np.sin(2.0 * math.pi * 1.5 * t))
    head = pole((0.0, 0.25), P, mu=mu, shear=shear, ultimate=(0.0, pad))
    found = held(sp.Body(4.0, 0.5, 100.0), room(0.0), motion, head)
    time, _, path = walked(motion, P, mu, shear, pad)
    assert path > 1.5 * pad
    assert found.devices["failure"][0] == el.DROPPED_OUT
    assert found.devices["failure_time"][0] == pytest.approx(time, abs=2e-4)


def test_a_preload_beyond_the_weight_lifts_a_body():
    """Turned round, a preload that pulls up with more than g takes the body off the floor, with less not."""
    for pull, flies in ((0.9 * G, False), (1.1 * G, True)):
        lift = planar((0.0, 0.0), CEILING, stiffness=K, slack_minus=np.inf, slack_plus=0.0)
        lift["cos"], lift["slack_minus"][:, 0], lift["slack_plus"][:, 0] = 1.0, -pull / K, np.inf
        found = held(sp.Body(1.0, 0.5, 100.0), room(0.4), constant(0.0, 0.5), lift)
        assert (found.result["outcome"] == 2) == flies
        if flies:
            assert found.history[:, 1].max() == pytest.approx(0.25 + 2 * (pull - G) / K, rel=1e-5)


def test_the_limit_of_a_pole_is_sharp():
    """The load at which a preloaded block starts to rock, found from outside."""
    b, h, P = 0.2, 0.8, 3.0

    def moves(a):
        found = held(block(b, h), room(3.0), constant(-a, 0.1), pole((0.0, h), P, mu=0.0))
        return found.result["peak_tilt"] > 0.0

    limit = threshold(moves, 0.2 * G, 0.5 * G, halvings=30)
    assert limit == pytest.approx((G + P) * b / h, rel=1e-7)


def stepped_under_a_pole(b, h, rate, P, limit, mu, shear, end, dt=1e-6):
    """Tilt and largest shear of a block that lifts a pole's foot, by its own law and small steps.

    It turns about the corner away from the pole and sticks there. The push grows with the foot's rise until
    the ceiling yields; the foot's spring slips where it pulls by more than μ times the push.
    """
    inertia, alpha, r = 4.0 / 3.0 * (b * b + h * h), math.atan(b / h), math.hypot(b, h)
    theta, omega, dent, slip, largest = 0.0, rate, 0.0, 0.0, 0.0
    for _ in range(round(end / dt)):
        x = -2.0 * b * math.cos(theta) + 2.0 * h * math.sin(theta)
        z = 2.0 * h * math.cos(theta) + 2.0 * b * math.sin(theta)
        push = P + K * (z - 2.0 * h - dent)
        if push > limit:
            dent += (push - limit) / K
            push = limit
        push = max(0.0, push)
        pull = shear * (x + 2.0 * b - slip)
        if abs(pull) > mu * push:
            kept = math.copysign(mu * push, pull)
            slip += (pull - kept) / shear
            pull = kept
        largest = max(largest, abs(pull))
        moment = -z * pull + x * push - G * r * math.sin(alpha - theta)
        omega += dt * moment / inertia
        theta += dt * omega
    return theta, largest


def test_a_pole_rubs_while_the_ceiling_yields():
    """The foot slips at μ times the push that the ceiling bears, which does not change while it gives way."""
    b, h, P, limit, mu, shear, end = 0.2, 0.8, 2.0, 5.0, 0.4, 3000.0, 0.12
    foot = pole((-b, h), P, mu=mu, shear=shear, limit_minus=limit, ultimate=1.0)
    found = held(block(b, h), room(3.0), still(end, 0.001), foot, tilt_rate=0.5, tolerance=1e-10)
    theta, largest = stepped_under_a_pole(b, h, 0.5, P, limit, mu, shear, end)
    assert found.history[-1, 2] == pytest.approx(theta, rel=1e-4)
    assert found.devices["peak_shear"][0] == pytest.approx(largest, rel=1e-6)
    assert largest == pytest.approx(mu * limit, rel=1e-9)
    yields = found.forces[:, 0, 0] == -limit
    assert np.count_nonzero(yields) > 10
    assert np.abs(found.forces[yields, 0, 1]) == pytest.approx(mu * limit, rel=1e-9)


def test_the_poles_of_a_bookcase_rub_as_documented():
    """Where the ceiling bears 1000 N and yields, the feet rub with 0.4 × 1000 N under a built-in motion."""
    body = sp.Body(0.30, 1.80, 200.0)
    place = sp.Room(sp.Floor.of("wood flooring"), left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
    held_by = TensionPole(stiffness=40e3, strength=500.0, pad=0.5)  # so wide that it does not lean
    seen = 0
    for scale in (0.6, 0.8, 1.0, 1.2):
        run = sp.simulate(body, place, sp.near_fault().component("x").scaled(scale), [held_by])
        (device,) = run.devices
        assert device.peak_push <= 1000.0 * (1 + 1e-9)
        assert device.peak_shear <= 400.0 * (1 + 1e-5)
        yields = device.pull <= -1000.0 * (1 - 1e-12)
        seen += np.count_nonzero(yields)
        assert np.all(np.abs(device.shear[yields]) > 0.0)
    assert seen > 3
