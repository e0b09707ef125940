"""``stayput verify`` and its curves: what it prints and writes, how wide, and what it refuses."""

import csv
import json
from codecs import BOM_UTF8
from pathlib import Path

import pytest
from commands import BEDROOM, BOOKCASE, SLENDER, cli
from rich.cells import cell_len

from stayput.catalogue import LANGUAGES, say

GLIDES = '[[measures]]\nname = "glides"\ntype = "felt_glides"\n'


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("scenario") / "block.toml"
    scene = SLENDER.replace('"near-fault"', '"near-fault"\nscale = 0.8').replace("samples = 4", "samples = 6")
    path.write_text('title = "A slender block"\n' + scene + GLIDES)
    return path


@pytest.fixture(scope="module")
def done(file):
    names = ("r.html", "r.md", "r.csv")
    html, markdown, table = (file.parent / name for name in names)
    result = cli("verify", file, "--report", html, "--markdown", markdown, "--csv", table, "--json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout), html, markdown, table


def test_json_markdown_csv_and_report_say_the_same(done):
    data, html, markdown, table = done
    assert table.read_bytes().startswith(BOM_UTF8)  # by which Excel tells its encoding
    rows = {row["option"]: row for row in csv.DictReader(table.open(encoding="utf-8-sig"))}
    assert [one["name"] for one in data["options"]] == list(rows)
    assert set(rows) == {"none", "belt", "glides"}
    for one in data["options"]:
        assert float(rows[one["name"]]["overturned"]) == one["probabilities"]["overturned"]["estimate"]
        assert one["label"]["en"] in markdown.read_text()
        assert one["label"]["en"] in html.read_text()
    assert data["verdict"]["en"] in markdown.read_text().replace("\\", "")
    assert {one["runs"] for one in data["options"]} == {6}


def test_what_is_printed_is_the_verdict(file, done):
    result = cli("verify", file, "--lang", "ja", "--slide-limit", "0.05", "--threads", "2")
    assert result.exit_code == 0, result.output
    data = done[0]
    assert data["verdict"]["ja"] in result.stdout.replace("\n", "")
    assert "5.0 cm" in result.stdout
    assert "glides" in result.stdout
    assert all(one["label"]["ja"] in result.stdout for one in data["options"])


def test_the_reports_toml_makes_the_same_verdict(file, done, tmp_path):
    again = tmp_path / "again.toml"
    again.write_text(done[0]["scenario_toml"], encoding="utf-8")
    data = json.loads(cli("verify", again, "--json").stdout)
    assert {**data, "seconds": 0} == {**done[0], "seconds": 0}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--lang", "fr"], "The language is 'fr'; it must be one of 'en', 'ja'."),
        (["--report", "r.txt"], "ends in .html"),
        (["--report", "nowhere/r.html"], "in a folder that exists"),
        (["--markdown", "r.html"], "ends in .md"),
        (["--csv", "r.html"], "ends in .csv"),
        (["--slide-limit", "-1"], "--slide-limit"),
        (["--threads", "0"], "Threads"),
    ],
)
def test_what_is_wrong_is_refused_before_any_work(file, arguments, said):
    result = cli("verify", file, *arguments)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stdout == ""


@pytest.fixture(scope="module")
def curves(file):
    out = file.parent / "curves"
    result = cli("verify", file, "--curves", out, "--im", "PGV", "--measure", "glides")
    assert result.exit_code == 0, result.output
    return result, out


def test_curves_are_written_with_counts_a_figure_and_the_forms_of_loss_tools(curves):
    result, out = curves
    assert {path.name for path in out.iterdir()} >= {"curves.csv", "observed.csv", "fragility.svg"}
    observed = list(csv.DictReader((out / "observed.csv").open(encoding="utf-8-sig")))
    assert {row["option"] for row in observed} == {"none", "glides"}
    assert all(int(row["overturned"]) <= int(row["runs"]) <= 6 for row in observed)
    for row in csv.DictReader((out / "curves.csv").open(encoding="utf-8-sig")):
        assert float(row["pgv_m_s"]) > 0.0
        assert 0.0 <= float(row["probability"]) <= 1.0
        assert row["method"] == "logit"
    assert "one motion" in result.stdout.lower()
    named = {path.name for path in out.iterdir()}
    assert all(f"Wrote {out / name}" in result.stdout for name in named)
    assert ("pelicun.csv" in named) == ("nrml.xml" in named)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--im", "SA(0.5s)"], "'PFA', 'PFV', 'MMI', or SA(T) with a period T in seconds: SA(0.5)."),
        (["--im", "PGAA"], "--im is 'PGAA' (did you mean 'PGA'?); it must be one of"),
        (["--measure", "belts"], "--measure is 'belts' (did you mean 'belt'?)"),
    ],
)
def test_curves_are_refused_in_a_sentence(file, tmp_path, arguments, said):
    result = cli("verify", file, "--curves", tmp_path / "out", *arguments)
    assert result.exit_code == 2
    assert said in result.stderr
    assert not (tmp_path / "out").exists()


def test_the_folder_of_the_curves_must_be_one(file, tmp_path):
    (tmp_path / "there").write_text("")
    assert "there' is a file" in cli("verify", file, "--curves", tmp_path / "there").stderr


def printed(folder: Path, scenario: str, width: int, *flags: str, command: str = "verify") -> str:
    file = folder / "scenario.toml"
    file.write_text(scenario, encoding="utf-8")
    done = cli(command, file, *flags, COLUMNS=str(width))
    assert done.exit_code == 0, done.output
    return done.stdout


@pytest.mark.parametrize("language", LANGUAGES)
def test_changes_of_a_room_are_a_list_where_their_table_would_break(tmp_path: Path, language: str) -> None:
    more = "--lang", language, "--set", "uncertainty.samples=4"  # in which somebody is hit
    narrow, wide = (printed(tmp_path, BEDROOM, width, *more) for width in (80, 400))
    heading = say("room_report.changed_shut_in", language)
    assert "".join(narrow.split()).count("".join(heading.split())) == 3  # beside each value
    assert wide.count(heading) == 1
    assert all(cell_len(line) <= 80 for line in narrow.splitlines())


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_ranking_that_is_too_wide_leaves_out_its_capacities(tmp_path: Path, language: str) -> None:
    narrow, wide = (
        printed(tmp_path, BOOKCASE, width, "--lang", language).splitlines() for width in (60, 100)
    )
    (told, *_) = (line for line in wide if "I50" in line)
    assert told.rstrip().endswith("I50")
    table = narrow[: next(n for n, line in enumerate(narrow) if line.startswith("–"))]
    table = [line for line in table if line[:1] in "123456789 "]
    assert not any("I50" in line for line in table)
    assert all(cell_len(line) <= 60 for line in table)


def test_simulate_names_the_stated_shaking(tmp_path: Path) -> None:
    assert "peak ground velocity 50 cm/s = 0.5 m/s" in printed(
        tmp_path, BOOKCASE, 200, "--set", "shaking.pgv=0.5", command="simulate"
    )
