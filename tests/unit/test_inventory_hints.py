"""What else tables hold: sizes without a unit, racks, two masses, no mass, pieces that are fixed."""

from __future__ import annotations

import pytest
from inventories import CITY, city, planned, rows_of_results, table

import stayput as sp
from stayput.files import named_columns
from stayput.inventory import assess
from stayput.inventory.columns import read_columns
from stayput.inventory.header import Header
from stayput.inventory.report import empty_told, further, notes_told

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
            "width=outer_depth[?],length=width[?],mass=weight[?],height=u_height[U]",
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
    "yes": 1, "TRUE": 1, "true": 1, "1": 1, "bolted": 1, "fixed": 1, "Anchored": 1, "有": 1, "あり": 1,
    "○": 1, "済": 1, "固定済": 1, "固定済み": 1, "１": 1, "FALSE": 0, "0": 0, "無": 0, "not anchored": 0,
    "unknown": 0, "不明": 0, "釘": None, "no+L字金具": None,
}  # fmt: skip


def test_a_fixed_piece_is_not_assessed_as_free(tmp_path):
    mine = FREE + '[[measures]]\nname = "mine"\ntype = "l_bracket"\n'
    file = table(tmp_path, [f"bookcase,{word}" for word in FIXED], "preset,固定状況")
    rows, rejects, _, facts, _ = planned(tmp_path, file, mine)
    free, fixed = (rows[[*FIXED].index(word)]["records"][0] for word in ("", "yes"))
    assert [row["records"][0] for row in rows] == [
        (free, fixed)[held] for held in FIXED.values() if held is not None
    ]
    assert {row["fixed"] for row in rows if row["records"][0] == fixed} == {"l_bracket"}
    assert "given twice" in rows[[*FIXED].index("mine")]["not_possible"][0]["reason"]
    assert len(rejects) == list(FIXED.values()).count(None)
    for row, word in zip(rejects, (word for word in FIXED if FIXED[word] is None), strict=True):
        assert f"fixed is '{word}'" in row["reason"]
        assert "it must be one of 'yes', 'no', 'Anti-slip sheet'" in row["reason"]
        assert "_" not in row["reason"]
        assert "'あり', 'なし', '滑り止めシート'" in row["reason_ja"]
    english, japanese = notes_told(facts)[0]
    assert "where that alone is said: 20 rows (8, 9, 10, 11, 12, …)" in english
    assert "L型金具）：20行（8、9、10、11、12、…行目）" in japanese
    for told, blank in zip(empty_told(facts), ("固定状況 in 3 rows", "固定状況（3行）"), strict=True):
        assert blank in told


@pytest.mark.parametrize(
    ("cell", "kind"), [(True, "l_bracket"), (False, None), (1, "l_bracket"), (0.0, None)]
)
def test_a_workbook_s_own_true_says_that_a_piece_is_fixed(tmp_path, cell, kind):
    from openpyxl import Workbook

    book = Workbook()
    book.active.append(["preset", "anchored"])
    book.active.append(["bookcase", cell])
    book.save(tmp_path / "inventory.xlsx")
    (row,), *_ = planned(tmp_path, tmp_path / "inventory.xlsx")
    assert row["fixed"] == kind


def test_rows_are_told_beside_the_reason_that_is_theirs(tmp_path):
    brackets = (
        FREE.replace("left_wall = { gap = 0.05 }\n", "") + '[[measures]]\nname = "b"\ntype = "l_bracket"\n'
    )
    rows = ["a,60,.3,1.8,", "b,,.3,1.8,.1", "c,70,.3,1.8,"]
    file = table(tmp_path, rows, "id,mass,width,height,gap")
    *_, facts, _ = planned(tmp_path, file, brackets)
    assert [(each["about"], each["rows"], each["same"]) for each in facts["measures not possible"]] == [
        ("b", 2, True),
        ("b", 1, True),
    ]
    (no_wall, _), (no_mass, _) = notes_told(facts)[1:]
    assert no_wall.endswith("2 rows (2, 4).")
    assert "mass" in no_mass
    assert no_mass.endswith("1 row (3).")


MONEY = {
    "value": ("", "in the currency of the table", "通貨は表のとおり"),
    "value [JPY]": ("JPY", "60,000 JPY", "60,000 JPY"),
    "価格（万円）": ("JPY", " JPY", " JPY"),
    "value,costs [EUR]": ("EUR", "60,000 EUR", "60,000 EUR"),
}


@pytest.mark.parametrize("columns", MONEY)
def test_losses_are_told_with_their_currency(tmp_path, columns):
    currency, *said = MONEY[columns]
    rows = ["a,bookcase,60000" + ",1;1" * columns.count(",")]
    done = assess(
        table(tmp_path, rows, f"id,preset,{columns}"), city(tmp_path), tmp_path / "out", progress=False
    )
    lines = (tmp_path / "out" / "summary.csv").read_text(encoding="utf-8-sig").splitlines()
    assert (lines[0].rsplit(",", 1)[1], lines[1].rsplit(",", 1)[1]) == ("currency", currency)
    total = done.summary.events["city"]
    total.loss = total.loss_best = 60_000.0
    for told, words in zip(further(total, done.facts["currency"]), said, strict=True):
        assert words.removeprefix("60,000") in told
        assert "their currency" not in told


def test_values_and_costs_are_in_one_currency():
    for header in ("id,preset,value [JPY],costs [EUR]", "id,preset,価格（千円）,costs [usd]"):
        with pytest.raises(sp.InputError) as refused:
            Header(header.split(","))
        assert "must be in one currency" in refused.value.told("en")
        assert "通貨が異なります" in refused.value.told("ja")
    Header(["id", "preset", "価格（千円）", "costs [円]"])


HINTS = [
    "Item,width [m],length [m],height [m]",
    "Item,Width [mm],W,H",
    "品名,幅,間口,高さ",
    "id,width,depth,奥行,height",
    "id,width,depth [m],height (cm)",
    "id,preset,stock,on hand",
    "name,u_height,rack units,depth",
    "品名,総重量,重量,質量",
    "name,サイズ,寸法,縦",
    "Gerät,Länge,w,l,pcs. a,copies",
    "id,preset,count,金額,合計金額",
    "id,preset,height,h,高さ,mass (lb)",
    "id,name,floor,count,total value",
]
UNITS = {
    "length": "cm",
    "width": "m",
    "height": "m",
    "gap": "m",
    "mass": "kg",
    "load": "kg",
    "value": "円",
    "costs": "円",
}


def filled(hint):
    """A hint with its ? filled in: units, the depth by a column that it leaves out, and other columns."""
    pairs, parts = named_columns(hint, ""), []
    depth = next((column for name, column in pairs if name == "ignore"), None)
    for name, column in pairs:
        known = ("name" if column == "Gerät" else "ignore") if name == "?" else name
        parts.append(f"{known}={depth if column == '?' else column.replace('?', UNITS.get(known, ''))}")
    return ",".join(parts)


@pytest.mark.parametrize("text", HINTS)
@pytest.mark.parametrize("storeys", [False, True])
def test_a_hint_is_accepted_when_it_is_filled_in(text, storeys):
    names, hint = text.split(","), None
    cells = [["3F" if storeys else "7"] * len(names)]
    for _ in range(3):
        try:
            Header(names, cells, read_columns(hint))
        except sp.InputError as error:
            hint = filled(error.values["proposal"])
        else:
            assert hint
            return
    raise AssertionError(hint)


def test_measures_are_compared_beside_what_fixes_a_piece_already(tmp_path):
    rows = ["a,,l_bracket+wedge_stopper", "b,L字金具,wedge_stopper", "c,Ｌ字金具＋ストッパー,"]
    file = table(tmp_path, [f"{row},bookcase" for row in rows], "id,fixed,measures,preset")
    done = assess(file, city(tmp_path, FREE), tmp_path / "out", progress=False)
    together, added, both = (row["options"] for row in rows_of_results(done))
    numbers = ({**option, "name": "", "expected_loss": 0.0} for option in (together[1], added[1], both[0]))
    first, *others = numbers
    assert all(other == first for other in others)
    assert [option["name"] for option in added] == ["none", "wedge_stopper"]


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
    assert first["records"] == second["records"]
