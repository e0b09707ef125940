"""Changes of a room that have been decided on, before a plan of what else to do is made."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from stayput.errors import InputError, instance_of
from stayput.rooms.changes import Change
from stayput.rooms.effects import Answer, Move, OtherTracks
from stayput.rooms.runs import Question, groups_of, moved_to, placed_elsewhere

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.measures import Measure
    from stayput.model.floor_plan import PersonPlace
    from stayput.scenario import Scenario
    from stayput.simulation.piece import Piece


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


def decisions_of(question: Question, changes: Sequence[Change]) -> Decisions:
    """Return decided changes, the moves apart from the measures.

    Raises
    ------
    InputError
        A change of what is not in the room, or both a measure and a move, or neither; a measure on what is no
        furniture; something moved twice, or to where it cannot stand; a piece moved that stands on another.
    """
    names, plan, whole = question.scenario.names, question.plan, question.whole
    single = {names[group[0]] for group in groups_of(question.scenario) if len(group) == 1}
    moves: list[Change] = []
    measures: dict[int, tuple[Measure, ...]] = {}
    for number, change in enumerate(changes):
        field, what = f"decided[{number}]", instance_of("decided", change, Change).what
        body = names.index(what) if what in names else None
        place = next((n for n, spot in enumerate(plan.places) if spot.name == what), None)
        if body is None and place is None:
            there = ", ".join(map(repr, [*names, *(spot.name for spot in plan.places)]))
            raise InputError("rooms.decided_unknown", field, name=repr(what), there=there)
        if (change.measure is None) == (change.at is None):
            raise InputError("rooms.decided_both", field, name=repr(what))
        if change.measure is not None:
            if body is None or whole.pieces[body].body.shape is not None:
                raise InputError("rooms.decided_on_no_piece", field, name=repr(what))
            measures[body] = (*measures.get(body, ()), change.measure)
            continue
        if what in {move.what for move in moves}:
            raise InputError("rooms.decided_twice", field, name=repr(what))
        if body is not None and what not in single:
            raise InputError("rooms.decided_joined", field, name=repr(what))
        if body is not None:
            there = elsewhere(whole.pieces[body], change)
            whole, heading = whole.with_piece(body, there), there.heading
        else:
            assert place is not None
            moved = _place_moved(plan.places[place], change)
            plan, heading = plan.with_places({place: moved}), moved.heading
        moves.append(replace(change, heading=heading))
    if moves:
        with question.scenario.naming_keys():
            replace(whole, plan=plan).refuse_wrong_places()
    return Decisions(tuple(moves), measures)


def elsewhere(piece: Piece, move: Change) -> Piece:
    """Return a piece where it is moved to."""
    return moved_to(piece, *move.place(piece.heading))


def _place_moved(place: PersonPlace, move: Change) -> PersonPlace:
    at, heading = move.place(place.heading)
    return replace(place, at=at, heading=heading)


def moved_as_decided(question: Question, as_it_is: Answer, change: Change) -> Move:
    """Return a decided move, with the tracks of a piece where it stands then."""
    names, plan = question.scenario.names, question.plan
    if change.what not in names:
        number = next(n for n, spot in enumerate(plan.places) if spot.name == change.what)
        place = _place_moved(plan.places[number], change)
        return Move(change, plan.with_places({number: place}), OtherTracks({}, as_it_is.missing))
    body = names.index(change.what)
    then = elsewhere(question.whole.pieces[body], change)
    part = placed_elsewhere(question.whole, body, then.at[:2], then.heading)
    (runs,) = question.run([part])
    return Move(change, plan, OtherTracks.of(part, runs))


def changes_between(before: Scenario, after: Scenario) -> tuple[Change, ...]:
    """Return the changes that make one room of another with the same pieces and places.

    A piece that stands on or is joined to another in either counts as not moved.
    """
    stated = [room.stated.on for room in (before, after)]
    scenes = [room.scene() for room in (before, after)]
    pieces = [scene.pieces for scene in scenes]
    single = [{group[0] for group in groups_of(room) if len(group) == 1} for room in (before, after)]
    changes: list[Change] = []
    for number, (name, was, now) in enumerate(zip(before.names, *pieces, strict=True)):
        if all(number in alone for alone in single) and (was.at, was.heading) != (now.at, now.heading):
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
