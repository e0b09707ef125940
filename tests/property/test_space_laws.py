"""A hull that is dropped in space never gains energy and never ends inside the floor."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from test_space_random import cases

import stayput as sp

STILL = sp.Motion(dt=0.005, x=np.zeros(201))


@given(st.integers(0, 2**32 - 1))
def test_a_dropped_hull_gains_no_energy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    hull = sp.Body.hull(rng.uniform(-0.4, 0.4, (rng.integers(5, 20), 3)) + 0.1 * rng.normal(size=3), 20.0)
    thrown = sp.Piece(
        hull,
        (0.0, 0.0, rng.uniform(0.05, 0.6) - hull.solid.vertices[:, 2].min()),
        velocity=tuple(rng.normal(0.0, 1.0, 3)),
        rotation_rate=tuple(rng.normal(0.0, 4.0, 3)),
    )
    static = rng.uniform(0.0, 1.0)
    floor = sp.Floor(static, rng.uniform(0.0, 1.0) * static, normal_restitution=rng.uniform(0.0, 0.8))
    run = sp.simulate(thrown, sp.Room(floor), STILL)
    found = cases.energies(run)
    assert np.diff(found).max() < 2e-3 * found[0]
    offsets = hull.solid.vertices - hull.solid.centre_of_gravity
    lowest = run.place[0, :, 2, np.newaxis] + run.turn[0][:, 2] @ offsets.T
    assert lowest.min() > -1e-4
