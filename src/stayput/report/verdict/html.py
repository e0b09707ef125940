"""Verdicts on one piece and on several as self-contained HTML pages."""

from __future__ import annotations

import shlex
from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from stayput.catalogue import phrase, say
from stayput.measures import parameters
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.page import file_of, framed, rendered, script_json, script_module, write_page
from stayput.report.palette import mode_looks
from stayput.report.scene import DRIFT_CORNER
from stayput.report.summary import sentences_of_piece
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.curves import curves_svg, legend, looks
from stayput.report.verdict.drawing import drawing_svg
from stayput.report.verdict.numbers import word
from stayput.report.verdict.pairs import (
    about_case,
    histories_svg,
    motion_told,
    pairs_of,
    pairs_of_several,
    space_pairs,
)
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
    from stayput.report.scene import PlaneScene
    from stayput.report.verdict.assumptions import Assumption
    from stayput.report.verdict.pairs import RunPair
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
        "device_columns": [word(key, language) for key in DEVICE_COLUMNS],
        "command": shlex.join([*command, "--lang", language, "--report", "report.html"]),
    }


def _content(verdict: Verdict, language: str) -> dict[str, Any]:
    scenario = verdict.scenario
    ground = scenario.ground()
    in_space = scenario.dimensions == 3
    pairs = () if in_space else pairs_of(verdict, ground)
    modes = mode_looks(language)
    scenes = {"modes": modes, "pairs": [pair.data(scenario.piece) for pair in pairs]}
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
        "pairs": [_pair(verdict, pair, language) for pair in pairs],
        "space_pairs": space_pairs(verdict, ground, language) if in_space else [],
        "modes": modes.values(),
        "scenes": Markup(script_json(scenes)),
        "details": [_detail(item, verdict, language) for item in verdict.options if item.option.measures],
        "estimates": estimate_rows(verdict, language),
        "reads_files": scenario.shaking.record is not None or isinstance(scenario.shaking.suite, str),
        "script": Markup(script_module(file_of("verdict/report.js"))),
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
        "pairs": pairs_of_several(verdict, language),
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


def _place_of_the_measure(verdict: Verdict, pair: RunPair, language: str) -> str:
    """Return whether the measure's run in a typical case is one of those that overturn, and how many do.

    The case is typical of the piece without a measure: the measure may fail in it and hold in most others.
    """
    chance = verdict.best.probabilities[OVERTURNED]
    if pair.kind != "typical" or len(pair.options) == 1 or chance.runs == 0:
        return ""
    held = "typical_never_falls" if chance.estimate == 0.0 else "typical_is_held"
    key = "typical_also_falls" if pair.scene.runs[1].overturned else held
    text = word(key, language, share=numbers.share(chance.estimate, language))
    return f" {text}" if language == "en" else text


def _pair(verdict: Verdict, pair: RunPair, language: str) -> dict[str, Any]:
    scene = pair.scene
    labels = [title(option, verdict, language) for option in pair.options]
    said = [say(sentences_of_piece(run), language) for run in scene.runs]
    sides = [{"label": label, "outcome": outcome} for label, outcome in zip(labels, said, strict=True)]
    outcomes = [f"{side['label']}{word('colon', language)}{side['outcome']}" for side in sides]
    about = about_case(pair.kind, len(sides), phrase("common.without"), language)
    return {
        "title": word(pair.kind, language),
        "about": about + _place_of_the_measure(verdict, pair, language),
        "motion": motion_told(verdict, pair.member, scene.runs[0], (scene.start, scene.end), language),
        "moved": _moved(scene, language),
        "sides": sides,
        "chart": Markup(histories_svg(pair, language, (" " if language == "en" else "").join(outcomes))),
    }


def _moved(scene: PlaneScene, language: str) -> str:
    """Return how the room moves in the scenes."""
    text = word("watch_text", language, corner=f"{DRIFT_CORNER:g}", grid=f"{scene.view.grid:g}")
    if scene.shift_scale >= 1.0:
        return text
    joint = " " if language == "en" else ""
    return text + joint + word("part_shown", language, part=f"{100.0 * scene.shift_scale:.0f}")


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
