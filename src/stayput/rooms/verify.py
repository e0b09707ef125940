"""`verify_room`: who is hit in a room by what, which door stays shut, and which single change helps most."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputError, instance_of, within
from stayput.fragility import JMA_INTENSITY, difference, probability
from stayput.mechanics.columns import FAILED_OUTCOME
from stayput.model.floor_plan import FACING
from stayput.montecarlo.counting import SLIDE_LIMIT, Quantiles
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import Settings
from stayput.montecarlo.several import draws_of_several
from stayput.progress import bar
from stayput.rooms.changes import Change, FreeFloor, measures_tried, other_places, places_at_walls, swept
from stayput.rooms.events import EndOfRuns, Events, collisions, events_of, hits_of
from stayput.rooms.runs import groups_of, part_with, placed_elsewhere, run_parts
from stayput.rooms.verdict import (
    ChangeVerdict,
    DoorVerdict,
    HitVerdict,
    PieceInRoom,
    PlaceVerdict,
    RoomVerdict,
    presence,
)
from stayput.rooms.ways import Ways
from stayput.scenario.room import RoomScenario
from stayput.simulation.placing import bare

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.model.floor_plan import FloorPlan, Place
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.montecarlo.several import DrawOfSeveral
    from stayput.rooms.runs import Part, PartRuns
    from stayput.rooms.tracks import Track
    from stayput.simulation.standing import Assembly

Tracks = list[list["Track"]]
"""Where the pieces were, [body][run]."""


class _Question(NamedTuple):
    """What all runs of a verification share."""

    scenario: RoomScenario
    plan: FloorPlan
    whole: Assembly
    drawn: list[list[DrawOfSeveral]]
    floors: FloorMotions
    threads: int | None
    count: Callable[[int], None]

    def run(self, parts: Sequence[Part]) -> list[PartRuns]:
        """Run parts of the room under all draws."""
        gravity = self.scenario.gravity
        return run_parts(parts, self.drawn, self.floors, gravity, threads=self.threads, progress=self.count)


class _Answer(NamedTuple):
    """What happens in the room, as it is or with a change."""

    tracks: Tracks
    missing: NDArray[np.bool_]
    events: Events


def verify_room(
    scenario: RoomScenario,
    *,
    changes: bool = True,
    slide_limit: float = SLIDE_LIMIT,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int, int], None] | None = None,
) -> RoomVerdict:
    """Say who is hit in a room by what, which door stays shut, and which single change helps most.

    Every piece meets the same motions from the same directions and the same draws. A long piece on the floor
    runs in the plane across its length; short and round ones, and those that stand on each other, in space.
    Each runs without the others: where two meet is counted (`RoomVerdict.collisions`), and not followed.

    Parameters
    ----------
    scenario : RoomScenario
        The room.
    changes : bool
        Whether single changes are tried: a measure on each piece that does harm, another place for it, and
        for those whom it hits.
    slide_limit : float
        Slide that counts as too far [m].
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    on_progress : callable, optional
        Called with the runs made and with all runs, as far as they are known; an exception that it raises
        stops the work.

    Raises
    ------
    InputError
        A piece that stands in a wall, in another or where a person is; a record that cannot be read.
    """
    began = time.perf_counter()
    limit = within("verification.slide_limit", slide_limit, 0.0, 1e3, "m", "slide_limit")
    room = instance_of("scenario", scenario, RoomScenario)
    plan, whole, shaking = room.floor_plan(), room.assembly(room.stated), room.shaking
    refuse_what_stands_wrong(room, plan, whole)
    ground = room.ground()
    hazard = Hazard(ground, shaking.building, shaking.storey or 1, bool(shaking.vertical), 3)
    settings = Settings.of(room, len(ground), limit)
    drawn = draws_of_several(
        len(room.names),
        settings.motions,
        settings.samples,
        settings.seed,
        as_stated=settings.as_stated,
        any_direction=room.direction is None,
    )
    if room.direction is not None:
        drawn = [[draw._replace(direction=room.direction) for draw in row] for row in drawn]
    floors = hazard.stated(shaking.wanted_intensity, shaking.scale, threads)
    groups, each = groups_of(room), settings.motions * settings.samples
    total, made = len(groups) * each, 0
    with bar(total, "Verifying", progress) as advance:

        def count(runs: int) -> None:
            nonlocal made
            made += runs
            advance(runs)
            if on_progress is not None:
                on_progress(made, max(total, made))

        question = _Question(room, plan, whole, drawn, floors, threads, count)
        parts = [part_with(room, group, whole) for group in groups]
        runs = question.run(parts)
        ends = EndOfRuns(plan)
        as_it_is = _answer(ends, len(room.names), parts, runs)
        tried = _changes(question, parts, as_it_is, ends) if changes else ()
    return _verdict(
        question, parts, runs, as_it_is, ends, tried, ground_intensity(floors), limit, made, began
    )


def ground_intensity(floors: FloorMotions) -> float:
    """Return the median JMA intensity of the ground."""
    return float(np.median(floors.measures[JMA_INTENSITY]))


def refuse_what_stands_wrong(scenario: RoomScenario, plan: FloorPlan, whole: Assembly) -> None:
    """Raise `InputError` where a piece stands in a wall, or where a person is."""
    sides = np.array([plan.width, plan.length])
    for number, member in enumerate(whole.members):
        standing = bare(member)
        corners = standing.solid.vertices @ standing.turn.T + np.asarray(standing.at)
        low, high = corners.min(axis=0), corners.max(axis=0)
        name = f"furniture[{number}].at"
        if (low[:2] < -1e-6).any() or (high[:2] > sides + 1e-6).any():
            raise InputError(
                "rooms.in_a_wall",
                name,
                name=repr(scenario.names[number]),
                low_x=float(low[0]),
                high_x=float(high[0]),
                low_y=float(low[1]),
                high_y=float(high[1]),
                width=plan.width,
                length=plan.length,
            )


def _answer(ends: EndOfRuns, bodies: int, parts: Sequence[Part], runs: Sequence[PartRuns]) -> _Answer:
    tracks: Tracks = [[] for _ in range(bodies)]
    missing = np.zeros(runs[0].results.shape[:2], np.bool_)
    for part, own in zip(parts, runs, strict=True):
        missing |= (own.results["outcome"] == FAILED_OUTCOME).any(axis=-1)
        for place, body in enumerate(part.bodies):
            tracks[body] = [run[place] for run in own.tracks]
    return _Answer(tracks, missing, events_of(ends, tracks))


def _anybody(flags: NDArray[np.bool_], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return whether something happens in any row, shape (motions, samples)."""
    return flags.any(axis=0).reshape(shape) if len(flags) else np.zeros(shape, np.bool_)


def _hits(events: Events, but: int | None = None) -> NDArray[np.bool_]:
    """Return which places are hit by any piece but one, shape (places, runs)."""
    return np.array(
        [
            np.any([one.happened for body, one in enumerate(hits) if body != but], axis=0)
            if len(hits) > (but is not None)
            else np.zeros_like(hits[0].happened)
            for hits in events.hits
        ],
        np.bool_,
    )


def _risk(hits: NDArray[np.bool_], places: Sequence[Place], missing: NDArray[np.bool_]) -> float:
    """Return the chance that a person is hit, weighted by how long somebody is at each place."""
    known = ~missing.ravel()
    if not len(hits) or not known.any():
        return 0.0 if known.any() else math.nan
    alone = np.prod([1.0 - presence(p) * own[known] for p, own in zip(places, hits, strict=True)], axis=0)
    return float(np.mean(1.0 - alone))


def _changes(
    question: _Question, parts: Sequence[Part], as_it_is: _Answer, ends: EndOfRuns
) -> tuple[ChangeVerdict, ...]:
    """Return what single changes bring, the best first."""
    scenario, plan, whole = question.scenario, question.plan, question.whole
    ways, floor = Ways(plan), FreeFloor(plan, tuple(bare(one) for one in whole.members))
    harmful = _harmful(as_it_is, plan, ends)
    found: list[ChangeVerdict] = []
    tried = [
        (part, one)
        for part in parts
        if set(part.bodies) & harmful
        for one in measures_tried(scenario, whole, part.bodies)
    ]
    tried = [
        (part, (change, held))
        for part, (change, held) in tried
        if scenario.names.index(change.what) in harmful
    ]
    for (part, (change, _)), own in zip(tried, question.run([held for _, (_, held) in tried]), strict=True):
        found.append(
            _effect(change, dict(zip(part.bodies, zip(*own.tracks), strict=True)), question, as_it_is, ends)
        )
    for part in parts:
        (body, *others) = part.bodies
        if others or body not in harmful or not scenario.furniture[body].is_furniture:
            continue
        for wall, middles in places_at_walls(scenario, whole, body, floor):
            moved = _best_at_wall(question, body, wall, middles, as_it_is, ways)
            if moved is not None:
                found.append(_effect(*moved, question, as_it_is, ends))
    for number, place in enumerate(plan.places):
        if as_it_is.events.hit(number).any():
            other = _best_place(number, other_places(place, floor), question, as_it_is, ways)
            if other is not None:
                found.append(_effect_of_place(number, other, question, as_it_is))
    return tuple(sorted(found, key=lambda one: (round(one.risk, 4), one.shut_in.estimate, one.change.effort)))


def _harmful(as_it_is: _Answer, plan: FloorPlan, ends: EndOfRuns) -> set[int]:
    """Return the pieces without which less would happen."""
    events, missing = as_it_is.events, as_it_is.missing
    risk = _risk(_hits(events), plan.places, missing)
    found: set[int] = set()
    blocked = events.blocked.sum() + events.shut_in.sum()
    for body in range(len(as_it_is.tracks)):
        others = [own for number, own in enumerate(as_it_is.tracks) if number != body]
        less = _risk(_hits(events, but=body), plan.places, missing) < risk
        if not less and blocked and others:
            left = [ends.of(run) for run in zip(*others, strict=True)]
            less = sum(map(sum, (flags for both in left for flags in both))) < blocked
        if less or (blocked and not others):
            found.add(body)
    return found


def _effect(
    change: Change,
    instead: dict[int, Sequence[Track]],
    question: _Question,
    as_it_is: _Answer,
    ends: EndOfRuns,
) -> ChangeVerdict:
    """Return what it brings that some pieces have other tracks."""
    tracks = [list(instead.get(body, own)) for body, own in enumerate(as_it_is.tracks)]
    hits = tuple(
        tuple(hits_of(place, instead[body]) if body in instead else one for body, one in enumerate(own))
        for place, own in zip(question.plan.places, as_it_is.events.hits, strict=True)
    )
    found = [ends.of(run) for run in zip(*tracks, strict=True)]
    blocked, shut = (
        np.array([pair[i] for pair in found], np.bool_).reshape(len(found), -1).T for i in (0, 1)
    )
    return _compared(change, Events(hits, blocked, shut), question.plan, as_it_is)


def _effect_of_place(number: int, place: Place, question: _Question, as_it_is: _Answer) -> ChangeVerdict:
    """Return what it brings that a place is elsewhere."""
    places = tuple(place if n == number else one for n, one in enumerate(question.plan.places))
    plan = replace_places(question.plan, places)
    hits = tuple(
        tuple(hits_of(place, own) for own in as_it_is.tracks) if n == number else own
        for n, own in enumerate(as_it_is.events.hits)
    )
    ends = EndOfRuns(plan)
    found = [ends.of(run) for run in zip(*as_it_is.tracks, strict=True)]
    blocked, shut = (
        np.array([pair[i] for pair in found], np.bool_).reshape(len(found), -1).T for i in (0, 1)
    )
    change = Change(place.name, at=place.at, heading=place.heading)
    return _compared(change, Events(hits, blocked, shut), plan, as_it_is)


def replace_places(plan: FloorPlan, places: tuple[Place, ...]) -> FloorPlan:
    """Return a plan with other places."""
    return type(plan)(plan.width, plan.length, plan.doors, plan.windows, places)


def _compared(change: Change, events: Events, plan: FloorPlan, as_it_is: _Answer) -> ChangeVerdict:
    missing, shape = as_it_is.missing, as_it_is.missing.shape
    before, after = _hits(as_it_is.events), _hits(events)
    hit, was_hit = _anybody(after, shape), _anybody(before, shape)
    shut, was_shut = _anybody(events.shut_in, shape), _anybody(as_it_is.events.shut_in, shape)
    return ChangeVerdict(
        change,
        probability(hit, missing),
        difference(hit, was_hit, missing),
        probability(shut, missing),
        difference(shut, was_shut, missing),
        _risk(after, plan.places, missing),
    )


def _best_at_wall(
    question: _Question,
    body: int,
    wall: str,
    middles: list[tuple[float, float]],
    as_it_is: _Answer,
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
    others = _hits(as_it_is.events, but=body)
    best, least = None, math.inf
    for middle in middles:
        shift = np.array(middle) - origin
        if same and np.hypot(*shift) < 1e-3:
            continue
        moved = [track.moved(0.0, shift) for track in tracks]
        over = swept(ways, moved)
        hits = np.array(
            [
                own | (over & ways.covered([place.corners]).ravel()).any(axis=1)
                for place, own in zip(places, others, strict=True)
            ]
        )
        risk = _risk(hits, places, as_it_is.missing)
        if risk < least - 1e-12:
            best, least = (Change(scenario.names[body], at=middle, heading=heading), {body: moved}), risk
    return best


def _best_place(
    number: int, others: list[Place], question: _Question, as_it_is: _Answer, ways: Ways
) -> Place | None:
    """Return where a place is hit least, the nearest of those that are alike."""
    if not others:
        return None
    over = np.any([swept(ways, own) for own in as_it_is.tracks], axis=0)
    here = question.plan.places[number]

    def key(place: Place) -> tuple[float, float]:
        share = (over & ways.covered([place.corners]).ravel()).any(axis=1).mean()
        away = math.hypot(place.at[0] - here.at[0], place.at[1] - here.at[1])
        return float(share), away + abs(math.remainder(place.heading - here.heading, math.pi))

    return min(others, key=key)


def _verdict(
    question: _Question,
    parts: Sequence[Part],
    runs: Sequence[PartRuns],
    as_it_is: _Answer,
    ends: EndOfRuns,
    changes: tuple[ChangeVerdict, ...],
    intensity: float,
    slide_limit: float,
    made: int,
    began: float,
) -> RoomVerdict:
    scenario, plan = question.scenario, question.plan
    events, missing = as_it_is.events, as_it_is.missing
    shape = missing.shape
    hits = _hits(events)
    risk = _risk(hits, plan.places, missing)
    pieces: list[PieceInRoom] = []
    masses: dict[int, float] = {}
    for part, own in zip(parts, runs, strict=True):
        for place, body in enumerate(part.bodies):
            outcomes, tracks = own.of_body(place), as_it_is.tracks[body]
            masses[body] = bare(question.whole.members[body]).solid.mass
            pieces.append(
                PieceInRoom(
                    scenario.names[body],
                    part.in_plane,
                    outcomes.probabilities(slide_limit),
                    Quantiles.of(outcomes.slide, outcomes.overturned),
                    np.mean([ends.covered_by(track) for track in tracks], axis=0),
                    tracks[0].outline(0),
                    risk - _risk(_hits(events, but=body), plan.places, missing),
                )
            )
    pieces.sort(key=lambda piece: (-round(piece.share, 9), -piece.probabilities["overturned"].estimate))
    at_rest = ends.of([own[0].at_first for own in as_it_is.tracks])[0]
    motions, samples = shape
    return RoomVerdict(
        scenario=scenario,
        plan=plan,
        intensity=intensity,
        hit=probability(_anybody(hits, shape), missing),
        shut_in=probability(_anybody(events.shut_in, shape), missing),
        risk=risk,
        places=tuple(_place(number, question, masses, as_it_is) for number in range(len(plan.places))),
        doors=tuple(
            DoorVerdict(door, probability(flags.reshape(shape), missing), stuck)
            for door, flags, stuck in zip(plan.doors, events.blocked, at_rest, strict=True)
        ),
        pieces=tuple(pieces),
        collisions={
            (scenario.names[a], scenario.names[b]): probability(met.reshape(shape), missing)
            for (a, b), met in collisions(as_it_is.tracks).items()
        },
        changes=changes,
        motions=motions,
        samples=samples,
        runs=made,
        slide_limit=slide_limit,
        seed=scenario.uncertainty.seed,
        seconds=time.perf_counter() - began,
    )


def _place(number: int, question: _Question, masses: dict[int, float], as_it_is: _Answer) -> PlaceVerdict:
    events, missing = as_it_is.events, as_it_is.missing
    shape, names = missing.shape, question.scenario.names
    by = [
        HitVerdict(
            names[body],
            masses[body],
            probability(one.happened.reshape(shape), missing),
            Quantiles.of(one.speed[one.happened], np.zeros(one.happened.sum(), np.bool_)),
            Quantiles.of(one.energy[one.happened], np.zeros(one.happened.sum(), np.bool_)),
        )
        for body, one in enumerate(events.hits[number])
        if one.happened.any()
    ]
    by.sort(key=lambda one: -one.probability.estimate)
    return PlaceVerdict(
        question.plan.places[number],
        probability(events.hit(number).reshape(shape), missing),
        tuple(by),
        probability(events.shut_in[number].reshape(shape), missing),
    )
