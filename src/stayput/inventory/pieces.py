"""From a row of an inventory to a piece: what stands, where, and what may hold it."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from stayput.cases import State, refuse_penetration
from stayput.errors import InputError, within
from stayput.inventory.cells import number_of, numbers_of, plain, shown, text_of, whole_of
from stayput.inventory.city import stated_building
from stayput.inventory.specs import ground_spec, measures_spec, thing_spec
from stayput.measures import MEASURES, hold
from stayput.room import Floor, Wall
from stayput.scenario import Scenario
from stayput.scenario.tables import FurnitureTable

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable, Mapping

    from stayput.body import Body
    from stayput.inventory.cells import Cell
    from stayput.inventory.city import Cities
    from stayput.measures import Measure
    from stayput.room import Room
    from stayput.scenario.building import BuildingTable

KEPT = 100_000
"""Bodies, and rooms with their measures, that are kept for rows that say the same."""

MOST_OPTIONS = 20
"""Most sets of measures that a row compares."""

OF_THE_BODY = ("preset", "width", "height", "mass", "cg_offset", "load")
OF_THE_ROOM = ("floor", "gap", "measures")
UNITS = {"width": "m", "height": "m", "mass": "kg"}
NO_MEASURE = "none"


@dataclass(frozen=True, slots=True, eq=False)
class Option:
    """A set of measures that a row compares; without a measure it is the piece as it stands."""

    name: str
    measures: tuple[Measure, ...]
    spec: str

    @classmethod
    def of(cls, name: str, measures: tuple[Measure, ...] = ()) -> Option:
        """Make an option of measures in any order."""
        ordered = tuple(sorted(measures, key=lambda one: one.kind))
        return cls(name, ordered, measures_spec(ordered))


@dataclass(frozen=True, slots=True, eq=False)
class Meeting:
    """A piece under one event.

    Parameters
    ----------
    event : str
        The event.
    station : int
        Place of the scenario among all.
    level : float, optional
        How strong a map says that the ground shakes; see `stayput.inventory.strength`.
    ground : str
        What tells the shaking of its building from others.
    storey : int
        The storey, 1 on the ground.
    building : str, optional
        What the building is called; none on the ground.
    thing : str
        What stands, and where.
    options : tuple of Option
        Without a measure first.
    """

    event: str
    station: int
    level: float | None
    ground: str
    storey: int
    building: str | None
    thing: str
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Piece:
    """A row of an inventory, checked."""

    row: int
    id: str
    count: int
    value: float | None
    lat: float | None
    lon: float | None
    costs: tuple[float, ...]
    met: tuple[Meeting, ...]


class Kept:
    """Outcomes of a function that costs time, refusals among them; the oldest are dropped."""

    def __init__(self, most: int = KEPT) -> None:
        self.most = most
        self.found: OrderedDict[Hashable, Any] = OrderedDict()

    def of(self, key: Hashable, make: Callable[[], Any]) -> Any:
        """Return what was made for a key, or raise what was raised."""
        if key not in self.found:
            try:
                self.found[key] = make()
            except InputError as error:
                self.found[key] = error.with_traceback(None)
            if len(self.found) > self.most:
                self.found.popitem(last=False)
        value = self.found[key]
        if isinstance(value, InputError):
            raise InputError(str(value))
        return value


class Reader:
    """Makes pieces of rows.

    Parameters
    ----------
    cities : Cities
        The scenarios.
    """

    def __init__(self, cities: Cities) -> None:
        self.cities = cities
        self.bodies, self.rooms, self.buildings, self.grounds = (Kept() for _ in range(4))

    def piece(self, row: int, cells: Mapping[str, Cell]) -> Piece:
        """Return the piece of a row.

        Raises
        ------
        InputError
            The first thing that is wrong.
        """
        piece = text_of("id", cells.get("id"))
        if piece is None:
            raise InputError("id is missing; every row must have one.")
        count = whole_of("count", cells.get("count"), 1, 1_000_000)
        value = number_of("value", cells.get("value"))
        if value is not None:
            within("value", value, 0.0, 1e15)
        lat, lon = number_of("lat", cells.get("lat"), "°"), number_of("lon", cells.get("lon"), "°")
        if (lat is None) != (lon is None):
            name = "lat" if lat is None else "lon"
            raise InputError(f"{name} is missing; lat and lon must be given together.")
        if lat is not None and lon is not None:
            within("lat", lat, -90.0, 90.0, "°")
            within("lon", lon, -180.0, 360.0, "°")
        body = self.bodies.of(*self._with(cells, OF_THE_BODY, body_of))
        costs = numbers_of("costs", cells.get("costs"))
        met: list[Meeting] = []
        for event, station, level in self.cities.met(lat, lon):
            label, building, storey = self._building(cells, station)
            thing, options = self._room(cells, body, station)
            if costs and len(costs) != len(options) - 1:
                told = f"costs has {len(costs)} numbers and measures has {len(options) - 1}"
                raise InputError(f"{told}; they must be as many.")
            ground = self.grounds.of((station, level, label), partial(ground_spec, station, level, building))
            met.append(Meeting(event.name, station, level, ground, storey, label, thing, options))
        for cost in costs:
            within("costs", cost, 0.0, 1e15)
        return Piece(row, piece, count or 1, value, lat, lon, costs, tuple(met))

    def _with(
        self, cells: Mapping[str, Cell], names: tuple[str, ...], make: Callable[[Mapping[str, Cell]], Any]
    ) -> tuple[Hashable, Callable[[], Any]]:
        key = tuple(plain(name, cells.get(name)) for name in names)
        return key, lambda: make(cells)

    def _room(self, cells: Mapping[str, Cell], body: Body, station: int) -> tuple[str, tuple[Option, ...]]:
        key = tuple(plain(name, cells.get(name)) for name in OF_THE_ROOM)
        scenario = self.cities.all[station].scenario

        def make() -> tuple[str, tuple[Option, ...]]:
            room = room_of(cells, scenario)
            refuse_penetration(body, room, State())
            options = options_of(cells, scenario)
            for option in options:
                hold(body, room, option.measures)
            return thing_spec(body, room), options

        return self.rooms.of((station, body, key), make)

    def _building(
        self, cells: Mapping[str, Cell], station: int
    ) -> tuple[str | None, BuildingTable | None, int]:
        given = text_of("building", cells.get("building"))
        storey = whole_of("storey", cells.get("storey"), 1, 200)
        shaking = self.cities.all[station].scenario.shaking
        if given is None:
            label, building = (None, shaking.building)
            storey = storey or shaking.storey
            if building is None and storey is not None:
                raise InputError("building is missing; it must be given where a storey is.")
        else:
            label, building = given, self.buildings.of(given, lambda: self._named(given))
        if building is None or storey is None:
            if building is not None:
                raise InputError("storey is missing; it must be given where a building is.")
            return None, None, 1
        if storey > building.highest():
            raise InputError(f"storey is {storey}; it must be between 1 and {building.highest()}, the roof.")
        return label or building.building().name, building, storey

    def _named(self, name: str) -> BuildingTable:
        named = self.cities.buildings
        building = named[name] if name in named else stated_building(name)
        if building is None:
            known = f"one of the scenario's ({', '.join(named)})" if named else "one that the scenario names"
            raise InputError(
                f"building is {shown(name)}; it must be {known}, or storeys and structure such as 10 RC."
            )
        return building


def body_of(cells: Mapping[str, Cell]) -> Body:
    """Return the body of a row.

    Raises
    ------
    InputError
        What is missing or cannot be.
    """
    table: dict[str, Any] = {"preset": text_of("preset", cells.get("preset"))}
    table |= {name: number_of(name, cells.get(name), unit) for name, unit in UNITS.items()}
    if offset := numbers_of("cg_offset", cells.get("cg_offset"), "m"):
        table["cg_offset"] = list(offset)
    if load := numbers_of("load", cells.get("load"), "kg"):
        table["shelves"] = list(load)
    said = {name: value for name, value in table.items() if value is not None}
    try:
        return FurnitureTable.model_validate(said).body()
    except ValidationError:
        try:
            Scenario.parse({"furniture": said})
        except InputError as error:
            told = str(error).replace("furniture.shelves", "load").replace("furniture.", "")
            raise InputError(told.replace("In [furniture]: ", "")) from None
        raise


def room_of(cells: Mapping[str, Cell], scenario: Scenario) -> Room:
    """Return the room of a row: the scenario's, with the row's floor and gap.

    Raises
    ------
    InputError
        No such surface, or a number that cannot be.
    """
    room = scenario.room.room()
    floor, gap = plain("floor", cells.get("floor")), number_of("gap", cells.get("gap"), "m")
    if floor is not None:
        room = replace(room, floor=_floor(floor, room.floor))
    if gap is not None:
        within("gap", gap, 0.0, 1e4, "m")
        room = replace(room, left_wall=replace(room.left_wall or Wall(0.0), gap=gap))
    return room


def _floor(given: str | float, before: Floor) -> Floor:
    if isinstance(given, str) and ";" not in given:
        of = Floor.of(given)
        static, kinetic = of.static_friction, of.kinetic_friction
    else:
        pair = numbers_of("floor", given)
        if len(pair) != 2:
            raise InputError(f"floor is {shown(given)}; it must be a surface, or static;kinetic friction.")
        static, kinetic = pair
    return Floor(
        static, kinetic, restitution=before.restitution, normal_restitution=before.normal_restitution
    )


def options_of(cells: Mapping[str, Cell], scenario: Scenario) -> tuple[Option, ...]:
    """Return the options of a row, that without a measure first; the scenario's where it says nothing.

    Raises
    ------
    InputError
        No such measure, one given twice, or too many.
    """
    named = {one.name: one.measures for one in scenario.measures}
    text = text_of("measures", cells.get("measures"), 1000)
    if text is None:
        return (Option.of(NO_MEASURE), *(Option.of(name, of) for name, of in named.items()))
    found = [Option.of(NO_MEASURE)]
    for part in text.split(";"):
        names = [name.strip() for name in part.split("+")]
        measures: tuple[Measure, ...] = ()
        for name in names:
            if name not in named and name not in MEASURES:
                known = ", ".join(dict.fromkeys((*named, *MEASURES)))
                raise InputError(f"measures has {shown(name)}; each must be one of {known}.")
            measures += named[name] if name in named else (MEASURES[name](),)
        found.append(Option.of("+".join(names), measures))
    if len(found) > MOST_OPTIONS + 1:
        raise InputError(f"measures has {len(found) - 1} sets; it must have at most {MOST_OPTIONS}.")
    names = [option.name for option in found]
    if len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise InputError(f"measures has {shown(twice)} twice; each must be there once.")
    return tuple(found)
