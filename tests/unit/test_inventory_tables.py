"""Hostile tables: what is refused as a whole, and what is rejected row by row, each with its reason."""

from __future__ import annotations

import datetime
import math
import zipfile
from decimal import Decimal

import openpyxl
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from inventories import HEADER, city, table

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.folder import Workspace
from stayput.inventory.header import header_of
from stayput.inventory.plan import make_plan
from stayput.inventory.scenarios import read_scenarios
from stayput.inventory.tables import open_table

GOOD = "good,chest,,,,,,,,,,,"


def plan(folder, file):
    """Facts and rejects of a table."""
    work = folder / "plan"
    work.mkdir()
    facts = make_plan(Workspace(work), file, read_scenarios(city(folder)), 2**24, lambda count: None)
    return facts, pq.read_table(work / "plan" / "rejects.parquet").to_pylist()


def row(**cells):
    return ",".join(cells.get(name, "") for name in HEADER.split(","))


# ruff: noqa: E501 - a case a line
REJECTED = {
    "unit in a cell": (row(id="x", width="40 ken", height="1", mass="1"), "width is '40 ken'; it must be a plain number in m, without its unit"),
    "decimal comma": (row(id="x", width='"0,4"', height="1", mass="1"), "width is '0,4'; it must be a plain number"),
    "thousands": (row(id="x", preset="chest", value='"90,00"'), "value is '90,00'"),
    "negative size": (row(id="x", width="-0.4", height="1", mass="1"), "width is -0.4 m; it must be between 0.01 and 10 m"),
    "zero mass": (row(id="x", width="0.4", height="1", mass="0"), "mass is 0 kg"),
    "NaN": (row(id="x", width="nan", height="1", mass="1"), "width is 'nan'"),
    "infinity": (row(id="x", width="1e999", height="1", mass="1"), "width is inf"),
    "hexadecimal": (row(id="x", width="0x1p-1", height="1", mass="1"), "width is '0x1p-1'"),
    "underscore": (row(id="x", width="1_0", height="1", mass="1"), "width is '1_0'"),
    "formula": (row(id="x", width="=1+1", height="1", mass="1"), "width is a formula"),
    "command in an id": (row(id="=cmd|' /C calc'!A0", preset="chest"), "id is a formula"),
    "no size": (row(id="x"), "width is missing"),
    "no such preset": (row(id="x", preset="wardrob"), "did you mean 'wardrobe'"),
    "no such floor": (row(id="x", preset="chest", floor="vynil"), "did you mean 'vinyl'"),
    "friction": (row(id="x", preset="chest", floor="0.3;0.4"), "kinetic friction is 0.4"),
    "negative gap": (row(id="x", preset="chest", gap="-0.1"), "gap is -0.1"),
    "no such building": (row(id="x", preset="chest", building="tower", storey="1"), "building is 'tower'"),
    "no such structure": (row(id="x", preset="chest", building="5 straw", storey="1"), "straw"),
    "storeys": (row(id="x", preset="chest", building="0 RC", storey="1"), "building.storeys is 0"),
    "storey above the roof": (row(id="x", preset="chest", building="office", storey="9"), "storey is 9; it must be 1 to 5"),
    "half a storey": (row(id="x", preset="chest", building="office", storey="1.5"), "whole number"),
    "no storey of a name": (row(id="x", preset="chest", building="office", storey="PH1"), "storey is 'PH1'; it must be a number, 1 on the ground, or such as 3F, M2F, B1 or RF"),
    "storey of nought": (row(id="x", preset="chest", building="office", storey="0"), "storey is 0; it must be 1 to 5, the roof, or a basement from B1 to B9"),
    "decimal comma between commas": (row(id="x", width='"0,4"', height="1", mass="1"), "a comma is a decimal one where semicolons stand between the columns"),
    "no storey": (row(id="x", preset="chest", building="office"), "storey is missing"),
    "no building": (row(id="x", preset="chest", storey="2"), "building is missing"),
    "no such measure": (row(id="x", preset="chest", measures="glue"), "measures has 'glue'"),
    "measure twice": (row(id="x", preset="chest", measures="wedge;wedge"), "twice"),
    "measures for one place": (row(id="x", preset="chest", measures="wedge_stopper+gel_mats"), "only one of them"),
    "taller than the room": (row(id="x", width="1", height="2.5", mass="9"), "inside the ceiling"),
    "costs": (row(id="x", preset="chest", measures="wedge;sheet", costs="5"), "costs has 1 numbers"),
    "negative cost": (row(id="x", preset="chest", measures="wedge", costs="-5"), "costs is -5"),
    "no count": (row(id="x", preset="chest", count="0"), "count is 0"),
    "negative value": (row(id="x", preset="chest", value="-1"), "value is -1"),
    "duplicate": (row(id="good", preset="chest"), "which is that of row 2"),
    "more cells": (GOOD.replace("good", "x") + ",1", "14 cells"),
    "fewer cells": ("x,chest", "2 cells"),
    "a million characters": (row(id="x", preset="c" * 10**6), "preset has 1000000 characters"),
    "a million in an id": (row(id="c" * 10**6, preset="chest"), "id has 1000000 characters"),
    "several lines": (row(id="x", preset='"chest\nchest"'), "several lines"),
    "stray quote": ('x,"chest"z,,,,,,,,,,,', "cannot be read"),
    "invisible character": (row(id="x\u200b", preset="chest"), "an invisible one"),
    "turned letters": (row(id="x\u202ey", preset="chest"), "an invisible one"),
    "not available": (row(id="x", width="#N/A", height="1", mass="1"), "width is '#N/A'; it must be a plain number"),
    "control character": (row(id="x\x07", preset="chest"), "control character"),
}  # fmt: skip


@pytest.mark.parametrize("name", REJECTED)
def test_a_bad_row_is_rejected_with_its_reason(tmp_path, name):
    bad, reason = REJECTED[name]
    facts, rejects = plan(tmp_path, table(tmp_path, [GOOD, bad, GOOD.replace("good", "last")]))
    assert (facts["pieces"], facts["rejects"]) == (2, 1)
    (told,) = rejects
    assert told["row"] == 3
    assert reason in told["reason"]
    assert told["reason"].endswith(".")
    assert len(told["reason"]) < 700
    assert len(told["id"]) <= 200


REFUSED = {
    "merged header": ("Piece,,,Place,\nid,preset,width,building,storey\n", "seem to stand in row 2"),
    "no header": ("p1,chest\n", "No heading of the first row is known"),
    "bars": ("id|preset\np|chest\n", "semicolons or tabs must be between"),
    "unit that is none of a size": ("id,preset,Mass (cm)\np,chest,40\n", "no unit that is known for it"),
    "endless cell": ("id,preset\np," + "c" * (2**24 + 1) + "\n", "goes beyond 16,777,216 characters"),
    "misspelt": ("id,presett\np,chest\n", "did you mean 'preset'"),
    "column twice": ("id,preset,preset\np,chest,chest\n", "there twice"),
    "too many columns": (",".join(["id", *(f"c{n}" for n in range(300))]) + "\n", "301 columns"),
    "empty": ("", "it is empty"),
    "only a header": ("id,preset\n", "a row below its header"),
    "open quote": ('id,preset\np,"chest\nq,chest\n', "row 2 of the inventory .line 2. a quote opens"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_bad_table_is_refused_whole(tmp_path, name):
    content, reason = REFUSED[name]
    file = tmp_path / "inventory.csv"
    file.write_text(content)
    with pytest.raises(sp.InputError, match=reason):
        plan(tmp_path, file)


@pytest.mark.parametrize(
    ("encoding", "how"),
    [("utf-8", "UTF-8"), ("utf-8-sig", "UTF-8"), ("cp932", "cp932"), ("utf-16", "UTF-16")],
)
def test_encodings_are_tried_in_turn(tmp_path, encoding, how):
    file = tmp_path / "inventory.csv"
    file.write_bytes("id,preset\n本棚,bookcase\n".encode(encoding))
    with open_table(file) as read:
        assert read.read_as == how
        assert read.header == ["id", "preset"]
        assert next(read.rows) == (2, ["本棚", "bookcase"])


@pytest.mark.parametrize("encoding", ["utf-16", "euc_jp", "utf-32"])
def test_other_encodings_are_refused(tmp_path, encoding):
    file = tmp_path / "inventory.csv"
    file.write_bytes("id,preset\n棚卸し食器棚,bookcase\n".encode(encoding) + b"\x85\xff\n")
    with pytest.raises(sp.InputError, match="UTF-8, cp932"), open_table(file):
        pass


def test_empty_rows_are_counted(tmp_path):
    facts, rejects = plan(tmp_path, table(tmp_path, [GOOD, ",,,,,,,,,,,,", "", row(id="b", preset="chest")]))
    assert facts["empty rows"] == 2
    assert facts["pieces"] == 2
    assert not rejects


def test_columns_that_are_not_known_are_named():
    assert header_of(["preset", "owner", "room no."]).unused == ("owner", "room no.")


def excel(folder, rows):
    book = openpyxl.Workbook()
    for cells in rows:
        book.active.append(cells)
    file = folder / "inventory.xlsx"
    book.save(file)
    return file


def test_a_workbook_is_read_cell_by_cell(tmp_path):
    rows = [
        ["id", "preset", "width", "count", None],
        [1, "chest", None, 2, None],
        ["f", "chest", "=0.1+0.3", 1, None],
        ["d", "chest", datetime.datetime(2024, 1, 1), 1, None],
        ["b", "chest", True, 1, None],
        [None, None, None, None, None],
        ["w", "chest", 0.45, 1.0, "x"],
        ["ok", "chest", 0.45, 1.0, None],
    ]
    facts, rejects = plan(tmp_path, excel(tmp_path, rows))
    assert facts["pieces"] == 2
    assert facts["empty rows"] == 1
    assert "Sheet" in facts["read as"]
    told = {row["row"]: row["reason"] for row in rejects}
    assert "width is a formula" in told[3]
    assert "a date" in told[4]
    assert "true or false" in told[5]
    assert "6 cells" in told[7] or "5 cells" in told[7] or "without a name" in told[7]


@pytest.mark.parametrize(
    ("number_format", "unit"), [('0" cm"', "cm"), ("0\\c\\m", "cm"), ('0.0"kg"', "kg"), ("0%", "%")]
)
def test_a_unit_in_the_format_of_a_number_is_seen(tmp_path, number_format, unit):
    file = excel(
        tmp_path, [["id", "preset", "width", "value"], ["a", "chest", 0.4, 9], ["b", "chest", 0.4, 9]]
    )
    book = openpyxl.load_workbook(file)
    book.active["C2"].number_format, book.active["D3"].number_format = number_format, '"¥"#,##0'
    book.save(file)
    facts, (told,) = plan(tmp_path, file)
    assert facts["pieces"] == 1
    assert f"width is a number that is shown in {unit}" in told["reason"]


def edited(file, sheet):
    """Give a workbook another first sheet."""
    with zipfile.ZipFile(file) as book:
        parts = {name: book.read(name) for name in book.namelist()}
    with zipfile.ZipFile(file, "w") as book:
        for name, content in parts.items():
            book.writestr(name, sheet(content) if name.endswith("sheet1.xml") else content)


@pytest.mark.parametrize(
    "sheet",
    [
        lambda content: content[:-40],
        lambda content: b"",
        lambda content: content.replace(b"<c ", b'<c t="s" ', 1).replace(b"<is>", b"<v>999</v><is>", 1),
    ],
)
def test_a_broken_sheet_is_refused(tmp_path, sheet):
    file = excel(tmp_path, [["id", "preset"], *([f"p{n}", "chest"] for n in range(50))])
    edited(file, sheet)
    with pytest.raises(sp.InputError, match=r"must be (whole, and is broken|an Excel workbook)"):
        plan(tmp_path, file)


def test_a_merged_header_of_a_workbook_is_refused(tmp_path):
    with pytest.raises(sp.InputError, match="seem to stand in row 2"):
        plan(tmp_path, excel(tmp_path, [["Piece", None, "Place"], ["id", "preset", "storey"]]))


@pytest.mark.parametrize("suffix", [".xlsx", ".parquet"])
def test_a_file_of_another_kind_is_refused(tmp_path, suffix):
    file = tmp_path / f"inventory{suffix}"
    file.write_bytes(b"PK\x03\x04 no such thing")
    with pytest.raises(sp.InputError, match="it must be"):
        plan(tmp_path, file)


def test_other_names_are_refused(tmp_path):
    file = tmp_path / "inventory.ods"
    file.write_bytes(b"")
    with pytest.raises(sp.InputError, match="must end in"):
        assess(file, city(tmp_path), tmp_path / "out", progress=False)


def test_parquet_is_read_with_its_types(tmp_path):
    columns = {
        "id": ["a", "b", None, "d"],
        "width": [0.4, math.nan, 0.4, -1.0],
        "height": [1.8, 1.8, 1.8, 1.8],
        "mass": pa.array([100, 100, 100, 100], pa.int16()),
        "floor": pa.array(["vinyl"] * 4).dictionary_encode(),
    }
    file = tmp_path / "inventory.parquet"
    pq.write_table(pa.table(columns), file)
    facts, rejects = plan(tmp_path, file)
    assert facts["pieces"] == 2
    assert facts["empty cells"] == {"id": 1}
    assert [row["row"] for row in rejects] == [3, 5]
    assert "width is nan" in rejects[0]["reason"]


def test_decimals_of_parquet_are_numbers(tmp_path):
    file = tmp_path / "inventory.parquet"
    pq.write_table(pa.table({"id": ["a"], "preset": ["chest"], "width": [Decimal("0.45")]}), file)
    facts, rejects = plan(tmp_path, file)
    assert facts["pieces"] == 1, rejects


def test_a_broken_page_of_parquet_is_refused(tmp_path):
    file = tmp_path / "inventory.parquet"
    pq.write_table(pa.table({"id": [f"p{n}" for n in range(9000)], "preset": ["chest"] * 9000}), file)
    content = bytearray(file.read_bytes())
    content[1000:1050] = b"\xff" * 50
    file.write_bytes(content)
    with pytest.raises(sp.InputError, match=r"could not be read|is broken"):
        plan(tmp_path, file)


def test_a_list_in_parquet_is_of_no_use(tmp_path):
    file = tmp_path / "inventory.parquet"
    pq.write_table(pa.table({"id": ["a"], "preset": ["chest"], "load": [[1.0, 2.0]]}), file)
    facts, rejects = plan(tmp_path, file)
    assert facts["pieces"] == 0
    assert "neither text nor number" in rejects[0]["reason"]


def test_rejects_cannot_be_taken_for_formulas(tmp_path):
    bad = row(id="@SUM(1)", preset="nothing")
    done = assess(table(tmp_path, [GOOD, bad]), city(tmp_path), tmp_path / "out", progress=False)
    assert ",'@SUM(1)," in (done.folder / "rejects.csv").read_text()
