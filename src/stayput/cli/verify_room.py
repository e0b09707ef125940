"""A verdict on a room on the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.cli.messages import folded

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.rooms.verdict import RoomVerdict


def print_room(verdict: RoomVerdict, lang: str, written: list[Path]) -> None:
    """Print a verdict on a room: its sentences, who is hit by what, doors, and single changes.

    Parameters
    ----------
    verdict : RoomVerdict
        The verdict.
    lang : str
        "en" or "ja".
    written : list of Path
        Files that were written.
    """
    from rich.console import Console
    from rich.table import Table

    from stayput.catalogue import phrase, say
    from stayput.report.verdict import numbers
    from stayput.rooms.words import best_sentence, change_label, door_name, place_name, sentence_of_room

    console = Console(highlight=False, markup=False)

    def text(key: str, **values: object) -> str:
        return say(f"rooms.{key}", lang, **values)

    def paragraph(sentences: str) -> None:
        if sentences:
            console.print(folded(sentences, console.width) if lang == "ja" else sentences)

    def table(*headings: str) -> Table:
        made = Table(box=None, padding=(0, 1, 0, 0))
        for number, heading in enumerate(headings):
            made.add_column(text(heading), justify="left" if number == 0 else "right", overflow="fold")
        return made

    if verdict.scenario.title is not None:
        console.print(verdict.scenario.title, style="bold")
    paragraph(sentence_of_room(verdict, lang))
    paragraph(best_sentence(verdict, lang))
    hits = table("who", "by", "chance", "day", "night", "speed", "energy", "mass")
    for place in verdict.places:
        shares = (numbers.share(one, lang) for one in (place.by_day, place.by_night))
        name = say(place_name(place.place), lang)
        hits.add_row(name, text("any_piece"), numbers.with_interval(place.hit, lang), *shares, "", "", "")
        for one in place.by:
            values = f"{one.speed.median:.1f} m/s", f"{one.energy.median:.3g} J", f"{one.mass:.4g} kg"
            hits.add_row("", one.piece, numbers.with_interval(one.probability, lang), "", "", *values)
    if verdict.places:
        console.print(hits)
        paragraph(text("upper_bounds"))
    ways = table("way", "chance")
    for door in verdict.doors:
        label = say(phrase("rooms.door_blocked", door=door_name(door.door)), lang)
        ways.add_row(label, numbers.with_interval(door.blocked, lang))
    for place in verdict.places:
        label = say(phrase("rooms.place_shut_in", place=place_name(place.place)), lang)
        ways.add_row(label, numbers.with_interval(place.shut_in, lang))
    if verdict.doors:
        console.print(ways)
        if any(door.at_rest for door in verdict.doors):
            paragraph(text("blocked_at_rest"))
    if verdict.changes:
        changes = table("change", "hit_then", "hit_less", "shut_in_then")
        for one in verdict.changes:
            changes.add_row(
                change_label(one.change, verdict, lang),
                numbers.with_interval(one.hit, lang),
                numbers.change(one.hit_change, lang),
                numbers.with_interval(one.shut_in, lang),
            )
        console.print(changes)
    paragraph(text("simulations", runs=f"{verdict.runs:,}", motions=verdict.motions, samples=verdict.samples))
    for path in written:
        console.print(f"Wrote {path}", soft_wrap=True)
