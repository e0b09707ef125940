"""B. Westermo and F. Udwadia (1983), Periodic response of a sliding oscillator system to harmonic excitation,
Earthquake Eng. Struct. Dyn. 11(1), 135-146, for an oscillator without spring: a block on a shaking floor.

A block that never sticks moves to and fro by (2Ag/ω²)√(1−(πμ/2A)²) once it is in its steady state.
"""

import math

import numpy as np
import pytest
from setups import G, both_laws, room, simulate

import stayput as sp

WIDE = sp.Body(1.0, 0.5, 100.0)


@both_laws
@pytest.mark.parametrize(("mu", "A", "frequency"), [(0.2, 0.5, 1.0), (0.1, 0.5, 2.0), (0.2, 0.9, 0.8)])
def test_steady_state(law, mu, A, frequency):
    cycles = 40
    motion = sp.sine(A * G, frequency, cycles / frequency, dt=1 / frequency / 500)
    run = simulate(WIDE, room(mu), motion, law)
    last, before = run.slide[-501:], run.slide[-1001:-500]
    assert np.ptp(last) == pytest.approx(np.ptp(before), rel=1e-6)  # it is steady
    assert last[-1] == pytest.approx(last[0], abs=1e-6)
    assert set(run.mode[-501:]) == {sp.Mode.SLIDE}
    omega = 2 * math.pi * frequency
    expected = 2 * A * G / omega**2 * math.sqrt(1 - (math.pi * mu / (2 * A)) ** 2)
    assert np.ptp(last) == pytest.approx(expected, rel=3e-5)
    if (mu, A, frequency) == (0.2, 0.5, 1.0):
        assert np.ptp(last) == pytest.approx(0.193314, rel=3e-5)


@both_laws
def test_it_sticks_in_every_cycle_where_the_shaking_is_weak(law):
    """Below πμ/2A ≈ 0.5 … 1 the block rests for a part of each half cycle: no such formula."""
    motion = sp.sine(0.3 * G, 1.0, 10.0, dt=0.002)
    run = simulate(WIDE, room(0.2), motion, law)
    assert {sp.Mode.SLIDE, sp.Mode.REST} <= set(run.mode[-501:])
