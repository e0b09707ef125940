"""Sentences with every measure's name, with one and with many, with very small and very large numbers."""

import dataclasses
import math
import re
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import report_runs
import verdict_cases

import stayput as sp
from stayput.catalogue import LANGUAGES, earthquake, page, say
from stayput.fragility.probabilities import Probability, percent, probability, probability_of_counts
from stayput.inventory.report import storey_map
from stayput.inventory.summary import Total
from stayput.measures import MEASURES, Belt, DeviceResult
from stayput.montecarlo.counting import DEVICE_FAILED, Quantiles
from stayput.report.summary import rows, sentence, sentences_of_piece
from stayput.report.verdict import numbers
from stayput.scenario.measures import Option
from stayput.simulation.outcome import Outcome
from stayput.verification.notes import shaken_notes
from stayput.verification.words import headline, reason, title
from stayput.wording import FAR, counted, inside

PAGE = Path(sp.__file__).parent / "app" / "page"

TEXTS = page.TEXTS | earthquake.TEXTS
"""All texts of the page."""


def moved(tilt, slide, outcome, room=None):
    """Return a run whose peaks are these, to the right."""
    t = np.linspace(0.0, 1.0, 201)
    run = report_runs.made(tilt * np.sin(3.0 * t), slide * t, ["rock"] * len(t), outcome=outcome)
    run = report_runs.changed(run, peak_tilt=abs(tilt), peak_slide=abs(slide))
    return dataclasses.replace(run, room=room or run.room)


def all_words(run):
    """Return the sentences of a run: of the command line, and of the page in both languages."""
    return sentence(run.named(["chest"])), *sentences_of_piece(run.named(["chest"]))


def held(kind, **values):
    """Return a verdict whose best option is a measure of a kind, with a device that fails in all runs."""
    verdict = verdict_cases.made()
    best = replace(verdict.best, option=Option(kind, ((MEASURES[kind](**values),),)))
    return replace(verdict, options=(best, *verdict.options[1:]))


@pytest.mark.parametrize("outcome", [Outcome.SLID, Outcome.ROCKED])
@pytest.mark.parametrize("slide", [0.0, 1e-5, 4e-4, 0.00996, 0.0099, 0.02, 0.999, 1.0, 2.9, 14.588])
@pytest.mark.parametrize("tilt", [0.0, 1e-5, math.radians(0.049), math.radians(0.051), 0.1])
def test_peaks_are_told_as_people_tell_them(outcome, slide, tilt):
    for text in all_words(moved(tilt, slide, outcome)):
        assert "up to less" not in text
        assert not re.search(r"最大[^、。]*未満", text)
        assert "0.0°" not in text
        assert "0.0度" not in text
        assert " 0 mm" not in text
        assert "10 mm" not in text
        assert not re.search(r"\d{3,}\.\d cm", text)


def test_a_slide_without_a_wall_in_its_way_is_told_as_one():
    """On casters of friction 0.03 a body does roll for ten metres; no room is so long."""
    english, page, japanese = all_words(moved(0.0, 14.588, Outcome.SLID, sp.Room(left_wall=sp.Wall(0.02))))
    assert "more than 3 m (there is no wall to stop it)" in english
    assert "more than 3 m (there is no wall to stop it)" in page
    assert "3 mを超えて" in japanese
    assert "14" not in english + page + japanese
    walled = moved(0.0, 14.588, Outcome.SLID, sp.Room(right_wall=sp.Wall(20.0)))
    assert "up to 14.59 m" in sentence(walled)
    assert ("Peak slide", "1458.80 cm") in rows(walled)
    to_the_back = moved(0.0, -14.588, Outcome.SLID, sp.Room(right_wall=sp.Wall(20.0)))
    assert "no wall to stop it" in sentence(to_the_back)
    assert ("Peak slide", "1458.80 cm (there is no wall to stop it)") in rows(to_the_back)


@pytest.mark.parametrize("sign", [-1.0, 1.0])
@pytest.mark.parametrize("outcome", [Outcome.OVERTURNED, Outcome.LEANING])
def test_the_page_names_the_sides_as_its_labels_do(sign, outcome):
    run = report_runs.changed(report_runs.falling(sign), outcome=outcome)
    english, japanese = sentences_of_piece(run.named(["chest"]))
    assert f"to the {'front' if sign > 0.0 else 'back'}" in english
    assert f"{'手前' if sign > 0.0 else '奥'}へ" in japanese
    assert not re.search(r"\b(left leaning to the )?(right|left) ", english.replace("was left", "was"))
    assert not set("右左") & set(japanese)
    assert f"to the {'right' if sign > 0.0 else 'left'}" in sentence(run)


@pytest.mark.parametrize("language", ["en", "ja"])
def test_no_text_of_the_page_speaks_of_right_and_left(language):
    text = "\n".join(words[LANGUAGES.index(language)] for words in TEXTS.values())
    assert not re.search(r"to the (right|left)|右へ|左へ|右側|左側", text)


def test_no_text_of_the_page_takes_the_place_of_another():
    shared = {name.rpartition(".")[2] for name in page.SHARED}
    assert len(TEXTS) == len(page.TEXTS) + len(earthquake.TEXTS)
    assert shared.isdisjoint(TEXTS)


def test_no_text_of_the_page_counts_with_a_plural():
    """A number in them may be 1: "Share of 1 earthquakes"."""
    text = "\n".join(english for english, _ in TEXTS.values())
    counts = re.findall(r"\{(?:n|motions|runs|count|number)\} (?:\w+ )?\w+s\b", text)
    assert counts == []
    assert not re.search(r"\{(device|measures)\} (fails|holds|is|has|was)\b", text)


@pytest.mark.parametrize("kind", MEASURES)
def test_a_measure_s_name_goes_with_its_sentence(kind):
    label = MEASURES[kind].label[0]
    verdict = held(kind)
    said = headline(verdict, "en")
    assert f"with {inside(label)}" in said
    assert reason(verdict.best, verdict, "en").startswith("It overturns")
    assert label[1:] in inside(label)
    capital = not label[1].islower()
    assert (inside(label) == label) == capital


@pytest.mark.parametrize("kind", ["l_bracket", "sliding_glides", "gel_mats", "belt"])
def test_the_device_that_failed_first_is_named_within_its_sentence(kind):
    label = MEASURES[kind].label
    failed = DeviceResult(
        kind=kind, label=label, place="", peak_pull=9.0, peak_push=0.0, peak_shear=0.0,
        failed=True, failure_time=1.25, cause="pull", utilisation=1.0,
        pull=np.zeros(1), shear=np.zeros(1),
    )  # fmt: skip
    english, _ = sentences_of_piece(
        dataclasses.replace(report_runs.falling(), names=("chest",), devices=(failed,))
    )
    assert f"First to fail: {inside(label[0])}, after 1.2 s." in english
    assert "l-brackets" not in english
    assert "ptfe" not in english


@pytest.mark.parametrize("language", ["en", "ja"])
def test_the_user_s_own_name_is_kept(language):
    verdict = verdict_cases.made()
    mine = replace(verdict.best, option=Option("Grandma's belt", ((Belt(),),)))
    named = replace(verdict, options=(mine, *verdict.options[1:]))
    assert "Grandma's belt" in title(mine.option, named, language)
    assert "Grandma's belt" in headline(named, language)
    yours = Option("yours", ((Belt(strength=900.0),),))  # the set of the page's reader has no name of its own
    assert not yours.own_name
    for plain in verdict.options:
        assert title(plain.option, verdict, language) == say(plain.option.label(), language)
    mats = replace(verdict.best, option=Option("うちのマット", ((MEASURES["gel_mats"](),),)))
    whole = replace(verdict, options=(mats, *verdict.options[1:]))
    shown = {"en": "うちのマット (Adhesive gel mats)", "ja": "うちのマット（耐震ゲルマット（粘着マット式））"}
    assert title(mats.option, whole, language) == shown[language]
    assert shown["ja"] in whole.to_markdown("ja")


@pytest.mark.parametrize("language", ["en", "ja"])
@pytest.mark.parametrize("share", [0.0, 1.0 / 16000.0, 0.004, 0.5, 0.996, 1.0 - 1.0 / 16000.0, 1.0])
@pytest.mark.parametrize("slide", [0.0, 1e-4, 2.0, math.inf, math.nan])
def test_reasons_for_small_and_large_numbers(language, share, slide):
    verdict = verdict_cases.made()
    chance = replace(verdict.best.probabilities[DEVICE_FAILED], estimate=share)
    best = replace(
        verdict.best,
        slide=Quantiles(slide, slide),
        probabilities=dict.fromkeys(verdict.best.probabilities, chance),
    )
    changed = replace(verdict, options=(best, *verdict.options[1:]))
    texts = [reason(best, changed, language), headline(changed, language)]
    texts += numbers.slides(best.slide, verdict.scenario.room.room(), language)
    for text in texts:
        assert not re.search(r"\b(nan|inf)\b", text)
        assert not re.search(r"\d{3,} cm", text)
        assert "14" not in text.replace("14 cm", "")
        if share not in (0.0, 1.0):
            assert not re.search(r"(?<![\d.<>])(0|0\.0|100|100\.0) ?%", text)


def test_a_slide_beyond_all_rooms_is_a_number_where_walls_are_on_both_sides():
    far = Quantiles(1.0, 4.0)
    open_room = sp.Room(left_wall=sp.Wall(0.02))
    closed = sp.Room(left_wall=sp.Wall(0.02), right_wall=sp.Wall(8.0))
    assert numbers.slides(far, open_room, "en") == ("1.0 m", f"> {FAR:g} m")
    assert numbers.slides(far, closed, "ja") == ("1.0 m", "4.0 m")


def test_the_note_on_grades_is_about_the_option_that_is_asked_for():
    verdict = verdict_cases.made()
    best, bare = (
        " ".join(english for english, _ in shaken_notes(verdict, graded))
        for graded in (verdict.best.option, verdict.without.option)
    )
    assert "belts: strength of one" in best
    assert "belts" not in bare
    assert all(
        note.startswith("Rough (grade C). Assumed, not measured: size and mass") for note in (best, bare)
    )


def test_counts():
    assert [counted(n, "run") for n in (0, 1, 2, 1000)] == ["0 runs", "1 run", "2 runs", "1,000 runs"]
    lone = Total(rows=1, pieces=1, fallen=defaultdict(float, {"": 0.0004, "_high": 0.2}))
    for total, shown, told in (
        (lone, "<0.1?", "% (0 to 20 %) of 1 piece"),
        (Total(1, 2, defaultdict(float, {"": 1.0})), "50", "of 2 pieces"),
    ):
        (cell,) = storey_map({("a", 1): total}, False)["rows"][0]["cells"]
        assert cell["shown"] == shown
        assert cell["told"][0].endswith(told)


def test_a_share_is_never_all_or_nothing_where_it_is_not():
    assert [percent(p) for p in (0.0, 1e-5, 4e-4, 6e-4, 0.5, 0.9994, 0.99996, 1.0)] == [
        "0", "<0.1", "<0.1", "0.1", "50", "99.9", ">99.9", "100",
    ]  # fmt: skip
    assert percent(-1e-5) == "−<0.1"
    assert percent(-0.0) == percent(0.0)
    # the same share, by itself and as what is left of a difference
    assert 0.825 - 0.05 < 0.775
    assert percent(0.825 - 0.05) == percent(0.775) == "78"
    assert percent(0.3 - 0.1 - 0.2) == "0"
    assert percent(0.285) == "29"
    found = probability(np.arange(40_000).reshape(4000, 10) < 1)
    assert found.text == "under 0.1 %"


@pytest.mark.parametrize(
    ("ends", "brief", "words"),
    [
        ((0.6, 0.55, 0.65), "60", "about 60 %"),
        ((0.6, 0.595, 0.605), "60", "about 60 %"),
        ((0.83, 0.61, 0.94), "80", "about 80 %"),
        ((0.37, 0.27, 0.48), "40", "about 40 %"),
        ((0.13, 0.04, 0.33), "10", "about 10 %"),
        ((0.06, 0.02, 0.22), "<22", "under 22 %"),  # 10 would be nearly twice as many
        ((0.0, 0.0, 0.0878), "<9", "under 9 %"),
        ((0.003, 0.0021, 0.0042), "<0.5", "under 0.5 %"),
        ((1.0, 0.8221, 1.0), ">82", "over 82 %"),
        ((0.25, 0.03, 0.78), "3–78", "3 to 78 %"),
    ],
)
def test_a_share_is_told_as_finely_as_its_interval_allows(ends, brief, words):
    estimate, low, high = ends
    chance = Probability(estimate, low, high, 0, 40, 20, 0, 1.0)
    assert (chance.brief, chance.share[0]) == (brief, words)
    assert chance.share[1].strip("約未満超") == words.replace("about ", "").replace("under ", "").replace(
        "over ", ""
    ).replace(" to ", "～").replace(" %", "%")
    assert (chance.ends[0] != "") == words.startswith("about")


def test_no_rounded_share_leaves_its_interval():
    for motions, samples in ((5, 4), (20, 2), (40, 10), (1, 400)):
        for fell in range(motions * samples + 1):
            runs = np.full(motions, samples)
            chance = probability_of_counts(np.diff(np.linspace(0, fell, motions + 1).astype(int)), runs)
            if chance.brief.isdigit():
                assert chance.low <= int(chance.brief) / 100 <= chance.high
            elif "–" not in chance.brief:
                bound = float(chance.brief[1:]) / 100
                assert bound >= chance.high if chance.brief[0] == "<" else bound <= chance.low
