"""Storeys as people write them, and which floor of the building each moves with."""

from __future__ import annotations

import unicodedata

import pytest
from inventories import city, planned, rows_of_results, table

from stayput.inventory import assess
from stayput.inventory.cells import ROOF, storey_called
from stayput.inventory.report import storey_map
from stayput.inventory.summary import Total

WRITTEN = {
    3: ("3", "3F", "3 F", "3階", "三階", "3.0", "3fl"),
    -1: ("B1", "B1F", "b1", "地下1階", "地下一階", "地下1", "地下", "地階", "Basement", "1. UG", "지하1층"),
    -2: ("B2F", "地下2階", "Basement 2"),
    2: ("M2F", "M2", "中2階", "中二階", "Mezzanine", "1. OG", "2층"),
    1: ("1F", "Ground floor", "EG", "RDC"),
    ROOF: ("屋上", "屋上階", "R", "RF", "R階", "Roof", "rooftop", "옥상"),
    None: ("PH1", "塔屋", "2nd floor", "F", "B", "0", "B0", "M", "3-4", "R2", "", "x" * 300),
}


def full_width(text: str) -> str:
    """Return a text in full-width characters, as Japanese keyboards write them."""
    return "".join(chr(ord(letter) + 0xFEE0) if "!" <= letter <= "~" else letter for letter in text)


@pytest.mark.parametrize("storey", WRITTEN)
def test_a_storey_is_known_as_people_write_it(storey):
    for text in WRITTEN[storey]:
        assert storey_called(text) == storey, text
        assert storey_called(full_width(f" {text} ")) == storey, text
        assert unicodedata.normalize("NFKC", full_width(text)) == text


def test_a_basement_moves_as_the_ground_and_a_roof_as_the_top(tmp_path):
    storeys = ["", "B1", "地下2階", "1", "中2階", "2F", "屋上", "ＲＦ", "5"]
    written = [f"p{n},chest,{'office' if storey else ''},{storey}" for n, storey in enumerate(storeys)]
    rows, *_, moved = planned(tmp_path, table(tmp_path, written, "id,preset,building,storey"))
    assert [row["storey"] for row in rows] == [None, -1, -2, 1, 2, 2, 5, 5, 5]  # of four storeys
    assert [row["building"] for row in rows] == [None, *["office"] * 8]
    ground, first, second, roof = (False, 1), (True, 1), (True, 2), (True, 5)
    assert moved == [ground, ground, ground, first, second, second, roof, roof, roof]
    assert rows[0]["records"] == rows[1]["records"] == rows[2]["records"]  # and is simulated once


def test_a_roof_is_called_so(tmp_path):
    rows = ["a,bookcase,office,R", "b,bookcase,office,5", "c,bookcase,8 RC,屋上", "d,bookcase,8 RC,5"]
    done = assess(
        table(tmp_path, rows, "id,preset,building,storey"), city(tmp_path), tmp_path / "out", progress=False
    )
    assert [row["storey"] for row in rows_of_results(done)] == [5, 5, 9, 5]
    assert done.facts["roofs"] == {"office": 5, "8 RC": 9}
    for language, roof, fifth in (("en", "roof", "5F"), ("ja", "屋上", "5階")):
        page = done.report(language).read_text(encoding="utf-8")
        assert [page.count(f">{told}<") for told in (roof, fifth, "9F", "9階")] == [4, 2, 0, 0]  # in a map
        between = ", " if language == "en" else "、"
        assert f"office{between}{roof}" in page
        assert f"{between}{fifth}" in page


def test_a_map_leaves_no_basement_out_between():
    total = Total(rows=1, pieces=1)
    shown = storey_map({("a", -3): total, ("a", 1): total}, False)
    assert [row["floor"][0] for row in shown["rows"]] == ["1F", "B1F", "B2F", "B3F"]
