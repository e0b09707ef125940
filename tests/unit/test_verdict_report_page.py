"""The report's page: one file with the verdict's numbers, safe from what it is given, in both languages."""

import base64
import json
import re
from dataclasses import replace

import numpy as np
import pytest
import verdict_cases
from html_pages import Page, check_alone, check_readable

import stayput as sp
from long_cases import long
from stayput.catalogue import phrase
from stayput.montecarlo.counting import Member, Members
from stayput.report.verdict import svg
from stayput.report.verdict.html import pairs_of, place_of_the_measure, report_html
from stayput.report.verdict.numbers import interval, probability, word
from stayput.report.verdict.tables import ranking
from stayput.verification.option_runner import OptionRunner, drawn_run
from stayput.verification.options import compared_options
from stayput.verification.words import headline


@pytest.fixture(scope="module", params=["en", "ja"])
def page(request):
    return verdict_cases.made(), request.param, verdict_cases.page(request.param)


def test_it_says_the_verdict_and_every_number_of_the_ranking(page):
    verdict, language, text = page
    told = Page(text).words
    assert " ".join(headline(verdict, language).split()) in told
    for row in ranking(verdict, language):
        assert row.label in told
        for _, found in row.shares:
            if found is not None:
                assert probability(found, language) in told
                # a share that is told by its interval has none beside it
                assert "–" in found.brief or interval(found, language) in told
        for middle, ends in row.capacities:
            assert middle in told
            assert ends in told
    assert f"{verdict.intensity:.2f}" in told


def test_bars_are_as_long_as_the_numbers(page):
    verdict, _, text = page
    parts = [attrs for tag, attrs in Page(text).elements if tag == "rect" and attrs.get("class") == "part"]
    first = [one.probabilities["overturned"] for one in verdict.options]
    all_of_them = [
        one.probabilities[event]
        for one in verdict.options
        for event in ("overturned", "slid", "hit_wall", "device_failed")
        if event != "device_failed" or one.devices
    ]
    wanted = [round(100.0 * chance.estimate, 2) for chance in (*first, *all_of_them)]
    assert [float(attrs["width"]) for attrs in parts] == wanted


def test_it_needs_nothing_else_and_can_be_read_without_seeing_it(page):
    _, language, text = page
    check_alone(text)
    check_readable(text, language)


def scenes(text):
    """Return what the players in a page show."""
    players = [attrs["srcdoc"] for tag, attrs in Page(text).elements if tag == "iframe"]
    found = [re.search(r'<script id="run"[^>]*>(.*?)</script>', player, re.DOTALL) for player in players]
    players = [json.loads(one[1]) for one in found]
    return [{**film, "telling_s": player["telling_s"]} for player in players for film in player["films"]]


def test_the_scenes_are_the_runs_of_the_verdict(page):
    verdict, _, text = page
    run = drawn_run(verdict.scenario, verdict.without.option, verdict.without.typical)
    shown = scenes(text)
    first, held = shown[:2]
    assert len(shown) == 4
    poses = first["poses"]
    time = np.linspace(poses["start_s"], poses["end_s"], poses["count"])
    tilt = np.frombuffer(base64.b64decode(first["bodies"][0]["tilt_rad"]), "<f4")
    inside = time < run.time[-1]
    np.testing.assert_allclose(tilt[inside], np.interp(time, run.time, run.tilt)[inside], atol=1e-4)
    assert 0.0 <= poses["start_s"] <= first["telling_s"] <= poses["end_s"] <= run.motion.duration
    assert (len(first["ties"]), len(held["ties"])) == (0, 2)  # both belts
    assert (first["poses"], first["view"]) == (held["poses"], held["view"])


def bare_and_held(verdict):
    member = verdict.without.typical
    return [drawn_run(verdict.scenario, one.option, member) for one in (verdict.without, verdict.best)]


def test_a_typical_case_tells_how_often_the_measure_fails(page):
    verdict, language, text = page
    chance = verdict.best.probabilities["overturned"]
    _, held = bare_and_held(verdict)
    spared = "typical_never_falls" if chance.estimate == 0.0 else "typical_is_held"
    key = "typical_also_falls" if held.overturned else spared
    assert word(key, language, share=chance.share) in Page(text).words


def test_a_measure_with_which_nothing_falls_is_not_contrasted_with_0_percent():
    verdict = verdict_cases.made()
    chance = replace(verdict.best.probabilities["overturned"], estimate=0.0)
    best = replace(verdict.best, probabilities={**verdict.best.probabilities, "overturned": chance})
    never = replace(verdict, options=(best, *verdict.options[1:]))
    _, held = bare_and_held(verdict)
    assert not held.overturned
    told = place_of_the_measure(never, held, "ja")
    assert told == "この対策では、この計算を含むどの計算でも転倒しません。"


def test_hostile_names_are_only_text():
    title = "</title><script>alert(1)</script>" + "x" * 160
    name = "</script><img src=x onerror=alert(1)> \"'&"
    data = {**verdict_cases.SCENARIO, "title": title, "furniture": {"preset": "chest", "name": name}}
    verdict = verdict_cases.made(data)
    belt, *others = verdict.options
    named = replace(belt, option=replace(belt.option, name='<b>"quoted"</b>\''))
    text = report_html(replace(verdict, options=(named, *others)))
    found = Page(text)
    assert [tag for tag, _ in found.elements].count("script") == 1
    assert not any(tag == "b" or "onerror" in attrs for tag, attrs in found.elements)
    assert title in found.words
    assert '<b>"quoted"</b>\'' in found.words


@pytest.mark.parametrize("language", [*long("en"), "ja"])
def test_a_verdict_without_curves_and_numbers_says_so(language):
    told = Page(report_html(verdict_cases.without_numbers(), language)).words
    assert word("unknown", language) in told
    assert word("not_precise", language) in told
    assert "nan" not in told.split()
    assert "None" not in told


def test_where_nothing_helps_there_is_one_side():
    verdict = verdict_cases.made()
    bare = replace(verdict, options=(verdict.options[1], verdict.options[0], verdict.options[2]))
    assert [len(pair["sides"]) for pair in pairs_of(bare, "en")] == [1, 1]
    told = word("typical_bare_text", "en", without=phrase("common.without"))
    assert told in Page(report_html(bare)).words


@pytest.mark.parametrize("dimensions", [2, 3])
@pytest.mark.parametrize("initial", [{}, {"tilt": 0.03}])
def test_a_replay_is_the_run_that_was_counted(initial, dimensions):
    tables = {**verdict_cases.SCENARIO, "initial": initial, "dimensions": dimensions}
    scenario = sp.Scenario.parse({**tables, "uncertainty": {"samples": 3}})
    options, _ = compared_options(scenario)
    members = Members.of_samples(1, 3)
    made = OptionRunner(scenario, 0.1, 1).run(options[:4], members)
    for option, runs in zip(options[:4], made, strict=True):
        for sample in range(3):
            run = drawn_run(scenario, option, Member(0, sample))
            assert run.peak_tilt == runs.tilt[sample]
            assert run.peak_slide == runs.slide[sample]
            assert run.overturned == runs.overturned[sample]


def test_ticks_are_round_and_inside():
    assert svg.ticks(4.0, 7.05, 7) == pytest.approx([4.0, 4.5, 5.0, 5.5, 6.0, 6.5, 7.0])
    assert all(-0.3 <= tick <= 0.3 for tick in svg.ticks(-0.3, 0.3, 4))


def test_a_report_is_written_whole_or_refused(tmp_path):
    verdict = verdict_cases.made()
    file = verdict.report(tmp_path / "r.html", "ja")
    assert file.read_text(encoding="utf-8") == verdict_cases.page("ja")
    with pytest.raises(sp.InputError, match=r"The language is 'fr'; it must be one of 'en', 'ja'\."):
        verdict.report(tmp_path / "s.html", "fr")
    with pytest.raises(sp.InputError, match=r"ends in \.html"):
        verdict.report(tmp_path / "s.txt")
    assert [path.name for path in tmp_path.iterdir()] == ["r.html"]
