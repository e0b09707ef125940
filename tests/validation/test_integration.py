"""Rocking against an independent integration: eccentric G, wedges, vertical shaking, event times to 1e-9 s.

The equations are those of `equations.py`, written from Newton's laws and integrated by SciPy's DOP853
(E. Hairer, S. P. Nørsett, G. Wanner, 1993, Solving Ordinary Differential Equations I) to 1e-13.
"""

import math

import numpy as np
import pytest
from equations import Rocking, record
from setups import STICKING, G, block, both_laws, impacts, simulate

import stayput as sp

BODIES = {
    "uniform": sp.Body(0.4, 1.6, 100.0),
    "eccentric": sp.Body(0.4, 1.6, 100.0, cg_offset=(0.04, 0.1)),
    "heavy base": sp.Body(0.5, 1.8, 100.0, cg_offset=(-0.08, -0.4), inertia=30.0),
    "front wedge": sp.Body(0.4, 1.6, 100.0, cg_offset=(0.02, 0.0), base_heights=(0.0, -0.005)),
}


def swell(duration: float, dt: float, seed: int, size: float) -> np.ndarray:
    """A few sines under an envelope: a smooth record with many zero crossings."""
    rng = np.random.default_rng(seed)
    t = np.arange(round(duration / dt) + 1) * dt
    waves = [np.sin(2 * math.pi * f * t + rng.uniform(0, 6)) for f in (0.7, 1.3, 2.1, 3.4)]
    return size * np.sin(math.pi * t / duration) * np.sum(waves, axis=0)


def compare(body: sp.Body, motion: sp.Motion, law: str, tilt: float, *, restitution: float = 1.0) -> sp.Run:
    floor = sp.Floor(3.0, 3.0, restitution=restitution)
    run = simulate(body, sp.Room(floor), motion, law, tilt=tilt)
    peer = Rocking(
        body, record(motion.x, motion.dt), record(motion.z, motion.dt), motion.time, restitution=restitution
    )
    states = peer.run(tilt, 0.0, 1 if tilt > 0 else -1)
    n, landings = states.shape[1], len(peer.landings)
    assert landings == 5
    assert {e.kind for e in run.events[:landings]} == {sp.EventKind.FLOOR_IMPACT}
    found = impacts(run)[:landings]
    assert [e.time for e in found[:1]] == pytest.approx(peer.landings[:1], abs=1e-9)
    assert [e.time for e in found] == pytest.approx(peer.landings, abs=1e-8)
    assert [e.tilt_rate for e in found] == pytest.approx(peer.rates, abs=1e-8)
    assert run.tilt[:n] == pytest.approx(states[0] - body.resting_tilt, abs=1e-8)
    assert run.rotation_rate[0, :n, 1] == pytest.approx(states[1], abs=1e-7)
    return run


@both_laws
@pytest.mark.parametrize("restitution", [1.0, 0.6])
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("name", BODIES)
def test_rocking_under_a_horizontal_record(law, restitution, side, name):
    motion = sp.Motion(0.02, swell(3.2, 0.02, 13, 0.5))
    compare(BODIES[name], motion, law, side * 0.08, restitution=restitution)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("name", BODIES)
def test_rocking_under_vertical_shaking(side, name):
    motion = sp.Motion(0.02, swell(3.2, 0.02, 13, 0.5), z=swell(3.2, 0.02, 4, 1.2))
    with_up = compare(BODIES[name], motion, "coulomb", side * 0.08)
    without = simulate(BODIES[name], sp.Room(STICKING), sp.Motion(0.02, motion.x), tilt=side * 0.08)
    n = min(len(with_up.tilt), len(without.tilt))
    assert np.abs(with_up.tilt[:n] - without.tilt[:n]).max() > 1e-3


def test_vertical_shaking_alone():
    """A tilted body falls and rocks under it; one that stands stays."""
    up = swell(3.2, 0.02, 7, 2.0)
    compare(BODIES["uniform"], sp.Motion(0.02, np.zeros(161), z=up), "coulomb", 0.1)
    run = simulate(BODIES["uniform"], sp.Room(STICKING), sp.Motion(0.02, np.zeros(161), z=up))
    assert run.outcome is sp.Outcome.RESTED


@both_laws
def test_history_of_one_sine(law):
    """The record's chain of 0.1 ms lines against the sine itself."""
    body, period, size = block(0.225, 0.9), 0.5, 0.4 * G
    uplift = math.asin(0.25 / 0.4) * period / (2 * math.pi)
    peer = Rocking(
        body,
        lambda t: size * math.sin(2 * math.pi * t / period) if t < period else 0.0,
        lambda _: 0.0,
        [period, 1.5],
    )
    peer.run(0.0, 0.0, -1, start=uplift)
    run = simulate(body, sp.Room(STICKING), sp.sine(size, 1 / period, period, dt=1e-4, quiet=1.0), law)
    assert [e.time for e in impacts(run)] == pytest.approx(peer.landings, abs=1e-6)
    assert run.peak_tilt == pytest.approx(peer.largest, abs=1e-6)
    assert run.peak_tilt / math.atan(0.25) == pytest.approx(0.41987, abs=1e-5)
