"""Workbooks: the cells that openpyxl reads, and what is refused of a sheet."""

from __future__ import annotations

import datetime
import zipfile

import openpyxl
import pytest

import stayput as sp
from stayput.inventory.cells import Unusable
from stayput.inventory.tables import open_table

SHEET = "xl/worksheets/sheet1.xml"
CELLS = [
    ["id", "preset", "width", "storey", None, "count"],
    ["本棚", "a_x005F_b & <c>", 0.45, 3, True, -1e-9],
    [None, " two\nlines ", 1e300, 0, False, 12345678901234],
    [],
    [datetime.datetime(2024, 1, 1), datetime.time(1), "=1+1", "#N/A", "'=x", ""],
    ["", "x" * 32767, None, None, None, 7],
]


def written(folder, rows=CELLS, merged=()):
    book = openpyxl.Workbook()
    for cells in rows:
        book.active.append(cells)
    for area in merged:
        book.active.merge_cells(area)
    book.create_sheet("more")
    book.save(folder / "inventory.xlsx")
    return folder / "inventory.xlsx"


def read(file):
    with open_table(file) as table:
        return [table.header, *(cells for _, cells in table.rows)]


def with_part(file, name, content):
    """Give a workbook another part."""
    with zipfile.ZipFile(file) as book:
        parts = {one: book.read(one) for one in book.namelist()}
    with zipfile.ZipFile(file, "w") as book:
        for one, kept in (parts | {name: content.encode()}).items():
            book.writestr(one, kept)
    return file


def test_cells_are_those_that_openpyxl_reads(tmp_path):
    file = written(tmp_path)
    wanted = openpyxl.load_workbook(file).active.iter_rows()
    for row, cells in zip(wanted, read(file), strict=True):
        for cell, found in zip(row, [*cells, *[None] * (len(row) - len(cells))], strict=True):
            if cell.data_type == "b":
                assert found == str(cell.value).lower()
            elif cell.data_type in ("f", "d", "e"):
                assert isinstance(found, Unusable), cell
            else:
                assert found == cell.value, cell
                assert type(found) is type(cell.value), cell


@pytest.mark.parametrize(
    ("area", "refused"),
    [("C2:C3", True), ("A3:B4", True), ("A2:C2", False), ("E2:F3", False), ("A9:A12", False)],
)
def test_cells_merged_over_rows_of_the_table_are_refused(tmp_path, area, refused):
    rows = ["id", "preset", "count"], ["a", "chest", 20], ["b", "chest", None], ["c", "chest", 1]
    file = written(tmp_path, rows, [area])
    if refused:
        with pytest.raises(sp.InputError, match=f"Cells {area} of the sheet are merged"):
            read(file)
    else:
        assert read(file)[3] == ["c", "chest", 1]


SPACE = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'


def sheet(cells):
    return f"<worksheet {SPACE}><dimension ref='A1:A2'/><sheetData>{cells}</sheetData></worksheet>"


def test_texts_have_no_readings_rows_may_be_left_out_and_the_stated_size_be_wrong(tmp_path):
    def text(inside):
        return f'<c t="inlineStr"><is>{inside}</is></c>'

    cells = text("<t>id</t>") + text("<r><t>pre</t></r><r><t>set</t></r>")
    others = text('<t>本棚</t><rPh sb="0" eb="2"><t>ホンダナ</t></rPh>') + text("<t>chest</t>")
    file = with_part(written(tmp_path), SHEET, sheet(f'<row>{cells}</row><row r="4">{others}</row>'))
    assert read(file) == [["id", "preset"], [None, None], [None, None], ["本棚", "chest"]]


DAMAGED = {
    "a row far below": (SHEET, sheet('<row r="99999999"/>'), "beyond 1048576"),
    "no such text": (SHEET, sheet('<row r="1"><c t="s"><v>9</v></c></row>'), "cannot be read"),
    "a number of 5000 digits": (
        SHEET,
        sheet(f'<row r="1"><c><v>{"9" * 5000}x</v></c></row>'),
        "cannot be read",
    ),
    "no sheet": ("xl/workbook.xml", "<a/>", "it must be a file of Excel"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_part_is_refused_in_a_sentence(tmp_path, name):
    part, content, reason = DAMAGED[name]
    with pytest.raises(sp.InputError, match=reason) as told:
        read(with_part(written(tmp_path, [["id"], [1]]), part, content))
    assert len(str(told.value)) < 400


def test_a_date_in_a_japanese_format_is_one(tmp_path):
    file = written(tmp_path, [["id", "count"], ["a", 45292]])
    with zipfile.ZipFile(file) as book:
        styles = book.read("xl/styles.xml").decode()
    assert 'numFmtId="0"' in styles
    with_part(file, "xl/styles.xml", styles.replace('numFmtId="0"', 'numFmtId="31"'))
    assert "a date" in read(file)[1][1].what[0]
