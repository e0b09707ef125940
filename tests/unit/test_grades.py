"""Grades of the inputs beside the numbers, and quick estimates that are far from the simulation."""

import csv
import html
import io
import json
from dataclasses import replace

import pytest
import verdict_cases

import stayput as sp
from stayput.app.verification import verdict_reply
from stayput.measures import MEASURES, GelMats, LBracket, LockedCasters, parameters
from stayput.measures.measure import GRADE_OF, MEANINGS, Grade
from stayput.report.verdict.tables import verdict_csv, verdict_markdown
from stayput.scenario.measures import Option
from stayput.verification.notes import APART, notes
from stayput.verification.options import grade, inputs, weakest

MINE = {"width": 0.4, "height": 1.8, "mass": 90.0}
WALL = {"gap": 0.02, "construction": "stud"}
ROOM = {"floor": "wood flooring", "left_wall": WALL, "ceiling": {"height": 2.4}}
OWN_FLOOR = {**ROOM, "floor": {"static_friction": 0.5}}


def scenario(furniture=MINE, room=ROOM, **tables):
    return sp.Scenario.parse({"furniture": furniture, "room": room, **tables})


def option(*measures):
    return Option("it", (measures,))


def test_a_grade_is_that_of_the_weakest_input_that_decides():
    for measures, stated, graded in (
        ((), {"room": OWN_FLOOR}, Grade.A),
        ((), {}, Grade.B),
        ((), {"furniture": {"preset": "bookcase"}}, Grade.C),
        ((MEASURES["anti_slip_sheet"](),), {}, Grade.B),
        ((GelMats(),), {}, Grade.C),
        ((LockedCasters(),), {}, Grade.C),
        ((), {"room": {"floor": "locked caster"}}, Grade.C),
        ((), {"shaking": {"intensity": 6.0, "building": {"storeys": 5}, "storey": 3}}, Grade.C),
    ):
        assert grade(option(*measures), scenario(**stated)) is graded
    assert {one.label[0] for one in weakest(option(LBracket()), scenario())} == {
        "screwed L-brackets: strength of one"
    }
    unknown = {**ROOM, "left_wall": {"gap": 0.02}}
    assert grade(option(LBracket(strength=1200.0)), scenario(room=unknown)) is Grade.C  # studs or not


def test_what_the_user_gives_counts_as_known():
    given = option(LBracket(strength=1200.0))
    assert grade(given, scenario()) is Grade.B
    assert grade(given, scenario(room=OWN_FLOOR)) is Grade.A
    # stiffness and damping do not decide; a default that is said again is the default
    assert grade(option(LBracket(stiffness=2e5)), scenario(room=OWN_FLOOR)) is Grade.C
    assert grade(option(LBracket(strength=None)), scenario(room=OWN_FLOOR)) is Grade.C


@pytest.mark.parametrize(
    ("sizes", "graded"),
    [
        ({"width": 0.30, "height": 1.80, "mass": 200.0}, Grade.C),
        ({"width": 0.30, "height": 1.80, "mass": 150.0}, Grade.C),
        ({"width": 0.31, "height": 1.78, "mass": 150.0}, Grade.A),
        ({"width": 0.31, "height": 1.78, "shelves": [30.0, 20.0]}, Grade.A),
    ],
)
def test_a_preset_s_own_sizes_are_defaults_even_where_a_page_sends_them(sizes, graded):
    assert inputs(option(), scenario({"preset": "bookcase", **sizes}))[0].grade is graded


def test_the_floor_counts_where_the_piece_stands_on_it():
    def about_the_floor(*measures):
        return any(one.label[0] == "friction on the floor" for one in inputs(option(*measures), scenario()))

    assert about_the_floor()
    assert about_the_floor(LBracket())
    assert about_the_floor(MEASURES["wedge_stopper"]())
    assert not about_the_floor(MEASURES["felt_glides"]())
    assert about_the_floor(GelMats())  # it adds to the floor's friction


def test_every_measure_that_holds_by_strength_or_grip_says_what_decides():
    for kind, measure in MEASURES.items():
        decides = [about.name for about in parameters(measure) if about.decides]
        numbers = {about.name for about in parameters(measure) if not about.choices}
        grips = {"strength", "static_friction", "tension"} & numbers
        assert grips <= set(decides), kind
        assert not {"damping", "stiffness", "count", "height"} & set(decides), kind
    assert set(GRADE_OF.values()) == set(MEANINGS) == set(Grade)
    assert max(Grade) is Grade.C


@pytest.mark.parametrize("language", ["en", "ja"])
def test_every_form_of_a_verdict_carries_the_grades(language):
    verdict = verdict_cases.made()
    place = 0 if language == "en" else 1
    for text in (
        html.unescape(verdict_cases.page(language)),
        verdict_markdown(verdict, language).replace("\\", ""),
    ):
        assert MEANINGS[Grade.C][place] in text
        for note in verdict.notes(language):
            assert note.replace("ζ", "") in text.replace("ζ", "").replace("\N{NO-BREAK SPACE}", " ")
    data = json.loads(verdict.to_json())
    assert [one["grade"] for one in data["options"]] == ["C", "C", "C"]
    assert data["options"][0]["inputs"][0]["en"] == "size and mass of the piece"
    assert data["grades"]["C"][language] == MEANINGS[Grade.C][place]
    rows = list(csv.DictReader(io.StringIO(verdict_csv(verdict))))
    assert [row["grade"] for row in rows] == ["C", "C", "C"]
    assert "belts: strength of one" in rows[0]["weakest_inputs"]
    reply = verdict_reply(verdict)
    assert [one.grade for one in reply.options] == ["C", "C", "C"]
    assert {"en": "grade C", "ja": "区分C"}[language] in getattr(reply.notes[0], language)


def estimated(verdict, ratio):
    return replace(verdict, estimates=replace(verdict.estimates, overturning_ratio=ratio))


def test_a_quick_estimate_far_from_the_simulation_is_explained():
    verdict = verdict_cases.made({**verdict_cases.SCENARIO, "room": {"floor": "wood flooring"}})
    found = verdict.without.probabilities["overturned"].estimate
    near, far = found + APART - 0.01, found - APART - 0.01
    assert not any("quick estimate" in english for english, _ in notes(estimated(verdict, near)))
    english, japanese = notes(estimated(verdict, far))[1]
    assert "The quick estimate (Kaneko and Hayashi)" in english
    assert "ζ = 0.5" in english
    assert "ばらつきζ=0.5" in japanese
    assert "may slide" not in english
    for beside in ({"left_wall": {"gap": 0.02}}, {"ceiling": {"height": 1.81}}):
        room = {"floor": "wood flooring", **beside}  # of what does not stand free the formula says nothing
        walled = verdict_cases.made({**verdict_cases.SCENARIO, "room": room})
        assert not any("quick estimate" in note for note, _ in notes(estimated(walled, far)))
    unknown = estimated(verdict_cases.without_numbers(), 0.9)
    assert not any("quick estimate" in note for note, _ in notes(unknown))


def test_what_the_formula_leaves_out_is_what_there_is():
    slippery = {"floor": "PTFE glide", "right_wall": {"gap": 2.0}, "ceiling": {"height": 2.4}}
    low = {"preset": "bookcase", "cg_offset": [0.0, -0.3]}
    table = {"furniture": low, "room": slippery, "shaking": {"builtin": "near-fault"}}
    verdict = verdict_cases.made(table)
    bare = replace(verdict, options=(verdict.without,))
    english = notes(estimated(bare, 0.0))[1][0]
    for said in ("may slide", "centre of gravity at 33 %"):
        assert said in english


@pytest.mark.parametrize(
    ("floor", "tag"),
    [("wood flooring", None), ("carpet", "low"), ({"surface": "carpet", "settlement": 0.0008}, "given")],
)
def test_a_floor_that_gives_is_among_the_inputs(floor, tag):
    scenario = sp.Scenario.parse({"furniture": {"preset": "chest"}, "room": {"floor": floor}})
    found = {item.label[0]: item.tag for item in inputs(Option("none"), scenario)}
    assert found.get("how far the floor gives") == tag
