"""Bodies that are dropped and thrown in space never gain energy and never end inside the floor."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp

G = 9.80665
STILL = sp.Motion(dt=0.005, x=np.zeros(201))


def energies(run: sp.SpaceRun) -> np.ndarray:
    """Kinetic and potential energy of a body at each sample [J]."""
    solid, turn, spin = run.standing[0].solid, run.turn[0], run.rotation_rate[0]
    inertia = turn @ solid.inertia @ turn.transpose(0, 2, 1)
    turning = 0.5 * np.einsum("si,sij,sj->s", spin, inertia, spin)
    moving = 0.5 * solid.mass * (run.velocity[0] ** 2).sum(axis=1)
    return turning + moving + solid.mass * G * run.place[0, :, 2]


@given(st.integers(0, 2**32 - 1))
def test_a_dropped_hull_gains_no_energy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    hull = sp.Solid(rng.uniform(-0.4, 0.4, (rng.integers(5, 20), 3)) + 0.1 * rng.normal(size=3), 20.0)
    thrown = sp.Standing(
        hull,
        (0.0, 0.0, rng.uniform(0.05, 0.6) - hull.vertices[:, 2].min()),
        velocity=tuple(rng.normal(0.0, 1.0, 3)),
        rotation_rate=tuple(rng.normal(0.0, 4.0, 3)),
    )
    static = rng.uniform(0.0, 1.0)
    floor = sp.Floor(static, rng.uniform(0.0, 1.0) * static, normal_restitution=rng.uniform(0.0, 0.8))
    run = sp.simulate(thrown, sp.Room(floor), STILL)
    found = energies(run)
    assert np.diff(found).max() < 2e-3 * found[0]
    offsets = hull.vertices - hull.centre_of_gravity
    lowest = run.place[0, :, 2, np.newaxis] + run.turn[0][:, 2] @ offsets.T
    assert lowest.min() > -1e-4


@pytest.mark.parametrize("direction", [0.0, 1.1])
def test_a_flat_cylinder_that_is_thrown_slides_to_where_friction_has_its_energy(direction: float) -> None:
    """On its rim, flat all the way: v²/(2 μ g)."""
    disc = sp.Solid.cylinder(0.6, 0.1, 10.0)
    way = np.array([np.cos(direction), np.sin(direction)])
    thrown = sp.Standing(disc, velocity=(*(1.5 * way), 0.0))
    run = sp.simulate(thrown, sp.Room(sp.Floor(0.4, 0.3)), STILL)
    np.testing.assert_allclose(run.slide[0, -1], 1.5**2 / (2.0 * 0.3 * G) * way, atol=2e-3)
    assert run.tilt.max() < 1e-6
