"""Hostile tables: what is refused as a whole, and what is rejected row by row, each with its reason."""

from __future__ import annotations

import math
from decimal import Decimal

import openpyxl
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from inventories import HEADER, city, planned, table

import stayput as sp
from stayput.inventory import assess

GOOD = "good,chest,,,,,,,,,,,"


def plan(folder, file):
    """Facts and rejects of a table."""
    made = planned(folder, file)
    return made.facts, made.rejects


def row(**cells):
    return ",".join(cells.get(name, "") for name in HEADER.split(","))


# ruff: noqa: E501 - a case a line
REJECTED = {
    "unit in a cell": (row(id="x", width="40 ken", height="1", mass="1"), "width is '40 ken'; it must be a plain number in m."),
    "negative size": (row(id="x", width="-0.4", height="1", mass="1"), "width is -0.4 m; it must be between 0.01 and 10 m"),
    "infinity": (row(id="x", width="1e999", height="1", mass="1"), "width is inf"),
    "formula": (row(id="x", width="=1+1", height="1", mass="1"), "width is a formula"),
    "no size": (row(id="x"), "width is missing"),
    "no such preset": (row(id="x", preset="wardrob"), "did you mean 'wardrobe'"),
    "friction": (row(id="x", preset="chest", floor="0.3;0.4"), "kinetic friction is 0.4"),
    "no such building": (row(id="x", preset="chest", building="tower", storey="1"), "building is 'tower'"),
    "no storey of a name": (row(id="x", preset="chest", building="office", storey="PH1"), "storey is 'PH1'; it must be 1 (on the ground) to 5 (the roof), or such as 3F, M2F, B1 to B9 or RF"),
    "storey of nought": (row(id="x", preset="chest", building="office", storey="0"), "storey is '0'; it must be 1"),
    "decimal comma between commas": (row(id="x", width='"0,4"', height="1", mass="1"), "a comma is a decimal one where semicolons stand between the columns"),
    "no storey": (row(id="x", preset="chest", building="office"), "building is given without storey"),
    "no building": (row(id="x", preset="chest", storey="2"), "building is missing"),
    "no such measure": (row(id="x", preset="chest", measures="glue"), "measures is 'glue'; it must be one of"),
    "measure twice": (row(id="x", preset="chest", measures="wedge;wedge"), "twice"),
    "measures for one place": (row(id="x", preset="chest", measures="wedge_stopper+gel_mats"), "only one of them"),
    "taller than the room": (row(id="x", width="1", height="2.5", mass="9"), "inside the ceiling"),
    "costs": (row(id="x", preset="chest", measures="wedge;sheet", costs="5"), "it must be 2 numbers"),
    "no count": (row(id="x", preset="chest", count="0"), "count is 0"),
    "duplicate": (row(id="good", preset="chest"), "it must not be that of row 2"),
    "more cells": (GOOD.replace("good", "x") + ",1", "14 cells"),
    "fewer cells": ("x,chest", "2 cells"),
    "a million characters": (row(id="x", preset="c" * 10**6), "preset has 1,000,000 characters"),
    "several lines": (row(id="x", preset='"chest\nchest"'), "it must be a text of one or more characters, not only spaces, without control characters"),
    "stray quote": ('x,"chest"z,,,,,,,,,,,', "cannot be read"),
    "invisible character": (row(id="x\u200b", preset="chest"), "id is 'x\\u200b'; it must be a text of one or more characters, not only spaces, without control characters"),
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
    "no header": ("p1,chest\n", "No heading of the first row is known"),
    "unit that is none of a size": ("id,preset,Mass (cm)\np,chest,40\n", "no unit that is known for it"),
    "endless cell": ("id,preset\np," + "c" * (2**24 + 1) + "\n", "more than 16,777,216 characters"),
    "misspelt": ("id,presett\np,chest\n", "did you mean 'preset'"),
    "column twice": ("id,preset,preset\np,chest,chest\n", "given twice"),
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


def excel(folder, rows):
    book = openpyxl.Workbook()
    for cells in rows:
        book.active.append(cells)
    file = folder / "inventory.xlsx"
    book.save(file)
    return file


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


@pytest.mark.parametrize("suffix", [".xlsx", ".parquet"])
def test_a_file_of_another_kind_is_refused(tmp_path, suffix):
    file = tmp_path / f"inventory{suffix}"
    file.write_bytes(b"PK\x03\x04 no such thing")
    with pytest.raises(sp.InputError, match="it must be"):
        plan(tmp_path, file)


def test_other_names_are_refused(tmp_path):
    file = tmp_path / "inventory.ods"
    file.write_bytes(b"")
    with pytest.raises(sp.InputError, match="that ends in"):
        assess(file, city(tmp_path), tmp_path / "out", progress=False)


def test_parquet_is_read_with_its_types(tmp_path):
    columns = {
        "id": ["a", "b", None, "d"],
        "width": [0.4, math.nan, 0.4, -1.0],
        "height": [1.8, 1.8, 1.8, 1.8],
        "mass": pa.array([100, 100, 100, 100], pa.int16()),
        "floor": pa.array(["vinyl"] * 4).dictionary_encode(),
        "gap": [Decimal("0.1"), None, None, None],
        "load": [None, None, None, [1.0, 2.0]],
    }
    file = tmp_path / "inventory.parquet"
    pq.write_table(pa.table(columns), file)
    facts, rejects = plan(tmp_path, file)
    assert facts["pieces"] == 2
    assert facts["empty cells"] == {"id": 1}
    assert [row["row"] for row in rejects] == [3, 5]
    assert "width is nan" in rejects[0]["reason"]
    assert "neither text nor number" in rejects[1]["reason"]


def test_a_broken_page_of_parquet_is_refused(tmp_path):
    file = tmp_path / "inventory.parquet"
    pq.write_table(pa.table({"id": [f"p{n}" for n in range(9000)], "preset": ["chest"] * 9000}), file)
    content = bytearray(file.read_bytes())
    content[1000:1050] = b"\xff" * 50
    file.write_bytes(content)
    with pytest.raises(sp.InputError, match=r"cannot be read"):
        plan(tmp_path, file)
