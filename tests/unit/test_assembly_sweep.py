"""Sweeps of several pieces over the keys of their file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import stayput as sp

TELEVISION = sp.read_scenario(Path(__file__).parents[2] / "examples" / "television.toml")


def test_a_sweep_has_the_bits_of_single_runs() -> None:
    axes = {"shaking.scale": [0.5, 1.0], "joints.strength": [100.0, 1e5]}
    data = sp.sweep(TELEVISION, axes, threads=2, progress=False)
    assert data.overturned.dims == ("shaking.scale", "joints.strength", "piece")
    assert list(data.piece.values) == ["stand", "television"]
    given = TELEVISION.model_dump(exclude_unset=True, exclude_none=True, by_alias=True)
    given["shaking"]["scale"] = 1.0
    given["joints"] = [joint | {"strength": 100.0} for joint in given["joints"]]
    run = sp.Scenario.parse(given).run()
    one = data.sel({"shaking.scale": 1.0, "joints.strength": 100.0})
    assert one.overturned.values.tolist() == [piece.overturned for piece in run.pieces]
    assert one.peak_tilt.values == pytest.approx([piece.peak_tilt for piece in run.pieces], abs=0.0)
    assert int(one.device_failures) == sum(device.failed for device in run.devices) == 2
    assert data.peak_slide.attrs["units"] == "m"


def test_one_item_of_a_list() -> None:
    axes = {"joints.strength": [1e6], "joints.shear": [1e6], "joints[1].strength": [1.0]}
    data = sp.sweep(TELEVISION, axes, progress=False)
    assert data.device_failures.values.tolist() == [[[1]]]


@pytest.mark.parametrize(
    ("axes", "said"),
    [
        ({"shakin.scale": [1.0]}, "did you mean 'shaking'"),
        ({"joints[5].strength": [1.0]}, "is no key of the file"),
        ({"title.x": [1.0]}, "is no key of the file"),
        ({"shaking.scale": ["x"]}, "must be a number"),
        ({"shaking.scale": []}, "has no values"),
        ({"shaking.scale": 1.0}, "must be a list"),
    ],
)
def test_what_is_refused(axes: dict[str, Any], said: str) -> None:
    with pytest.raises(sp.InputError, match=said):
        sp.sweep(TELEVISION, axes)
