"""Rows and towers: impacts that run through many bodies, by what energy and statics ask of them."""

import numpy as np
import pytest
from in_space import energy, still

import stayput as sp
from stayput.simulation.space import ENDS, results_of, trace_together
from stayput.simulation.space_engine import SpaceShaking


def tipped(body: sp.Body, corner: float, rate: float) -> sp.Piece:
    """Return a body that turns about its base edge at x = corner."""
    spin = np.array([0.0, rate, 0.0])
    lever = body.solid.centre_of_gravity - np.array([corner, 0.0, 0.0])
    return sp.Piece(body, velocity=tuple(np.cross(spin, lever)), rotation_rate=tuple(spin))


@pytest.mark.parametrize("count", [2, 5])
def test_a_row_of_shelves_falls_to_its_end(count: int) -> None:
    """Each tips the next: 2.1 m reach over 0.75 m, and a shelf that is hit above has no way to stand."""
    shelf = sp.Body.box(0.32, 0.9, 2.1, 120.0)
    row = [tipped(shelf, 0.16, 0.75), *(sp.Piece(shelf, (0.75 * n, 0.0, 0.0)) for n in range(1, count))]
    run = sp.simulate(sp.Scene(row, sp.Room(sp.Floor(0.4, 0.4)), friction=(0.3, 0.3)), still(6.0))
    assert all(piece.overturned for piece in run.pieces)
    assert not run.given_up
    found = sum(energy(run, body) for body in range(count))
    assert (np.diff(found) <= 1e-6 * found[0]).all()


def test_a_run_of_a_row_that_has_fallen_ends_with_the_same_results() -> None:
    """Shelves that lean on each other never stand again, though strong shaking moves them to its end."""
    shelf = sp.Body.box(0.32, 0.9, 2.1, 120.0)
    row = [tipped(shelf, 0.16, 0.75), *(sp.Piece(shelf, (0.75 * n, 0.0, 0.0)) for n in range(1, 3))]
    scene = sp.Scene(row, sp.Room(sp.Floor(0.4, 0.4)), friction=(0.3, 0.3))
    shaking = SpaceShaking.of(sp.Motion(dt=0.01, x=3.0 * np.sin(5.0 * 0.01 * np.arange(2401))))
    runs = [trace_together(scene, shaking, 9.80665, stop_after_rest=end) for end in (np.inf, ENDS)]
    whole, ended = (results_of(run, shaking.dt) for run in runs)
    for name in ("outcome", "end", "peak_tilt", "peak_slide", "residual_slide"):
        assert np.array_equal(whole[name], ended[name]), name
    assert runs[1].trace.steps < runs[0].trace.steps
    places = runs[1].trace.place
    assert (places[:, 600:] == places[:, -1:]).all()


def test_ten_blocks_bear_their_own_weight_under_shaking() -> None:
    """Below μ g and below what tips ten blocks as one, b/h g, nothing moves against anything."""
    block = sp.Body.box(0.5, 0.5, 0.3, 20.0)
    tower = [sp.Piece(block, (0.0, 0.0, 0.3 * n)) for n in range(10)]
    time = 0.01 * np.arange(201)
    shaking = sp.Motion(dt=0.01, x=1.2 * np.sin(9.0 * time), y=0.8 * np.sin(7.0 * time))
    run = sp.simulate(sp.Scene(tower, sp.Room(sp.Floor(0.5, 0.4)), friction=(0.5, 0.4)), shaking)
    assert max(piece.tilt.max() for piece in run.pieces) < 1e-9
    assert max(piece.slide.max() for piece in run.pieces) < 1e-6


@pytest.mark.long
def test_a_tower_of_ten_under_strong_shaking_runs_to_its_end() -> None:
    """It falls, and hardly a step is left without impulses that fit."""
    block = sp.Body.box(0.5, 0.5, 0.3, 20.0)
    tower = [sp.Piece(block, (0.0, 0.0, 0.3 * n)) for n in range(10)]
    strong = sp.near_fault()
    shaking = sp.Motion(strong.dt, **{axis: values[:1200] for axis, values in strong.components.items()})
    run = sp.simulate(sp.Scene(tower, sp.Room(sp.Floor(0.5, 0.4)), friction=(0.5, 0.4)), shaking)
    assert not run.given_up
    assert run[0].overturned
    assert all(piece.fell_off for piece in run.pieces[1:])
    assert run.unconverged <= 2e-3 * run.steps
