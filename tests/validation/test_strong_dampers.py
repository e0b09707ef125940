"""Strong dampers in space: what they take is energy, whatever the step; and what a bracket bears in a corner.

A damper only takes energy away (W = −c ∫ u̇² dt ≤ 0), and keeps the momentum of two free bodies.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from in_space import G, energy

import stayput as sp
from long_cases import long
from stayput.measures import LBracket
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.rooms.purchases import purchases_of
from stayput.verification.changes import Change, with_changes
from stayput.verification.option_runner import OptionRunner

BOX = sp.Body.box(0.3, 0.3, 0.3, 10.0)


def still(duration: float) -> sp.Motion:
    return sp.Motion(dt=0.001, x=np.zeros(round(1000 * duration) + 1))


@pytest.mark.parametrize("damping", [0.1, 0.5, 1.0, 2.0])
@pytest.mark.parametrize(("mass", "stiffness"), [(10.0, 1e6), (10.0, 1e9), (0.01, 1e5), (1.0, 1e5)])
def test_a_joint_in_flight_takes_energy_and_keeps_momentum(mass: float, stiffness: float, damping: float):
    first = sp.Body.box(0.3, 0.3, 0.3, mass)
    start = [
        sp.Piece(first, (0.0, 0.0, 4.0), velocity=(-1.0, 0.5, 3.0), rotation_rate=(1.0, 2.0, 3.0)),
        sp.Piece(BOX, (0.5, 0.0, 4.0), velocity=(1.0, 0.0, 3.0), rotation_rate=(0.0, -1.0, 0.5)),
    ]
    joint = sp.Joint(0, 1, (0.15, 0.1, 4.1), stiffness=stiffness, damping=damping)
    run = sp.simulate(
        sp.Scene(start, sp.Room(sp.Floor(0.5, 0.5)), friction=(0.5, 0.5), joints=[joint]), still(0.2)
    )
    found = energy(run, 0) + energy(run, 1)
    assert np.isfinite(found).all()
    assert found.max() <= found[0] * (1.0 + 1e-6)
    momentum = mass * run.velocity[0, :, :2] + BOX.mass * run.velocity[1, :, :2]
    np.testing.assert_allclose(momentum - momentum[0], 0.0, atol=1e-9)


@pytest.mark.parametrize("damping", [0.1, 0.8, 2.0])
def test_joined_boxes_on_a_shaken_floor_stay_slow(damping: float):
    """They go no faster than the floor does, which they follow by friction alone."""
    t = np.arange(0.0, 1.001, 0.005)
    floor = [14.0 * np.sin(6.0 * np.pi * t), 7.0 * np.sin(4.0 * np.pi * t), 11.2 * np.sin(10.0 * np.pi * t)]
    motion = sp.Motion(dt=0.005, x=floor[0], y=floor[1], z=floor[2])
    boxes = [sp.Piece(BOX), sp.Piece(BOX, (0.6, 0.0, 0.0))]
    joint = sp.Joint(0, 1, (0.15, 0.1, 0.2), stiffness=1e6, damping=damping)
    run = sp.simulate(
        sp.Scene(boxes, sp.Room(sp.Floor(0.3, 0.3)), friction=(0.3, 0.3), joints=[joint]), motion
    )
    assert np.abs(run.velocity).max() < 2.0
    assert run.devices[0].peak_pull < 10.0 * BOX.mass * G


@cache
def needed(along: float) -> tuple[float, ...]:
    """Return the forces that brackets of a bookcase need, at a place along its wall."""
    scenario = sp.Scenario.parse(
        {
            "plan": {"width": 3.6, "length": 2.7},
            "furniture": [{"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": along}],
            "shaking": {"intensity": "6-upper", "suite": {"family": "mixed", "count": 6}},
            "uncertainty": {"samples": 6},
        }
    )
    option = with_changes(scenario.stated, [Change("bookcase", LBracket())], scenario.names)
    (purchase,) = purchases_of(OptionRunner(scenario, SLIDE_LIMIT, 2), option, (LBracket(),), 0)
    assert purchase.needed is not None
    return tuple(purchase.needed)


@pytest.mark.parametrize("gap", [0.0, 5e-4, *long(1e-5, 2e-3)])
def test_a_bracket_in_a_corner_bears_what_it_bears_elsewhere(gap: float):
    """A piece that touches a side wall is shaken against it: its brackets then bear no hundred times more."""
    in_the_corner, elsewhere = needed(0.4 + gap), needed(1.4)
    for force, usual in zip(in_the_corner, elsewhere, strict=True):
        assert force < 1.5 * usual
