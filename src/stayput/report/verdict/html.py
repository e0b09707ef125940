"""A verdict as one HTML page that needs nothing else."""

from __future__ import annotations

import json
import shlex
from importlib import resources
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

import stayput
from stayput.files import check_target, draft
from stayput.measures import parameters
from stayput.report.film import DRIFT_CORNER
from stayput.report.palette import MODE_COLOURS
from stayput.report.summary import motion_label
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.curves import curves_svg, legend, looks
from stayput.report.verdict.drawing import drawing_svg
from stayput.report.verdict.estimates import estimate_rows
from stayput.report.verdict.histories import histories_svg
from stayput.report.verdict.languages import check_language
from stayput.report.verdict.pairs import pairs_of
from stayput.report.verdict.scenes import scene
from stayput.report.verdict.tables import DEVICE_COLUMNS, SHARES, device_rows, ranking, simulations
from stayput.report.verdict.words import MODES, motion_named, place, word
from stayput.scenario.writing import scenario_toml
from stayput.verification.verdict import OVERTURNED
from stayput.verification.words import class_label, headline, title

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.measures import Measure
    from stayput.report.verdict.pairs import Pair
    from stayput.verification import OptionVerdict, Verdict

SUFFIXES = (".html",)
"""The kind of file that a report is written as."""


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
    check_language(language)
    target = check_target(path, SUFFIXES)
    text = report_html(verdict, language)
    with draft(target) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
    return target


def report_html(verdict: Verdict, language: str = "en") -> str:
    """Return the text of a report; see `write_report`.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    pages = Environment(
        loader=PackageLoader("stayput.report", "verdict"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    pages.filters["tight"] = _tight
    return pages.get_template("report.html").render(_content(verdict, language))


def _content(verdict: Verdict, language: str) -> dict[str, Any]:
    scenario = verdict.scenario
    ground = scenario.shaking.ground(scenario.folder)
    pairs = pairs_of(verdict, ground)
    scenes = [scene(pair, language) for pair in pairs]

    def told(key: str, **values: object) -> str:
        return word(key, language, **values)

    return {
        "language": language,
        "told": told,
        "numbers": numbers,
        "verdict": verdict,
        "title": scenario.title or told("report"),
        "headline": headline(verdict, language),
        "version": stayput.__version__,
        "strength": told(
            "instrumental",
            **{"class": class_label(verdict.intensity, language), "value": f"{verdict.intensity:.2f}"},
        ),
        "simulations": simulations(verdict, language),
        "device_columns": [told(key) for key in DEVICE_COLUMNS],
        "limit": numbers.length(verdict.slide_limit, language),
        "shares": [f"{100.0 * share:g}" for share in SHARES],
        "rows": ranking(verdict, language),
        "looks": looks(verdict),
        "before": _drawn(verdict, verdict.without, language),
        "after": _drawn(verdict, verdict.best, language) if verdict.best.option.measures else None,
        "curves": Markup(curves_svg(verdict, language)) if verdict.best.curves else None,
        "legend": legend(verdict, language),
        "pairs": [
            _pair(verdict, pair, drawn, len(ground), language)
            for pair, drawn in zip(pairs, scenes, strict=True)
        ],
        "modes": [(colour, MODES[mode][place(language)]) for mode, colour in MODE_COLOURS.items()],
        "scenes": Markup(_script_data(scenes)),
        "details": [_detail(one, verdict, language) for one in verdict.options if one.option.measures],
        "estimates": estimate_rows(verdict, language),
        "assumptions": [(a.what(language), a.value(language), a.confidence) for a in assumptions(verdict)],
        "toml": scenario_toml(scenario),
        "reads_files": scenario.shaking.record is not None or isinstance(scenario.shaking.suite, str),
        "command": command(verdict, language),
        "style": Markup(_text("report.css")),
        "script": Markup(_text("report.js")),
    }


def command(verdict: Verdict, language: str, file: str = "scenario.toml") -> str:
    """Return the command that makes the report again."""
    words = ["stayput", "verify", file, "--slide-limit", f"{verdict.slide_limit:g}", "--lang", language]
    return shlex.join([*words, "--report", "report.html"])


def _tight(text: str) -> str:
    """Return a text whose lines do not end between a number and its sign of per cent."""
    return text.replace(" %", "\N{NO-BREAK SPACE}%")


def _text(name: str) -> str:
    return resources.files("stayput.report.verdict").joinpath(name).read_text(encoding="utf-8")


def _script_data(values: object) -> str:
    """Return values for a script element, which "</" would end."""
    return json.dumps(values, allow_nan=False, ensure_ascii=False, separators=(",", ":")).replace(
        "</", "<\\/"
    )


def _drawn(verdict: Verdict, one: OptionVerdict, language: str) -> dict[str, Any]:
    label = title(one.option, verdict, language)
    return {
        "label": label,
        "drawing": Markup(drawing_svg(verdict, one.option.measures, language, label)),
        "share": numbers.probability(one.probabilities[OVERTURNED], language),
        "interval": numbers.interval(one.probabilities[OVERTURNED], language),
    }


def _pair(verdict: Verdict, pair: Pair, drawn: dict[str, Any], count: int, language: str) -> dict[str, Any]:
    sides = [
        {"label": title(side.option, verdict, language), "outcome": side.outcome(language)}
        for side in pair.sides
    ]
    outcomes = [f"{side['label']}{word('colon', language)}{side['outcome']}" for side in sides]
    said = f"{pair.kind} told" if len(pair.sides) > 1 else f"{pair.kind} bare told"
    return {
        "title": word(pair.kind, language),
        "told": word(said, language),
        "motion": word(
            "motion shown",
            language,
            number=pair.member.motion + 1,
            count=count,
            name=motion_named(motion_label(pair.motion), language),
            peak=f"{pair.motion.pga:.1f}",
            start=f"{pair.start:.1f}",
            end=f"{pair.end:.1f}",
            duration=f"{pair.motion.duration:g}",
        ),
        "moved": _moved(drawn, language),
        "sides": sides,
        "chart": Markup(histories_svg(pair, language, word("listed", language).join(outcomes))),
    }


def _moved(drawn: dict[str, Any], language: str) -> str:
    """Return how the room moves in the scenes."""
    told = word("watch told", language, corner=f"{DRIFT_CORNER:g}", grid=f"{drawn['grid']:g}")
    if drawn["part"] >= 1.0:
        return told
    joint = " " if language == "en" else ""
    return told + joint + word("part shown", language, part=f"{100.0 * drawn['part']:.0f}")


def _detail(one: OptionVerdict, verdict: Verdict, language: str) -> dict[str, Any]:
    which = place(language)
    measures: Sequence[Measure] = one.option.measures
    return {
        **_drawn(verdict, one, language),
        "rank": one.rank,
        "about": [measure.about[which] for measure in measures],
        "change": numbers.change(one.change, language),
        "devices": device_rows(one, language),
        "parameters": [(measure.label[which], _parameters(measure, language)) for measure in measures],
    }


def _parameters(measure: Measure, language: str) -> list[tuple[str, str, str]]:
    """Return name, value with unit, and how well founded it is, of each parameter."""
    found: list[tuple[str, str, str]] = []
    for about in parameters(measure):
        value = getattr(measure, about.name)
        usual = value == about.default
        shown = value if isinstance(value, str) else numbers.NO_NUMBER if value is None else f"{value:.6g}"
        name = about.label[place(language)]
        found.append((name, f"{shown} {about.unit}".rstrip(), about.confidence.value if usual else "given"))
    return found
