"""The paper's contact rules: thresholds, impacts and walls as written."""

import pytest
from mechanics_runs import G, kinds, modes, steady, traced

import stayput as sp


def run_paper(level, room, duration=0.05, **state):
    return traced(steady(level * G, duration, law=1), room=room, **state)


@pytest.mark.parametrize(
    ("level", "mu", "mode"),
    [(0.1, 0.2, "rest"), (0.22, 0.2, "slide"), (0.24, 0.6, "rest"), (0.26, 0.6, "rock")],
)
def test_sliding_starts_at_mu_and_rocking_at_the_slenderness(level, mu, mode):
    assert modes(run_paper(level, sp.Room(sp.Floor(mu, mu))))[-1].value == mode


def test_a_landing_follows_equation_3_14():
    room = sp.Room(sp.Floor(3.0, 3.0, restitution=0.7))
    run = run_paper(0.0, room, 1.0, tilt=1e-7, tilt_rate=-1.0)
    first = run.events[0]
    assert list(sp.EventKind)[int(first.kind)] is sp.EventKind.FLOOR_IMPACT
    assert first.tilt_rate == pytest.approx(-0.7 * 0.91176, abs=1e-5)


def test_a_wall_reverses_the_rotation():
    room = sp.Room(sp.Floor(3.0, 3.0), right_wall=sp.Wall(0.05, 0.4, 0.0))
    run = run_paper(0.0, room, 0.5, tilt=0.02, tilt_rate=1.0)
    hit = next(e for e in run.events if list(sp.EventKind)[int(e.kind)] is sp.EventKind.WALL_IMPACT)
    assert hit.tilt_rate < 0.0


def test_vertical_motion_is_left_out():
    room = sp.Room(sp.Floor(0.5, 0.5))
    shaken = traced(steady(0.0, 0.2, up=-2.0 * G, law=1), room=room)
    assert set(modes(shaken)) == {sp.Mode.REST}
    assert kinds(shaken) == []
