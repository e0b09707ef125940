"""Verdicts on one piece and on several as self-contained HTML pages."""

from __future__ import annotations

import shlex
from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from stayput.catalogue import say
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
    from stayput.rooms.verdict import RoomVerdict
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
    if not verdict.scenario.alone:
        return rendered("verdict/several.html", _content_of_several(verdict, language))
    return rendered("verdict/report.html", _content(verdict, language))


def shared_content(
    verdict: Verdict | RoomVerdict,
    texts: str,
    kind: str,
    sheets: Iterable[str],
    rests_on: Iterable[Assumption],
    language: str,
) -> dict[str, Any]:
    """Return what the reports of all verdicts show.

    Parameters
    ----------
    verdict : Verdict or RoomVerdict
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


def _of_a_ranking(
    verdict: Verdict, texts: str, kind: str, rests_on: Iterable[Assumption], language: str
) -> dict[str, Any]:
    command = ["stayput", "verify", "scenario.toml", "--slide-limit", f"{verdict.slide_limit:g}"]
    return {
        **shared_content(verdict, texts, kind, ["verdict/report.css"], rests_on, language),
        "simulations": simulations(verdict, language),
        "impossible": impossible_rows(verdict, language),
        "pairs": pairs_of(verdict, language),
        "device_columns": [word(key, language) for key in DEVICE_COLUMNS],
        "command": shlex.join([*command, "--lang", language, "--report", "report.html"]),
    }


def _content(verdict: Verdict, language: str) -> dict[str, Any]:
    shaking = verdict.scenario.shaking
    return {
        **_of_a_ranking(verdict, "report", word("report", language), assumptions(verdict), language),
        "headline": verdict.sentence(language),
        "shares": [f"{100.0 * share:g}" for share in SHARES],
        "notes": verdict.notes(language),
        "grades": grades_text(language),
        "rows": ranking(verdict, language),
        "looks": looks(verdict),
        "before": _drawn(verdict, verdict.without, language),
        "after": _drawn(verdict, verdict.best, language) if verdict.best.option.measures else None,
        "curves": Markup(curves_svg(verdict, language)) if verdict.best.curves else None,
        "legend": legend(verdict, language),
        "details": [_detail(item, verdict, language) for item in verdict.options if item.option.measures],
        "estimates": estimate_rows(verdict, language),
        "reads_files": shaking.record is not None or isinstance(shaking.suite, str),
    }


def _content_of_several(verdict: Verdict, language: str) -> dict[str, Any]:
    content = _of_a_ranking(
        verdict, "several", say("several.report", language), assumptions(verdict), language
    )
    rows = ranking(verdict, language)
    return {
        **content,
        "headline": verdict.sentence(language),
        "rows": rows,
        "device_columns": [say("several.holds", language), *content["device_columns"]],
        "details": [(row, device_rows(row.option, language)) for row in rows if row.option.devices],
    }


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


def _detail(result: OptionVerdict, verdict: Verdict, language: str) -> dict[str, Any]:
    measures = result.option.measures
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
