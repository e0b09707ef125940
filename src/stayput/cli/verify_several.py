"""A verdict on several pieces on the terminal."""

from __future__ import annotations

import math
from functools import partial
from typing import TYPE_CHECKING

from stayput.cli.messages import folded

if TYPE_CHECKING:
    from stayput.verification import AssemblyVerdict


def print_several(verdict: AssemblyVerdict, lang: str) -> None:
    """Print a verdict on several pieces: its sentence, a table of the options, and why each is where it is.

    Parameters
    ----------
    verdict : AssemblyVerdict
        The verdict.
    lang : str
        "en" or "ja".
    """
    from rich.console import Console
    from rich.table import Table

    from stayput.catalogue import say
    from stayput.report.several.tables import rejected_rows, several_rows, simulations_of_several
    from stayput.report.verdict import numbers
    from stayput.report.verdict.words import word
    from stayput.verification import EVENTS
    from stayput.verification.several_words import headline_of_several

    text = partial(word, language=lang)
    console = Console(highlight=False, markup=False)

    def paragraph(sentences: str) -> None:
        console.print(folded(sentences, console.width) if lang == "ja" else sentences)

    if verdict.scenario.title is not None:
        console.print(verdict.scenario.title, style="bold")
    paragraph(headline_of_several(verdict, lang))
    table = Table(box=None, padding=(0, 1, 0, 0))
    table.add_column("", justify="right")
    table.add_column(say("several.option", lang), min_width=12, overflow="fold")
    limit = numbers.length(verdict.slide_limit, lang)
    events = (text(f"brief_{event}", limit=limit) for event in EVENTS)
    for heading in (*events, text("brief_slide"), *verdict.scenario.names):
        table.add_column(heading, justify="right", overflow="fold")
    rows = several_rows(verdict, lang)
    for row in rows:
        shares = (
            numbers.NO_NUMBER if chance is None else numbers.probability(chance, lang)
            for _, chance in row.shares
        )
        slide = text("brief_falls") if math.isinf(row.result.slide.median) else row.slide[0]
        each = (numbers.probability(chance, lang) for _, chance in row.pieces)
        table.add_row(str(row.result.rank), row.brief, *shares, slide, *each)
    rejected = rejected_rows(verdict, lang)
    for label, _ in rejected:
        table.add_row(numbers.NO_NUMBER, label, text("brief_not_possible"))
    console.print(table)
    paragraph(say("several.brief_text", lang))
    colon = text("colon")
    for row in rows:
        console.print(f"{row.result.rank}. {row.title}{colon}{row.reason}", soft_wrap=True)
    for label, why in rejected:
        console.print(
            f"{numbers.NO_NUMBER}  {label}{colon}{text('not_possible')}{colon}{why}", soft_wrap=True
        )
    if verdict.motions == 1:
        paragraph(text("one_motion"))
    if not verdict.precise:
        paragraph(text("not_precise"))
    paragraph(simulations_of_several(verdict, lang))
