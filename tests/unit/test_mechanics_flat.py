"""Rest and flat sliding: closed forms, and the extremes by which rest is skipped."""

import numpy as np
import pytest
from mechanics_runs import G, modes, steady, traced

import stayput as sp
from stayput.mechanics.flat import BLOCK
from stayput.mechanics.runner import extremes, shaking


def test_a_rectangular_pulse_slides_the_body_by_the_closed_form():
    mu, level, duration = 0.3, 0.6, 0.3
    x = np.zeros(20001)
    x[:6001] = level * G
    motion = shaking(x, None, duration / 6000, 0)
    run = traced(motion, body=sp.Body(1.0, 0.5, 100.0), room=sp.Room(sp.Floor(mu, mu)))
    expected = level * (level - mu) * G * duration**2 / (2.0 * mu)
    assert abs(run.result["residual_slide"]) == pytest.approx(expected, rel=1e-3)
    assert modes(run)[-1] is sp.Mode.REST


def test_friction_stops_a_slide_exactly():
    run = traced(
        steady(0.0, 1.0), body=sp.Body(1.0, 0.5, 100.0), room=sp.Room(sp.Floor(0.5, 0.4)), slide_rate=1.0
    )
    assert run.result["residual_slide"] == pytest.approx(1.0 / (2.0 * 0.4 * G), rel=1e-12)
    (stop,) = run.events
    assert stop.time == pytest.approx(1.0 / (0.4 * G), rel=1e-12)
    assert stop.slide_rate == 0.0


def test_a_slide_into_a_wall_ends_at_its_gap():
    room = sp.Room(sp.Floor(0.1, 0.1), right_wall=sp.Wall(0.05, 0.0, 0.0))
    run = traced(steady(0.0, 1.0), body=sp.Body(1.0, 0.5, 100.0), room=room, slide_rate=1.0)
    assert run.result["peak_slide"] == pytest.approx(0.05, abs=1e-9)
    assert run.result["wall_impacts"] == 1


@pytest.mark.parametrize("n", [2, BLOCK, BLOCK + 1, BLOCK + 2, 5 * BLOCK + 3])
def test_extremes_cover_the_segments_of_each_block(n):
    values = np.random.default_rng(n).normal(size=n)
    low, high = extremes(values)
    for block in range(len(low)):
        part = values[block * BLOCK : (block + 1) * BLOCK + 1]  # segments share their ends
        assert (low[block], high[block]) == (part.min(), part.max())
    assert (len(low) - 1) * BLOCK < n - 1 <= len(low) * BLOCK
