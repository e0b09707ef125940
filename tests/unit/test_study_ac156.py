"""The study of AC156's test beside floors: that its numbers are those of single runs, and what comes out."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import stayput as sp
from studies import ac156_runs
from studies.ac156 import ac156, passing
from studies.ac156_runs import BUILDINGS, HEIGHTS, ROOMS, TESTS, bodies, earthquakes

RECORDS = Path(__file__).parents[3] / "shared" / "motions"


@pytest.fixture(scope="module", autouse=True)
def motions_made_once():
    """Make each motion of a test once for all studies here; they are most of the time of each."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ac156_runs, "ac156_motion", cache(ac156_runs.ac156_motion))
        yield


@pytest.fixture(scope="module")
def study():
    return ac156(sds=[0.5, 1.0], tests=2, motions=4)


def test_a_pass_is_that_of_single_runs(study):
    required = sp.ac156(1.0, HEIGHTS[2])
    motions = [replace(sp.ac156_motion(required, number), y=None) for number in (1, 2)]
    room = ROOMS["no sliding"]
    for place, body in enumerate(bodies()):
        stands = not any(sp.simulate(body, room, motion).overturned for motion in motions)
        cell = study.data["passes"].sel(sds=1.0, height=1.0, floor="no sliding", test=TESTS[0].name)
        assert bool(cell[place]) is stands


def test_a_share_is_that_of_single_runs(study):
    building, body, room = BUILDINGS["10-storey RC"], bodies()[1], ROOMS["vinyl"]
    ground = [replace(motion, y=None) for motion in earthquakes(0.5, 4, 1)]
    falls = [sp.simulate(body, room, building.floor_motion(motion, 11)).overturned for motion in ground]
    cell = study.data["overturned"].sel(sds=0.5, height=1.0, floor="vinyl", building="10-storey RC")
    assert float(cell[1]) == np.mean(falls)


def test_what_passes_falls_on_roofs_of_tall_buildings(study):
    """What AC156 does not ask for below 1.3 Hz overturns what passed it."""
    roof = passing(study.data, TESTS[0].name).sel(height=1.0, building="20-storey steel")
    assert float(roof.mean()) > 0.2
    whole = passing(study.data, TESTS[2].name).sel(height=1.0, building="20-storey steel")
    assert float(whole.mean()) < float(roof.mean())
    isolated = passing(study.data, TESTS[0].name).sel(building="base-isolated 8-storey RC")
    assert float(isolated.max()) == 0.0


def test_it_writes_what_can_be_read(study, tmp_path):
    assert all(path.stat().st_size > 0 for path in study.write(tmp_path))
    read = xr.load_dataset(tmp_path / "ac156.nc", engine="scipy")
    assert np.array_equal(read["overturned"], study.data["overturned"])


@pytest.mark.skipif(not RECORDS.is_dir(), reason="the records are absent")
def test_real_records_do_the_same():
    files = ["elcentro_1940_180.AT2", "jma_kobe_1995_ns.AT2", "nishi_akashi_1995_090.AT2"]
    ground = sp.Suite(tuple(sp.read_motion(RECORDS / name) for name in files), "records")
    data = ac156(sds=[1.0], tests=2, ground=ground).data
    assert data.attrs["earthquakes"] == 3
    roof = passing(data, TESTS[0].name).sel(height=1.0, building="20-storey steel")
    assert float(roof.max()) > 0.3


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"sds": []}, "SDS"),
        ({"sds": [1.0, 0.5]}, "SDS"),
        ({"tests": 0}, "motions"),
        ({"motions": 0}, "motions"),
    ],
)
def test_refusals(changes, words):
    with pytest.raises(sp.InputError, match=words):
        ac156(**changes)
