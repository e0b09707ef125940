"""The energy that turns a body over: m g (R − z) over an edge, a corner or a rim, whatever its inertia."""

import math

import numpy as np
import pytest
from in_space import STICKING, G, still

import stayput as sp


def kicked(convex: sp.Body, arm: np.ndarray, factor: float) -> tuple[sp.Piece, float]:
    """A body that turns about a point of its base, with a share of the energy that lifts G above it [J].

    G lies above the middle of the base; the axis is level and across the way to the point.
    """
    lever = convex.solid.centre_of_gravity - arm
    along = arm / np.linalg.norm(arm)
    axis = np.cross([0.0, 0.0, 1.0], along)
    about = axis @ convex.solid.inertia @ axis + convex.mass * lever @ lever
    barrier = convex.mass * G * (np.linalg.norm(lever) - lever[2])
    spin = math.sqrt(2.0 * factor * barrier / about) * axis
    return sp.Piece(convex, velocity=tuple(np.cross(spin, lever)), rotation_rate=tuple(spin)), barrier


def passes(start: sp.Piece, over: float) -> bool:
    """Whether G came over the point that it turns about, at a tilt [rad], and 0.1 rad beyond."""
    highest = sp.simulate(start, STICKING, still(1.8), step=1e-4).tilt.max()
    assert abs(highest - over) > 0.02
    return bool(highest > over + 0.1)


@pytest.mark.parametrize("factor", [0.985, 1.015])
@pytest.mark.parametrize("share", [0.5, 1.0, 2.0])
@pytest.mark.parametrize(
    "arm",
    [(0.2, 0.0, 0.0), (-0.2, 0.0, 0.0), (0.0, 0.3, 0.0), (0.0, -0.3, 0.0)],
    ids=["front", "back", "left", "right"],
)
def test_an_edge(arm: tuple[float, float, float], share: float, factor: float) -> None:
    usual = sp.Body.box(0.4, 0.6, 1.5, 80.0)
    convex = sp.Body.box(0.4, 0.6, 1.5, 80.0, inertia=share * usual.solid.inertia)
    start, _ = kicked(convex, np.array(arm), factor)
    assert passes(start, math.atan2(np.linalg.norm(arm), 0.75)) == (factor > 1.0)


@pytest.mark.parametrize("factor", [0.985, 1.015])
@pytest.mark.parametrize("share", [0.5, 1.0, 2.0])
def test_a_corner(share: float, factor: float) -> None:
    """A square column that is kicked along its diagonal stays in that plane, where the barrier is sharp."""
    usual = sp.Body.box(0.4, 0.4, 1.5, 80.0)
    convex = sp.Body.box(0.4, 0.4, 1.5, 80.0, inertia=share * usual.solid.inertia)
    start, _ = kicked(convex, np.array([0.2, 0.2, 0.0]), factor)
    assert passes(start, math.atan2(0.2 * math.sqrt(2.0), 0.75)) == (factor > 1.0)


@pytest.mark.parametrize("factor", [0.985, 1.015])
@pytest.mark.parametrize("direction", [0.0, 1.0])
def test_a_rim(direction: float, factor: float) -> None:
    drum = sp.Body.cylinder(0.5, 1.4, 60.0)
    arm = 0.25 * np.array([math.cos(direction), math.sin(direction), 0.0])
    start, _ = kicked(drum, arm, factor)
    assert passes(start, math.atan2(0.25, 0.7)) == (factor > 1.0)


@pytest.mark.parametrize("angle", [0.2, 0.9, 1.3])
@pytest.mark.parametrize("share", [0.5, 2.0])
def test_no_kick_below_the_lowest_barrier_overturns(angle: float, share: float) -> None:
    """Kicked in any direction, with less energy than the lowest barrier, that of its long edge."""
    usual = sp.Body.box(0.4, 0.6, 1.5, 80.0)
    convex = sp.Body.box(0.4, 0.6, 1.5, 80.0, inertia=share * usual.solid.inertia)
    way = np.array([0.2 * math.cos(angle), 0.3 * math.sin(angle), 0.0])
    start, barrier = kicked(convex, way, 1.0)
    _, lowest = kicked(convex, np.array([0.2, 0.0, 0.0]), 1.0)
    start, _ = kicked(convex, way, 0.99 * lowest / barrier)
    assert not sp.simulate(start, STICKING, still(2.0), step=2e-4).overturned
