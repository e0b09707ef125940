"""A verification of furniture with contents: how much comes out, in each form a verdict is written in."""

from __future__ import annotations

import csv
import io
import json

import pytest

from stayput.app.verification import verdict_reply
from stayput.report.verdict.html import write_report
from stayput.scenario import Scenario
from stayput.verification import verify

DATA = {
    "furniture": {"preset": "bookcase"},
    "room": {"back_wall": {"gap": 0.02}},
    "shaking": {"intensity": 6.25, "suite": {"count": 4}},
    "contents": {"kind": "books"},
    "measures": [{"type": "l_bracket"}],
    "uncertainty": {"samples": 8},
}


@pytest.fixture(scope="module")
def verdict():
    return verify(Scenario.parse(DATA), levels=[], progress=False, threads=1)


def test_each_option_has_a_share_with_its_interval(verdict):
    for option in verdict.options:
        out = option.contents.out
        assert 0.0 <= out.low <= out.estimate <= out.high <= 1.0
        assert (out.runs, out.motions) == (4 * 5 * 8, 4)
        assert option.contents.mass_out == pytest.approx(160.0 * out.estimate)
    assert verdict.best.contents.out.estimate > 0.05
    assert verdict.best.contents.rigid.estimate == 0.0


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
    assert "It then stands, but" in verdict.sentence()
    assert "of the books come out" in verdict.sentence()
    assert "倒れなくても、本の" in verdict.sentence("ja")
    assert any("bounded, not computed" in note for note in verdict.notes())


def test_it_is_in_every_file(verdict, tmp_path):
    share = verdict.best.contents.out.estimate
    data = json.loads(verdict.to_json())
    assert data["options"][0]["contents"]["contents_out_share"] == share
    rows = list(csv.DictReader(io.StringIO(verdict.to_csv())))
    assert float(rows[0]["contents_out_share"]) == share
    assert "Contents that come out" in verdict.to_markdown()
    page = write_report(verdict, tmp_path / "r.html").read_text(encoding="utf-8")
    assert page.count("Contents that come out") == 1 + len(verdict.options)
    assert verdict_reply(verdict).options[0].contents.contents_out_share == share


def test_open_drawers_are_a_bound():
    data = {**DATA, "contents": {"kind": "boxes", "drawers": "stops", "mass_share": 0.3}}
    for option in verify(Scenario.parse(data), levels=[], progress=False, threads=1).options:
        assert option.contents.opened.estimate >= option.contents.rigid.estimate
