"""Verdicts on one piece and on several as self-contained HTML pages."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from stayput.catalogue import say
from stayput.catalogue.names import STABILITY
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures import Measure, hold, parameters
from stayput.montecarlo.counting import OVERTURNED, Member
from stayput.report.animation import film_of, player_page
from stayput.report.figures import drawable, embedded, figure_of
from stayput.report.fragility import plot_options
from stayput.report.history import peak_told, window_of
from stayput.report.names import motion_label, named
from stayput.report.page import framed, rendered
from stayput.report.plot import plot_run
from stayput.report.section import draw_section
from stayput.report.summary import sentences_of_piece
from stayput.report.verdict import numbers, tables
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.numbers import word
from stayput.verification.option_runner import drawn_run
from stayput.verification.words import class_label, title

if TYPE_CHECKING:
    from stayput.report.verdict.tables import RankingRow
    from stayput.simulation.run import Run
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict


def report_html(verdict: Verdict, language: str = "en") -> str:
    """Return a report of a verdict: one HTML page with drawings, curves, animations and all inputs.

    It loads nothing from elsewhere, and can be printed. Up to four of the runs are done again for it.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".

    Raises
    ------
    InputError
        A record that cannot be read any more.
    """
    return rendered("verdict/report.html", _content(verdict, language))


def shared_content(
    verdict: Verdict, texts: str, kind: str, sheets: Iterable[str], language: str
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
        "assumptions": told(assumptions(verdict), language),
        "toml": verdict.scenario.to_toml(),
    }


def _content(verdict: Verdict, language: str) -> dict[str, Any]:
    shaking, alone = verdict.scenario.shaking, verdict.scenario.alone
    text = partial(word, language=language)
    holds = () if alone else (say("several.holds", language),)
    command = ["stayput", "verify", "scenario.toml", "--slide-limit", f"{verdict.slide_limit:g}"]
    held = [result for result in verdict.options if result.option.count]
    rows = tables.ranking(verdict, language)
    ranked = first_rows(rows)
    drawn = _compared(verdict) if alone else []
    sheets, texts = ["verdict/report.css"], "report" if alone else "several"
    return {
        **shared_content(verdict, texts, text("report"), sheets, language),
        "alone": alone,
        "without": title(verdict.without.option, verdict, language),
        "events": tables.event_headings(verdict, language),
        "simulations": tables.simulations(verdict, language),
        "impossible": tables.impossible_rows(verdict, language),
        "pairs": pairs_of(verdict, language),
        "device_columns": [*holds, *map(text, tables.DEVICE_COLUMNS)],
        "command": shlex.join([*command, "--lang", language, "--report", "report.html"]),
        "headline": verdict.sentence(language),
        "shares": [f"{100.0 * share:g}" for share in tables.SHARES] if alone else [],
        "notes": verdict.notes(language),
        "grades": tables.grades_text(language),
        "rows": rows,
        "ranked": ranked,
        "more": len(rows) + len(verdict.impossible) - len(ranked),
        "drawn": [_drawn(verdict, result, language) for result in drawn],
        "curves": curves_image(verdict, language) if verdict.best.curves else "",
        "details": [_detail(result, verdict, language) for result in held],
        "estimates": tables.estimate_rows(verdict, language) if verdict.estimates else [],
        "reads_files": shaking.record is not None or isinstance(shaking.suite, str),
    }


def _drawn(verdict: Verdict, result: OptionVerdict, language: str) -> dict[str, Any]:
    label, alone = title(result.option, verdict, language), verdict.scenario.alone
    about = ""
    if alone:
        body, piece = verdict.scenario.piece.body(), named(verdict.scenario.piece.title, language)
        width, height = (f"{100.0 * size:.3g}" for size in (body.width, body.height))
        about = word("drawing_alt", language, piece=piece, width=width, height=height, label=label)
    return {
        "label": label,
        "drawing": drawing(verdict, result, language) if alone else "",
        "about_drawing": about,
        "stands": say(STABILITY[result.pieces[0].stability], language) if alone else "",
        "share": numbers.probability(result.probabilities[OVERTURNED], language),
        "interval": numbers.interval(result.probabilities[OVERTURNED], language),
        "grade": verdict.grade(result).value,
        "weakest": tables.weakest_inputs(result, verdict, language),
    }


def _detail(result: OptionVerdict, verdict: Verdict, language: str) -> dict[str, Any]:
    measures = {measure.label: measure for measure in result.option.measures}.values()
    return {
        **_drawn(verdict, result, language),
        "rank": result.rank,
        "about": [say(measure.about, language) for measure in measures],
        "change": "" if result.change is None else numbers.change(result.change, language),
        "devices": tables.device_rows(result, verdict, language),
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

    The typical case is that of the baseline, the worst one that of the best option; where the baseline is
    the best, both are its own, alone.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    heading = word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    without = title(verdict.without.option, verdict, language)
    pairs: list[dict[str, Any]] = []
    for kind, member in (("typical", verdict.without.typical), ("worst", verdict.best.worst)):
        sides = _sides(verdict, member, language)
        runs = [run for _, run in sides]
        window = window_of(runs)
        about = word(f"{kind}{'' if len(sides) > 1 else '_bare'}_text", language, without=without)
        if kind == "typical" and len(runs) > 1 and verdict.scenario.alone:
            about += place_of_the_measure(verdict, runs[1], language)
        films = [film_of(run, language, runs, window=window) for run in runs]
        outcomes = [say(sentences_of_piece(run), language) for run in runs]
        labels = [label for label, _ in sides]
        colon, listed = word("colon", language), word("listed", language)
        shown = [
            {
                "label": label,
                "outcome": outcome,
                "histories": embedded(plot_run(film.scene.run, language=drawn), "svg"),
            }
            for label, outcome, film in zip(labels, outcomes, films, strict=True)
        ]
        pairs.append(
            {
                "title": word(kind, language),
                "about": about,
                "sides": shown,
                "outcomes": listed.join(
                    f"{label}{colon}{said}" for label, said in zip(labels, outcomes, strict=True)
                ),
                # it does not play before somebody asks for it: a page opens at its most telling moment
                "player": player_page(films, 1.0, 1.5, plays=False, labels=labels),
                "motion": motion_told(verdict, member, runs[0], window, language),
            }
        )
    return pairs


MOST_RANKED = 5
"""Options in the ranking on a report's first screen, that without anything among them."""


def first_rows(rows: Sequence[RankingRow]) -> Sequence[RankingRow]:
    """Return the rows of a ranking that stand on the first screen."""
    bare = next(row for row in rows if not row.option.option.count)
    first = rows[:MOST_RANKED]
    return first if bare in first else [*rows[: MOST_RANKED - 1], bare]


def _sides(verdict: Verdict, member: Member, language: str) -> list[tuple[str, Run]]:
    """Return labels and runs of what is shown side by side: no measure, and the best one, if it is one."""
    return [
        (title(result.option, verdict, language), drawn_run(verdict.scenario, result.option, member))
        for result in _compared(verdict)
    ]


def _compared(verdict: Verdict) -> list[OptionVerdict]:
    """Return the option that the others are compared with, and the best one if it is another."""
    return [verdict.without] if verdict.best is verdict.without else [verdict.without, verdict.best]


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


def curves_image(verdict: Verdict, language: str) -> str:
    """Return the curves of a verdict over JMA's intensity, or a floor's, as the address of an image."""
    return embedded(plot_options(verdict, JMA_INTENSITY, language=language), "svg")


def drawing(verdict: Verdict, result: OptionVerdict, language: str) -> str:
    """Return a drawing of a lone piece with measures, in the colour of how firmly it stands, as an image."""
    held = hold(verdict.scenario.piece.body(), verdict.scenario.room.room(), result.option.measures)
    stands = result.pieces[0].stability
    figure = figure_of(lambda axis: draw_section(axis, held, language, stands=stands), 2.6, 3.2)
    return embedded(figure, "svg")
