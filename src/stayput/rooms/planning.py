"""`action_plan`: which moves and measures help most in a room, how strong they must be, and in which order.

One thing at most is moved, what brings most, unless it has been decided what to move. On each piece that does
harm, or overturns often wherever it falls, come the measures that have been decided on, else the set with
which it does least harm by itself; a device on a wall comes in such a number that what it is screwed to bears
it, as far as the studs behind the piece allow. All runs are under the same earthquakes and draws.
"""

from __future__ import annotations

import time
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of
from stayput.measures.edges import WedgeStopper
from stayput.measures.floor import SOFT
from stayput.motion.intensity import factor_to_intensity, intensity_of_class
from stayput.progress import tally
from stayput.rooms.changes import Change, held_part, measures_for
from stayput.rooms.decisions import Decisions, decisions_of, elsewhere, moved_as_decided
from stayput.rooms.effects import OtherTracks, effect_of, falling_pieces, harmful_pieces, moves_of, risk_of
from stayput.rooms.events import Hits, hits_of
from stayput.rooms.runs import PartRuns, RoomPart, group_of, with_measures
from stayput.rooms.step_words import why_not
from stayput.rooms.steps import (
    ALIKE,
    SETS,
    ActionPlan,
    ChosenStep,
    Fix,
    Home,
    PlanStep,
    Purchase,
    Trial,
    for_people,
    frees,
    in_number,
    in_order_of_gain,
    merit,
    purchases_of,
)
from stayput.rooms.verdict import RoomEffect, RoomVerdict
from stayput.rooms.verify import floors_of, question_of, states, verdict_of
from stayput.simulation.placing import placed
from stayput.verification.options import inputs_in_room

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from stayput.catalogue import Phrase
    from stayput.fragility.probabilities import Probability
    from stayput.measures import Measure
    from stayput.model.floor_plan import FloorPlan, PersonPlace
    from stayput.rooms.effects import Move, RoomState
    from stayput.rooms.runs import Question
    from stayput.rooms.steps import NotTaken
    from stayput.rooms.tracks import Track
    from stayput.simulation.scene import Scene

WEAKER_CLASSES = ("6-upper", "6-lower", "5-upper", "5-lower", "4")
"""Classes of intensity, the strongest first, in which it is tried whether a device that is too weak holds."""


def action_plan(
    verdict: RoomVerdict,
    *,
    decided: Sequence[Change] = (),
    no_drilling: bool = False,
    tatami: bool = False,
    plasterboard: bool = False,
    dropped_ceiling: bool = False,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int], None] | None = None,
) -> ActionPlan:
    """Say what to move in a room, what to buy for which piece and how strong, and what each brings.

    Parameters
    ----------
    verdict : RoomVerdict
        The room. Its earthquakes and draws are used again; its single changes are not needed.
    decided : sequence of Change
        Changes that are made in any case, such as ``[verdict.best.change]``: they are steps of the plan,
        whatever they bring, and nothing else is moved or put on the same piece.
    no_drilling : bool
        Whether nothing else may be screwed to a wall.
    tatami, plasterboard, dropped_ceiling : bool
        What floor, walls and ceiling are, where the scenario does not say: tatami; plasterboard without studs
        that can be used; a ceiling on wires, against which no pole may push. The room is verified anew with
        them.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    on_progress : callable, optional
        Called with the number of runs just made; an exception that it raises stops the work.

    Raises
    ------
    InputError
        A decided change of something that is not in the room, or is moved twice; a move to where it cannot
        stand; a measure that cannot be put in place. A scenario that says otherwise of the home.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.Scenario.parse({
    ...     "plan": {"width": 2.4, "length": 2.0},
    ...     "furniture": [{"name": "shelf", "preset": "bookcase", "against": "left_wall", "along": 1.0}],
    ...     "places": [{"kind": "desk", "at": [1.3, 1.0]}],
    ...     "shaking": {"intensity": "6-lower", "suite": {"family": "near-fault", "count": 3}},
    ...     "uncertainty": {"samples": 3},
    ... })
    >>> verdict = sp.verify_room(scenario, changes=False, progress=False)
    >>> plan = sp.action_plan(verdict, progress=False)
    >>> [(step.what, step.fix.kinds) for step in plan.steps]
    [('shelf', ('l_bracket',))]
    """
    began = time.perf_counter()
    asked = instance_of("verdict", verdict, RoomVerdict)
    home = Home(no_drilling, tatami, plasterboard, dropped_ceiling)
    with tally(None, "progress.planning", progress) as made:

        def count(runs: int) -> None:
            made(runs)
            if on_progress is not None:
                on_progress(runs)

        question = question_of(home.of(asked.scenario), threads)._replace(advance=count)
        (*_, state) = states(question)
        planner = _Planner(question, state, home, decisions_of(question, decided))
        steps, unsolved = planner.steps()
    as_it_is = verdict_of(question, state, asked.slide_limit)
    now = replace(as_it_is, complete=True, runs=made.done, seconds=time.perf_counter() - began)
    return ActionPlan(now, home, steps, unsolved, planner.drilled, planner.reasons())


class _Planner:
    """The steps of a plan.

    Parameters
    ----------
    question : Question
        The room, its motions and draws.
    state : RoomState
        The room as it is.
    home : Home
        What the home is like.
    decisions : Decisions
        What is done in any case.
    """

    def __init__(self, question: Question, state: RoomState, home: Home, decisions: Decisions) -> None:
        self.question, self.state, self.home, self.decisions = question, state, home, decisions
        hits = state.as_it_is.events.hits
        struck = {body for row in hits for body, hit in enumerate(row) if hit.happened.any()}
        self.harmful = struck | harmful_pieces(state)
        self.falling = falling_pieces(state.as_it_is)
        self.drilled: dict[str, Fix] = {}
        self._not_taken: dict[str, dict[tuple[str, ...], Phrase]] = {}
        self._groups: dict[frozenset[str], OtherTracks] = {}
        self._known: dict[tuple[int, PersonPlace], tuple[Sequence[Track], Hits]] = {}

    def steps(self) -> tuple[tuple[PlanStep, ...], tuple[str, ...]]:
        """Return the steps in their order, and the pieces on which nothing helps."""
        names = self.question.scenario.names
        moves = self._moves()
        chosen = [self._moving(move, effect) for move, effect in moves]
        moved = {move.change.what for move, _ in moves}
        whole = self._after([move for move, _ in moves])
        unsolved: list[str] = []
        for body in sorted(self.harmful | self.falling | set(self.decisions.measures)):
            fixing = self._fixing(body, whole)
            if fixing is not None:
                chosen.append(fixing)
            elif names[body] not in moved or body in self.falling:
                unsolved.append(names[body])
        steps = tuple(self._in_order([*chosen]))
        kept = {step.what for step in steps if step.fix is not None}
        for fix, what in ((choice.step.fix, choice.step.what) for choice in chosen):
            if fix is not None and what not in kept:
                self._not_taken[what][fix.kinds] = phrase("action_plan.not_needed")
        return steps, tuple(unsolved)

    def reasons(self) -> dict[str, NotTaken]:
        """Return why sets of measures were not taken on the pieces, in the order in which they are tried."""
        return {
            name: {kinds: why[kinds] for kinds in SETS if kinds in why}
            for name, why in self._not_taken.items()
            if why
        }

    def _in_order(self, chosen: list[ChosenStep]) -> Iterable[PlanStep]:
        """Yield the steps that are needed, each time that which brings most with those before it.

        One that has not been decided on, and without which the others bring as much, is not needed.
        """
        needed = self._by_gain(chosen)
        reached = in_order_of_gain(self._together(needed))
        for choice in [choice for choice in reversed(needed) if not choice.step.decided]:
            others = [other for other in needed if other is not choice]
            without = in_order_of_gain(self._together(others))
            if without <= reached:
                needed, reached = others, without
        all_of_them = for_people(self._together(needed))
        for number, choice in enumerate(needed, start=1):
            others = [other for other in needed if other is not choice]
            yield replace(
                choice.step,
                together=self._together(needed[:number]),
                for_people=for_people(self._together(others)) > all_of_them,
            )

    def _by_gain(self, chosen: list[ChosenStep]) -> list[ChosenStep]:
        done: list[ChosenStep] = []
        while chosen:
            effects = [self._together([*done, choice]) for choice in chosen]
            keys = [
                (in_order_of_gain(effect), choice.step.cost_class, in_order_of_gain(choice.step.alone))
                for choice, effect in zip(chosen, effects, strict=True)
            ]
            done.append(chosen.pop(keys.index(min(keys))))
        return done

    def _together(self, done: list[ChosenStep]) -> RoomEffect:
        """Return what some of the steps bring together."""
        moves = [choice for choice in done if choice.step.move is not None]
        relocated = {choice.step.what for choice in moves}
        way = OtherTracks({}, self.state.as_it_is.missing)
        for choice in moves:
            way = way.joined(choice.here)
        fixes: dict[tuple[int, ...], list[ChosenStep]] = {}
        for choice in done:
            if choice.step.fix is not None:
                fixes.setdefault(choice.step.fix.part.bodies, []).append(choice)
        for group, choices in fixes.items():
            if len(choices) > 1:
                way = way.joined(self._held_together(group, choices))
            else:
                (choice,) = choices
                way = way.joined(choice.there if choice.step.what in relocated else choice.here)
        places = dict(choice.place for choice in moves if choice.place)
        return self._effect(self.question.plan.with_places(places), way)

    def _held_together(self, group: tuple[int, ...], fixes: Sequence[ChosenStep]) -> OtherTracks:
        """Return how pieces that stand on or are joined to each other move, of which several are held."""
        key = frozenset(choice.step.what for choice in fixes)
        if key not in self._groups:
            whole = self.question.whole
            for choice in fixes:
                assert choice.step.fix is not None
                body = group[choice.step.fix.place]
                bought = [purchase.measure for purchase in choice.step.fix.purchases]
                whole = with_measures(whole, body, bought)
            part = RoomPart.of(whole, group)
            runs = self.question.run([part])[0]
            self._groups[key] = OtherTracks.of(part, runs)
        return self._groups[key]

    def _hits(self, place: PersonPlace, tracks: Sequence[Track]) -> Hits:
        """Return the contacts of a piece with a place, which are looked for once."""
        key = id(tracks), place
        if key not in self._known:
            self._known[key] = tracks, hits_of(place, tracks)  # its tracks stay, so that the id is theirs
        return self._known[key][1]

    def _effect(self, plan: FloorPlan, way: OtherTracks) -> RoomEffect:
        return effect_of(plan, way, self.state, self._hits)

    def _moves(self) -> list[tuple[Move, RoomEffect]]:
        """Return what it has been decided to move, else the move that clearly helps and helps most, if any.

        With each what it brings.
        """
        question, state = self.question, self.state
        decided = [moved_as_decided(question, state.as_it_is, change) for change in self.decisions.moves]
        moves = decided or moves_of(question, state, self.harmful - set(self.decisions.measures))
        tried = [(move, self._effect(move.plan, move.way)) for move in moves]
        if decided:
            return tried
        helping = [pair for pair in tried if pair[1].helps]
        return [min(helping, key=lambda pair: in_order_of_gain(pair[1]))] if helping else []

    def _moving(self, move: Move, effect: RoomEffect) -> ChosenStep:
        scenario, what = self.question.scenario, move.change.what
        bodies = list(move.way.tracks) or sorted(self.harmful)
        deciding = {quantity: None for body in bodies for quantity in inputs_in_room((), scenario, body)}
        overturned = self._overturned(bodies[0]) if move.way.tracks else None
        decided = move.change in self.decisions.moves
        step = PlanStep(
            what, move.change, None, effect, effect, overturned, None, tuple(deciding), decided=decided
        )
        was = self.question.plan.places
        places = ((n, place) for n, place in enumerate(move.plan.places) if place != was[n])
        return ChosenStep(step, next(places, None), move.way, move.way)

    def _after(self, moves: Sequence[Move]) -> Scene:
        """Return the pieces with some moved."""
        whole = self.question.whole
        for move in moves:
            for body in move.way.tracks:
                whole = whole.with_piece(body, elsewhere(whole.pieces[body], move.change))
        return whole

    def _overturned(self, body: int) -> Probability:
        return self.state.as_it_is.outcomes[body].probability_of_overturning()

    def _fixing(self, body: int, whole: Scene) -> ChosenStep | None:
        """Return the best measures on a piece, which stands in ``whole`` as it is to stand."""
        decided = self.decisions.measures.get(body)
        why = self._not_taken.setdefault(self.question.scenario.names[body], {})
        if decided is None:
            why.update({kinds: phrase("action_plan.drills") for kinds in SETS if not self.home.allows(kinds)})
            tried = self._helpful(body, whole, [kinds for kinds in SETS if self.home.allows(kinds)])
        else:
            tried = [self._tried_as_decided(body, whole, decided)]
        if not tried:
            self._with_drilling(body, whole)
            return None
        best = min(tried, key=merit)
        fix, here, there = self._fitted(best, body, whole)
        if not fix.enough:
            self._with_drilling(body, whole)
        undrilled = [trial for trial in tried if not any(measure.drilled for measure in trial.measures)]
        instead = None
        if fix.drilled and undrilled:
            instead = self._fitted(min(undrilled, key=merit), body, whole)[0]
        shown = {way.kinds for way in (fix, instead) if way is not None}
        why.update({trial.kinds: why_not(trial, best) for trial in tried if trial.kinds not in shown})
        scenario, was = self.question.scenario, self._overturned(body)
        deciding = inputs_in_room(tuple(purchase.measure for purchase in fix.purchases), scenario, body)
        what, alone, as_decided = scenario.names[body], fix.alone, decided is not None
        step = PlanStep(what, None, fix, alone, alone, was, instead, deciding, decided=as_decided)
        return ChosenStep(step, None, here, there)

    def _with_drilling(self, body: int, whole: Scene) -> None:
        """Keep the best measures on a piece of those that only the ban on drilling rules out, if any."""
        tried = self._helpful(body, whole, [kinds for kinds in SETS if not self.home.allows(kinds)])
        if tried:
            name = self.question.scenario.names[body]
            self.drilled[name] = self._fitted(min(tried, key=merit), body, whole)[0]

    def _helpful(self, body: int, whole: Scene, sets: Sequence[tuple[str, ...]]) -> list[Trial]:
        """Run sets of measures on a piece, and return those that help and can be put on it in ``whole``."""
        as_it_is, group = self.state.as_it_is, group_of(self.question.scenario, body)
        here = OtherTracks({number: as_it_is.tracks[number] for number in group}, as_it_is.missing)
        bare, why = self._own_risk(here), self._not_taken[self.question.scenario.names[body]]
        helpful: list[Trial] = []
        for trial in self._tried(body, sets):
            if not (trial.piece_risk < bare or frees(trial.effect) or self._steadies(trial, body)):
                why[trial.kinds] = why_not(trial)
            elif refused := self._refused(body, trial.measures, whole):
                why[trial.kinds] = refused
            else:
                helpful.append(trial)
        return helpful

    def _tried_as_decided(self, body: int, whole: Scene, measures: tuple[Measure, ...]) -> Trial:
        """Run the measures that have been decided on, where the piece stands or, if it must, is to stand."""
        here = self.question.whole
        part = self._with(body, measures, whole if self._refused(body, measures, here) else here)
        return self._as_tried(measures, part, self.question.run([part])[0], body)

    def _steadies(self, tried: Trial, body: int) -> bool:
        """Return whether a piece that overturns often does so less with measures, clearly or not."""
        less = self._overturned(body).estimate - tried.overturns.estimate
        return body in self.falling and less > ALIKE

    def _tried(self, body: int, sets: Sequence[tuple[str, ...]]) -> list[Trial]:
        """Run sets of measures, those that can be put on a piece where it stands."""
        parts: list[tuple[tuple[Measure, ...], RoomPart]] = []
        here, why = self.question.whole, self._not_taken[self.question.scenario.names[body]]
        for kinds in sets:
            measures = measures_for(kinds, here, body)
            if refused := self._refused(body, measures, here):
                why[kinds] = refused
            else:
                parts.append((measures, self._with(body, measures, here)))
        runs = self.question.run([part for _, part in parts])
        return [
            self._as_tried(measures, part, part_runs, body)
            for (measures, part), part_runs in zip(parts, runs, strict=True)
        ]

    def _as_tried(self, measures: tuple[Measure, ...], part: RoomPart, runs: PartRuns, body: int) -> Trial:
        way = OtherTracks.of(part, runs)
        effect, piece_risk = self._effect(self.question.plan, way), self._own_risk(way)
        overturns = runs.of_body(part.bodies.index(body)).probability_of_overturning()
        return Trial(measures, way, effect, piece_risk, overturns, runs.probability_of_failure())

    def _own_risk(self, way: OtherTracks) -> float:
        """Return the chance that a person is hit by some pieces, whatever others do."""
        places, missing = self.question.plan.places, self.state.as_it_is.missing | way.missing
        hits = [[self._hits(place, tracks).happened for tracks in way.tracks.values()] for place in places]
        return risk_of(np.any(hits, axis=1), places, missing) if places else 0.0

    def _refused(self, body: int, measures: tuple[Measure, ...], whole: Scene) -> Phrase | None:
        """Return why measures cannot be put on a piece; None where they can."""
        soft = whole.room.floor.surface in SOFT
        for measure in measures:
            if soft and isinstance(measure, WedgeStopper):
                return phrase("measures.wedge_sinks", measure=measure.label)
        try:
            held_part(self.question.scenario, whole, body, measures)
        except InputError as error:
            sentence = error.told("en").removesuffix("."), error.told("ja").removesuffix("。")
            return phrase("action_plan.not_possible", why=sentence)
        return None

    def _with(self, body: int, measures: tuple[Measure, ...], whole: Scene) -> RoomPart:
        """Return the part of a piece with measures on it, which have not been put in place."""
        scenario = self.question.scenario
        return RoomPart.of(with_measures(whole, body, measures), group_of(scenario, body))

    def _fitted(self, tried: Trial, body: int, whole: Scene) -> tuple[Fix, OtherTracks, OtherTracks]:
        """Return measures as they are bought, and how the piece moves where it stands and where it will.

        Where the studs allow it there are as many devices as what they are screwed to asks for.
        """
        measures, part = tried.measures, self._with(body, tried.measures, whole)
        purchases = purchases_of(self.question, part, measures, body)
        piece = whole.pieces[body]
        fitted = tuple(in_number(purchase, piece.body.length or 0.0) for purchase in purchases)
        if fitted != measures and not any(
            self._refused(body, fitted, scene) for scene in (whole, self.question.whole)
        ):
            measures, part = fitted, self._with(body, fitted, whole)
            purchases = purchases_of(self.question, part, measures, body)
            here = self._with(body, fitted, self.question.whole)
            tried = self._as_tried(measures, here, self.question.run([here])[0], body)
        place = part.bodies.index(body)
        there, overturns, gives_way = tried.way, tried.overturns, tried.gives_way
        if whole is not self.question.whole:
            runs = self.question.run([part])[0]
            there = OtherTracks.of(part, runs)
            overturns = runs.of_body(place).probability_of_overturning()
            gives_way = runs.probability_of_failure()
        held = placed(part.scene)[place].held
        assert held is not None
        cautions = tuple(
            caution for measure in measures for caution in measure.cautions(held.body, held.room)
        )
        enough_to = self._enough_to(part, purchases, body)
        fix = Fix(part, place, purchases, tried.effect, overturns, gives_way, cautions, enough_to)
        return fix, tried.way, there

    def _enough_to(self, part: RoomPart, purchases: tuple[Purchase, ...], body: int) -> float | None:
        """Return the JMA intensity, a class's middle, for which what is too weak here is strong enough.

        The classes are the ground's: under motions of upper floors there is none.
        """
        if self.question.floors.floor or all(purchase.enough for purchase in purchases):
            return None
        measures = tuple(purchase.measure for purchase in purchases)
        now, threads = self.question.floors.median_intensity, self.question.threads
        for level in (intensity_of_class(name) for name in WEAKER_CLASSES):
            if level < now:
                floors = floors_of(self.question.scenario, threads, factor_to_intensity(now, level))
                weaker = self.question._replace(floors=floors)
                if all(purchase.enough for purchase in purchases_of(weaker, part, measures, body)):
                    return level
        return None
