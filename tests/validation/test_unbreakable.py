"""What is asked of a device that fails: the peak force of the same device which cannot.

Source: balance of moments about the front edge of a rigid block that is pushed forward, with its width b, its
height h, its mass m and its tilt φ: forces of the device times their levers are
m (a (h cos φ + b sin φ) − g (b cos φ − h sin φ))/2. The acceleration a grows so slowly that inertia plays
no part, and the devices have no slack, over which the block would gain speed.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

import stayput as sp
from stayput.measures import MEASURES, Chain, GelMats, LBracket, TensionPole

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.measures import DeviceResult, Measure

WIDTH, HEIGHT, MASS, G = 0.3, 1.8, 100.0, 9.80665
BODY = sp.Body(WIDTH, HEIGHT, MASS)
LARGEST = 3.0
"""Acceleration at the end [m/s²]."""
RAMP = sp.Motion(0.01, x=np.linspace(0.0, -LARGEST, 2001))
ROOM = sp.Room(
    floor=sp.Floor(static_friction=2.0, kinetic_friction=2.0), left_wall=sp.Wall(0.0), ceiling=sp.Ceiling(2.4)
)


@pytest.mark.parametrize(
    ("weak", "moment"),
    [
        (LBracket(strength=20.0, slack=0.0), lambda it: it.peak_pull * HEIGHT + it.peak_shear * WIDTH),
        (Chain(strength=20.0, slack=0.0, angle=0.0), lambda it: it.peak_pull * HEIGHT),
        (
            TensionPole(strength=100.0, preload=50.0, setback=0.0),
            lambda it: it.peak_push * WIDTH + it.peak_shear * HEIGHT,
        ),
        (GelMats(tension=2e3, shear=1e5), lambda it: it.peak_pull * WIDTH),
    ],
    ids=lambda part: getattr(part, "kind", ""),
)
def test_the_demand_on_a_device_that_fails_is_in_balance(
    weak: Measure, moment: Callable[[DeviceResult], float]
):
    runs = [sp.simulate(BODY, ROOM, RAMP, [measure]) for measure in (weak, weak.unbreakable())]
    failing, strong = (run.devices[0] for run in runs)
    assert failing.failed
    assert not strong.failed
    assert (strong.utilisation, strong.weakest) == (0.0, None)
    sin, cos = math.sin(runs[1].peak_tilt), math.cos(runs[1].peak_tilt)
    across, up = HEIGHT * cos + WIDTH * sin, WIDTH * cos - HEIGHT * sin
    balance = 0.5 * MASS * (LARGEST * across - G * up)
    assert moment(strong) == pytest.approx(balance, rel=0.03)
    assert moment(failing) < 0.9 * balance


@pytest.mark.parametrize("dimensions", [2, 3])
@pytest.mark.parametrize("kind", MEASURES)
def test_where_nothing_fails_what_cannot_fail_has_the_same_bits(kind: str, dimensions: int):
    """So verdicts repeat only runs in which something reaches its strength: `stayput.verification.demand`."""
    room, shaking = sp.Room(left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.3)), sp.near_fault().scaled(0.25)
    measure = MEASURES[kind]()
    body = sp.Body(WIDTH, HEIGHT, MASS, length=0.9)
    own, strong = (
        sp.simulate(body, room, shaking, [each], dimensions=dimensions)
        for each in (measure, measure.unbreakable())
    )
    assert own.device_failures == 0
    assert np.array_equal(own.tilt, strong.tilt)
    assert np.array_equal(own.slide, strong.slide)
    for ours, theirs in zip(own.devices, strong.devices, strict=True):
        assert np.array_equal(ours.pull, theirs.pull)
        assert (ours.peak_pull, ours.peak_push) == (theirs.peak_pull, theirs.peak_push)
