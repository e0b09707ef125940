"""A verdict on a room as tables of texts, for terminal and Markdown."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import stayput
from stayput.catalogue import phrase, say
from stayput.report.verdict import numbers
from stayput.report.verdict.markdown import plain, table
from stayput.rooms.words import (
    best_sentence,
    change_label,
    door_name,
    motion_phrase,
    piece_name,
    place_name,
)

if TYPE_CHECKING:
    from stayput.fragility import Probability
    from stayput.rooms.verdict import RoomVerdict


class TextTable(NamedTuple):
    """A table of texts, with what is said below it; without rows it is left out."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    below: str = ""


def sentences(verdict: RoomVerdict, language: str) -> tuple[str, ...]:
    """Return what is said above the tables."""
    best = best_sentence(verdict, language)
    return (verdict.sentence(language), *([best] if best else []))


def tables(verdict: RoomVerdict, language: str) -> tuple[TextTable, ...]:
    """Return who is hit by what, which ways out are blocked, and what single changes bring."""

    def texts(*keys: str) -> tuple[str, ...]:
        return tuple(say(f"rooms.{key}", language) for key in keys)

    def chance(value: Probability) -> str:
        return numbers.with_interval(value, language)

    hits: list[tuple[str, ...]] = []
    for place in verdict.places:
        shares = (numbers.share(one, language) for one in (place.by_day, place.by_night))
        name = say(place_name(place.place), language)
        hits.append((name, *texts("any_piece"), chance(place.hit), *shares, "", "", ""))
        for one in place.by:
            strength = numbers.speed(one.speed.median), numbers.energy(one.energy.median)
            name = say(piece_name(one.piece), language)
            hits.append(("", name, chance(one.probability), "", "", *strength, numbers.mass(one.mass)))
    ways = [(phrase("rooms.door_blocked", door=door_name(door.door)), door.blocked) for door in verdict.doors]
    if any(door.door.way_out for door in verdict.doors):
        ways += [
            (phrase("rooms.place_shut_in", place=place_name(place.place)), place.shut_in)
            for place in verdict.places
        ]
    changes = [
        (
            change_label(one.change, verdict, language),
            chance(one.hit),
            numbers.change(one.hit_change, language),
            chance(one.shut_in),
            "" if (own := verdict.piece_changed(one)) is None else chance(own[0]),
        )
        for one in verdict.changes
    ]
    stuck = any(door.at_rest for door in verdict.doors)
    return (
        TextTable(
            texts("who", "by", "chance", "day", "night", "speed", "energy", "mass"),
            tuple(hits),
            *texts("upper_bounds"),
        ),
        TextTable(
            texts("way", "chance"),
            tuple((say(label, language), chance(blocked)) for label, blocked in ways),
            *(texts("blocked_at_rest") if stuck else ()),
        ),
        TextTable(texts("change", "hit_then", "hit_less", "shut_in_then", "overturned_then"), tuple(changes)),
    )


def simulations_of_room(verdict: RoomVerdict, language: str) -> str:
    """Return how many runs the verdict rests on."""
    motions = motion_phrase(verdict) or phrase("rooms.motions", count=verdict.motions)
    return say(
        "rooms.simulations", language, runs=f"{verdict.runs:,}", motions=motions, samples=verdict.samples
    )


def room_markdown(verdict: RoomVerdict, language: str = "en") -> str:
    """Return a verdict on a room as a text in Markdown, in "en" or "ja"."""
    first, *others = sentences(verdict, language)
    lines = [f"# {plain(verdict.scenario.title or say('rooms.report', language))}", f"\n**{plain(first)}**"]
    lines += [f"\n{plain(sentence)}" for sentence in others]
    for each in tables(verdict, language):
        if each.rows:
            lines += ["", *table(each.headings, each.rows), *([f"\n{each.below}"] if each.below else [])]
    lines += [f"\n{simulations_of_room(verdict, language)}", f"\nstayput {stayput.__version__}"]
    return "\n".join(lines) + "\n"
