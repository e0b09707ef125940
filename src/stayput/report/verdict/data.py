"""A verdict as plain values: what JSON holds."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

import stayput
from stayput.measures import parameters
from stayput.motion.intensity import intensity_class
from stayput.report.verdict.assumptions import assumptions
from stayput.scenario.writing import scenario_toml
from stayput.verification.words import LANGUAGES, headline, reason

if TYPE_CHECKING:
    from stayput.fragility import Capacity, FragilityCurve, Probability
    from stayput.measures import Measure
    from stayput.verification import OptionVerdict, Quantiles, Verdict


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
    return {
        "stayput": stayput.__version__,
        "title": verdict.scenario.title,
        "verdict": {language: headline(verdict, language) for language in LANGUAGES},
        "best": verdict.best.option.name,
        "jma_intensity": number(verdict.intensity),
        "intensity_class": intensity_class(verdict.intensity),
        "slide_limit_m": verdict.slide_limit,
        "motions": verdict.motions,
        "samples": verdict.samples,
        "runs": verdict.runs,
        "seed": verdict.seed,
        "precise": verdict.precise,
        "seconds": number(verdict.seconds),
        "options": [_option(one, verdict) for one in verdict.options],
        "estimates": {
            "rocking_acceleration_m_s2": number(verdict.estimates.rocking_acceleration),
            "overturning_velocity_m_s": number(verdict.estimates.overturning_velocity),
            "possible": number(verdict.estimates.possible),
            "overturning_ratio": number(verdict.estimates.overturning_ratio),
        },
        "assumptions": [
            {"what": one.what("en"), "value": one.value("en"), "confidence": one.confidence}
            for one in assumptions(verdict)
        ],
        "scenario_toml": scenario_toml(verdict.scenario),
    }


def _option(one: OptionVerdict, verdict: Verdict) -> dict[str, Any]:
    change = one.change
    return {
        "rank": one.rank,
        "name": one.option.name,
        "label": {language: one.option.label(language) for language in LANGUAGES},
        "reason": {language: reason(one, verdict, language) for language in LANGUAGES},
        "measures": [_measure(measure) for measure in one.option.measures],
        "probabilities": {event: _probability(found) for event, found in one.probabilities.items()},
        "overturned_change": None
        if change is None
        else {
            "estimate": number(change.estimate),
            "low": number(change.low),
            "high": number(change.high),
            "clear": change.clear,
            "pairs": change.pairs,
        },
        "peak_slide_m": _quantiles(one.slide),
        "peak_tilt_rad": _quantiles(one.tilt),
        "devices": [
            {
                "type": device.kind,
                "name": device.name,
                "failed": _probability(device.failed),
                "failure_time_s": number(device.failure_time),
                "peak_force_n": _quantiles(device.peak),
                "utilisation": _quantiles(device.used),
            }
            for device in one.devices
        ],
        "capacities": [_capacity(found) for found in one.capacities.values()],
        "curves": [_curve(curve) for curve in one.curves.values()],
    }


def _measure(measure: Measure) -> dict[str, Any]:
    values = {about.name: getattr(measure, about.name) for about in parameters(measure)}
    return {"type": measure.kind, **values}


def _probability(found: Probability) -> dict[str, Any]:
    return {
        "estimate": number(found.estimate),
        "low": number(found.low),
        "high": number(found.high),
        "count": found.fell,
        "runs": found.runs,
        "missing": found.missing,
    }


def _quantiles(found: Quantiles) -> dict[str, float | None]:
    return {"median": number(found.median), "p90": number(found.p90)}


def _capacity(found: Capacity) -> dict[str, Any]:
    return {
        "share": found.share,
        "jma_intensity": number(found.estimate),
        "low": number(found.low),
        "high": number(found.high),
        "above": number(found.above),
        "below": number(found.below),
        "text": found.text,
    }


def _curve(curve: FragilityCurve) -> dict[str, Any]:
    """Return a curve's parameters and what was observed, in SI units."""
    return {
        "measure": curve.measure.key,
        "state": curve.state.value,
        "median": number(curve.median),
        "dispersion": number(curve.dispersion),
        "family": "normal" if curve.measure.is_logarithm else "lognormal",
        "levels": [{"im": number(level.im), **_probability(level.probability)} for level in curve.levels],
    }


def number(value: float) -> float | None:
    """Return a number, or None in place of one that is not finite."""
    return float(value) if math.isfinite(value) else None
