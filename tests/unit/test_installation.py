"""Measures as people install them: what is wrong, in what share, and what the verdict says of it."""

import csv
import io
import json
from dataclasses import replace

import numpy as np
import pytest

import stayput as sp
from stayput.measures import MEASURES, Belt, GelMats, LBracket, LBracketInBoard, TensionPole, WedgeStopper
from stayput.measures.measure import FAULTY
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.verdict.html import report_html
from stayput.report.verdict.tables import verdict_csv, verdict_markdown
from stayput.verification.words import reason

ROOM = sp.Room(left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))

FILE = {
    "furniture": {"preset": "bookcase"},
    "room": {"left_wall": {"gap": 0.02, "construction": "plasterboard"}, "ceiling": {"height": 2.4}},
    "shaking": {"intensity": 6.25, "suite": {"family": "near-fault", "count": 10}},
    "measures": [
        {"type": "l_bracket", "wall": "stud"},
        {"type": "anti_slip_sheet"},
        {"name": "pair", "combine": [{"type": "wedge_stopper"}, {"type": "tension_pole"}]},
    ],
}


def verdict_of(installation="well", **tables):
    stated = {"samples": 10, "installation": installation}
    parsed = sp.Scenario.parse({**FILE, **tables, "uncertainty": stated})
    return sp.verify(parsed, levels=(), progress=False)


@pytest.fixture(scope="module")
def usual():
    return verdict_of("as people install it")


def by_name(verdict):
    return {result.option.name: result for result in verdict.options}


@pytest.mark.parametrize(
    ("measure", "worse"),
    [
        (LBracket(), LBracket(wall="plasterboard")),
        (LBracket(strength=1500.0), LBracket(wall="plasterboard")),
        (Belt(), Belt(slack=0.01 + 0.05)),
        (TensionPole(), TensionPole(preload=20.0)),
        (TensionPole(preload=10.0), TensionPole(preload=10.0)),
        (GelMats(), GelMats(realism=0.3 * 0.7)),
        (WedgeStopper(), WedgeStopper(thickness=0.0035)),
    ],
)
def test_what_is_wrong_with_a_badly_installed_measure(measure, worse):
    bad = measure.badly_installed(ROOM)
    assert (bad.measure, bad.share) == (worse, FAULTY)
    assert not bad.how[1].isascii()


def test_of_some_measures_little_can_be_done_wrong():
    for measure in (LBracketInBoard(), LBracket(wall="plasterboard"), MEASURES["ballast"]()):
        assert measure.badly_installed(ROOM) is None


def test_what_is_said_of_gypsum_board_is_what_the_bracket_holds():
    bracket = LBracketInBoard()
    assert bracket.drawn("plasterboard", 1.8, 2.4).strength == pytest.approx(300.0, rel=0.05)
    assert "each holds a pull of only about 300 N" in bracket.about[0]
    assert "1個あたり約300 N" in bracket.about[1]
    for height in (1.2, 1.8, 2.1):
        board, stud = (LBracket().drawn(wall, height, 2.4) for wall in ("plasterboard", "stud"))
        assert board.strength < stud.strength


def test_installed_well_is_the_default_and_costs_nothing(usual):
    well = verdict_of()
    assert all(result.installed is None for result in well.options)
    assert usual.runs == well.runs + 2 * well.without.runs
    for name, result in by_name(well).items():
        assert by_name(usual)[name].probabilities == result.probabilities
    assert verdict_of(0.0).runs == well.runs
    assert sp.Scenario.parse(FILE).uncertainty.installation == "well"


def test_as_people_install_it_mixes_the_two(usual):
    options = by_name(usual)
    assert options["anti_slip_sheet"].installed is options["none"].installed is None
    for name in ("l_bracket", "pair"):
        result, mixed = options[name], options[name].installed
        for event, chance in result.probabilities.items():
            wanted = (1.0 - FAULTY) * chance.estimate + FAULTY * mixed.badly[event].estimate
            assert mixed.usual[event] == pytest.approx(wanted)
    assert len(options["pair"].installed.how) == 2
    bracket = options["l_bracket"]
    assert bracket.installed.badly[OVERTURNED].estimate > bracket.probabilities[OVERTURNED].estimate
    halves = by_name(verdict_of(0.5))["l_bracket"].installed
    assert (halves.share, halves.badly) == (0.5, bracket.installed.badly)


def test_badly_installed_is_the_measure_with_what_is_wrong(usual):
    """Under the same draws as an option of its own would be."""
    alone = verdict_of(measures=[{"type": "l_bracket", "wall": "plasterboard"}])
    found = by_name(usual)["l_bracket"].installed.badly
    assert found == by_name(alone)["l_bracket"].probabilities


def test_every_form_of_the_verdict_says_it(usual):
    clause = "as people install it,"
    line = reason(by_name(usual)["l_bracket"], usual, "en")
    assert clause in line
    assert "23 % of such devices are badly installed (screws beside the studs, in plasterboard)" in line
    assert "With screwed L-brackets, as people install such devices, it overturns in" in usual.sentence()
    assert "を実際の取付けのとおりとすると、" in usual.sentence("ja")
    assert clause in verdict_markdown(usual).replace("\\", "")
    assert clause in report_html(usual, "en")
    assert "23%が取付け不良" in verdict_markdown(usual, "ja")
    data = {one["name"]: one for one in json.loads(usual.to_json())["options"]}
    told = data["l_bracket"]["as_installed"]
    assert told["badly_share"] == FAULTY
    assert told["usual"][OVERTURNED] == by_name(usual)["l_bracket"].installed.usual[OVERTURNED]
    assert data["anti_slip_sheet"]["as_installed"] is None
    rows = {row["option"]: row for row in csv.DictReader(io.StringIO(verdict_csv(usual)))}
    assert rows["anti_slip_sheet"]["overturned_as_installed"] == ""
    assert rows["l_bracket"]["overturned_as_installed"] != ""


def test_a_difference_that_cannot_be_seen_is_called_none(usual):
    bracket = by_name(usual)["l_bracket"]
    held = bracket.probabilities[OVERTURNED]
    alike = replace(bracket.installed, badly={OVERTURNED: held}, usual={OVERTURNED: held.estimate})
    same = replace(bracket, installed=alike)
    told = f"{held.share[0]} overturn, no clear difference from when it is well installed: 23 % of"
    assert told in reason(same, usual, "en")
    assert "と明らかな差はありません（23%が" in reason(same, usual, "ja")
    apart = replace(bracket.installed, usual={OVERTURNED: held.estimate + 0.4})
    assert "from when" not in reason(replace(bracket, installed=apart), usual, "en")
    assert "実際の取付けでは" in reason(replace(bracket, installed=apart), usual, "ja")


def test_cautions_and_the_weakest_link_stand_in_the_reason():
    measures = [{"type": "l_bracket"}, {"type": "l_bracket_board", "count": 1}]
    verdict = verdict_of(measures=measures)
    for result in (one for one in verdict.options if one.option.measures):
        english = reason(result, verdict, "en")
        assert "caution: " in english
        assert "plasterboard alone" in english
        assert "注意：" in reason(result, verdict, "ja")
        assert result.devices
        for device in result.devices:
            assert device.weakest[0] == "the screws pull out of the plasterboard"
            assert device.weakest[0] in english
            assert np.isfinite(device.failed.estimate)


@pytest.mark.parametrize("wrong", ["badly", -0.1, 1.1, True])
def test_another_installation_is_refused(wrong):
    with pytest.raises(sp.InputError, match=r"uncertainty.installation is .*; it must be"):
        sp.Scenario.parse({**FILE, "uncertainty": {"installation": wrong}})
