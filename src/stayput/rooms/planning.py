"""`action_plan`: which moves and measures help most in a room, how strong they must be, and in which order.

One thing at most is moved, what brings most, unless it has been decided what to move. On each piece that does
harm, or overturns often wherever it falls, come the measures that have been decided on, else that set with
which it does least harm by itself, of those that clearly help and are not too weak; a device on a wall comes
in such a number that what it is screwed to bears it, as far as the studs behind the piece allow. All runs are
under the same earthquakes and draws.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, instance_of
from stayput.measures.measure import identity_of
from stayput.montecarlo.counting import OVERTURNED
from stayput.progress import tally
from stayput.rooms.purchases import in_number, purchases_of
from stayput.rooms.step_words import why_not
from stayput.rooms.steps import (
    ActionPlan,
    ChosenStep,
    Decisions,
    Fix,
    Home,
    NotTaken,
    PlanStep,
    Trial,
    decisions_of,
    for_people,
    in_order_of_gain,
    merit,
)
from stayput.simulation.groups import groups_of_falls
from stayput.simulation.placing import placed
from stayput.simulation.space_fate import MAY_FALL_FROM
from stayput.verification.changes import Change, measures_for, refuse_unheld, with_changes
from stayput.verification.compare import option_verdict
from stayput.verification.meetings import with_meetings
from stayput.verification.option_runner import OptionRunner
from stayput.verification.options import TRIED, compared_options, inputs_of_piece
from stayput.verification.people import hits_in
from stayput.verification.search import falling_pieces, harmful_pieces, moves_of
from stayput.verification.verdict import OptionVerdict, Verdict

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.measures import Measure
    from stayput.scenario.measures import Option

PLAN_RUNS = 32
"""Runs of what a plan tells: from so many a half-width of 16 points."""

MOST_AS_IT_IS = 64
"""Most runs of the room as it is, which has as many as in its verdict, so that both tell the same."""

TRIAL_RUNS, CANDIDATES = 8, 2
"""Runs of all that is tried, and how many of the best of it are then run as often as what is told."""


def action_plan(
    verdict: Verdict,
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
    verdict : Verdict
        The room. Its earthquakes and draws are used again, and its runs, if no room was verified since; its
        single changes are not needed.
    decided : sequence of Change
        Changes that are made in any case, such as ``verdict.changes(verdict.helping)``: they are steps of the
        plan, whatever they bring, and nothing else is moved or put on the same piece.
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
    ...     "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
    ...     "uncertainty": {"samples": 8},
    ... })
    >>> verdict = sp.verify(scenario, changes=False, progress=False)
    >>> plan = sp.action_plan(verdict, progress=False)
    >>> [(step.what, step.fix.kinds) for step in plan.steps]
    [('shelf', ('l_bracket',))]
    """
    began = time.perf_counter()
    asked = instance_of("verdict", verdict, Verdict)
    if asked.scenario.plan is None:
        raise InputError("scenario.missing", "plan", allowed=phrase("rooms.no_plan"))
    home = Home(no_drilling, tatami, plasterboard, dropped_ceiling)
    with tally(None, "progress.planning", progress) as made:

        def count(runs: int) -> None:
            made(runs)
            if on_progress is not None:
                on_progress(runs)

        scenario = home.of(asked.scenario)
        compared_options(scenario)  # refuses what cannot be put in place
        runner = OptionRunner(scenario, asked.slide_limit, threads, advance=count)
        as_it_is = min(max(PLAN_RUNS, asked.without.runs), MOST_AS_IT_IS)
        planner = _Planner(runner, home, decisions_of(scenario, decided), as_it_is)
        steps, unsolved = planner.steps()
        if steps:
            steps = *steps[:-1], replace(steps[-1], together=with_meetings(runner, steps[-1].together))
    now = replace(
        asked,
        scenario=scenario,
        options=(replace(with_meetings(runner, planner.as_it_is), rank=1),),
        runs=made.done,
        seconds=time.perf_counter() - began,
        complete=True,
    )
    return ActionPlan(
        now, home, steps, unsolved, planner.drilled, planner.reasons(), not_enough=planner.not_enough
    )


class _Planner:
    """The steps of a plan.

    Parameters
    ----------
    runner : OptionRunner
        The room's motions and draws.
    home : Home
        What the home is like.
    decisions : Decisions
        What is done in any case.
    as_it_is : int
        Runs of the room as it is.
    """

    def __init__(self, runner: OptionRunner, home: Home, decisions: Decisions, as_it_is: int) -> None:
        self.runner, self.home, self.decisions = runner, home, decisions
        self.scenario, self.base = runner.scenario, runner.scenario.stated
        self._members = runner.members.chosen(slice(as_it_is))
        (self.runs,) = runner.run([self.base], self._members, keep=True)
        self.as_it_is = option_verdict(runner, self.base, self.runs, None)
        self.scene = runner.scene(self.base)
        self.group_of = {body: group for group in groups_of_falls(self.scene) for body in group}
        struck = np.flatnonzero(hits_in(self.runs).any(axis=(0, 1))).tolist()
        self.harmful = {*struck} | harmful_pieces(runner, self.base, self.runs)
        self.falling = falling_pieces(self.runs)
        self.drilled: dict[str, Fix] = {}
        self.not_enough: dict[str, Fix] = {}
        self._not_taken: dict[str, dict[tuple[str, ...], Phrase]] = {}
        self._known: dict[Hashable, OptionVerdict] = {}
        # whether a set on a piece brings something, even if it is too weak: two together may then be enough
        self._clear: dict[tuple[int, tuple[str, ...]], bool] = {}
        self.moves = self._moves()

    def steps(self) -> tuple[tuple[PlanStep, ...], tuple[str, ...]]:
        """Return the steps in their order, and the pieces on which nothing helps."""
        names = self.scenario.names
        chosen = [ChosenStep(self._moving(move), (move,)) for move in self.moves]
        moved = {move.what for move in self.moves}
        unsolved: list[str] = []
        for body in sorted(self.harmful | self.falling | set(self.decisions.measures)):
            fixing = self._fixing(body)
            if fixing is not None:
                chosen.append(fixing)
            elif names[body] in moved and body not in self.falling:
                self.not_enough.pop(names[body], None)
            elif names[body] not in self.not_enough:
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
            name: {kinds: why[kinds] for kinds in TRIED if kinds in why}
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

    def _together(self, done: Iterable[ChosenStep]) -> OptionVerdict:
        """Return what some of the steps bring together."""
        return self._effect([change for choice in done for change in choice.changes])

    def _with(self, changes: Iterable[Change]) -> Option:
        return with_changes(self.base, changes, self.scenario.names)

    def _effect(self, changes: Sequence[Change], count: int = PLAN_RUNS) -> OptionVerdict:
        """Return what changes bring in the first so many runs."""
        ordered = sorted(changes, key=repr)
        measures = tuple(change.measure and identity_of(change.measure) for change in ordered)
        key = repr(ordered), measures, count
        if key not in self._known:
            option = self._with(changes)
            (runs,) = self.runner.run([option], self._members.chosen(slice(count)))
            self._known[key] = option_verdict(self.runner, option, runs, self.runs)
        return self._known[key]

    def _moves(self) -> tuple[Change, ...]:
        """Return what it has been decided to move, else the move that clearly helps and helps most."""
        if self.decisions.moves:
            return self.decisions.moves
        may_move = self.harmful - set(self.decisions.measures)
        moves = [*moves_of(self.runner, self.base, self.runs, may_move)]
        moves.sort(key=lambda move: in_order_of_gain(self._effect([move], TRIAL_RUNS)))
        helping = [move for move in moves[:CANDIDATES] if self._effect([move]).helps]
        return (min(helping, key=lambda move: in_order_of_gain(self._effect([move]))),) if helping else ()

    def _moving(self, move: Change) -> PlanStep:
        scenario, effect = self.scenario, self._effect([move])
        body = scenario.names.index(move.what) if move.what in scenario.names else None
        bodies = sorted(self.harmful) if body is None else [body]
        deciding = {quantity: None for number in bodies for quantity in inputs_of_piece((), scenario, number)}
        overturned = None if body is None else self._overturned(body)
        decided = move in self.decisions.moves
        return PlanStep(
            move.what, move, None, effect, effect, overturned, None, tuple(deciding), decided=decided
        )

    def _overturned(self, body: int) -> Probability:
        return self.as_it_is.pieces[body].probabilities[OVERTURNED]

    def _fixing(self, body: int) -> ChosenStep | None:
        """Return the best measures on a piece.

        Where they are too weak, or do not clearly help, they are not enough, and no step.
        """
        decided = self.decisions.measures.get(body)
        why = self._not_taken.setdefault(self.scenario.names[body], {})
        if decided is None:
            why |= {kinds: phrase("action_plan.drills") for kinds in TRIED if not self.home.allows(kinds)}
            tried, sound = self._tried(body, self.home.allows)
        else:
            tried, sound = [self._trial(body, decided)], None
        if not tried:
            self._with_drilling(body)
            return None
        fix = sound or self._fitted(self._in_full(min(tried, key=merit), body), body)
        if not fix.enough or not fix.alone.helps:
            self._with_drilling(body)
        undrilled = [trial for trial in tried if not any(measure.drilled for measure in trial.measures)]
        instead = self._sound(undrilled, body) if fix.drilled else None
        shown = {way.kinds for way in (fix, instead) if way is not None}
        best = next(trial for trial in tried if trial.kinds == fix.kinds)
        for trial in tried:
            if trial.kinds not in shown:
                why.setdefault(trial.kinds, why_not(trial, best))
        measures, was = tuple(purchase.measure for purchase in fix.purchases), self._overturned(body)
        deciding = inputs_of_piece(measures, self.scenario, body)
        what, alone, as_decided = self.scenario.names[body], fix.alone, decided is not None
        if not sound and not as_decided:
            self.not_enough[what] = fix
            why.pop(fix.kinds, None)  # it is told beside the fix, of more runs
            return None
        step = PlanStep(what, None, fix, alone, alone, was, instead, deciding, decided=as_decided)
        return ChosenStep(step, self._on(body, measures))

    def _with_drilling(self, body: int) -> None:
        """Keep the best measures on a piece that only the ban on drilling rules out, where they are sound."""
        if fix := self._tried(body, lambda kinds: not self.home.allows(kinds))[1]:
            self.drilled[self.scenario.names[body]] = fix

    def _tried(self, body: int, allowed: Callable[[tuple[str, ...]], bool]) -> tuple[list[Trial], Fix | None]:
        """Run sets of measures on a piece, two together where one is too weak; also return what is sound."""
        single, double = ([kinds for kinds in TRIED if len(kinds) == n and allowed(kinds)] for n in (1, 2))
        tried = self._helpful(body, single)
        sound = self._sound(tried, body)
        if sound is None and (not tried or any(self._clear.get((body, trial.kinds)) for trial in tried)):
            tried += self._helpful(body, double)
            sound = self._sound(tried, body)
        else:
            why = self._not_taken[self.scenario.names[body]]
            why |= {kinds: phrase("action_plan.pair_not_tried") for kinds in double if kinds not in why}
        return tried, sound

    def _sound(self, tried: Iterable[Trial], body: int) -> Fix | None:
        """Return the best measures that clearly help and are not too weak."""
        why = self._not_taken[self.scenario.names[body]]
        candidates = sorted(tried, key=merit)[:CANDIDATES]
        if not self._may_help(body):
            why |= {trial.kinds: phrase("action_plan.no_gain") for trial in candidates}
            return None
        for trial in candidates:
            # more devices on a wall are stronger; of anything else even 8 runs show what often fails
            if trial.overturns.low >= MAY_FALL_FROM and not any(each.drilled for each in trial.measures):
                why[trial.kinds] = why_not(trial)
                self._clear[body, trial.kinds] = True
                continue
            full = self._in_full(trial, body)
            self._clear[body, trial.kinds] = full.effect.helps
            if full.effect.helps and (fix := self._fitted(full, body)).sound:
                return fix
            why[trial.kinds] = why_not(full, full) if full.effect.helps else phrase("action_plan.no_gain")
        return None

    def _may_help(self, body: int) -> bool:
        """Whether the runs of the plan are enough to show a change, were nothing to fall any more."""
        if body in self.harmful:
            return True
        outcomes = [*self.runs.of_bodies()]
        of_group = [outcomes[number] for number in self.group_of[body]]
        none = np.zeros(len(self.runs.members), np.bool_)
        return any(each.difference(none, each, each.overturned).clear for each in of_group)

    def _in_full(self, trial: Trial, body: int) -> Trial:
        """Return a trial in all runs of the plan, with as many devices as are needed."""
        return self._trial(body, self._in_number(body, trial.measures), PLAN_RUNS)

    def _helpful(self, body: int, sets: Sequence[tuple[str, ...]]) -> list[Trial]:
        """Run sets of measures on a piece; return those that help and can be put on it where it will be."""
        bare, helpful = self._trial(body, ()), list[Trial]()
        why = self._not_taken[self.scenario.names[body]]
        for kinds in sets:
            measures = measures_for(kinds, self.scene, body)
            refused = self._refused(body, measures)
            if refused is not None:
                why[kinds] = refused
                continue
            trial = self._trial(body, measures)
            if merit(trial) < merit(bare):
                helpful.append(trial)
            else:
                why[kinds] = why_not(trial)
        return helpful

    def _harm(self, effect: OptionVerdict, body: int) -> float:
        """Return the harm of a piece and of what stands on it or bears it [J]."""
        return sum(effect.pieces[number].harm for number in self.group_of[body])

    def _on(self, body: int, measures: tuple[Measure, ...]) -> tuple[Change, ...]:
        return tuple(Change(self.scenario.names[body], measure) for measure in measures)

    def _trial(self, body: int, measures: tuple[Measure, ...], count: int = TRIAL_RUNS) -> Trial:
        """Run measures on a piece where it stands."""
        effect = self._effect(self._on(body, measures), count)
        overturns = effect.pieces[body].probabilities[OVERTURNED]
        return Trial(measures, effect, self._harm(effect, body), overturns, self._gives_way(effect, body))

    def _gives_way(self, effect: OptionVerdict, body: int) -> Probability:
        """Return how often the weakest device on a piece fails."""
        name = self.scenario.names[body]
        failed = [device.failed for device in effect.devices if device.pieces == (name,)]
        none = effect.probabilities[OVERTURNED]
        nothing = replace(none, estimate=0.0, low=0.0, fell=0)
        return max(failed, key=lambda chance: chance.estimate, default=nothing)

    def _refused(self, body: int, measures: tuple[Measure, ...]) -> Phrase | None:
        """Return why measures cannot be put on a piece where it stands, or is to stand; None if they can."""
        room = self.scenario.room.room()
        for measure in measures:
            if (why := measure.advised_against(room)) is not None:
                return why
        try:
            for moves in ((), self.moves):
                refuse_unheld(self.runner.scene(self._with([*moves, *self._on(body, measures)])), body)
        except InputError as error:
            sentence = error.told("en").removesuffix("."), error.told("ja").removesuffix("。")
            return phrase("action_plan.not_possible", why=sentence)
        return None

    def _in_number(self, body: int, measures: tuple[Measure, ...]) -> tuple[Measure, ...]:
        """Return measures with as many devices as their fixing asks for, where the studs allow it."""
        if not any(measure.drilled for measure in measures):
            return measures
        length = self.scene.pieces[body].body.length or 0.0
        option = self._with(self._on(body, measures))
        purchases = purchases_of(self.runner, option, measures, body, TRIAL_RUNS)
        fitted = tuple(in_number(purchase, length) for purchase in purchases)
        return measures if self._refused(body, fitted) else fitted

    def _fitted(self, tried: Trial, body: int) -> Fix:
        """Return measures as they are bought.

        They are run where the piece stands: another direction of shaking tells as much as new draws.
        """
        on = self._on(body, tried.measures)
        purchases = purchases_of(self.runner, self._with(on), tried.measures, body)
        moved = [move for move in self.moves if move.what == self.scenario.names[body]]
        scene = self.runner.scene(self._with([*moved, *on]))
        in_place = placed(scene)[body].held
        assert in_place is not None
        cautions = tuple(
            caution
            for measure in tried.measures
            for caution in measure.cautions(in_place.body, in_place.room)
        )
        return Fix(scene, body, purchases, tried.effect, tried.overturns, tried.gives_way, cautions)
