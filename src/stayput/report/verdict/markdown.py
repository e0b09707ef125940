"""A verdict as Markdown."""

from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING

import stayput
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.numbers import NO_NUMBER, length, with_interval
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
from stayput.report.verdict.words import word
from stayput.verification.words import headline, title
from stayput.wording import with_aside

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

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
    return "\n".join(_lines(verdict, language)) + "\n"


def _lines(verdict: Verdict, language: str) -> Iterator[str]:
    text = partial(word, language=language)
    yield f"# {plain(verdict.scenario.title or text('report'))}"
    yield f"\n**{plain(headline(verdict, language))}**\n"
    for note in verdict.notes(language):
        yield f"{plain(note)}\n"
    yield simulations(verdict, language)
    if verdict.motions == 1:
        yield f"\n{text('one_motion')}"
    if not verdict.precise:
        yield f"\n{text('not_precise')}"
    yield f"\n## {text('ranking')}\n"
    columns = _columns(verdict, language)
    rows = [_cells(row, language) for row in ranking(verdict, language)]
    for label, reason in impossible_rows(verdict, language):
        blank = (NO_NUMBER,) * (len(columns) - 4)
        rows.append((NO_NUMBER, label, text("not_possible"), *blank, reason))
    yield from table(columns, rows)
    yield f"\n{plain(grades_text(language))}"
    devices = [
        (title(result.option, verdict, language), *row)
        for result in verdict.options
        for row in device_rows(result, language)
    ]
    if devices:
        yield f"\n## {text('devices')}\n"
        yield from table((text("measure"), *(text(key) for key in DEVICE_COLUMNS)), devices)
    yield f"\n## {text('estimates')}\n"
    yield f"{text('estimates_text')}\n"
    yield from table((text("formula"), text("says"), text("beside")), estimate_rows(verdict, language))
    yield f"\n## {text('assumptions')}\n"
    heading = (text("assumption"), text("value"), text("confidence"))
    yield from table(
        heading,
        ((a.what(language), a.value(language), text(a.confidence)) for a in assumptions(verdict)),
    )
    yield f"\n## {text('again')}\n"
    yield text("again_text", file="scenario.toml", version=stayput.__version__)
    yield "\n```toml"
    yield verdict.scenario.to_toml().rstrip()
    yield "```\n"
    yield text("caution")


def _columns(verdict: Verdict, language: str) -> tuple[str, ...]:
    far = length(verdict.slide_limit, language)
    return (
        word("rank", language),
        word("measure", language),
        word("overturned", language),
        word("slid", language, limit=far),
        word("hit_wall", language),
        word("device_failed", language),
        *((word("contents_out", language),) if verdict.without.contents is not None else ()),
        word("slide_both", language),
        *(word("capacity", language, share=f"{100.0 * share:g}") for share in SHARES),
        word("grade", language),
        word("why", language),
    )


def _cells(row: RankingRow, language: str) -> tuple[str, ...]:
    shares = tuple(
        NO_NUMBER if chance is None else with_interval(chance, language) for _, chance in row.shares
    )
    label = with_aside(row.name, row.label, language) if row.name else row.label
    capacities = (with_aside(middle, ends, language) if ends else middle for middle, ends in row.capacities)
    slide = word("listed", language).join(row.slide)
    contents = () if row.contents is None else (with_interval(row.contents, language),)
    return str(row.option.rank), label, *shares, *contents, slide, *capacities, row.grade, row.reason


def table(heading: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """Yield the lines of a table."""
    yield f"| {' | '.join(map(plain, heading))} |"
    yield f"|{' --- |' * len(heading)}"
    for row in rows:
        yield f"| {' | '.join(map(plain, row))} |"


def plain(text: str) -> str:
    """Return a text in which no character means something to Markdown or HTML, on one line."""
    one_line = " ".join(text.split())
    return re.sub(r"([\\`*_\[\]<>|#~])", r"\\\1", one_line)
