"""Verdicts on the terminal: on one piece, on several, on a room."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from rich.cells import cell_len
from rich.padding import Padding
from rich.table import Table

from stayput.catalogue import say
from stayput.cli.messages import folded, plain_table, terminal
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY
from stayput.montecarlo.counting import EVENTS, OVERTURNED
from stayput.report.room.report import sections, sentences, simulations_of_room
from stayput.report.verdict import numbers
from stayput.report.verdict.numbers import NO_NUMBER, word
from stayput.report.verdict.tables import SHARES, impossible_rows, ranking, simulations
from stayput.verification.words import title
from stayput.wording import with_aside

if TYPE_CHECKING:
    from rich.console import Console

    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

_NEXT = 3
"""How many changes of a room are listed after those that help."""


def print_verdict(verdict: Verdict, lang: str) -> None:
    """Print a verdict.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    lang : str
        "en" or "ja".
    """
    if verdict.scenario.plan is not None:
        _print_room(verdict, lang)
    else:
        _print_options(verdict, lang)


def _print_options(verdict: Verdict, lang: str) -> None:
    """Print the title, what is found, the table of options, and why each is where it is."""
    text = partial(word, language=lang)
    alone, colon = verdict.scenario.alone, text("colon")
    rows: list[tuple[str, ...]] = []
    reasons: list[str] = []
    for row in ranking(verdict, lang):
        result = row.option
        falls, *others = (
            NO_NUMBER if share is None else numbers.probability(share, lang) for _, share in row.shares
        )
        out = () if row.contents is None else (numbers.probability(row.contents, lang),)
        slide = text("brief_falls") if math.isinf(result.slide.median) else row.slide[0]
        label = title(result.option, verdict, lang)
        if alone:
            last = [numbers.capacity(result.capacities.get(share), lang) for share in SHARES]
            if ends := numbers.interval(result.probabilities[OVERTURNED], lang):
                label = with_aside(label, ends, lang)
        else:
            last = [numbers.probability(chance, lang) for _, chance in row.pieces]
        rows.append((str(result.rank), row.name or row.label, falls, *others, *out, slide, *last))
        reasons.append(f"{result.rank}. {label}{colon}{row.reason}")
    for (label, why), item in zip(impossible_rows(verdict, lang), verdict.impossible, strict=True):
        brief = item.option.name if item.option.own_name else label
        rows.append((NO_NUMBER, brief, text("brief_not_possible")))
        reasons.append(f"{NO_NUMBER}  {colon.join((label, text('not_possible'), why))}")
    limit = numbers.length(verdict.slide_limit, lang)
    events = [text(f"brief_{event}", limit=limit) for event in EVENTS]
    inside = () if verdict.without.contents is None else (text("brief_contents_out"),)
    capacities = [text("brief_capacity", share=f"{100.0 * share:g}") for share in SHARES]
    each = capacities if alone else verdict.scenario.names
    headings = (text("measure"), *events, *inside, text("brief_slide"), *each)
    jma = FLOOR_JMA if verdict.floor else JMA_INTENSITY
    console, paragraph = terminal(lang, verdict.scenario.title)
    paragraph(verdict.sentence(lang))
    trust, *notes = verdict.notes(lang)
    paragraph(trust)
    console.print(_ranked(headings, rows, console, len(SHARES) if alone else 0))
    if alone:
        paragraph(text("brief_text", intensity=jma.names))
    else:
        paragraph(say("several.brief_text", lang))
    for line in (*reasons, *notes):
        console.print(line, soft_wrap=True)
    if verdict.motions == 1:
        paragraph(text("one_motion"))
    if not verdict.precise:
        paragraph(text("not_precise"))
    paragraph(simulations(verdict, lang))


def _ranked(headings: Sequence[str], rows: Iterable[Sequence[str]], console: Console, last: int) -> Table:
    """Return the table of options, without the last so many columns where it is too wide with them."""
    narrow = 12  # of the labels, which are folded
    table = Table(box=None, padding=(0, 1, 0, 0))
    table.add_column("", justify="right")
    table.add_column(headings[0], min_width=narrow, overflow="fold")
    for heading in headings[1:]:
        table.add_column(heading, justify="right", no_wrap=last > 0, overflow="fold")
    for row in rows:
        table.add_row(*row)
    folds = max(max(cell_len(str(cell)) for cell in table.columns[1].cells) - narrow, 0)
    if last and _width(table, console) - folds > console.width:
        del table.columns[-last:]
    return table


def _width(table: Table, console: Console) -> int:
    """Return the width of a table whose lines do not break [cells]."""
    return console.measure(table, options=console.options.update(max_width=10_000)).maximum


def _print_room(verdict: Verdict, lang: str) -> None:
    """Print a verdict on a room: its sentences, who is hit by what, doors, and the first single changes."""
    console, paragraph = terminal(lang, verdict.scenario.title)
    trust, *notes = verdict.notes(lang)
    for sentence in (*sentences(verdict, lang), trust):
        paragraph(sentence)
    listed = _listed(verdict)
    for section in sections(verdict, listed, lang):
        if not section.rows:
            paragraph(section.about)
            continue
        rows = [tuple(cell.text(lang) for cell in row) for row in section.rows]
        table = plain_table(section.columns, rows, gap=1, justify="right")
        paragraph(section.title)
        if _width(table, console) <= console.width:
            console.print(table)
        else:  # whose lines would break: a list instead
            for label, *values in rows:
                named = zip(section.columns[1:], values, strict=True)
                said = say("common.listed", lang).join(f"{head} {value}" for head, value in named if value)
                paragraph(label)
                console.print(
                    Padding(folded(said, console.width - 2) if lang == "ja" else said, (0, 0, 0, 2))
                )
        if section.key == "what_hits":
            paragraph(say("rooms.upper_bounds", lang))
    if more := len(verdict.others) - len(listed):
        paragraph(say("rooms.more_changes", lang, count=more))
    for note in notes:
        paragraph(note)
    paragraph(simulations_of_room(verdict, lang))


def _listed(verdict: Verdict) -> tuple[OptionVerdict, ...]:
    """Return the options of a room that help and the next few; all where only one would be left out."""
    shown = sum(option.helps for option in verdict.others) + _NEXT
    return verdict.others if len(verdict.others) <= shown + 1 else verdict.others[:shown]
