"""The sentences of a verdict on a room; they are in `stayput.catalogue.rooms`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.catalogue.names import PIECES
from stayput.model.floor_plan import PLACES
from stayput.rooms.changes import wall_faced
from stayput.verification.words import class_phrase, of_the_cases, sentence_of, share_text
from stayput.wording import inside

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.floor_plan import Door, PersonPlace
    from stayput.rooms.changes import Change
    from stayput.rooms.verdict import ChangeVerdict, RoomVerdict

TOLD = 0.005
"""From this share on something is told in the verdict's sentence."""


def place_name(place: PersonPlace) -> Phrase:
    """Return what a place is called, translated where that is its kind."""
    return phrase(f"rooms.{place.name}") if place.name in PLACES else (place.name, place.name)


def door_name(door: Door) -> Phrase:
    """Return what a door is called, translated where it has no name of its own."""
    return phrase("rooms.door") if door.name == "door" else (door.name, door.name)


def piece_name(name: str) -> Phrase:
    """Return what a piece is called, translated where that is a preset's name."""
    return PIECES.get(name, (name, name))


def often(share: float) -> Phrase:
    """Return how often something happens: "in 6 of 10 earthquakes"."""
    tenths = round(10.0 * share)
    if share >= 1.0:
        return phrase("rooms.always")
    if 1 <= tenths <= 9:
        return phrase("rooms.of_ten", count=tenths)
    return phrase("rooms.rarely", share=share_text(share))


def sentence_of_room(verdict: RoomVerdict, language: str) -> str:
    """Return the verdict in one sentence."""
    clauses = [say(part, language) for part in _clauses(verdict)]
    strength = say("rooms.strength", language, strength=class_phrase(verdict.intensity))
    told = sentence_of(clauses, language)
    return strength + (told[0].lower() + told[1:] if language == "en" else told)


def _clauses(verdict: RoomVerdict) -> list[Phrase]:
    if not verdict.places:
        parts = [phrase("rooms.no_places")]
    else:
        parts = [
            phrase(
                "rooms.hits",
                often=often(place.by[0].probability.estimate),
                piece=piece_name(place.by[0].piece),
                place=place_name(place.place),
            )
            for place in sorted(verdict.places, key=lambda one: -one.hit.estimate)
            if place.hit.estimate >= TOLD
        ] or [phrase("rooms.nobody_hit")]
    parts += [
        phrase("rooms.blocked", often=often(door.blocked.estimate), door=door_name(door.door))
        for door in verdict.doors
        if door.blocked.estimate >= TOLD
    ]
    worst = max(verdict.places, key=lambda one: one.shut_in.estimate, default=None)
    if worst is not None and worst.shut_in.estimate >= TOLD:
        parts.append(
            phrase("rooms.shut_in", often=often(worst.shut_in.estimate), place=place_name(worst.place))
        )
    return parts


def change_label(change: Change, verdict: RoomVerdict, language: str) -> str:
    """Return what a change consists of."""
    return say(label_of(change, verdict), language)


def label_of(change: Change, verdict: RoomVerdict) -> Phrase:
    """Return the same in both languages."""
    if change.measure is not None:
        return phrase("rooms.fix", measure=change.measure.label, piece=piece_name(change.what))
    assert change.at is not None
    assert change.heading is not None
    x, y = change.at
    place = next((one.place for one in verdict.places if one.place.name == change.what), None)
    if place is not None and change.what not in verdict.scenario.names:
        turned = abs(math.remainder(change.heading - place.heading, math.pi)) > 1e-6
        key = "rooms.turn_place" if turned else "rooms.move_place"
        return phrase(key, place=place_name(place), x=x, y=y)
    wall = wall_faced(change.heading)
    along = y if wall in ("left_wall", "right_wall") else x
    return phrase(
        "rooms.move_piece", piece=piece_name(change.what), wall=phrase(f"rooms.{wall}"), along=along
    )


def change_sentence(result: ChangeVerdict, verdict: RoomVerdict, language: str) -> str:
    """Return what a change brings, in one sentence."""
    key, held, bare = "rooms.effect", result.hit.estimate, verdict.hit.estimate
    if not result.hit_change.clear and result.shut_in_change.clear:
        key, held, bare = "rooms.effect_shut", result.shut_in.estimate, verdict.shut_in.estimate
    english, japanese = label_of(result.change, verdict)
    shares = {
        name: (of_the_cases(share), share_text(share)[1]) for name, share in (("held", held), ("bare", bare))
    }
    told = say(key, language, change=(inside(english), japanese), **shares)
    return sentence_of([told], language)


def best_sentence(verdict: RoomVerdict, language: str) -> str:
    """Return which single change helps most, or that none does; empty where none was tried."""
    if not verdict.changes:
        return ""
    best = verdict.best
    if best is None:
        return say("rooms.no_best", language)
    change = change_sentence(best, verdict, language)
    return say("rooms.best", language, change=change.rstrip(".。"))
