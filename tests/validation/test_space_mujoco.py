"""A box under two components, and two stacked boxes, beside MuJoCo at a fine step.

The models are those of `benchmarks/space_mujoco.py`. MuJoCo's contacts are soft, so that its bodies settle,
and one coefficient of friction holds there.
"""

from __future__ import annotations

import numpy as np
import pytest

from benchmark_modules import benchmark

pytest.importorskip("mujoco", reason="MuJoCo is not installed")


_, mj = benchmark("csv_tables"), benchmark("space_mujoco")


def test_a_box_that_rocks_on_edges_and_corners() -> None:
    """The peak tilt within 2 %, and the tilt within 3 % of it until the first landing."""
    boxes, friction, size = mj.CASES["one box that rocks"]
    motion = mj.two_components(size, 1.0)
    run = mj.in_stayput(boxes, friction, motion, 1e-4)
    tilts, _ = mj.in_mujoco(boxes, friction, motion, 5e-5)
    peak = run.tilt.max()
    assert 0.01 < peak < 0.5
    assert tilts.max() == pytest.approx(peak, rel=0.02)
    until = slice(0, int(np.argmax(run[0].tilt)) + 1)
    np.testing.assert_allclose(tilts[0, until], run[0].tilt[until], atol=0.03 * peak)


def test_a_box_that_slides_in_two_directions() -> None:
    """The way in plan within 2 %, in either direction."""
    boxes, friction, size = mj.CASES["one box that slides"]
    motion = mj.two_components(size, 1.2)
    run = mj.in_stayput(boxes, friction, motion, 1e-4)
    _, places = mj.in_mujoco(boxes, friction, motion, 1e-4)
    way = run.place[0, -1, :2] - run.place[0, 0, :2]
    assert np.linalg.norm(way) > 0.03
    np.testing.assert_allclose(places[0, -1, :2], way, atol=0.02 * float(np.linalg.norm(way)))


def test_a_box_that_slides_on_a_box() -> None:
    """The lower one sticks, and the way of the upper is within 5 %."""
    boxes, friction, size = mj.CASES["two boxes, stacked"]
    motion = mj.two_components(size, 1.2)
    run = mj.in_stayput(boxes, friction, motion, 2e-4)
    _, places = mj.in_mujoco(boxes, friction, motion, 2e-4)
    ways = run.place[:, -1, :2] - run.place[:, 0, :2]
    assert np.abs(ways[0]).max() < 1e-15
    assert np.abs(places[0, -1, :2]).max() < 1e-4
    assert np.linalg.norm(ways[1]) > 0.01
    np.testing.assert_allclose(places[1, -1, :2], ways[1], atol=0.05 * float(np.linalg.norm(ways[1])))


def test_what_creeps_and_what_does_not() -> None:
    """Pushed by half of what friction holds, MuJoCo creeps, in proportion to its step: 1 µm/s at 1 ms."""
    assert mj.creep(1e-3, 2.0) == pytest.approx(1e-6, rel=0.1)
    assert mj.creep(5e-4, 2.0) == pytest.approx(5e-7, rel=0.1)
    pushed = mj.sp.Motion(dt=0.01, x=np.full(201, 0.5 * 0.4 * mj.GRAVITY))
    assert np.abs(mj.in_stayput([(0.8, 0.8, 0.4, 50.0)], (0.4, 0.4), pushed, 1e-3).slide).max() == 0.0
