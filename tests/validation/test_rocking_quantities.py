"""R, α, p and the static overturning acceleration of the rocking literature (Housner 1963, West 1882)."""

from __future__ import annotations

import math

import numpy as np
import pytest

import stayput as sp

G = 9.80665


def test_a_uniform_block_has_housners_quantities():
    block = sp.Body(width=0.4, height=1.2, mass=100.0)
    R, alpha = math.hypot(0.2, 0.6), math.atan2(0.4, 1.2)
    assert block.size == pytest.approx((R, R), rel=1e-14)
    assert block.slenderness == pytest.approx((alpha, alpha), rel=1e-14)
    assert block.frequency_parameter() == pytest.approx(2 * (math.sqrt(0.75 * G / R),), rel=1e-14)
    assert block.overturning_acceleration() == pytest.approx(2 * (G * 0.4 / 1.2,), rel=1e-14)


def test_p_is_how_fast_a_block_that_stands_on_its_corner_falls():
    # Near the critical angle θ̈ = p² (θ − α), so that a small lean beyond it grows as cosh(p t).
    block = sp.Body(width=0.4, height=1.2, mass=100.0, cg_offset=(0.03, -0.1), inertia=9.0)
    p, alpha, lean = block.frequency_parameter()[1], block.slenderness[1], 1e-4
    run = sp.simulate(
        block,
        sp.Room(floor=sp.Floor(static_friction=1e3, kinetic_friction=1e3)),
        sp.Motion(0.005, np.zeros(200)),
        initial=sp.State(tilt=alpha + lean),
    )
    grown = run.tilt[:101] - alpha
    assert grown == pytest.approx(lean * np.cosh(p * run.time[:101]), rel=2e-3)


@pytest.mark.parametrize("side", [0, 1])
@pytest.mark.parametrize("heights", [(0.0, 0.0), (0.0, -0.01)])
def test_a_steady_push_lifts_the_block_just_above_its_overturning_acceleration(
    side: int, heights: tuple[float, float]
):
    block = sp.Body(width=0.4, height=1.2, mass=100.0, cg_offset=(0.05, -0.1), base_heights=heights)
    room = sp.Room(floor=sp.Floor(static_friction=1e3, kinetic_friction=1e3))
    limit = block.overturning_acceleration()[side]
    sign = 1.0 if side == 0 else -1.0  # a floor that accelerates to +x tips the block to −x, about A
    for factor, moves in ((0.999, False), (1.001, True)):
        motion = sp.Motion(0.01, np.full(400, sign * factor * limit))
        run = sp.simulate(block, room, motion)
        assert (run.peak_tilt > 1e-6) is moves
