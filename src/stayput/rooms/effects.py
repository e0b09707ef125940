"""What single changes of a room bring, each beside the room as it is, run by run."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.fragility import difference, probability
from stayput.model.floor_plan import FACING
from stayput.rooms.changes import Change, FreeFloor, measures_tried, other_places, places_at_walls, swept
from stayput.rooms.events import EndOfRuns, Events, Hits, hits_of
from stayput.rooms.runs import placed_elsewhere, run_parts
from stayput.rooms.verdict import ChangeVerdict, presence
from stayput.simulation.placing import bare

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from numpy.typing import NDArray

    from stayput.model.floor_plan import FloorPlan, PersonPlace
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.montecarlo.several import DrawOfSeveral
    from stayput.rooms.runs import PartRuns, RoomPart
    from stayput.rooms.tracks import Track
    from stayput.rooms.ways import Ways
    from stayput.scenario.room import RoomScenario
    from stayput.simulation.standing import Assembly


class Question(NamedTuple):
    """What all runs of a verification share."""

    scenario: RoomScenario
    plan: FloorPlan
    whole: Assembly
    drawn: list[list[DrawOfSeveral]]
    floors: FloorMotions
    threads: int | None
    advance: Callable[[int], None]

    def run(self, parts: Sequence[RoomPart]) -> list[PartRuns]:
        """Run parts of the room under all draws."""
        gravity = self.scenario.gravity
        return run_parts(parts, self.drawn, self.floors, gravity, threads=self.threads, progress=self.advance)


class Answer(NamedTuple):
    """What happens in the room, as it is or with a change."""

    tracks: list[list[Track]]
    missing: NDArray[np.bool_]
    events: Events


def anybody(flags: NDArray[np.bool_], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return whether something happens in any row, shape (motions, samples)."""
    found = np.zeros(flags.shape[1:], np.bool_)
    for row in flags:
        found |= row
    return found.reshape(shape)


def hits_by(events: Events, *, but: int | None = None, only: int | None = None) -> NDArray[np.bool_]:
    """Return which places are hit by any piece, by any but one, or by one only, shape (places, runs)."""
    found = np.zeros((len(events.hits), events.runs), np.bool_)
    for row, hits in zip(found, events.hits, strict=True):
        for body, one in enumerate(hits):
            if body != but and only in (None, body):
                row |= one.happened
    return found


def risk_of(hits: NDArray[np.bool_], places: Sequence[PersonPlace], missing: NDArray[np.bool_]) -> float:
    """Return the chance that a person is hit, weighted by how long somebody is at each place."""
    known = ~missing.ravel()
    if not len(hits) or not known.any():
        return 0.0 if known.any() else math.nan
    spared = np.ones(int(known.sum()))
    for place, own in zip(places, hits, strict=True):
        spared *= 1.0 - presence(place) * own[known]
    return float(np.mean(1.0 - spared))


class Move(NamedTuple):
    """A change that moves something, with what differs then.

    Parameters
    ----------
    change : Change
        The change.
    plan : FloorPlan
        The room's plan with it.
    instead : dict of int to sequence of Track
        The tracks of the piece that is moved.
    """

    change: Change
    plan: FloorPlan
    instead: dict[int, Sequence[Track]]


def changes_of(
    question: Question, parts: Sequence[RoomPart], as_it_is: Answer, ends: EndOfRuns
) -> tuple[ChangeVerdict, ...]:
    """Return what single changes bring, the best first."""
    scenario, plan, whole = question.scenario, question.plan, question.whole
    harmful = harmful_pieces(as_it_is, plan, ends)
    found: list[ChangeVerdict] = []
    tried = [
        one
        for part in parts
        for body in part.bodies
        if body in harmful
        for one in measures_tried(scenario, whole, part.bodies, body)
    ]
    for (change, held), own in zip(tried, question.run([part for _, part in tried]), strict=True):
        found.append(_compared(Move(change, plan, tracks_of_part(held, own)), as_it_is, ends))
    found += [_compared(move, as_it_is, ends) for move in moves_of(question, parts, as_it_is, ends, harmful)]
    return tuple(sorted(found, key=lambda one: (round(one.risk, 4), one.shut_in.estimate, one.change.effort)))


def tracks_of_part(part: RoomPart, runs: PartRuns) -> dict[int, Sequence[Track]]:
    """Return the tracks of the pieces of a part by their numbers in the room."""
    return dict(zip(part.bodies, zip(*runs.tracks, strict=True), strict=True))


def moves_of(
    question: Question, parts: Sequence[RoomPart], as_it_is: Answer, ends: EndOfRuns, harmful: set[int]
) -> Iterator[Move]:
    """Yield the best place of each harmful piece at each wall, and of each place at which somebody is hit."""
    scenario, plan, whole = question.scenario, question.plan, question.whole
    ways, floor = ends.ways, FreeFloor(plan, tuple(bare(one) for one in whole.members))
    for part in parts:
        (body, *others) = part.bodies
        if others or body not in harmful or not scenario.furniture[body].is_furniture:
            continue
        for wall, middles in places_at_walls(scenario, whole, body, floor):
            moved = _best_at_wall(question, body, wall, middles, as_it_is, ways)
            if moved is not None:
                yield Move(moved[0], plan, moved[1])
    for number, place in enumerate(plan.places):
        if as_it_is.events.hit(number).any():
            other = _best_place(number, other_places(place, floor), question, as_it_is, ways)
            if other is not None:
                places = (*plan.places[:number], other, *plan.places[number + 1 :])
                change = Change(other.name, at=other.at, heading=other.heading)
                yield Move(change, replace(plan, places=places), {})


def harmful_pieces(as_it_is: Answer, plan: FloorPlan, ends: EndOfRuns) -> set[int]:
    """Return the pieces without which less would happen."""
    events, missing = as_it_is.events, as_it_is.missing
    risk = risk_of(hits_by(events), plan.places, missing)
    found: set[int] = set()
    blocked = events.blocked.sum() + events.shut_in.sum()
    for body in range(len(as_it_is.tracks)):
        others = [own for number, own in enumerate(as_it_is.tracks) if number != body]
        less = risk_of(hits_by(events, but=body), plan.places, missing) < risk
        if not less and blocked and others:
            less = sum(flags.sum() for flags in ends.of_all(others)) < blocked
        if less or (blocked and not others):
            found.add(body)
    return found


def events_with(
    plan: FloorPlan,
    instead: Mapping[int, Sequence[Track]],
    as_it_is: Answer,
    ends: EndOfRuns,
    hits: Callable[[PersonPlace, Sequence[Track]], Hits] = hits_of,
) -> Events:
    """Return what happens where some pieces have other tracks, and some places may be elsewhere.

    Parameters
    ----------
    plan : FloorPlan
        The room with the places where they are.
    instead : mapping of int to sequence of Track
        The tracks of the pieces that have others.
    as_it_is : Answer
        What happens otherwise.
    ends : EndOfRuns
        Of the plan as it is.
    hits : callable
        Returns the contacts of a piece with a place.
    """
    tracks = [instead.get(body, own) for body, own in enumerate(as_it_is.tracks)]
    found = tuple(
        tuple(
            hits(place, own) if body in instead or place != was else known[body]
            for body, own in enumerate(tracks)
        )
        for place, was, known in zip(plan.places, ends.plan.places, as_it_is.events.hits, strict=True)
    )
    return Events(found, *(ends if plan == ends.plan else EndOfRuns(plan)).of_all(tracks))


def _compared(move: Move, as_it_is: Answer, ends: EndOfRuns) -> ChangeVerdict:
    """Return what a change brings, beside the room as it is."""
    events = events_with(move.plan, move.instead, as_it_is, ends)
    missing, shape = as_it_is.missing, as_it_is.missing.shape
    before, after = hits_by(as_it_is.events), hits_by(events)
    hit, was_hit = anybody(after, shape), anybody(before, shape)
    shut, was_shut = anybody(events.shut_in, shape), anybody(as_it_is.events.shut_in, shape)
    return ChangeVerdict(
        move.change,
        probability(hit, missing),
        difference(hit, was_hit, missing),
        probability(shut, missing),
        difference(shut, was_shut, missing),
        risk_of(after, move.plan.places, missing),
    )


def _best_at_wall(
    question: Question,
    body: int,
    wall: str,
    middles: list[tuple[float, float]],
    as_it_is: Answer,
    ways: Ways,
) -> tuple[Change, dict[int, Sequence[Track]]] | None:
    """Return where along a wall a piece does least harm, and its tracks there.

    It runs in the middle of those places; the tracks elsewhere are the same, shifted.
    """
    scenario, member = question.scenario, bare(question.whole.members[body])
    heading = FACING[wall]
    same = abs(math.remainder(heading - member.heading, 2.0 * math.pi)) < 1e-9
    at = middles[len(middles) // 2]
    if same:
        tracks: Sequence[Track] = as_it_is.tracks[body]
        origin = np.array(member.at[:2])
    else:
        part = placed_elsewhere(scenario, question.whole, body, at, heading)
        tracks, origin = [run[0] for run in question.run([part])[0].tracks], np.array(at)
    places = question.plan.places
    others = hits_by(as_it_is.events, but=body)
    best: tuple[Change, dict[int, Sequence[Track]]] | None = None
    least = math.inf
    for middle in middles:
        shift = np.array(middle) - origin
        if same and np.hypot(*shift) < 1e-3:
            continue
        moved: Sequence[Track] = tuple(track.shifted(shift) for track in tracks)
        over = swept(ways, moved)
        hits = np.array(
            [
                own | (over & ways.covered([place.corners]).ravel()).any(axis=1)
                for place, own in zip(places, others, strict=True)
            ]
        )
        risk = risk_of(hits, places, as_it_is.missing)
        if risk < least - 1e-12:
            best = Change(scenario.names[body], at=middle, heading=heading), {body: moved}
            least = risk
    return best


def _best_place(
    number: int, others: list[PersonPlace], question: Question, as_it_is: Answer, ways: Ways
) -> PersonPlace | None:
    """Return where a place is hit least, the nearest of those that are alike."""
    if not others:
        return None
    over = np.any([swept(ways, own) for own in as_it_is.tracks], axis=0)
    here = question.plan.places[number]

    def key(place: PersonPlace) -> tuple[float, float]:
        share = (over & ways.covered([place.corners]).ravel()).any(axis=1).mean()
        away = math.hypot(place.at[0] - here.at[0], place.at[1] - here.at[1])
        return float(share), away + abs(math.remainder(place.heading - here.heading, math.pi))

    return min(others, key=key)
