"""Headings that are not known, or not in the first row: the refusal says what to do."""

from __future__ import annotations

import re

import pytest
from inventories import city

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.columns import COLUMNS
from stayput.inventory.header import Header
from stayput.inventory.tables import open_table

GERMAN = (
    "Inventarnr.;Bezeichnung;Tiefe (mm);Höhe (mm);Gewicht (kg);Stockwerk;Gebäude;Anzahl (Stück)\n"
    "S-1;Regal;300;1800;45,5;EG;3 RC;4\nS-2;Schrank;420;1.950;80;1. OG;3 RC;2\n"
)
KNOWN = (
    "name=Bezeichnung,width=Tiefe (mm),height=Höhe (mm),mass=Gewicht (kg),storey=Stockwerk,building=Gebäude"
)


def refusal(folder, text, columns=None, encoding="utf-8-sig", name="inventory.csv"):
    """The refusal of a table."""
    (folder / name).write_bytes(text.encode(encoding))
    with pytest.raises(sp.InputError) as refused:
        assess(folder / name, city(folder), folder / "out", columns=columns, progress=False)
    return refused.value


def proposal_of(error):
    """The line of a refusal that can be copied, which is the same in both languages."""
    found = {re.search('--columns "(.+?)"', error.told(language))[1] for language in ("en", "ja")}
    assert len(found) == 1
    return found.pop()


def test_headings_that_are_not_known_are_proposed_with_a_mark_for_each(tmp_path):
    error = refusal(tmp_path, GERMAN)
    assert proposal_of(error) == (
        "?=Tiefe (mm),?=Höhe (mm),count=Anzahl (Stück),"
        "?=Inventarnr.,?=Bezeichnung,?=Gewicht (kg),?=Stockwerk,?=Gebäude"
    )
    assert "from front to back" in str(error)
    assert "widthは奥行" in error.told("ja")
    for language in ("en", "ja"):
        assert ", ".join(COLUMNS) in error.told(language)
        assert "ignore" in error.told(language)
    given = proposal_of(refusal(tmp_path, GERMAN, f"{KNOWN},ignore=Inventarnr."))
    assert given == f"{KNOWN},ignore=Inventarnr.,count=Anzahl (Stück)"
    done = assess(tmp_path / "inventory.csv", city(tmp_path), tmp_path / "out", columns=given, progress=False)
    assert (done.facts["pieces"], done.facts["rejects"]) == (2, 0)


@pytest.mark.parametrize("known", ["id", "mass", "count"])
def test_columns_that_are_not_known_are_asked_for_where_nothing_tells_the_pieces(known):
    names, rows = [known, "Bredde", "Djup", "Höjd"], [["7", "900", "300", "1800"]]
    with pytest.raises(sp.InputError) as refused:
        Header(names, rows)
    assert proposal_of(refused.value) == "?=Bredde,?=Djup,?=Höjd"
    Header(["name", *names[1:]], [["bookcase", *rows[0][1:]]])  # some may be of a preset's size


ELSEWHERE = {
    "a title": (4, "備品台帳\n\n作成：総務課,令和6年\n番号,品名,奥行(mm)\n1,本棚,300\n"),
    "a title without marks": (4, "Furniture 2024\n\n\nNo.;Depth (mm);Height (mm)\n1;300;1800\n"),
    "empty rows": (4, ",,\n,,\n,,\nItem No.,Item,Depth (mm)\n1,Bookcase,300\n"),
    "sizes below one name": (2, "番号,品名,寸法(mm),,,重量(kg)\n,,幅,奥行,高さ,\n1,本棚,900,300,1800,80\n"),
    "units": (2, "番号,品名,奥行,高さ,重量\n,,(mm),(mm),(kg)\n1,本棚,300,1800,60\n"),
}


@pytest.mark.parametrize("name", ELSEWHERE)
def test_headings_are_one_row_the_first(tmp_path, name):
    row, text = ELSEWHERE[name]
    error = refusal(tmp_path, text)
    assert f"Row {row} has headings" in str(error)
    assert "rows above them must be removed" in str(error)
    assert f"{row}行目に見出し" in error.told("ja")
    assert "その上の行を削除" in error.told("ja")


@pytest.mark.parametrize("encoding", ["cp1252", "latin-1"])
def test_a_western_encoding_is_not_taken_for_japanese(tmp_path, encoding):
    error = refusal(tmp_path, GERMAN, encoding=encoding)
    assert "CSV UTF-8" in str(error)
    assert "CSV UTF-8" in error.told("ja")


@pytest.mark.parametrize("header", ["品名,奥行(mm)", "id,preset,階", "id,name,棟A", "id,name,A棟"])
def test_a_japanese_encoding_is_still_one(tmp_path, header):
    (tmp_path / "inventory.csv").write_bytes(f"{header}\n本,1,2\n".encode("cp932"))
    with open_table(tmp_path / "inventory.csv") as found:
        assert (found.read_as, found.header) == ("cp932", header.split(","))
