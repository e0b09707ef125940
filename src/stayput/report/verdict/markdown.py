"""Verdicts on one piece and on several as Markdown."""

from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING

import stayput
from stayput.catalogue import say
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.numbers import NO_NUMBER, length, word
from stayput.report.verdict.tables import (
    DEVICE_COLUMNS,
    SHARES,
    device_rows,
    estimate_rows,
    grades_text,
    impossible_rows,
    ranking,
    simulations,
)
from stayput.verification.words import title
from stayput.wording import with_aside

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from stayput.report.verdict.assumptions import Assumption
    from stayput.report.verdict.tables import RankingRow
    from stayput.verification import Verdict


def verdict_markdown(verdict: Verdict, language: str = "en") -> str:
    """Return a verdict as a text in Markdown.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    text, of_several = partial(word, language=language), partial(say, language=language)
    alone, rows = verdict.scenario.alone, ranking(verdict, language)
    devices = [
        (title(row.option.option, verdict, language), *each)
        for row in rows
        for each in device_rows(row.option, language)
    ]
    if alone:
        contents = (text("contents_out"),) if verdict.without.contents is not None else ()
        option, any_piece, kind = text("measure"), text("overturned"), text("report")
        capacities = (text("capacity", share=f"{100.0 * share:g}") for share in SHARES)
        further = *contents, text("slide_both"), *capacities, text("grade"), text("why")
        about, below = "", f"\n{plain(grades_text(language))}"
        held, heading = (option,), text("devices")
    else:
        option, any_piece, kind = (
            of_several("several.option"),
            of_several("several.any"),
            of_several("several.report"),
        )
        further = of_several("several.each"), text("slide_both"), text("why")
        about, below = f"{of_several('several.about')}\n", ""
        held, heading = (option, of_several("several.holds")), of_several("several.details")
    estimates: tuple[str, ...] = ()
    if verdict.estimates is not None:
        rows_of_formulas = table(
            (text("formula"), text("says"), text("beside")), estimate_rows(verdict, language)
        )
        estimates = _section(text("estimates"), f"{text('estimates_text')}\n", *rows_of_formulas)
    return _text(
        *_head(verdict, kind, verdict.sentence(language), language),
        *filter(None, [about]),
        *(f"{plain(note)}\n" for note in verdict.notes(language)),
        *_runs(verdict, language),
        *_ranking(verdict, (*_events(verdict, option, any_piece, language), *further), rows, language),
        *filter(None, [below]),
        *_devices(heading, held, devices, language),
        *estimates,
        *_foot(verdict, assumptions(verdict), language),
    )


def _text(*lines: str) -> str:
    return "\n".join(lines) + "\n"


def _section(heading: str, *lines: str) -> tuple[str, ...]:
    return f"\n## {heading}\n", *lines


def _head(verdict: Verdict, kind: str, said: str, language: str) -> tuple[str, str]:
    return f"# {plain(verdict.scenario.title or kind)}", f"\n**{plain(said)}**\n"


def _runs(verdict: Verdict, language: str) -> Iterator[str]:
    """Yield how many runs were made, and what they do not tell."""
    yield simulations(verdict, language)
    if verdict.motions == 1:
        yield f"\n{word('one_motion', language)}"
    if not verdict.precise:
        yield f"\n{word('not_precise', language)}"


def _events(verdict: Verdict, option: str, falls: str, language: str) -> tuple[str, ...]:
    """Return the headings of rank, option and events in a ranking."""
    text = partial(word, language=language)
    slid = text("slid", limit=length(verdict.slide_limit, language))
    return text("rank"), option, falls, slid, text("hit_wall"), text("device_failed")


def _ranking(
    verdict: Verdict, columns: Sequence[str], rows: Sequence[RankingRow], language: str
) -> tuple[str, ...]:
    """Return the section of the ranking, with what cannot be put in place at its end."""
    lines = [_cells(row, not verdict.scenario.alone, language) for row in rows]
    blank = (NO_NUMBER,) * (len(columns) - 4)
    impossible = [
        (NO_NUMBER, label, word("not_possible", language), *blank, reason)
        for label, reason in impossible_rows(verdict, language)
    ]
    return _section(word("ranking", language), *table(columns, [*lines, *impossible]))


def _devices(
    heading: str, first: Sequence[str], rows: Sequence[Sequence[str]], language: str
) -> tuple[str, ...]:
    columns = (*first, *(word(key, language) for key in DEVICE_COLUMNS))
    return _section(heading, *table(columns, rows)) if rows else ()


def _foot(verdict: Verdict, rests_on: Iterable[Assumption], language: str) -> Iterator[str]:
    """Yield the assumptions, and how to do it again."""
    text = partial(word, language=language)
    rows = [(what, value, text(confidence)) for what, value, confidence in told(rests_on, language)]
    columns = (text("assumption"), text("value"), text("confidence"))
    yield from _section(text("assumptions"), *table(columns, rows))
    yield from _section(text("again"), text("again_text", file="scenario.toml", version=stayput.__version__))
    yield f"\n```toml\n{verdict.scenario.to_toml().rstrip()}\n```\n"
    yield text("caution")


def _cells(row: RankingRow, several: bool, language: str) -> tuple[str, ...]:
    listed = word("listed", language)
    shares = [NO_NUMBER if chance is None else say(chance.texts, language) for _, chance in row.shares]
    head, slide = (str(row.option.rank), row.label, *shares), listed.join(row.slide)
    if several:
        each = listed.join(f"{name} {say(chance.texts, language)}" for name, chance in row.pieces)
        return *head, each, slide, row.reason
    label = with_aside(row.name, row.label, language) if row.name else row.label
    contents = () if row.contents is None else (say(row.contents.texts, language),)
    capacities = (with_aside(middle, ends, language) if ends else middle for middle, ends in row.capacities)
    return head[0], label, *shares, *contents, slide, *capacities, row.grade, row.reason


def table(heading: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Yield the lines of a table."""
    yield f"| {' | '.join(map(plain, heading))} |"
    yield f"|{' --- |' * len(heading)}"
    for row in rows:
        yield f"| {' | '.join(map(plain, row))} |"


def plain(text: str) -> str:
    """Return a text in which no character means something to Markdown or HTML, on one line."""
    one_line = " ".join(text.split())
    return re.sub(r"([\\`*_\[\]<>|#~])", r"\\\1", one_line)
