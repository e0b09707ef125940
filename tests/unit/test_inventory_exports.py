"""Results in other formats."""

from __future__ import annotations

import csv
import json

import pytest
from commands import cli
from inventories import city, rows_of_results, table

import stayput as sp
from stayput.inventory import assess

ROWS = ["a,bookcase,35.1,135.2,+x", "本棚,bookcase,35.2,225.5,", "c,chest,,,"]


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    folder = tmp_path_factory.mktemp("exports")
    file = table(folder, ROWS, "id,preset,lat,lon,owner")
    return assess(file, city(folder), folder / "out", export="csv,geojson", progress=False)


def test_a_csv_has_the_rows_of_the_results(exported):
    with (exported.folder / "pieces.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    for read, row in zip(rows, rows_of_results(exported), strict=True):
        assert read["id"] == row["id"]
        assert float(read["overturned"]) == row["overturned"]
        assert read["best"] == row["best"]
        assert "options" not in read


def test_a_geojson_has_a_point_for_each_place(exported):
    content = json.loads((exported.folder / "pieces.geojson").read_text(encoding="utf-8"))
    assert content["type"] == "FeatureCollection"
    points = [feature["geometry"] for feature in content["features"]]
    assert points[0] == {"type": "Point", "coordinates": [135.2, 35.1]}
    assert points[1]["coordinates"] == [-134.5, 35.2]  # a longitude of 225.5°
    assert points[2] is None
    assert [feature["properties"]["id"] for feature in content["features"]] == ["a", "本棚", "c"]


def test_an_export_may_follow(tmp_path):
    file = table(tmp_path, ROWS, "id,preset,lat,lon,owner")
    assess(file, city(tmp_path), tmp_path / "out", progress=False)
    done = assess(file, city(tmp_path), tmp_path / "out", export="geojson", progress=False)
    assert done.runs == 0
    assert (done.folder / "pieces.geojson").exists()
    assert not list((done.folder / "work" / "drafts").iterdir())


def test_that_a_map_has_no_points_is_said(tmp_path):
    file = table(tmp_path, ["a,chest"], "id,preset")
    line = "assess", file, "--scenario", city(tmp_path), "--out", tmp_path / "out", "--export"
    assert "Without coordinates: 1 piece; on a map they have no point." in cli(*line, "geojson").stdout
    assert "Without coordinates" not in cli(*line, "csv").stdout


def test_other_formats_are_refused(tmp_path):
    file = table(tmp_path, ["a,chest"], "id,preset")
    with pytest.raises(sp.InputError, match="'csv', 'geojson'"):
        assess(file, city(tmp_path), tmp_path / "out", export="shp", progress=False)


def test_a_piece_with_an_id_keeps_its_name(tmp_path):
    rows = ["1,本棚 大,bookcase,,35.1,135.2", "2,,bookcase,,35.1,135.2", "3,=壊れた棚,bookcase,-1,35.1,135.2"]
    file = table(tmp_path, rows, "No.,品名,preset,height,lat,lon")
    done = assess(file, city(tmp_path), tmp_path / "out", export="csv,geojson", progress=False)
    assert [row["name"] for row in rows_of_results(done)] == ["本棚 大", None]
    exported = list(csv.DictReader((done.folder / "pieces.csv").read_text("utf-8-sig").splitlines()))
    assert [row["name"] for row in exported] == ["本棚 大", ""]
    points = json.loads((done.folder / "pieces.geojson").read_text("utf-8"))["features"]
    assert [point["properties"]["name"] for point in points] == ["本棚 大", None]
    (reject,) = done.rejects.to_pylist()
    assert (reject["id"], reject["name"]) == ("3", "=壊れた棚")
    assert "4,3,'=壊れた棚," in (done.folder / "rejects.csv").read_text("utf-8-sig")
    for language in ("en", "ja"):
        text = done.report(language).read_text("utf-8")
        assert ">1 本棚 大<" in text
        assert ">3 =壊れた棚<" in text


def test_an_id_made_of_a_name_does_not_repeat_it(tmp_path):
    file = table(tmp_path, ["本棚,bookcase"], "品名,preset")
    done = assess(file, city(tmp_path), tmp_path / "out", progress=False)
    assert [(row["id"], row["name"]) for row in rows_of_results(done)] == [("本棚 #2", "本棚")]
    assert ">本棚 #2<" in done.report("ja").read_text("utf-8")
