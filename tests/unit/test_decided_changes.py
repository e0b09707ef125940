"""Changes of a room that have been decided on: they are steps of the plan."""

from __future__ import annotations

import json
import math
from typing import Any

import planned_room
import pytest

import stayput as sp
from long_cases import long
from stayput.measures import Belt, LBracket
from stayput.report.room.card import plan_html
from stayput.rooms.steps import changes_between
from stayput.verification.changes import Change

ROOM: dict[str, Any] = {
    **planned_room.ROOM,
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 3}},
    "uncertainty": {"samples": 2},
}
MOVE = Change("bookcase", at=(3.43, 2.2), heading=math.pi)
MOVED = {"name": "bookcase", "preset": "bookcase", "against": "right_wall", "along": 2.2}


def room(*furniture: dict[str, Any], **tables: Any) -> sp.Scenario:
    return sp.Scenario.parse(
        {**ROOM, "furniture": [*furniture, *ROOM["furniture"][len(furniture) :]], **tables}
    )


def verified(scenario: sp.Scenario) -> sp.Verdict:
    return sp.verify(scenario, changes=False, progress=False)


def falls(verdict: sp.Verdict) -> dict[str, float]:
    return {one.name: one.probabilities["overturned"].estimate for one in verdict.without.pieces}


@pytest.fixture(scope="module")
def verdict() -> sp.Verdict:
    return verified(room())


def decided(verdict: sp.Verdict, *changes: Change, **home: Any) -> sp.ActionPlan:
    return sp.action_plan(verdict, decided=changes, progress=False, **home)


def test_decided_changes_are_steps_and_the_rest_is_planned_with_them(verdict: sp.Verdict):
    plan = decided(verdict, MOVE, Change("chest", Belt()))
    steps = {(step.what, step.move is not None): step for step in plan.steps if step.decided}
    assert set(steps) == {("bookcase", True), ("chest", False)}
    chest = steps["chest", False].fix
    assert chest is not None
    assert chest.kinds == ("belt",)
    assert chest.purchases[0].needed is not None  # how strong it must be is told
    others = [step for step in plan.steps if not step.decided]
    assert all(step.move is None for step in others)  # nothing else is moved
    assert {step.what for step in others} <= {"bookcase"}


def test_what_decided_changes_bring_is_what_the_room_with_them_gives(verdict: sp.Verdict):
    """All decided moves and measures together are as that room verified by itself, from another file."""
    held = {**MOVED, "measures": [{"type": "l_bracket"}]}
    bed = {**ROOM["places"][0], "at": [1.2, 0.8]}
    after = room(held, {**ROOM["furniture"][1], "against": "far_side_wall"}, places=[bed])
    changes = changes_between(room(), after)
    moved = {(what, True) for what in ("bookcase", "chest", "bed")}
    assert {(one.what, one.measure is None) for one in changes} == {*moved, ("bookcase", False)}
    plan, there = decided(verdict, *changes), verified(after)
    last = max(number for number, step in enumerate(plan.steps) if step.decided)
    assert all(step.decided for step in plan.steps[: last + 1])  # no other step comes between
    together = plan.steps[last].together
    assert together.people is not None
    assert there.without.people is not None
    for name in ("hit", "shut_in", "blocked"):
        assert getattr(together.people, name).chance == getattr(there.without.people, name).chance
    assert {one.name: one.probabilities["overturned"].estimate for one in together.pieces} == falls(there)


def test_a_choice_without_effect_stays_and_says_so(verdict: sp.Verdict):
    """The chest, which does no harm, is moved by a hand's breadth."""
    plan = decided(verdict, Change("chest", at=(1.55, 0.26), heading=math.pi / 2))
    (step,) = [one for one in plan.steps if one.decided]
    assert step.what == "chest"
    page = plan_html(plan)
    assert "your choice" in page
    assert json.loads(plan.to_json())["steps"][plan.steps.index(step)]["decided"] is True
    assert "決めた変更" in plan_html(plan, "ja")


def test_measures_in_place_are_told_apart_from_those_decided_on():
    held = {**ROOM["furniture"][1], "measures": [{"type": "gel_mats"}]}
    plan = decided(verified(room(ROOM["furniture"][0], held)), Change("bookcase", LBracket()))
    page = plan_html(plan)
    assert "Taken as in place already: Adhesive gel mats on the chest of drawers." in page
    assert [step.what for step in plan.steps if step.decided] == ["bookcase"]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ([Change("desk", LBracket())], "'desk'"),
        ([Change("bed", LBracket())], "furniture"),
        ([Change("bookcase")], "either a measure or another place"),
        ([Change("bookcase", LBracket(), at=(1.0, 1.0))], "either a measure or another place"),
        ([Change("bookcase", at=(1.4, 1.9), heading=0.0)], "bed"),
        ([Change("bookcase", at=(9.0, 1.9), heading=0.0)], "bookcase"),
        ([MOVE, MOVE], "twice"),
    ],
)
def test_what_cannot_be_decided_is_refused(verdict: sp.Verdict, changes: list[Change], told: str):
    with pytest.raises(sp.InputError, match=told):
        decided(verdict, *changes)


def test_what_stands_on_another_stays_there():
    box = {"name": "box", "preset": "television", "on": "chest", "at": [0.0, 0.0], "heading": math.pi / 2}
    scenario = sp.Scenario.parse({**ROOM, "furniture": [*ROOM["furniture"], box]})
    with pytest.raises(sp.InputError, match="stands on or is joined"):
        decided(verified(scenario), Change("chest", at=(1.8, 0.3)))


BOX = {"width": 0.34, "length": 0.9, "height": 0.9}
STACKED: list[dict[str, Any]] = [
    {**BOX, "name": "low", "mass": 60.0, "at": [0.195, 1.9], "heading": 0.0},
    {**BOX, "name": "up", "mass": 40.0, "on": "low", "at": [0.0, 0.0]},
]
CONNECTORS = [{"first": "up", "second": "low", "at": [0.05, y, 0.9]} for y in (1.6, 2.2)]


@pytest.mark.parametrize("joints", [CONNECTORS, *long([])], ids=["joined", "stacked"])
def test_measures_on_pieces_that_stand_on_each_other_act_together(joints: list[dict[str, Any]]):
    tables: dict[str, Any] = {"joints": joints} if joints else {}
    tables["shaking"] = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}}
    bare = sp.Scenario.parse({**ROOM, "furniture": STACKED, **tables})
    plan = decided(verified(bare), Change("up", Belt()), Change("low", LBracket()))
    held = {
        step.what: [{"type": one.measure.kind, "count": one.count} for one in step.fix.purchases]
        for step in plan.steps
        if step.fix is not None
    }
    tried = [{**piece, "measures": held[piece["name"]]} for piece in STACKED]
    there = verified(sp.Scenario.parse({**ROOM, "furniture": tried, **tables}))
    assert plan.together is not None
    assert plan.together.people is not None
    assert there.without.people is not None
    assert plan.together.people.hit.chance == there.without.people.hit.chance
    shares = {one.name: one.probabilities["overturned"].estimate for one in plan.together.pieces}
    assert shares == falls(there)


def test_a_plan_is_made_where_a_piece_carries_another():
    """A wedge would lean the lower one into the upper one, and is not tried."""
    once = {"shaking": {"intensity": "6-upper", "builtin": "near-fault"}, "uncertainty": {"samples": 4}}
    plan = decided(verified(sp.Scenario.parse({**ROOM, **once, "furniture": STACKED})))
    low = [step.fix for step in plan.steps if step.what == "low" and step.fix is not None]
    assert all("wedge_stopper" not in fix.kinds for fix in low)
    assert plan.steps or plan.unsolved or plan.not_enough


def test_a_move_tells_that_the_piece_falls_more_often_there(verdict: sp.Verdict):
    plan = decided(verdict, MOVE, Change("bookcase", Belt()))
    steps = {step.move is not None: step for step in plan.steps if step.what == "bookcase"}
    fix = steps[False].fix
    assert fix is not None
    there = verified(room({**MOVED, "measures": [{"type": "belt", "count": fix.purchases[0].count}]}))
    assert fix.overturns.estimate == falls(there)["bookcase"]
