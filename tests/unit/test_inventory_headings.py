"""Headings that are not in English or Japanese, or not in the first row: the refusal says what to do."""

# ruff: noqa: E501 - a table a line

from __future__ import annotations

import re

import pytest
from inventories import city

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.columns import COLUMNS, IN_OTHER_LANGUAGES, header_name
from stayput.inventory.header import header_of
from stayput.inventory.tables import open_table

GERMAN = (
    "Inventarnr.;Bezeichnung;Breite (mm);Tiefe (mm);Höhe (mm);Gewicht (kg);Stockwerk;Gebäude;Anzahl;Preis"
)
TABLES = {
    "German": f"{GERMAN}\nS-1;Regal;900;300;1800;45,5;EG;3 RC;4;199,90 €\nS-2;Schrank;1;420;1.950;80;1. OG;3 RC;2;1.249,00 €\n",
    "German, no units": "Nr.;Tiefe;Höhe;Gewicht\n1;30;180;45,5\n2;42;195;80\n",
    "French": "N° inventaire;Désignation;Largeur (cm);Profondeur (cm);Hauteur (cm);Poids (kg);Étage;Bâtiment;Quantité\n"
    "F1;Armoire;100;42;195;80,5;RDC;3 RC;4\nF2;Armoire;100;42;195;80;2;3 RC;4\n",
    "Korean": "관리번호,품명,폭(mm),깊이(mm),높이(mm),무게(kg),층,건물,수량\nK1,책장,900,300,1800,60,2층,4 RC,3\nK2,책장,900,300,1800,60,지하1층,4 RC,3\n",
    "a comma in a heading": 'Nr.,"Tiefe (mm)","Höhe (mm)","Gewicht (kg)","Anzahl (Stück, gesamt)"\n1,300,1800,60,2\n2,300,1800,60,2\n',
}  # fmt: skip


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


@pytest.mark.parametrize("name", TABLES)
def test_a_proposal_that_is_copied_reads_every_row(tmp_path, name):
    error = refusal(tmp_path, TABLES[name])
    assert "from front to back" in str(error)
    assert "widthは奥行" in error.told("ja")
    done = assess(
        tmp_path / "inventory.csv",
        city(tmp_path),
        tmp_path / "out",
        columns=proposal_of(error).replace("Gewicht[?]", "Gewicht[kg]").replace("[?]", "[cm]"),
        progress=False,
    )
    assert (done.facts["pieces"], done.facts["rejects"]) == (2, 0)


def test_every_heading_that_may_matter_is_in_the_proposal(tmp_path):
    assert proposal_of(refusal(tmp_path, TABLES["German"])) == (
        "id=Inventarnr.,name=Bezeichnung,width=Tiefe (mm),height=Höhe (mm),mass=Gewicht (kg),storey=Stockwerk,"
        "building=Gebäude,count=Anzahl,value=Preis"
    )


@pytest.mark.parametrize(("cells", "name"), [(["Armario", "Mesa"], "name"), (["4", "12"], "count")])
def test_nombre_is_a_name_in_spanish_and_a_number_in_french(cells, name):
    rows = [["a", "30", "180", cell] for cell in cells]
    with pytest.raises(sp.InputError) as refused:
        header_of(["id", "depth (cm)", "height (cm)", "Nombre"], rows)
    assert proposal_of(refused.value) == f"{name}=Nombre"


@pytest.mark.parametrize("known", ["id", "mass", "count"])
def test_columns_that_are_not_known_are_asked_for_where_nothing_tells_the_pieces(known):
    names, rows = [known, "Bredde", "Djup", "Höjd"], [["7", "900", "300", "1800"]]
    with pytest.raises(sp.InputError) as refused:
        header_of(names, rows)
    assert proposal_of(refused.value) == "?=Bredde,?=Djup,?=Höjd"
    header_of(["name", *names[1:]], [["bookcase", *rows[0][1:]]])  # some may be of a preset's size


def test_a_heading_in_another_language_that_is_not_known_is_asked_for_while_sizes_are_missing():
    names = ["编号", "名称", "前后", "高度", "备注"]
    with pytest.raises(sp.InputError) as refused:
        header_of(names, [["1", "书柜", "300", "1800", "-"]])
    assert proposal_of(refused.value) == "id=编号,height=高度[?],?=前后,?=备注"
    with pytest.raises(sp.InputError) as refused:
        header_of([*names, "深度"], [["1", "书柜", "300", "1800", "-", "300"]])
    assert proposal_of(refused.value) == "id=编号,height=高度[?],width=深度[?]"


def test_unknown_headings_are_proposed_with_a_mark_for_each(tmp_path):
    text = "Артикул,Наименование,Глубина,Высота,Масса\n1,Шкаф,450,1800,60\n"
    error = refusal(tmp_path, text)
    proposal = proposal_of(error)
    assert proposal == "?=Артикул,?=Наименование,?=Глубина,?=Высота,?=Масса"
    given = proposal_of(refusal(tmp_path, text, "mass=Масса[kg],ignore=Артикул"))
    assert given == "mass=Масса[kg],ignore=Артикул,?=Наименование,?=Глубина,?=Высота"
    for language in ("en", "ja"):
        assert ", ".join(COLUMNS) in error.told(language)
        assert "ignore" in error.told(language)


BELOW = {
    "a title": "備品台帳\n\n作成：総務課,令和6年\n番号,品名,奥行(mm)\n1,本棚,300\n",
    "a title without marks": "Inventar 2024\n\n\nNr.;Tiefe (mm);Höhe (mm)\n1;300;1800\n",
    "empty rows": ",,\n,,\n,,\nItem No.,Item,Depth (mm)\n1,Bookcase,300\n",
}


@pytest.mark.parametrize("name", BELOW)
def test_headings_below_a_title_are_named_with_their_row(tmp_path, name):
    error = refusal(tmp_path, BELOW[name])
    assert "headings seem to stand in row 4" in str(error)
    assert "the rows above them must be removed" in str(error)
    assert "見出しが4行目" in error.told("ja")
    assert "その上の行を削除" in error.told("ja")


TWO_ROWS = {
    "sizes below one name": "番号,品名,寸法(mm),,,重量(kg)\n,,幅,奥行,高さ,\n1,本棚,900,300,1800,80\n",
    "units": "番号,品名,奥行,高さ,重量\n,,(mm),(mm),(kg)\n1,本棚,300,1800,60\n",
}


@pytest.mark.parametrize("name", TWO_ROWS)
def test_headings_of_two_rows_are_to_be_one(tmp_path, name):
    error = refusal(tmp_path, TWO_ROWS[name])
    assert "Row 2 has headings too" in str(error)
    assert "such as Depth (mm)" in str(error)
    assert "2行目にも見出し" in error.told("ja")


@pytest.mark.parametrize("encoding", ["cp1252", "latin-1"])
def test_a_western_encoding_is_not_taken_for_japanese(tmp_path, encoding):
    text = TABLES["German"].replace("€", "EUR")
    error = refusal(tmp_path, text, encoding=encoding)
    assert "CSV UTF-8" in str(error)
    assert "CSV UTF-8" in error.told("ja")


@pytest.mark.parametrize("header", ["品名,奥行(mm)", "id,preset,階", "id,name,棟A", "id,name,A棟"])
def test_a_japanese_encoding_is_still_one(tmp_path, header):
    (tmp_path / "inventory.csv").write_bytes(f"{header}\n本,1,2\n".encode("cp932"))
    with open_table(tmp_path / "inventory.csv") as found:
        assert (found.read_as, found.header) == ("cp932", header.split(","))


def test_words_of_other_languages_are_none_of_stayput():
    for name, words in IN_OTHER_LANGUAGES.items():
        assert name in COLUMNS
        for word in words:
            assert header_name(word).column is None, word
            assert header_name(f"{word} (mm)").in_another_language == name
