"""Sweeps of several pieces over the keys of their file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import stayput as sp

TELEVISION = sp.read(Path(__file__).parents[2] / "examples" / "television.toml")


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
        ({"title.x": [1.0]}, "title is a table; it must be a text"),
        ({"shaking.scale": ["x"]}, "must be a number"),
        ({"shaking.scale": []}, "is empty"),
        ({"shaking.scale": 1.0}, "must be a list"),
    ],
)
def test_what_is_refused(axes: dict[str, Any], said: str) -> None:
    with pytest.raises(sp.InputError, match=said):
        sp.sweep(TELEVISION, axes)


def test_python_objects_stay_in_a_sweep() -> None:
    lone = sp.Scenario.parse({"furniture": {"width": 0.3, "height": 1.5, "mass": 60.0}})
    strong, weak = (lone.with_python(motions=sp.Suite((sp.sine(a, 1.0, 3.0),))) for a in (3.0, 0.1))
    tilts = [float(sp.sweep(one, {}, progress=False).peak_tilt) for one in (strong, weak)]
    assert tilts[0] > 0.01 > tilts[1]
    assert tilts[0] == strong.run().peak_tilt


def test_values_of_numpy_and_lists() -> None:
    lone = {"furniture": {"preset": "chest"}, "shaking": {"suite": {"count": 2}}}
    data = sp.sweep(sp.Scenario.parse(lone), {"shaking.member": np.arange(1, 3)}, progress=False)
    assert data["shaking.member"].values.tolist() == [1, 2]
    offsets = [[0.0, 0.0], [0.0, -0.2]]
    swept = sp.sweep(sp.Scenario.parse(lone), {"furniture.cg_offset": offsets}, progress=False)
    assert swept["furniture.cg_offset"].values.tolist() == [0, 1]
    for axes in ({3: [1.0]}, {"furniture[7].mass": [1.0]}):
        with pytest.raises(sp.InputError, match="is no key of the file"):
            sp.sweep(sp.Scenario.parse(lone), axes, progress=False)
    with pytest.raises(sp.InputError, match="histories is given for a sweep of a scenario"):
        sp.sweep(sp.Scenario.parse(lone), {}, histories=["tilt"], progress=False)
    with pytest.raises(sp.InputError, match="chunk is given for a sweep of a scenario"):
        sp.sweep(sp.Scenario.parse(lone), {}, chunk=0, progress=False)
    with pytest.raises(sp.InputError, match=r"option is 'progres' \(did you mean 'progress'\?\)"):
        sp.sweep(sp.Scenario.parse(lone), {}, progres=False)  # type: ignore[call-arg]
    with pytest.raises(sp.InputError, match="is no key of the file"):
        sp.sweep(TELEVISION, {"furniture[\u0660].mass": [20.0]}, progress=False)
