"""What to buy for a piece: how strong a device must be, and how many of them its fixing needs."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from stayput.measures.wall import WallDevice
from stayput.rooms.forces import MARGIN, Purchase, more_than, quantile_of, strengths_of, unbreakable
from stayput.rooms.runs import with_member
from stayput.rooms.steps import STUD_PITCH
from stayput.simulation.placing import placed
from stayput.simulation.standing import Piece

if TYPE_CHECKING:
    from stayput.measures import Measure
    from stayput.rooms.effects import Question
    from stayput.rooms.runs import RoomPart


def purchases_of(
    question: Question, part: RoomPart, measures: tuple[Measure, ...], body: int
) -> tuple[Purchase, ...]:
    """Return what to buy: how strong one must be, and how strong what it is fixed to is."""
    place = part.bodies.index(body)
    piece = part.assembly.members[place]
    held = placed(part.assembly.members, part.room)[place].held
    assert isinstance(piece, Piece)
    assert held is not None
    kinds = {measure.kind for measure in measures}
    strong = tuple(
        unbreakable(measure.fitted_to(piece.body)) if measure.kind in kinds else measure
        for measure in piece.measures
    )
    member = replace(piece, measures=strong)
    runs = question.run([part._replace(assembly=with_member(part.assembly, place, member))])[0]
    found: list[Purchase] = []
    for measure in measures:
        strengths = strengths_of(held, measure.kind)
        if strengths is None:
            found.append(Purchase(measure))
            continue
        holds, fails = strengths
        needed = quantile_of(runs.peaks, (place, measure.kind)).times(MARGIN)
        found.append(Purchase(measure, needed, holds, fails))
    return tuple(found)


def in_number(purchase: Purchase, length: float) -> Measure:
    """Return a device on a wall in the number that its fixing needs, one on each stud at most."""
    measure = purchase.measure
    if not isinstance(measure, WallDevice) or purchase.needed is None or purchase.holds is None:
        return measure
    most = max(measure.count, math.floor(length / STUD_PITCH[0]) + 1)
    needed = math.ceil(measure.count * more_than(purchase.needed, purchase.holds))
    return replace(measure, count=min(most, max(measure.count, needed)))
