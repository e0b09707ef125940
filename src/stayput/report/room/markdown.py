"""A verdict on a room as Markdown."""

from __future__ import annotations

from typing import TYPE_CHECKING

import stayput
from stayput.catalogue import say
from stayput.report.room.tables import sentences, simulations_of_room, tables
from stayput.report.verdict.markdown import plain, table

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.rooms.verdict import RoomVerdict


def room_markdown(verdict: RoomVerdict, language: str = "en") -> str:
    """Return a verdict on a room as a text in Markdown, in "en" or "ja"."""
    return "\n".join(_lines(verdict, language)) + "\n"


def _lines(verdict: RoomVerdict, language: str) -> Iterator[str]:
    yield f"# {plain(verdict.scenario.title or say('rooms.report', language))}"
    first, *others = sentences(verdict, language)
    yield f"\n**{plain(first)}**"
    for sentence in others:
        yield f"\n{plain(sentence)}"
    for each in tables(verdict, language):
        if each.rows:
            yield ""
            yield from table(each.headings, each.rows)
            if each.below:
                yield f"\n{each.below}"
    yield f"\n{simulations_of_room(verdict, language)}"
    yield f"\nstayput {stayput.__version__}"
