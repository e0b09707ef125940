"""A verdict as a self-contained HTML page."""

from __future__ import annotations

import shlex
from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup, escape

from stayput.catalogue import say
from stayput.measures import parameters
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.embedding import script_json, script_module
from stayput.report.names import motion_label
from stayput.report.page import file_of, framed, rendered, write_page
from stayput.report.palette import mode_looks
from stayput.report.scene import DRIFT_CORNER
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.curves import curves_svg, legend, looks
from stayput.report.verdict.drawing import drawing_svg
from stayput.report.verdict.histories import histories_svg
from stayput.report.verdict.in_space import space_pairs
from stayput.report.verdict.pairs import pairs_of, scene_data
from stayput.report.verdict.tables import (
    DEVICE_COLUMNS,
    SHARES,
    device_rows,
    estimate_rows,
    grades_text,
    impossible_rows,
    ranking,
    simulations,
    weakest_inputs,
)
from stayput.report.verdict.words import word
from stayput.verification.words import class_label, headline, title

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.measures import Measure
    from stayput.report.scene import Scene
    from stayput.report.verdict.pairs import RunPair
    from stayput.verification import OptionVerdict, Verdict


def write_report(verdict: Verdict, path: str | Path, language: str = "en") -> Path:
    """Write a report of a verdict: one HTML file with drawings, curves, animations and all inputs.

    It loads nothing from elsewhere, and can be printed. Four of the runs are done again for it.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    path : str or Path
        The file, whose name ends in .html.
    language : str
        "en" or "ja".

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        Another language, a path that cannot be written, or a record that cannot be read any more.
    """
    return write_page(path, language, lambda: report_html(verdict, language))


def report_html(verdict: Verdict, language: str = "en") -> str:
    """Return the text of a report; see `write_report`.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    return rendered("verdict/report.html", _content(verdict, language))


def _content(verdict: Verdict, language: str) -> dict[str, Any]:
    scenario = verdict.scenario
    ground = scenario.ground()
    in_space = scenario.dimensions == 3
    pairs = () if in_space else pairs_of(verdict, ground)
    scenes = [pair.scene for pair in pairs]
    modes = mode_looks(language)

    text = partial(word, language=language)
    return {
        **framed(language, "report", scenario.title or text("report"), ["verdict/report.css"]),
        "text": text,
        "numbers": numbers,
        "verdict": verdict,
        "headline": headline(verdict, language),
        "strength": text(
            "instrumental",
            **{
                "class": class_label(verdict.intensity, language, verdict.floor),
                "value": f"{verdict.intensity:.2f}",
            },
        ),
        "simulations": simulations(verdict, language),
        "device_columns": [text(key) for key in DEVICE_COLUMNS],
        "limit": numbers.length(verdict.slide_limit, language),
        "shares": [f"{100.0 * share:g}" for share in SHARES],
        "notes": verdict.notes(language),
        "grades": grades_text(language),
        "rows": ranking(verdict, language),
        "impossible": impossible_rows(verdict, language),
        "looks": looks(verdict),
        "before": _drawn(verdict, verdict.without, language),
        "after": _drawn(verdict, verdict.best, language) if verdict.best.option.measures else None,
        "curves": Markup(curves_svg(verdict, language)) if verdict.best.curves else None,
        "legend": legend(verdict, language),
        "pairs": [
            _pair(verdict, pair, scene, len(ground), language)
            for pair, scene in zip(pairs, scenes, strict=True)
        ],
        "space_pairs": space_pairs(verdict, ground, language) if in_space else [],
        "modes": modes.values(),
        "scenes": Markup(
            script_json(
                {
                    "modes": modes,
                    "pairs": [
                        scene_data(pair, scene, scenario.furniture)
                        for pair, scene in zip(pairs, scenes, strict=True)
                    ],
                }
            )
        ),
        "details": [
            _detail(result, verdict, language) for result in verdict.options if result.option.measures
        ],
        "estimates": estimate_rows(verdict, language),
        "assumptions": [(a.what(language), a.value(language), a.confidence) for a in assumptions(verdict)],
        "toml": escape(scenario.to_toml()),
        "reads_files": scenario.shaking.record is not None or isinstance(scenario.shaking.suite, str),
        "command": escape(command(verdict, language)),
        "script": Markup(script_module(file_of("verdict/report.js"))),
    }


def command(verdict: Verdict, language: str, file: str = "scenario.toml") -> str:
    """Return the command that makes the report again."""
    words = ["stayput", "verify", file, "--slide-limit", f"{verdict.slide_limit:g}", "--lang", language]
    return shlex.join([*words, "--report", "report.html"])


def _drawn(verdict: Verdict, result: OptionVerdict, language: str) -> dict[str, Any]:
    label = title(result.option, verdict, language)
    return {
        "label": label,
        "drawing": Markup(drawing_svg(verdict, result.option.measures, language, label)),
        "share": numbers.probability(result.probabilities[OVERTURNED], language),
        "interval": numbers.interval(result.probabilities[OVERTURNED], language),
        "grade": verdict.grade(result).value,
        "weakest": weakest_inputs(result, verdict, language),
    }


def _place_of_the_measure(verdict: Verdict, pair: RunPair, language: str) -> str:
    """Return whether the measure's run in a typical case is one of those that overturn, and how many do.

    The case is typical of the piece without a measure: the measure may fail in it and hold in most others.
    """
    chance = verdict.best.probabilities[OVERTURNED]
    if pair.kind != "typical" or len(pair.sides) == 1 or chance.runs == 0:
        return ""
    held = "typical_never_falls" if chance.estimate == 0.0 else "typical_is_held"
    key = "typical_also_falls" if pair.sides[1].run.overturned else held
    told = word(key, language, share=numbers.share(chance.estimate, language))
    return f" {told}" if language == "en" else told


def _pair(verdict: Verdict, pair: RunPair, scene: Scene, count: int, language: str) -> dict[str, Any]:
    sides = [
        {"label": title(side.option, verdict, language), "outcome": side.outcome(language)}
        for side in pair.sides
    ]
    outcomes = [f"{side['label']}{word('colon', language)}{side['outcome']}" for side in sides]
    about_key = f"{pair.kind}_text" if len(pair.sides) > 1 else f"{pair.kind}_bare_text"
    return {
        "title": word(pair.kind, language),
        "about": word(about_key, language) + _place_of_the_measure(verdict, pair, language),
        "motion": word(
            "motion_shown",
            language,
            number=pair.member.motion + 1,
            count=count,
            name=motion_label(pair.motion, language),
            peak=pair.motion.pga,
            start=f"{pair.start:.1f}",
            end=f"{pair.end:.1f}",
            duration=f"{pair.motion.duration:g}",
        ),
        "moved": _moved(scene, language),
        "sides": sides,
        "chart": Markup(histories_svg(pair, language, word("listed", language).join(outcomes))),
    }


def _moved(scene: Scene, language: str) -> str:
    """Return how the room moves in the scenes."""
    text = word("watch_text", language, corner=f"{DRIFT_CORNER:g}", grid=f"{scene.view.grid:g}")
    if scene.shift_scale >= 1.0:
        return text
    joint = " " if language == "en" else ""
    return text + joint + word("part_shown", language, part=f"{100.0 * scene.shift_scale:.0f}")


def _detail(result: OptionVerdict, verdict: Verdict, language: str) -> dict[str, Any]:
    measures: Sequence[Measure] = result.option.measures
    return {
        **_drawn(verdict, result, language),
        "rank": result.rank,
        "about": [say(measure.about, language) for measure in measures],
        "change": numbers.change(result.change, language),
        "devices": device_rows(result, language),
        "parameters": [
            (say(measure.label, language), _parameters(measure, language)) for measure in measures
        ],
    }


def _parameters(measure: Measure, language: str) -> list[tuple[str, str, str]]:
    """Return name, value with unit, and how well founded it is, of each parameter."""
    rows: list[tuple[str, str, str]] = []
    for about in parameters(measure):
        value = getattr(measure, about.name)
        shown = value if isinstance(value, str) else numbers.NO_NUMBER if value is None else f"{value:.6g}"
        name = say(about.label, language)
        rows.append((name, f"{shown} {about.unit}".rstrip(), about.tag(value)))
    return rows
