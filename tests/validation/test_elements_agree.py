"""Both kernels agree where elements bear nothing, and one answer comes out whatever the settings."""

import numpy as np
import pytest
from setups import G, block

import stayput as sp
from devices import CEILING, LEFT, axial, bare, held, planar

SHAKEN = sp.near_fault().component("x").trimmed(0.0, 12.0)
PLACES = {
    "rocks": (block(0.2, 0.8), sp.Room(sp.Floor(0.9, 0.9)), 0.8),
    "slides": (block(0.5, 0.5), sp.Room(sp.Floor(0.3, 0.2)), 1.0),
    "slides and rocks": (block(0.2, 0.6), sp.Room(sp.Floor(0.35, 0.3)), 1.0),
    "hits walls": (
        block(0.2, 0.8),
        sp.Room(sp.Floor(0.4, 0.3), left_wall=sp.Wall(0.01), right_wall=sp.Wall(0.2)),
        1.0,
    ),
    "rests": (block(0.4, 0.4), sp.Room(sp.Floor(0.9, 0.9)), 0.3),
}


@pytest.mark.parametrize("name", PLACES)
def test_elements_that_bear_next_to_nothing_change_next_to_nothing(name):
    """A spring of 10⁻¹² N/(kg m) keeps the second kernel at work to the end."""
    body, place, scale = PLACES[name]
    motion = SHAKEN.scaled(scale)
    weak = planar(
        (0.0, 0.0),
        LEFT,
        stiffness=(1e-12, 1e-12),
        slack_plus=(0.0, 0.0),
        slack_minus=(0.0, 0.0),
    )
    one, other = bare(body, place, motion), held(body, place, motion, weak)
    for name in ("outcome", "floor_impacts", "wall_impacts"):
        assert other.result[name] == one.result[name]
    assert [event.kind for event in other.events] == [event.kind for event in one.events]
    times = [event.time for event in one.events]
    assert [event.time for event in other.events] == pytest.approx(times, abs=1e-6)
    assert other.history[:, 2:6] == pytest.approx(one.history[:, 2:6], abs=1e-5)
    assert other.result["peak_tilt"] == pytest.approx(one.result["peak_tilt"], abs=1e-7)
    assert other.result["peak_slide"] == pytest.approx(one.result["peak_slide"], abs=1e-7)


@pytest.mark.parametrize("name", PLACES)
def test_without_elements_the_first_kernel_does_the_work(name):
    body, place, scale = PLACES[name]
    motion = SHAKEN.scaled(scale)
    one, other = bare(body, place, motion), held(body, place, motion)
    assert np.array_equal(one.history, other.history)


@pytest.mark.parametrize("name", PLACES)
def test_tighter_settings_give_the_same_run(name):
    body, place, scale = PLACES[name]
    motion = SHAKEN.scaled(scale)
    b, h = -body.corners[0][0], -body.corners[0][1]
    belt = axial((-b, h), (-b - 0.3, 2 * h), length=0.3, stiffness=1500.0, damping=5.0, slack_plus=0.01)
    pole = planar(
        (0.0, h),
        CEILING,
        stiffness=(2000.0, 800.0),
        slack_plus=(np.inf, 0.0),
        slack_minus=(-0.05 * G / 2000.0, 0.0),
        friction=0.4,
    )
    coarse = held(body, place, motion, belt, pole, tolerance=1e-7)
    fine = held(body, place, motion, belt, pole, tolerance=1e-11, max_step=motion.dt / 4)
    assert coarse.result["outcome"] == fine.result["outcome"]
    assert coarse.result["peak_tilt"] == pytest.approx(fine.result["peak_tilt"], abs=2e-5)
    assert coarse.result["peak_slide"] == pytest.approx(fine.result["peak_slide"], abs=2e-5)
    for force in ("peak_pull", "peak_push", "peak_shear"):
        assert coarse.devices[force] == pytest.approx(fine.devices[force], rel=2e-3, abs=1e-3)
