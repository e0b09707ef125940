"""What is found in many rows is said once, with the number of rows and the first of them."""

from __future__ import annotations

import json
import re

import pytest
from commands import cli
from inventories import CITY, city, rows_of_results, table

from stayput.inventory import assess
from stayput.inventory.report import measures_named

HEADER = "管理番号,品名,奥行(mm),高さ(mm),重量(kg),数量"
MEASURED = CITY.split("[[measures]]")[0].replace("ceiling = { height = 2.4 }\n", "") + (
    '[[measures]]\ntype = "tension_pole"\n'
    '[[measures]]\ncombine = [{ type = "wedge_stopper" }, { type = "l_bracket" }]\n'
)
ROWS = [
    *(f"a{n},机,,720,30,1" for n in range(7)),  # rows 2 to 8
    "b,本棚,300,1800,60,2",
    "b,本棚,300,1800,60,2",
    "b,本棚,300,1800,60,2",
    "c,本棚,300,1800,60,0",
    ",本棚,300,1800,60,",
    " ,本棚,300,,60,1",
    " , ,　,,,",
]


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    folder = tmp_path_factory.mktemp("findings")
    return assess(table(folder, ROWS, HEADER), city(folder, MEASURED), folder / "out", progress=False)


def said(done, language):
    """What the command prints for the results, which are complete."""
    folder = done.folder.parent
    line = "assess", folder / "inventory.csv", "--scenario", folder / "city.toml", "--out", done.folder
    result = cli(*line, "--lang", language, "--quiet")
    assert result.exit_code == 0, result.output
    return result.stdout, cli(*line, "--json").stdout


def test_every_row_is_counted(done):
    facts = done.facts
    assert (facts["rows"], facts["pieces"], facts["rejects"], facts["empty rows"]) == (14, 3, 10, 1)
    assert [row["id"] for row in rows_of_results(done)] == ["b", "本棚 #13", "本棚 #14"]


@pytest.mark.parametrize("length", [190, 200_000])
def test_a_long_id_is_shortened_in_what_is_said_of_it(tmp_path, length):
    rows = [f"{length * 'x'},chest", f"{length * 'x'},chest", "a,chest"]
    done = assess(table(tmp_path, rows, "id,preset"), city(tmp_path), tmp_path / "out", progress=False)
    assert done.facts["rejects"] == (1 if length <= 200 else 2)
    told = (*(done.folder / "rejects.csv").read_text("utf-8-sig").splitlines(), *said(done, "ja"))
    assert max(line.count("x") for line in told) < 500


@pytest.mark.parametrize(
    ("language", "sentences"),
    [
        (
            "en",
            [
                "7 rows (2, 3, 4, 5, 6, …): Column '奥行(mm)': width is missing",
                "2 rows (10, 11): Column '管理番号': id is 'b'; it must not be that of row 9",
                "1 row (12): Column '数量': count is 0",
                "Empty cells: 管理番号 in 2 rows; 数量 in 1 row; 高さ(mm) in 1 row. There a piece is",
                "tension_pole: not possible. Tension poles need a ceiling",
                "In 3 rows (9, 13, 14).",
                "as UTF-8; 1 of them empty",
            ],
        ),
        (
            "ja",
            [
                "7行（2、3、4、5、6、…行目）：列「奥行(mm)」：奥行がありません。",
                "2行（10、11行目）：列「管理番号」：番号が'b'になっていますが、9行目と同じです。",
                "1行（12行目）：列「数量」：数量が0になっています。",
                "空のセル：管理番号（2行）、数量（1行）、高さ(mm)（1行）。番号の代わりに品名と行番号",
                "ポール式（突っ張り棒）：設置できません。",
                "該当：3行（9、13、14行目）。",
                "UTF-8（空の1行を除く）として",
            ],
        ),
    ],
)
def test_a_finding_is_said_once(done, language, sentences):
    page = re.sub("<[^>]*>", " ", done.report(language).read_text(encoding="utf-8")).replace("&#39;", "'")
    printed, _ = said(done, language)
    for sentence in sentences:
        assert printed.count(sentence) == 1, sentence
        alone = sentence.partition("): ")[2] or sentence.partition("）：列")[2]
        assert page.count(alone or sentence) == 1, sentence


def test_reasons_that_differ_are_told_by_an_example(tmp_path):
    file = table(tmp_path, ["a,chest,-1", "b,chest,-2", "c,chest,1"], "id,preset,value")
    done = assess(file, city(tmp_path), tmp_path / "out", progress=False)
    printed, told = said(done, "en")
    assert "2 rows (2, 3): such as: value is -1; it must be" in printed
    (found,) = json.loads(told)["rejects alike"]
    assert (found["about"], found["rows"], found["same"]) == ("common.not_within", 2, False)
    assert [row["id"] for row in found["first"]] == ["a", "b"]
    assert "2行（2、3行目）：例：valueが-1になっています。" in said(done, "ja")[0]


def test_json_has_each_finding_once(done):
    _, told = said(done, "en")
    record = json.loads(told)
    assert [found["rows"] for found in record["rejects alike"]] == [7, 2, 1]
    assert record["rejects alike"][0]["first"][0] == {"row": 2, "id": "a0", "name": "机"}
    assert told.count("width is missing") == 1
    assert [found["about"] for found in record["measures not possible"]] == ["tension_pole"]


def test_measures_have_japanese_names_in_a_japanese_report(done):
    japanese = done.report("ja").read_text(encoding="utf-8").partition("<body>")[2]
    assert not re.search("tension_pole|wedge_stopper|l_bracket", japanese)
    assert measures_named("wedge_stopper + l_bracket")[1] == measures_named("wedge_stopper+l_bracket")[1]
    english, named = measures_named("wedge_stopper + mine")
    assert named.endswith("+mine")
    assert english == "wedge_stopper + mine"
