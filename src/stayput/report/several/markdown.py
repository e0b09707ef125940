"""A verdict on several pieces as Markdown."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import stayput
from stayput.catalogue import say
from stayput.report.several.tables import (
    rejected_rows,
    several_assumptions,
    several_device_rows,
    several_rows,
    simulations_of_several,
)
from stayput.report.verdict.markdown import plain, table
from stayput.report.verdict.numbers import NO_NUMBER, length, with_interval
from stayput.report.verdict.tables import DEVICE_COLUMNS
from stayput.report.verdict.words import word
from stayput.verification.words import headline_of_several

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.report.several.tables import SeveralRow
    from stayput.verification import AssemblyVerdict


def several_markdown(verdict: AssemblyVerdict, language: str = "en") -> str:
    """Return a verdict on several pieces as a text in Markdown.

    Parameters
    ----------
    verdict : AssemblyVerdict
        The verdict.
    language : str
        "en" or "ja".
    """
    return "\n".join(_lines(verdict, language)) + "\n"


def _lines(verdict: AssemblyVerdict, language: str) -> Iterator[str]:
    text, own = partial(word, language=language), partial(_own, language=language)
    yield f"# {plain(verdict.scenario.title or own('report'))}"
    yield f"\n**{plain(headline_of_several(verdict, language))}**\n"
    yield own("about")
    yield f"\n{simulations_of_several(verdict, language)}"
    if verdict.motions == 1:
        yield f"\n{text('one_motion')}"
    if not verdict.precise:
        yield f"\n{text('not_precise')}"
    yield f"\n## {text('ranking')}\n"
    limit = length(verdict.slide_limit, language)
    columns = (
        text("rank"),
        own("option"),
        own("any"),
        text("slid", limit=limit),
        text("hit_wall"),
        text("device_failed"),
        own("each"),
        text("slide_both"),
        text("why"),
    )
    rows = [_cells(row, language) for row in several_rows(verdict, language)]
    for title, reason in rejected_rows(verdict, language):
        rows.append((NO_NUMBER, title, text("not_possible"), *(NO_NUMBER,) * 5, reason))
    yield from table(columns, rows)
    devices = [
        (row.title, *cells)
        for row in several_rows(verdict, language)
        for cells in several_device_rows(row.result, language)
    ]
    if devices:
        yield f"\n## {own('details')}\n"
        heading = (own("option"), own("holds"), *(text(key) for key in DEVICE_COLUMNS))
        yield from table(heading, devices)
    yield f"\n## {text('assumptions')}\n"
    heading = (text("assumption"), text("value"), text("confidence"))
    entries = several_assumptions(verdict)
    yield from table(heading, ((a.what(language), a.value(language), text(a.confidence)) for a in entries))
    yield f"\n## {text('again')}\n"
    yield text("again_text", file="scenario.toml", version=stayput.__version__)
    yield "\n```toml"
    yield verdict.scenario.to_toml().rstrip()
    yield "```\n"
    yield text("caution")


def _own(key: str, language: str) -> str:
    return say(f"several.{key}", language)


def _cells(row: SeveralRow, language: str) -> tuple[str, ...]:
    shares = (NO_NUMBER if chance is None else with_interval(chance, language) for _, chance in row.shares)
    listed = word("listed", language)
    each = listed.join(f"{name} {with_interval(chance, language)}" for name, chance in row.pieces)
    return str(row.result.rank), row.title, *shares, each, listed.join(row.slide), row.reason
