"""A verdict on a room on the terminal."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from stayput.cli.messages import folded

if TYPE_CHECKING:
    from stayput.rooms.verdict import ChangeVerdict, RoomVerdict

_NEXT = 3
"""How many changes are listed after those that help."""


def print_room(verdict: RoomVerdict, lang: str) -> None:
    """Print a verdict on a room: its sentences, who is hit by what, doors, and the first single changes.

    Parameters
    ----------
    verdict : RoomVerdict
        The verdict.
    lang : str
        "en" or "ja".
    """
    from rich.console import Console
    from rich.padding import Padding
    from rich.table import Table

    from stayput.catalogue import say
    from stayput.report.room.tables import sentences, simulations_of_room, tables

    console = Console(highlight=False, markup=False)

    def paragraph(told: str) -> None:
        console.print(folded(told, console.width) if lang == "ja" else told)

    if verdict.scenario.title is not None:
        console.print(verdict.scenario.title, style="bold")
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
