"""`verify_room`: who is hit in a room by what, which door stays shut, and which single change helps most."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, within
from stayput.fragility.probabilities import probability
from stayput.montecarlo.counting import SLIDE_LIMIT, Quantiles
from stayput.montecarlo.hazard import FloorMotions, Hazard
from stayput.montecarlo.sampling import Settings
from stayput.montecarlo.several import draws_of_several
from stayput.progress import tally
from stayput.rooms.effects import Answer, RoomState, anybody, changes_of, hits_by, in_order, risk_of
from stayput.rooms.events import EndOfRuns, shares_covered
from stayput.rooms.runs import Question, RoomPart, groups_of
from stayput.rooms.verdict import (
    ChangeVerdict,
    DoorVerdict,
    HitVerdict,
    PlaceVerdict,
    RoomPiece,
    RoomVerdict,
    TypicalRun,
)
from stayput.scenario import Scenario
from stayput.simulation.placing import placed

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from numpy.typing import NDArray


def verify_room(
    scenario: Scenario,
    *,
    changes: bool = True,
    slide_limit: float = SLIDE_LIMIT,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int, int], None] | None = None,
    on_verdict: Callable[[RoomVerdict], None] | None = None,
) -> RoomVerdict:
    """Say who is hit in a room by what, which door stays shut, and which single change helps most.

    Every piece meets the same motions from the same directions and the same draws. A long piece on the floor
    runs in the plane across its length; short and round ones, and those that stand on each other, in space.
    Each runs without the others: where two meet is counted (`RoomVerdict.collisions`), and not followed.

    Parameters
    ----------
    scenario : Scenario
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
    on_verdict : callable, optional
        Called with what is known so far, which is not `complete`: after a few runs, after more of them, and
        after each change.

    Raises
    ------
    InputError
        A piece that stands in a wall, in another or where a person is; a record that cannot be read.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.Scenario.parse({
    ...     "plan": {"width": 3.0, "length": 2.5},
    ...     "furniture": [{"name": "shelf", "preset": "bookcase", "against": "left_wall", "along": 1.2}],
    ...     "places": [{"kind": "bed", "at": [1.4, 1.2], "heading": 1.5708}],
    ...     "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
    ...     "uncertainty": {"samples": 8},
    ... })
    >>> verdict = sp.verify_room(scenario, changes=False, progress=False)
    >>> verdict.hit.text, verdict.hit.runs
    ('36 to 94 %', 8)
    """
    began = time.perf_counter()
    limit = within("verification.slide_limit", slide_limit, 0.0, 1e3, "m", "slide_limit")
    question = question_of(scenario, threads)
    each = len(question.drawn) * len(question.drawn[0])
    total = len(groups_of(question.scenario)) * each
    with tally(total, "progress.verifying", progress, on_progress) as count:

        def reported(verdict: RoomVerdict) -> RoomVerdict:
            so_far = replace(verdict, runs=count.done, seconds=time.perf_counter() - began)
            if on_verdict is not None:
                on_verdict(so_far)
            return so_far

        (*_, last) = map(reported, _verdicts(question._replace(advance=count), limit, changes=changes))
    return replace(last, complete=True)


def question_of(scenario: Scenario, threads: int | None) -> Question:
    """Return a room with its motions and draws; nothing has run yet, and nobody hears of progress.

    Raises
    ------
    InputError
        A piece that stands in a wall, in another or where a person is; a record that cannot be read.
    """
    room = instance_of("scenario", scenario, Scenario)
    if room.plan is None:
        raise InputError("scenario.missing", "plan", allowed=phrase("rooms.no_plan"))
    whole = room.scene()
    with room.naming_keys():
        whole.refuse_wrong_places()
        placed(whole)  # refuses what cannot be put in place
    floors = floors_of(room, threads)
    settings = Settings.of(room, len(floors.motions), SLIDE_LIMIT)  # which changes no run
    drawn = draws_of_several(
        room.names,
        settings.motions,
        settings.samples,
        settings.seed,
        as_stated=settings.as_stated,
        quantities=settings.quantities,
        direction=room.direction,
    )
    return Question(room, whole, drawn, floors, threads)


def floors_of(room: Scenario, threads: int | None, times: float = 1.0) -> FloorMotions:
    """Return the motions under the furniture of a room, with those of the ground times a factor."""
    return Hazard.of(room).stated_by(room, threads, times)


def states(question: Question) -> Iterator[RoomState]:
    """Run a room as it is; yield what is known after a few runs, after more, and after all."""
    scenario, ends = question.scenario, EndOfRuns(question.plan)
    parts = [RoomPart.of(question.whole, group) for group in groups_of(scenario)]
    as_it_is: Answer | None = None
    for block in question.blocks():
        more = Answer.of(ends, parts, question.with_samples(*block).run(parts))
        as_it_is = more if as_it_is is None else as_it_is.joined(more)
        yield RoomState(parts, as_it_is, ends)


def _verdicts(question: Question, slide_limit: float, *, changes: bool) -> Iterator[RoomVerdict]:
    """Yield the verdict as it gets better: from some of the runs, from all, then change by change."""
    known: tuple[RoomState, RoomVerdict] | None = None
    for state in states(question):
        known = state, verdict_of(question, state, slide_limit)
        yield known[1]
    if changes and known is not None:
        (state, verdict), verdicts = known, list[ChangeVerdict]()
        for change in changes_of(question, state):
            verdicts.append(change)
            yield replace(verdict, changes=in_order(verdicts))


def verdict_of(question: Question, state: RoomState, slide_limit: float) -> RoomVerdict:
    """Return the verdict on a room as it is, which has run."""
    parts, as_it_is, ends = state
    scenario, plan, whole = question.scenario, question.plan, question.whole
    events, missing = as_it_is.events, as_it_is.missing
    shape = missing.shape
    hits = hits_by(events)
    in_plane = {body: part.in_plane for part in parts for body in part.bodies}
    masses = [member.body.mass for member in whole.pieces]
    pieces: list[RoomPiece] = []
    for body, (tracks, outcomes) in enumerate(zip(as_it_is.tracks, as_it_is.outcomes, strict=True)):
        fell = outcomes.overturned.ravel()
        pieces.append(
            RoomPiece(
                scenario.names[body],
                in_plane[body],
                outcomes.probabilities(slide_limit),
                Quantiles.of(outcomes.slide, outcomes.overturned),
                shares_covered(ends, tracks, fell),
                shares_covered(ends, tracks, ~fell),
                tracks[0].outline(0),
                risk_of(hits_by(events, only=body), plan.places, missing),
            )
        )
    pieces.sort(key=lambda piece: (-round(piece.risk, 9), -piece.probabilities["overturned"].estimate))
    at_rest, _ = ends.ways.shut_in(ends.ways.covered(runs[0].outline(0) for runs in as_it_is.tracks))
    motions, samples = shape
    return RoomVerdict(
        scenario=scenario,
        plan=plan,
        intensity=question.floors.median_intensity,
        hit=probability(anybody(hits, shape), missing),
        shut_in=probability(anybody(events.shut_in, shape), missing),
        blocked=probability(anybody(events.blocked, shape), missing),
        risk=risk_of(hits, plan.places, missing),
        places=tuple(_place(number, question, masses, as_it_is) for number in range(len(plan.places))),
        doors=tuple(
            DoorVerdict(door, probability(flags.reshape(shape), missing), stuck)
            for door, flags, stuck in zip(plan.doors, events.blocked, at_rest, strict=True)
        ),
        pieces=tuple(pieces),
        collisions={
            (scenario.names[a], scenario.names[b]): probability(met.reshape(shape), missing)
            for (a, b), met in as_it_is.met.items()
        },
        typical=_typical(question, as_it_is),
        motions=motions,
        samples=samples,
        slide_limit=slide_limit,
        seed=scenario.uncertainty.seed,
        floor=question.floors.floor,
    )


def _typical(question: Question, as_it_is: Answer) -> TypicalRun | None:
    """Return a run of what happens most often, under the motion under which it does so most often."""
    events, missing = as_it_is.events, as_it_is.missing
    hit, shut_in = (anybody(flags, missing.shape) for flags in (hits_by(events), events.shut_in))
    what = 2 * hit + shut_in
    counts = np.bincount(what[~missing], minlength=1)
    so = (what == counts.argmax()) & ~missing
    if not so.any():
        return None
    motion = int(so.sum(axis=1).argmax())
    return TypicalRun(motion + 1, question.drawn[motion][int(so[motion].argmax())].direction)


def _place(number: int, question: Question, masses: Sequence[float], as_it_is: Answer) -> PlaceVerdict:
    events, missing = as_it_is.events, as_it_is.missing
    shape, names = missing.shape, question.scenario.names
    by = [
        HitVerdict(
            names[body],
            masses[body],
            probability(hits.happened.reshape(shape), missing),
            _quantiles(hits.speed[hits.happened]),
            _quantiles(hits.energy[hits.happened]),
        )
        for body, hits in enumerate(events.hits[number])
        if hits.happened.any()
    ]
    by.sort(key=lambda hit: -hit.probability.estimate)
    return PlaceVerdict(
        question.plan.places[number],
        probability(events.hit(number).reshape(shape), missing),
        tuple(by),
        probability(events.shut_in[number].reshape(shape), missing),
    )


def _quantiles(values: NDArray[np.float64]) -> Quantiles:
    return Quantiles.of(values, np.zeros(values.shape, np.bool_))
