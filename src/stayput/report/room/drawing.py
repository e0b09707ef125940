"""The plans in the report of a room: as it is, and with the best change that moves something."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import say
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.room.labels import FONT
from stayput.report.room.plan import DrawnPiece, DrawnPlan, plan_svg, swatch_svg
from stayput.report.verdict import numbers
from stayput.rooms.words import change_label, names_in
from stayput.simulation.placing import bare

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from numpy.typing import NDArray

    from stayput.fragility import Probability
    from stayput.rooms.changes import Change
    from stayput.rooms.verdict import RoomVerdict
    from stayput.simulation.standing import Standing


def room_plan(verdict: RoomVerdict, language: str) -> str:
    """Return the plan of the room with where its pieces come to lie, and who is hit how often."""

    def told(key: str, chance: Probability) -> str:
        return say(f"room_report.{key}", language, share=numbers.probability(chance, language))

    notes = {one.name: told("overturns", one.probabilities[OVERTURNED]) for one in verdict.pieces}
    notes |= {one.place.name: told("is_hit", one.hit) for one in verdict.places}
    notes |= {one.door.name: told("is_blocked", one.blocked) for one in verdict.doors}
    return plan_svg(verdict.plan, _pieces(verdict), _kinds(verdict), language, notes=notes).svg


def legend(verdict: RoomVerdict, language: str) -> list[tuple[str, str]]:
    """Return the colour and the name of each piece."""
    called = names_in(verdict.scenario, language)
    return [(swatch_svg(look), name) for look, name in enumerate(called)]


def change_plan(verdict: RoomVerdict, language: str) -> tuple[str, str] | None:
    """Return a plan with the best change that helps and moves something, and what the change is."""
    best = next((one.change for one in verdict.changes if one.helps and one.change.at is not None), None)
    if best is None:
        return None
    return numbered_plan(verdict, [best], language).svg, change_label(best, verdict, language)


def numbered_plan(
    verdict: RoomVerdict,
    moves: Iterable[Change],
    language: str,
    numbered: Mapping[str, str] | None = None,
    letters: float = FONT,
) -> DrawnPlan:
    """Return a plan of the room with some things moved, and numbers before names or in their place.

    Parameters
    ----------
    verdict : RoomVerdict
        The room.
    moves : iterable of Change
        What is moved.
    language : str
        "en" or "ja".
    numbered : mapping of str, optional
        The number of a piece or a place.
    letters : float
        Size of the letters of names [px].
    """
    pieces = [replace(piece, covers=None) for piece in _pieces(verdict)]
    plan, kinds = verdict.plan, _kinds(verdict)
    moved: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
    for change in moves:
        assert change.at is not None
        assert change.heading is not None
        if change.what in verdict.scenario.names:
            body = verdict.scenario.names.index(change.what)
            before = pieces[body].outline
            pieces[body] = _moved(pieces[body], _standing(verdict)[body], change)
            moved.append((before, pieces[body].outline))
        else:
            number = [place.name for place in plan.places].index(change.what)
            place = plan.places[number]
            other = replace(place, at=change.at, heading=change.heading)
            moved.append((place.corners, other.corners))
            plan = plan.with_places({number: other})
    return plan_svg(plan, pieces, kinds, language, moved=moved, numbered=numbered, letters=letters)


def _kinds(verdict: RoomVerdict) -> list[str]:
    return [table.kind for table in verdict.scenario.places]


def _standing(verdict: RoomVerdict) -> list[Standing]:
    scenario = verdict.scenario
    return [bare(member) for member in scenario.assembly(scenario.stated).members]


def _pieces(verdict: RoomVerdict) -> list[DrawnPiece]:
    """Return the pieces in the order of the file, in which what stands on another comes after it."""
    found = {piece.name: piece for piece in verdict.pieces}
    return [
        DrawnPiece(name, look, found[name].outline, standing.heading, found[name].covers)
        for look, (name, standing) in enumerate(zip(verdict.scenario.names, _standing(verdict), strict=True))
    ]


def _moved(piece: DrawnPiece, standing: Standing, change: Change) -> DrawnPiece:
    assert change.at is not None
    assert change.heading is not None
    angle = change.heading - piece.heading
    cos, sin = math.cos(angle), math.sin(angle)
    turn = np.array([[cos, sin], [-sin, cos]])
    outline = (piece.outline - np.asarray(standing.at[:2])) @ turn + np.asarray(change.at)
    return replace(piece, outline=outline, heading=change.heading)
