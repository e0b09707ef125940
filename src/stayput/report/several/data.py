"""A verdict on several pieces as plain values: JSON and CSV."""

from __future__ import annotations

import csv
import io
import json
from typing import TYPE_CHECKING, Any

import stayput
from stayput.catalogue import LANGUAGES
from stayput.montecarlo.counting import OVERTURNED
from stayput.motion.intensity import intensity_class
from stayput.report.several.tables import several_assumptions
from stayput.report.summary import number
from stayput.report.verdict.data import strength_data
from stayput.spreadsheets import text_cell
from stayput.verification.words import headline_of_several, reason_of_several, title_of_several

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from stayput.fragility import Probability
    from stayput.montecarlo.counting import Quantiles
    from stayput.verification import AssemblyOptionVerdict, AssemblyVerdict
    from stayput.verification.verdict import DeviceOfSeveral


def several_json(verdict: AssemblyVerdict) -> str:
    """Return a verdict as the text of a JSON file; see `several_data`."""
    return json.dumps(several_data(verdict), allow_nan=False, ensure_ascii=False, indent=2) + "\n"


def several_data(verdict: AssemblyVerdict) -> dict[str, Any]:
    """Return a verdict as plain values, in SI units that the keys name; what is not finite is None."""
    return {
        "stayput": stayput.__version__,
        "title": verdict.scenario.title,
        "verdict": in_both(lambda language: headline_of_several(verdict, language)),
        "best": verdict.best.option.name,
        "jma_intensity": number(verdict.intensity),
        "intensity_class": None if verdict.floor else intensity_class(verdict.intensity),
        "motion_floor": verdict.floor or None,
        "strength": strength_data(verdict.scenario, verdict.motions),
        "slide_limit_m": verdict.slide_limit,
        "motions": verdict.motions,
        "samples": verdict.samples,
        "runs": verdict.runs,
        "seed": verdict.seed,
        "precise": verdict.precise,
        "seconds": number(verdict.seconds),
        "options": [_option(result, verdict) for result in verdict.options],
        "not_possible": [
            {
                "name": one.option.name,
                "label": in_both(lambda language, one=one: title_of_several(one, verdict, language)),
                "reason": in_both(one.why),
            }
            for one in verdict.rejected
        ],
        "assumptions": [
            {"what": entry.what("en"), "value": entry.value("en"), "confidence": entry.confidence}
            for entry in several_assumptions(verdict)
        ],
        "scenario_toml": verdict.scenario.to_toml(),
    }


def in_both(text: Callable[[str], str]) -> dict[str, str]:
    """Return a text by its languages."""
    return {language: text(language) for language in LANGUAGES}


def _option(result: AssemblyOptionVerdict, verdict: AssemblyVerdict) -> dict[str, Any]:
    names = verdict.scenario.names
    return {
        "name": result.option.name,
        "rank": result.rank,
        "label": in_both(lambda language: title_of_several(result, verdict, language)),
        "reason": in_both(lambda language: reason_of_several(result, verdict, language)),
        "joined": result.option.joined,
        "measures": {
            name: [measure.kind for measure in measures]
            for name, measures in zip(names, result.option.measures, strict=True)
        },
        "probabilities": _chances(result.probabilities),
        "change": None if result.change is None else number(result.change.estimate),
        **_peaks(result.slide, result.tilt),
        "pieces": [
            {
                "name": piece.name,
                "counts": body in verdict.scenario.counted,
                "probabilities": _chances(piece.probabilities),
                **_peaks(piece.slide, piece.tilt),
            }
            for body, piece in enumerate(result.pieces)
        ],
        "devices": [_device(device) for device in result.devices],
    }


def _chances(chances: Mapping[str, Probability]) -> dict[str, dict[str, Any]]:
    return {
        event: {
            "estimate": number(chance.estimate),
            "low": number(chance.low),
            "high": number(chance.high),
            "count": chance.fell,
            "runs": chance.runs,
            "missing": chance.missing,
        }
        for event, chance in chances.items()
    }


def _peaks(slide: Quantiles, tilt: Quantiles) -> dict[str, float | None]:
    return {
        "peak_slide_m_median": number(slide.median),
        "peak_slide_m_p90": number(slide.p90),
        "peak_tilt_rad_median": number(tilt.median),
        "peak_tilt_rad_p90": number(tilt.p90),
    }


def _device(device: DeviceOfSeveral) -> dict[str, Any]:
    summary = device.summary
    return {
        "holds": list(device.pieces),
        "kind": summary.kind,
        "name": summary.name,
        "failed": number(summary.failed.estimate),
        "failure_time_s_median": number(summary.failure_time),
        "peak_force_n_median": number(summary.peak.median),
        "peak_force_n_p90": number(summary.peak.p90),
        "utilisation_median": number(summary.used.median),
        "utilisation_p90": number(summary.used.p90),
        "weakest": None if summary.weakest is None else dict(zip(LANGUAGES, summary.weakest, strict=True)),
    }


def several_csv(verdict: AssemblyVerdict) -> str:
    """Return the ranking as the text of a CSV file: one row an option, empty where there is no number."""
    records = [_record(result, verdict) for result in verdict.options]
    records += [
        {
            **dict.fromkeys(records[0]),
            "option": one.option.name,
            "consists_of": title_of_several(one, verdict, "en"),
            "not_possible": one.why("en"),
        }
        for one in verdict.rejected
    ]
    lines = io.StringIO()
    writer = csv.DictWriter(lines, list(records[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(
        {text_cell(name): text_cell(cell) if isinstance(cell, str) else cell for name, cell in record.items()}
        for record in records
    )
    return lines.getvalue()


def _record(result: AssemblyOptionVerdict, verdict: AssemblyVerdict) -> dict[str, object]:
    record: dict[str, object] = {
        "rank": result.rank,
        "option": result.option.name,
        "consists_of": title_of_several(result, verdict, "en"),
    }
    for event, chance in result.probabilities.items():
        ends = (("", chance.estimate), ("_low", chance.low), ("_high", chance.high))
        record |= {f"{event}{end}": number(value) for end, value in ends}
    shares = result.probabilities[OVERTURNED]
    record |= {"runs": shares.runs, "missing": shares.missing}
    for piece in result.pieces:
        record[f"overturned: {piece.name}"] = number(piece.probabilities[OVERTURNED].estimate)
    return {**record, **_peaks(result.slide, result.tilt), "not_possible": None}
