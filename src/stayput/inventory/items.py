"""Rows of an inventory as checked items: the piece, where it stands, and the measures to compare."""

from __future__ import annotations

from collections import OrderedDict
from copy import copy
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from stayput.catalogue import phrase
from stayput.errors import InputError, unknown, visible, within
from stayput.inventory.cells import (
    Unusable,
    number_of,
    number_or_none,
    numbers_of,
    plain,
    shown,
    text_of,
    whole_of,
)
from stayput.inventory.columns import TOTAL_ROW, plain_name
from stayput.inventory.contents import OF_THE_CONTENTS, contents_of
from stayput.inventory.scenarios import stated_building
from stayput.inventory.store import ground_spec, measures_spec, piece_spec
from stayput.inventory.vocabulary import ROOF
from stayput.measures import MEASURES, hold
from stayput.measures.measure import refuse_conflicts
from stayput.model.room import WALLS, Floor, Wall
from stayput.model.state import State, refuse_bad_start
from stayput.scenario import Scenario
from stayput.scenario.tables import FurnitureTable

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable, Mapping

    from stayput.catalogue import Phrase
    from stayput.inventory.cells import Cell
    from stayput.inventory.places import GroundLevel
    from stayput.inventory.scenarios import Scenarios
    from stayput.measures import Measure
    from stayput.model.body import Body
    from stayput.model.room import Room
    from stayput.scenario.tables import BuildingTable

MOST_CACHED = 100_000
"""Bodies, and rooms with their measures, that are cached for rows with the same values."""

MOST_OPTIONS = 20
"""Most sets of measures that a row compares."""

DEEPEST = 9
"""Lowest basement that there may be."""

OF_THE_BODY = ("preset", "width", "height", "mass", "cg_offset", "load")
OF_THE_ROOM = ("floor", "gap", "wall", "measures")
SIZES = {"width": (0.01, 10.0, "m"), "height": (0.01, 10.0, "m"), "mass": (0.1, 50_000.0, "kg")}
"""What a piece of an inventory may have; beyond, its numbers are in another unit than is stated."""

NO_MEASURE = "none"

LONGEST_NAME = 100
"""Letters of what a piece is called that are kept."""


@dataclass(frozen=True, slots=True, eq=False)
class MeasureSet:
    """A set of measures that a row compares; without a measure it is the piece as it stands."""

    name: str
    measures: tuple[Measure, ...]
    spec: str

    @classmethod
    def of(cls, name: str, measures: tuple[Measure, ...] = ()) -> MeasureSet:
        """Make an option of measures in any order."""
        ordered = tuple(sorted(measures, key=lambda measure: measure.kind))
        return cls(name, ordered, measures_spec(ordered))


@dataclass(frozen=True, slots=True, eq=False)
class Exposure:
    """An item under one event.

    Parameters
    ----------
    event : str
        The event.
    station : int
        Place of the scenario among all.
    level : GroundLevel, optional
        Level of the ground from a map.
    ground : str
        Spec of the shaking of its building.
    storey : int
        The storey, 1 on the ground, below 0 in a basement.
    building : str, optional
        What the building is called; none on the ground.
    piece : str
        Spec of the piece with its contents in its room.
    options : tuple of MeasureSet
        Without a measure first.
    impossible : tuple of (str, Phrase)
        Names of the sets of measures that cannot be put in place, and why not.
    costs : tuple of float
        Costs of the options but the first, where they are given.
    """

    event: str
    station: int
    level: GroundLevel | None
    ground: str
    storey: int
    building: str | None
    piece: str
    options: tuple[MeasureSet, ...]
    impossible: tuple[tuple[str, Phrase], ...]
    costs: tuple[float, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Item:
    """A checked row of an inventory."""

    row: int
    id: str
    name: str | None
    count: int
    value: float | None
    lat: float | None
    lon: float | None
    depth: float
    exposures: tuple[Exposure, ...]


class ResultCache:
    """Cache of results, refusals among them, of which the oldest are dropped."""

    def __init__(self, most: int = MOST_CACHED) -> None:
        self.most = most
        self.results: OrderedDict[Hashable, Any] = OrderedDict()

    def get(self, key: Hashable, make: Callable[[], Any]) -> Any:
        """Return the result for a key, or raise the refusal: a copy, since each raise adds to a traceback."""
        if key not in self.results:
            try:
                self.results[key] = make()
            except InputError as error:
                self.results[key] = error.with_traceback(None)
            if len(self.results) > self.most:
                self.results.popitem(last=False)
        value = self.results[key]
        if isinstance(value, InputError):
            raise copy(value)
        return value


class RowReader:
    """Checks rows and makes items of them.

    Parameters
    ----------
    scenarios : Scenarios
        The scenarios.

    Attributes
    ----------
    roofs : dict of str to int
        Number of the roof of each building that has a piece there.
    """

    def __init__(self, scenarios: Scenarios) -> None:
        self.scenarios = scenarios
        self.bodies, self.rooms, self.buildings, self.grounds = (ResultCache() for _ in range(4))
        self.roofs: dict[str, int] = {}

    def item(self, row: int, cells: Mapping[str, Cell]) -> Item:
        """Return the item of a row.

        Raises
        ------
        InputError
            The first thing that is wrong.
        """
        piece = text_of("id", cells.get("id")) or numbered(cells.get("name"), row)
        for name in ("id", "name"):
            called = cells.get(name)
            if isinstance(called, str) and TOTAL_ROW.fullmatch(plain_name(called)):
                raise InputError("inventory.total_row", name, name=name, value=shown(called))
        count = whole_of("count", cells.get("count"), 1, 1_000_000)
        value = number_of("value", cells.get("value"))
        if value is not None:
            within("value", value, 0.0, 1e15, field="value")
        lat, lon = number_of("lat", cells.get("lat"), "°"), number_of("lon", cells.get("lon"), "°")
        if (lat is None) != (lon is None):
            name = "lat" if lat is None else "lon"
            raise InputError("inventory.lat_and_lon", name, name=name)
        if lat is not None and lon is not None:
            within("lat", lat, -90.0, 90.0, "°", "lat")
            within("lon", lon, -180.0, 360.0, "°", "lon")
        body = self.bodies.get(_values(cells, OF_THE_BODY), partial(body_of, cells))
        costs = numbers_of("costs", cells.get("costs"))
        exposures: list[Exposure] = []
        for event, station, level in self.scenarios.events_at(lat, lon):
            label, building, storey = self._building(cells, station)
            piece_text, options, not_possible = self._room(cells, body, station)
            if costs and len(costs) != len(options) - 1:
                raise InputError(
                    "inventory.costs_count", "costs", costs=len(costs), measures=len(options) - 1
                )
            place = station, level, None if building is None else label
            ground = self.grounds.get(place, partial(ground_spec, station, level, building))
            possible = [n for n, option in enumerate(options) if option.name not in not_possible]
            exposures.append(
                Exposure(
                    event.name,
                    station,
                    level,
                    ground,
                    storey,
                    label,
                    piece_text,
                    tuple(options[n] for n in possible),
                    tuple(not_possible.items()),
                    tuple(costs[n - 1] for n in possible[1:]) if costs else (),
                )
            )
        for cost in costs:
            within("costs", cost, 0.0, 1e15, field="costs")
        return Item(
            row, piece, name_of(cells.get("name")), count or 1, value, lat, lon, body.width, tuple(exposures)
        )

    def _room(
        self, cells: Mapping[str, Cell], body: Body, station: int
    ) -> tuple[str, tuple[MeasureSet, ...], dict[str, Phrase]]:
        """Return the piece's spec in its room, the options, and reasons against those not possible."""
        scenario = self.scenarios.all[station].scenario

        def make() -> tuple[str, tuple[MeasureSet, ...], dict[str, Phrase]]:
            room = room_of(cells, scenario)
            refuse_bad_start(body, room, State())
            options = options_of(cells, scenario)
            not_possible: dict[str, Phrase] = {}
            for option in options:
                refuse_conflicts(option.measures)
                try:
                    hold(body, room, option.measures)
                except InputError as error:  # no wall behind, no ceiling, an anchor above the ceiling
                    not_possible[option.name] = error.told("en"), error.told("ja")
            contents = contents_of(cells, body, scenario)
            return piece_spec(body, room, contents), options, not_possible

        return self.rooms.get((station, body, _values(cells, (*OF_THE_ROOM, *OF_THE_CONTENTS))), make)

    def _building(
        self, cells: Mapping[str, Cell], station: int
    ) -> tuple[str | None, BuildingTable | None, int]:
        """Return the building's name, what moves its floor (none: the ground alone), and the storey."""
        stated = text_of("building", cells.get("building"))
        shaking, cell = self.scenarios.all[station].scenario.shaking, cells.get("storey")
        building = shaking.building
        if stated is not None:
            building = self.buildings.get(stated, lambda: self._named(stated))
        if building is None:
            if plain("storey", cell) is not None:
                raise InputError("inventory.building_missing", "building", name="building")
            return None, None, 1
        highest, name = building.highest(), stated or building.building().name
        storey = storey_of(cell, highest) or (shaking.storey if stated is None else None)
        if storey is None:
            raise InputError("inventory.storey_missing", "storey", name="storey")
        if storey == highest:
            self.roofs[name] = storey
        return name, building if storey > 0 else None, storey

    def _named(self, name: str) -> BuildingTable:
        named = self.scenarios.buildings
        building = named[name] if name in named else stated_building(name)
        if building is None:
            known = phrase("inventory.one_that_is_named")
            if named:
                known = phrase("inventory.one_of_the_scenario", names=", ".join(named))
            raise InputError(
                "inventory.unknown_building", "building", name="building", value=shown(name), known=known
            )
        return building


def _values(cells: Mapping[str, Cell], names: tuple[str, ...]) -> Hashable:
    return tuple(plain(name, cells.get(name)) for name in names)


def name_of(cell: Cell) -> str | None:
    """Return what a piece is called, in one line, or None where the cell says nothing of use."""
    if cell is None or isinstance(cell, Unusable):
        return None
    whole = int(cell) if isinstance(cell, float) and cell.is_integer() else cell
    return visible(" ".join(str(whole).split())[:LONGEST_NAME].strip()) or None


def numbered(called: Cell, row: int) -> str:
    """Return the id of a piece whose row has none: what it is called, with its row."""
    name = called.strip()[:LONGEST_NAME].strip() if isinstance(called, str) else ""
    return f"{name} #{row}" if name else f"row {row}"


def body_of(cells: Mapping[str, Cell]) -> Body:
    """Return the body of a row.

    Raises
    ------
    InputError
        What is missing or cannot be.
    """
    table: dict[str, Any] = {"preset": text_of("preset", cells.get("preset"))}
    table |= {name: number_of(name, cells.get(name), unit) for name, (_, _, unit) in SIZES.items()}
    if offset := numbers_of("cg_offset", cells.get("cg_offset"), "m"):
        table["cg_offset"] = list(offset)
    if load := numbers_of("load", cells.get("load"), "kg"):
        table["shelves"] = list(load)
    stated = {name: value for name, value in table.items() if value is not None}
    for name, (low, high, unit) in SIZES.items():
        if name in stated:
            within(name, stated[name], low, high, unit, name)
    try:
        return FurnitureTable.model_validate(stated).body()
    except ValidationError:
        try:
            Scenario.parse({"furniture": stated})
        except InputError as error:
            # A row has columns where a scenario has keys of its table [furniture].
            known = error.renamed("furniture.shelves", "load").renamed("furniture.", "")
            raise known.anywhere() from None
        raise


def room_of(cells: Mapping[str, Cell], scenario: Scenario) -> Room:
    """Return the room of a row: the scenario's, with the row's floor, gap and wall.

    Raises
    ------
    InputError
        No such surface or wall, a number that cannot be, or a wall without a gap to it.
    """
    room = scenario.room.room()
    floor, gap = plain("floor", cells.get("floor")), number_of("gap", cells.get("gap"), "m")
    if floor is not None:
        try:
            room = replace(room, floor=_floor(floor, room.floor))
        except InputError as error:
            raise error.about("floor") from None
    if gap is not None:
        within("gap", gap, 0.0, 1e4, "m", "gap")
        room = replace(room, left_wall=replace(room.left_wall or Wall(0.0), gap=gap))
    wall = text_of("wall", cells.get("wall"))
    if wall is not None:
        if wall not in WALLS:
            raise unknown("inventory.wall", wall, WALLS, field="wall")
        if room.left_wall is None:
            raise InputError("inventory.wall_without_gap", "wall", name="gap")
        room = replace(room, left_wall=replace(room.left_wall, construction=wall))
    return room


def _floor(value: str | float, default: Floor) -> Floor:
    losses = {name: getattr(default, name) for name in ("restitution", "normal_restitution")}
    if isinstance(value, str) and ";" not in value:
        return Floor.of(value, **losses)
    pair = numbers_of("floor", value)
    if len(pair) != 2:
        raise InputError("inventory.floor", "floor", name="floor", value=shown(value))
    return Floor(*pair, **losses)


def storey_of(cell: Cell, highest: int) -> int | None:
    """Return the storey of a cell, below 0 in a basement; None where it is empty.

    Raises
    ------
    InputError
        No storey, or one that a building of so many does not have.
    """
    if cell == ROOF:
        return highest
    if isinstance(cell, str) and cell.strip() and number_or_none(cell) is None:
        raise InputError("inventory.storey", "storey", name="storey", value=shown(cell))
    storey = whole_of("storey", cell, -1_000_000, 1_000_000)
    if storey is not None and not (1 <= storey <= highest or -DEEPEST <= storey <= -1):
        raise InputError(
            "inventory.storey_range", "storey", name="storey", storey=storey, highest=highest, deepest=DEEPEST
        )
    return storey


def options_of(cells: Mapping[str, Cell], scenario: Scenario) -> tuple[MeasureSet, ...]:
    """Return the options of a row, that without a measure first; the scenario's where it says nothing.

    Raises
    ------
    InputError
        No such measure, one given twice, or too many.
    """
    named = {measure_set.name: measure_set.measures for measure_set in scenario.measures}
    text = text_of("measures", cells.get("measures"), 1000)
    if text is None:
        return (MeasureSet.of(NO_MEASURE), *(MeasureSet.of(*each) for each in named.items()))
    sets = [MeasureSet.of(NO_MEASURE)]
    for part in text.split(";"):
        names = [name.strip() for name in part.split("+")]
        measures: tuple[Measure, ...] = ()
        for name in names:
            if name not in named and name not in MEASURES:
                known = ", ".join(dict.fromkeys((*named, *MEASURES)))
                raise InputError(
                    "inventory.unknown_measure", "measures", name="measures", value=shown(name), known=known
                )
            measures += named[name] if name in named else (MEASURES[name](),)
        sets.append(MeasureSet.of("+".join(names), measures))
    if len(sets) > MOST_OPTIONS + 1:
        raise InputError(
            "inventory.too_many_sets", "measures", name="measures", count=len(sets) - 1, most=MOST_OPTIONS
        )
    names = [option.name for option in sets]
    if len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise InputError("inventory.measure_twice", "measures", name="measures", value=shown(twice))
    return tuple(sets)
