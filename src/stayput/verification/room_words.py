"""The sentences of a verdict on a room; they are in `stayput.catalogue.rooms`."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import chain, repeat
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase, say
from stayput.catalogue.names import PIECES
from stayput.fragility.probabilities import Probability, percent
from stayput.measures.wall import REACH
from stayput.model.floor_plan import PLACE_NAMES, Door, PersonPlace
from stayput.montecarlo.counting import OVERTURNED
from stayput.scenario.measures import AS_STATED
from stayput.verification.changes import Change, wall_faced
from stayput.verification.words import sentence_of, shaking_phrase, title
from stayput.wording import called, default_name, inside, joined, name_quoted, name_within

if TYPE_CHECKING:
    from stayput.fragility.paired import Difference
    from stayput.verification.people import People
    from stayput.verification.verdict import OptionVerdict, PieceVerdict, Verdict

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


def often(chance: Probability, cases: Phrase) -> Phrase:
    """Return how often something happens: "in about 25 % of earthquakes"."""
    return phrase("rooms.often", share=chance.share, cases=cases)


def motion_phrase(verdict: Verdict) -> Phrase | None:
    """Return what the only motion of a verdict is called: "this record"; None where there are more."""
    if verdict.motions > 1:
        return None
    return phrase("rooms.this_motion" if verdict.scenario.shaking.record is None else "rooms.this_record")


def people_in(verdict: Verdict) -> People:
    """Return what happens to people in a room as it is."""
    people = verdict.without.people
    assert people is not None
    return people


def pieces_in(verdict: Verdict) -> list[PieceVerdict]:
    """Return what becomes of the pieces of a room as it is, those that do most harm first."""
    return sorted(
        verdict.without.pieces, key=lambda piece: (-piece.harm, -piece.probabilities[OVERTURNED].estimate)
    )


def sentence_of_room(verdict: Verdict, language: str) -> str:
    """Return the verdict in one sentence: of which shaking, what happens how often, and how sure that is."""
    if not people_in(verdict).hit.chance.runs:
        return say("verification.no_run", language)
    stated = verdict.scenario.shaking.strength
    key = "rooms.strength_scattered" if stated is not None and stated.scatter else "rooms.strength"
    strength = say(key, language, strength=shaking_phrase(verdict))
    sentence = sentence_of([say(part, language) for part in _clauses(verdict)], language)
    return strength + (sentence[0].lower() + sentence[1:] if language == "en" else sentence)


def _clauses(verdict: Verdict) -> Iterator[Phrase]:
    """Yield what happens, each with its interval."""
    only, runs = motion_phrase(verdict), phrase("rooms.runs")
    of_one = runs if only is None else phrase("rooms.runs_of", motion=only)
    # What the ends are, and which motion it is, is said once.
    names = chain([phrase("rooms.interval")], repeat(("", "")))
    cases = repeat(phrase("rooms.earthquakes")) if only is None else chain([of_one], repeat(runs))

    def ends_of(chance: Probability) -> Phrase:
        if not chance.ends[0]:
            return "", ""
        (english, japanese), (first, second) = next(names), chance.ends
        return phrase("common.aside", content=(english + first, japanese + second))

    def happens(key: str, chance: Probability, **values: Phrase) -> Phrase:
        return phrase(key, often=often(chance, next(cases)), interval=ends_of(chance), **values)

    people = people_in(verdict)
    worst = sorted(people.places, key=lambda place: (-place.hit.estimate, -place.touched.estimate))
    reached = [
        (place, hit)
        for place in worst
        for hit in place.by
        if hit is place.by[0] or (hit.by_falling and hit.probability.estimate >= TOLD)
    ]
    reached = [each for each in reached if each[1].probability.estimate >= TOLD] or reached
    if people.places and not any(hit.by_falling for _, hit in reached):
        yield phrase("rooms.nobody_hit", often=often(people.hit.chance, next(cases)))
    for place, hit in reached:
        values = {"piece": piece_within(hit.piece), "place": _where_somebody_is(place.place)}
        key = "rooms.falls_on" if hit.by_falling else "rooms.touches"
        yield happens(key, hit.probability, **values)
    named = {hit.piece for _, hit in reached if hit.by_falling}
    falling = [piece for piece in verdict.without.pieces if piece.falls and piece.name not in named]
    falling.sort(key=lambda piece: -piece.probabilities["overturned"].estimate)
    if falling:
        first, *others = falling
        beside = phrase("rooms.with_others", count=len(others)) if others else ("", "")
        chance = first.probabilities["overturned"]
        yield happens("rooms.falls_too", chance, piece=piece_within(first.name), others=beside)
    elif not people.places:
        yield phrase("rooms.any_falls", often=often(verdict.without.probabilities[OVERTURNED], next(cases)))
    for door in people.doors:
        name = name_within(door.door.name, _DOOR)
        if door.at_rest:
            yield phrase("rooms.blocked_already", door=name)
        elif door.blocked.estimate >= TOLD:
            yield happens("rooms.blocked", door.blocked, door=name)
    shut = max(people.places, key=lambda place: place.shut_in.estimate, default=None)
    if shut is not None and shut.shut_in_at_rest:
        yield phrase("rooms.shut_in_already")
    elif shut is not None and shut.shut_in.estimate >= TOLD:
        yield happens("rooms.shut_in", shut.shut_in, place=_where_somebody_is(shut.place))


def option_label(option: OptionVerdict, verdict: Verdict, language: str) -> str:
    """Return what an option of a room consists of, as it stands by itself."""
    label = say(_label(option, verdict), language)
    return label[:1].upper() + label[1:]


def _label(option: OptionVerdict, verdict: Verdict) -> Phrase:
    """Return the same within a sentence: of options in a file their titles, else what changes."""
    if verdict.scenario.options and option.option.name != AS_STATED:
        return title(option.option, verdict, "en"), title(option.option, verdict, "ja")
    changes = verdict.changes(option)
    return joined(label_of(change, verdict) for change in changes) if changes else phrase("rooms.as_it_is")


def piece_changed(option: OptionVerdict, verdict: Verdict) -> tuple[Probability, Difference] | None:
    """Return how often the only piece that an option changes overturns, and the difference; else None."""
    changed = {change.what for change in verdict.changes(option)}
    pieces = [piece for piece in option.pieces if changed == {piece.name}]
    return (pieces[0].probabilities[OVERTURNED], pieces[0].change) if pieces and pieces[0].change else None


def label_of(change: Change, verdict: Verdict) -> Phrase:
    """Return the same within a sentence, in both languages."""
    if change.measure is not None:
        english, japanese = change.measure.label
        return phrase("rooms.fix", measure=(inside(english), japanese), piece=piece_within(change.what))
    assert change.at is not None
    assert change.heading is not None
    x, y = change.at
    place = next((spot.place for spot in people_in(verdict).places if spot.place.name == change.what), None)
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


def change_sentence(option: OptionVerdict, verdict: Verdict, language: str) -> str:
    """Return what an option is and what it brings."""
    return sentence_of([say(_effect(option, verdict), language)], language)


def _effect(option: OptionVerdict, verdict: Verdict) -> Phrase:
    what, people = next(iter(option.better), "hit"), option.people
    assert people is not None
    changed = piece_changed(option, verdict) if what == "overturned" else None
    outlook = people.hit if what == "overturned" else getattr(people, what)
    chance, change = changed or outlook
    assert change is not None
    goes = "stays" if not change.clear else "falls" if change.estimate < 0.0 else "rises"
    least, most = sorted((abs(change.low), abs(change.high)))
    return phrase(
        "rooms.change_of",
        change=_label(option, verdict),
        what=phrase(f"rooms.chance_of_{what}"),
        goes=phrase(f"rooms.{goes}", least=percent(least), most=percent(most), held=chance.share),
    )


def tags(option: OptionVerdict) -> list[Phrase]:
    """Return what an option is clearly better in, and what worse; that nothing is clear, where nothing is."""
    changes = [("fewer", name) for name in option.better] + [("more", name) for name in option.worse]
    # a way out that is free is more than a door
    shown = [(way, name) for way, name in changes if name != "blocked" or (way, "shut_in") not in changes]
    return [phrase(f"rooms.{way}_{name}") for way, name in shown] or [phrase("fragility.no_clear_difference")]


def best_sentence(verdict: Verdict, language: str) -> str:
    """Return which of the options of a room helps most, or that none does; empty where none was tried."""
    if not verdict.others:
        return ""
    best = verdict.helping
    if best is None:
        return say("rooms.no_best", language) if verdict.complete else ""
    alike = sum(option.helps and option.rank == best.rank for option in verdict.others) - 1
    key = "rooms.among_best" if alike else "rooms.best"
    return say(key, language, change=_effect(best, verdict), count=alike)
