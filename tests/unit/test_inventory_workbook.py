"""Workbooks as a stream: the cells that openpyxl reads, and little memory for what unpacks to a lot."""

from __future__ import annotations

import datetime
import json
import subprocess
import sys
import zipfile

import openpyxl
import pytest

import stayput as sp
from stayput.inventory.cells import Unusable
from stayput.inventory.tables import open_table

SHEET, TEXTS, STYLES = "xl/worksheets/sheet1.xml", "xl/sharedStrings.xml", "xl/styles.xml"
RELATIONS = "xl/_rels/workbook.xml.rels"
RELATION = b'<Relationship Type="x/sharedStrings" Target="/xl/sharedStrings.xml" Id="texts"/>'
CELLS = [
    ["id", "preset", "width", "storey", None, "count"],
    ["本棚", "a_x005F_b & <c>", 0.45, 3, True, -1e-9],
    [None, " two\nlines ", 1e300, 0, False, 12345678901234],
    [],
    [datetime.datetime(2024, 1, 1), datetime.time(1), "=1+1", "#N/A", "'=x", ""],
    ["", "x" * 32767, None, None, None, 7],
]


def written(folder, rows=CELLS):
    book = openpyxl.Workbook()
    for cells in rows:
        book.active.append(cells)
    book.create_sheet("more")
    book.save(folder / "inventory.xlsx")
    return folder / "inventory.xlsx"


def read(file, memory=2**24):
    with open_table(file, memory) as table:
        return [table.header, *(cells for _, cells in table.rows)]


def with_part(file, name, content):
    """Give a workbook another part: text, or chunks of it."""
    with zipfile.ZipFile(file) as book:
        parts = {one: book.read(one) for one in book.namelist() if one != name}
    if name == TEXTS and RELATION not in parts[RELATIONS]:
        parts[RELATIONS] = parts[RELATIONS].replace(b"</Relationships>", RELATION + b"</Relationships>")
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as book:
        for one, kept in parts.items():
            book.writestr(one, kept)
        with book.open(name, "w", force_zip64=True) as part:
            for chunk in [content] if isinstance(content, str) else content:
                part.write(chunk.encode())
    return file


def test_cells_are_those_that_openpyxl_reads(tmp_path):
    file = written(tmp_path)
    wanted = openpyxl.load_workbook(file).active.iter_rows()
    for row, cells in zip(wanted, read(file), strict=True):
        for cell, found in zip(row, [*cells, *[None] * (len(row) - len(cells))], strict=True):
            if cell.data_type in ("f", "d", "b", "e"):
                assert isinstance(found, Unusable), cell
            else:
                assert found == cell.value, cell
                assert type(found) is type(cell.value), cell


@pytest.mark.parametrize(
    ("area", "refused"),
    [("C2:C3", True), ("A3:B4", True), ("A2:C2", False), ("E2:F3", False), ("A9:A12", False)],
)
def test_cells_merged_over_rows_of_the_table_are_refused(tmp_path, area, refused):
    book = openpyxl.Workbook()
    for cells in (["id", "preset", "count"], ["a", "chest", 20], ["b", "chest", None], ["c", "chest", 1]):
        book.active.append(cells)
    book.active.merge_cells(area)
    book.save(tmp_path / "inventory.xlsx")
    if refused:
        with pytest.raises(sp.InputError, match=f"Cells {area} of the sheet are merged"):
            read(tmp_path / "inventory.xlsx")
    else:
        assert read(tmp_path / "inventory.xlsx")[3] == ["c", "chest", 1]


def test_texts_have_no_readings_and_rows_may_be_left_out(tmp_path):
    file = written(tmp_path, [["id", "preset"], ["本棚", "chest"]])
    texts = "<si><t>id</t></si><si><r><t>pre</t></r><r><t>set</t></r></si>"
    texts += '<si><t>本棚</t><rPh sb="0" eb="2"><t>ホンダナ</t></rPh><phoneticPr fontId="1"/></si>'
    with_part(file, TEXTS, f"<x:sst xmlns:x='y'>{texts}</x:sst>")
    cells = '<c t="s"><v>0</v></c><c r="B1" t="s"><v>1</v></c>'
    others = '<c t="s"><v>2</v></c><c t="inlineStr"><is><t>chest</t></is></c>'
    with_part(file, SHEET, sheet(f'<row>{cells}</row><row r="4">{others}</row>'))
    assert read(file) == [["id", "preset"], [None, None], [None, None], ["本棚", "chest"]]


def sheet(cells):
    return f"<worksheet><sheetData>{cells}</sheetData></worksheet>"


def repeated(before, part, times, after):
    yield before
    for _ in range(times):
        yield part * 1000
    yield after


HEAD = '<worksheet><sheetData><row><c t="str"><v>id</v></c></row>'
DAMAGED = {
    "a row twice": (SHEET, sheet('<row r="2"/><row r="2"/>'), "row 2 does not follow row 2"),
    "a row far below": (SHEET, sheet('<row r="99999999"/>'), "beyond 1048576"),
    "a column far off": (SHEET, sheet('<row r="1"><c r="ZZZ1"/></row>'), "beyond 16384"),
    "columns in disorder": (SHEET, sheet('<row r="1"><c r="B1"/><c r="A1"/></row>'), "follow column 2"),
    "no such text": (SHEET, sheet('<row r="1"><c t="s"><v>9</v></c></row>'), "has no text 9"),
    "a number of 5000 digits": (SHEET, sheet(f'<row r="1"><c><v>{"9" * 5000}x</v></c></row>'), "is broken"),
    "entities": (SHEET, '<!DOCTYPE a [<!ENTITY b "c">]>' + sheet(""), "declares a document type"),
    "nested": (SHEET, sheet("<row>" + "<a>" * 100), "nests more than 50"),
    "many formats": (STYLES, "<a><cellXfs>" + "<xf/>" * 100_001 + "</cellXfs></a>", "100000 formats"),
}  # fmt: skip


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_part_is_refused_in_a_sentence(tmp_path, name):
    part, content, reason = DAMAGED[name]
    with pytest.raises(sp.InputError, match=reason) as told:
        read(with_part(written(tmp_path, [["id"], [1]]), part, content))
    assert len(str(told.value)) < 400


@pytest.mark.parametrize("part", ["xl/workbook.xml", "_rels/.rels", "xl/_rels/workbook.xml.rels"])
@pytest.mark.parametrize("content", ["", "<a/>", "<a>", "<Relationships/>"])
def test_a_book_without_sheets_is_none(tmp_path, part, content):
    with pytest.raises(sp.InputError, match="it must be a file of Excel"):
        read(with_part(written(tmp_path), part, content))


BOMBS = {
    "texts": (TEXTS, repeated("<sst>", "<si><t>abcdefgh</t></si>", 4000, "</sst>"), "than 16 MiB of texts"),
    "one text": (TEXTS, repeated("<sst><si><t>", "a" * 10, 8000, "</t></si></sst>"), "goes beyond"),
    "one cell": (SHEET, repeated(f"{HEAD}<row><c><v>", "a" * 10, 8000, ""), "goes beyond"),
    "one tag": (SHEET, repeated(f"{HEAD}<row ", "a" * 10, 8000, ""), "a tag"),
    "rows": (SHEET, repeated(HEAD, "<row/>", 1100, "</sheetData></worksheet>"), "beyond 1048576"),
    # two million elements are enough: a tree of them would take 200 MB
    "others": (SHEET, repeated(HEAD, "<a><b/></a>", 1000, "</sheetData></worksheet>"), None),
}  # fmt: skip
READS = """
import json, resource, sys
from stayput.errors import InputError
from stayput.inventory.tables import open_table
from pathlib import Path

before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
for file in sys.argv[1:]:
    said = ""
    try:
        with open_table(Path(file), 2**24) as table:
            for _ in table.rows:
                pass
    except InputError as error:
        said = str(error)
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) // 1024
    print(json.dumps([said, grown]))
"""


@pytest.fixture(scope="module")
def readings(tmp_path_factory):
    """What one process says of each, and by how much its memory has grown by then [MiB]."""
    files = {}
    for name, (part, content, _) in BOMBS.items():
        folder = tmp_path_factory.mktemp("bomb")
        files[name] = with_part(written(folder, [["id"], ["a"]]), part, content)
        if part == TEXTS:
            with_part(files[name], SHEET, sheet('<row><c t="s"><v>0</v></c></row>'))
        assert files[name].stat().st_size < 2**20
    line = [sys.executable, "-c", READS, *map(str, files.values())]
    done = subprocess.run(line, capture_output=True, text=True, check=True)
    return dict(zip(files, map(json.loads, done.stdout.splitlines()), strict=True))


@pytest.mark.parametrize("name", BOMBS)
def test_what_unpacks_to_a_lot_takes_little_memory(readings, name):
    said, grown = readings[name]
    reason = BOMBS[name][2]
    assert grown < 150, said  # of which openpyxl itself takes some 30
    assert said == "" if reason is None else reason in said
