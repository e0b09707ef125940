"""Bodies that elements hold: both kernels agree; rocking on a tie; standing on a wedge."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from setups import STICKING, G, block, constant, room, still, threshold

import stayput as sp
from devices import CEILING, LEFT, TILT, axial, bare, held, planar

SHAKEN = sp.near_fault().component("x").trimmed(0.0, 12.0)
PLACES = {
    "rocks": (block(0.2, 0.8), sp.Room(sp.Floor(0.9, 0.9)), 0.8),
    "slides": (block(0.5, 0.5), sp.Room(sp.Floor(0.3, 0.2)), 1.0),
    "slides and rocks": (block(0.2, 0.6), sp.Room(sp.Floor(0.35, 0.3)), 1.0),
    "hits walls": (
        block(0.2, 0.8),
        sp.Room(sp.Floor(0.4, 0.3), left_wall=sp.Wall(0.01), right_wall=sp.Wall(0.2)),
        1.0,
    ),
    "rests": (block(0.4, 0.4), sp.Room(sp.Floor(0.9, 0.9)), 0.3),
}


@pytest.mark.parametrize("name", PLACES)
def test_elements_that_bear_next_to_nothing_change_next_to_nothing(name):
    """A spring of 10⁻¹² N/(kg m) keeps the second kernel at work to the end."""
    body, place, scale = PLACES[name]
    motion = SHAKEN.scaled(scale)
    weak = planar((0.0, 0.0), LEFT, stiffness=(1e-12, 1e-12), slack_plus=(0.0, 0.0), slack_minus=(0.0, 0.0))
    one, other = bare(body, place, motion), held(body, place, motion, weak)
    for name in ("outcome", "floor_impacts", "wall_impacts"):
        assert other.result[name] == one.result[name]
    assert [event.kind for event in other.events] == [event.kind for event in one.events]
    times = [event.time for event in one.events]
    assert [event.time for event in other.events] == pytest.approx(times, abs=1e-6)
    assert other.history[:, 2:6] == pytest.approx(one.history[:, 2:6], abs=1e-5)
    assert other.result["peak_tilt"] == pytest.approx(one.result["peak_tilt"], abs=1e-7)
    assert other.result["peak_slide"] == pytest.approx(one.result["peak_slide"], abs=1e-7)


@pytest.mark.parametrize("name", PLACES)
def test_without_elements_the_first_kernel_does_the_work(name):
    body, place, scale = PLACES[name]
    motion = SHAKEN.scaled(scale)
    one, other = bare(body, place, motion), held(body, place, motion)
    assert np.array_equal(one.history, other.history)


@pytest.mark.parametrize("name", PLACES)
def test_tighter_settings_give_the_same_run(name):
    body, place, scale = PLACES[name]
    motion = SHAKEN.scaled(scale)
    b, h = -body.corners[0][0], -body.corners[0][1]
    belt = axial((-b, h), (-b - 0.3, 2 * h), length=0.3, stiffness=1500.0, damping=5.0, slack_plus=0.01)
    pole = planar(
        (0.0, h),
        CEILING,
        stiffness=(2000.0, 800.0),
        slack_plus=(np.inf, 0.0),
        slack_minus=(-0.05 * G / 2000.0, 0.0),
        friction=0.4,
    )
    coarse = held(body, place, motion, belt, pole, tolerance=1e-7)
    fine = held(body, place, motion, belt, pole, tolerance=1e-11, max_step=motion.dt / 4)
    assert coarse.result["outcome"] == fine.result["outcome"]
    assert coarse.result["peak_tilt"] == pytest.approx(fine.result["peak_tilt"], abs=2e-5)
    assert coarse.result["peak_slide"] == pytest.approx(fine.result["peak_slide"], abs=2e-5)
    for force in ("peak_pull", "peak_push", "peak_shear"):
        assert coarse.devices[force] == pytest.approx(fine.devices[force], rel=2e-3, abs=1e-3)


STICKING_ROOM = sp.Room(STICKING)


def about_right_corner(b, h, tie_at, anchor, k, c, slack, a):
    """Rates of (θ, θ̇) of a block of half sizes b and h on B, tied from a point (from G) to an anchor."""
    inertia = 4.0 / 3.0 * (b * b + h * h)

    def rates(_t, y):
        theta, omega = y
        sin, cos = math.sin(theta), math.cos(theta)
        x, z = b - b * cos + h * sin, b * sin + h * cos  # G: B stands at (b, 0)
        u, v = tie_at
        px, pz = x + u * cos + v * sin, z + v * cos - u * sin
        dx, dz = px - anchor[0], pz - anchor[1]
        far = math.hypot(dx, dz)
        wx, wz = omega * pz, -omega * (px - b)
        rate = (dx * wx + dz * wz) / far
        stretch = far - abs(tie_at[0] - anchor[0]) - slack
        pull = max(0.0, k * stretch + c * rate) if stretch > 0.0 else 0.0
        fx, fz = -pull * dx / far, -pull * dz / far
        moment = -(x - b) * -G + z * -a + fx * pz - fz * (px - b)
        return [omega, moment / inertia]

    return rates


@pytest.mark.parametrize(("slack", "c"), [(0.0, 0.0), (0.02, 0.0), (0.01, 1.0)])
def test_a_tied_block_follows_the_equations(slack, c):
    """A belt from the top back edge to the wall, 0.3 m behind; the block is thrown forward."""
    b, h, k = 0.2, 0.8, 60.0
    point, anchor = (-b, h), (-b - 0.3, 2 * h)
    belt = axial(point, anchor, length=0.3, stiffness=k, damping=c, slack_plus=slack)
    motion = still(0.6, 0.002)
    found = held(block(b, h), STICKING_ROOM, motion, belt, tilt_rate=1.2)
    rates = about_right_corner(b, h, point, anchor, k, c, slack, 0.0)

    def landing(_t, y):
        return y[0]

    landing.terminal, landing.direction = True, -1
    exact = solve_ivp(
        rates, (0, 0.6), [0.0, 1.2], events=landing, max_step=1e-3, rtol=1e-10, atol=1e-13, dense_output=True
    )
    end = exact.t_events[0][0]
    impacts = [event.time for event in found.events if event.kind == 3]
    assert impacts[0] == pytest.approx(end, abs=2e-7)
    time = 0.002 * np.arange(len(found.history))
    before = time < end
    assert found.history[before, TILT] == pytest.approx(exact.sol(time[before])[0], abs=2e-7)


def test_without_a_tie_the_same_block_overturns():
    assert held(block(0.2, 0.8), STICKING_ROOM, still(3.0), tilt_rate=1.2).result["outcome"] == 4


@pytest.mark.parametrize("z", [1.6, 1.2])
def test_static_force_of_a_tie(z):
    """F = m (a h − g b)/z of a block of half sizes b and h under a steady acceleration, in small tilts."""
    b, h, a = 0.2, 0.8, 0.6 * G
    k = 3e5
    tie = planar((-b, z - h), LEFT, stiffness=k, damping=2 * math.sqrt(k), slack_plus=0.0)
    found = held(block(b, h), STICKING_ROOM, constant(-a, 3.0), tie)
    assert found.forces[-1, 0, 0] == pytest.approx((a * h - G * b) / z, rel=1e-4)
    assert found.result["residual_tilt"] == pytest.approx((a * h - G * b) / z / (k * z), rel=1e-3)
    # below the threshold it bears nothing, and the body rests
    quiet = held(block(b, h), STICKING_ROOM, constant(-0.24 * G, 3.0), tie)
    assert quiet.result["outcome"] == 0
    assert quiet.devices["peak_pull"][0] == 0.0


def test_convergence():
    """The error of a run falls with the tolerance."""
    b, h = 0.2, 0.8
    belt = axial((-b, h), (-b - 0.3, 2 * h), length=0.3, stiffness=600.0, slack_plus=0.01)
    tilts = [
        held(block(b, h), STICKING_ROOM, still(0.3, 0.05), belt, tilt_rate=1.2, tolerance=tolerance).history[
            -1, TILT
        ]
        for tolerance in (1e-5, 1e-7, 1e-9, 1e-13)
    ]
    errors = np.abs(np.array(tilts[:-1]) - tilts[-1])
    assert errors[0] < 1e-3
    assert errors[1] < 1e-5
    assert errors[2] < 1e-7


BOTH = [pytest.param(bare, id="bare"), pytest.param(held, id="with elements")]


@pytest.mark.parametrize("run", BOTH)
def test_a_wedge_tilts_the_body_back_and_turns_its_limits(run):
    """With a wedge w under the front edge: tan θ₀ = −w/b; tipping at (b_f/h_G) of the tilted body."""
    b, h, w = 0.4, 1.8, 0.012
    body, place = sp.Body(b, h, 100.0, base_heights=(0.0, -w)), sp.Room(STICKING)
    assert body.resting_tilt == pytest.approx(-math.atan(w / b), rel=1e-12)
    quiet = run(body, place, still(1.0))
    assert quiet.result["outcome"] == 0
    assert set(quiet.history[:, 2]) == {0.0}

    sin, cos = math.sin(body.resting_tilt), math.cos(body.resting_tilt)
    for corner, way in ((1, -1.0), (0, 1.0)):
        u, v = body.corners[corner]
        across, up = u * cos + v * sin, v * cos - u * sin
        limit = threshold(
            lambda a, way=way: run(body, place, constant(way * a, 0.05)).result["peak_tilt"] > 0.0,
            0.05 * G,
            0.6 * G,
            halvings=30,
        )
        assert limit == pytest.approx(abs(across / up) * G, rel=1e-8)
    flat = b / h
    assert abs(body.corners[1][0] * cos + body.corners[1][1] * sin) / (h / 2) > flat  # forward it is safer


@pytest.mark.parametrize("run", BOTH)
@pytest.mark.parametrize(("left", "right"), [(0.3, 0.8), (0.8, 0.3), (0.1, 0.2)])
def test_each_base_corner_has_its_own_friction(run, left, right):
    """Flat, each corner bears what the moment about G gives it, and slips with its own coefficient."""
    b, h = 2.0, 0.6
    floor = sp.Floor(
        left_edge_static_friction=left,
        left_edge_kinetic_friction=left,
        right_edge_static_friction=right,
        right_edge_kinetic_friction=right,
    )
    for d in (1.0, -1.0):
        # N_A + N_B = 1; moment about G: b/2 (N_A − N_B) + d h/2 (μ_A N_A + μ_B N_B) = 0
        matrix = [[1.0, 1.0], [b / 2 + d * h / 2 * left, -b / 2 + d * h / 2 * right]]
        loads = np.linalg.solve(matrix, [1.0, 0.0])
        mu = loads @ [left, right]
        found = run(sp.Body(b, h, 100.0), sp.Room(floor), still(2.0, 0.002), slide_rate=d)
        assert d * found.result["peak_slide"] * d == pytest.approx(1.0 / (2 * mu * G), rel=1e-9)
        # it starts to slide at the same load, in the direction that the load pushes it
        limit = threshold(
            lambda a, d=d, floor=floor: (
                run(sp.Body(b, h, 100.0), sp.Room(floor), constant(-d * a, 0.05)).result["peak_slide"] > 0.0
            ),
            0.01 * G,
            0.9 * G,
            halvings=25,
        )
        assert limit == pytest.approx(mu * G, rel=1e-6)


@pytest.mark.parametrize("run", BOTH)
def test_a_corner_alone_keeps_its_friction(run):
    """A body that rocks on its rubber edge sticks; on the bare one it slips."""
    body = sp.Body(0.4, 1.6, 100.0)
    rubber = sp.Floor(0.05, 0.05, right_edge_static_friction=1.0, right_edge_kinetic_friction=1.0)
    sticks = run(body, sp.Room(rubber), still(0.2), tilt=0.1)
    slips = run(body, sp.Room(rubber), still(0.2), tilt=-0.1)
    assert sticks.result["peak_slide"] == 0.0
    assert slips.result["peak_slide"] > 1e-3


def test_own_frictions_equal_to_the_floors_change_nothing():
    motion = sp.sine(amplitude=0.5 * G, frequency=1.0, duration=5.0)
    own = {
        f"{side}_edge_{kind}_friction": value
        for side in ("left", "right")
        for kind, value in (("static", 0.4), ("kinetic", 0.3))
    }
    plain = bare(sp.Body(0.5, 1.0, 100.0), room(0.4, 0.3), motion)
    same = bare(sp.Body(0.5, 1.0, 100.0), room(0.4, 0.3, **own), motion)
    assert np.array_equal(plain.history, same.history)
