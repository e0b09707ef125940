"""The plan to buy and do: forces and margins, filters, order, the card in both languages and on paper."""

from __future__ import annotations

import html
import itertools
import json
import math
import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from planned_room import ROOM
from typer.testing import CliRunner

import stayput as sp
from stayput.catalogue import LANGUAGES, phrase, say
from stayput.cli import app
from stayput.fragility.probabilities import probability
from stayput.measures import MEASURES, Belt, LBracket, WedgeStopper
from stayput.measures.measure import Grade
from stayput.mechanics.devices.columns import DEVICE
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.room.card import plan_html
from stayput.report.room.elevation import ELEVATION_SCALES, SIZES, elevation_scale, elevation_svg, sizes_of
from stayput.rooms.purchases import MARGIN, QUANTILE, DeviceForces, Purchase, quantile_of
from stayput.rooms.step_words import (
    changes_nothing,
    checks,
    in_runs,
    measures_on,
    not_strong_enough,
    what_it_brings,
)
from stayput.uncertainty import USUAL
from stayput.verification.demand import DEMAND_RUNS
from stayput.verification.options import inputs_of_piece
from stayput.verification.people import PairedEstimate
from stayput.verification.room_words import people_in, piece_name
from stayput.verification.words import class_phrase

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.rooms.steps import Fix
    from stayput.verification.people import People
    from stayput.verification.verdict import OptionVerdict


def room(**tables: Any) -> sp.Scenario:
    return sp.Scenario.parse({**ROOM, **tables})


def alone(**shaking: Any) -> sp.Scenario:
    """Return the room with the bookcase only, and other shaking."""
    return room(furniture=ROOM["furniture"][:1], shaking={**ROOM["shaking"], **shaking})


def planned(scenario: sp.Scenario, **home: Any) -> sp.ActionPlan:
    return sp.action_plan(sp.verify(scenario, changes=False, progress=False), progress=False, **home)


@pytest.fixture(scope="module")
def plan() -> sp.ActionPlan:
    return planned(room())


def fixes(plan: sp.ActionPlan) -> list[Fix]:
    """Return what stands on the card: to buy, instead of that, and not enough."""
    bought = [fix for step in plan.steps for fix in (step.fix, step.instead) if fix is not None]
    assert all(fix.sound for fix in bought)
    return [*bought, *plan.not_enough.values()]


def of_people(effect: OptionVerdict) -> People:
    assert effect.people is not None
    return effect.people


def test_the_margin_makes_up_for_the_weakest_products():
    """A strength whose median is MARGIN times the force is below it in 5 % of the draws."""
    strengths = MARGIN * USUAL["strength"].quantile(np.linspace(0.0005, 0.9995, 1000))
    assert np.mean(strengths < 1.0) == pytest.approx(1.0 - QUANTILE, abs=0.001)
    assert pytest.approx(math.exp(1.6449 * math.sqrt(math.log(1.09))), rel=1e-3) == MARGIN


def test_the_quantile_is_of_each_direction_and_by_rank():
    devices = np.zeros((40, 2), DEVICE)
    devices["peak_pull"][:, 0] = 2.0 * np.arange(1, 41)  # of two devices alike, which share it
    devices["peak_shear"][:, 1] = 2.0 * (100 - np.arange(1, 41))
    belt = Belt(count=2).apply(sp.Body(0.3, 1.8, 100.0), sp.Room(left_wall=sp.Wall(0.02))).elements[0]
    assert belt.count == 2
    # 38 of 40 runs are 95 %: the 38th smallest pull is 38, the 38th smallest shear 97
    assert quantile_of(devices, [belt, belt]) == DeviceForces(38.0, 0.0, 97.0)


def test_a_purchase_is_enough_where_it_holds_in_every_direction():
    needed = DeviceForces(800.0, 5000.0, 700.0)
    assert Purchase(LBracket(), needed, DeviceForces(1300.0, math.inf, 1700.0)).enough
    assert not Purchase(LBracket(), needed, DeviceForces(1300.0, math.inf, 600.0)).enough
    assert Purchase(WedgeStopper()).enough


def test_measures_on_a_wall_alone_are_drilled():
    drilled = {kind for kind, measure in MEASURES.items() if measure.drilled}
    assert drilled == {"l_bracket", "l_bracket_board", "belt", "chain"}


def test_the_plan_hangs_together(plan: sp.ActionPlan):
    assert plan.verdict.complete
    assert {step.what for step in plan.steps if step.fix} | set(plan.unsolved) >= {"bookcase"}
    assert plan.together is not None
    now = people_in(plan.verdict)
    assert of_people(plan.together).hit.chance.estimate < now.hit.chance.estimate
    for step in plan.steps:
        assert (step.move is None) != (step.fix is None)
        for effect in (step.alone, step.together):
            chance, change = of_people(effect).hit
            assert change is not None
            assert change.estimate == pytest.approx(chance.estimate - now.hit.chance.estimate)
    assert of_people(plan.steps[0].alone).hit == of_people(plan.steps[0].together).hit
    # each step is the one that brings most after those before it: together it gets no worse
    severities = [of_people(step.together).severity for step in plan.steps]
    assert all(later <= earlier for earlier, later in itertools.pairwise(severities))


def test_brackets_come_in_the_number_that_their_screws_need(plan: sp.ActionPlan):
    (fix,) = [step.fix for step in plan.steps if step.what == "bookcase" and step.fix]
    (bracket,) = fix.purchases
    assert bracket.measure.kind == "l_bracket"
    assert bracket.enough or bracket.count == 3  # one on each stud behind 0.8 m at 303 mm
    assert bracket.needed is not None
    assert bracket.needed.pull > 200.0
    assert fix.overturns.estimate < 0.1


def test_a_piece_that_falls_where_nobody_is_has_a_step_too():
    """Two bookcases far from the only bed: nothing reaches it, and both are to be held all the same."""
    far = planned(
        room(
            plan={"width": 7.0, "length": 2.7},
            furniture=[
                {"name": "first", "preset": "bookcase", "against": "left_wall", "along": 1.9},
                {"name": "second", "preset": "bookcase", "against": "left_wall", "along": 0.7},
            ],
            places=[{"kind": "bed", "at": [5.5, 1.9], "heading": math.pi / 2}],
        )
    )
    fell = {piece.name: piece.probabilities["overturned"].estimate for piece in far.verdict.without.pieces}
    assert people_in(far.verdict).hit.chance.estimate == 0.0
    assert min(fell.values()) >= 0.5
    assert {step.what for step in far.steps} == {"first", "second"}
    assert not any(step.for_people for step in far.steps)
    assert far.together is not None
    assert max(one.probabilities["overturned"].estimate for one in far.together.pieces) < 0.3
    for language, told in (("en", "overturns"), ("ja", "倒れ")):
        assert told in far.verdict.sentence(language)
        assert max(fell, key=lambda name: fell[name]) in far.verdict.sentence(language)
        assert say("action_plan.only_falls", language) in plan_html(far, language)


def test_what_still_falls_is_said(plan: sp.ActionPlan):
    before = plan.verdict
    nothing = replace(plan, steps=(), unsolved=("bookcase",))
    chance = next(one for one in before.without.pieces if one.name == "bookcase").probabilities["overturned"]
    told = phrase("action_plan.piece_falls", piece=piece_name("bookcase"), was=chance.texts)
    for number, language in enumerate(LANGUAGES):
        assert told[number] in plan_html(nothing, language).replace("\xa0", " ")
    assert "helps with: bookcase" in plan_html(nothing)


@pytest.mark.parametrize("without", ["steps", "anything"])
def test_how_the_room_is_leads_on_every_card(plan: sp.ActionPlan, rented: sp.ActionPlan, without: str):
    """A plan without steps that finds nothing good enough tells who is hit too, with the interval."""
    fix = rented.not_enough["bookcase"]
    not_enough = {"bookcase": fix} if without == "steps" else {}
    bare = replace(plan, steps=(), unsolved=(), not_enough=not_enough)
    hit = people_in(plan.verdict).hit.chance
    assert hit.estimate > 0.0
    what = phrase("rooms.chance_of_hit")
    told = phrase("action_plan.chance", what=what, share=hit.texts)
    for number, language in enumerate(LANGUAGES):
        for one in (plan, bare):
            first = re.search(r'<p class="sentence">(.*?)</p>', plan_html(one, language))
            assert first is not None
            assert told[number] in first[1].replace("\xa0", " ")
        assert "nothing has to be bought" not in plan_html(bare, language)
        assert "買う物はありません" not in plan_html(bare, language)


def test_chances_on_the_card_have_their_intervals(plan: sp.ActionPlan):
    """In "about 30 % (18 to 46 %) → under 17 %" the share that was has one as that which will be."""
    often, verdict = probability(np.arange(40).reshape(40, 1) < 12), plan.verdict
    people = replace(people_in(verdict), hit=PairedEstimate(often, None))
    probabilities = {**verdict.without.probabilities, OVERTURNED: often}
    pieces = tuple(replace(one, probabilities=probabilities) for one in verdict.without.pieces)
    without = replace(verdict.without, pieces=pieces, people=people)
    page = html.unescape(plan_html(replace(plan, verdict=replace(verdict, options=(without,)))))
    assert f"{often.text} →" in page.replace("\xa0", " ")
    assert not re.search(r"about [\d.]+ % →", page.replace("\xa0", " "))


def test_strengths_are_told_of_the_runs_that_they_are_from(plan: sp.ActionPlan):
    """A plan of 32 runs has forces on unbreakable devices from 16 of them."""
    often = replace(plan.verdict, options=(replace(plan.verdict.without, runs=32),))
    for verdict, runs in ((plan.verdict, 8), (often, DEMAND_RUNS)):
        page = html.unescape(plan_html(replace(plan, verdict=verdict))).replace("\xa0", " ")
        assert f"in 95 % of {runs} runs" in page


def test_the_room_as_it_is_has_the_numbers_of_its_verdict():
    """A race ran nothing 36 times: the card told of 32 of these beside a report that told of all.

    On the page a plan is made for the room before what was tried in it, whose numbers are others.
    """
    bookcase = ROOM["furniture"][0]
    held = {**bookcase, "measures": [{"type": "l_bracket", "count": 4}]}
    before, after = (room(furniture=[it], uncertainty={"samples": 40}) for it in (bookcase, held))
    verdict, tried = (sp.verify(each, changes=False, progress=False) for each in (before, after))
    plan = sp.action_plan(verdict, progress=False)
    made = sp.action_plan(replace(tried, scenario=before), progress=False)
    was = verdict.without
    for of in (plan, made):
        now = of.verdict.without
        assert (now.runs, now.probabilities, now.people) == (40, was.probabilities, was.people)
    assert was.probabilities[OVERTURNED].estimate > tried.without.probabilities[OVERTURNED].estimate
    assert "are from 32 to 40 runs" in html.unescape(plan_html(plan)).replace("\xa0", " ")


def test_on_tatami_there_is_neither_gel_nor_a_wedge():
    scenario = room(furniture=ROOM["furniture"][:1])
    soft = planned(scenario, tatami=True, plasterboard=True)
    assert fixes(soft)
    assert {kind for fix in fixes(soft) for kind in fix.kinds} <= {"l_bracket", "belt", "tension_pole"}
    for fix in fixes(soft):
        assert fix.kinds == ("tension_pole",) or any("plasterboard" in caution[0] for caution in fix.cautions)


def test_the_grade_is_that_of_the_weakest_input(plan: sp.ActionPlan):
    assert all(step.grade == Grade.C for step in plan.steps)
    bookcase = {"name": "bookcase", "width": 0.3, "length": 0.8, "height": 1.8, "mass": 180.0}
    known = room(
        furniture=[{**bookcase, "against": "left_wall", "along": 1.9}],
        room={"floor": {"static_friction": 0.4, "kinetic_friction": 0.3}, "walls": "stud"},
    )
    for scenario, grades in ((known, {Grade.A}), (room(), {Grade.B, Grade.C})):
        assert {one.grade for one in inputs_of_piece((), scenario, 0)} == grades
        labels = {one.label[0] for one in inputs_of_piece((LBracket(),), scenario, 0)}
        assert ("what is behind the wall's surface" in labels) == (scenario is not known)


@pytest.fixture(scope="module")
def rented() -> sp.ActionPlan:
    """Return a plan without drilling: what then holds a full bookcase is too weak."""
    return planned(alone(), no_drilling=True, threads=1)


def test_the_same_bits_for_any_number_of_threads(rented: sp.ActionPlan):
    texts = [plan.to_json() for plan in (rented, planned(alone(), no_drilling=True, threads=3))]
    assert len({re.sub(r'"seconds": [0-9.]+', "", text) for text in texts}) == 1


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_card_says_what_to_buy_where_and_what_it_brings(plan: sp.ActionPlan, language: str):
    page = plan_html(plan, language)
    assert f'<html lang="{language}">' in page
    assert "{" not in re.sub(r"<(style|script)>.*?</\1>", "", page, flags=re.DOTALL)
    assert page.count("<tr>") == len(plan.steps) + 1
    assert page.count('class="elevation"') == sum(step.fix is not None for step in plan.steps)
    for key in ("title", "buy", "where", "effect", "check"):
        assert say(f"action_plan.{key}", language) in page
    # what is not known well stands after what to do
    known = page.split("</table>")[1].split('<section class="known">')[1]
    assert '<p class="rough">' in known
    assert '<p class="rough">' not in page.split("</table>")[0]
    for step in plan.steps:
        assert all(say(one.label, language) in html.unescape(known) for one in step.weakest)
    assert page.count("<script") == page.count("<script>") <= 1  # nothing is loaded
    assert "http://" not in page
    assert "https://" not in page


def scale_of(page: str, drawing: str) -> int:
    found = re.search(rf"{drawing} 1:(\d+)", page)
    assert found is not None
    return int(found[1])


def test_plan_and_elevations_are_to_the_scale_that_they_say(plan: sp.ActionPlan):
    page = plan_html(plan)
    style = re.search(r'<svg style="width:([\d.]+)mm" viewBox="0 0 (\d+) ', page)
    assert style is not None
    # 460 px are the longer side of the room, 3.6 m
    on_paper = float(style[1]) * 1e-3
    assert on_paper * scale_of(page, "Plan") == pytest.approx(float(style[2]) * 3.6 / 460.0, rel=0.003)
    assert on_paper <= sizes_of(plan).plan[0] + 1e-4
    fix, said = fixes(plan)[0], scale_of(page, "elevations")
    picture = re.search(r'<svg viewBox="0 0 ([\d.]+) ([\d.]+)" class="elevation".*?</svg>', page, re.DOTALL)
    assert picture is not None
    assert re.search(rf"width:{float(picture[1]) / 10.0:.1f}mm", picture[0])
    box = re.search(r'width="([\d.]+)" height="([\d.]+)" class="piece"', picture[0])
    assert box is not None
    body = fix.piece.body
    sizes = [float(size) * 1e-4 * said for size in box.groups()]
    assert sizes == pytest.approx([body.length, body.height], rel=0.002)


def test_drawings_are_larger_where_there_are_fewer_steps(plan: sp.ActionPlan):
    step = next(step for step in plan.steps if step.fix)
    assert step.fix is not None
    scales: list[int] = []
    for count in (1, 2, 4):
        several = replace(plan, steps=(replace(step, instead=None),) * count)
        page, sizes, fixes_drawn = plan_html(several), sizes_of(several), [step.fix] * count
        scales.append(scale_of(page, "elevations"))
        assert scales[-1] == elevation_scale(fixes_drawn, sizes)
        drawn = re.search(r"height:([\d.]+)mm", elevation_svg(step.fix, step.what, scales[-1], "en"))
        assert drawn is not None
        high = count * float(drawn[1]) * 1e-3
        assert high <= sizes.elevations[1] + 1e-4 * count or scales[-1] == ELEVATION_SCALES[-1]
        assert f"--letters: {sizes.letters}pt" in page
    assert scales == sorted(set(scales))
    letters = [sizes.letters for sizes in SIZES]
    assert letters == sorted(letters, reverse=True)


def test_a_tenant_is_told_what_else_can_be_done(rented: sp.ActionPlan):
    """What may be done without drilling is too weak, and no step: ask the landlord, or drill."""
    assert not any(fix.drilled for fix in fixes(rented))
    assert all(step.fix is None for step in rented.steps)
    assert set(rented.not_enough) == {"bookcase"} == set(rented.drilled)
    fix = rented.drilled["bookcase"]
    assert fix.drilled
    assert fix.sound
    assert json.loads(rented.to_json())["not_enough"]["bookcase"]["too_weak"]
    assert json.loads(rented.to_json())["with_drilling"]["bookcase"]["buy"][0]["type"] == fix.kinds[0]
    nothing = planned(alone(), tatami=True, dropped_ceiling=True, no_drilling=True)
    assert nothing.unsolved == ("bookcase",) == tuple(nothing.drilled)
    for language in LANGUAGES:
        page = html.unescape(plan_html(rented, language)).replace("\xa0", " ")
        for key in ("ask_landlord", "out_of_reach"):
            assert say(f"action_plan.{key}", language) in page
        assert page.count(f"<dt>{say('action_plan.buy', language)}</dt>") == 1  # with drilling only
        assert say(measures_on("bookcase", rented.not_enough["bookcase"]), language) in page
        assert fix.overturns.texts[LANGUAGES.index(language)] in page
        unsolved = html.unescape(plan_html(nothing, language))
        assert say("action_plan.drilled_on", language, piece=piece_name("bookcase")) in unsolved
        assert say("action_plan.ask_landlord", language) in unsolved


def test_the_json_holds_forces_and_effects(plan: sp.ActionPlan):
    data = json.loads(plan.to_json())
    assert data["margin"] == pytest.approx(MARGIN, rel=1e-6)
    assert [step["what"] for step in data["steps"]] == [step.what for step in plan.steps]
    bought = next(step["fix"]["buy"][0] for step in data["steps"] if step["fix"])
    assert set(bought["rated_n"]) == {"pull", "shear"}
    (bare,) = data["room"]["options"]
    hit = people_in(plan.verdict).hit.chance
    assert bare["people"]["hit"]["estimate"] == pytest.approx(hit.estimate)


def test_a_room_in_which_nothing_does_harm_needs_nothing():
    calm = planned(alone(intensity="3"))
    assert calm.steps == ()
    assert calm.together is None
    assert "nothing has to be bought" in plan_html(calm)


@pytest.mark.parametrize("intensity", ["3", "6-upper"])
def test_a_card_of_a_room_without_persons_tells_of_none(intensity: str):
    shaking = {**ROOM["shaking"], "intensity": intensity}
    card = planned(room(furniture=ROOM["furniture"][:1], places=[], shaking=shaking))
    assert bool(card.steps or card.not_enough) == (intensity == "6-upper")
    for language, words in (("en", "hit|anybody|somebody|bed"), ("ja", "人に|ベッド")):
        page = re.sub(r"<(style|script)>.*?</\1>", "", plan_html(card, language), flags=re.DOTALL)
        assert not re.findall(words, page.split("<main>")[0].split("<header>")[1] + page.split("<main>")[1])


@pytest.mark.parametrize(
    ("flags", "told"), [(["--tatami"], "give both"), (["--card", "card.html"], "is given without a [plan]")]
)
def test_the_command_line_refuses_a_plan_of_no_room(tmp_path: Path, flags: list[str], told: str):
    file = tmp_path / "piece.toml"
    file.write_text('[furniture]\npreset = "bookcase"\n[shaking]\nintensity = "5-upper"\n')
    done = CliRunner().invoke(app, ["verify", str(file), *flags])
    assert done.exit_code == 2
    assert told in " ".join(done.output.split())


def test_what_is_too_weak_says_so_first(plan: sp.ActionPlan, rented: sp.ActionPlan):
    weak = [fix for fix in fixes(rented) if not fix.enough]
    assert weak
    for fix in weak:
        said = not_strong_enough(fix, rented)
        assert said is not None
        for language, text in zip(LANGUAGES, said[0], strict=True):
            page = plan_html(rented, language).replace("\xa0", " ")
            assert f'<p class="weak"><strong>{text}</strong>' in page
    strong = [fix for fix in fixes(plan) if fix.enough]
    assert all(not_strong_enough(fix, plan) is None for fix in strong)


@pytest.mark.parametrize(
    ("gives_way", "overturns", "key"),
    [(0.0, 0.0, "no_reserve"), (0.5, 0.0, "no_reserve"), (0.0, 0.5, "no_reserve"), (0.5, 0.5, "weak")],
)
def test_what_works_in_the_runs_has_no_reserve_and_is_not_too_weak(
    plan: sp.ActionPlan, rented: sp.ActionPlan, gives_way: float, overturns: float, key: str
):
    """Brackets with which the piece falls in 0 % of the runs are not said to be not strong enough."""
    weak = next(fix for fix in fixes(rented) if not fix.enough)
    chance, (step, *_) = weak.overturns, [one for one in plan.steps if one.fix]
    fix = replace(
        weak, gives_way=replace(chance, estimate=gives_way), overturns=replace(chance, estimate=overturns)
    )
    said = not_strong_enough(fix, plan)
    assert said is not None
    assert said[0] == phrase(
        f"action_plan.{key}", strength=class_phrase(plan.verdict.intensity), in_runs=in_runs(fix)
    )
    page = plan_html(replace(plan, steps=(replace(step, fix=fix, instead=None),), unsolved=(), not_enough={}))
    dead_end = say("action_plan.not_enough", "en", pieces=piece_name(step.what))
    assert (dead_end in page) == (key == "weak")


def test_each_check_says_whether_it_is_of_the_step_or_of_its_variant(
    plan: sp.ActionPlan, rented: sp.ActionPlan
):
    number, step = next((n, one) for n, one in enumerate(plan.steps, 1) if one.fix is not None)
    step = replace(step, instead=rented.not_enough["bookcase"])
    steps = tuple(step if n == number else one for n, one in enumerate(plan.steps, 1))
    page = plan_html(replace(plan, steps=steps), "en")
    assert re.search(rf"<strong>[\d, ]*{number}[\d, ]*</strong>", page)
    label = say("action_plan.steps_instead", "en", steps=str(number))
    assert f"<strong>{label}</strong>" in page
    assert step.instead is not None
    (last, *_) = list(checks(step.instead))[::-1]
    assert last[0] in page.split(f"<strong>{label}</strong>")[1].split("</li>")[0]


def test_a_step_that_helps_only_with_others_says_with_which(plan: sp.ActionPlan):
    """Two pieces hit the same bed in the same runs: either alone changes nothing."""
    step, now = plan.steps[0], people_in(plan.verdict)
    people = of_people(step.alone)
    assert people.hit.change is not None
    same = replace(people.hit.change, estimate=0.0)
    names = ("hit", "shut_in", "blocked")
    outlooks = {name: getattr(now, name)._replace(change=same) for name in names}
    idle = replace(step.alone, people=replace(people, **outlooks))
    assert changes_nothing(idle, plan)
    first, second = replace(step, alone=idle, together=idle), replace(step, alone=idle)
    pair = replace(plan, steps=(first, second))
    only, told = list(what_it_brings(1, pair)), list(what_it_brings(2, pair))
    assert only == [phrase("action_plan.only_together", steps="2")]
    assert told[0] == phrase("action_plan.only_together", steps="1")
    assert len(told) == 2


def test_the_command_line_plans_a_room_without_places_and_doors_and_tells_of_falls_alone(tmp_path: Path):
    room, out = tmp_path / "room.toml", tmp_path / "plan.html"
    room.write_text(
        '[plan]\nwidth = 3.6\nlength = 2.7\n[[furniture]]\nname = "bookcase"\npreset = "bookcase"\n'
        'against = "left_wall"\nalong = 1.35\n[shaking]\nbuiltin = "near-fault"\n'
        "[uncertainty]\nsamples = 2\n",
        encoding="utf-8",
    )
    flags = ["--card", str(out), "--no-drilling", "--lang", "ja"]
    done = CliRunner().invoke(app, ["verify", str(room), *flags])
    assert done.exit_code == 0, done.output
    assert "plan.html" in done.output
    page = out.read_text(encoding="utf-8")
    assert say("action_plan.no_drilling", "ja") in page
    assert "本棚" in page
