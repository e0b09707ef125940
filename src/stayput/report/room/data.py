"""The probabilities of a room as CSV, and a plan to buy and do as plain values."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import stayput
from stayput.files import csv_text
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.summary import attributes, by_language, number
from stayput.report.verdict.data import interval_data, people_data, verdict_data
from stayput.rooms.purchases import MARGIN, QUANTILE
from stayput.rooms.step_words import forces_asked, heading, where
from stayput.verification.room_words import people_in, piece_changed, pieces_in

if TYPE_CHECKING:
    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.rooms.steps import ActionPlan, Fix, PlanStep
    from stayput.verification.verdict import OptionVerdict, Verdict


def room_csv(verdict: Verdict) -> str:
    """Return the probabilities of a verdict as CSV: what happens to what, by what.

    Of a change, also what it brings: the probability with it less that of the room as it is.
    """
    names = ("event", "of", "by", "probability", "low", "high", "change", "change_low", "change_high")
    rows = ((*texts, *_ends(chance), *_ends(change)) for *texts, chance, change in _rows(verdict))
    return csv_text(names, rows)


def _ends(value: Probability | Difference | None) -> Iterable[float | None]:
    return (None,) * 3 if value is None else interval_data(value).values()


def _rows(verdict: Verdict) -> Iterator[tuple[str, str, str, Probability, Difference | None]]:
    people = people_in(verdict)
    for place in people.places:
        yield "hit", place.place.name, "", place.hit, None
        for hit in place.by:
            yield "hit", place.place.name, hit.piece, hit.probability, None
        yield "shut_in", place.place.name, "", place.shut_in, None
    for door in people.doors:
        yield "blocked", door.door.name, "", door.blocked, None
    for piece in pieces_in(verdict):
        for event, chance in piece.probabilities.items():
            yield event, piece.name, "", chance, None
    for option in verdict.others:
        assert option.people is not None
        label = verdict.label(option)
        yield "hit_with", label, "", option.people.hit.chance, option.people.hit.change
        yield "shut_in_with", label, "", option.people.shut_in.chance, option.people.shut_in.change
        if (overturned := piece_changed(option, verdict)) is not None:
            yield "overturned_with", label, "", *overturned


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
        "not_taken": {
            name: [{"types": list(kinds), "why": by_language(why)} for kinds, why in reasons.items()]
            for name, reasons in plan.not_taken.items()
        },
        "room": verdict_data(plan.verdict),
    }


def _step(step: PlanStep, plan: ActionPlan) -> dict[str, Any]:
    move, fixes = step.move, {"fix": step.fix, "without_drilling": step.instead}
    return {
        "what": step.what,
        "step": by_language(heading(step, plan)),
        "at_m": None if move is None or move.at is None else list(move.at),
        "heading_rad": None if move is None else move.heading,
        **{name: None if fix is None else _fix(fix) for name, fix in fixes.items()},
        "overturned": None if step.overturned is None else interval_data(step.overturned),
        "alone": _effect(step.alone),
        "together": _effect(step.together),
        **attributes(step, "for_people", "decided", "cost_class"),
        "grade": step.grade.value,
        "weakest": [list(item.label) for item in step.weakest],
    }


def _fix(fix: Fix) -> dict[str, Any]:
    return {
        "overturned": interval_data(fix.overturns),
        "gives_way": interval_data(fix.gives_way),
        "alone": _effect(fix.alone),
        **attributes(fix, "enough", "too_weak"),
        "enough_to_jma": None if fix.enough_to is None else number(fix.enough_to),
        "cautions": [list(caution) for caution in fix.cautions],
        "buy": [
            {
                "type": item.measure.kind,
                "count": item.count,
                "where": list(where(item, fix)),
                "rated_n": {name: number(force) for name, force in forces_asked(item)},
                "holds_n": None if item.holds is None else attributes(item.holds, *item.holds._fields),
                "enough": item.enough,
            }
            for item in fix.purchases
        ],
    }


def _effect(effect: OptionVerdict) -> dict[str, Any]:
    assert effect.people is not None
    people = people_data(effect.people)
    return {
        **{name: value for name, value in people.items() if name not in ("places", "doors")},
        "overturned": [interval_data(piece.probabilities[OVERTURNED]) for piece in effect.pieces],
        "overturned_change": [
            None if piece.change is None else interval_data(piece.change) for piece in effect.pieces
        ],
    }
