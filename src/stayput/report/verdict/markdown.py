"""Verdicts on one piece and on several as Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

import stayput
from stayput.catalogue import say
from stayput.report.verdict import tables
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.numbers import NO_NUMBER, word, word_of
from stayput.verification.words import title
from stayput.wording import with_aside

if TYPE_CHECKING:
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
    return "\n".join(_lines(verdict, language)) + "\n"


def _lines(verdict: Verdict, language: str) -> Iterator[str]:
    """Yield the text in pieces of one or more lines."""
    text, text_of = partial(word, language=language), partial(word_of, verdict, language=language)
    alone, rows = verdict.scenario.alone, tables.ranking(verdict, language)
    yield f"# {plain(verdict.scenario.title or text_of('report'))}"
    yield f"\n**{plain(verdict.sentence(language))}**\n"
    if not alone:
        yield f"{text_of('about')}\n"
    yield from (f"{plain(note)}\n" for note in verdict.notes(language))
    yield tables.simulations(verdict, language)
    if verdict.motions == 1:
        yield f"\n{text('one_motion')}"
    if not verdict.precise:
        yield f"\n{text('not_precise')}"

    columns = [text("rank"), text_of("measure"), *tables.event_headings(verdict, language)]
    if alone:
        contents = () if verdict.without.contents is None else (text("contents_out"),)
        capacities = (text("capacity", share=f"{100.0 * share:g}") for share in tables.SHARES)
        columns += [*contents, text("slide_both"), *capacities, text("grade"), text("why")]
    else:
        columns += [text_of("each"), text("slide_both"), text("why")]
    blank = (NO_NUMBER,) * (len(columns) - 4)
    impossible = [
        (NO_NUMBER, label, text("not_possible"), *blank, reason)
        for label, reason in tables.impossible_rows(verdict, language)
    ]
    ranked = [_cells(row, alone, language) for row in rows]
    yield from _section(text("ranking"), *table(columns, [*ranked, *impossible]))
    if alone:
        yield f"\n{plain(tables.grades_text(language))}"

    devices = [
        (title(row.option.option, verdict, language), *each)
        for row in rows
        for each in tables.device_rows(row.option, language)
    ]
    if devices:
        holds, heading = ((), text("devices")) if alone else ((text_of("holds"),), text_of("details"))
        columns = (text_of("measure"), *holds, *map(text, tables.DEVICE_COLUMNS))
        yield from _section(heading, *table(columns, devices))
    if verdict.estimates is not None:
        columns = (text("formula"), text("says"), text("beside"))
        formulas = table(columns, tables.estimate_rows(verdict, language))
        yield from _section(text("estimates"), f"{text('estimates_text')}\n", *formulas)
    columns = (text("assumption"), text("value"), text("confidence"))
    rests_on = (
        (what, value, text(confidence)) for what, value, confidence in told(assumptions(verdict), language)
    )
    yield from _section(text("assumptions"), *table(columns, rests_on))
    yield from _section(text("again"), text("again_text", file="scenario.toml", version=stayput.__version__))
    yield f"\n```toml\n{verdict.scenario.to_toml().rstrip()}\n```\n"
    yield text("caution")


def _section(heading: str, *lines: str) -> tuple[str, ...]:
    return f"\n## {heading}\n", *lines


def _cells(row: tables.RankingRow, alone: bool, language: str) -> tuple[str, ...]:
    """Return a row of the ranking as its cells."""
    listed, label = word("listed", language), row.label
    if alone and row.name:
        label = with_aside(row.name, label, language)
    shares = [NO_NUMBER if chance is None else say(chance.texts, language) for _, chance in row.shares]
    contents = () if row.contents is None else (say(row.contents.texts, language),)
    pieces = [f"{name} {say(chance.texts, language)}" for name, chance in row.pieces]
    each = () if alone else (listed.join(pieces),)
    capacities = (with_aside(middle, ends, language) if ends else middle for middle, ends in row.capacities)
    grade = (row.grade,) if alone else ()
    head = str(row.option.rank), label, *shares
    return *head, *contents, *each, listed.join(row.slide), *capacities, *grade, row.reason


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
