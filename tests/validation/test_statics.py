"""Statics: what holds a body that does not move.

C. H. West's formula, a = (b/h)g (J. Milne, 1885, Seismic experiments, Trans. Seism. Soc. Japan 8), Coulomb's
a = μg, and the same by the balance of moments for an eccentric centre of gravity, a wedge and a wall.
"""

import math

import numpy as np
import pytest
from setups import STICKING, G, both_laws, constant, room, simulate, still, turned

import stayput as sp

NEAR = 1e-9
ON_STICKING = sp.Room(STICKING)
BODIES = {
    "slender": sp.Body(0.4, 1.6, 100.0),
    "squat": sp.Body(1.0, 0.7, 100.0),
    "eccentric": sp.Body(0.4, 1.6, 100.0, cg_offset=(0.07, -0.2)),
    "top-heavy": sp.Body(0.4, 1.6, 100.0, cg_offset=(-0.05, 0.1), inertia=40.0),
    "front wedge": sp.Body(0.4, 1.6, 100.0, base_heights=(0.0, -0.005)),
    "eccentric on feet": sp.Body(0.4, 1.6, 100.0, cg_offset=(0.05, -0.1), base_heights=(-0.02, -0.04)),
}


def rocking_limits(body: sp.Body) -> tuple[float, float]:
    """Floor accelerations/g at which the weight and the inertia force point through the corners B and A."""
    ratios = []
    for corner in (1, 0):
        across, up = turned(body.corners[corner], body.resting_tilt)
        ratios.append(across / up)
    return ratios[0], ratios[1]


@both_laws
@pytest.mark.parametrize("name", BODIES)
def test_rocking_starts_where_the_resultant_leaves_the_base(law, name):
    body = BODIES[name]
    low, high = rocking_limits(body)
    assert low < 0 < high
    for limit in (low, high):
        holds = simulate(body, ON_STICKING, constant(limit * G * (1 - NEAR), 5.0), law)
        assert holds.outcome is sp.Outcome.RESTED
        assert not holds.events
        assert (np.ptp(holds.slide), holds.peak_slide) == (0.0, pytest.approx(0.0, abs=1e-15))
        assert set(holds.tilt) == {0.0}
        rocks = simulate(body, ON_STICKING, constant(limit * G * (1 + NEAR), 1.0), law)
        assert rocks.mode[-1] == sp.Mode.ROCK
        assert (rocks.tilt[-1] < 0.0) == (limit > 0)


def test_west():
    low, high = rocking_limits(sp.Body(0.4, 1.6, 100.0))
    assert (low, high) == pytest.approx((-0.25, 0.25), rel=1e-14)
    low, high = rocking_limits(BODIES["eccentric"])
    assert (low, high) == pytest.approx((-(0.2 - 0.07) / 0.6, (0.2 + 0.07) / 0.6), rel=1e-14)


@both_laws
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("name", BODIES)
def test_sliding_starts_at_mu_g(law, side, name):
    body, mu = BODIES[name], 0.12
    assert mu < min(map(abs, rocking_limits(body)))
    place = room(mu, 0.1)
    holds = simulate(body, place, constant(side * mu * G * (1 - NEAR), 5.0), law)
    assert holds.outcome is sp.Outcome.RESTED
    assert (np.ptp(holds.slide), holds.peak_slide) == (0.0, pytest.approx(0.0, abs=1e-15))
    slides = simulate(body, place, constant(side * mu * G * (1 + NEAR), 1.0), law)
    assert slides.outcome is sp.Outcome.SLID
    assert slides.residual_slide == pytest.approx(-side * (mu - 0.1) * G / 2, rel=1e-5)


@pytest.mark.parametrize("up", [-5.0, 5.0])
def test_vertical_acceleration_scales_both_limits(up):
    body = sp.Body(0.4, 1.6, 100.0)
    for place, limit, rocks in ((ON_STICKING, 0.25, True), (room(0.2), 0.2, False)):
        a = limit * (G + up)
        assert simulate(body, place, constant(a * (1 - NEAR), 1.0, up=up)).outcome is sp.Outcome.RESTED
        run = simulate(body, place, constant(a * (1 + NEAR), 1.0, up=up))
        assert (run.peak_tilt > 0.0, run.peak_slide > 0.0) == (rocks, not rocks)


@both_laws
@pytest.mark.parametrize(
    ("heights", "tilt"), [((0.0, -0.005), -0.005 / 0.4), ((-0.01, 0.0), 0.01 / 0.4), ((-0.02, -0.02), 0.0)]
)
def test_wedge_tilts_the_body_at_rest(law, heights, tilt):
    """A wedge under the right edge: the body leans back by the wedge over the width."""
    body = sp.Body(0.4, 1.6, 100.0, base_heights=heights)
    run = simulate(body, ON_STICKING, still(10.0), law)
    assert run.outcome is sp.Outcome.RESTED
    assert body.resting_tilt == pytest.approx(math.atan(tilt), abs=1e-15)
    assert (run.residual_tilt, run.peak_tilt) == (0.0, 0.0)  # told from rest
    assert run.residual_slide == pytest.approx(0.0, abs=1e-15)
    feet = [turned(body.corners[corner], math.atan(tilt))[1] for corner in (0, 1)]
    assert feet == pytest.approx([-run.place[0, -1, 2]] * 2, abs=1e-15)


@both_laws
def test_a_flush_wall_holds_what_is_pressed_on_it(law):
    place = sp.Room(STICKING, left_wall=sp.Wall(0.0, friction=0.0))
    for a in (0.26, 1.0, 3.0):
        run = simulate(sp.Body(0.4, 1.6, 100.0), place, constant(a * G, 5.0), law)
        assert run.outcome is sp.Outcome.RESTED
        assert (run.peak_tilt, run.peak_slide) == (0.0, 0.0)


@both_laws
def test_a_flush_wall_does_not_hold_what_is_pulled_away(law):
    place = sp.Room(STICKING, left_wall=sp.Wall(0.0, friction=0.0))
    holds = simulate(sp.Body(0.4, 1.6, 100.0), place, constant(-0.25 * G * (1 - NEAR), 1.0), law)
    assert holds.outcome is sp.Outcome.RESTED
    rocks = simulate(sp.Body(0.4, 1.6, 100.0), place, constant(-0.25 * G * (1 + NEAR), 1.5), law)
    assert rocks.mode[-1] == sp.Mode.ROCK
    free = simulate(sp.Body(0.4, 1.6, 100.0), ON_STICKING, constant(-0.25 * G * (1 + NEAR), 1.5), law)
    assert rocks.tilt == pytest.approx(free.tilt, rel=1e-3)
    slippery = sp.Room(sp.Floor(0.2, 0.2), left_wall=sp.Wall(0.0, friction=0.0))
    slides = simulate(sp.Body(0.4, 1.6, 100.0), slippery, constant(-0.2 * G * (1 + NEAR), 1.0), law)
    assert slides.outcome is sp.Outcome.SLID


def test_a_flush_wall_is_left_in_one_event():
    place = sp.Room(STICKING, left_wall=sp.Wall(0.0, friction=0.0))
    run = simulate(sp.Body(0.4, 1.6, 100.0), place, constant(-0.25 * G * (1 + 1e-6), 0.1))
    assert len(run.events) <= 1
    assert run.mode[-1] == sp.Mode.ROCK


@pytest.mark.parametrize("friction", [0.0, 0.2, 1.0])
def test_a_rough_flush_wall_does_not_hold_by_self_stress(friction):
    """Nothing presses the wall as the body tips away from it: it moves as if there were none."""
    motion = sp.Motion(0.01, [10.0, 8.5])
    body, floor = sp.Body(0.09, 0.15, 100.0), sp.Floor(0.994, 0.994)
    free = simulate(body, sp.Room(floor), motion)
    flush = simulate(body, sp.Room(floor, right_wall=sp.Wall(0.0, friction=friction)), motion)
    assert len(flush.events) == len(free.events)
    assert flush.peak_tilt == pytest.approx(free.peak_tilt, rel=1e-9)
    beside = sp.Room(sp.Floor(0.4, 0.3), left_wall=sp.Wall(0.0, friction=friction))
    assert (
        simulate(sp.Body(0.4, 1.6, 100.0), beside, constant(-0.26 * G, 1.0)).outcome is not sp.Outcome.RESTED
    )


def test_a_base_slides_where_its_edge_cannot_keep_it_tipped():
    """Flat friction .5 above b/h = 1/7, edge friction .14 below: it slides with b/h, and does not chatter."""
    run = simulate(sp.Body(0.1, 0.7, 100.0), sp.Room(sp.Floor(0.5, 0.5, 0.14, 0.14)), constant(-0.3 * G, 0.5))
    assert run.outcome is sp.Outcome.SLID
    assert len(run.events) == 0
    assert run.slide_rate[-1] == pytest.approx((0.3 - 1 / 7) * G * 0.5, rel=1e-6)


def test_a_sliding_body_that_jams_tips_over_its_leading_corner():
    """No force can keep a light-ended body sliding on much friction (Painlevé): the leading corner stops."""
    body = sp.Body(0.4, 0.8, 76.88, inertia=1.0669)
    for side in (1.0, -1.0):
        run = simulate(body, room(1.17), constant(0.0, 0.3), slide_rate=0.7 * side)
        assert run.outcome is sp.Outcome.ROCKED
        assert side * run.tilt[5] > 0.01


@both_laws
def test_a_body_thrown_at_a_flush_wall_bounces_off(law):
    place = sp.Room(sp.Floor(0.0, 0.0), right_wall=sp.Wall(0.0, restitution=0.5, friction=0.0))
    run = simulate(sp.Body(0.4, 0.4, 100.0), place, constant(0.0, 0.2), law, slide_rate=1.0)
    assert run.events[0].time == 0.0
    assert run.wall_impacts == 1
    assert run.slide_rate[-1] == pytest.approx(-0.5)


def test_a_body_is_held_against_the_ceiling_or_a_wall():
    """Where the floor falls faster than g, what is flush with the ceiling stays there by its friction."""
    down = sp.Motion(0.01, np.zeros(50), z=np.full(50, -12.0))
    under = sp.Room(sp.Floor(0.5, 0.5), ceiling=sp.Ceiling(1.0, friction=0.5))
    assert simulate(sp.Body(0.5, 1.0, 100.0), under, down).outcome is sp.Outcome.RESTED
    aside = sp.Motion(0.01, np.full(50, -30.0), z=np.full(50, -12.0))
    beside = sp.Room(sp.Floor(0.5, 0.5), right_wall=sp.Wall(0.0, friction=0.5))
    assert simulate(sp.Body(0.5, 1.0, 100.0), beside, aside).outcome is sp.Outcome.RESTED


@both_laws
def test_rest_is_exact_under_shaking_just_below_the_limits(law):
    """Not a micrometre of creep in ten minutes of noise."""
    rng = np.random.default_rng(5)
    noise = rng.uniform(-1, 1, 60_001) * 0.2499 * G
    run = simulate(sp.Body(0.4, 1.6, 100.0), room(0.25), sp.Motion(0.01, noise), law)
    assert run.outcome is sp.Outcome.RESTED
    assert (run.peak_tilt, run.peak_slide) == (0.0, 0.0)


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_body_leaves_a_floor_that_falls_faster_than_it_does(friction):
    """Where z̈ = −20 t m/s³, that is from t = g/20 on; friction plays no part."""
    time = np.arange(101) * 0.01
    fall = sp.Motion(0.01, np.zeros(101), z=-20.0 * time)
    floor = sp.Floor(friction, friction)
    run = simulate(sp.Body(0.4, 1.0, 100.0), sp.Room(floor), fall)
    assert run.events[0].kind is sp.EventKind.LIFT_OFF
    assert run.events[0].time == pytest.approx(G / 20.0, abs=NEAR)
    under = sp.Room(floor, ceiling=sp.Ceiling(1.0, friction=0.5))
    run = simulate(sp.Body(0.4, 1.0, 100.0), under, fall)
    assert run.outcome is not sp.Outcome.FAILED
    assert len(run.events) < 5
    assert np.abs(run.place[0, :, 2] - 0.5).max() < NEAR
