"""Hostile tables, mutated by their grammar: each row is accounted for, or the table is refused.

HYPOTHESIS_PROFILE=thorough tries many more.
"""

from __future__ import annotations

import io
import sys
import tempfile
import zipfile
from contextlib import closing
from pathlib import Path

import openpyxl
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp
from stayput.inventory.folder import Workspace
from stayput.inventory.plan import REJECTED, make_plan
from stayput.inventory.scenarios import read_scenarios
from stayput.inventory.store import Store

sys.path.insert(0, str(Path(__file__).parents[1] / "unit"))
from inventories import city

pytestmark = pytest.mark.hostile

GOOD = [
    ["id", "preset", "width", "height", "mass", "load", "floor", "building", "storey", "measures", "costs"],
    ["a", "bookcase", "", "", "", "10;5", "vinyl", "office", "3", "wedge;sheet", "10;20"],
    ["b", "", "0.4", "1.8", "100", "", "0.4;0.3", "2 wood", "2", "gel_mats+tension_pole", ""],
    ["c", "chest", "0.45", "", "", "", "", "", "", "", ""],
]
NUMBERS = ["nan", "-inf", "1e999", "-0", "1e-320", "9" * 5000, "1_0", "0x10", "０．４", "1,5", "10 cm"]
LISTS = [";", ";;;;", "+", "+".join(["wedge"] * 50), ";".join(["wedge"] * 200), "1;" * 300]
BUILDINGS = ["999999999 RC", "-1 RC", "0 wood", "RC 10"]
TEXTS = ["=1+1", "@x", "'", '"', "\x00", "\ufeff", "\u202e", "\ud7ff", "a\nb", "a\rb", " ", "\u3000"]
CELLS = st.one_of(
    st.sampled_from([*NUMBERS, *LISTS, *BUILDINGS, *TEXTS, "真" * 300, "x" * 100_000]),
    st.text(max_size=8),
    st.floats().map(repr),
    st.integers().map(str),
)
places = st.integers(0, 10**6)


@st.composite
def rows(draw):
    """A good table of which cells, rows and columns are replaced, repeated, left out or exchanged."""
    found = [list(row) for row in GOOD]
    for _ in range(draw(st.integers(1, 6))):
        row = found[draw(places) % len(found)]
        place = draw(places) % (len(row) or 1)
        match draw(
            st.sampled_from(["cell", "cell", "cell", "more", "less", "twice", "swap", "row", "no row"])
        ):
            case "cell" if row:
                row[place] = draw(CELLS)
            case "more":
                row.insert(place, draw(CELLS))
            case "less" if row:
                del row[place]
            case "twice" if row:
                row.append(row[place])
            case "swap" if row:
                row[place], row[-1] = row[-1], row[place]
            case "row":
                found.append(list(row))
            case "no row" if len(found) > 1:
                del found[draw(places) % len(found)]
            case _:
                pass
    return found


@st.composite
def damaged(draw, content: bytes):
    """Bytes of which some are cut, replaced, repeated or put in."""
    for _ in range(draw(st.integers(1, 4))):
        start = draw(places) % (len(content) or 1)
        stop = start + draw(st.integers(0, 40))
        part = draw(
            st.sampled_from([b"", b'"', b"\0", b"\r", b",,", b"\xff\xfe", b"\x81", content[start:stop] * 3])
        )
        content = content[:start] + draw(st.sampled_from([part, bytes(8), b"\xff" * 4])) + content[stop:]
    return content


@pytest.fixture(scope="module")
def cities():
    with tempfile.TemporaryDirectory() as folder:
        yield read_scenarios(city(Path(folder)))


def check(cities, suffix: str, content: bytes) -> None:
    """Every row is a piece, a reject or empty; or one sentence refuses the table, and leaves nothing."""
    with tempfile.TemporaryDirectory() as folder:
        file, plan = Path(folder) / f"inventory{suffix}", Path(folder) / "plan.sqlite"
        file.write_bytes(content)
        refused, facts = None, {}
        try:
            facts = make_plan(Workspace(Path(folder)), file, cities, 2**22, lambda count: None)
        except sp.InputError as error:
            refused = str(error)
        assert not list((Path(folder) / "drafts").iterdir())
        if refused is not None:
            assert refused.endswith(".")
            assert "\n" not in refused
            assert len(refused) < 3000
            assert not plan.exists()
            return
        with closing(Store(plan)) as store:
            rejects = [dict(zip(REJECTED, line, strict=True)) for line in store.rejects()]
            good = [row["row"] for part in range(facts["parts"]) for row in store.part(part)]
    assert facts["rows"] == len(set(good)) + len(rejects) + facts["empty rows"]
    assert not {row["row"] for row in rejects} & set(good)
    for row in rejects:
        assert row["reason"].endswith(".")
        assert len(row["reason"]) < 1500


def as_csv(table: list[list[str]]) -> str:
    import csv

    text = io.StringIO()
    csv.writer(text).writerows(table)
    return text.getvalue()


def as_workbook(table: list[list[str]]) -> bytes:
    book, content = openpyxl.Workbook(), io.BytesIO()
    for row in table:
        book.active.append([cell if cell.isprintable() else "?" for cell in row])
    book.save(content)
    return content.getvalue()


@given(
    rows(), st.sampled_from(["utf-8", "utf-8-sig", "cp932", "utf-16"]), st.sampled_from(["\r\n", "\n", "\r"])
)
def test_cells_of_csv(cities, table, encoding, end):
    text = as_csv(table).replace("\r\n", end)
    check(cities, ".csv", text.encode(encoding, "replace"))


@given(damaged(as_csv(GOOD).encode()))
def test_bytes_of_csv(cities, content):
    check(cities, ".csv", content)


@given(rows())
def test_cells_of_a_workbook(cities, table):
    short = [[cell[:1000] for cell in row] for row in table]
    check(cities, ".xlsx", as_workbook(short))


BOOK = as_workbook(GOOD)
PARTS = [
    "xl/worksheets/sheet1.xml",
    "xl/styles.xml",
    "xl/workbook.xml",
    "xl/_rels/workbook.xml.rels",
    "_rels/.rels",
]


@given(st.sampled_from(PARTS), st.data())
def test_parts_of_a_workbook(cities, part, data):
    content = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(BOOK)) as before, zipfile.ZipFile(content, "w") as after:
        for name in before.namelist():
            kept = before.read(name)
            after.writestr(name, data.draw(damaged(kept)) if name == part else kept)
    check(cities, ".xlsx", content.getvalue())


@given(damaged(BOOK))
def test_bytes_of_a_workbook(cities, content):
    check(cities, ".xlsx", content)


def as_parquet() -> bytes:
    content = io.BytesIO()
    pq.write_table(pa.table(dict(zip(GOOD[0], map(list, zip(*GOOD[1:], strict=True)), strict=True))), content)
    return content.getvalue()


@given(damaged(as_parquet()))
def test_bytes_of_parquet(cities, content):
    check(cities, ".parquet", content)
