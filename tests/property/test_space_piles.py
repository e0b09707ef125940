"""Several bodies that stand on and fall over each other make no energy: friction and impacts only take it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_space_random import cases

import stayput as sp

STILL = sp.Motion(dt=0.01, x=np.zeros(31))


def tower(rng: np.random.Generator) -> list[sp.Piece]:
    """Boxes on each other, the uppermost thrown."""
    found, top = [], 0.0
    for number in range(5):
        solid = sp.Body.box(*rng.uniform(0.2, 0.5, 3), float(rng.uniform(2.0, 50.0)))
        velocity = tuple(rng.normal(0.0, 1.5, 3)) if number == 4 else (0.0, 0.0, 0.0)
        found.append(sp.Piece(solid, (*rng.uniform(-0.03, 0.03, 2), top), velocity=velocity))
        top += solid.height + 1e-9
    return found


def pile(rng: np.random.Generator) -> list[sp.Piece]:
    """Boxes and cylinders in a row that are thrown together."""
    found = []
    for number in range(4):
        solid = sp.Body.box(*rng.uniform(0.2, 0.4, 3), float(rng.uniform(2.0, 50.0)))
        if rng.random() < 0.4:
            solid = sp.Body.cylinder(
                rng.uniform(0.2, 0.4), rng.uniform(0.2, 0.6), float(rng.uniform(2.0, 50.0))
            )
        at = 0.6 * number, rng.uniform(-0.1, 0.1), rng.uniform(0.0, 0.2)
        velocity = (1.5 - number) * 2.0, *rng.normal(0.0, 0.3, 2)
        found.append(sp.Piece(solid, at, velocity=velocity, rotation_rate=tuple(rng.normal(0.0, 2.0, 3))))
    return found


@pytest.mark.parametrize("kind", [tower, pile])
@pytest.mark.parametrize("restitution", [0.0, 0.5])
@given(seed=st.integers(0, 2**32 - 1))
def test_no_energy_is_made(kind, restitution: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    static, between = rng.uniform(0.0, 1.0, 2)
    room = sp.Room(sp.Floor(static, 0.8 * static, normal_restitution=restitution))
    scene = sp.Scene(kind(rng), room, friction=(between, 0.8 * between))
    run = sp.simulate(scene, STILL)
    found = cases.energies(run)
    assert np.isfinite(found).all()
    assert np.diff(found).max() < 1e-4 * found[0]
