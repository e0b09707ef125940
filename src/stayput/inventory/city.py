"""The scenarios of an assessment: events, stations, named buildings."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

from pydantic import ValidationError

from stayput.errors import InputError
from stayput.inventory.places import distances
from stayput.inventory.strength import JMA
from stayput.scenario import Scenario
from stayput.scenario.fields import Table, Text, between
from stayput.scenario.messages import sentence_of
from stayput.scenario.reading import scenario_table
from stayput.scenario.writing import scenario_toml

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.inventory.places import ShakeMap
    from stayput.inventory.strength import Strength
    from stayput.motion.suites import Suite
    from stayput.scenario.building import BuildingTable

ANY: dict[str, Any] = {"preset": "chest"}
"""Stands in for the furniture of a scenario that leaves it to the inventory."""

_STATED = re.compile(r"(\d{1,3})(?:\s*,\s*|\s+|\s*$)([A-Za-z-]*)", re.ASCII)


class StationTable(Table):
    """Where a scenario's shaking was recorded, and in which event."""

    lat: Annotated[float, between(-90.0, 90.0, "°")]
    lon: Annotated[float, between(-180.0, 360.0, "°")]
    event: Text | None = None


@dataclass(frozen=True, eq=False)
class City:
    """One scenario file of an assessment.

    Parameters
    ----------
    name : str
        The file's name without its ending.
    scenario : Scenario
        Shaking, and what holds where a row of the inventory says nothing.
    buildings : mapping
        Buildings by their names.
    station : StationTable, optional
        Where it was recorded.
    """

    name: str
    scenario: Scenario
    buildings: Mapping[str, BuildingTable] = field(default_factory=dict[str, "BuildingTable"])
    station: StationTable | None = None

    @cached_property
    def ground(self) -> Suite:
        """The motions of the ground."""
        return self.scenario.shaking.ground(self.scenario.folder)

    @cached_property
    def digest(self) -> str:
        """What tells it from others: the scenario, its buildings and the samples of its motions."""
        found = hashlib.sha256(scenario_toml(self.scenario).encode())
        place = None if self.station is None else self.station.model_dump()
        tables = {name: table.model_dump() for name, table in sorted(self.buildings.items())}
        found.update(json.dumps([self.name, place, tables]).encode())
        for motion in self.ground:
            found.update(json.dumps([motion.name, motion.dt]).encode())
            for values in motion.components.values():
                found.update(values.tobytes())
        return found.hexdigest()


@dataclass(frozen=True, slots=True, eq=False)
class Event:
    """One earthquake: a scenario for all pieces, or the stations of which each piece takes the nearest.

    Parameters
    ----------
    name : str
        What it is called.
    stations : tuple of int
        Places of its scenarios among all.
    lats, lons : tuple of float
        Where they are; empty for one that holds everywhere.
    """

    name: str
    stations: tuple[int, ...]
    lats: tuple[float, ...] = ()
    lons: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class Cities:
    """All scenarios of an assessment."""

    all: tuple[City, ...]
    events: tuple[Event, ...]
    shakemap: ShakeMap | None = None

    @cached_property
    def buildings(self) -> dict[str, BuildingTable]:
        """The named buildings of all scenarios.

        Raises
        ------
        InputError
            One name for two buildings.
        """
        found: dict[str, BuildingTable] = {}
        for city in self.all:
            for name, table in city.buildings.items():
                if found.setdefault(name, table) != table:
                    raise InputError(
                        f"The building {name!r} is another one in {city.name}; it must be the same."
                    )
        return found

    @property
    def strength(self) -> Strength:
        """What says how strong the ground shakes: the map's measure, else JMA's intensity."""
        return JMA if self.shakemap is None else self.shakemap.strength

    @property
    def needs_places(self) -> bool:
        """Whether each piece needs a latitude and a longitude."""
        return self.shakemap is not None or any(event.lats for event in self.events)

    def met(self, lat: float | None, lon: float | None) -> list[tuple[Event, int, float | None]]:
        """Return what a piece meets: each event, its scenario there, and a level from a map.

        Raises
        ------
        InputError
            The place is missing, or lies outside the map.
        """
        if not self.needs_places:
            return [(event, event.stations[0], None) for event in self.events]
        if lat is None or lon is None:
            name = "lat" if lat is None else "lon"
            raise InputError(f"{name} is missing; it must be given where there are stations or a shake map.")
        level = None if self.shakemap is None else self.shakemap.at(lat, lon)
        found: list[tuple[Event, int, float | None]] = []
        for event in self.events:
            near = int(distances(lat, lon, event.lats, event.lons).argmin()) if event.lats else 0
            found.append((event, event.stations[near], level))
        return found


def read_cities(path: str | Path, shakemap: ShakeMap | None = None) -> Cities:
    """Read a scenario file, or a folder of them.

    In a folder, scenarios with a ``[station]`` are grouped by its ``event`` and joined to pieces by the
    nearest station; without one, every file is an event for all pieces.

    Raises
    ------
    InputError
        A scenario that is not possible; stations beside scenarios without one; a map beside stations.
    """
    place = Path(path)
    files = sorted(place.glob("*.toml")) if place.is_dir() else [place]
    if not files:
        raise InputError(f"The folder of scenarios is {str(place)!r}; it must hold files that end in .toml.")
    cities = tuple(read_city(file) for file in files)
    located = [city for city in cities if city.station is not None]
    if located and len(located) < len(cities):
        other = next(city.name for city in cities if city.station is None)
        raise InputError(f"{other}.toml has no [station], and others have one; all must have it or none.")
    if shakemap is not None:
        _check_map(cities)
    return Cities(cities, _events(cities, place.stem), shakemap)


def _check_map(cities: Sequence[City]) -> None:
    if len(cities) > 1 or cities[0].station is not None:
        raise InputError(
            "A shake map is given beside stations or several scenarios; it goes with one scenario."
        )
    if cities[0].scenario.shaking.scale is not None:
        raise InputError("shaking.scale is given beside a shake map, which says how strong it shakes.")


def _events(cities: Sequence[City], folder: str) -> tuple[Event, ...]:
    if cities[0].station is None:
        return tuple(Event(city.name, (place,)) for place, city in enumerate(cities))
    groups: dict[str, list[int]] = {}
    for place, city in enumerate(cities):
        assert city.station is not None
        groups.setdefault(city.station.event or folder, []).append(place)
    found: list[Event] = []
    for name, places in groups.items():
        tables = [table for place in places if (table := cities[place].station) is not None]
        lats, lons = tuple(one.lat for one in tables), tuple(one.lon for one in tables)
        found.append(Event(name, tuple(places), lats, lons))
    return tuple(found)


def read_city(file: Path) -> City:
    """Read one scenario file, which may have ``[buildings.NAME]`` and ``[station]`` and no furniture.

    Raises
    ------
    InputError
        What is wrong, after the file's name.
    """
    try:
        data = dict(scenario_table(file))
        buildings, station = data.pop("buildings", {}), data.pop("station", None)
        data.setdefault("furniture", ANY)
        scenario = Scenario.parse(data, file.parent)
        if scenario.contact != "coulomb":
            raise InputError(f'The contact is "{scenario.contact}"; an assessment needs "coulomb".')
        if not isinstance(buildings, dict):
            raise InputError("buildings is not a table; it must be one of [buildings.NAME].")
        tables = cast("dict[str, object]", buildings)
        named = {name: building_table(f"buildings.{name}", one) for name, one in tables.items()}
        return City(file.stem, scenario, named, None if station is None else _station(station))
    except InputError as error:
        said = str(error)
        raise InputError(said if said.startswith("The scenario file") else f"{file.name}: {said}") from None


def _station(table: object) -> StationTable:
    try:
        return StationTable.model_validate(table)
    except ValidationError as error:
        said = sentence_of(error.errors(), StationTable.model_json_schema())
        raise InputError(f"station.{said}") from None


def building_table(name: str, table: object) -> BuildingTable:
    """Return a building as a scenario has it.

    Parameters
    ----------
    name : str
        What a sentence calls it.
    table : mapping
        Its keys and values.

    Raises
    ------
    InputError
        What is wrong with it.
    """
    shaking = {"builtin": "near-fault", "building": table, "storey": 1}
    try:
        building = Scenario.parse({"furniture": ANY, "shaking": shaking}).shaking.building
    except InputError as error:
        raise InputError(str(error).replace("shaking.building", name)) from None
    assert building is not None
    return building


def stated_building(text: str) -> BuildingTable | None:
    """Return the building of a text such as "10 RC", or None where it is another text.

    Raises
    ------
    InputError
        Storeys or a structure that cannot be.
    """
    found = _STATED.fullmatch(text)
    if found is None:
        return None
    table: dict[str, Any] = {"storeys": int(found[1])}
    return building_table("building", {**table, "structure": found[2]} if found[2] else table)
