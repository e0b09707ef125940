"""Rows of an inventory that say what is inside: as a verification follows it, and in every file."""

from __future__ import annotations

import csv
import json

import pytest
from commands import cli
from inventories import city, digests, rows_of_results, table, verified

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.items import contents_of
from stayput.saved import from_text, to_text
from stayput.scenario import Scenario

HEADER = "id,preset,contents,doors,drawers,lip,load,measures"
ROWS = [
    "books,bookcase,books,,,,,l_bracket",
    'dishes,cupboard,dishes,"hinged, latched",,,,wedge',
    "lip,bookcase,bottles,,,0.03,20;15;10,wedge",
    "bare,bookcase,,,,,,l_bracket",
]


BODY = sp.Body(0.4, 1.8, 100.0)


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    folder = tmp_path_factory.mktemp("small")
    return assess(table(folder, ROWS, HEADER), city(folder), folder / "out", threads=1, progress=False)


@pytest.fixture(scope="module")
def filled():
    data = {"furniture": {"preset": "chest"}, "contents": {"kind": "dishes", "doors": "hinged", "shelves": 4}}
    return Scenario.parse(data)


@pytest.fixture(scope="module")
def unsaid():
    return Scenario.parse({"furniture": {"preset": "chest"}})


def test_a_row_tells_what_a_verification_tells(small):
    verdict = verified(
        furniture={"preset": "bookcase", "shelves": [20.0, 15.0, 10.0]},
        contents={"kind": "bottles", "lip": 0.03},
        measures=[{"type": "wedge_stopper", "name": "wedge"}],
    )
    told = {"wedge" if one.option.measures else "none": one.contents.out for one in verdict.options}
    row = rows_of_results(small)[2]
    for option in row["options"]:
        out = told[option["name"]]
        found = [option[f"contents_out_share{end}"] for end in ("", "_low", "_high")]
        assert found == [out.estimate, out.low, out.high]
    assert row["contents_out_share"] == told["none"].estimate
    assert row["best_contents_out_share"] == told[row["best"]].estimate


def test_a_row_without_contents_has_no_share_and_all_else_as_before(small):
    books, _, _, bare = rows_of_results(small)
    assert bare["contents_out_share"] is bare["best_contents_out_share"] is None
    assert [option["contents_out_share"] for option in bare["options"]] == [None, None]
    assert 0.0 < books["contents_out_share"] <= 1.0
    for name in ("overturned", "slid", "slide_median", "best", "best_overturned", "runs"):
        assert books[name] == bare[name]


def test_summary_report_and_command_tell_the_mean_over_what_has_contents(small, tmp_path):
    rows = [row for row in rows_of_results(small) if row["contents_out_share"] is not None]
    mean = sum(row["contents_out_share"] for row in rows) / 3
    total = small.summary.events["city"]
    assert (total.filled, total.share_out()) == (3, pytest.approx(mean))
    with (small.folder / "summary.csv").open(newline="", encoding="utf-8") as file:
        (line,) = csv.DictReader(file)
    assert float(line["contents_out_share"]) == total.share_out()
    page = (small.folder / "report.html").read_text(encoding="utf-8")
    assert "Of what is inside 3 pieces" in page
    assert "Contents out with it" in page
    inventory, scenario = table(tmp_path, ROWS, HEADER), city(tmp_path)
    line = "assess", inventory, "--scenario", scenario, "--out", tmp_path / "out"
    assert "Of what is inside 3 pieces" in cli(*line).stdout
    told = json.loads(cli(*line, "--json").stdout)
    assert told["events"]["city"]["contents_out_share"] == total.share_out()


def test_neither_threads_nor_tasks_change_a_bit(small, tmp_path, monkeypatch):
    monkeypatch.setattr("stayput.inventory.work.SECONDS", 0.001)
    monkeypatch.setattr("stayput.inventory.work.MOST_UNITS", 1)
    assess(table(tmp_path, ROWS, HEADER), city(tmp_path), tmp_path / "out", threads=3, progress=False)
    assert digests(tmp_path / "out") == digests(small.folder)


def test_where_a_row_says_nothing_the_scenario_holds(filled):
    assert contents_of({}, BODY, filled) == sp.Contents("dishes", doors="hinged", shelves=4)
    assert contents_of({"contents": "none"}, BODY, filled) is None
    assert contents_of({"contents": "books", "doors": "none"}, BODY, filled) == sp.Contents(
        "books", shelves=4
    )
    other = contents_of({"load": "20;10", "lip": 0.02}, BODY, filled)
    assert other == sp.Contents("dishes", doors="hinged", lip=0.02, loads=(20.0, 10.0))


def test_a_load_is_that_of_the_contents(unsaid):
    assert contents_of({"load": "20;10"}, BODY, unsaid) is None
    cells = {"contents": "books", "load": "20;10"}
    assert contents_of(cells, BODY, unsaid) == sp.Contents("books", loads=(20.0, 10.0))
    even = contents_of({"contents": "books", "load": 25.0}, BODY, unsaid)
    assert even == sp.Contents("books", mass_share=0.25)


@pytest.mark.parametrize(
    ("cells", "message"),
    [
        ({"doors": "hinged"}, "doors is given without contents"),
        ({"lip": "0.02"}, "lip is given without contents"),
        ({"contents": "book"}, "did you mean 'books'"),
        ({"contents": "books", "doors": "glass"}, "Doors is 'glass'"),
        ({"contents": "books", "doors": "hinged", "drawers": "free"}, "is given beside doors"),
        ({"contents": "books", "lip": "3 ken"}, "plain number"),
        ({"contents": "books", "lip": "-1"}, "lip height is -1"),
        ({"contents": "books", "load": "60;50"}, "110 kg in all"),
    ],
)
def test_what_cannot_be_inside_is_refused(unsaid, cells, message):
    with pytest.raises(sp.InputError, match=message):
        contents_of(cells, BODY, unsaid)


@pytest.mark.parametrize(
    "inside", [None, sp.Contents(), sp.Contents("boxes", loads=(0.1, 0.3), drawers="stops")]
)
def test_a_spec_keeps_every_bit(inside):
    room = sp.Room(left_wall=sp.Wall(0.1))
    assert from_text(to_text((BODY, room, inside))) == (BODY, room, inside)
