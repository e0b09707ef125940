"""The plan to buy and do: what to move, what to put on which piece, and what it brings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, instance_of, list_of
from stayput.measures import MEASURES, Measure
from stayput.montecarlo.counting import OVERTURNED
from stayput.scenario.tables import floor_of
from stayput.simulation.space_fate import MAY_FALL_FROM
from stayput.verification.changes import Change, loose_pieces, with_changes
from stayput.verification.people import harm_step
from stayput.vocabulary import TATAMI

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.measures.measure import Grade
    from stayput.rooms.purchases import Purchase
    from stayput.scenario import Scenario
    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Scene
    from stayput.verification.options import Input
    from stayput.verification.verdict import OptionVerdict, Verdict


class Decisions(NamedTuple):
    """What is done in any case.

    Parameters
    ----------
    moves : tuple of Change
        What is moved, each thing once.
    measures : mapping of int to tuple of Measure
        What is put on the piece of a number.
    """

    moves: tuple[Change, ...]
    measures: Mapping[int, tuple[Measure, ...]]


def decisions_of(scenario: Scenario, changes: Sequence[Change]) -> Decisions:
    """Return decided changes, the moves apart from the measures.

    Raises
    ------
    InputError
        A change of what is not in the room, or both a measure and a move, or neither; a measure on what is no
        furniture; something moved twice, or to where it cannot stand; a piece moved that stands on another.
    """
    names, scene = scenario.names, scenario.scene()
    assert scene.plan is not None
    places = {place.name: place for place in scene.plan.places}
    moves: list[Change] = []
    measures: dict[int, tuple[Measure, ...]] = {}
    for number, change in enumerate(list_of("decided", changes)):
        field, what = f"decided[{number}]", instance_of("decided", change, Change).what
        body = names.index(what) if what in names else None
        if body is None and what not in places:
            there = ", ".join(map(repr, [*names, *places]))
            raise InputError("rooms.decided_unknown", field, name=repr(what), there=there)
        if (change.measure is None) == (change.at is None):
            raise InputError("rooms.decided_both", field, name=repr(what))
        if change.measure is not None:
            if body is None or scene.pieces[body].body.shape is not None:
                raise InputError("rooms.decided_on_no_piece", field, name=repr(what))
            measures[body] = (*measures.get(body, ()), change.measure)
            continue
        if what in {move.what for move in moves}:
            raise InputError("common.twice", field, name=repr(what))
        if body is not None and body not in loose_pieces(scenario):
            raise InputError("rooms.decided_joined", field, name=repr(what))
        faces = places[what].heading if body is None else scene.pieces[body].heading
        moves.append(change if change.heading is not None else replace(change, heading=faces))
    if moves:
        with scenario.naming_keys():
            option = with_changes(scenario.stated, moves, names)
            scenario.scene(option).refuse_wrong_places()
    return Decisions(tuple(moves), measures)


def changes_between(before: Scenario, after: Scenario) -> tuple[Change, ...]:
    """Return the changes that make one room of another with the same pieces and places.

    A piece that stands on or is joined to another in either counts as not moved.
    """
    stated = [room.stated.on for room in (before, after)]
    scenes = [room.scene() for room in (before, after)]
    pieces = [scene.pieces for scene in scenes]
    loose = loose_pieces(before) & loose_pieces(after)
    changes: list[Change] = []
    for number, (name, was, now) in enumerate(zip(before.names, *pieces, strict=True)):
        if number in loose and (was.at, was.heading) != (now.at, now.heading):
            changes.append(Change(name, at=now.at[:2], heading=now.heading))
        had = list(stated[0][number])
        for measure in stated[1][number]:
            if measure in had:
                had.remove(measure)
            else:
                changes.append(Change(name, measure))
    for was, now in zip(*(scene.plan.places for scene in scenes if scene.plan), strict=True):
        if (was.at, was.heading) != (now.at, now.heading):
            changes.append(Change(was.name, at=now.at, heading=now.heading))
    return tuple(changes)


COST_BOUNDS = ((2_000, 15), (6_000, 40))
"""Upper ends of the cost classes 1 and 2, in yen and in euros: a convention; class 3 is all above."""


def cost_class_of(measures: Iterable[Measure]) -> int:
    """Return the cost class of measures on a piece, 0 to 3."""
    return min(len(COST_BOUNDS) + 1, sum(measure.cost_class for measure in measures))


@dataclass(frozen=True, slots=True)
class Home:
    """What a home is like, and what is allowed in it.

    Parameters
    ----------
    no_drilling : bool
        Whether nothing may be screwed to a wall.
    tatami : bool
        Whether the floor is tatami, to which gel does not stick.
    plasterboard : bool
        Whether the walls are plasterboard without studs that can be used.
    dropped_ceiling : bool
        Whether the ceiling hangs on wires, so that no pole may push against it.
    """

    no_drilling: bool = False
    tatami: bool = False
    plasterboard: bool = False
    dropped_ceiling: bool = False

    def allows(self, kinds: Iterable[str]) -> bool:
        """Return whether measures of some kinds may be used in this home."""
        return not (self.no_drilling and any(MEASURES[kind].drilled for kind in kinds))

    def __post_init__(self) -> None:
        for each in fields(self):
            instance_of(each.name, getattr(self, each.name), bool)

    def of(self, scenario: Scenario) -> Scenario:
        """Return a room as it is in this home.

        Raises
        ------
        InputError
            The scenario states something else of its floor, walls or ceiling.
        """
        room, ceiling = scenario.room, scenario.room.ceiling
        changed: dict[str, Any] = {}

        def change(name: str, key: str, value: object, *, stated: bool) -> None:
            if stated:
                raise InputError("rooms.home_contradicts", key, condition=phrase(f"action_plan.{name}"))
            changed[key.split(".")[1]] = value

        if self.tatami and not floor_of(room.floor).surface.startswith("tatami"):
            change("tatami", "room.floor", TATAMI, stated="floor" in room.model_fields_set)
        if self.plasterboard and room.walls != "plasterboard":
            change("plasterboard", "room.walls", "plasterboard", stated="walls" in room.model_fields_set)
        if self.dropped_ceiling and ceiling is not None and ceiling.construction != "dropped":
            dropped = ceiling.model_copy(update={"construction": "dropped"})
            stated = "construction" in ceiling.model_fields_set
            change("dropped_ceiling", "room.ceiling.construction", dropped, stated=stated)
        if not changed:
            return scenario
        return scenario.model_copy(update={"room": room.model_copy(update=changed)})


@dataclass(frozen=True, slots=True)
class Fix:
    """Measures on a piece: what to buy, and what they bring alone.

    Parameters
    ----------
    scene : Scene
        The room, with the piece held where it is to stand.
    body : int
        The piece.
    purchases : tuple of Purchase
        What to buy.
    alone : OptionVerdict
        What they bring by themselves, with everything where it is.
    overturns : Probability
        That the piece overturns with them.
    gives_way : Probability
        That the weakest of their devices fails.
    cautions : tuple of Phrase
        Why they may not do much, each as a clause.
    """

    scene: Scene
    body: int
    purchases: tuple[Purchase, ...]
    alone: OptionVerdict
    overturns: Probability
    gives_way: Probability
    cautions: tuple[Phrase, ...]

    @property
    def piece(self) -> Piece:
        """The piece, as it is then held."""
        return self.scene.pieces[self.body]

    @property
    def enough(self) -> bool:
        """Whether all are strong enough for the shaking of the plan, as far as computed strengths tell."""
        return all(purchase.enough for purchase in self.purchases)

    @property
    def too_weak(self) -> bool:
        """Whether, not being strong enough, they fail in the runs too, and the piece overturns often.

        Else what is not strong enough has no reserve.
        """
        return not self.enough and fails_to_hold(self.gives_way, self.overturns)

    @property
    def sound(self) -> bool:
        """Whether it is worth buying: it clearly helps, and is not too weak."""
        return self.alone.helps and not self.too_weak

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of its measures."""
        return tuple(purchase.measure.kind for purchase in self.purchases)

    @property
    def drilled(self) -> bool:
        """Whether it takes holes in a wall."""
        return any(purchase.measure.drilled for purchase in self.purchases)

    @property
    def cost_class(self) -> int:
        """Its cost, 0 to 3; see `stayput.measures.Measure.cost_class`."""
        return cost_class_of(purchase.measure for purchase in self.purchases)


NotTaken: TypeAlias = "Mapping[tuple[str, ...], Phrase]"
"""Why sets of measures were not taken on a piece, each a clause, by their kinds."""


@dataclass(frozen=True, slots=True)
class PlanStep:
    """One thing to do: to move something, or to put measures on a piece.

    Parameters
    ----------
    what : str
        The piece, or the place of a person that is moved.
    move : Change or None
        Where it goes, if it is moved.
    fix : Fix or None
        What is put on it, if it is not.
    alone : OptionVerdict
        What it brings by itself.
    together : OptionVerdict
        What it brings with all steps before it.
    overturned : Probability or None
        That the piece overturns as the room is; None of the place of a person.
    instead : Fix or None
        What may be done without drilling, where the fix needs holes.
    inputs : tuple of Input
        The inputs that decide its numbers, and how well each is founded.
    for_people : bool
        Whether without it, and with all other steps, somebody is hit or shut in more often, or a door is
        blocked; else it only keeps a piece from overturning.
    decided : bool
        Whether it had been decided on before the plan was made.
    """

    what: str
    move: Change | None
    fix: Fix | None
    alone: OptionVerdict
    together: OptionVerdict
    overturned: Probability | None
    instead: Fix | None
    inputs: tuple[Input, ...]
    for_people: bool = True
    decided: bool = False

    @property
    def grade(self) -> Grade:
        """Its grade: that of the weakest of its inputs."""
        return max(quantity.grade for quantity in self.inputs)

    @property
    def weakest(self) -> tuple[Input, ...]:
        """The inputs of that grade."""
        return tuple(quantity for quantity in self.inputs if quantity.grade == self.grade)

    @property
    def cost_class(self) -> int:
        """Its cost: 0 for moving, else that of the fix."""
        return 0 if self.fix is None else self.fix.cost_class


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class ActionPlan:
    """Result of `stayput.action_plan`.

    Parameters
    ----------
    verdict : Verdict
        The room as it is in this home; single changes are not in it.
    home : Home
        What the home is like.
    steps : tuple of PlanStep
        What to do, in order of importance.
    unsolved : tuple of str
        Pieces that do harm or overturn often, and on which nothing that may be done helps.
    drilled : mapping
        Where nothing may be drilled: the best measures that are, and would be enough, on each piece for which
        all others are not.
    not_taken : mapping
        The sets of measures that were not taken on a piece, by their kinds, and why.
    not_enough : mapping
        The best measures on each piece that has no step since all are too weak or do not clearly help.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.Scenario.parse({
    ...     "plan": {"width": 3.0, "length": 2.5},
    ...     "furniture": [{"name": "shelf", "preset": "bookcase", "against": "left_wall", "along": 1.0}],
    ...     "places": [{"kind": "bed", "at": [1.6, 1.0], "heading": 1.5708}],
    ...     "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
    ...     "uncertainty": {"samples": 8},
    ... })
    >>> verdict = sp.verify(scenario, changes=False, progress=False)
    >>> plan = sp.action_plan(verdict, progress=False)
    >>> now, then = verdict.without.people.hit, plan.together.people.hit
    >>> now.chance.fell, then.chance.fell  # of 8 earthquakes: as it is, and after all steps
    (5, 0)
    """

    verdict: Verdict
    home: Home
    steps: tuple[PlanStep, ...]
    unsolved: tuple[str, ...]
    drilled: Mapping[str, Fix] = field(default_factory=dict[str, "Fix"])
    not_taken: Mapping[str, NotTaken] = field(default_factory=dict[str, "NotTaken"])
    not_enough: Mapping[str, Fix] = field(default_factory=dict[str, "Fix"])

    def __repr__(self) -> str:
        return f"ActionPlan({len(self.steps)} steps, {len(self.unsolved)} pieces unsolved; {self.verdict!r})"

    @property
    def together(self) -> OptionVerdict | None:
        """What all steps bring together; None where there is none."""
        return self.steps[-1].together if self.steps else None

    def to_html(self, language: str = "en") -> str:
        """Return the plan as a page to print, in "en" or "ja"; see `stayput.report.room.card`."""
        from stayput.report.room.card import plan_html

        return plan_html(self, language)

    def to_json(self) -> str:
        """Return the plan as JSON; keys carry their units."""
        from stayput.report.verdict.data import json_text, plan_data

        return json_text(plan_data(self))

    def report(self, path: str | Path, language: str = "en") -> Path:
        """Write the plan, one HTML file with everything in it, to print.

        Raises
        ------
        InputError
            Another language, or a path that cannot be written.
        """
        from stayput.report.page import write_page

        return write_page(path, language, lambda: self.to_html(language))


ALIKE = 0.005
"""Risks that differ by no more than this are equal in the order of steps: half a per cent."""


class Trial(NamedTuple):
    """Measures on a piece that have run where it stands; ``harm``: of its part of the room alone [J]."""

    measures: tuple[Measure, ...]
    effect: OptionVerdict
    harm: float
    overturns: Probability
    gives_way: Probability

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of its measures."""
        return tuple(measure.kind for measure in self.measures)


def fails_to_hold(gives_way: Probability, overturns: Probability) -> bool:
    """Return whether measures fail in the runs, and the piece overturns often all the same."""
    return gives_way.estimate > 0.0 and overturns.estimate >= MAY_FALL_FROM


class ChosenStep(NamedTuple):
    """A step before its place in the order is known, and what it changes."""

    step: PlanStep
    changes: tuple[Change, ...]


def in_order_of_gain(effect: OptionVerdict) -> tuple[float, ...]:
    """Return the sort key of what something brings, the best first: for people, and then what overturns."""
    fallen = sum(piece.probabilities[OVERTURNED].estimate for piece in effect.pieces)
    return (*for_people(effect), round(fallen / ALIKE))


def for_people(effect: OptionVerdict) -> tuple[float, ...]:
    """Return how much happens to people: the harm, then who is shut in, and which door is blocked."""
    assert effect.people is not None
    return effect.people.severity


def merit(tried: Trial) -> tuple[float, ...]:
    """Return the sort key of measures on a piece: of those that bring the same, what it falls with least."""
    ways = for_people(tried.effect)[1:]
    return (harm_step(tried.harm), *ways, round(tried.overturns.estimate / ALIKE), len(tried.measures))
