"""A verdict as JSON, CSV and Markdown: the same numbers, in both languages, whatever it is called."""

import csv
import io
import json
import math
import re
import string
import tomllib
from dataclasses import replace

import numpy as np
import pytest
import verdict_cases
from verdict_cases import SCENARIO, made

import stayput as sp
from stayput.catalogue import names, phrase, runs, say
from stayput.catalogue.report import TEXTS
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import INTENSITY_MEASURES
from stayput.fragility.probabilities import probability
from stayput.fragility.trials import Trials
from stayput.measures import MEASURES, Belt
from stayput.model.body import FURNITURE
from stayput.montecarlo.counting import Quantiles
from stayput.motion.suites.families import FAMILIES
from stayput.motion.suites.synthesis import synthetic_suite
from stayput.report.names import given_name
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.data import verdict_data
from stayput.report.verdict.exports import write_curves
from stayput.report.verdict.numbers import capacity, capacity_interval, change, force, length, share
from stayput.report.verdict.tables import (
    DEVICE_COLUMNS,
    device_rows,
    simulations,
    verdict_csv,
    verdict_markdown,
)
from stayput.scenario.measures import Option
from stayput.simulation.outcome import EventKind, Mode, Outcome
from stayput.uncertainty import USUAL
from stayput.verification.contents import ContentsVerdict, Leaving
from stayput.verification.notes import SlidingShare, everyday_note
from stayput.verification.words import headline, reason, title


def test_every_mode_outcome_preset_and_quantity_has_its_words():
    assert set(names.MODES) == set(Mode)
    assert set(names.OUTCOMES) == set(Outcome)
    assert set(names.EVENTS) == set(EventKind)
    of_one = set(Outcome) - {Outcome.FELL_OFF, Outcome.ROLLED}  # in space alone
    assert {outcome.value for outcome in of_one} <= set(runs.TEXTS)
    assert {f"quantity_{name}" for name in USUAL} <= set(TEXTS)
    assert set(names.PIECES) == set(FURNITURE)
    assert set(FAMILIES) <= {*names.FAMILIES, *names.MOTIONS}
    assert all(all(measure.label) and all(measure.about) for measure in MEASURES.values())


def test_it_says_how_often_each_option_ran():
    verdict = verdict_cases.made()
    belt, *others = verdict.options
    raced = replace(verdict, options=(replace(belt, runs=16), *others))
    data = json.loads(raced.to_json())
    assert (data["runs"], [option["runs"] for option in data["options"]]) == (2400, [16, 80, 80])
    for language, each in (("en", "16 to 80"), ("ja", "16～80")):
        assert "2,400" in simulations(raced, language)
        assert each in simulations(raced, language)
        assert each not in simulations(verdict, language)
    assert simulations(raced, "en") in verdict_markdown(raced)


def test_json_has_no_number_that_json_does_not_know():
    for verdict in (verdict_cases.made(), verdict_cases.without_numbers()):
        text = verdict.to_json()
        json.loads(text, parse_constant=lambda name: pytest.fail(name))
        assert verdict_data(verdict) == json.loads(text)
        assert sp.Scenario.parse(tomllib.loads(json.loads(text)["scenario_toml"])) == verdict.scenario


def test_csv_has_a_row_for_every_option():
    verdict = verdict_cases.made()
    rows = list(csv.DictReader(io.StringIO(verdict_csv(verdict))))
    assert [row["option"] for row in rows] == ["belt", "none", "felt_glides"]
    for one, row in zip(verdict.options, rows, strict=True):
        assert float(row["overturned"]) == one.probabilities["overturned"].estimate
        assert int(row["overturned_count"]) == one.probabilities["overturned"].fell
        assert row["peak_slide_m_p90"] == ""
    assert float(rows[1]["jma_intensity_50_percent"]) == verdict.without.capacities[0.5].estimate
    assert rows[0]["jma_intensity_50_percent"] == ""
    capacity = verdict.best.capacities[0.5]  # nothing fell, so that it is beyond the curve
    assert rows[0]["jma_intensity_50_percent_text"] == capacity.text


@pytest.mark.parametrize("language", ["en", "ja"])
def test_markdown_of_nothing_known_says_so(language):
    text = verdict_markdown(verdict_cases.without_numbers(), language)
    assert numbers.word("unknown", language) in text
    assert numbers.word("not_precise", language) in text
    assert not re.search(r"\bnan\b", text)


@pytest.mark.parametrize(("language", "moment"), [("en", "12.3 s"), ("ja", "12.3 秒")])
def test_a_device_is_told_with_its_load_its_margin_and_when_it_failed(language, moment):
    verdict = verdict_cases.made()
    (row,) = device_rows(verdict.best, verdict, language)
    device = verdict.best.devices[0]
    assert device.failed.texts[language == "ja"] == row[1]
    assert row[2] == moment
    assert [part in row[4] for part in ("900 N", "1.8 kN")] == [True, True]
    assert [share(part, language) in row[5] for part in (0.45, 0.9)] == [True, True]
    unhurt = replace(device, failure_time=math.nan, used=Quantiles(0.0, 0.0))
    assert device_rows(replace(verdict.best, devices=(unhurt,)), verdict, language)[0][2:6:3] == ("–", "–")
    text = verdict_markdown(verdict, language)
    assert all(cell in text for cell in row)
    assert numbers.word("estimates", language) in text


@pytest.mark.parametrize("language", ["en", "ja"])
@pytest.mark.parametrize(
    "furniture", [{"preset": "bookcase"}, [{"preset": "bookcase"}]], ids=["table", "list"]
)
def test_rows_of_tables_have_the_columns_of_their_headings(language, furniture):
    """A list of one piece too, whose devices say what they hold."""
    verdict = verdict_cases.made({**verdict_cases.SCENARIO, "furniture": furniture})
    tables = re.findall(r"(?:^\|.*\n)+", verdict_markdown(verdict, language), re.MULTILINE)
    assert len(tables) == 4
    for table in tables:
        assert len({len(re.findall(r"(?<!\\)\|", line)) for line in table.splitlines()}) == 1
    (row,) = device_rows(verdict.best, verdict, language)
    assert len(row) == len(DEVICE_COLUMNS) + isinstance(furniture, list)


def test_motions_of_suites_have_names_in_both_languages():
    for family in FAMILIES:
        name = synthetic_suite(family, 1)[0].name
        assert given_name(name, "en") == name
        assert given_name(name, "ja").startswith("模擬地震動（")
        assert "synthetic" not in given_name(name, "ja")
        assert not set(given_name(name, "ja")) & set(string.ascii_letters)
    floor = "synthetic near-fault motion, storey 8 of 10-storey RC building"
    assert given_name(floor, "ja") == "断層近傍の模擬地震動（10階建て（鉄筋コンクリート造）の8階）"
    for own in ("El Centro 1940", "Kobe, NS of Kobe"):
        assert given_name(own, "ja") == own
    assert given_name(sp.sine(6.0, 1.0, 2.0).name, "ja") == "正弦波 6 m/s², 1 Hz"


@pytest.mark.parametrize(
    ("estimate", "ends", "said", "helps"),
    [
        (-0.5, (-0.7, -0.3), ("instead of", "減ります"), True),
        (-0.5, (-0.9, 0.1), ("no clear difference", "明らかな差がありません"), False),
        (0.3, (0.1, 0.5), ("more often", "増えて"), False),
    ],
)
def test_a_difference_that_is_not_clear_is_told_as_none(estimate, ends, said, helps):
    verdict = verdict_cases.made()
    change = replace(verdict.best.change, estimate=estimate, low=ends[0], high=ends[1])
    best = replace(verdict.best, change=change)
    told = replace(verdict, options=(best, *verdict.options[1:]))
    for language, word in zip(("en", "ja"), said, strict=True):
        assert word in reason(best, told, language).lower()
        assert (title(best.option, told, language).lower() in headline(told, language).lower()) == helps


@pytest.mark.parametrize("language", ["en", "ja"])
def test_two_of_one_measure_are_told_apart(language):
    one = verdict_cases.made()
    strong = replace(one.best, option=Option("strong belt", ((Belt(strength=4000.0),),)), rank=2)
    two = replace(one, options=(one.best, strong, *one.options[1:]))
    label = say(one.best.option.label(), language)
    assert title(one.best.option, one, language) == label
    titles = {title(each.option, two, language) for each in two.options}
    assert len(titles) == 4
    assert "strong belt" in next(told for told in titles if "strong" in told)
    assert "(belt)" in headline(two, language) or "（belt）" in headline(two, language)
    assert "(belt)" not in headline(one, language)


def test_hostile_names_mean_nothing_to_markdown():
    title = "<script>alert(1)</script> | `x` [a](b) *c*"
    name = 'say "hi" | | <img src=x>'
    data = {**verdict_cases.SCENARIO, "title": title, "furniture": {"preset": "chest", "name": name}}
    text = verdict_markdown(verdict_cases.made(data))
    told = text.split("```")[0]
    assert "\\<script\\>" in told
    assert "<img" not in told.replace("\\<img", "")
    assert (
        len({line.count(" | ") for line in told.splitlines() if line.startswith(("| 1", "| 2", "| 3"))}) == 1
    )


def test_assumptions_carry_how_well_founded_they_are():
    given = {
        "furniture": {"width": 0.4, "height": 1.8, "mass": 90.0},
        "room": {"floor": {"static_friction": 0.5}},
    }
    preset, own = verdict_cases.made(), verdict_cases.made(given)
    tags = {one.what[0]: one.confidence for one in assumptions(preset)}
    assert (tags["Furniture"], tags["Floor"], tags["Wall behind"]) == ("low", "medium", "given")
    tags = {one.what[0]: one.confidence for one in assumptions(own)}
    assert (tags["Furniture"], tags["Floor"]) == ("given", "given")
    for one in assumptions(preset):
        assert one.confidence in TEXTS
        assert one.value[0] != ""
        assert one.value[1] != ""
    assert any("synthetic" in one.value[0] for one in assumptions(preset))


@pytest.mark.parametrize(
    ("share", "said", "japanese"),
    [
        (0.0, "would not slide under any of the motions", "どの地震動でも滑らない"),
        (0.5, "50 % of the motions would move it, half of these by more than 12 cm", "地震動の50%で動き"),
        (1.0, "all motions would move it, half of them by more than 12 cm", "すべての地震動で動き"),
    ],
)
def test_how_far_it_would_slide(share, said, japanese):
    estimates = replace(made().estimates, sliding=SlidingShare(share, 0.12 if share else math.nan))
    verdict = made(estimates=estimates)
    assert said in verdict_markdown(verdict)
    assert japanese in verdict_markdown(verdict, "ja")


def test_carpet_is_an_aside_within_what_people_do():
    scenario = {**SCENARIO, "everyday": {"carpet": 0.011, "pull": 1.0, "load": 0.0}}
    told, japanese = everyday_note(made(scenario=scenario))
    assert " (with carpet that lifts its back by 11 mm); the margin is " in told
    assert "カーペットで背面が11 mm浮き、" in japanese


def test_heights_that_read_alike_are_told_once():
    out = probability(np.eye(4, dtype=bool))
    leaving = {height: Leaving(height, 1.41, 0.5, 1.0) for height in (1.0, 1.4)}
    said = {}
    for height, left in leaving.items():
        contents = ContentsVerdict(out, 0.0, 1.0, out, out, None, left, np.eye(4))
        verdict = made(scenario={**SCENARIO, "contents": {"kind": "books"}})
        option = replace(verdict.best, contents=contents)
        said[height] = reason(option, verdict, "en"), reason(option, verdict, "ja")
    assert "half of them leave from 1.0 m or higher (at most 1.5 m), 90 %" in said[1.0][0]
    assert "half of them or more leave from 1.4 m, none from higher, 90 % of them" in said[1.4][0]
    assert "その半数以上は最も高い1.4 mから、" in said[1.4][1]


def test_numbers_in_words():
    told = {3.14159: "3.14 N", 811.4: "811 N", 999.0: "1.0 kN", 2000.0: "2.0 kN", 12345.0: "12 kN"}
    assert {value: force(value, "en") for value in told} == told
    assert length(0.004, "en") == "0.4 cm"
    assert length(0.123, "ja") == "12 cm"
    assert length(math.inf, "en") == "overturned"
    assert length(math.nan, "en") == "–"
    assert change(None, "en") == "–"
    bare = verdict_cases.made().without
    assert capacity(bare.capacities[0.5], "en") == bare.capacities[0.5].text.split(" (")[0]
    low, high = (f"{end:.2f}" for end in (bare.capacities[0.5].low, bare.capacities[0.5].high))
    assert capacity_interval(bare.capacities[0.5], "en") == f"{low} to {high}"
    assert capacity_interval(bare.capacities[0.5], "ja") == f"{low}～{high}"
    assert capacity(None, "en") == "–"


@pytest.mark.parametrize(("key", "heading", "nrml"), [("PGV", "pgv_m_s", True), ("PFA", "pfa_m_s2", False)])
def test_curves_are_written_for_loss_tools(tmp_path, key, heading, nrml):
    measure = INTENSITY_MEASURES[key]
    verdict = verdict_cases.made()
    files, left_out = write_curves(verdict, measure, tmp_path / "curves")
    names = ["curves.csv", "observed.csv", "fragility.svg", "pelicun.csv", *(["nrml.xml"] if nrml else [])]
    assert [file.name for file in files] == names
    assert sorted(names) == sorted(path.name for path in (tmp_path / "curves").iterdir())
    assert any(told.startswith("belt is not") for told in left_out)
    assert any("OpenQuake has no PFA" in told for told in left_out) != nrml
    curve = verdict.without.curves[measure]
    for row in csv.DictReader(files[0].open(encoding="utf-8-sig")):
        if row["option"] == "none":
            assert float(row["probability"]) == float(curve.probability(float(row[heading])))
    rows = [row for row in csv.DictReader(files[1].open(encoding="utf-8-sig")) if row["option"] == "none"]
    assert [int(row["overturned"]) for row in rows] == [level.probability.fell for level in curve.levels]


@pytest.mark.parametrize("language", ["en", "ja"])
def test_a_curve_without_a_median_is_left_out_of_what_loss_tools_read(tmp_path, language):
    measure = INTENSITY_MEASURES["PGV"]
    few = FragilityCurve("felt_glides", Trials.from_counts(measure, [0.1, 0.2], [0, 1], [40, 40]))
    assert few.lognormal is None
    verdict = verdict_cases.made()
    glides = next(result for result in verdict.options if result.option.name == "felt_glides")
    options = [replace(o, curves={measure: few}) if o is glides else o for o in verdict.options]
    changed = replace(verdict, options=tuple(options))
    files, left_out = write_curves(changed, measure, tmp_path / "curves", language)
    assert any(say(phrase("fragility.has_no_median"), language) in told for told in left_out)
    written = {row["ID"] for row in csv.DictReader(files[3].open(encoding="utf-8"))}
    assert "none" in written
    assert "felt_glides" not in written
