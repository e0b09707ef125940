"""A verdict on a room, and a plan to buy and do, as plain values: JSON and CSV."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import stayput
from stayput.report.summary import attributes, by_language, number
from stayput.report.verdict.data import head_data, in_both, interval_data, quantiles_data, shaking_data
from stayput.rooms.events import CELL
from stayput.rooms.step_words import forces_asked, heading, where
from stayput.rooms.steps import MARGIN, QUANTILE
from stayput.rooms.words import best_sentence, change_label, change_sentence, tags
from stayput.spreadsheets import csv_text

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.rooms.steps import ActionPlan, Fix, PlanStep
    from stayput.rooms.verdict import ChangeVerdict, RoomEffect, RoomVerdict


def room_data(verdict: RoomVerdict) -> dict[str, Any]:
    """Return a verdict as plain values, in SI units that the keys name; what is not finite is None."""
    return {
        **head_data(verdict),
        "best": in_both(partial(best_sentence, verdict)),
        **shaking_data(verdict),
        **attributes(verdict, "motions", "samples", "runs", "seed", "seconds"),
        "hit": interval_data(verdict.hit),
        "shut_in": interval_data(verdict.shut_in),
        "risk": number(verdict.risk),
        "places": [
            {
                "name": place.place.name,
                "hit": interval_data(place.hit),
                "hit_by_day": number(place.by_day),
                "hit_at_night": number(place.by_night),
                "shut_in": interval_data(place.shut_in),
                "by": [
                    {
                        "piece": hit.piece,
                        "mass_kg": number(hit.mass),
                        "probability": interval_data(hit.probability),
                        "speed_m_s": quantiles_data(hit.speed),
                        "energy_J": quantiles_data(hit.energy),
                    }
                    for hit in place.by
                ],
            }
            for place in verdict.places
        ],
        "doors": [
            {"name": door.door.name, "blocked": interval_data(door.blocked), "blocked_at_rest": door.at_rest}
            for door in verdict.doors
        ],
        "pieces": [
            {
                "name": piece.name,
                "engine": "plane" if piece.in_plane else "space",
                "probabilities": {event: interval_data(p) for event, p in piece.probabilities.items()},
                "peak_slide_m": quantiles_data(piece.slide),
                "falls": piece.falls,
                "risk": number(piece.risk),
                "outline_m": piece.outline.tolist(),
            }
            for piece in verdict.pieces
        ],
        "cell_m": CELL,
        "collisions": [
            {"pieces": list(pair), "probability": interval_data(chance)}
            for pair, chance in verdict.collisions.items()
        ],
        "changes": [_change(change, verdict) for change in verdict.changes],
    }


def _change(result: ChangeVerdict, verdict: RoomVerdict) -> dict[str, Any]:
    change, overturned = result.change, verdict.piece_changed(result)
    ends = ("hit", "hit_change", "shut_in", "shut_in_change")
    return {
        "what": change.what,
        "label": in_both(partial(change_label, change, verdict)),
        "sentence": in_both(partial(change_sentence, result, verdict)),
        "measure": None if change.measure is None else change.measure.kind,
        "drilled": change.measure is not None and change.measure.drilled,
        "at_m": None if change.at is None else list(change.at),
        "heading_rad": change.heading,
        **{name: interval_data(getattr(result, name)) for name in ends},
        "overturned": None if overturned is None else interval_data(overturned[0]),
        "overturned_change": None if overturned is None else interval_data(overturned[1]),
        "risk": number(result.risk),
        "helps": result.helps,
        "better": list(result.better),
        "worse": list(result.worse),
        "tags": [by_language(tag) for tag in tags(result)],
    }


def room_csv(verdict: RoomVerdict) -> str:
    """Return the probabilities of a verdict as CSV: what happens to what, by what.

    Of a change, also what it brings: the probability with it less that of the room as it is.
    """
    names = ("event", "of", "by", "probability", "low", "high", "change", "change_low", "change_high")
    rows = ((*texts, *_ends(chance), *_ends(change)) for *texts, chance, change in _rows(verdict))
    return csv_text(names, rows)


def _ends(value: Probability | Difference | None) -> Iterable[float | None]:
    return (None,) * 3 if value is None else interval_data(value).values()


def _rows(verdict: RoomVerdict) -> Iterator[tuple[str, str, str, Probability, Difference | None]]:
    for place in verdict.places:
        yield "hit", place.place.name, "", place.hit, None
        for hit in place.by:
            yield "hit", place.place.name, hit.piece, hit.probability, None
        yield "shut_in", place.place.name, "", place.shut_in, None
    for door in verdict.doors:
        yield "blocked", door.door.name, "", door.blocked, None
    for piece in verdict.pieces:
        for event, chance in piece.probabilities.items():
            yield event, piece.name, "", chance, None
    for (first, second), chance in verdict.collisions.items():
        yield "meet", first, second, chance, None
    for result in verdict.changes:
        label = change_label(result.change, verdict, "en")
        yield "hit_with", label, "", result.hit, result.hit_change
        yield "shut_in_with", label, "", result.shut_in, result.shut_in_change
        if (overturned := verdict.piece_changed(result)) is not None:
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
        "room": room_data(plan.verdict),
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


def _effect(effect: RoomEffect) -> dict[str, Any]:
    ends = ("hit", "hit_change", "shut_in", "shut_in_change", "blocked", "blocked_change")
    return {
        **{name: interval_data(getattr(effect, name)) for name in ends},
        "risk": number(effect.risk),
        "overturned": [interval_data(chance) for chance in effect.overturned],
        "overturned_change": [interval_data(difference) for difference in effect.overturned_change],
    }
