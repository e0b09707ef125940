"""Force laws of elements, and how they fail: springs, stops and pads; by closed forms."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from setups import G, block, constant, room, still, threshold

import stayput as sp
from devices import CEILING, FLOOR, LEFT, RIGHT, SLIDE, SLIDE_RATE, axial, held, planar
from stayput.measures import BaseIsolator, GelMats, LBracket, LBracketInBoard, element_rows, hold
from stayput.mechanics.columns import H_SLIDE_RATE
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import no_elements, shaking, trace
from stayput.model.flat_fields import case_columns

BODY = sp.Body(1.0, 0.5, 100.0)
SMOOTH = room(0.0)
K = 40.0  # N/(kg m)


def oscillator(time, x0, zeta):
    """Free damped vibration from x0, at rest."""
    w = math.sqrt(K)
    wd = w * math.sqrt(1.0 - zeta**2)
    return x0 * np.exp(-zeta * w * time) * (np.cos(wd * time) + zeta * w / wd * np.sin(wd * time))


@pytest.mark.parametrize("zeta", [0.0, 0.05, 0.6])
def test_a_bonded_spring_makes_an_oscillator(zeta):
    spring = planar(
        (0.0, 0.0), RIGHT, stiffness=K, damping=2 * zeta * math.sqrt(K), slack_plus=0.0, slack_minus=0.0
    )
    found = held(BODY, SMOOTH, still(5.0), spring, slide=0.05)
    time = 0.01 * np.arange(501)
    assert found.history[:, SLIDE] == pytest.approx(oscillator(time, 0.05, zeta), abs=1e-8)
    assert found.result["end"] == 5.0


def test_a_tie_along_the_slide_is_the_same_both_ways():
    """A strut of any length pulls and pushes; a belt only pulls, so the body runs on to the other side."""
    anchor = (-2.0, 0.25)
    strut = axial((0.0, 0.0), anchor, length=2.0, stiffness=K, slack_minus=0.0)
    time = 0.01 * np.arange(201)
    found = held(BODY, SMOOTH, still(2.0), strut, slide=0.05)
    assert found.history[:, SLIDE] == pytest.approx(oscillator(time, 0.05, 0.0), abs=1e-8)
    belt = axial((0.0, 0.0), anchor, length=2.0, stiffness=K)
    found = held(BODY, SMOOTH, still(2.0), belt, slide=0.05)
    quarter = 0.5 * math.pi / math.sqrt(K)
    after = time > quarter
    free = -0.05 * math.sqrt(K) * (time[after] - quarter)
    assert found.history[after, SLIDE] == pytest.approx(free, abs=1e-8)
    assert found.devices["peak_pull"][0] == pytest.approx(K * 0.05, rel=1e-6)
    assert found.devices["peak_push"][0] == pytest.approx(0.0, abs=1e-7)


def test_slack_is_a_run_without_force():
    """A stop on either side, s away: half a vibration in the spring, and 2s at a constant rate between."""
    s, v = 0.03, 0.4
    stop = planar((0.0, 0.0), RIGHT, stiffness=K, slack_plus=s, slack_minus=s)
    found = held(BODY, SMOOTH, still(3.0), stop, slide_rate=v)
    w = math.sqrt(K)
    period = 4 * s / v + 2 * math.pi / w
    phase = np.mod(0.01 * np.arange(301), period)
    half = phase > period / 2
    phase[half] -= period / 2
    into = phase - s / v
    x = np.where(
        into < 0,
        v * phase,
        np.where(into < math.pi / w, s + v / w * np.sin(w * into), s - v * (into - math.pi / w)),
    )
    assert found.history[:, SLIDE] == pytest.approx(np.where(half, -x, x), abs=2e-8)
    assert found.result["peak_slide"] == pytest.approx(s + v / w, abs=1e-8)
    assert found.devices["peak_pull"][0] == pytest.approx(K * v / w, rel=1e-5)


def test_a_damped_belt_never_pushes():
    """Its damper would push before it is slack; the body leaves with the rate that it has then."""
    c, v = 6.0, 0.5
    belt = axial((0.0, 0.0), (-1.0, 0.25), length=1.0, stiffness=K, damping=c)
    found = held(BODY, SMOOTH, still(1.0, 0.001), belt, slide_rate=v)

    def force(_t, y):
        return K * y[0] + c * y[1]

    force.terminal, force.direction = True, -1
    free = solve_ivp(
        lambda t, y: [y[1], -K * y[0] - c * y[1]],
        (0, 1),
        [0, v],
        events=force,
        max_step=1e-3,
        rtol=1e-12,
        atol=1e-14,
    )
    x, rate = free.y_events[0][0]
    time = 0.001 * np.arange(1001)
    after = time > free.t_events[0][0]
    on = x + rate * (time[after] - free.t_events[0][0])
    assert found.history[after, SLIDE] == pytest.approx(on, abs=1e-8)
    assert found.devices["peak_push"][0] == pytest.approx(0.0, abs=1e-7)
    assert found.forces[0, 0, 0] == 0.0
    assert found.devices["peak_pull"][0] == pytest.approx((K * free.y[0] + c * free.y[1]).max(), rel=1e-3)
    assert found.forces[:, 0, 0].min() >= -1e-7


def test_friction_and_a_spring():
    """Sliding on dry friction against a spring: each half swing is about ∓μg/k; it sticks where kx ≤ μg."""
    mu, x0 = 0.02, 0.05
    spring = planar((0.0, 0.0), RIGHT, stiffness=K, slack_plus=0.0, slack_minus=0.0)
    found = held(BODY, room(mu), still(5.0), spring, slide=x0)
    loss = 2 * mu * G / K
    swings, x = 0, x0
    while abs(x) > mu * G / K:
        x, swings = -math.copysign(abs(x) - loss, x), swings + 1
    assert found.result["residual_slide"] == pytest.approx(x, abs=1e-9)
    rest = [event for event in found.events if event.kind == 8]
    assert rest[-1].time == pytest.approx(swings * math.pi / math.sqrt(K), abs=1e-7)
    assert set(found.history[-100:, SLIDE_RATE]) == {0.0}


def test_shear_of_a_ceiling_piece():
    """The tangential line along a ceiling bears as the normal one of a wall does."""
    spring = planar(
        (0.0, 0.25), CEILING, stiffness=(0.0, K), slack_plus=(np.inf, 0.0), slack_minus=(np.inf, 0.0)
    )
    heavy = sp.Body(4.0, 0.5, 100.0)
    found = held(heavy, SMOOTH, still(2.0), spring, slide=0.05)
    time = 0.01 * np.arange(201)
    assert found.history[:, SLIDE] == pytest.approx(oscillator(time, 0.05, 0.0), abs=1e-8)
    assert found.devices["peak_shear"][0] == pytest.approx(K * 0.05, rel=1e-6)


def test_a_hanging_body_swings_as_the_equations_say():
    """Flight on a tie: two bodies' worth of freedom, integrated independently with finite rotation."""
    body, anchor = sp.Body(0.4, 0.6, 100.0), (0.3, 2.0)
    tie = axial((0.1, 0.3), anchor, length=1.0, stiffness=300.0, damping=1.0)
    inertia = body.inertia_about_cg / body.mass

    def rates(_t, y):
        x, z, tilt, vx, vz, w = y
        px, pz = 0.1 * math.cos(tilt) + 0.3 * math.sin(tilt), 0.3 * math.cos(tilt) - 0.1 * math.sin(tilt)
        dx, dz = x + px - anchor[0], z + pz - anchor[1]
        far = math.hypot(dx, dz)
        rate = (dx * (vx + w * pz) + dz * (vz - w * px)) / far
        pull = max(0.0, 300.0 * (far - 1.0) + rate) if far > 1.0 else 0.0
        fx, fz = -pull * dx / far, -pull * dz / far
        return [vx, vz, w, fx, fz - G, (fx * pz - fz * px) / inertia]

    lift = sp.Motion(0.005, np.zeros(71), z=np.full(71, -2 * G))  # the floor falls away from it
    found = held(body, room(0.5), lift, tie)

    def falling(t, y):
        dx = rates(t, y)
        dx[4] += 2 * G
        return dx

    times = 0.005 * np.arange(71)
    start = [0, 0.3, 0, 0, 0, 0]
    exact = solve_ivp(falling, (0, 0.4), start, t_eval=times, max_step=2e-4, rtol=1e-9, atol=1e-12).y
    assert found.history[:, 0] == pytest.approx(exact[0], abs=1e-7)
    assert found.history[:, 1] == pytest.approx(exact[1], abs=1e-7)
    assert found.history[:, 2] == pytest.approx(exact[2], abs=1e-7)


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
        (0.0, -0.25), FLOOR, stiffness=(0.0, k), slack_plus=(np.inf, gap), slack_minus=(np.inf, gap)
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
        touched += device.peak_shear > 0.0
        # a rocking base moves its middle a little less than its corner
        if np.abs(run.slide).max() < 0.98 * isolator.stroke - 0.02:
            assert device.peak_shear == 0.0
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
