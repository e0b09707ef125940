"""A verdict on a room as tables of texts, for terminal and Markdown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.report.verdict import numbers
from stayput.rooms.words import (
    best_sentence,
    change_label,
    door_name,
    motion_phrase,
    piece_name,
    place_name,
    sentence_of_room,
)

if TYPE_CHECKING:
    from stayput.rooms.verdict import RoomVerdict


@dataclass(frozen=True, slots=True)
class TextTable:
    """A table of texts, with what is said below it; without rows it is left out."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    below: str = ""


def sentences(verdict: RoomVerdict, language: str) -> tuple[str, ...]:
    """Return what is said above the tables."""
    best = best_sentence(verdict, language)
    return (sentence_of_room(verdict, language), *([best] if best else []))


def tables(verdict: RoomVerdict, language: str) -> tuple[TextTable, ...]:
    """Return who is hit by what, which ways out are blocked, and what single changes bring."""

    def texts(*keys: str) -> tuple[str, ...]:
        return tuple(say(f"rooms.{key}", language) for key in keys)

    hits: list[tuple[str, ...]] = []
    for place in verdict.places:
        shares = (numbers.share(one, language) for one in (place.by_day, place.by_night))
        name = say(place_name(place.place), language)
        hits.append(
            (name, *texts("any_piece"), numbers.with_interval(place.hit, language), *shares, "", "", "")
        )
        for one in place.by:
            values = (
                numbers.speed(one.speed.median),
                numbers.energy(one.energy.median),
                numbers.mass(one.mass),
            )
            hits.append(
                (
                    "",
                    say(piece_name(one.piece), language),
                    numbers.with_interval(one.probability, language),
                    "",
                    "",
                    *values,
                )
            )
    ways = [(phrase("rooms.door_blocked", door=door_name(door.door)), door.blocked) for door in verdict.doors]
    if any(door.door.way_out for door in verdict.doors):
        ways += [
            (phrase("rooms.place_shut_in", place=place_name(place.place)), place.shut_in)
            for place in verdict.places
        ]
    changes = [
        (
            change_label(one.change, verdict, language),
            numbers.with_interval(one.hit, language),
            numbers.change(one.hit_change, language),
            numbers.with_interval(one.shut_in, language),
            "" if (own := verdict.piece_changed(one)) is None else numbers.with_interval(own[0], language),
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
            tuple((say(label, language), numbers.with_interval(chance, language)) for label, chance in ways),
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
