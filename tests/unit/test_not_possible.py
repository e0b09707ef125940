"""Measures that cannot be put in place, and runs that were all given up: never a number, and never 0 %."""

import csv
import io
import json
import re
from dataclasses import replace

import pytest
import verdict_cases
from inventories import city, rows_of_results, table

import stayput as sp
from long_cases import long
from stayput.app.verification import verdict_reply
from stayput.inventory import assess
from stayput.measures import Belt, TensionPole
from stayput.report.verdict.exports import write_curves
from stayput.report.verdict.html import report_html
from stayput.report.verdict.tables import verdict_csv, verdict_markdown
from stayput.scenario.measures import Option
from stayput.verification import verify
from stayput.verification.options import Impossible, compared_options

TABLES = {
    "furniture": {"preset": "chest"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 1.5}},
    "shaking": {"builtin": "near-fault", "scale": 0.3},
    "uncertainty": {"samples": 2},
}
STEEP = {"type": "belt", "angle": 1.3, "name": "急なベルト"}
REASON = "puts its anchor at 1.8"


def scenario(*measures, **tables):
    given = {"measures": list(measures)} if measures else {}
    return sp.Scenario.parse({**TABLES, **given, **tables})


@pytest.fixture(scope="module")
def verdict():
    return verify(scenario(STEEP, {"type": "felt_glides"}), levels=())


def test_an_anchor_above_the_ceiling_is_not_possible_and_the_rest_is_verified(verdict):
    assert {one.option.name for one in verdict.options} == {"none", "felt_glides"}
    (one,) = verdict.impossible
    assert (one.option.name, one.option.measures) == ("急なベルト", (Belt(angle=1.3),))
    assert REASON in one.why("en")
    assert "床と天井の間" in one.why("ja")


@pytest.mark.parametrize(("language", "said"), [*long(("en", "not possible")), ("ja", "設置不可")])
def test_every_form_says_so_with_the_reason(verdict, language, said):
    (one,) = verdict.impossible
    why = one.why(language)
    html = report_html(verdict, language).replace("\xa0", " ")
    place = html.index(why)
    assert said in html[place : place + 300]
    assert "急なベルト" in html[place - 300 : place]
    text = verdict_markdown(verdict, language)
    (line,) = [line for line in text.splitlines() if line.startswith("| –")]
    assert [part in line for part in (said, why, "急なベルト")] == [True] * 3
    assert not re.search(r"\d ?%", line)
    columns = {line.count(" | ") for line in text.splitlines() if line.startswith(("| –", "| 1", "| 2"))}
    assert len(columns) == 1
    reply = verdict_reply(verdict)
    assert [other["reason"][language] for other in reply.not_possible] == [why]
    data = json.loads(verdict.to_json())
    (told,) = data["not_possible"]
    assert (told["reason"][language], told["name"], len(data["options"])) == (why, "急なベルト", 2)


def test_its_row_of_the_csv_has_no_number(verdict):
    *possible, row = csv.DictReader(io.StringIO(verdict_csv(verdict)))
    assert (row["option"], row["rank"], row["overturned"], row["runs"]) == ("急なベルト", "", "", "")
    assert REASON in row["not_possible"]
    assert all(other["not_possible"] == "" for other in possible)


def test_its_curve_is_missed_with_the_reason(tmp_path):
    other = Impossible(
        Option("belt", ((Belt(angle=1.3),),)), sp.InputError("Belts angle is 1.3 rad, and so on.")
    )
    verdict = replace(verdict_cases.made(), impossible=(other,))
    _, left_out = write_curves(verdict, next(iter(verdict.without.curves)), tmp_path / "curves")
    assert "belt is in no file: it cannot be put in place. Belts angle is 1.3 rad, and so on." in left_out


def test_usual_measures_that_do_not_fit_are_not_possible_either():
    options, impossible = compared_options(scenario(room={"floor": "carpet"}))
    assert "felt_glides" in {option.name for option in options}
    reasons = {one.option.name: one for one in impossible}
    assert {"l_bracket", "belt", "tension_pole", "wedge_stopper + tension_pole"} <= set(reasons)
    assert reasons["tension_pole"].why("en").startswith("Tension poles need a ceiling")
    assert reasons["tension_pole"].why("ja").startswith("「ポール式（突っ張り棒）」には天井が必要です。")
    assert reasons["belt"].why("ja") == "「ベルト式」には背面の壁が必要です。"


def test_where_nothing_is_left_to_compare_it_is_refused():
    with pytest.raises(sp.InputError, match=REASON):
        verify(scenario(STEEP), levels=())
    sentence = sp.InputError("A sentence that nobody has put into Japanese.")
    poles = Impossible(Option("p", ((TensionPole(),),)), sentence)
    assert poles.why("ja") == poles.why("en")


@pytest.mark.parametrize("language", ["en", "ja"])
def test_runs_that_were_all_given_up_are_never_nought_per_cent(language):
    verdict = verdict_cases.without_numbers()
    texts = [verdict_markdown(verdict, language), verdict.sentence(language)]
    assert not any(re.search(r"(?<![\d.])0 ?%", text) for text in texts)
    data = json.loads(verdict.to_json())
    assert all(one["probabilities"]["overturned"]["estimate"] is None for one in data["options"])
    rows = list(csv.DictReader(io.StringIO(verdict_csv(verdict))))
    assert all(row["overturned"] == "" for row in rows)


def test_an_inventory_assesses_what_is_possible_and_names_what_is_not(tmp_path):
    rows = [
        "both,,1,2.39,90,,,,,tension_pole;felt_glides,700;30,1,20000",
        "one,,1,2.39,90,,,,,tension_pole,,1,",
        "fits,chest,,,,,,,,tension_pole;felt_glides,700;30,1,20000",
    ]
    done = assess(table(tmp_path, rows), city(tmp_path), tmp_path / "out", threads=1, progress=False)
    both, one, fits = rows_of_results(done)
    assert [option["name"] for option in both["options"]] == ["none", "felt_glides"]
    assert [option["cost"] for option in both["options"]] == [0.0, 30.0]
    assert [option["cost"] for option in fits["options"]] == [0.0, 700.0, 30.0]
    (missing,) = both["not_possible"]
    assert missing["name"] == "tension_pole"
    assert "The space below the ceiling for “Tension poles” is 0.01 m" in missing["reason"]
    assert [option["name"] for option in one["options"]] == ["none"]
    assert one["not_possible"] == both["not_possible"]
    assert fits["not_possible"] == []
    page = (done.folder / "report.html").read_text(encoding="utf-8").replace("\xa0", " ")
    assert "tension_pole: not possible. The space below the ceiling for “Tension poles” is 0.01 m" in page
