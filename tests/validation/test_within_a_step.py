"""What happens within one step of a record: as by other integrators, and whatever the step is."""

import numpy as np
import pytest
from equations import Rocking
from setups import G, block, events, room, simulate

import stayput as sp


def finer(motion: sp.Motion, parts: int = 8) -> sp.Motion:
    """The same piecewise linear record on a finer grid."""
    n = len(motion.x)
    at = np.arange((n - 1) * parts + 1) / parts
    x, z = (None if v is None else np.interp(at, np.arange(n), v) for v in (motion.x, motion.z))
    return sp.Motion(motion.dt / parts, x, z=z)


def beside_a_wall(seed: int) -> tuple[sp.Body, sp.Room, sp.Motion]:
    """A body that a wall touches, or nearly, for 0.8 s on a floor that shakes along and up."""
    rng = np.random.default_rng(seed)
    U = rng.uniform
    body, mu = sp.Body(U(0.2, 0.6), U(0.8, 2.0), 100.0), U(0.2, 0.7)
    floor = sp.Floor(mu, mu * U(0.6, 1.0))
    wall = sp.Wall(U(0.0, 0.002) * (rng.random() < 0.6), 0.0 if rng.random() < 0.5 else 0.3, U(0.0, 0.5))
    along, up = U(1.0, 8.0) * rng.standard_normal(41), 3.0 * rng.standard_normal(41)
    return body, sp.Room(floor, right_wall=wall), sp.Motion(0.02, along, z=up)


def results(body: sp.Body, place: sp.Room, motion: sp.Motion) -> tuple[object, ...]:
    """Outcome, hits on the wall, peak tilt and residual slide."""
    run = sp.simulate(body, place, motion)
    return run.outcome, len(events(run, sp.EventKind.WALL_IMPACT)), run.peak_tilt, run.residual_slide


def same(one: tuple[object, ...], other: tuple[object, ...]) -> bool:
    return one[:2] == other[:2] and np.allclose(one[2:], other[2:], rtol=0.0, atol=1e-6)


def test_finer_samples_mirror_images_and_a_still_end_change_no_run_beside_a_wall():
    """120 runs; in a few of them rounding may decide whether a body just touches the wall."""
    changed = {"finer": 0, "mirrored": 0, "longer": 0}
    for seed in range(120):
        body, place, motion = beside_a_wall(seed)
        one = results(body, place, motion)
        wall = place.right_wall
        outcome, hits, tilt, slide = results(
            body, sp.Room(place.floor, left_wall=wall), sp.Motion(motion.dt, -motion.x, z=motion.z)
        )
        changed["mirrored"] += not same(one, (outcome, hits, tilt, -slide))
        changed["finer"] += not same(one, results(body, place, finer(motion)))
        still, rest = np.zeros(100), np.zeros(150)
        ended, longer = (
            sp.Motion(motion.dt, np.append(motion.x, end), z=np.append(motion.z, end))
            for end in (still, rest)
        )
        changed["longer"] += not same(results(body, place, ended), results(body, place, longer))
    assert max(changed.values()) <= 3, changed


def test_a_slow_landing_goes_on_rocking_where_the_load_hardly_resists():
    """The load rises past (b/h)g as the body lands: what little rate is left to it is what tips it."""
    body, dt = block(0.2, 0.8), 0.02
    along = -G * 0.25 * np.linspace(0.995, 1.03, 21)
    times = np.arange(len(along)) * dt
    for rate in (1e-3, 2e-3):  # rad/s: the other corner opens at 0.4 and 0.8 mm/s
        run = simulate(body, room(3.0), sp.Motion(dt, along), tilt=-1e-7, tilt_rate=rate)
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
        run = sp.simulate(sp.Body(1.0, 1.6, 100.0), place, motion)
        assert run.outcome != "failed"
        assert np.abs(run.tilt).max() == 0.0 == np.abs(run.slide).max()
        hits.append([e.time for e in events(run, sp.EventKind.CEILING_IMPACT)])
    assert len(hits[0]) == 4
    assert hits[0] == pytest.approx(hits[1], abs=1e-12)


def test_a_flush_wall_is_not_hit_by_the_corner_that_lands_beside_it():
    """Its gap b(1 − cos θ) is never negative; rounding must not close it at any step of the record."""
    t = np.arange(0.0, 6.0, 0.02)
    place = sp.Room(sp.Floor(3.0, 3.0), left_wall=sp.Wall(0.0, 0.3, 0.0))
    for amplitude in np.linspace(3.0, 4.0, 8):
        motion = sp.Motion(0.02, amplitude * np.sin(2.0 * np.pi * t))
        for parts in (1, 2, 3):
            run = sp.simulate(sp.Body(0.4, 1.6, 100.0), place, finer(motion, parts))
            assert len(events(run, sp.EventKind.FLOOR_IMPACT)) > 5
            tilts = [abs(event.tilt) for event in events(run, sp.EventKind.WALL_IMPACT)]
            assert not [tilt for tilt in tilts if 1e-11 < tilt < 1e-5]


@pytest.mark.parametrize("seed", [67, 197])
def test_the_peak_of_an_excursion_that_turns_in_the_step_it_began_in(seed):
    """From rest at the start of a step, uplift and return before its end: the peak lies in between."""
    body, place, motion = beside_a_wall(seed)
    coarse, fine = (sp.simulate(body, place, m).peak_tilt for m in (motion, finer(motion, 64)))
    assert 0.0 < fine < 4e-4
    assert coarse == pytest.approx(fine, rel=1e-6)


def test_a_leaning_slip_that_stops_and_goes_on_within_a_step_is_stopped_there():
    """Its friction turns over: the body ends where it does under the same record on a finer grid."""
    body, place, motion = beside_a_wall(2568)
    assert same(results(body, place, motion), results(body, place, finer(motion)))
