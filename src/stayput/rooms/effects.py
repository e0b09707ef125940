"""What single changes of a room bring, each beside the room as it is, run by run."""

from __future__ import annotations

import math
from contextlib import closing
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from stayput.fragility.paired import Difference, difference
from stayput.fragility.probabilities import Probability, probability
from stayput.model.floor_plan import FACING, FloorPlan, PersonPlace
from stayput.montecarlo.counting import Outcomes
from stayput.rooms.changes import (
    Change,
    FreeFloor,
    measures_tried,
    other_places,
    places_at_walls,
    reach,
    swept,
)
from stayput.rooms.events import EndOfRuns, Events, Hits, Ways, collisions, events_of, hits_of
from stayput.rooms.runs import PartRuns, Question, RoomPart, placed_elsewhere
from stayput.rooms.verdict import ChangeVerdict, RoomEffect, presence
from stayput.simulation.stability import MAY_FALL_FROM

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence

    from numpy.typing import NDArray

    from stayput.rooms.tracks import Track


SAME = 0.05
"""Distance below which another place is the one where something is already [m]."""


class Answer(NamedTuple):
    """What happens in the room as it is.

    Parameters
    ----------
    tracks : list, [body][run]
        Where the pieces were; runs by motion and by sample within it.
    outcomes : tuple of Outcomes
        What became of each piece.
    missing : ndarray of bool, shape (motions, samples)
        Which runs were given up.
    events : Events
        What happened.
    met : mapping of pairs of int to ndarray of bool, shape (runs,)
        Which pieces came together.
    """

    tracks: list[list[Track]]
    outcomes: tuple[Outcomes, ...]
    missing: NDArray[np.bool_]
    events: Events
    met: dict[tuple[int, int], NDArray[np.bool_]]

    @classmethod
    def of(cls, ends: EndOfRuns, parts: Sequence[RoomPart], runs: Sequence[PartRuns]) -> Answer:
        """Return what happens in the runs of all parts."""
        tracks: dict[int, list[Track]] = {}
        outcomes: dict[int, Outcomes] = {}
        missing = np.zeros(runs[0].results.shape[:2], np.bool_)
        for part, part_runs in zip(parts, runs, strict=True):
            missing |= part_runs.missing
            for place, body in enumerate(part.bodies):
                tracks[body], outcomes[body] = part_runs.of_tracks(place), part_runs.of_body(place)
        by_number = [tracks[body] for body in sorted(tracks)]
        return cls(
            by_number,
            tuple(outcomes[body] for body in sorted(outcomes)),
            missing,
            events_of(ends, by_number),
            collisions(by_number),
        )

    @property
    def overturning(self) -> list[float]:
        """The chance that each piece overturns."""
        return [outcomes.probability_of_overturning().estimate for outcomes in self.outcomes]

    def joined(self, more: Answer) -> Answer:
        """Return this and what happens in further samples of the same motions."""
        motions = len(self.missing)

        def joined(array: NDArray[Any], other: NDArray[Any]) -> NDArray[Any]:
            """Join what is of runs along the last axis, motion by motion."""
            pair = ((part, part.shape[-1] // motions) for part in (array, other))
            rows = [part.reshape(*part.shape[:-1], motions, samples) for part, samples in pair]
            return np.concatenate(rows, axis=-1).reshape(*array.shape[:-1], array.shape[-1] + other.shape[-1])

        hits = tuple(
            tuple(Hits(*map(joined, row, other)) for row, other in zip(rows, others, strict=True))
            for rows, others in zip(self.events.hits, more.events.hits, strict=True)
        )
        blocked = joined(self.events.blocked, more.events.blocked)
        shut_in = joined(self.events.shut_in, more.events.shut_in)
        never = [np.zeros(answer.events.runs, np.bool_) for answer in (self, more)]
        pairs = sorted({*self.met, *more.met}, key=lambda pair: pair[::-1])
        return Answer(
            [
                joined(np.array(tracks, object), np.array(other, object)).tolist()
                for tracks, other in zip(self.tracks, more.tracks, strict=True)
            ],
            tuple(Outcomes.joined([*pair]) for pair in zip(self.outcomes, more.outcomes, strict=True)),
            np.concatenate([self.missing, more.missing], axis=1),
            Events(hits, blocked, shut_in),
            {pair: joined(self.met.get(pair, never[0]), more.met.get(pair, never[1])) for pair in pairs},
        )


class RoomState(NamedTuple):
    """A room as it is, run under some or all draws.

    Parameters
    ----------
    parts : list of RoomPart
        The pieces that run together.
    as_it_is : Answer
        What happens in the room.
    ends : EndOfRuns
        Of its plan.
    """

    parts: list[RoomPart]
    as_it_is: Answer
    ends: EndOfRuns


def anybody(flags: NDArray[np.bool_], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return whether something happens in any row, shape (motions, samples)."""
    happens = np.zeros(flags.shape[1:], np.bool_)
    for row in flags:
        happens |= row
    return happens.reshape(shape)


def hits_by(events: Events, *, but: int | None = None, only: int | None = None) -> NDArray[np.bool_]:
    """Return which places are hit by any piece, by any but one, or by one only, shape (places, runs)."""
    hit = np.zeros((len(events.hits), events.runs), np.bool_)
    for row, hits in zip(hit, events.hits, strict=True):
        for body, hits_of_body in enumerate(hits):
            if body != but and only in (None, body):
                row |= hits_of_body.happened
    return hit


def risk_of(hits: NDArray[np.bool_], places: Sequence[PersonPlace], missing: NDArray[np.bool_]) -> float:
    """Return the chance that a person is hit, weighted by how long somebody is at each place."""
    known = ~missing.ravel()
    if not len(hits) or not known.any():
        return 0.0 if known.any() else math.nan
    spared = np.ones(int(known.sum()))
    for place, hit in zip(places, hits, strict=True):
        spared *= 1.0 - presence(place) * hit[known]
    return float(np.mean(1.0 - spared))


class OtherTracks(NamedTuple):
    """How some pieces move otherwise: their tracks, and which of their runs were given up."""

    tracks: Mapping[int, Sequence[Track]]
    missing: NDArray[np.bool_]

    @classmethod
    def of(cls, part: RoomPart, runs: PartRuns) -> OtherTracks:
        """Return how the pieces of a part move in its runs."""
        return cls({body: runs.of_tracks(place) for place, body in enumerate(part.bodies)}, runs.missing)

    def joined(self, other: OtherTracks) -> OtherTracks:
        """Return this with other pieces, or the same once more otherwise."""
        return OtherTracks({**self.tracks, **other.tracks}, self.missing | other.missing)


class Move(NamedTuple):
    """A change that moves something, with the room's plan with it, and how pieces move otherwise then."""

    change: Change
    plan: FloorPlan
    way: OtherTracks


def in_order(changes: Iterable[ChangeVerdict]) -> tuple[ChangeVerdict, ...]:
    """Return changes, the best first: those that help, and then the others; moving asks less than fixing."""

    def key(verdict: ChangeVerdict) -> tuple[float, ...]:
        fixes = verdict.change.measure is not None
        return not verdict.helps, round(verdict.risk, 4), verdict.shut_in.estimate, verdict.fallen, fixes

    return tuple(sorted(changes, key=key))


def changes_of(question: Question, state: RoomState) -> Iterator[ChangeVerdict]:
    """Yield what single changes bring: another place first, then measures on the pieces that do most harm.

    After them come measures on those that overturn without doing harm where they stand.
    """
    scenario, plan, whole = question.scenario, question.plan, question.whole
    as_it_is, harmful = state.as_it_is, harmful_pieces(state)
    for move in moves_of(question, state, harmful):
        question.advance(0)
        yield compared(move, state)

    def harm(body: int) -> tuple[float, ...]:
        risk = risk_of(hits_by(as_it_is.events, only=body), plan.places, as_it_is.missing)
        return body in harmful, risk, chances[body]

    chances = as_it_is.overturning
    tried = [
        each
        for body in sorted(harmful | falling_pieces(as_it_is), key=harm, reverse=True)
        for each in measures_tried(scenario, whole, body)
    ]
    with closing(question.runs_of_each([held for _, held in tried])) as all_runs:
        for (change, held), runs in zip(tried, all_runs, strict=True):
            yield compared(Move(change, plan, OtherTracks.of(held, runs)), state)


def moves_of(question: Question, state: RoomState, harmful: Collection[int]) -> Iterator[Move]:
    """Yield the best spot for each place at which somebody is hit, and for harmful pieces at each wall."""
    scenario, plan, whole = question.scenario, question.plan, question.whole
    as_it_is, ways = state.as_it_is, state.ends.ways
    floor = FreeFloor(plan, whole.pieces)
    struck = [number for number in range(len(plan.places)) if as_it_is.events.hit(number).any()]
    over = _swept_by_any(as_it_is, ways) if struck else None
    for number in struck:
        assert over is not None
        place = plan.places[number]
        other = _best_place(place, other_places(place, floor), over, question, ways)
        if other is not None:
            change = Change(other.name, at=other.at, heading=other.heading)
            yield Move(change, plan.with_places({number: other}), OtherTracks({}, as_it_is.missing))
    for part in state.parts:
        (body, *others) = part.bodies
        if others or body not in harmful or not scenario.pieces[body].is_furniture:
            continue
        for wall, middles in places_at_walls(whole, body, floor):
            moved = _best_at_wall(question, state, body, wall, middles)
            if moved is not None:
                yield moved


def harmful_pieces(state: RoomState) -> set[int]:
    """Return the pieces without which less would happen."""
    _, as_it_is, ends = state
    events, missing, places = as_it_is.events, as_it_is.missing, ends.plan.places
    risk = risk_of(hits_by(events), places, missing)
    harmful: set[int] = set()
    blocked = events.blocked.sum() + events.shut_in.sum()
    for body in range(len(as_it_is.tracks)):
        others = [tracks for number, tracks in enumerate(as_it_is.tracks) if number != body]
        less = risk_of(hits_by(events, but=body), places, missing) < risk
        if not less and blocked and others:
            less = sum(flags.sum() for flags in ends.of_all(others)) < blocked
        if less or (blocked and not others):
            harmful.add(body)
    return harmful


def falling_pieces(as_it_is: Answer) -> set[int]:
    """Return the pieces that overturn so often that they are to be held, wherever they fall."""
    return {body for body, chance in enumerate(as_it_is.overturning) if chance >= MAY_FALL_FROM}


def effect_of(
    plan: FloorPlan,
    way: OtherTracks,
    state: RoomState,
    hits: Callable[[PersonPlace, Sequence[Track]], Hits] = hits_of,
) -> RoomEffect:
    """Return what changes bring, beside the room as it is, of the runs that neither gave up.

    Parameters
    ----------
    plan : FloorPlan
        The room with the places where they are then.
    way : OtherTracks
        How some pieces move otherwise.
    state : RoomState
        The room as it is.
    hits : callable
        Returns the contacts of a piece with a place.
    """
    _, as_it_is, ends = state
    tracks = [way.tracks.get(body, unchanged) for body, unchanged in enumerate(as_it_is.tracks)]
    before = as_it_is.events
    all_hits = tuple(
        tuple(
            hits(place, body_tracks) if body in way.tracks or place != was else known[body]
            for body, body_tracks in enumerate(tracks)
        )
        for place, was, known in zip(plan.places, ends.plan.places, before.hits, strict=True)
    )
    events = Events(all_hits, *(ends if plan == ends.plan else EndOfRuns(plan)).of_all(tracks))
    missing = as_it_is.missing | way.missing
    shape, after = missing.shape, hits_by(events)

    def chance(with_change: NDArray[np.bool_], without: NDArray[np.bool_]) -> tuple[Probability, Difference]:
        flags = anybody(with_change, shape)
        return probability(flags, missing), difference(flags, anybody(without, shape), missing)

    fell = [
        chance(_overturned(then), _overturned(now)) for then, now in zip(tracks, as_it_is.tracks, strict=True)
    ]
    return RoomEffect(
        *chance(after, hits_by(before)),
        *chance(events.shut_in, before.shut_in),
        *chance(events.blocked, before.blocked),
        risk_of(after, plan.places, missing),
        tuple(now for now, _ in fell),
        tuple(change for _, change in fell),
    )


def _overturned(tracks: Sequence[Track]) -> NDArray[np.bool_]:
    """Return in which runs a piece overturned, shape (1, runs)."""
    return np.array([[track.overturned for track in tracks]])


def compared(move: Move, state: RoomState) -> ChangeVerdict:
    """Return what a change brings, beside the room as it is."""
    return ChangeVerdict.of(move.change, effect_of(move.plan, move.way, state))


def _best_at_wall(
    question: Question, state: RoomState, body: int, wall: str, middles: list[tuple[float, float]]
) -> Move | None:
    """Return where along a wall a piece does least harm.

    It runs in the middle of those places; the tracks elsewhere are the same, shifted.
    """
    as_it_is, ways = state.as_it_is, state.ends.ways
    scenario, member = question.scenario, question.whole.pieces[body]
    heading = FACING[wall]
    same = abs(math.remainder(heading - member.heading, 2.0 * math.pi)) < 1e-9
    at = middles[len(middles) // 2]
    if same:
        tracks, missing = as_it_is.tracks[body], as_it_is.missing
        origin = np.array(member.at[:2])
    else:
        (runs,) = question.run([placed_elsewhere(question.whole, body, at, heading)])
        tracks, missing = runs.of_tracks(0), runs.missing
        origin = np.array(at)
    places, outlines = question.plan.places, [reach(track) for track in tracks]
    cells = [ways.cells(place.corners) for place in places]
    others = hits_by(as_it_is.events, but=body)
    best, least = None, math.inf
    for middle in middles:
        shift = np.array(middle) - origin
        if same and np.hypot(*shift) < SAME:
            continue
        question.advance(0)  # who has left may end it here
        over = swept(ways, [outline + shift for outline in outlines])
        hits = np.array([hit | over[:, at].any(axis=1) for at, hit in zip(cells, others, strict=True)])
        risk = risk_of(hits, places, missing)
        if risk < least - 1e-12:
            best, least = (middle, shift), risk
    if best is None:
        return None
    middle, shift = best
    change = Change(scenario.names[body], at=middle, heading=heading)
    shifted = OtherTracks({body: [track.shifted(shift) for track in tracks]}, missing)
    return Move(change, question.plan, shifted)


def _swept_by_any(as_it_is: Answer, ways: Ways) -> NDArray[np.bool_]:
    """Return over which cells any piece moves in each run at most, shape (runs, nx · ny)."""
    (over, *others) = (swept(ways, [reach(track) for track in tracks]) for tracks in as_it_is.tracks)
    for other in others:
        over |= other
    return over


def _best_place(
    here: PersonPlace, others: list[PersonPlace], over: NDArray[np.bool_], question: Question, ways: Ways
) -> PersonPlace | None:
    """Return where a place is hit least, the nearest of those that are alike."""

    def away(place: PersonPlace) -> float:
        shift = math.hypot(place.at[0] - here.at[0], place.at[1] - here.at[1])
        return shift + abs(math.remainder(place.heading - here.heading, math.pi))

    def key(place: PersonPlace) -> tuple[float, float]:
        question.advance(0)  # who has left may end it here
        share = over[:, ways.cells(place.corners)].any(axis=1).mean()
        return float(share), away(place)

    return min((place for place in others if away(place) >= SAME), key=key, default=None)
