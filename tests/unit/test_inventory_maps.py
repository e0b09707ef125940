"""Shake maps: JMA's intensity or Sa where each piece stands, and motions that have it."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from inventories import city, rows_of_results, table

import stayput as sp
from stayput.fragility import spectral_acceleration
from stayput.inventory import assess
from stayput.inventory.scenarios import read_scenarios
from stayput.inventory.shakemap_files import read_shakemap
from stayput.montecarlo.hazard import factors_to_level_zero

GRID = ["35,135,5", "35,136,6", "36,135,6", "36,136,7"]


def test_a_shake_map_is_bilinear_on_a_grid(tmp_path):
    file = table(tmp_path, GRID, "lat,lon,intensity", "map.csv")
    found = read_shakemap(file)
    assert found.at(35.0, 135.0).level == 5.0
    assert found.at(35.5, 135.5).level == 6.0
    assert found.at(35.25, 135.25).level == 5.5
    assert found.at(36.0, 136.0).level == 7.0
    with pytest.raises(sp.InputError, match="lat on the shake map is 37"):
        found.at(37.0, 135.5)


def test_a_shake_map_of_any_places_gives_the_nearest(tmp_path):
    file = table(tmp_path, [*GRID[:3], "35.5,135.6,6.66"], "lat,lon,intensity", "map.csv")
    assert read_shakemap(file).at(35.5, 135.5).level == 6.7


def test_a_shake_map_says_how_strong_it_shakes(tmp_path):
    grid = table(tmp_path, GRID, "lat,lon,intensity", "map.csv")
    inventory = table(tmp_path, ["p,chest,35,135", "q,chest,35.5,135.5", "r,chest,1,1"], "id,preset,lat,lon")
    done = assess(inventory, city(tmp_path), tmp_path / "out", shakemap=grid, progress=False)
    assert [row["intensity"] for row in rows_of_results(done)] == [5.0, 6.0]
    assert "shake map" in done.rejects.to_pylist()[0]["reason"]


G = 9.80665
SA_GRID = ["35,135,0.1", "35,136,0.4", "36,135,0.4", "36,136,1.6"]


def sa(motion, period, component):
    return sp.response_spectrum(motion, [period], 0.05, component).sa[0] / G


@pytest.fixture
def floors(monkeypatch):
    """What shakes the pieces of a run, in order."""
    work, seen = sys.modules["stayput.inventory.work"], {}

    def spy(units, measures, floor, sampling, kind, of=work.evaluate):
        seen[id(floor)] = floor
        return of(units, measures, floor, sampling, kind)

    monkeypatch.setattr(work, "evaluate", spy)
    return seen


@pytest.mark.parametrize("period", [0.05, 0.3, 1.0])
def test_motions_have_the_sa_of_the_map(tmp_path, floors, period):
    grid = table(tmp_path, SA_GRID, f"lat,lon,sa_{period:g}", "map.csv")
    inventory = table(tmp_path, ["p,chest,35,135", "q,chest,35.5,135.5"], "id,preset,lat,lon")
    scenario = city(tmp_path)
    done = assess(inventory, scenario, tmp_path / "out", shakemap=grid, threads=1, progress=False)
    ground = read_scenarios(scenario).all[0].ground
    for row, floor, wanted in zip(rows_of_results(done), floors.values(), (0.1, 0.4), strict=True):
        assert row["sa"] == pytest.approx(wanted, rel=0.03)
        felt = [motion.scaled(float(k)) for motion, k in zip(ground, floor.scales, strict=True)]
        for motion in felt:
            x, y = sa(motion, period, "x"), sa(motion, period, "y")
            assert np.sqrt(x * y) == pytest.approx(row["sa"], rel=1e-9)
            assert x != pytest.approx(row["sa"], rel=1e-3)  # the components scatter about it
        assert row["intensity"] == pytest.approx(np.median([motion.intensity for motion in felt]))
    (told,) = done.folder.glob("report.html")
    assert f"Sa at {period:g} s, 5 % damping, geometric mean" in told.read_text(encoding="utf-8").replace(
        "\N{NO-BREAK SPACE}", " "
    )


def test_a_motion_of_one_component_has_its_sa():
    motion = sp.sine(5.0, 1.0, 10.0)
    assert set(motion.components) == {"x"}
    (factor,) = factors_to_level_zero(spectral_acceleration(0.5), [motion])
    assert sa(motion.scaled(factor), 0.5, "x") == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize(
    "header",
    [
        "lat,lon",
        "lat,lon,pga",
        "lat,lon,sa(0.3)",
        "lat,lon,sa_-1",
        "lat,intensity,sa_0.3",
        "lat,lon,sa_0.3,sa_1.0",
        "lat,lon,lon,sa_0.3",
        "",
    ],
)
def test_a_map_tells_one_thing(tmp_path, header):
    file = table(tmp_path, ["35,135,0.4"], header, "map.csv")
    with pytest.raises(sp.InputError, match=r"must be lat, lon and one of intensity|unit must be one of"):
        read_shakemap(file)


@pytest.mark.parametrize(
    ("header", "row", "told"),
    [
        ("sa_20", "35,135,1", "the period 20 s; it must be 0.01 to 10 s"),
        (
            "sa_0.3",
            "35,135,40",
            "sa_0.3 in row 2 of the shake map is 40 g; it must be between",
        ),
        ("sa_0.3", "35,135,0", "sa_0.3 in row 2 of the shake map is 0 g"),
        ("sa_0.3", "35,135,nan", "is nan; it must be a finite number"),
        ("sa_0.3", "35,135,0.4 g", "is '0.4 g'; it must be a number"),
        ("sa_0.3", "35,135,,", "4 cells; it must have 3"),
        ("intensity", "35,135,10", "is 10; it must be between -3 and 9"),
        ("intensity", "35,135,5\n35.0,135,6", "Row 3 of the shake map is at 35°, 135°, as row 2 is"),
    ],
)
def test_a_bad_map_is_refused(tmp_path, header, row, told):
    file = table(tmp_path, [row], f"lat,lon,{header}", "map.csv")
    with pytest.raises(sp.InputError) as error:
        read_shakemap(file)
    assert told in str(error.value)
