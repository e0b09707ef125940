"""Verdicts on one piece and on several as self-contained HTML pages."""

from __future__ import annotations

import shlex
from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from stayput.catalogue import say
from stayput.catalogue.names import STABILITY
from stayput.measures import parameters
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.page import framed, rendered, write_page
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.curves import curves_svg, legend, looks
from stayput.report.verdict.drawing import drawing_svg
from stayput.report.verdict.numbers import word
from stayput.report.verdict.pairs import pairs_of
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
from stayput.verification.words import class_label, title

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

    from stayput.measures import Measure
    from stayput.report.verdict.assumptions import Assumption
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict


def write_report(verdict: Verdict, path: str | Path, language: str = "en") -> Path:
    """Write a report of a verdict: one HTML file with drawings, curves, animations and all inputs.

    It loads nothing from elsewhere, and can be printed. Up to four of the runs are done again for it.

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
    """Return the text of a report; see `write_report`."""
    return rendered("verdict/report.html", _content(verdict, language))


def shared_content(
    verdict: Verdict,
    texts: str,
    kind: str,
    sheets: Iterable[str],
    rests_on: Iterable[Assumption],
    language: str,
) -> dict[str, Any]:
    """Return what the reports of all verdicts show.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    texts : str
        The part of the catalogue that has the page's own texts.
    kind : str
        What the report is called, where the scenario has no title.
    sheets : iterable of str
        Style sheets; see `stayput.report.page.framed`.
    rests_on : iterable of Assumption
        The assumptions.
    language : str
        "en" or "ja".
    """
    shaking = {"class": class_label(verdict.intensity, language, verdict.floor)}
    return {
        **framed(language, texts, verdict.scenario.title or kind, sheets),
        "text": partial(word, language=language),
        "numbers": numbers,
        "verdict": verdict,
        "kind": kind,
        "strength": word("instrumental", language, **shaking, value=f"{verdict.intensity:.2f}"),
        "limit": numbers.length(verdict.slide_limit, language),
        "assumptions": told(rests_on, language),
        "toml": verdict.scenario.to_toml(),
    }


def _content(verdict: Verdict, language: str) -> dict[str, Any]:
    shaking, alone = verdict.scenario.shaking, verdict.scenario.alone
    text, of_several = partial(word, language=language), partial(say, language=language)
    kind = text("report") if alone else of_several("several.report")
    holds = () if alone else (of_several("several.holds"),)
    command = ["stayput", "verify", "scenario.toml", "--slide-limit", f"{verdict.slide_limit:g}"]
    held = [result for result in verdict.options if result.option.count]
    drawn = [verdict.without, *[verdict.best] * bool(verdict.best.option.count)] if alone else []
    sheets, texts = ["verdict/report.css"], "report" if alone else "several"
    return {
        **shared_content(verdict, texts, kind, sheets, assumptions(verdict), language),
        "alone": alone,
        "option": text("measure") if alone else of_several("several.option"),
        "falls": text("overturned") if alone else of_several("several.any"),
        "simulations": simulations(verdict, language),
        "impossible": impossible_rows(verdict, language),
        "pairs": pairs_of(verdict, language),
        "device_columns": [*holds, *map(text, DEVICE_COLUMNS)],
        "command": shlex.join([*command, "--lang", language, "--report", "report.html"]),
        "headline": verdict.sentence(language),
        "shares": [f"{100.0 * share:g}" for share in SHARES] if alone else [],
        "notes": verdict.notes(language),
        "grades": grades_text(language) if alone else "",
        "rows": ranking(verdict, language),
        "drawn": [_drawn(verdict, result, language) for result in drawn],
        "looks": looks(verdict),
        "curves": Markup(curves_svg(verdict, language)) if verdict.best.curves else None,
        "legend": legend(verdict, language),
        "details": [_detail(result, verdict, language) for result in held],
        "estimates": estimate_rows(verdict, language) if verdict.estimates else [],
        "reads_files": shaking.record is not None or isinstance(shaking.suite, str),
    }


def _drawn(verdict: Verdict, result: OptionVerdict, language: str) -> dict[str, Any]:
    label, alone = title(result.option, verdict, language), verdict.scenario.alone
    return {
        "label": label,
        "drawing": Markup(drawing_svg(verdict, result, language, label)) if alone else "",
        "stands": say(STABILITY[result.pieces[0].stability], language) if alone else "",
        "share": numbers.probability(result.probabilities[OVERTURNED], language),
        "interval": numbers.interval(result.probabilities[OVERTURNED], language),
        "grade": verdict.grade(result).value if alone else "",
        "weakest": weakest_inputs(result, verdict, language) if alone else "",
    }


def _detail(result: OptionVerdict, verdict: Verdict, language: str) -> dict[str, Any]:
    measures = {measure.label: measure for measure in result.option.measures}.values()
    return {
        **_drawn(verdict, result, language),
        "rank": result.rank,
        "about": [say(measure.about, language) for measure in measures],
        "change": numbers.change(result.change, language),
        "devices": device_rows(result, language),
        "parameters": [(say(m.label, language), _parameters(m, language)) for m in measures],
    }


def _parameters(measure: Measure, language: str) -> Iterator[tuple[str, str, str]]:
    """Yield name, value with unit, and how well founded it is, of each parameter."""
    for about in parameters(measure):
        value = getattr(measure, about.name)
        shown = value if isinstance(value, str) else numbers.NO_NUMBER if value is None else f"{value:.6g}"
        yield say(about.label, language), f"{shown} {about.unit}".rstrip(), about.tag(value)
