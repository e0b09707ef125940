"""stayput and MuJoCo agree about the planar block, where soft contacts allow; and MuJoCo's model is right.

The model is `benchmarks/mujoco_block.py`. MuJoCo's contacts give a little, have one coefficient of
friction, and its steps are 1 ms or less, so the tolerances are MuJoCo's: a few steps in time and 1 % in size.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import stayput as sp
from benchmark_modules import benchmark

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

G = 9.81
STEP = 5e-4  # s, of MuJoCo


mb = benchmark("mujoco_block")


def in_mujoco(block: Any, motion: sp.Motion, **state: float) -> Any:
    """Roll one block out under a motion."""
    time = mb.middles(motion.duration, STEP)
    applied = mb.forces([block], time, motion.dt, motion.x, motion.z, np.ones(1))
    return mb.run([block.model(STEP, G)], block.state(**state)[None], applied)


def in_stayput(block: Any, motion: sp.Motion, **state: float) -> sp.Run:
    """Simulate the same."""
    walls = (
        None if math.isinf(gap) else sp.Wall(gap, block.wall_restitution, block.wall_friction)
        for gap in (block.left_gap, block.right_gap)
    )
    room = sp.Room(sp.Floor(block.friction, block.friction), *walls)
    body = sp.Body(block.width, block.height, block.mass)
    return sp.simulate(body, room, motion, initial=sp.State(**state), gravity=G)


def still(duration: float) -> sp.Motion:
    return sp.Motion(0.01, np.zeros(round(duration / 0.01) + 1))


def landings(found: Any) -> list[float]:
    """Times at which MuJoCo's block changes its fulcrum [s]."""
    tilt, time = found.tilt[0], found.time
    crossed = np.flatnonzero(np.sign(tilt[1:]) != np.sign(tilt[:-1]))
    return [float(time[i]) for i in crossed if abs(found.tilt_rate[0, i]) > 0.1]


TALL = mb.Block(0.4, 1.6, friction=2.0)
SQUAT = mb.Block(2.0, 0.4, friction=0.3)


def test_free_rocking() -> None:
    """Impacts within 3 ms and 0.3 %: the soft landing takes a few steps."""
    tilt = math.atan(0.25) / 2
    ours = [e.time for e in in_stayput(TALL, still(2.0), tilt=tilt).events if e.kind == "floor impact"]
    theirs = landings(in_mujoco(TALL, still(2.0), tilt=tilt))
    assert len(theirs) >= 3
    assert theirs[:3] == pytest.approx(ours[:3], rel=3e-3, abs=3e-3)
    assert theirs[:3] == pytest.approx([0.441671, 1.160493, 1.770421], rel=3e-3, abs=3e-3)


def test_slide_after_a_pulse() -> None:
    """Residual slide within 0.1 %, and both at the closed form A(A−μ)gt²/(2μ)."""
    motion = sp.pulse("rectangular", -0.6 * G, duration=0.3, quiet=1.0)
    ours = in_stayput(SQUAT, motion).residual_slide
    theirs = float(in_mujoco(SQUAT, motion).x[0, -1])
    assert theirs == pytest.approx(ours, rel=1e-3)
    assert theirs == pytest.approx(0.264870, rel=1e-3)


def test_sliding_under_a_sine() -> None:
    """Steady range of the slide within 1 %, as soft contacts creep before they slip."""
    block, motion = mb.Block(2.0, 0.4, friction=0.2), sp.sine(0.5 * G, 1.0, 20.0)
    ours = np.ptp(in_stayput(block, motion).slide[-400:])
    theirs = np.ptp(in_mujoco(block, motion).x[0, -4000:])
    assert theirs == pytest.approx(ours, rel=1e-2)
    assert theirs == pytest.approx(0.193314, rel=1e-2)


@pytest.mark.parametrize(("a", "mu"), [(0.4, 0.26), (0.6, 0.3)])
def test_slide_rock(a: float, mu: float) -> None:
    """Tilt and place of G after 0.2 s of a sustained step within 2 % and 1 %: soft contacts settle first."""
    block = mb.Block(0.4, 1.6, friction=mu)
    motion = sp.Motion(0.01, np.full(21, a * G))
    ours, theirs = in_stayput(block, motion), in_mujoco(block, motion)
    assert theirs.tilt[0, -1] == pytest.approx(ours.tilt[-1], rel=2e-2)
    assert theirs.x[0, -1] == pytest.approx(ours.place[0, -1, 0], rel=1e-2)


@pytest.mark.parametrize("share", [0.97, 1.03])
def test_verdict_of_a_rectangular_pulse(share: float) -> None:
    """3 % below the threshold of 0.55697 g (0.2 s) both stand, 3 % above it both overturn."""
    motion = sp.pulse("rectangular", share * 0.55697 * G, duration=0.2, quiet=6.0)
    ours, theirs = in_stayput(TALL, motion), in_mujoco(TALL, motion)
    assert ours.overturned is (share > 1.0)
    assert bool(theirs.overturned[0]) is ours.overturned


def test_wall_stops_a_fall() -> None:
    """A wall stops a falling block in both; without the wall it overturns in both."""
    motion = sp.pulse("rectangular", -1.1 * 0.55697 * G, duration=0.2, quiet=4.0)
    free, walled = TALL, mb.Block(0.4, 1.6, friction=2.0, right_gap=0.1)
    assert in_stayput(free, motion).overturned
    assert in_mujoco(free, motion).overturned[0]
    ours, theirs = in_stayput(walled, motion), in_mujoco(walled, motion)
    assert not ours.overturned
    assert not theirs.overturned[0]
    assert float(theirs.peak_tilt[0]) == pytest.approx(ours.peak_tilt, rel=3e-2)


def test_verdicts_under_the_near_fault_motion() -> None:
    """Of 24 clear-cut cases (same verdict at 0.9 and 1.1 times the motion) at least 23 agree."""
    motion, rng = sp.near_fault().trimmed(0.0, 15.0).component("x"), np.random.default_rng(4)
    clear: list[tuple[Any, float, bool]] = []
    while len(clear) < 24:
        block = mb.Block(
            float(rng.uniform(0.2, 0.6)), float(rng.uniform(0.6, 2.0)), friction=float(rng.uniform(0.2, 0.9))
        )
        scale = float(rng.uniform(0.3, 1.5))
        verdicts = {
            in_stayput(block, motion.scaled(k * scale)).overturned for k in (0.9, 0.95, 1.0, 1.05, 1.1)
        }
        if len(verdicts) == 1:
            clear.append((block, scale, verdicts.pop()))
    blocks, scales, ours = zip(*clear, strict=True)
    assert 4 <= sum(ours) <= 20, "the draw must hold both verdicts"
    time = mb.middles(motion.duration, 1e-3)
    applied = mb.forces(blocks, time, motion.dt, motion.x, None, np.array(scales))
    models = [block.model(1e-3, G) for block in blocks]
    theirs = mb.run(models, np.array([block.state() for block in blocks]), applied, threads=2).overturned
    assert int(np.sum(theirs == np.array(ours))) >= 23
