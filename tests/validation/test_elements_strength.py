"""Failure of devices: brittle, ductile, pads by pull and shear, stops; by closed forms."""

import math

import numpy as np
import pytest
from setups import G, block, constant, room, still, threshold

import stayput as sp
from devices import FLOOR, LEFT, RIGHT, SLIDE, held, planar
from stayput.measures import BaseIsolator, GelMats, LBracket, LBracketInBoard, element_rows, hold
from stayput.mechanics.columns import H_SLIDE_RATE
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import no_elements, shaking, trace
from stayput.simulation.flat_fields import case_columns

SMOOTH = room(0.0)
BODY = sp.Body(1.0, 0.5, 100.0)
K = 40.0


def test_a_brittle_spring_breaks_when_its_force_is_there():
    """x = v/ω sin ωt breaks at kx = S; the body runs on at the rate it has then."""
    v, strength = 0.4, 2.0
    w = math.sqrt(K)
    spring = planar((0.0, 0.0), LEFT, stiffness=K, slack_plus=0.0, slack_minus=0.0, limit_plus=strength)
    found = held(BODY, SMOOTH, still(1.0), spring, slide_rate=v)
    device = found.devices[0]
    time = math.asin(strength / K * w / v) / w
    assert device["failure"] == el.PULLED
    assert device["failure_time"] == pytest.approx(time, abs=1e-9)
    assert device["peak_pull"] == pytest.approx(strength, rel=1e-7)
    left = v * math.cos(w * time)
    assert found.result["residual_slide"] == pytest.approx(strength / K + left * (1.0 - time), abs=1e-8)
    assert [event.kind for event in found.events] == [11]
    # one that is a little stronger than the largest force holds
    spring["limit_plus"][:, 0] = K * v / w * 1.0001
    assert held(BODY, SMOOTH, still(1.0), spring, slide_rate=v).devices["failure"][0] == el.HOLDS


def test_a_ductile_spring_takes_energy_with_its_plastic_part():
    """½v² = ½S²/k + S p; unloading is elastic, and what has come back is ½S²/k."""
    v, strength = 0.8, 2.0
    plastic = (0.5 * v * v - 0.5 * strength**2 / K) / strength
    spring = planar(
        (0.0, 0.0), LEFT, stiffness=K, slack_plus=0.0, slack_minus=0.0, limit_plus=strength, ultimate=1.0
    )
    found = held(BODY, SMOOTH, still(1.5, 0.001), spring, slide_rate=v)
    device = found.devices[0]
    assert device["failure"] == el.HOLDS
    assert device["plastic"][0] == pytest.approx(plastic, rel=1e-6)
    assert found.result["peak_slide"] == pytest.approx(plastic + strength / K, rel=1e-6)
    back = found.history[:, 5].min()
    assert back == pytest.approx(-strength / math.sqrt(K), rel=1e-4)
    # it parts where the plastic elongation is used up, with the energy that is left
    spring["ultimate"][:, 0] = used = 0.5 * plastic
    found = held(BODY, SMOOTH, still(0.55, 0.001), spring, slide_rate=v)
    assert found.devices["failure"][0] == el.DRAWN_OUT
    rate = math.sqrt(v * v - strength**2 / K - 2 * strength * used)
    assert found.history[-1, 5] == pytest.approx(rate, rel=1e-6)


def pads(body, shear, pull, **fields):
    """Gel pads under both base corners, bonded where the body stands."""
    return [
        planar(
            corner,
            FLOOR,
            stiffness=(2e4, 5e3),
            slack_plus=(0.0, 0.0),
            slack_minus=(np.inf, 0.0),
            limit_plus=(pull, shear),
            limit_minus=(np.inf, shear),
            **fields,
        )
        for corner in body.corners[:2]
    ]


def test_pads_hold_a_static_load_to_their_shear_strength():
    """A low body under a slowly growing load: floor friction and both pads together, then all is lost."""
    body, mu, shear = sp.Body(1.0, 0.4, 100.0), 0.2, 0.6
    gentle = sp.Motion(0.01, np.linspace(0.0, 6.0, 6001))

    def failure(scale):
        found = held(body, room(mu), gentle.scaled(scale), *pads(body, shear, 50.0), tolerance=1e-9)
        return found.devices

    strength = mu * G + 2 * shear
    slow = failure(1.0)
    assert slow["failure"].tolist() == [el.SHEARED, el.SHEARED]
    assert slow["failure_time"] == pytest.approx(10.0 * strength, rel=0.02)
    assert failure(0.97 * strength / 6.0)["failure"].tolist() == [el.HOLDS, el.HOLDS]


def test_a_pad_holds_a_tall_body_to_its_pull_strength():
    """Uplift starts at g b/h; the heel pad adds m a h = m g b + 2 b P: the static limit of tipping."""
    b, h, pull = 0.2, 0.8, 2.0
    body = block(b, h)

    def falls(a):
        ramp = sp.Motion(0.01, np.concatenate((np.linspace(0.0, a, 800), np.full(700, a))))
        found = held(body, room(3.0), ramp, *pads(body, 50.0, pull, damping=(150.0, 0.0)), tolerance=1e-8)
        return found.result["outcome"] == 4

    limit = threshold(falls, 0.3 * G, 1.0 * G, halvings=10)
    assert limit == pytest.approx((G * b + 2 * b * pull) / h, rel=0.01)


def test_pull_and_shear_act_together():
    """On the ellipse (N/S)² + (T/S')² = 1 a spring that is pulled along a slope breaks."""
    v = 1.0
    k = (30.0, 50.0)
    strength = (1.0, 1.5)
    slope = 0.3
    both = planar(
        (0.0, 0.0),
        (math.sin(slope), math.cos(slope)),
        stiffness=k,
        slack_plus=(0.0, 0.0),
        slack_minus=(0.0, 0.0),
        limit_plus=strength,
        limit_minus=strength,
        interaction=1,
    )
    found = held(BODY, SMOOTH, still(1.0), both, slide_rate=-v)
    # along a plane at 90° − slope the point moves by x cos(slope) off it and x sin(slope) along it
    off, along = math.cos(slope), math.sin(slope)
    stiffness = k[0] * off**2 + k[1] * along**2
    x = 1.0 / math.hypot(k[0] * off / strength[0], k[1] * along / strength[1])
    w = math.sqrt(stiffness)
    assert found.devices["failure_time"][0] == pytest.approx(math.asin(x * w / v) / w, abs=1e-8)


@pytest.mark.parametrize("gap", [0.05, 0.2])
def test_an_isolator_stops_at_the_end_of_its_stroke(gap):
    """Low friction to the stroke, then a stiff stop that sends the body back with what it has."""
    mu, v, k = 0.01, 0.8, 2e3
    stop = planar(
        (0.0, -0.25),
        FLOOR,
        stiffness=(0.0, k),
        slack_plus=(np.inf, gap),
        slack_minus=(np.inf, gap),
    )
    found = held(sp.Body(4.0, 0.5, 100.0), room(mu), still(1.0, 0.001), stop, slide_rate=v)
    rate = math.sqrt(v * v - 2 * mu * G * gap)
    deepest = (-mu * G + math.hypot(mu * G, rate * math.sqrt(k))) / k
    assert found.result["peak_slide"] == pytest.approx(gap + deepest, rel=1e-6)
    assert found.devices["peak_shear"][0] == pytest.approx(k * deepest, rel=1e-4)
    back = math.sqrt(rate**2 - 4 * mu * G * deepest)
    assert -found.history[:, 5].min() == pytest.approx(back, abs=0.02)


def test_devices_at_rest_bear_nothing_and_break_by_preload_alone():
    strong = planar((0.0, 0.0), RIGHT, stiffness=K, slack_plus=-0.01, limit_plus=1.0)
    found = held(BODY, room(0.4), constant(0.3 * G, 1.0), strong)
    assert found.result["outcome"] == 0
    assert found.devices["failure"][0] == el.HOLDS
    assert found.forces[:, 0, 0] == pytest.approx(0.4)
    weak = planar((0.0, 0.0), RIGHT, stiffness=K, slack_plus=-0.01, limit_plus=0.3)
    found = held(BODY, room(0.4), constant(0.3 * G, 1.0), weak)
    assert found.devices["failure_time"][0] == 0.0
    assert found.history[-1, SLIDE] == 0.0


def furniture(rng):
    return sp.Body(rng.uniform(0.3, 0.8), rng.uniform(0.6, 1.8), rng.uniform(30.0, 300.0))


def shaken(rng):
    return sp.near_fault().component("x").trimmed(0.0, 15.0).scaled(rng.uniform(0.3, 1.3))


def test_a_stop_that_is_never_touched_bears_nothing():
    """Also where an impact turns the body round: the force is noted with the branch of after it."""
    rng = np.random.default_rng(3)
    touched = 0
    for _ in range(25):
        isolator = BaseIsolator(stroke=rng.uniform(0.05, 0.3))
        run = sp.simulate(furniture(rng), sp.Room(), shaken(rng), [isolator])
        (device,) = run.devices
        # a rocking base moves its middle a little less than its corner
        for peak, far in ((device.peak_pull, run.slide.max()), (device.peak_push, -run.slide.min())):
            touched += peak > 0.0
            if far < 0.98 * isolator.stroke - 0.02:
                assert peak == 0.0
    assert touched > 5


@pytest.mark.parametrize("kind", [GelMats, LBracket, LBracketInBoard])
def test_no_peak_is_beyond_the_strength(kind):
    """A damper's force jumps with the rates in an impact; what a device bears is its strength at most."""
    rng = np.random.default_rng(4)
    measure = kind()
    used = 0.0
    for _ in range(25):
        body = furniture(rng)
        place = sp.Room(left_wall=sp.Wall(rng.uniform(0.0, 0.03)))
        run = sp.simulate(body, place, shaken(rng), [measure])
        for row, device in zip(element_rows(hold(body, place, [measure])), run.devices, strict=True):
            pull, shear = body.mass * row["limit_plus"]
            assert device.peak_pull <= pull * (1 + 1e-9)
            assert device.peak_shear <= shear * (1 + 1e-9)
            used = max(used, device.peak_pull / pull, device.peak_shear / shear)
    assert used > 0.8


@pytest.mark.parametrize("dt", [5e-4, 2e-3, 6e-3])
def test_a_tie_yields_when_it_reaches_its_strength_while_the_base_shares_its_friction(dt):
    """An edge that rubs less than the base: a corner carries just nothing, a margin that rests at zero."""
    body = sp.Body(1.025, 1.878, 17.66, (0.069, 0.684))
    floor = sp.Floor(0.58, 0.58, edge_static_friction=0.34, edge_kinetic_friction=0.25)
    case = case_columns(body, sp.Room(floor), sp.State(slide_rate=-1.5), 9.80665)[0]
    tie = no_elements(1)
    tie["kind"], tie["u"], tie["v"] = el.AXIAL, -0.52, 0.147
    tie["x"], tie["z"] = -0.444, 1.194
    point = body.cg_offset[0] - 0.52, body.height / 2 + body.cg_offset[1] + 0.147
    tie["length"], tie["slack_plus"] = math.dist(point, (-0.444, 1.194)), 0.0
    tie["stiffness"][0, 0], tie["limit_plus"][0, 0], tie["ultimate"][0, 0] = 914e3, 1.23, 0.0486
    floor_at_rest = shaking(np.zeros(4), None, dt, 0)
    usual, fine = (trace(case, floor_at_rest, tie, max_step=step) for step in (np.inf, dt / 200))
    assert usual.forces[:, 0, 0].max() == pytest.approx(1.23, rel=1e-3)
    assert usual.history[:, H_SLIDE_RATE] == pytest.approx(fine.history[:, H_SLIDE_RATE], abs=2e-5)
