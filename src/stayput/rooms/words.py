"""The sentences of a verdict on a room; they are in `stayput.catalogue.rooms`."""

from __future__ import annotations

import math
from itertools import chain, repeat
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.catalogue.names import PIECES
from stayput.fragility.probabilities import percent
from stayput.model.floor_plan import PLACES
from stayput.rooms.changes import wall_faced
from stayput.verification.words import class_phrase, of_the_cases, sentence_of, share_text
from stayput.wording import inside

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.catalogue import Phrase
    from stayput.fragility import Probability
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


def _where_somebody_is(place: PersonPlace) -> Phrase:
    """Return where the person of a place is: "in the bed"."""
    if place.name in PLACES:
        return phrase(f"rooms.at_{place.name}")
    return phrase("rooms.at_place", place=place.name)


def often(share: float, cases: Phrase) -> Phrase:
    """Return how often something happens: "in 6 of 10 earthquakes"."""
    tenths = round(10.0 * share)
    if share >= 1.0:
        return phrase("rooms.always", cases=cases)
    if 1 <= tenths <= 9:
        return phrase("rooms.of_ten", count=tenths, cases=cases)
    return phrase("rooms.rarely", share=share_text(share), cases=cases)


def sentence_of_room(verdict: RoomVerdict, language: str) -> str:
    """Return the verdict in one sentence: of which shaking, what happens how often, and how sure that is."""
    if not verdict.hit.runs:
        return say("verification.no_run", language)
    stated = verdict.scenario.shaking.strength
    key = "rooms.strength_scattered" if stated is not None and stated.scatter else "rooms.strength"
    if verdict.motions == 1:
        key = "rooms.strength_of_one"
    strength = say(key, language, strength=class_phrase(verdict.intensity))
    told = sentence_of([say(part, language) for part in _clauses(verdict)], language)
    return strength + (told[0].lower() + told[1:] if language == "en" else told)


def _clauses(verdict: RoomVerdict) -> Iterator[Phrase]:
    """Yield what happens, each with its interval."""
    cases = phrase("rooms.runs" if verdict.motions == 1 else "rooms.earthquakes")
    names = chain([phrase("rooms.interval")], repeat(("", "")))  # what the ends are is said once

    def ends_of(chance: Probability) -> Phrase:
        (english, japanese), (first, second) = next(names), interval_text(chance)
        return phrase("common.aside", content=(english + first, japanese + second))

    def happens(key: str, chance: Probability, **values: Phrase | int) -> Phrase:
        return phrase(key, often=often(chance.estimate, cases), interval=ends_of(chance), **values)

    worst = sorted(verdict.places, key=lambda one: -one.hit.estimate)
    told = [place for place in worst if place.hit.estimate >= TOLD] or [place for place in worst if place.by]
    if not verdict.places:
        yield phrase("rooms.no_places")
    elif not told:
        yield phrase("rooms.nobody_hit", runs=verdict.hit.runs, interval=ends_of(verdict.hit))
    for place in told:
        first = place.by[0]
        values = {"piece": piece_name(first.piece), "place": _where_somebody_is(place.place)}
        yield happens("rooms.hits", first.probability, **values)
    named = {place.by[0].piece for place in told}
    falling = [piece for piece in verdict.pieces if piece.falls and piece.name not in named]
    falling.sort(key=lambda piece: -piece.probabilities["overturned"].estimate)
    if falling:
        first, *others = falling
        yield happens(
            "rooms.falls_with_others" if others else "rooms.falls",
            first.probabilities["overturned"],
            piece=piece_name(first.name),
            count=len(others),
        )
    for door in verdict.doors:
        if door.blocked.estimate >= TOLD:
            yield happens("rooms.blocked", door.blocked, door=door_name(door.door))
    shut = max(verdict.places, key=lambda one: one.shut_in.estimate, default=None)
    if shut is not None and shut.shut_in.estimate >= TOLD:
        yield happens("rooms.shut_in", shut.shut_in, place=_where_somebody_is(shut.place))


def interval_text(chance: Probability) -> Phrase:
    """Return the interval of a probability: "7 to 20 %"."""
    low, (english, japanese) = percent(chance.low), share_text(chance.high)
    return f"{low} to {english}", f"{low}～{japanese}"


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
    along, start = (y, "near_side_wall") if wall in ("left_wall", "right_wall") else (x, "left_wall")
    return phrase(
        "rooms.move_piece",
        piece=piece_name(change.what),
        wall=phrase(f"rooms.{wall}"),
        along=along,
        start=phrase(f"rooms.{start}"),
    )


def change_sentence(result: ChangeVerdict, verdict: RoomVerdict, language: str) -> str:
    """Return what a change brings, in one sentence."""
    what = next(iter(result.better), "hit")
    (held, change), own = (result.hit, result.hit_change), verdict.piece_changed(result)
    if what == "shut_in":
        held, change = result.shut_in, result.shut_in_change
    elif what == "blocked":
        held, change = result.blocked, result.blocked_change
    elif what == "overturned" and own is not None:
        held, change = own
    english, japanese = label_of(result.change, verdict)
    shares = {
        name: (of_the_cases(share), share_text(share)[1])
        for name, share in (("held", held.estimate), ("bare", held.estimate - change.estimate))
    }
    told = say(
        f"rooms.effect_{what}",
        language,
        change=(inside(english), japanese),
        piece=piece_name(result.change.what),
        **shares,
    )
    return sentence_of([told], language)


def tags(result: ChangeVerdict) -> list[Phrase]:
    """Return what a change is clearly better in, and what worse; that nothing is clear, where nothing is."""
    found = [phrase(f"rooms.fewer_{name}") for name in result.better]
    found += [phrase(f"rooms.more_{name}") for name in result.worse]
    return found or [phrase("rooms.nothing_clear")]


def best_sentence(verdict: RoomVerdict, language: str) -> str:
    """Return which single change helps most, or that none does; empty where none was tried."""
    if not verdict.changes:
        return ""
    best = verdict.best
    if best is None:
        return say("rooms.no_best", language)
    change = change_sentence(best, verdict, language)
    return say("rooms.best", language, change=change.rstrip(".。"))
