"""A verdict as Markdown."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import stayput
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.estimates import estimate_rows
from stayput.report.verdict.numbers import NO_NUMBER, length, with_interval
from stayput.report.verdict.tables import DEVICE_COLUMNS, SHARES, device_rows, ranking, simulations
from stayput.report.verdict.words import word
from stayput.scenario.writing import scenario_toml
from stayput.verification.words import headline, title

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from stayput.report.verdict.tables import Row
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
    def told(key: str, **values: object) -> str:
        return word(key, language, **values)

    yield f"# {_plain(verdict.scenario.title or told('report'))}"
    yield f"\n**{_plain(headline(verdict, language))}**\n"
    yield simulations(verdict, language)
    if verdict.motions == 1:
        yield f"\n{told('one motion')}"
    if not verdict.precise:
        yield f"\n{told('not precise')}"
    yield f"\n## {told('ranking')}\n"
    yield from _table(
        _columns(verdict, language), (_cells(row, language) for row in ranking(verdict, language))
    )
    devices = [
        (title(one.option, verdict, language), *row)
        for one in verdict.options
        for row in device_rows(one, language)
    ]
    if devices:
        yield f"\n## {told('devices')}\n"
        yield from _table((told("measure"), *(told(key) for key in DEVICE_COLUMNS)), devices)
    yield f"\n## {told('estimates')}\n"
    yield f"{told('estimates told')}\n"
    yield from _table((told("formula"), told("says"), told("beside")), estimate_rows(verdict, language))
    yield f"\n## {told('assumptions')}\n"
    heading = (told("assumption"), told("value"), told("confidence"))
    yield from _table(
        heading,
        ((one.what(language), one.value(language), told(one.confidence)) for one in assumptions(verdict)),
    )
    yield f"\n## {told('again')}\n"
    yield told("again told", file="scenario.toml", version=stayput.__version__)
    yield "\n```toml"
    yield scenario_toml(verdict.scenario).rstrip()
    yield "```\n"
    yield told("caution")


def _columns(verdict: Verdict, language: str) -> tuple[str, ...]:
    far = length(verdict.slide_limit, language)
    return (
        word("rank", language),
        word("measure", language),
        word("overturned", language),
        word("slid", language, limit=far),
        word("hit_wall", language),
        word("device_failed", language),
        word("slide both", language),
        *(word("capacity", language, share=f"{100.0 * share:g}") for share in SHARES),
        word("why", language),
    )


def _cells(row: Row, language: str) -> tuple[str, ...]:
    shares = tuple(NO_NUMBER if found is None else with_interval(found, language) for _, found in row.shares)
    label = f"{row.label} ({row.name})" if row.name else row.label
    capacities = (f"{middle} ({ends})" if ends else middle for middle, ends in row.capacities)
    return str(row.option.rank), label, *shares, ", ".join(row.slide), *capacities, row.reason


def _table(heading: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    yield f"| {' | '.join(map(_plain, heading))} |"
    yield f"|{' --- |' * len(heading)}"
    for row in rows:
        yield f"| {' | '.join(map(_plain, row))} |"


def _plain(text: str) -> str:
    """Return a text in which no character means something to Markdown or HTML, on one line."""
    one_line = " ".join(text.split())
    return re.sub(r"([\\`*_\[\]<>|#~])", r"\\\1", one_line)
