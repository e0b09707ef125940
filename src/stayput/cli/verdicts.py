"""Verdicts on the terminal: on one piece, on several, on a room."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.cli.messages import folded

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from rich.console import Console
    from rich.table import Table

    from stayput.rooms.verdict import ChangeVerdict, RoomVerdict
    from stayput.verification import AssemblyVerdict, Verdict

_NEXT = 3
"""How many changes of a room are listed after those that help."""


def print_verdict(verdict: Verdict | AssemblyVerdict | RoomVerdict, lang: str) -> None:
    """Print a verdict.

    Parameters
    ----------
    verdict : Verdict, AssemblyVerdict or RoomVerdict
        The verdict.
    lang : str
        "en" or "ja".
    """
    from stayput.rooms.verdict import RoomVerdict
    from stayput.verification import AssemblyVerdict

    if isinstance(verdict, RoomVerdict):
        _print_room(verdict, lang)
    elif isinstance(verdict, AssemblyVerdict):
        _print_several(verdict, lang)
    else:
        _print_one(verdict, lang)


def _titled(title: str | None, lang: str) -> tuple[Console, Callable[[str], None]]:
    """Print a title; return the terminal, and what prints a paragraph on it."""
    from rich.console import Console

    console = Console(highlight=False, markup=False)
    if title is not None:
        console.print(title, style="bold")
    return console, lambda told: console.print(folded(told, console.width) if lang == "ja" else told)


def _print_one(verdict: Verdict, lang: str) -> None:
    from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY
    from stayput.montecarlo.counting import OVERTURNED
    from stayput.report.verdict import numbers
    from stayput.report.verdict.numbers import word
    from stayput.report.verdict.tables import SHARES, grades_text, impossible_rows, ranking, simulations
    from stayput.verification import EVENTS
    from stayput.verification.words import headline, title
    from stayput.wording import with_aside

    text = partial(word, language=lang)
    console, paragraph = _titled(verdict.scenario.title, lang)
    paragraph(headline(verdict, lang))
    limit = numbers.length(verdict.slide_limit, lang)
    events = (text(f"brief_{event}", limit=limit) for event in EVENTS)
    capacities = (text("brief_capacity", share=f"{100.0 * share:g}") for share in SHARES)
    inside = (text("brief_contents_out"),) if verdict.without.contents is not None else ()
    headings = (*events, *inside, text("brief_slide"), *capacities)
    rows, lines = ranking(verdict, lang), list[tuple[str, ...]]()
    for row in rows:
        falls, *others = (
            numbers.NO_NUMBER if chance is None else numbers.probability(chance, lang)
            for _, chance in row.shares
        )
        result = row.option
        reached = (numbers.capacity(result.capacities.get(share), lang, brief=True) for share in SHARES)
        slide = text("brief_falls") if math.isinf(result.slide.median) else row.slide[0]
        share = f"{falls} ({row.grade})"  # the grade of its inputs stands beside the number itself
        out = () if row.contents is None else (numbers.probability(row.contents, lang),)
        lines.append((str(result.rank), row.name or row.label, share, *others, *out, slide, *reached))
    impossible = impossible_rows(verdict, lang)
    for (label, _), rejected in zip(impossible, verdict.impossible, strict=True):
        name = rejected.option.name if rejected.option.own_name else label
        lines.append((numbers.NO_NUMBER, name, text("brief_not_possible")))
    console.print(_fitting(text("measure"), headings, lines, len(SHARES), console))
    paragraph(text("brief_text", intensity=(FLOOR_JMA if verdict.floor else JMA_INTENSITY).names))
    paragraph(grades_text(lang))
    colon = text("colon")
    for row in rows:
        ends = numbers.interval(row.option.probabilities[OVERTURNED], lang)
        label = title(row.option.option, verdict, lang)
        label = with_aside(label, ends, lang) if ends else label
        console.print(f"{row.option.rank}. {label}{colon}{row.reason}", soft_wrap=True)
    for label, why in impossible:
        console.print(
            f"{numbers.NO_NUMBER}  {label}{colon}{text('not_possible')}{colon}{why}", soft_wrap=True
        )
    for note in verdict.notes(lang):
        console.print(note, soft_wrap=True)
    if verdict.motions == 1:
        paragraph(text("one_motion"))
    if not verdict.precise:
        paragraph(text("not_precise"))
    paragraph(simulations(verdict, lang))


def _fitting(
    label: str, headings: tuple[str, ...], lines: Sequence[tuple[str, ...]], last: int, console: Console
) -> Table:
    """Return the table of a ranking, without its last columns where it is wider than the terminal."""
    from rich.cells import cell_len
    from rich.table import Table

    narrow = 12  # of the labels, which are folded
    folds = max(max(cell_len(line[1]) for line in lines) - narrow, 0)
    for shown in (headings, headings[:-last]):
        table = Table(box=None, padding=(0, 1, 0, 0))
        table.add_column("", justify="right")
        table.add_column(label, min_width=narrow, overflow="fold")
        for heading in shown:
            table.add_column(heading, justify="right", no_wrap=True, overflow="fold")
        for line in lines:
            table.add_row(*line[: len(shown) + 2])
        if (
            console.measure(table, options=console.options.update(max_width=10_000)).maximum - folds
            <= console.width
        ):
            break
    return table


def _print_several(verdict: AssemblyVerdict, lang: str) -> None:
    """Print a verdict on several pieces: its sentence, a table of options, and why each is where it is."""
    from rich.table import Table

    from stayput.report.verdict import numbers
    from stayput.report.verdict.numbers import word
    from stayput.report.verdict.tables import impossible_rows, several_ranking, simulations
    from stayput.verification import EVENTS
    from stayput.verification.words import headline_of_several

    text = partial(word, language=lang)
    console, paragraph = _titled(verdict.scenario.title, lang)
    paragraph(headline_of_several(verdict, lang))
    table = Table(box=None, padding=(0, 1, 0, 0))
    table.add_column("", justify="right")
    table.add_column(say("several.option", lang), min_width=12, overflow="fold")
    limit = numbers.length(verdict.slide_limit, lang)
    events = (text(f"brief_{event}", limit=limit) for event in EVENTS)
    for heading in (*events, text("brief_slide"), *verdict.scenario.names):
        table.add_column(heading, justify="right", overflow="fold")
    rows = several_ranking(verdict, lang)
    for row in rows:
        shares = (
            numbers.NO_NUMBER if chance is None else numbers.probability(chance, lang)
            for _, chance in row.shares
        )
        slide = text("brief_falls") if math.isinf(row.option.slide.median) else row.slide[0]
        each = (numbers.probability(chance, lang) for _, chance in row.pieces)
        table.add_row(str(row.option.rank), row.brief, *shares, slide, *each)
    rejected = impossible_rows(verdict, lang)
    for label, _ in rejected:
        table.add_row(numbers.NO_NUMBER, label, text("brief_not_possible"))
    console.print(table)
    paragraph(say("several.brief_text", lang))
    colon = text("colon")
    for row in rows:
        console.print(f"{row.option.rank}. {row.label}{colon}{row.reason}", soft_wrap=True)
    for label, why in rejected:
        console.print(
            f"{numbers.NO_NUMBER}  {label}{colon}{text('not_possible')}{colon}{why}", soft_wrap=True
        )
    if verdict.motions == 1:
        paragraph(text("one_motion"))
    if not verdict.precise:
        paragraph(text("not_precise"))
    paragraph(simulations(verdict, lang))


def _print_room(verdict: RoomVerdict, lang: str) -> None:
    """Print a verdict on a room: its sentences, who is hit by what, doors, and the first single changes."""
    from rich.padding import Padding
    from rich.table import Table

    from stayput.report.room.tables import sentences, simulations_of_room, tables

    console, paragraph = _titled(verdict.scenario.title, lang)
    for sentence in sentences(verdict, lang):
        paragraph(sentence)
    listed = _listed(verdict)
    for each in tables(replace(verdict, changes=listed), lang):
        if not each.rows:
            continue
        table = Table(box=None, padding=(0, 1, 0, 0))
        for number, heading in enumerate(each.headings):
            table.add_column(heading, justify="left" if number == 0 else "right", overflow="fold")
        for row in each.rows:
            table.add_row(*row)
        # a table whose lines would break becomes a list
        if console.measure(table, options=console.options.update(max_width=10_000)).maximum <= console.width:
            console.print(table)
        else:
            for row in each.rows:
                label, *values = row
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
    first = sorted(verdict.changes, key=lambda one: not one.helps)
    shown = sum(one.helps for one in first) + _NEXT
    return tuple(first if len(first) <= shown + 1 else first[:shown])
