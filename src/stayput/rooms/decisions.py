"""Changes of a room that have been decided on, before a plan of what else to do is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from stayput.errors import InputError, instance_of
from stayput.verification.changes import Change, loose_pieces, with_changes

if TYPE_CHECKING:
    from stayput.measures import Measure
    from stayput.scenario import Scenario


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
    for number, change in enumerate(changes):
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
