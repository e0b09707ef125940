"""Presets of furniture: sizes of the table they were taken from."""

import numpy as np
import pytest

import stayput as sp
from stayput.model.body import FURNITURE, Body


@pytest.mark.parametrize(
    ("name", "width", "height", "lightest", "heaviest"),
    [
        ("refrigerator", 0.68, 1.82, 90, 120),
        ("wardrobe", 0.60, 1.90, 80, 150),
        ("bookcase", 0.30, 1.80, 150, 250),
        ("empty bookcase", 0.30, 1.80, 35, 35),
        ("television", 0.27, 0.76, 18, 18),
        ("cupboard", 0.40, 1.80, 100, 100),
        ("chest", 0.42, 1.365, 81, 81),
        ("vending machine", 0.83, 1.83, 250, 450),
        ("server rack", 1.00, 2.00, 120, 900),
        ("upright piano", 0.62, 1.25, 230, 230),
    ],
)
def test_preset(name, width, height, lightest, heaviest):
    preset = FURNITURE[name]
    assert (preset.width, preset.height) == (width, height)
    assert lightest <= preset.mass <= heaviest
    Body(preset.width, preset.height, preset.mass)


def test_a_carcass_is_not_heavier_than_the_loaded_piece():
    for preset in FURNITURE.values():
        assert preset.carcass_mass is None or preset.carcass_mass <= preset.mass


def test_the_base_is_as_wide_as_its_corners_are_apart():
    body = Body(0.5, 1.6, 100.0, base_heights=(0.0, -0.01), base_insets=(0.03, 0.05), cg_offset=(0.02, 0.0))
    (left, _), (right, _), *_ = body.corners
    assert body.base_width == pytest.approx(right - left) == pytest.approx(0.42)
    assert Body(0.5, 1.6, 100.0).base_width == 0.5


def test_a_mass_is_asked_for_wherever_a_body_is_made():
    with pytest.raises(TypeError, match="mass"):
        sp.Body(0.4, 1.8)  # pyright: ignore[reportCallIssue]
    for furniture in (
        {"width": 0.4, "height": 1.8},
        [{"name": "box", "width": 0.4, "length": 0.9, "height": 1.8}],
    ):
        with pytest.raises(sp.InputError, match="mass") as refused:
            sp.Scenario.parse({"furniture": furniture, "shaking": {"builtin": "near-fault"}})
        assert "mass" in refused.value.told("ja")


def test_a_body_without_devices_moves_alike_whatever_its_mass():
    room = sp.Room(left_wall=sp.Wall(0.05))
    runs = [
        sp.simulate(sp.Body(0.4, 1.8, mass), room, sp.near_fault().component("x")) for mass in (1.0, 100.0)
    ]
    assert runs[0].outcome == runs[1].outcome
    np.testing.assert_allclose(runs[0].tilt, runs[1].tilt, atol=1e-9)
