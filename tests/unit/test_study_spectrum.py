"""The study of spectra: what it gives, and that its numbers are those of single runs."""

import math

import numpy as np
import pytest
import xarray as xr

import stayput as sp
from stayput.studies.spectrum import spectrum
from stayput.studies.spectrum_runs import falling_ranges

PERIODS, SLENDERNESS = [1.0, 1.8, 3.0], [0.2, 0.4]


@pytest.fixture(scope="module")
def study():
    return spectrum(periods=PERIODS, slenderness=SLENDERNESS, step=0.05)


def body_of(alpha, period):
    R = 3.0 * 9.80665 / (4.0 * (2.0 * math.pi / period) ** 2)
    return sp.Body(2.0 * R * math.sin(alpha), 2.0 * R * math.cos(alpha), 100.0)


def record(scale):
    return sp.near_fault().component("x").padded(after=5.0).scaled(scale)


@pytest.mark.parametrize("place", [1, 2])
@pytest.mark.parametrize("period", PERIODS)
def test_the_record_is_that_of_single_runs(study, place, period):
    point = study.data.isel(curve=place).sel(period=period)
    body, room = body_of(SLENDERNESS[place - 1], period), sp.Room(sp.Floor(3.0, 3.0))
    assert float(point["slenderness"]) == SLENDERNESS[place - 1]
    assert math.hypot(body.width, body.height) == pytest.approx(2.0 * float(point["half_diagonal"]))
    run = sp.simulate(body, room, record(1.0))
    assert run.overturned is bool(point["overturned"])
    assert run.peak_tilt == pytest.approx(float(point["peak_tilt"]))
    for lower, upper, direction in zip(
        *(point[n].values for n in ("lower", "upper", "direction")), strict=True
    ):
        if direction:
            assert sp.simulate(body, room, record(lower)).overturned is bool(direction < 0)
            assert sp.simulate(body, room, record(upper)).overturned is bool(direction > 0)


def test_ratios_at_a_landing_are_stated(study):
    stated = study.data["restitution"].values
    assert stated == pytest.approx([0.9, *(1.0 - 1.5 * np.sin(SLENDERNESS) ** 2)])


def test_figures_and_summary(study):
    assert list(study.figures) == ["pulse", "record", "rocking"]
    assert [len(figure.axes) for figure in study.figures.values()] == [1, 2, 1]
    islands = study.data["islands"].isel(curve=slice(1, None))
    assert study.quantities["bodies"].value == islands.size
    assert study.quantities["with_islands"].value == int((islands > 0).sum())
    assert list(study.summary.columns) == ["quantity", "published", "stayput", "difference"]
    assert list(study.summary["published"][:3]) == ["3.032", "6.743", "7.493"]


def test_it_writes_what_can_be_read(study, tmp_path):
    files = study.write(tmp_path)
    assert all(path.stat().st_size > 0 for path in files)
    read = xr.load_dataset(tmp_path / "spectrum.nc", engine="scipy")
    assert all(read[name].attrs["long_name"] for name in read.data_vars)
    assert np.array_equal(read["amplitude"], study.data["amplitude"], equal_nan=True)


def test_ranges_of_falling():
    point = xr.Dataset(
        {
            "amplitude": ("edge", [1.0, 2.0, 3.0]),
            "direction": ("edge", [1, -1, 1]),
            "falls_at_lowest": False,
            "falls_at_highest": True,
        },
        attrs={"lowest_amplitude": 0.5, "highest_amplitude": 4.0},
    )
    assert falling_ranges(point) == [(1.0, 2.0), (3.0, 4.0)]
    above = point.isel(edge=slice(1, None)).assign(falls_at_lowest=True)
    assert falling_ranges(above) == [(0.5, 2.0), (3.0, 4.0)]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"slenderness": []}, "one or more"),
        ({"slenderness": [0.3, 0.2]}, "increasing"),
        ({"slenderness": [2.0]}, "Slenderness"),
        ({"periods": [0.0, 1.0]}, "Period"),
        ({"periods": [1.0]}, "two or more"),
        ({"step": 0.5}, "Step"),
        ({"motion": sp.Motion(0.01, np.zeros(10), name="none")}, "is still"),
    ],
)
def test_refusals(changes, words):
    with pytest.raises(sp.InputError, match=words):
        spectrum(**{"periods": [1.0, 2.0], "slenderness": [0.2], "step": 0.2} | changes)


def test_any_record_of_any_strength():
    weak = sp.sine(0.05, 1.0, 5.0)
    study = spectrum(weak, periods=[1.0, 2.0], slenderness=[0.2], step=0.1)
    assert not np.nan_to_num(study.data["overturned"]).any()
    assert not np.nan_to_num(study.data["peak_tilt"]).any()
    assert study.quantities["falls"].value == 0
    with_vertical = spectrum(sp.near_fault(), periods=[1.0, 2.0], slenderness=[0.3], step=0.1)
    without = spectrum(sp.near_fault().component("x"), periods=[1.0, 2.0], slenderness=[0.3], step=0.1)
    assert not with_vertical.data["amplitude"][1:].equals(without.data["amplitude"][1:])
