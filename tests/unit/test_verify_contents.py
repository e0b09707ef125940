"""A verification of furniture with contents: how much comes out, in each form a verdict is written in."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

import numpy as np
import pytest

import stayput as sp
from stayput.app.verification import verdict_reply
from stayput.contents.spill import Spill
from stayput.scenario import Scenario
from stayput.verification import verify
from stayput.verification.contents import Leaving
from stayput.verification.verdict import AsInstalled
from stayput.verification.words import reason

DATA = {
    "dimensions": 2,
    "furniture": {"preset": "bookcase"},
    "room": {"left_wall": {"gap": 0.02}},
    "shaking": {"intensity": 6.25, "suite": {"family": "near-fault", "count": 8}},
    "contents": {"kind": "books"},
    "measures": [{"type": "l_bracket"}],
    "uncertainty": {"samples": 8},
}
FEW = {"intensity": 6.25, "suite": {"family": "near-fault", "count": 2}}


@pytest.fixture(scope="module")
def verdict():
    return verify(Scenario.parse(DATA), levels=[], progress=False, threads=1)


def test_each_option_has_a_share_with_its_interval(verdict):
    for option in verdict.options:
        out = option.contents.out
        assert 0.0 <= out.low <= out.estimate <= out.high <= 1.0
        assert (out.runs, out.motions) == (8 * 5 * 8, 8)
        assert option.contents.mass_out == pytest.approx(160.0 * out.estimate)
    assert verdict.best.contents.out.estimate > 0.05
    assert verdict.best.contents.rigid.estimate == 0.0


def test_things_leave_a_standing_piece_from_its_shelves(verdict):
    leaving = verdict.best.contents.leaving
    assert 0.0 <= leaving.height <= leaving.highest < 1.5
    assert 0.0 <= leaving.speed <= leaving.fast < 3.0
    assert "half of them leave from" in reason(verdict.best, verdict, "en")
    assert "その半数は高さ" in reason(verdict.best, verdict, "ja")


def test_the_followed_stand_for_what_comes_off_their_shelf():
    nan = np.nan
    standing = stated_spill([[True, True, True], [True, False, False]], [[nan, 0.2, nan], [-0.6, nan, nan]])
    fallen = stated_spill(np.ones((2, 3), bool), np.full((2, 3), nan), overturned=True)
    leaving = Leaving.of([standing, fallen])
    assert (leaving.height, leaving.highest) == (0.0, 0.9)
    assert leaving.speed == pytest.approx(0.2)
    assert leaving.fast == pytest.approx(np.quantile([0.2, 0.2, 0.2, 0.6], 0.9))
    assert Leaving.of([fallen]) is None
    assert Leaving.of([]) is None


def stated_spill(out, speed, *, overturned=False):
    """What came out of two shelves, 0 and 0.9 m high, of which the items with a speed were followed."""
    speed = np.array(speed)
    height = np.where(np.isfinite(speed), np.array([[0.0], [0.9]]), np.nan)
    numbers = {"time": 0.0 * speed, "height": height, "speed": speed, "distance": 0.0 * speed}
    return Spill(
        contents=sp.Contents(shelves=2, items=3),
        overturned=overturned,
        out=np.array(out),
        toppled=np.zeros((2, 3), bool),
        mass=np.ones((2, 3)),
        open_from=np.zeros(2),
        **numbers,
    )


def test_the_bits_do_not_depend_on_threads(verdict):
    again = verify(Scenario.parse(DATA), levels=[], progress=False, threads=2)
    assert [one.contents for one in again.options] == [one.contents for one in verdict.options]


def test_contents_change_nothing_else(verdict):
    bare = {key: value for key, value in DATA.items() if key != "contents"}
    without = verify(Scenario.parse(bare), levels=[], progress=False, threads=1)
    assert without.best.contents is None
    assert [one.probabilities for one in without.options] == [one.probabilities for one in verdict.options]
    assert "contents_out_share" not in without.to_csv()


def test_it_is_said_in_both_languages(verdict):
    change = replace(verdict.best.change, low=-1.0, high=-0.1)
    clear = replace(verdict, options=(replace(verdict.best, change=change), verdict.without))
    assert "It then mostly stands, but" in clear.sentence()
    assert "of the books come out" in clear.sentence()
    assert "倒れなくても、本の" in clear.sentence("ja")
    note = next(note for note in verdict.notes() if "bounded, not computed" in note)
    rigid = verdict.without.contents.rigid
    assert f"over the {rigid.runs} runs in which they were followed" in note
    assert f"in {rigid.text} with all of them fixed to it" in note


def test_what_comes_out_is_of_the_measure_that_is_named(verdict):
    """Beside what is said without a measure, or as people install one, "it" would be another case."""
    named = "With screwed L-brackets, {}{} of the books come out ("
    share = verdict.best.contents.out.share[0]
    bare = replace(verdict.without, probabilities=verdict.best.probabilities)
    unclear = replace(verdict.best.change, low=-1.0, high=0.1)
    steady = replace(verdict, options=(replace(verdict.best, change=unclear), bare))
    upright, _, rest = steady.sentence().partition(" of the cases. ")
    assert "stays upright without any measure in these runs; it may overturn in under " in upright
    assert rest.startswith(named.format("", share))
    chances = {event: chance.estimate for event, chance in verdict.best.probabilities.items()}
    installed = AsInstalled(0.2, (("loosely", "緩く"),), verdict.best.probabilities, chances)
    usual = replace(verdict, options=(replace(verdict.best, installed=installed), verdict.without))
    assert (
        "With screwed L-brackets, as people install such devices, it overturns in under 40 %. "
        in usual.sentence()
    )
    assert named.format("well installed, ", share) in usual.sentence()
    assert "を正しく取り付けた場合、本の" in usual.sentence("ja")


def test_it_is_in_every_file(verdict, tmp_path):
    share = verdict.best.contents.out.estimate
    leaving = verdict.best.contents.leaving
    rows = list(csv.DictReader(io.StringIO(verdict.to_csv())))
    assert float(rows[0]["contents_out_share"]) == share
    assert float(rows[0]["contents_leaving_height_m_median"]) == leaving.height
    assert "Contents that come out" in verdict.to_markdown()
    page = verdict.report(tmp_path / "r.html").read_text(encoding="utf-8")
    assert page.count("Contents that come out") == 1
    assert verdict_reply(verdict).options[0].contents["contents_out_share"] == share


def test_a_verification_in_space_follows_contents_there():
    """Each motion's first draw is followed: where one sample is made, those runs are the verification's."""
    data = {**DATA, "dimensions": 3, "shaking": FEW, "uncertainty": {"samples": 1}}
    for option in verify(Scenario.parse(data), levels=[], progress=False, threads=1).options:
        # followed at finer samples, which a run that all but falls may tell
        rigid, overturned = option.contents.rigid.estimate, option.probabilities["overturned"].estimate
        assert abs(rigid - overturned) <= 1.0 / option.contents.rigid.runs
        assert option.contents.out.estimate >= option.contents.rigid.estimate


@pytest.mark.parametrize("dimensions", [2, 3])
def test_their_runs_do_not_move_the_bar_and_do_not_depend_on_threads(dimensions):
    scenario = Scenario.parse({**DATA, "dimensions": dimensions, "shaking": FEW})
    seen, told = [], []
    for threads in (1, 3):
        verdict = verify(
            scenario, levels=[], threads=threads, on_progress=lambda done, total: seen.append((done, total))
        )
        assert seen[-1] == (verdict.runs, verdict.runs)
        told.append([option.contents for option in verdict.options])
    assert told[0] == told[1]


def test_open_drawers_are_a_bound():
    data = {**DATA, "contents": {"kind": "boxes", "drawers": "stops", "mass_share": 0.3}}
    bare = verify(Scenario.parse(data), levels=[], progress=False, threads=1).without
    assert bare.contents.opened.estimate >= bare.contents.rigid.estimate
