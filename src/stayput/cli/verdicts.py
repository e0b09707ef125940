"""Verdicts on the terminal: on one piece, on several, on a room."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from rich.cells import cell_len
from rich.padding import Padding
from rich.table import Table

from stayput.catalogue import say
from stayput.cli.messages import folded, plain_table, terminal
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY
from stayput.montecarlo.counting import EVENTS, OVERTURNED
from stayput.report.room.report import sentences, simulations_of_room, tables
from stayput.report.verdict import numbers
from stayput.report.verdict.numbers import NO_NUMBER, word
from stayput.report.verdict.tables import (
    SHARES,
    grades_text,
    impossible_rows,
    ranking,
    simulations,
)
from stayput.rooms.verdict import RoomVerdict
from stayput.verification.words import title
from stayput.wording import with_aside

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from rich.console import Console

    from stayput.fragility.probabilities import Probability
    from stayput.rooms.verdict import ChangeVerdict
    from stayput.verification import Verdict

_NEXT = 3
"""How many changes of a room are listed after those that help."""


def print_verdict(verdict: Verdict | RoomVerdict, lang: str) -> None:
    """Print a verdict.

    Parameters
    ----------
    verdict : Verdict or RoomVerdict
        The verdict.
    lang : str
        "en" or "ja".
    """
    if isinstance(verdict, RoomVerdict):
        _print_room(verdict, lang)
    else:
        _print_options(verdict, lang)


class _Line(NamedTuple):
    """A line of a ranking, and the sentence about it below the table."""

    rank: str
    brief: str
    cells: tuple[str, ...]
    title: str
    reason: str


def _print_options(verdict: Verdict, lang: str) -> None:
    text, alone = partial(word, language=lang), verdict.scenario.alone
    lines: list[_Line] = []
    for row in ranking(verdict, lang):
        result = row.option
        falls, *others = _shares(row.shares, lang)
        slide = _slide(row.slide[0], result.slide.median, lang)
        if alone:
            reached = (numbers.capacity(result.capacities.get(share), lang, brief=True) for share in SHARES)
            share = f"{falls} ({row.grade})"  # the grade of its inputs stands beside the number itself
            out = () if row.contents is None else (numbers.probability(row.contents, lang),)
            cells = (share, *others, *out, slide, *reached)
        else:
            each = (numbers.probability(chance, lang) for _, chance in row.pieces)
            cells = (falls, *others, slide, *each)
        ends = numbers.interval(result.probabilities[OVERTURNED], lang) if alone else ""
        label = title(result.option, verdict, lang)
        label = with_aside(label, ends, lang) if ends else label
        lines.append(_Line(str(result.rank), row.name or row.label, cells, label, row.reason))
    impossible = zip(impossible_rows(verdict, lang), verdict.impossible, strict=True)
    rejected = [
        (item.option.name if item.option.own_name else label, label, why) for (label, why), item in impossible
    ]
    events = _events(verdict, lang)
    if alone:
        capacities = (text("brief_capacity", share=f"{100.0 * share:g}") for share in SHARES)
        inside = (text("brief_contents_out"),) if verdict.without.contents is not None else ()
        headings = (text("measure"), *events, *inside, text("brief_slide"), *capacities)
        jma = FLOOR_JMA if verdict.floor else JMA_INTENSITY
        below = (text("brief_text", intensity=jma.names), grades_text(lang))
    else:
        headings = (say("several.option", lang), *events, text("brief_slide"), *verdict.scenario.names)
        below = (say("several.brief_text", lang),)
    _print_ranking(
        verdict,
        lang,
        headings,
        lines,
        rejected,
        above=verdict.sentence(lang),
        below=below,
        notes=verdict.notes(lang),
        end=simulations(verdict, lang),
        last=len(SHARES) if alone else 0,
    )


def _events(verdict: Verdict, lang: str) -> list[str]:
    """Return the headings of the columns of events."""
    limit = numbers.length(verdict.slide_limit, lang)
    return [word(f"brief_{event}", lang, limit=limit) for event in EVENTS]


def _shares(shares: Iterable[tuple[Any, Probability | None]], lang: str) -> list[str]:
    return [NO_NUMBER if share is None else numbers.probability(share, lang) for _, share in shares]


def _slide(slide: str, median: float, lang: str) -> str:
    return word("brief_falls", lang) if math.isinf(median) else slide


def _print_ranking(
    verdict: Verdict,
    lang: str,
    headings: Sequence[str],
    lines: Sequence[_Line],
    rejected: Sequence[tuple[str, str, str]],
    *,
    above: str,
    below: Sequence[str],
    notes: Iterable[str] = (),
    end: str,
    last: int = 0,
) -> None:
    """Print the title, what is found, the table of options, and why each is where it is.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    lang : str
        "en" or "ja".
    headings : sequence of str
        What stands above the labels and the cells.
    lines : sequence of _Line
        The options.
    rejected : sequence of tuple of str
        Those that are not possible: in brief, in full, and why.
    above, below, notes, end
        Sentences above and below the table, below the reasons, and at the end.
    last : int
        How many of the last columns are left out where the table is wider than the terminal.
    """
    console, paragraph = terminal(lang, verdict.scenario.title)
    paragraph(above)
    rows = [(line.rank, line.brief, *line.cells) for line in lines]
    rows += [(NO_NUMBER, brief, word("brief_not_possible", lang)) for brief, _, _ in rejected]
    narrow = 12  # of the labels, which are folded
    folds = max(max(cell_len(row[1]) for row in rows) - narrow, 0)
    for shown in (len(headings), len(headings) - last):
        table = Table(box=None, padding=(0, 1, 0, 0))
        table.add_column("", justify="right")
        table.add_column(headings[0], min_width=narrow, overflow="fold")
        for heading in headings[1:shown]:
            table.add_column(heading, justify="right", no_wrap=last > 0, overflow="fold")
        for row in rows:
            table.add_row(*row[: shown + 1])
        if last == 0 or _width(table, console) - folds <= console.width:
            break
    console.print(table)  # pyright: ignore[reportPossiblyUnbound] - there is one of two
    for sentence in below:
        paragraph(sentence)
    colon = word("colon", lang)
    for line in lines:
        console.print(f"{line.rank}. {line.title}{colon}{line.reason}", soft_wrap=True)
    for _, label, why in rejected:
        console.print(f"{NO_NUMBER}  {colon.join((label, word('not_possible', lang), why))}", soft_wrap=True)
    for note in notes:
        console.print(note, soft_wrap=True)
    if verdict.motions == 1:
        paragraph(word("one_motion", lang))
    if not verdict.precise:
        paragraph(word("not_precise", lang))
    paragraph(end)


def _width(table: Table, console: Console) -> int:
    """Return the width of a table whose lines do not break [cells]."""
    return console.measure(table, options=console.options.update(max_width=10_000)).maximum


def _print_room(verdict: RoomVerdict, lang: str) -> None:
    """Print a verdict on a room: its sentences, who is hit by what, doors, and the first single changes."""
    console, paragraph = terminal(lang, verdict.scenario.title)
    for sentence in sentences(verdict, lang):
        paragraph(sentence)
    listed = _listed(verdict)
    for each in tables(replace(verdict, changes=listed), lang):
        if not each.rows:
            continue
        table = plain_table(each.headings, each.rows, gap=1, justify="right", overflow="fold")
        if _width(table, console) <= console.width:
            console.print(table)
        else:  # whose lines would break: a list instead
            for label, *values in each.rows:
                named = zip(each.headings[1:], values, strict=True)
                said = say("common.listed", lang).join(
                    f"{heading} {value}" for heading, value in named if value
                )
                if label:
                    paragraph(label)
                console.print(
                    Padding(folded(said, console.width - 2) if lang == "ja" else said, (0, 0, 0, 2))
                )
        if each.below:
            paragraph(each.below)
    if more := len(verdict.changes) - len(listed):
        paragraph(say("rooms.more_changes", lang, count=more))
    paragraph(simulations_of_room(verdict, lang))


def _listed(verdict: RoomVerdict) -> tuple[ChangeVerdict, ...]:
    """Return the changes that help and the next few; all where only one would be left out."""
    first = sorted(verdict.changes, key=lambda change: not change.helps)
    shown = sum(change.helps for change in first) + _NEXT
    return tuple(first if len(first) <= shown + 1 else first[:shown])
