"""A verdict as plain values, for the JSON file and the app's replies."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import stayput
from stayput.catalogue import LANGUAGES
from stayput.fragility.curve import METHOD
from stayput.measures import parameters
from stayput.measures.measure import MEANINGS
from stayput.motion.intensity import intensity_class
from stayput.report.summary import number
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.tables import contents_data
from stayput.verification.grades import inputs
from stayput.verification.notes import everyday_cases, notes
from stayput.verification.words import headline, reason

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.fragility import Capacity, FragilityCurve, Probability
    from stayput.measures import Measure
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.verification import AsInstalled, OptionVerdict, Quantiles, Verdict


def verdict_json(verdict: Verdict) -> str:
    """Return a verdict as the text of a JSON file; see `verdict_data`."""
    return json.dumps(verdict_data(verdict), allow_nan=False, ensure_ascii=False, indent=2) + "\n"


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """Return a verdict as plain values, in SI units that the keys name.

    What is not finite is None: a quantile of a peak where so many overturn that it has none, an interval's
    end beyond what was run, a capacity that no number can be given for.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    """
    test = verdict.estimates.shake_table
    return {
        "stayput": stayput.__version__,
        "title": verdict.scenario.title,
        "verdict": _texts((headline(verdict, "en"), headline(verdict, "ja"))),
        "notes": [_texts(note) for note in notes(verdict)],
        "best": verdict.best.option.name,
        "jma_intensity": number(verdict.intensity),
        "intensity_class": None if verdict.floor else intensity_class(verdict.intensity),
        "motion_floor": verdict.floor or None,
        "strength": strength_data(verdict.scenario, verdict.motions),
        "slide_limit_m": verdict.slide_limit,
        "motions": verdict.motions,
        "samples": verdict.samples,
        "runs": verdict.runs,
        "settled_runs": verdict.settled,
        "seed": verdict.seed,
        "precise": verdict.precise,
        "seconds": number(verdict.seconds),
        "grades": {grade.value: _texts(meaning) for grade, meaning in MEANINGS.items()},
        "options": [_option(result, verdict) for result in verdict.options],
        "not_possible": [
            {
                "name": impossible.option.name,
                "label": _texts((impossible.option.label("en"), impossible.option.label("ja"))),
                "measures": [_measure(measure) for measure in impossible.option.measures],
                "reason": _texts((impossible.why("en"), impossible.why("ja"))),
            }
            for impossible in verdict.impossible
        ],
        "estimates": {
            "rocking_acceleration_m_s2": number(verdict.estimates.rocking_acceleration),
            "overturning_velocity_m_s": number(verdict.estimates.overturning_velocity),
            "possible": number(verdict.estimates.possible),
            "overturning_ratio": number(verdict.estimates.overturning_ratio),
            "equipment_loads": [
                {
                    "equipment_class": load.grade,
                    "position": load.position,
                    "k_h": number(load.coefficient),
                    "overturns": load.overturns,
                    "tie_force_n": number(load.force),
                }
                for load in verdict.estimates.equipment
            ],
            "ac156_height_ratio": None if test is None else number(test.height_ratio),
            "ac156_rocking_s_ds_g": None if test is None else number(test.sds),
            "asce43_sliding_share": number(verdict.estimates.sliding.share),
            "asce43_sliding_median_m": number(verdict.estimates.sliding.distance),
        },
        "everyday": everyday_data(verdict.scenario),
        "assumptions": [
            {"what": entry.what("en"), "value": entry.value("en"), "confidence": entry.confidence}
            for entry in assumptions(verdict)
        ],
        "scenario_toml": verdict.scenario.to_toml(),
    }


def strength_data(scenario: Scenario | AssemblyScenario, motions: int) -> dict[str, Any] | None:
    """Return how strongly the ground was said to shake; None where the motions keep their own strength."""
    strength = scenario.shaking.strength
    if strength is None:
        return None
    return {
        "stated": scenario.shaking.stated,
        "measure": f"SA({strength.period:g})" if strength.period else strength.measure,
        "median": number(strength.median),
        "scatter_of_log10": number(strength.scatter),
        "about": _texts(strength.told(motions)),
    }


def everyday_data(scenario: Scenario) -> list[dict[str, Any]]:
    """Return the cases of tip-over without an earthquake as plain values, the smallest margin first."""
    return [
        {
            "case": case.name,
            "label": _texts(said),
            "restoring_moment_n_m": number(case.restoring),
            "overturning_moment_n_m": number(case.overturning),
            "margin": number(case.margin),
            "tips_over": case.tips,
        }
        for case, said in everyday_cases(scenario)
    ]


def _option(result: OptionVerdict, verdict: Verdict) -> dict[str, Any]:
    change = result.change
    return {
        "rank": result.rank,
        "name": result.option.name,
        "label": _texts((result.option.label("en"), result.option.label("ja"))),
        "reason": _texts((reason(result, verdict, "en"), reason(result, verdict, "ja"))),
        "grade": verdict.grade(result).value,
        "inputs": [
            {**_texts(item.label), "grade": item.grade.value, "tag": item.tag}
            for item in inputs(result.option, verdict.scenario)
        ],
        "measures": [_measure(measure) for measure in result.option.measures],
        "probabilities": {event: _probability(value) for event, value in result.probabilities.items()},
        "as_installed": None if result.installed is None else _as_installed(result.installed),
        "overturned_change": None
        if change is None
        else {
            "estimate": number(change.estimate),
            "low": number(change.low),
            "high": number(change.high),
            "clear": change.clear,
            "pairs": change.pairs,
        },
        "peak_slide_m": quantiles_data(result.slide),
        "peak_tilt_rad": quantiles_data(result.tilt),
        "devices": [
            {
                "type": device.kind,
                "name": device.name,
                "failed": _probability(device.failed),
                "failure_time_s": number(device.failure_time),
                "peak_force_n": quantiles_data(device.peak),
                "utilisation": quantiles_data(device.used),
                "weakest": None if device.weakest is None else _texts(device.weakest),
            }
            for device in result.devices
        ],
        "contents": None if result.contents is None else contents_data(result.contents),
        "capacities": [_capacity(value) for value in result.capacities.values()],
        "curves": [_curve(curve) for curve in result.curves.values()],
    }


def _as_installed(installed: AsInstalled) -> dict[str, Any]:
    return {
        "badly_share": installed.share,
        "badly": {event: _probability(value) for event, value in installed.badly.items()},
        "usual": {event: number(value) for event, value in installed.usual.items()},
        "how": [_texts(how) for how in installed.how],
    }


def _texts(text: Phrase) -> dict[str, str]:
    """Return a text by its languages."""
    return dict(zip(LANGUAGES, text, strict=True))


def _measure(measure: Measure) -> dict[str, Any]:
    values = {parameter.name: getattr(measure, parameter.name) for parameter in parameters(measure)}
    return {"type": measure.kind, **values}


def _probability(probability: Probability) -> dict[str, Any]:
    return {
        "estimate": number(probability.estimate),
        "low": number(probability.low),
        "high": number(probability.high),
        "count": probability.fell,
        "runs": probability.runs,
        "missing": probability.missing,
        "text": probability.text,
    }


def quantiles_data(quantiles: Quantiles) -> dict[str, float | None]:
    """Return quantiles as plain values."""
    return {"median": number(quantiles.median), "p90": number(quantiles.p90)}


def _capacity(capacity: Capacity) -> dict[str, Any]:
    return {
        "share": capacity.share,
        "jma_intensity": number(capacity.estimate),
        "low": number(capacity.low),
        "high": number(capacity.high),
        "above": number(capacity.above),
        "below": number(capacity.below),
        "one_motion": capacity.one_motion,
        "text": capacity.text,
    }


def _curve(curve: FragilityCurve) -> dict[str, Any]:
    """Return a curve and the observed shares at its levels, in SI units."""
    share = curve.probability([level.im for level in curve.levels])
    low, high = curve.band([level.im for level in curve.levels])
    lognormal = curve.lognormal
    return {
        "measure": curve.measure.key,
        "state": curve.state.value,
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
        "lognormal": None
        if lognormal is None
        else {
            "family": lognormal.family,
            "median": number(lognormal.median),
            "dispersion": number(lognormal.dispersion),
            "fits": lognormal.fits,
            "p_value": number(lognormal.p_value),
            "misfit": number(lognormal.misfit),
        },
    }
