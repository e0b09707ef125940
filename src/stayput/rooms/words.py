"""The sentences of a verdict on a room; they are in `stayput.catalogue.rooms`."""

from __future__ import annotations

import math
from itertools import chain, repeat
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase, say
from stayput.catalogue.names import PIECES
from stayput.fragility.probabilities import percent
from stayput.measures.wall import REACH
from stayput.model.floor_plan import PLACE_NAMES, Door, PersonPlace
from stayput.rooms.changes import Change, wall_faced
from stayput.verification.words import sentence_of, shaking_phrase, share_text
from stayput.wording import called, default_name, inside, name_quoted, name_within

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.fragility.probabilities import Probability
    from stayput.rooms.verdict import ChangeVerdict, RoomVerdict

TOLD = 0.005
"""From this share on something is told in the verdict's sentence."""


_AT = {"bed": "in", "futon": "on", "cot": "in", "desk": "at", "sofa": "on", "play area": "in"}
_DOOR: dict[str, Phrase] = {"door": phrase("rooms.door")}


def place_name(place: PersonPlace) -> Phrase:
    """Return what a place is called, translated where it has no name of its own."""
    return called(place.name, PLACE_NAMES)


def door_name(door: Door) -> Phrase:
    """Return what a door is called, translated where it has no name of its own."""
    return called(door.name, _DOOR)


def piece_name(name: str) -> Phrase:
    """Return what a piece is called, translated where that is a preset's name, with a number or without."""
    return called(name, PIECES)


def piece_within(name: str) -> Phrase:
    """Return the same as it stands within a sentence: "the bookcase", "bookcase 2", "“My shelf”"."""
    return name_within(name, PIECES)[0], name_quoted(name, PIECES)[1]


def _where_somebody_is(place: PersonPlace) -> Phrase:
    """Return where the person of a place is: "in bed", "at desk 2"."""
    default = default_name(place.name, PLACE_NAMES)
    in_bed = default == ("bed", "")  # which has no article then
    name = place_name(place) if in_bed else name_within(place.name, PLACE_NAMES)
    return phrase(f"rooms.{'at' if default is None else _AT[default[0]]}_place", place=name)


def often(share: float, cases: Phrase) -> Phrase:
    """Return how often something happens: "in 8 of 10 earthquakes", "in 3 of 100 earthquakes".

    Of as few as come within 2 points, and within a tenth, of the share; of 1,000 where none do.
    """
    if share >= 1.0:
        return phrase("rooms.always", cases=cases)
    for whole in (10, 20, 100, 1000):
        count = math.floor(round(whole * share, 9) + 0.5)  # a half is rounded up
        off = round(abs(count / whole - share), 9)
        if 1 <= count < whole and (off <= min(0.02, 0.1 * share) or whole == 1000):
            return phrase("rooms.count_of", count=count, all=whole, cases=cases)
    return phrase("rooms.rarely", share=share_text(share), cases=cases)


def motion_phrase(verdict: RoomVerdict) -> Phrase | None:
    """Return what the only motion of a verdict is called: "this record"; None where there are more."""
    if verdict.motions > 1:
        return None
    return phrase("rooms.this_motion" if verdict.scenario.shaking.record is None else "rooms.this_record")


def sentence_of_room(verdict: RoomVerdict, language: str) -> str:
    """Return the verdict in one sentence: of which shaking, what happens how often, and how sure that is."""
    if not verdict.hit.runs:
        return say("verification.no_run", language)
    stated = verdict.scenario.shaking.strength
    key = "rooms.strength_scattered" if stated is not None and stated.scatter else "rooms.strength"
    strength = say(key, language, strength=shaking_phrase(verdict))
    sentence = sentence_of([say(part, language) for part in _clauses(verdict)], language)
    return strength + (sentence[0].lower() + sentence[1:] if language == "en" else sentence)


def _clauses(verdict: RoomVerdict) -> Iterator[Phrase]:
    """Yield what happens, each with its interval."""
    only, runs = motion_phrase(verdict), phrase("rooms.runs")
    of_one = runs if only is None else phrase("rooms.runs_of", motion=only)
    # What the ends are, and which motion it is, is said once.
    names = chain([phrase("rooms.interval")], repeat(("", "")))
    cases = repeat(phrase("rooms.earthquakes")) if only is None else chain([of_one], repeat(runs))

    def ends_of(chance: Probability) -> Phrase:
        (english, japanese), (first, second) = next(names), interval_text(chance)
        return phrase("common.aside", content=(english + first, japanese + second))

    def happens(key: str, chance: Probability, **values: Phrase) -> Phrase:
        return phrase(key, often=often(chance.estimate, next(cases)), interval=ends_of(chance), **values)

    worst = sorted(verdict.places, key=lambda place: -place.hit.estimate)
    hit = [place for place in worst if place.hit.estimate >= TOLD] or [place for place in worst if place.by]
    if not verdict.places:
        yield phrase("rooms.no_places")
    elif not hit:
        next(cases)
        yield phrase("rooms.nobody_hit", count=verdict.hit.runs, cases=of_one, interval=ends_of(verdict.hit))
    for place in hit:
        first = place.by[0]
        values = {"piece": piece_within(first.piece), "place": _where_somebody_is(place.place)}
        yield happens("rooms.hits", first.probability, **values)
    named = {place.by[0].piece for place in hit}
    falling = [piece for piece in verdict.pieces if piece.falls and piece.name not in named]
    falling.sort(key=lambda piece: -piece.probabilities["overturned"].estimate)
    if falling:
        first, *others = falling
        beside = phrase("rooms.with_others", count=len(others)) if others else ("", "")
        chance = first.probabilities["overturned"]
        yield happens("rooms.falls_too", chance, piece=piece_within(first.name), others=beside)
    for door in verdict.doors:
        if door.blocked.estimate >= TOLD:
            yield happens("rooms.blocked", door.blocked, door=name_within(door.door.name, _DOOR))
    shut = max(verdict.places, key=lambda place: place.shut_in.estimate, default=None)
    if shut is not None and shut.shut_in.estimate >= TOLD:
        yield happens("rooms.shut_in", shut.shut_in, place=_where_somebody_is(shut.place))


def interval_text(chance: Probability) -> Phrase:
    """Return the interval of a probability: "7 to 20 %"."""
    low, (english, japanese) = percent(chance.low), share_text(chance.high)
    return f"{low} to {english}", f"{low}～{japanese}"


def change_label(change: Change, verdict: RoomVerdict, language: str) -> str:
    """Return what a change consists of, as it stands by itself."""
    label = say(label_of(change, verdict), language)
    return label[:1].upper() + label[1:]


def label_of(change: Change, verdict: RoomVerdict) -> Phrase:
    """Return the same within a sentence, in both languages."""
    if change.measure is not None:
        english, japanese = change.measure.label
        return phrase("rooms.fix", measure=(inside(english), japanese), piece=piece_within(change.what))
    assert change.at is not None
    assert change.heading is not None
    x, y = change.at
    place = next((spot.place for spot in verdict.places if spot.place.name == change.what), None)
    if place is not None and change.what not in verdict.scenario.names:
        turned = abs(math.remainder(change.heading - place.heading, math.pi)) > 1e-6
        how = phrase("rooms.turned" if turned else "rooms.moved", place=name_within(place.name, PLACE_NAMES))
        return phrase("rooms.move_place", how=how, x=x, y=y)
    wall = wall_faced(change.heading)
    axis = 0 if wall in ("left_wall", "right_wall") else 1  # across the wall
    along, start = (y, "near_side_wall") if axis == 0 else (x, "left_wall")
    piece = verdict.scenario.scene().pieces[verdict.scenario.names.index(change.what)]
    off = abs(piece.at[0] - x if axis == 0 else piece.at[1] - y)
    at_this_wall = wall_faced(piece.heading) == wall and off <= REACH
    return phrase(
        "rooms.move_along" if at_this_wall else "rooms.move_piece",
        piece=piece_within(change.what),
        wall=phrase(f"rooms.{wall}"),
        along=along,
        start=phrase(f"rooms.{start}"),
    )


def change_sentence(result: ChangeVerdict, verdict: RoomVerdict, language: str) -> str:
    """Return what a change is and what it brings."""
    return sentence_of([say(_effect(result, verdict), language)], language)


def _effect(result: ChangeVerdict, verdict: RoomVerdict) -> Phrase:
    what = next(iter(result.better), "hit")
    changed = verdict.piece_changed(result) if what == "overturned" else None
    if what in ("shut_in", "blocked"):
        changed = getattr(result, what), getattr(result, f"{what}_change")
    chance, change = changed or (result.hit, result.hit_change)
    held, bare = chance.estimate, chance.estimate - change.estimate
    goes = "stays" if share_text(held) == share_text(bare) else "falls" if held < bare else "rises"
    return phrase(
        "rooms.change_of",
        change=label_of(result.change, verdict),
        what=phrase(f"rooms.chance_of_{what}"),
        goes=phrase(f"rooms.{goes}", bare=share_text(bare), held=share_text(held)),
    )


def tags(result: ChangeVerdict) -> list[Phrase]:
    """Return what a change is clearly better in, and what worse; that nothing is clear, where nothing is."""
    changes = [("fewer", name) for name in result.better] + [("more", name) for name in result.worse]
    # a way out that is free is more than a door
    shown = [(way, name) for way, name in changes if name != "blocked" or (way, "shut_in") not in changes]
    return [phrase(f"rooms.{way}_{name}") for way, name in shown] or [phrase("rooms.nothing_clear")]


def best_sentence(verdict: RoomVerdict, language: str) -> str:
    """Return which single change helps most, or that none does; empty where none was tried."""
    if not verdict.changes:
        return ""
    best = verdict.best
    if best is None:
        return say("rooms.no_best", language) if verdict.complete else ""
    return say("rooms.best", language, change=_effect(best, verdict))
