"""A plan to buy and do as plain values: JSON."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import stayput
from stayput.report.room.data import chance_data, room_data
from stayput.report.several.data import in_both
from stayput.report.summary import number
from stayput.rooms.forces import MARGIN, QUANTILE
from stayput.rooms.step_words import forces_asked, heading, where

if TYPE_CHECKING:
    from stayput.rooms.steps import ActionPlan, Fix, PlanStep
    from stayput.rooms.verdict import RoomEffect


def plan_json(plan: ActionPlan) -> str:
    """Return a plan as the text of a JSON file."""
    return json.dumps(plan_data(plan), allow_nan=False, ensure_ascii=False, indent=2) + "\n"


def plan_data(plan: ActionPlan) -> dict[str, Any]:
    """Return a plan as plain values, in SI units that the keys name; what is not finite is None."""
    together = plan.together
    return {
        "stayput": stayput.__version__,
        "home": {name: getattr(plan.home, name) for name in plan.home.__dataclass_fields__},
        "quantile": QUANTILE,
        "margin": number(MARGIN),
        "steps": [_step(step, plan) for step in plan.steps],
        "together": None if together is None else _effect(together),
        "unsolved": list(plan.unsolved),
        "with_drilling": {name: _fix(fix) for name, fix in plan.drilled.items()},
        "room": room_data(plan.verdict),
    }


def _step(step: PlanStep, plan: ActionPlan) -> dict[str, Any]:
    def told(language: str) -> str:
        return heading(step, plan)[("en", "ja").index(language)]

    move = step.move
    return {
        "what": step.what,
        "step": in_both(told),
        "at_m": None if move is None or move.at is None else list(move.at),
        "heading_rad": None if move is None else move.heading,
        "fix": None if step.fix is None else _fix(step.fix),
        "without_drilling": None if step.instead is None else _fix(step.instead),
        "overturned": None if step.overturned is None else chance_data(step.overturned),
        "alone": _effect(step.alone),
        "together": _effect(step.together),
        "for_people": step.for_people,
        "decided": step.decided,
        "cost_class": step.cost_class,
        "grade": step.grade.value,
        "weakest": [list(one.label) for one in step.weakest],
    }


def _fix(fix: Fix) -> dict[str, Any]:
    return {
        "overturned": chance_data(fix.overturns),
        "alone": _effect(fix.alone),
        "enough": fix.enough,
        "enough_to_jma": None if fix.enough_to is None else number(fix.enough_to),
        "cautions": [list(caution) for caution in fix.cautions],
        "buy": [
            {
                "type": one.measure.kind,
                "count": one.count,
                "where": list(where(one, fix)),
                "rated_n": {name: number(force) for name, force in forces_asked(one)},
                "holds_n": None
                if one.holds is None
                else {k: number(v) for k, v in one.holds._asdict().items()},
                "enough": one.enough,
            }
            for one in fix.purchases
        ],
    }


def _effect(effect: RoomEffect) -> dict[str, Any]:
    return {
        "hit": chance_data(effect.hit),
        "hit_change": chance_data(effect.hit_change),
        "shut_in": chance_data(effect.shut_in),
        "shut_in_change": chance_data(effect.shut_in_change),
        "blocked": chance_data(effect.blocked),
        "blocked_change": chance_data(effect.blocked_change),
        "risk": number(effect.risk),
        "overturned": [chance_data(one) for one in effect.overturned],
        "overturned_change": [chance_data(one) for one in effect.overturned_change],
    }
