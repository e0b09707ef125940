"""What else tables hold: sizes without a unit, racks, two masses, no mass, pieces that are fixed."""

from __future__ import annotations

import pytest
from inventories import CITY, city, planned, rows_of_results, table

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.columns import read_columns
from stayput.inventory.header import Header
from stayput.inventory.report import notes_told

BARE = {
    "one in cm": ("id,depth (cm),height,mass", None, "height=height[?]"),
    "one mapped in cm": ("id,width,depth,height,mass", "width=depth[cm],ignore=width", "height=height[?]"),
    "one along the wall in mm": ("id,幅(mm),width,height", None, "width=width[?],height=height[?]"),
    "all mapped": ("id,depth,h", "width=depth,height=h", "width=depth[?],height=h[?]"),
    "gaps too": ("id,depth (in),height (in),gap", None, "gap=gap[?]"),
    "a mass": ("id,preset,mass (lb),load", None, "load=load[?]"),
    "money": ("id,preset,価格（千円）,costs", None, "costs=costs[?]"),
}


@pytest.mark.parametrize("name", BARE)
def test_a_number_without_a_unit_is_asked_for_beside_one_in_another(name):
    header, columns, proposal = BARE[name]
    with pytest.raises(sp.InputError) as refused:
        Header(header.split(","), (), read_columns(columns))
    for language in ("en", "ja"):
        assert f'{proposal}"' in refused.value.told(language)


@pytest.mark.parametrize("header", ["id,width,height,gap,mass", "id,depth (m),height,mass (kg),load"])
def test_numbers_without_a_unit_are_in_stayput_s_own_where_none_is_in_another(header):
    assert not Header(header.split(",")).doubts


def test_a_mapped_column_is_in_the_unit_of_its_heading():
    header = Header(["id", "depth (cm)", "h (cm)", "mass"], (), read_columns("width=depth,height=h"))
    assert header.cells(["a", "45", "180", "60"])["width"] == 0.45


@pytest.mark.parametrize(
    ("header", "proposal", "words"),
    [
        (
            "name,width,u_height,outer_depth,weight",
            "width=outer_depth[?],ignore=width,mass=weight[?],height=u_height[U]",
            ("rack units of 44.45 mm", "1Uは44.45 mm"),
        ),
        ("品名,総重量(kg),重量(kg)", "ignore=重量(kg)", ("what is inside", "収納物を含む")),
        (
            "Item,Weight,Gross weight",
            "mass=Gross weight[?],ignore=Weight",
            ("what is inside", "収納物を含む"),
        ),
    ],
)
def test_what_a_column_may_hold_is_said(header, proposal, words):
    with pytest.raises(sp.InputError) as refused:
        Header(header.split(","))
    for language, word in zip(("en", "ja"), words, strict=True):
        assert f'"{proposal}"' in refused.value.told(language)
        assert word in refused.value.told(language)


def test_rack_units_are_a_unit():
    header = Header(["id", "depth (mm)", "高さ(U)", "mass"])
    assert header.cells(["a", "900", "42", "90"])["height"] == pytest.approx(1.8669)


def test_a_table_of_buildings_is_refused_as_one():
    with pytest.raises(sp.InputError) as refused:
        Header(["PortNumber", "AccNumber", "LocNumber", "BuildingID", "OccupancyCode", "BuildingTIV"])
    assert "a row for each piece of furniture" in refused.value.told("en")
    assert "建物の一覧です" in refused.value.told("ja")


FREE = CITY.split("[[measures]]")[0]


def test_a_piece_without_a_mass_moves_as_one_with_any(tmp_path):
    file = table(tmp_path, ["a,0.3,1.8,37,8", "b,0.3,1.8,,8"], "id,width,height,mass,value [€]")
    done = assess(file, city(tmp_path, FREE), tmp_path / "out", progress=False)
    weighed, without = rows_of_results(done)
    for name in ("overturned", "slide_median", "hit_wall"):
        assert without[name] == pytest.approx(weighed[name], rel=1e-6)
    for language, said in (("en", "Without a mass: 1 row"), ("ja", "重量のない家具：1行")):
        page = done.report(language).read_text(encoding="utf-8")
        assert said in page
        assert page.count(" EUR") > 1
        assert page.count('<table class="map">') == 1  # with measures it would be the same
    assert "empty cells" in done.facts
    assert not done.facts["empty cells"]


def test_what_needs_a_mass_is_not_assessed_without_one(tmp_path):
    rows = ["a,,,", "b,books,,", "c,,L-bracket,", "d,,,20"]
    file = table(tmp_path, [f"{row},0.3,1.8" for row in rows], "id,contents,fixed,load,width,height")
    (row,), rejects, *_ = planned(tmp_path, file)
    assert row["options"] == ["none", "sheet"]
    assert [each["name"] for each in row["not_possible"]] == ["wedge"]
    assert [each["id"] for each in rejects] == ["b", "c", "d"]
    assert all("mass" in each["reason"] and "重量" in each["reason_ja"] for each in rejects)


FIXED = {
    "": 0, "no": 0, "Unfixed": 0, "未": 0, "なし": 0, "×": 0,
    "L字金具": 1, "ｌ型金具": 1, "Screwed L-brackets": 1, "l_bracket": 1, "brackets": 1, "mine": 1,
    "yes": None, "済": None, "固定済み": None, "true": None, "釘": None, "no+L字金具": None,
}  # fmt: skip


def test_a_fixed_piece_is_not_assessed_as_free(tmp_path):
    mine = FREE + '[[measures]]\nname = "mine"\ntype = "l_bracket"\n'
    file = table(tmp_path, [f"bookcase,{word}" for word in FIXED], "preset,固定状況")
    rows, rejects, _, facts, _ = planned(tmp_path, file, mine)
    free, fixed = rows[0]["units"]
    assert [row["units"][0] for row in rows] == [
        (free, fixed)[held] for held in FIXED.values() if held is not None
    ]
    assert {row["fixed"] for row in rows if row["units"][0] == fixed} == {"l_bracket"}
    assert "given twice" in rows[-1]["not_possible"][0]["reason"]
    assert len(rejects) == list(FIXED.values()).count(None)
    for row, word in zip(rejects, (word for word in FIXED if FIXED[word] is None), strict=True):
        assert f"fixed is '{word}'" in row["reason"]
        assert "it must be one of 'anti_slip_sheet'" in row["reason"]
        assert "'なし', '滑り止めシート'" in row["reason_ja"]
    english, japanese = notes_told(facts)[0]
    assert "Fixed already by l_bracket: 6 rows (8, 9, 10, 11, 12, …)" in english
    assert "L型金具（ねじ留め）ですでに固定してある家具：6行（8、9、10、11、12、…行目）" in japanese


def test_measures_are_compared_beside_what_fixes_a_piece_already(tmp_path):
    rows = ["a,,l_bracket+wedge_stopper", "b,L字金具,wedge_stopper", "c,Ｌ字金具＋ストッパー,"]
    file = table(tmp_path, [f"{row},bookcase" for row in rows], "id,fixed,measures,preset")
    (together, added, both), *_ = planned(tmp_path, file, FREE)
    assert together["units"][1] == added["units"][1] == both["units"][0]
    assert added["options"] == ["none", "wedge_stopper"]


@pytest.mark.parametrize(
    ("word", "kind"),
    [
        ("石膏ボード", "plasterboard"),
        ("石こうボード", "plasterboard"),
        ("間柱", "stud"),
        ("長押", "hanging strip"),
    ],
)
def test_walls_are_read_in_japanese(tmp_path, word, kind):
    file = table(tmp_path, [f"a,chest,{word}", f"b,chest,{kind}"], "id,preset,壁の下地")
    (first, second), *_ = planned(tmp_path, file)
    assert first["units"] == second["units"]
