"""Mode selection: which mode follows a loss of equilibrium, and the accelerations that go with it."""

import numpy as np
import pytest
from mechanics_runs import G, kinds, modes, steady, traced

import stayput as sp
from stayput.mechanics.columns import H_SLIDE_RATE, H_TILT_RATE


@pytest.mark.parametrize(
    ("level", "mu", "mode", "turning", "slip"),
    [
        (0.4, 0.2, sp.Mode.SLIDE, 0.0, -1.962),
        (0.4, 0.26, sp.Mode.SLIDE_ROCK, 0.3487, -1.0763),
        (0.4, 0.28, sp.Mode.SLIDE_ROCK, 1.0612, -0.2688),
        (0.4, 0.6, sp.Mode.ROCK, 1.2984, 0.0),
        (0.6, 0.3, sp.Mode.SLIDE_ROCK, 1.7945, -1.3997),
    ],
)
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_step_of_acceleration_starts_the_one_consistent_mode(level, mu, mode, turning, slip, side):
    dt = 1e-4
    run = traced(steady(side * level * G, 3 * dt, dt=dt), room=sp.Room(sp.Floor(mu, mu)))
    assert modes(run)[1] is mode
    rates = run.history[:, [H_TILT_RATE, H_SLIDE_RATE]]
    found = np.abs(np.diff(rates, axis=0)[0] / dt)
    assert found == pytest.approx(np.abs([turning, slip]), abs=2e-3)


def test_a_body_that_can_rest_does_so_to_the_bit():
    run = traced(steady(0.24 * G, 1.0))
    assert set(modes(run)) == {sp.Mode.REST}
    assert not run.history[:, [H_TILT_RATE, H_SLIDE_RATE]].any()
    assert len(run.events) == 0


def test_a_flush_wall_carries_no_self_stress():
    """It presses only where the body would move into it: the body slides off it as if it were not there."""
    room = sp.Room(sp.Floor(0.2, 0.2))
    walled = sp.Room(sp.Floor(0.2, 0.2), left_wall=sp.Wall(0.0, 0.3, 0.5))
    free, flush = (traced(steady(-0.22 * G, 0.3), room=place) for place in (room, walled))
    assert flush.result["residual_slide"] == pytest.approx(free.result["residual_slide"], rel=1e-12)
    held = traced(steady(0.22 * G, 0.3), room=walled)
    assert held.result["residual_slide"] == 0.0


def test_downward_acceleration_beyond_gravity_throws_the_body_up():
    run = traced(steady(0.0, 0.1, up=-1.5 * G))
    assert modes(run)[-1] is sp.Mode.FLIGHT
    assert sp.EventKind.FAILED not in kinds(run)
