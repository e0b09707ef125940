"""What tells the shaking, the pieces and the measures of an inventory apart: texts that keep every bit."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from stayput.cases import State, from_leaves, leaves
from stayput.measures import MEASURES, parameters
from stayput.scenario.building import BuildingTable

if TYPE_CHECKING:
    from stayput.body import Body
    from stayput.measures import Measure
    from stayput.room import Room


def ground_spec(station: int, level: float | None, building: BuildingTable | None) -> str:
    """Return what tells the shaking of a building from others: scenario, level from a map, building."""
    table = None if building is None else building.model_dump(exclude_defaults=True)
    return json.dumps([station, level, table], sort_keys=True)


def ground_of(spec: str) -> tuple[int, float | None, BuildingTable | None]:
    """Return the scenario, the level and the building of a spec; the inverse of `ground_spec`."""
    station, level, table = json.loads(spec)
    return station, level, None if table is None else BuildingTable.model_validate(table)


def thing_spec(body: Body, room: Room) -> str:
    """Return a body in a room as text, each number with all its bits."""
    return json.dumps(leaves(body, room, State(), 1.0))


def thing_of(spec: str) -> tuple[Body, Room]:
    """Return the body and the room of a spec; the inverse of `thing_spec`."""
    body, room, _ = from_leaves(json.loads(spec))
    return body, room


def measures_spec(measures: tuple[Measure, ...]) -> str:
    """Return measures as text."""
    tables = [
        {"type": one.kind, **{about.name: getattr(one, about.name) for about in parameters(one)}}
        for one in measures
    ]
    return json.dumps(tables, sort_keys=True)


def measures_of(spec: str) -> tuple[Measure, ...]:
    """Return the measures of a spec; the inverse of `measures_spec`."""
    return tuple(MEASURES[table.pop("type")](**table) for table in json.loads(spec))
