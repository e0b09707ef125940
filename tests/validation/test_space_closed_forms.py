"""The engine in space beside closed forms: rest, sliding, and where rocking begins."""

import math

import numpy as np
import pytest
from in_space import STICKING, G, steady, still

import stayput as sp

BOX = sp.Body.box(0.4, 0.6, 1.5, 80.0)


def test_a_body_on_a_still_floor_does_not_move_at_all() -> None:
    for solid in (BOX, sp.Body.cylinder(0.4, 1.2, 30.0), sp.Body.cone(0.4, 0.2, 1.0, 30.0)):
        run = sp.simulate(sp.Piece(solid, heading=0.3), sp.Room(), still(1.0))
        assert np.array_equal(run.place, np.repeat(run.place[:, :1], len(run.time), axis=1))
        assert np.array_equal(run.attitude, np.repeat(run.attitude[:, :1], len(run.time), axis=1))


@pytest.mark.parametrize("direction", [0.0, 0.4, math.pi / 2])
@pytest.mark.parametrize("squat", [sp.Body.box(0.8, 0.6, 0.2, 50.0), sp.Body.cylinder(0.6, 0.1, 10.0)])
def test_what_is_thrown_slides_to_where_friction_has_its_energy(squat: sp.Body, direction: float) -> None:
    """Coulomb: v²/(2 μ g), whatever the direction and the heading; a cylinder on its rim."""
    way = np.array([math.cos(direction), math.sin(direction)])
    thrown = sp.Piece(squat, heading=0.7, velocity=(*(2.0 * way), 0.0))
    run = sp.simulate(thrown, sp.Room(sp.Floor(0.4, 0.3)), still(2.0))
    np.testing.assert_allclose(run[0].slide_in_plan[-1], 2.0**2 / (2.0 * 0.3 * G) * way, atol=2e-3)
    assert float(np.abs(run.rotation_rate).max()) < 1e-6


@pytest.mark.parametrize("direction", [0.0, 0.7, 2.5])
@pytest.mark.parametrize("factor", [0.999, 1.02])
def test_a_body_rocks_where_the_push_leaves_its_base(direction: float, factor: float) -> None:
    """It tips where h a > g d with d from below G to the edge of the base in the direction of the push."""
    push = np.array([math.cos(direction), math.sin(direction)])
    edge = min(0.2 / max(abs(push[0]), 1e-9), 0.3 / max(abs(push[1]), 1e-9))
    least = G * edge / 0.75
    run = sp.simulate(BOX, STICKING, steady(*(factor * least * push), 1.0))
    assert (run.tilt.max() > 1e-6) == (factor > 1.0)
    assert (run.steps == 0) == (factor < 1.0)


@pytest.mark.parametrize("factor", [0.999, 1.02])
def test_a_cylinder_rocks_where_the_push_leaves_its_circle(factor: float) -> None:
    drum = sp.Body.cylinder(0.4, 1.2, 60.0)
    least = factor * G * 0.2 / 0.6
    run = sp.simulate(drum, STICKING, steady(0.8 * least, 0.6 * least, 1.0))
    assert (run.tilt.max() > 1e-6) == (factor > 1.0)
    assert (run.steps == 0) == (factor < 1.0)
