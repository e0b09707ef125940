"""Tables as people have them: their columns by what they are called, their units, and what is unclear."""

from __future__ import annotations

import json
import re

import pytest
from inventories import CITY, planned, table

import stayput as sp
from stayput.inventory.columns import COLUMNS, plain_name, read_columns
from stayput.inventory.header import Header
from stayput.inventory.plan import ROWS_LOOKED_AT
from stayput.inventory.report import engine_told
from stayput.model.body import FURNITURE
from stayput.model.room import SURFACES
from stayput.vocabulary import WORDS


def read(folder, text, columns=None, encoding="utf-8", name="inventory.csv", scenario=CITY):
    """Rows of a plan, its rejects, the bodies of its pieces and its facts."""
    (folder / name).write_bytes(text.encode(encoding))
    return planned(folder, folder / name, scenario, columns)[:4]


def sizes(body):
    return body.width, body.height, body.mass


JAPANESE = "管理番号,品名,幅(mm),奥行(mm),高さ(mm),重量(kg),設置階,建物,数量,取得価額（円）,備考\n"


def test_a_japanese_table_is_read_as_it_is(tmp_path):
    first = 'A-1,本棚,900,300,1800,80,3階,office,4,"45,000",\n'
    text = JAPANESE + first + "A-2,書庫,880,450,2100,65,2F,office,2,\\60000,窓\n"
    rows, rejects, bodies, facts = read(tmp_path, text, encoding="cp932")
    assert not rejects
    assert [row["id"] for row in rows] == ["A-1", "A-2"]
    assert [row["count"] for row in rows] == [4, 2]
    assert [row["value"] for row in rows] == [45000.0, 60000.0]
    assert [row["storey"] for row in rows] == [3, 2]
    depths = [(0.3, 1.8, 80.0), (0.45, 2.1, 65.0)]  # and not widths
    assert [sizes(body) for body in bodies] == depths
    assert facts["columns not used"] == ["備考"]
    assert [body.length for body in bodies] == [0.9, 0.88]
    assert "width = 奥行(mm)" in facts["columns renamed"]


def test_an_american_table_is_read_in_its_units(tmp_path):
    text = (
        "Asset Tag,Description,Width (in),Depth (in),Height (in),Weight (lbs),Level,Bldg,Qty,Unit Price\n"
        "T1,Bookcase,36,12,72,90,2,5 steel,3,250\n"
    )
    rows, rejects, (body,), _ = read(tmp_path, text)
    assert not rejects
    assert sizes(body) == pytest.approx((0.3048, 1.8288, 40.8233133), rel=1e-12)
    assert (rows[0]["storey"], rows[0]["building"], rows[0]["count"]) == (2, "5 steel", 3)


@pytest.mark.parametrize(
    ("mark", "encoding", "ending"),
    [("\t", "utf-16", "txt"), ("\t", "utf-8", "tsv"), (";", "utf-8-sig", "csv"), ("|", "utf-8", "txt")],
)
def test_marks_between_cells_and_encodings(tmp_path, mark, encoding, ending):
    text = "id,width,height,mass\np,0.5,1.5,80\n".replace(",", mark)
    _, rejects, (body,), _ = read(tmp_path, text, encoding=encoding, name=f"inventory.{ending}")
    assert not rejects
    assert sizes(body) == (0.5, 1.5, 80.0)


def test_semicolons_go_with_decimal_commas(tmp_path):
    text = (
        "sep=;\nid;width;height;mass;cg_offset;floor;value\n"
        'a;0,45;1,8;80,5;"0,01;-0,1";"0,4;0,3";1200,50\n'
        "b;0,450;1,800;80;;;1,200\nc;0.45;1.8;80;;;1.200\nd;0.45;1.8;1.800;;;\n"
        "e;45,5 cm;1,8;80,5 kg;;;12,5 €\n"
    )
    rows, rejects, (first, last), facts = read(tmp_path, text)
    assert sizes(last) == pytest.approx((0.455, 1.8, 80.5))
    assert [row["value"] for row in rows] == [1200.5, 12.5]
    assert sizes(first) == (0.45, 1.8, 80.5)
    assert first.cg_offset == (0.01, -0.1)
    assert facts["read as"] == "UTF-8 with semicolons"
    assert {row["id"]: row["reason"].split(" is ")[0] for row in rejects} == {
        "b": "value",  # 1.2 or 1200
        "c": "value",
        "d": "mass",
    }


def test_an_amount_with_its_sign_goes_with_decimal_commas(tmp_path):
    amounts = ["$1,200.50", "1.200,50", "€ 12,5", "45円", "$2,000", "￥2.000", "$12,5x"]
    text = "id;preset;value\n" + "".join(f"{n};chest;{amount}\n" for n, amount in enumerate(amounts))
    rows, rejects, *_ = read(tmp_path, text)
    assert [row["value"] for row in rows] == [1200.5, 1200.5, 12.5, 45.0]
    assert ["may be of decimals" in row["reason"] for row in rejects] == [True, True, False]
    assert "value is '$2,000'" in rejects[0]["reason"]


UNCLEAR = {
    "no unit": ("品名,奥行,高さ,重量\n棚,450,1800,60\n", "width=奥行[?],height=高さ[?],mass=重量[?]"),
    "width and depth": (
        "id,width,depth,height,mass\na,0.9,0.3,1.8,80\n",
        "width=depth[?],length=width[?],height=height[?]",
    ),
    "only the width": ("品名,幅(mm),高さ(mm),重量(kg)\n棚,450,1800,60\n", "width=?,ignore=幅(mm)"),
    "like a count": ("品名,配置台数合計\n本棚,3\n", "count=配置台数合計"),
    "counts by storey": ("品名,1F,2階\n本棚,3,4\n", "count=1F,?=2階"),
    "a count with a note": ("品名,数量（予備）\n本棚,3\n", "count=数量（予備）"),
    "a total": ("品名,台数,金額\n本棚,3,135000\n", "ignore=金額"),
    "sizes in one cell": ("品名,サイズ\n本棚,900x300x1800\n", "?=サイズ"),
    "storeys for a surface": ("id,preset,Floor\na,chest,3\nb,chest,2F\n", "storey=Floor"),
    "Japanese sizes": ("品名,縦(mm),横(cm)\n本棚,300,90\n", "?=縦(mm),?=横(cm)"),
    "a size by its unit": ("品名,胴まわり(mm)\n本棚,300\n", "?=胴まわり(mm)"),
    "another unit": ("id,preset,高さ(kg)\na,chest,3\n", "height=高さ(kg)[?]"),
}


@pytest.mark.parametrize("name", UNCLEAR)
def test_what_is_unclear_is_refused_with_a_proposal(tmp_path, name):
    text, proposal = UNCLEAR[name]
    with pytest.raises(sp.InputError) as refused:
        read(tmp_path, text)
    assert f'--columns "{proposal}"' in str(refused.value)
    assert proposal in refused.value.told("ja")


COUNTS = (
    "Num", "台", "保有数", "Nos.", "EA", "In stock", "Anzahl", "配置 数", "Number of chairs", "員數",
)  # fmt: skip


@pytest.mark.parametrize("header", COUNTS)
def test_what_may_count_is_never_dropped(tmp_path, header):
    with pytest.raises(sp.InputError) as refused:
        read(tmp_path, f"品名,{header}\n本棚,3\n")
    assert f'--columns "count={header}"' in str(refused.value)
    given = Header(["品名", header], (), read_columns(f"count={header}"))
    assert given.places["count"] == 1


@pytest.mark.parametrize("header", ["数　量", "数 量", " 台　数 ", "個　 数", "Q'ty", "Q’ty"])
def test_a_name_with_blanks_between_its_letters_is_that_name(header):
    assert Header(["品　名", header]).places == {"name": 0, "count": 1}


@pytest.mark.parametrize("header", ["耐用年数", "階数", "段数", "Stock location", "利用人数"])
def test_what_counts_something_else_is_not_used(header):
    assert Header(["品名", header]).unused == [header]


GIVEN = [name for name, (_, proposal) in UNCLEAR.items() if "?" not in proposal and "by storey" not in name]


@pytest.mark.parametrize("name", GIVEN)
def test_a_proposal_that_is_given_is_understood(tmp_path, name):
    text, proposal = UNCLEAR[name]
    if name == "another unit":
        text, proposal = text.replace("(kg)", ""), "height=高さ[m]"
    read(tmp_path, text, proposal)


@pytest.mark.parametrize(
    ("cells", "size"),
    [
        ("４５０,１８００,８０．５", (0.45, 1.8, 80.5)),
        ('450,"1,800",80', (0.45, 1.8, 80.0)),
        ("450mm,180 cm,80kg", (0.45, 1.8, 80.0)),
        ("45ｃｍ,1.8m,80000 g", (0.45, 1.8, 80.0)),
        ('450㎜,"1,800mm",80㎏', (0.45, 1.8, 80.0)),
        ("0.450 m,180cm,60.000", (0.45, 1.8, 60.0)),
        ('450,1800,"1,200.50"', (0.45, 1.8, 1200.5)),
        ('450,1800,"1,234.0"', (0.45, 1.8, 1234.0)),
    ],
)
def test_numbers_are_read_as_people_write_them(tmp_path, cells, size):
    _, rejects, (body,), _ = read(tmp_path, f"品名,奥行(mm),高さ(mm),重量(kg)\n棚,{cells}\n")
    assert not rejects
    assert sizes(body) == pytest.approx(size, rel=1e-12)


@pytest.mark.parametrize("cell", ['"1,200"', "80 斤", "8_0", "10⁵", "80mm", '"1,23,456"', "80kg?"])
def test_numbers_that_are_not_certain_are_refused(tmp_path, cell):
    _, rejects, bodies, _ = read(tmp_path, f"品名,奥行(mm),高さ(mm),重量(kg)\n棚,450,1800,{cell}\n")
    assert not bodies
    assert "mass is " in rejects[0]["reason"]


@pytest.mark.parametrize(
    "cells",
    ["棚,300,1.800,60,1,100", "棚,300,1800,60,2.000,100", "棚,300,1800,60,1,1.200", "棚,300,1.800mm,60,1,1"],
)
@pytest.mark.parametrize("mark", [",", "\t", ";"])
def test_a_point_that_may_be_one_of_thousands_is_never_one_of_decimals(tmp_path, cells, mark):
    table = f"品名,奥行(mm),高さ(mm),重量(kg),数量,単価\n{cells}\n".replace(",", mark)
    _, rejects, bodies, _ = read(tmp_path, table)
    if mark == ";" and "1.800" in cells:  # where commas are decimal, the point in mm is one of thousands
        assert sizes(bodies[0])[1] == 1.8
    else:
        assert "may be of decimals or of thousands" in rejects[0]["reason"]
        assert not bodies


@pytest.mark.parametrize("name", ["合計", "SUBTOTAL", "Grand total"])
@pytest.mark.parametrize("header", ["品名", "管理番号"])
def test_a_row_that_is_a_total_is_no_piece(tmp_path, name, header):
    table = f"{header},奥行(mm),高さ(mm),重量(kg),数量\n棚,300,1800,60,2\n{name},300,1800,60,2\n"
    rows, (rejected,), _, _ = read(tmp_path, table)
    assert [row["count"] for row in rows] == [2]
    assert "and not of a total" in rejected["reason"]


def test_a_header_needs_no_unit_where_every_cell_has_one(tmp_path):
    table = "品名,奥行,高さ,重量\n棚,450mm,180 cm,80kg\n机,不明,１８０ｃｍ,80kg\n書庫,18 in,6ft,120 lb\n"
    _, (rejected,), (first, last), _ = read(tmp_path, table)
    assert sizes(first) == pytest.approx((0.45, 1.8, 80.0))
    assert sizes(last) == pytest.approx((0.4572, 1.8288, 54.4310844))
    assert rejected["id"] == "机 #3"
    assert rejected["reason"] == "Column '奥行': width is '不明'; it must be a plain number in m."


def test_a_cell_without_a_unit_among_those_that_have_one_is_refused(tmp_path):
    table = "品名,奥行,高さ,重量\n" + "棚,45cm,1.8m,80kg\n" * ROWS_LOOKED_AT
    _, (rejected,), _, _ = read(tmp_path, table + "机,0.45,1.8m,80kg\n")
    assert rejected["reason"] == (
        "Column '奥行': width is '0.45'; it must be a number with a unit, as in its column."
    )
    sample = [["棚", "45cm", "1.8m", "80kg"], ["机", "45", "1.8m", "80kg"]]
    with pytest.raises(sp.InputError, match=re.escape('"width=奥行[?]"')):
        Header(["品名", "奥行", "高さ", "重量"], sample)


def test_the_size_along_the_wall_is_the_length(tmp_path):
    """What cannot be read there refuses no row: such a piece is run in the plane, as one without a width."""
    text = "品名,幅(cm),奥行(mm),高さ(mm),重量(kg)\n"
    text += "".join(f"棚,{width},450,1800,60\n" for width in ("30", "?", "", "90", "900000"))
    _, rejects, bodies, facts = read(tmp_path, text)
    assert not rejects
    assert [body.length for body in bodies] == [0.3, None, None, 0.9, None]
    assert "length = 幅(cm)" in facts["columns renamed"]
    assert facts["in the plane"] == 3
    english, japanese = engine_told(facts)
    assert english.startswith("Simulated in the plane of their depth: 3 rows, of which no length")
    assert "奥行方向だけで計算した家具：3行" in japanese
    assert engine_told(facts | {"in the plane": 0}) == ("", "")


def test_a_piece_without_a_length_is_refused_where_it_cannot_be_in_the_plane(tmp_path):
    rows = ["a,0.3,0.9,1.8,80", "b,0.3,,1.8,80"]
    for number, stated in enumerate(("dimensions = 3\n", "near_side_wall = { gap = 0.1 }\n")):
        folder = tmp_path / str(number)
        folder.mkdir()
        scenario = (
            stated + CITY if "dimensions" in stated else CITY.replace("[shaking]", f"{stated}[shaking]")
        )
        _, rejects, (body,), _, _ = planned(
            folder, table(folder, rows, "id,width,length,height,mass"), scenario
        )
        assert body.length == 0.9
        assert [each["id"] for each in rejects] == ["b"]
        assert "length" in rejects[0]["reason"]
        assert "length" in rejects[0]["reason_ja"] or "幅" in rejects[0]["reason_ja"]


BAD_CELLS = {
    "数量": ["0", "0.5", "x"], "奥行(mm)": ["x", "0", "=A1", "1.800"], "高さ(mm)": ["", "9e9"],
    "重量(kg)": ["-1"], "階": ["PH1", "9", ""], "建物": ["塔", ""], "床": ["草", "0.3;0.4", "0.3"],
    "壁": ["紙"], "すき間(m)": ["-1", ""], "収納物": ["石"], "緯度": ["91", ""], "番号": ["1", "x" * 300],
    "価格": ["-1"], "対策": ["のり", "l_bracket;l_bracket"], "費用": ["1;2", "-1"],
}  # fmt: skip


@pytest.mark.parametrize("heading", BAD_CELLS)
def test_japanese_reasons_know_no_key_of_a_column(tmp_path, heading):
    good = dict.fromkeys(BAD_CELLS, "") | {
        "番号": "1", "奥行(mm)": "300", "高さ(mm)": "1800", "重量(kg)": "60", "階": "3", "建物": "5 RC",
        "すき間(m)": "0.1", "壁": "concrete", "緯度": "35", "経度": "135", "対策": "l_bracket",
    }  # fmt: skip
    bad = [good | {"番号": f"b{n}", heading: cell} for n, cell in enumerate(BAD_CELLS[heading])]
    bare = CITY.replace("left_wall = { gap = 0.05 }\n", "")
    text = "\n".join(",".join(row.values()) for row in [dict(zip(good, good, strict=True)), good, *bad])
    _, rejects, *_ = read(tmp_path, text, "measures=対策,costs=費用", scenario=bare)
    assert len(rejects) == len(bad)
    keys = re.compile(rf"(?<![\w.])({'|'.join(COLUMNS)})(?![\w.])", re.ASCII)
    for row in rejects:
        own_words = re.sub("'[^']*'", "", row["reason_ja"]).partition("シナリオの[shaking]")[0]
        assert not keys.search(own_words), own_words
        assert row["reason"].count(": ") >= 1, row["reason"]  # after the column of the table


@pytest.mark.parametrize("ending", ["toml", "json", "text", "mapping"])
def test_a_mapping_says_which_column_is_which(tmp_path, ending):
    table = "名,a (mm),b,Gewicht,x\n棚,450,180,60,7\n"
    mapping = {"name": "名", "width": "a (mm)", "height": "b[cm]", "mass": "Gewicht[kg]", "ignore": ["x"]}
    columns = mapping
    if ending == "toml":
        columns = tmp_path / "columns.toml"
        lines = (f"{name} = {json.dumps(value, ensure_ascii=False)}\n" for name, value in mapping.items())
        columns.write_text("".join(lines))
    elif ending == "json":
        columns = str(tmp_path / "columns.json")
        (tmp_path / "columns.json").write_text(json.dumps(mapping))
    elif ending == "text":
        columns = "name=名,width=a (mm),height=b[cm],mass=Gewicht[kg],ignore=x"
    rows, _, (body,), facts = read(tmp_path, table, columns)
    assert sizes(body) == (0.45, 1.8, 60.0)
    assert rows[0]["id"] == "棚 #2"
    assert facts["columns not used"] == ["x"]
    assert "height = b [cm]" in facts["columns renamed"]


def test_a_comma_may_be_in_the_name_of_a_column():
    mapping = read_columns("width=Tiefe (mm),value=Preis, netto,ignore=a, b")
    assert mapping.pairs == (("width", "Tiefe (mm)"), ("value", "Preis, netto"))
    assert mapping.ignored == ("a, b",)


@pytest.mark.parametrize(
    ("columns", "reason"),
    [
        ("width", "must be such as width="),
        ("width=", "must be such as width="),
        ("breadth=奥行", "must be one of"),
        ("width=深さ", "The column is '深さ'; it must be one of 'id'"),
        ("width=奥行[?]", "it must be one of 'mm', 'cm', 'm', 'in', 'ft'"),
        ("width=奥行[kg]", "The unit of width is 'kg'; it must be one of 'mm'"),
        ("height=高さ(cm)[mm]", "it must be one of 'cm'"),
        ("width=奥行[mm],height=奥行[mm]", "given twice"),
        ("width=奥行[mm],width=高さ", "given twice"),
        ({"width": 3}, "must be such as width="),
        ({"width": ["奥行", "高さ"]}, "must be such as width="),
        ("none.json", "cannot be read"),
    ],
)
def test_a_wrong_mapping_is_refused(tmp_path, columns, reason):
    with pytest.raises(sp.InputError, match=reason):
        read(tmp_path, "id,preset,奥行,高さ(cm)\na,chest,450,180\n", columns)


def test_no_name_is_that_of_two_columns():
    aliases = [alias for name, column in COLUMNS.items() for alias in (name, *column.aliases)]
    assert len(set(aliases)) == len(aliases)
    assert all(plain_name(alias) == alias.replace("_", " ") for alias in aliases)


def test_words_stand_for_presets_that_there_are():
    assert set(WORDS["preset"].values()) == set(FURNITURE)
    assert set(WORDS["floor"].values()) == set(SURFACES)
    assert WORDS["preset"]["本棚"] == "bookcase"
    header = Header(["id", "preset", "床材"])
    assert header.cells(["a", "食器棚", "カーペット"]) == {"id": "a", "preset": "cupboard", "floor": "carpet"}
