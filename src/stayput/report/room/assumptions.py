"""What a verdict on a room rests on: its assumptions, and the limits of the model."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.model.parameters import GIVEN
from stayput.report.several.tables import (
    drawn_between,
    piece_assumptions,
    rolling_assumptions,
    settlement_assumptions,
)
from stayput.report.verdict.assumptions import (
    MODEL,
    Assumption,
    ceiling_assumptions,
    drawn_assumptions,
    fixed_to,
    floor_assumption,
    shaking_assumptions,
)
from stayput.rooms.events import CELL, PASSAGE

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.rooms.verdict import RoomVerdict


def assumptions_of_room(verdict: RoomVerdict) -> list[Assumption]:
    """Return the assumptions of a verdict on a room, those of its model first."""
    scenario = verdict.scenario
    room = scenario.surroundings()
    walls = [] if room.left_wall is None else [fixed_to("wall_fixing", room.left_wall)]
    return [
        *_limits(verdict),
        *settlement_assumptions(scenario),
        *rolling_assumptions(scenario),
        _direction(scenario.direction),
        *piece_assumptions(scenario),
        floor_assumption(scenario, room.floor),
        *walls,
        *(() if room.ceiling is None else ceiling_assumptions(room.ceiling)),
        *shaking_assumptions(scenario, verdict.motions),
        *drawn_assumptions(scenario.uncertainty),
        drawn_between(),
    ]


def _limits(verdict: RoomVerdict) -> Iterator[Assumption]:
    values = {"passage": PASSAGE, "cell": 100.0 * CELL}
    for key in ("alone", "persons", "passage"):
        text = phrase(f"room_report.limit_{key}_text", **values)
        yield Assumption((phrase(f"room_report.limit_{key}"), text), MODEL)
    for key in ("contacts", "devices"):
        yield Assumption((phrase(f"report.limit_{key}"), phrase(f"report.limit_{key}_text")), MODEL)


def _direction(given: float | None) -> Assumption:
    heading = phrase("room_report.direction")
    if given is None:
        return Assumption((heading, phrase("room_report.direction_drawn")), MODEL)
    return Assumption((heading, phrase("room_report.direction_given", degrees=math.degrees(given))), GIVEN)
