"""Verdicts on one piece and on several as self-contained HTML pages."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from stayput.catalogue import phrase, say
from stayput.catalogue.names import STABILITY
from stayput.fragility.curve import CurveState, FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures import Measure, parameters
from stayput.montecarlo.counting import OVERTURNED, Member
from stayput.report.animation import film_of, player_page
from stayput.report.figures import classes_between, drawable, embedded
from stayput.report.history import peak_told, window_of
from stayput.report.names import motion_label
from stayput.report.page import framed, rendered, write_page
from stayput.report.plot import plot_run
from stayput.report.summary import sentences_of_piece
from stayput.report.verdict import numbers, svg, tables
from stayput.report.verdict.assumptions import Assumption, assumptions, told
from stayput.report.verdict.drawing import drawing_svg
from stayput.report.verdict.numbers import word, word_of
from stayput.verification.contest import drawn_run
from stayput.verification.words import class_label, title

if TYPE_CHECKING:
    from stayput.simulation.run import Run
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

WIDTH, HEIGHT = 600.0, 400.0
LEFT, RIGHT, TOP, BOTTOM = 74.0, 590.0, 34.0, 346.0
LOOKS = 11
"""Looks of lines that the page's style has: the first is that of no measure, the second of the best."""

_POINTS = 191


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
    text, text_of = partial(word, language=language), partial(word_of, verdict, language=language)
    holds = () if alone else (text_of("holds"),)
    command = ["stayput", "verify", "scenario.toml", "--slide-limit", f"{verdict.slide_limit:g}"]
    held = [result for result in verdict.options if result.option.count]
    drawn = [verdict.without, *[verdict.best] * bool(verdict.best.option.count)] if alone else []
    sheets, texts = ["verdict/report.css"], "report" if alone else "several"
    return {
        **shared_content(verdict, texts, text_of("report"), sheets, assumptions(verdict), language),
        "alone": alone,
        "events": tables.event_headings(verdict, language),
        "simulations": tables.simulations(verdict, language),
        "impossible": tables.impossible_rows(verdict, language),
        "pairs": pairs_of(verdict, language),
        "device_columns": [*holds, *map(text, tables.DEVICE_COLUMNS)],
        "command": shlex.join([*command, "--lang", language, "--report", "report.html"]),
        "headline": verdict.sentence(language),
        "shares": [f"{100.0 * share:g}" for share in tables.SHARES] if alone else [],
        "notes": verdict.notes(language),
        "grades": tables.grades_text(language) if alone else "",
        "rows": tables.ranking(verdict, language),
        "drawn": [_drawn(verdict, result, language) for result in drawn],
        "looks": looks(verdict),
        "curves": Markup(curves_svg(verdict, language)) if verdict.best.curves else None,
        "legend": legend(verdict, language),
        "details": [_detail(result, verdict, language) for result in held],
        "estimates": tables.estimate_rows(verdict, language) if verdict.estimates else [],
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
        "weakest": tables.weakest_inputs(result, verdict, language) if alone else "",
    }


def _detail(result: OptionVerdict, verdict: Verdict, language: str) -> dict[str, Any]:
    measures = {measure.label: measure for measure in result.option.measures}.values()
    return {
        **_drawn(verdict, result, language),
        "rank": result.rank,
        "about": [say(measure.about, language) for measure in measures],
        "change": numbers.change(result.change, language),
        "devices": tables.device_rows(result, language),
        "parameters": [(say(m.label, language), _parameters(m, language)) for m in measures],
    }


def _parameters(measure: Measure, language: str) -> Iterator[tuple[str, str, str]]:
    """Yield name, value with unit, and how well founded it is, of each parameter."""
    for about in parameters(measure):
        value = getattr(measure, about.name)
        shown = value if isinstance(value, str) else numbers.NO_NUMBER if value is None else f"{value:.6g}"
        yield say(about.label, language), f"{shown} {about.unit}".rstrip(), about.tag(value)


def pairs_of(verdict: Verdict, language: str) -> list[dict[str, Any]]:
    """Return what a report shows of the typical and the worst case, run again.

    The typical case is that without a measure, the worst one that of the best measure; without a best
    measure both are those without one, alone.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    heading = word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    without = phrase("common.without" if verdict.scenario.alone else "several.nothing")
    pairs: list[dict[str, Any]] = []
    for kind, member in (("typical", verdict.without.typical), ("worst", verdict.best.worst)):
        sides = _sides(verdict, member, language)
        runs = [run for _, run in sides]
        window = window_of(runs)
        about = word(f"{kind}{'' if len(sides) > 1 else '_bare'}_text", language, without=without)
        if kind == "typical" and len(runs) > 1 and verdict.scenario.alone:
            about += place_of_the_measure(verdict, runs[1], language)
        shown: list[dict[str, Any]] = []
        for label, run in sides:
            film = film_of(run, language, runs, window=window)
            shown.append(
                {
                    "label": label,
                    "outcome": say(sentences_of_piece(run), language),
                    # several that play at once would be too much for a slow machine
                    "player": player_page(film, 1.0, 1.5, plays=False),
                    "histories": embedded(plot_run(film.scene.run, language=drawn), "svg"),
                }
            )
        motion = motion_told(verdict, member, runs[0], window, language)
        pairs.append({"title": word(kind, language), "about": about, "sides": shown, "motion": motion})
    return pairs


def _sides(verdict: Verdict, member: Member, language: str) -> list[tuple[str, Run]]:
    """Return labels and runs of what is shown side by side: no measure, and the best one, if it is one."""
    scenario = verdict.scenario
    shown = [verdict.without, verdict.best][: 1 + bool(verdict.best.option.count)]
    return [
        (title(result.option, verdict, language), drawn_run(scenario, result.option, member))
        for result in shown
    ]


def place_of_the_measure(verdict: Verdict, held: Run, language: str) -> str:
    """Return whether the measure's run in a typical case is one of those that overturn, and how many do.

    The case is typical of the piece without a measure: the measure may fail in it and hold in most others.
    """
    chance = verdict.best.probabilities[OVERTURNED]
    if chance.runs == 0:
        return ""
    spared = "typical_never_falls" if chance.estimate == 0.0 else "typical_is_held"
    key = "typical_also_falls" if held.overturned else spared
    text = word(key, language, share=chance.share)
    return f" {text}" if language == "en" else text


def motion_told(verdict: Verdict, member: Member, run: Run, shown: tuple[float, float], language: str) -> str:
    """Return which motion a run met, how strong it was, and from when to when it is shown [s]."""
    return word(
        "motion_shown",
        language,
        number=member.motion + 1,
        count=verdict.motions,
        name=motion_label(run.motion, language),
        peak=peak_told(run),
        start=f"{shown[0]:.1f}",
        end=f"{shown[1]:.1f}",
        duration=f"{run.motion.duration:g}",
    )


def looks(verdict: Verdict) -> dict[str, int]:
    """Return the look of each option's line, by its name: 0 without a measure, the others as they rank."""
    names = [result.option.name for result in verdict.options if result.option.measures]
    by_name = {name: 1 if n == 0 else 2 + (n - 1) % (LOOKS - 2) for n, name in enumerate(names)}
    return by_name | {verdict.without.option.name: 0}


def legend(verdict: Verdict, language: str) -> list[dict[str, object]]:
    """Return the legend, the best option first: each look, label, and whether there is a curve."""
    look_of, entries = looks(verdict), list[dict[str, object]]()
    for result in verdict.options:
        if result.curves:
            state = result.curves[JMA_INTENSITY].state
            label = title(result.option, verdict, language)
            note = "" if state is CurveState.FITTED else word("no_curve", language, state=state.phrase)
            entries.append({"look": look_of[result.option.name], "label": label, "note": note})
    return entries


def curves_svg(verdict: Verdict, language: str) -> str:
    """Return the picture: curves of all options, bands and counts of no measure and of the best.

    Parameters
    ----------
    verdict : Verdict
        A verdict with curves.
    language : str
        "en" or "ja".
    """
    levels = verdict.levels
    x = svg.PixelAxis(float(levels[0]) - 0.1, float(levels[-1]) + 0.1, LEFT, RIGHT)
    y = svg.PixelAxis(0.0, 1.0, BOTTOM, TOP)
    label = say("fragility.floor_jma" if verdict.floor else "report.axis_intensity", language)
    parts = [*([] if verdict.floor else _classes(x, language)), *_frame(x, y, label, language)]
    look_of = looks(verdict)
    shown = [verdict.without, *([verdict.best] if verdict.best.option.measures else [])]
    parts += [_band(x, y, result.curves[JMA_INTENSITY], look_of[result.option.name]) for result in shown]
    for result in reversed(verdict.options):
        curve = result.curves[JMA_INTENSITY]
        if curve.state is CurveState.FITTED:
            grid = curve.grid(_POINTS)
            style = f"curve look{look_of[result.option.name]}"
            parts.append(svg.polyline(x.at(grid), y.at(curve.probability(grid)), style))
    for result in shown:
        parts += _counts(x, y, result.curves[JMA_INTENSITY], look_of[result.option.name])
    if x.low <= verdict.intensity <= x.high:
        parts += _here(x, verdict.intensity, language)
    return svg.drawing(WIDTH, HEIGHT, parts, word("fragility_alt", language), "chart")


def _classes(x: svg.PixelAxis, language: str) -> list[str]:
    """Return bands of every second class of JMA's intensity, and the classes' names along the top."""
    parts: list[str] = []
    for shaded, name, low, high in classes_between(x.low, x.high):
        left, right = x.place(low), x.place(high)
        if shaded:
            parts.append(svg.box(left, TOP, right, BOTTOM, "classes"))
        if right - left > 40.0:
            name_shown = name if language == "en" else class_label(0.5 * (low + high), language)
            parts.append(svg.label(0.5 * (left + right), TOP - 8.0, name_shown))
    return parts


def _frame(x: svg.PixelAxis, y: svg.PixelAxis, label: str, language: str) -> list[str]:
    parts: list[str] = []
    for share in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
        level = y.place(share)
        parts.append(svg.line(LEFT, level, RIGHT, level, "grid"))
        parts.append(svg.label(LEFT - 7.0, level + 4.5, numbers.share(share, language), anchor="end"))
    for value in svg.ticks(x.low, x.high, 7):
        parts += svg.tick(x.place(value), BOTTOM, f"{value:.1f}")
    parts.append(svg.line(LEFT, BOTTOM, RIGHT, BOTTOM, "axis"))
    parts.append(svg.label(0.5 * (LEFT + RIGHT), BOTTOM + 42.0, label, "name"))
    middle = 0.5 * (TOP + BOTTOM)
    turned = svg.label(0.0, 0.0, word("axis_share", language), "name")
    parts.append(svg.element("g", turned, transform=f"translate(14 {middle:.0f}) rotate(-90)"))
    return parts


def _band(x: svg.PixelAxis, y: svg.PixelAxis, curve: FragilityCurve, look: int) -> str:
    if curve.state is not CurveState.FITTED or curve.one_motion:
        return ""
    grid = curve.grid(_POINTS)
    low, high = curve.band(grid)
    upper = zip(x.at(grid).tolist(), y.at(high).tolist(), strict=True)
    lower = zip(x.at(grid[::-1]).tolist(), y.at(low[::-1]).tolist(), strict=True)
    return svg.polygon([*upper, *lower], f"band look{look}")


def _counts(x: svg.PixelAxis, y: svg.PixelAxis, curve: FragilityCurve, look: int) -> list[str]:
    """Return marks of the observed shares: circles without a measure, squares with one."""
    parts: list[str] = []
    for level in curve.levels:
        across, up = x.place(level.im), y.place(level.probability.estimate)
        if look == 0:
            parts.append(svg.element("circle", cx=across, cy=up, r=3.5, class_=f"mark look{look}"))
        else:
            parts.append(svg.box(across - 3.2, up - 3.2, across + 3.2, up + 3.2, f"mark look{look}"))
    return parts


def _here(x: svg.PixelAxis, intensity: float, language: str) -> list[str]:
    across = x.place(intensity)
    right = across < 0.5 * (LEFT + RIGHT)
    text = word("here", language, value=JMA_INTENSITY.text(intensity))
    place, anchor = (across + 6.0, "start") if right else (across - 6.0, "end")
    return [
        svg.line(across, TOP, across, BOTTOM, "here"),
        svg.label(place, TOP + 16.0, text, "name halo", anchor),
    ]
