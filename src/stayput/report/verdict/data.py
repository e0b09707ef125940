"""Verdicts and plans to buy and do as plain values, for JSON files and the app's replies; a room's as CSV."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import stayput
from stayput.catalogue import LANGUAGES
from stayput.files import csv_text
from stayput.fragility.curve import METHOD, FragilityCurve
from stayput.measures import Measure, parameters
from stayput.measures.measure import MEANINGS
from stayput.montecarlo.counting import DEVICE_FAILED, OVERTURNED, Quantiles
from stayput.motion.intensity import intensity_class
from stayput.report.summary import attributes, by_language, number
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.tables import contents_data
from stayput.rooms.purchases import MARGIN, QUANTILE
from stayput.rooms.step_words import forces_asked, heading, where
from stayput.verification.notes import Estimates, everyday_cases, notes
from stayput.verification.options import inputs
from stayput.verification.people import CRUSHING_ENERGY, DECIDING_EVENTS
from stayput.verification.room_words import people_in, piece_changed, pieces_in

if TYPE_CHECKING:
    import xarray as xr

    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.rooms.steps import ActionPlan, Fix, PlanStep
    from stayput.scenario import Scenario
    from stayput.scenario.measures import Option
    from stayput.verification.people import People
    from stayput.verification.verdict import DeviceSummary, OptionVerdict, PieceVerdict, Verdict


def room_csv(verdict: Verdict) -> str:
    """Return the probabilities of a verdict as CSV: what happens to what, by what.

    Of a change, also what it brings, the probability with it less that of the room as it is, and its rank.
    """
    names = ("event", "of", "by", "probability", "low", "high", "change", "change_low", "change_high", "rank")
    rows = ((*texts, *_ends(chance), *_ends(change), rank) for *texts, chance, change, rank in _rows(verdict))
    return csv_text(names, rows)


def verdict_dataset(verdict: Verdict) -> xr.Dataset:
    """Return probabilities and quantiles over ``option``, ``piece`` and ``event``.

    Parameters
    ----------
    verdict : Verdict
        The verdict.

    Returns
    -------
    xarray.Dataset
        Of each probability its estimate and the ends of its 95 % interval, over ``bound``.
    """
    import xarray as xr  # which takes its time to load

    options = verdict.options
    pieces = [[piece.probabilities for piece in option.pieces] for option in options]
    events, bound = [*options[0].probabilities], ["estimate", "low", "high"]

    def each(chances: Mapping[str, Probability]) -> list[list[float]]:
        return [[getattr(chances[event], name) for name in bound] for event in events]

    over_options = [each(option.probabilities) for option in options]
    data = xr.Dataset(
        {
            "rank": ("option", [option.rank for option in options]),
            "probability": (("option", "event", "bound"), over_options),
            "piece_probability": (("option", "piece", "event", "bound"), [[*map(each, of)] for of in pieces]),
        },
        {
            "option": [option.option.name for option in options],
            "piece": list(verdict.scenario.names),
            "event": events,
            "bound": bound,
        },
        attributes(verdict, "motions", "runs", "seed", "intensity"),
    )
    for name, unit in (("slide", "m"), ("tilt", "rad")):
        for part in ("median", "p90"):
            values = [[getattr(getattr(piece, name), part) for piece in option.pieces] for option in options]
            about = {"units": unit, "long_name": f"{part} of the largest {name}; inf where it overturns"}
            data[f"{name}_{part}"] = (("option", "piece"), values, about)
    for name in DECIDING_EVENTS if options[0].people is not None else ():
        chances = [getattr(option.people, name).chance for option in options]
        values = [[getattr(chance, part) for part in bound] for chance in chances]
        data[name] = (("option", "bound"), values)
    return data


def _ends(value: Probability | Difference | None) -> Iterable[float | None]:
    return (None,) * 3 if value is None else attributes(value, *_ENDS).values()


def _rows(verdict: Verdict) -> Iterator[tuple[str, str, str, Probability, Difference | None, int | None]]:
    people = people_in(verdict)
    for place in people.places:
        for event in ("hit", "crushed", "touched"):
            yield event, place.place.name, "", getattr(place, event), None, None
        for hit in place.by:
            event = "hit" if hit.by_falling else "touched"
            yield event, place.place.name, hit.piece, hit.probability, None, None
        yield "shut_in", place.place.name, "", place.shut_in, None, None
    for door in people.doors:
        yield "blocked", door.door.name, "", door.blocked, None, None
    for piece in pieces_in(verdict):
        for event, chance in piece.probabilities.items():
            yield event, piece.name, "", chance, None, None
    for option in verdict.others:
        assert option.people is not None
        label = verdict.label(option)
        for event in ("hit", "shut_in") if people.places else ():
            yield f"{event}_with", label, "", *getattr(option.people, event), option.rank
        if (overturned := piece_changed(option, verdict)) is not None:
            yield "overturned_with", label, "", *overturned, option.rank
        if (failed := option.probabilities[DEVICE_FAILED]).estimate:
            yield "device_failed_with", label, "", failed, None, option.rank


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
        "not_enough": {name: _fix(fix) for name, fix in plan.not_enough.items()},
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
        "overturned": interval_data(step.overturned),
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
        "overturned_change": [interval_data(piece.change) for piece in effect.pieces],
    }


_ENDS = ("estimate", "low", "high")


def json_text(data: dict[str, Any]) -> str:
    """Return plain values as the text of a JSON file."""
    return json.dumps(data, allow_nan=False, ensure_ascii=False, indent=2) + "\n"


def in_both(text: Callable[[str], str]) -> dict[str, str]:
    """Return a text by its languages."""
    return {language: text(language) for language in LANGUAGES}


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """Return a verdict as plain values, in SI units that the keys name.

    What is not finite is None: a quantile of a peak where so many overturn that it has none, an interval's
    end beyond what was run, a capacity that no number can be given for.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    """
    return {
        "stayput": stayput.__version__,
        "title": verdict.scenario.title,
        "verdict": in_both(verdict.sentence),
        "notes": [by_language(note) for note in notes(verdict)],
        "best": verdict.best.option.name,
        "jma_intensity": number(verdict.intensity),
        "intensity_class": None if verdict.floor else intensity_class(verdict.intensity),
        "motion_floor": verdict.floor or None,
        "strength": strength_data(verdict.scenario, verdict.motions),
        "slide_limit_m": verdict.slide_limit,
        **attributes(verdict, "motions", "runs"),
        **attributes(verdict, "seed", "precise", "seconds", "complete"),
        "engine": "plane" if verdict.scenario.dimensions == 2 else "space",
        "components": list(verdict.scenario.components),
        "direction_rad": verdict.scenario.direction,  # None: drawn, or along the depth
        "grades": {grade.value: by_language(meaning) for grade, meaning in MEANINGS.items()},
        "options": [_option(result, verdict) for result in verdict.options],
        "not_possible": [
            {
                "name": item.option.name,
                "label": by_language(item.option.label(verdict.scenario.names)),
                "reason": in_both(item.why),
                **_in_place(item.option, verdict.scenario),
            }
            for item in verdict.impossible
        ],
        "estimates": None if verdict.estimates is None else _estimates(verdict.estimates),
        "everyday": everyday_data(verdict.scenario) if verdict.scenario.alone else None,
        "assumptions": [
            {"what": what, "value": value, "confidence": confidence}
            for what, value, confidence in told(assumptions(verdict), "en")
        ],
        "scenario_toml": verdict.scenario.to_toml(),
    }


def _estimates(estimates: Estimates) -> dict[str, Any]:
    test = estimates.shake_table
    return {
        "rocking_acceleration_m_s2": number(estimates.rocking_acceleration),
        "overturning_velocity_m_s": number(estimates.overturning_velocity),
        **attributes(estimates, "possible", "overturning_ratio"),
        "equipment_loads": [
            {
                "equipment_class": load.grade,
                "position": load.position,
                "k_h": number(load.coefficient),
                "overturns": load.overturns,
                "tie_force_n": number(load.force),
            }
            for load in estimates.equipment
        ],
        "ac156_height_ratio": None if test is None else number(test.height_ratio),
        "ac156_rocking_s_ds_g": None if test is None else number(test.sds),
        "asce43_sliding_share": number(estimates.sliding.share),
        "asce43_sliding_median_m": number(estimates.sliding.distance),
    }


def strength_data(scenario: Scenario, motions: int) -> dict[str, Any] | None:
    """Return how strongly the ground was said to shake; None where the motions keep their own strength."""
    strength = scenario.shaking.strength
    if strength is None:
        return None
    return {
        "stated": scenario.shaking.stated,
        "measure": f"SA({strength.period:g})" if strength.period else strength.measure,
        "median": number(strength.median),
        "scatter_of_log10": number(strength.scatter),
        "about": by_language(strength.told(motions)),
    }


def everyday_data(scenario: Scenario) -> list[dict[str, Any]]:
    """Return the cases of tip-over without an earthquake as plain values, the smallest margin first."""
    return [
        {
            "case": case.name,
            "label": by_language(said),
            "restoring_moment_n_m": number(case.restoring),
            "overturning_moment_n_m": number(case.overturning),
            "margin": number(case.margin),
            "tips_over": case.tips,
        }
        for case, said in everyday_cases(scenario)
    ]


def _option(result: OptionVerdict, verdict: Verdict) -> dict[str, Any]:
    change, installed, scenario = result.change, result.installed, verdict.scenario
    return {
        "rank": result.rank,
        "name": result.option.name,
        "label": by_language(result.option.label(scenario.names))
        if scenario.plan is None
        else in_both(partial(verdict.label, result)),
        "reason": in_both(partial(verdict.reason, result)),
        "grade": verdict.grade(result).value,
        "inputs": [
            {**by_language(item.label), "grade": item.grade.value, "tag": item.tag}
            for item in inputs(result.option, scenario)
        ],
        **_in_place(result.option, scenario),
        "probabilities": {event: _probability(value) for event, value in result.probabilities.items()},
        "as_installed": None
        if installed is None
        else {
            "badly_share": installed.share,
            "badly": {event: _probability(value) for event, value in installed.badly.items()},
            "usual": {event: number(value) for event, value in installed.usual.items()},
            "how": [by_language(how) for how in installed.how],
        },
        "overturned_change": None if change is None else attributes(change, *_ENDS, "clear", "pairs"),
        "peak_slide_m": quantiles_data(result.slide),
        "peak_tilt_rad": quantiles_data(result.tilt),
        "pieces": [_piece(piece, body in scenario.counted) for body, piece in enumerate(result.pieces)],
        "people": None if result.people is None else people_data(result.people),
        "meetings": [
            {"pieces": [first, second], **_probability(chance)} for first, second, chance in result.meetings
        ],
        "helps": result.helps,
        "better": list(result.better),
        "worse": list(result.worse),
        "runs": result.runs,
        "typical": {"motion": result.typical.motion, "sample": result.typical.sample},
        "devices": [_device(device) for device in result.devices],
        "contents": None if result.contents is None else contents_data(result.contents),
        "capacities": [
            {
                "share": capacity.share,
                "jma_intensity": number(capacity.estimate),
                **attributes(capacity, "low", "high", "text"),
            }
            for capacity in result.capacities.values()
        ],
        "curves": [_curve(curve) for curve in result.curves.values()],
    }


def _in_place(option: Option, scenario: Scenario) -> dict[str, Any]:
    """Return what an option puts in place: its measures by piece, and whether the joints are."""
    held = zip(scenario.names, option.on, strict=True)
    return {
        "joined": option.joined,
        "moved": [
            {"what": move.what, "at_m": [*move.at], "heading_rad": move.heading} for move in option.moved
        ],
        "measures": {name: [_measure(measure) for measure in measures] for name, measures in held},
    }


def _piece(piece: PieceVerdict, counts: bool) -> dict[str, Any]:
    return {
        "name": piece.name,
        "counts": counts,
        "probabilities": {event: _probability(chance) for event, chance in piece.probabilities.items()},
        "overturned_change": interval_data(piece.change),
        **attributes(piece, "falls"),
        "harm_J": number(piece.harm),
        "peak_slide_m": quantiles_data(piece.slide),
        "peak_tilt_rad": quantiles_data(piece.tilt),
        "stability": piece.stability,
    }


def people_data(people: People) -> dict[str, Any]:
    """Return what happens to the people of a room as plain values."""
    names = "crushed", "hit", "touched", "shut_in", "blocked"
    estimates = {name: getattr(people, name) for name in names}
    return {
        "crushed_from_J": CRUSHING_ENERGY,
        **{name: interval_data(estimate.chance) for name, estimate in estimates.items()},
        **{f"{name}_change": interval_data(estimate.change) for name, estimate in estimates.items()},
        "risk": number(people.risk),
        "harm_J": number(people.harm),
        "places": [
            {
                "name": place.place.name,
                **{name: interval_data(getattr(place, name)) for name in names[:3]},
                "hit_by_day": number(place.by_day.estimate),
                "hit_at_night": number(place.by_night.estimate),
                "shut_in": interval_data(place.shut_in),
                "shut_in_at_rest": place.shut_in_at_rest,
                "by": [
                    {
                        "piece": hit.piece,
                        "mass_kg": number(hit.mass),
                        "probability": interval_data(hit.probability),
                        "by_falling": hit.by_falling,
                        "speed_m_s": quantiles_data(hit.speed),
                        "energy_J": quantiles_data(hit.energy),
                    }
                    for hit in place.by
                ],
            }
            for place in people.places
        ],
        "doors": [
            {"name": door.door.name, "blocked": interval_data(door.blocked), "blocked_at_rest": door.at_rest}
            for door in people.doors
        ],
    }


def _device(device: DeviceSummary) -> dict[str, Any]:
    return {
        "type": device.kind,
        "name": device.name,
        "holds": list(device.pieces),
        "failed": _probability(device.failed),
        "failure_time_s": number(device.failure_time),
        "peak_force_n": quantiles_data(device.peak),
        "utilisation": quantiles_data(device.used),
        "demand": None if device.demand is None else quantiles_data(device.demand),
        "weakest": None if device.weakest is None else by_language(device.weakest),
    }


def _measure(measure: Measure) -> dict[str, Any]:
    values = {parameter.name: getattr(measure, parameter.name) for parameter in parameters(measure)}
    return {"type": measure.kind, **values}


def interval_data(chance: Probability | Difference | None) -> dict[str, Any] | None:
    """Return a probability or a difference of two, with its interval; None of none."""
    return None if chance is None else attributes(chance, *_ENDS)


def _probability(chance: Probability) -> dict[str, Any]:
    counts = {"count": chance.fell, "runs": chance.runs, "missing": chance.missing}
    return {**attributes(chance, *_ENDS), **counts, "text": chance.text}


def quantiles_data(quantiles: Quantiles) -> dict[str, float | None]:
    """Return quantiles as plain values."""
    return attributes(quantiles, "median", "p90")


def _curve(curve: FragilityCurve) -> dict[str, Any]:
    """Return a curve and the observed shares at its levels, in SI units."""
    im = [level.im for level in curve.levels]
    share, (low, high) = curve.probability(im), curve.band(im)
    return {
        "measure": curve.measure.key,
        "method": METHOD,
        "one_motion": curve.one_motion,
        "levels": [
            {
                "im": number(level.im),
                **_probability(level.probability),
                "curve": {"share": number(p), "low": number(a), "high": number(b)},
            }
            for level, p, a, b in zip(curve.levels, share, low, high, strict=True)
        ],
        "lognormal": None if curve.lognormal is None else curve.lognormal._asdict(),
    }
