"""Assessments of inventories: what rows come to, joins of places, summaries, the command."""

from __future__ import annotations

import csv
import json
import math
from collections import defaultdict
from pathlib import Path

import duckdb
import numpy as np
import pyarrow.parquet as pq
import pytest
from commands import cli
from inventories import CITY, HEADER, city, digests, pieces, rows_of_results, table, verified

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.assess import memory_of
from stayput.inventory.report import expected, storey_map
from stayput.inventory.scenarios import read_scenario_file, read_scenarios
from stayput.inventory.summary import Total
from stayput.measures import MEASURES, element_rows, hold
from stayput.model.flat_fields import case_columns
from stayput.model.state import State
from stayput.montecarlo.sampling import drawn_body, drawn_place, drawn_surfaces, draws, rows_of

ROWS = [
    "shelf,bookcase,,,,,0.02,office,3,wedge;sheet+tension_pole,1000;5000,4,20000",
    "chest,chest,,,,vinyl,0.1,2 wood,2,wedge,,1,",
    "box,,0.4,1.2,50,0.5;0.4,,,,sheet,0,2,100",
]


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    folder = tmp_path_factory.mktemp("small")
    bad = ["shelf,chest,,,,,,,,,,,", "bad,,-1,1,1,,,,,,,,"]
    return assess(table(folder, ROWS + bad), city(folder), folder / "out", threads=2, progress=False)


def test_a_row_says_what_a_verification_says(small):
    row = rows_of_results(small)[0]
    both = {"combine": [{"type": "anti_slip_sheet"}, {"type": "tension_pole"}], "name": "sheet+tension_pole"}
    verdict = verified(
        gap=0.02,
        shaking={"building": {"storeys": 4, "structure": "steel"}, "storey": 3},
        measures=[{"type": "wedge_stopper", "name": "wedge"}, both],
    )
    told = {one.option.name: one for one in verdict.options}
    assert [option["name"] for option in row["options"]] == ["none", "wedge", "sheet+tension_pole"]
    for option in row["options"]:
        of = told[option["name"]]
        for event, found in of.probabilities.items():
            ends = option[event], option[f"{event}_low"], option[f"{event}_high"]
            assert ends == (found.estimate, found.low, found.high)
        assert (option["slide_median"], option["slide_p90"]) == (of.slide.median, of.slide.p90)
    assert (row["best"], row["finding"]) == ("sheet+tension_pole", "may_be_chance")
    assert verdict.best.option.name == "none"  # which no set clearly betters
    assert row["intensity"] == verdict.intensity == 6.0


def test_rows_have_losses_and_what_is_best(small):
    shelf, chest, box = rows_of_results(small)
    assert shelf["expected_loss"] == 4 * 20000 * shelf["overturned"]
    assert shelf["risk_reduction"] == shelf["overturned"] - shelf["best_overturned"]
    assert chest["expected_loss"] is None
    assert chest["best_by_cost"] is None
    assert box["building"] is None
    assert box["storey"] is None
    assert chest["building"] == "2 wood"
    assert [row["row"] for row in (shelf, chest, box)] == [2, 3, 4]


def test_no_row_is_dropped(small):
    told = small.rejects.to_pylist()
    assert [row["row"] for row in told] == [5, 6]
    assert "row 2" in told[0]["reason"]
    assert "width is -1" in told[1]["reason"]
    facts = small.facts
    assert facts["rows"] == facts["pieces"] + facts["rejects"] + facts["empty rows"]
    assert (small.folder / "rejects.csv").read_text().count("\n") == 3


def test_duckdb_reads_the_results(small):
    base, each = duckdb.connect(), f"FROM '{small.folder}/pieces/*.parquet'"
    assert base.execute(f"SELECT id {each} ORDER BY row").fetchall() == [("shelf",), ("chest",), ("box",)]
    options = f"SELECT unnest(options, recursive := true) {each}"
    assert base.execute(f"SELECT count(*) FROM ({options})").fetchone() == (7,)


def test_parts_say_what_they_are(small):
    schema = pq.read_schema(next((small.folder / "pieces").glob("*.parquet")))
    told = json.loads(schema.metadata[b"stayput"])
    assert told["version"] == sp.__version__
    (scenario,) = told["scenarios"]
    assert (scenario["seed"], scenario["motions"], scenario["samples"]) == (1, 3, 2)
    assert scenario["suite"]
    assert b"about" in schema.field("overturned").metadata


def test_the_report_stands_alone(small):
    page = (small.folder / "report.html").read_text()
    assert '<table class="map">' in page
    assert "http" not in page.replace("http-equiv", "")
    assert "shelf" in page
    assert "row 2" in page
    assert "Best for its cost" in page
    assert "the ground at JMA intensity 6.00" in page


def test_the_scenarios_own_building_is_named_in_the_reports_language(tmp_path):
    stated = 'building = { storeys = 8, structure = "steel" }\nstorey = 1'
    own = CITY.replace("intensity = 6.0", f"intensity = 6.0\n{stated}")
    file = table(tmp_path, ["a,bookcase,3,"], "id,preset,storey,building")
    done = assess(file, city(tmp_path, own), tmp_path / "out", progress=False)
    english, japanese = (done.report(language).read_text("utf-8") for language in ("en", "ja"))
    assert ">8-storey steel building<" in english
    assert "8-storey steel buildi…" not in english
    assert done.summary.worst[0]["building"] == "8-storey steel building"
    assert "storey" not in japanese.partition("<body>")[2]
    assert japanese.count(">8階建て（鉄骨造）<") == 2  # in a map and a table


def test_a_map_shows_every_storey_and_whole_names():
    long = "a & b <of a very long name, that goes on>"
    total = Total(rows=1, pieces=4, fallen=defaultdict(float, {"": 1.0, "_best": 0.5}))
    shown = storey_map({("10 RC", 7): total, ("2 wood", 2): total, (long, 1): total, ("", 0): total}, False)
    assert [row["floor"][0] for row in shown["rows"]] == [*(f"{n}F" for n in range(7, 0, -1)), "ground"]
    assert [english for english, _ in shown["buildings"]] == ["no building", "2 wood", "10 RC", long]
    cells = [cell["shown"] for row in shown["rows"] for cell in row["cells"] if cell is not None]
    assert cells == ["25"] * 4


def test_summaries_add_up(small):
    rows = rows_of_results(small)
    total = small.summary.events["city"]
    assert total.pieces == 7
    assert total.fallen[""] == pytest.approx(sum(row["count"] * row["overturned"] for row in rows))
    assert total.fallen[""] == pytest.approx(sum(one.fallen[""] for one in small.summary.places.values()))


def test_pieces_that_are_alike_are_simulated_once(tmp_path):
    done = assess(table(tmp_path, pieces(400)), city(tmp_path), tmp_path / "out", progress=False)
    assert done.facts["choices"] == 1200
    assert done.facts["units"] == 60  # 10 bodies, of which each meets 2 storeys; 3 options
    assert done.runs == 60 * 6


def test_neither_threads_nor_memory_nor_parts_change_a_bit(tmp_path, monkeypatch):
    inventory, scenario = table(tmp_path, pieces(60)), city(tmp_path)
    one = assess(inventory, scenario, tmp_path / "one", threads=1, progress=False)
    monkeypatch.setattr("stayput.inventory.work.SECONDS", 0.001)
    monkeypatch.setattr("stayput.inventory.work.SAVE_AFTER", 0.0)
    other = assess(inventory, scenario, tmp_path / "other", threads=4, memory="256MB", progress=False)
    assert digests(one.folder) == digests(other.folder)


@pytest.mark.parametrize("what", ["inventory", "scenario", "slide limit", "version of stayput"])
def test_another_assessment_is_not_mixed_in(tmp_path, monkeypatch, what):
    inventory, scenario, more = table(tmp_path, pieces(3)), city(tmp_path), {}
    assess(inventory, scenario, tmp_path / "out", progress=False)
    before = digests(tmp_path / "out")
    match what:
        case "inventory":
            table(tmp_path, pieces(4))
        case "scenario":
            city(tmp_path, CITY.replace("seed = 1", "seed = 2"))
        case "slide limit":
            more = {"slide_limit": 0.2}
        case _:
            monkeypatch.setattr(sp, "__version__", "0.0.0")
    with pytest.raises(sp.InputError, match=f"another {what}"):
        assess(inventory, scenario, tmp_path / "out", progress=False, **more)
    assert digests(tmp_path / "out") == before


STATION = '\n[station]\nlat = {lat}\nlon = {lon}\nevent = "quake"\n'


def test_a_file_is_no_folder_for_results(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(sp.InputError, match=r"it must be a folder, and '.*notes\.txt' is a file"):
        assess(table(tmp_path, ROWS), city(tmp_path), tmp_path / "notes.txt" / "deep" / "out", progress=False)
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_each_piece_takes_the_nearest_station(tmp_path):
    folder = tmp_path / "quake"
    folder.mkdir()
    city(folder, CITY + STATION.format(lat=35.0, lon=135.0), "a.toml")
    city(folder, CITY.replace("6.0", "5.0") + STATION.format(lat=36.0, lon=135.0), "b.toml")
    rows = ["p,chest,35.1,135.2", "q,chest,35.9,134.9", "r,chest,,"]
    inventory = table(tmp_path, rows, "id,preset,lat,lon")
    done = assess(inventory, folder, tmp_path / "out", progress=False)
    found = [(row["id"], row["event"], row["station"], row["intensity"]) for row in rows_of_results(done)]
    assert found == [("p", "quake", "a", 6.0), ("q", "quake", "b", 5.0)]
    assert "lat is missing" in done.rejects.to_pylist()[0]["reason"]


def test_scenarios_without_a_station_are_events_for_all(tmp_path):
    folder = tmp_path / "events"
    folder.mkdir()
    city(folder, CITY, "a.toml")
    city(folder, CITY.replace("6.0", "5.0"), "b.toml")
    done = assess(table(tmp_path, pieces(5)), folder, tmp_path / "out", progress=False)
    assert [row["event"] for row in rows_of_results(done)] == ["a", "b"] * 5
    assert set(done.summary.events) == {"a", "b"}
    city(folder, CITY + STATION.format(lat=35.0, lon=135.0), "c.toml")
    with pytest.raises(sp.InputError, match=r"a\.toml: station is missing"):
        read_scenarios(folder)


@pytest.mark.parametrize("kind", [None, *MEASURES])
def test_rows_by_the_column_are_those_of_each_draw(kind):
    body = sp.Body(0.4, 1.8, 120.0, (0.01, 0.05), inertia=40.0)
    room = sp.Room(sp.Floor(0.4, 0.3, 0.5, 0.4, 0.9), sp.Wall(0.02), sp.Wall(1.0), sp.Ceiling(2.4))
    measures = (MEASURES[kind](),) if kind else ()
    hold(body, room, measures)
    rows = rows_of(body, room, measures, draws(4, 5, 3), 9.81)
    cases, elements, masses = [], [], []
    for draw in (one for row in draws(4, 5, 3) for one in row):
        bought = [measure.fitted_to(body) for measure in measures]
        held = hold(drawn_body(body, draw), drawn_place(room, draw), bought)
        cases.append(case_columns(held.body, drawn_surfaces(held.room, draw), State(), 9.81))
        elements.append(element_rows(held, draw.strength))
        masses.append(held.body.mass)
    wanted = np.concatenate(cases)
    for name in wanted.dtype.names:
        np.testing.assert_array_equal(rows.cases[name], wanted[name])
    assert rows.elements.tobytes() == np.stack(elements).tobytes()
    np.testing.assert_array_equal(rows.masses, masses)


def test_a_precision_stops_where_it_is_reached(tmp_path):
    text = CITY.replace("samples = 6", "samples = 96\nprecision = 0.2").replace("count = 3", "count = 12")
    rows = ["still,,3.0,0.5,100,,,,,,,,", "shaky,,0.35,1.8,100,,,,,,,,"]
    scenario = city(tmp_path, text.split("[[measures]]")[0])
    done = assess(table(tmp_path, rows), scenario, tmp_path / "out", progress=False)
    still, shaky = rows_of_results(done)
    assert still["runs"] == 16  # two looks: 0 of 16 is known to within 0.2
    assert 16 < shaky["runs"] < 96
    assert done.runs == still["runs"] + shaky["runs"]


def test_the_report_rounds_as_the_terminal_does():
    best = {"_best": 0.4, "_best_low": 0.1, "_best_high": 0.9}
    fallen = defaultdict(float, {"": 8.2, "_low": 7.1, "_high": 9.3, **best})
    total = Total(rows=1, pieces=10, fallen=fallen)
    assert expected(total)[0].startswith("8.2 of 10 pieces are expected to overturn: 82 % (71 to 93 %)")
    assert "clearly helps, 0.4: 4 % (1 to 9 %)." in expected(total)[0]
    assert expected(total)[1].startswith("10点のうち8.2点が転倒する見込みです：82%（71～93%）。")
    assert "8.2 of 10 pieces" in expected(total)[0]


@pytest.mark.parametrize("start", ["=", "+", "-", "@"])
def test_no_text_of_the_results_runs_in_a_spreadsheet(tmp_path, start):
    scenario = city(tmp_path, CITY, f"{start}city.toml")
    file = table(tmp_path, ["p,chest", f"{start}1,nothing"], "id,preset")
    assess(file, scenario, tmp_path / "out", progress=False)
    cells = []
    for written in ("summary.csv", "rejects.csv"):
        with (tmp_path / "out" / written).open(newline="", encoding="utf-8") as opened:
            cells += [cell for row in csv.reader(opened) for cell in row]
    assert f"'{start}city" in cells
    assert f"'{start}1" in cells
    assert not [cell for cell in cells if cell.startswith(("=", "+", "-", "@"))]


@pytest.mark.parametrize(("text", "found"), [("2GB", 2**31), ("512 MiB", 2**29), ("1e9", None), ("1", None)])
def test_memory_is_read(text, found):
    if found is None:
        with pytest.raises(sp.InputError, match="emory"):
            memory_of(text)
    else:
        assert memory_of(text) == found


def test_the_command_prints_what_it_did(tmp_path):
    inventory = table(tmp_path, ROWS, f"{HEADER},owner", "i.csv")
    inventory.write_text(inventory.read_text().replace(",20000", ",20000,me"))
    line = "assess", inventory, "--scenario", city(tmp_path), "--out", tmp_path / "out"
    told = cli(*line)
    assert told.exit_code == 0, told.output
    assert "owner" in told.output
    record = json.loads(cli(*line, "--json").stdout)
    assert record["runs"] == 0
    assert record["rejects"] == 2
    assert math.isfinite(record["events"]["city"]["expected_overturned"])
    assert Path(record["folder"]) == tmp_path / "out"


def test_rejects_alone_are_a_failure(tmp_path):
    file = table(tmp_path, ["a,-1", "b,x"], "id,width")
    told = cli("assess", file, "--scenario", city(tmp_path), "--out", tmp_path / "out")
    assert told.exit_code == 2
    assert told.stderr.startswith("No row of the inventory could be assessed; ")
    assert "Not assessed: 2 rows" in told.stdout
    assert (tmp_path / "out" / "rejects.csv").read_text().count("\n") == 3


def test_the_example_runs(tmp_path):
    examples = Path(__file__).parents[2] / "examples" / "city"
    text = (examples / "city.toml").read_text(encoding="utf-8")
    quick = text.replace("count = 80", "count = 10").replace("[uncertainty]", "[uncertainty]\nsamples = 40")
    scenario = city(tmp_path, f"dimensions = 2\n{quick}")
    done = assess(examples / "inventory.csv", scenario, tmp_path / "out", progress=False)
    assert done.facts["rejects"] == 0
    page = done.report("en").read_text(encoding="utf-8")
    assert page.count('<table class="map">') == 2  # the measures are seen to help
    assert f"{done.summary.events['city'].loss:,.0f} JPY" in page


@pytest.mark.parametrize(("floor", "wall"), [("carpet", "plasterboard"), ("vinyl", "concrete")])
def test_floor_and_wall_of_a_row_are_those_of_a_verification(tmp_path, floor, wall):
    row = f"shelf,bookcase,{floor},0.03,{wall},l_bracket;gel_mats"
    file = table(tmp_path, [row], "id,preset,floor,gap,wall,measures")
    done = assess(file, city(tmp_path), tmp_path / "out", threads=1, progress=False)
    (found,) = rows_of_results(done)
    measures = [{"type": "l_bracket"}, {"type": "gel_mats"}]
    verdict = verified(gap=0.03, wall=wall, floor=floor, measures=measures)
    not_possible = {one["name"] for one in found["not_possible"]}
    assert not_possible == {one.option.name for one in verdict.impossible}
    assert not_possible == ({"gel_mats"} if floor == "carpet" else set())
    slides = {one.option.name if one.option.measures else "none": one.slide.median for one in verdict.options}
    assert {option["name"]: option["slide_median"] for option in found["options"]} == slides


PLAIN = "[shaking]\nintensity = 5.5\n[uncertainty]\nsamples = 40\n"


@pytest.mark.parametrize(
    ("added", "key"),
    [('installation = "as people install it"\n', "installation"), ("[everyday]\nload = 20.0\n", "everyday")],
)
def test_what_only_a_verification_uses_is_said(tmp_path, added, key):
    file = tmp_path / "quake.toml"
    file.write_text(PLAIN + added, encoding="utf-8")
    with pytest.warns(sp.InputWarning, match=rf"quake.toml.*{key}.* is not used"):
        read_scenario_file(file)


def test_a_start_inside_the_wall_is_refused_as_in_a_verification(tmp_path):
    scenario = city(tmp_path, CITY.replace("0.05", "0.02") + "[initial]\nslide = -0.5\n")
    file = table(tmp_path, ["a,0.4,0.9,1.8,80", "b,0.4,,1.8,80"], "id,width,length,height,mass")
    done = assess(file, scenario, tmp_path / "out", progress=False)
    assert [row["id"] for row in done.rejects.to_pylist()] == ["a", "b"]
