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

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.fragility import JMA_INTENSITY
from stayput.inventory.places import distances
from stayput.scenario import Scenario
from stayput.scenario.fields import Table, Text, between
from stayput.scenario.messages import refusal_of
from stayput.scenario.toml import read_toml

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.fragility import IntensityMeasure
    from stayput.inventory.places import ShakeMap
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
        """Digest of the scenario, its buildings and the samples of its motions."""
        found = hashlib.sha256(self.scenario.to_toml().encode())
        place = None if self.station is None else self.station.model_dump()
        tables = {name: table.model_dump() for name, table in sorted(self.buildings.items())}
        found.update(json.dumps([self.name, place, tables]).encode())
        for motion in self.ground:
            found.update(json.dumps([motion.name, motion.dt]).encode())
            for values in motion.components.values():
                found.update(values.tobytes())
        return found.hexdigest()


@dataclass(frozen=True, slots=True, eq=False)
class Earthquake:
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
    events: tuple[Earthquake, ...]
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
                    raise InputError("inventory.other_building", name=repr(name), scenario=city.name)
        return found

    @property
    def measure(self) -> IntensityMeasure:
        """What levels of the ground are of: the map's measure, else JMA's intensity."""
        return JMA_INTENSITY if self.shakemap is None else self.shakemap.measure

    @property
    def needs_places(self) -> bool:
        """Whether each piece needs a latitude and a longitude."""
        return self.shakemap is not None or any(event.lats for event in self.events)

    def events_at(self, lat: float | None, lon: float | None) -> list[tuple[Earthquake, int, float | None]]:
        """Return the events at a place: each with its scenario there, and a level from a map.

        Raises
        ------
        InputError
            The place is missing, or lies outside the map.
        """
        if not self.needs_places:
            return [(event, event.stations[0], None) for event in self.events]
        if lat is None or lon is None:
            name = "lat" if lat is None else "lon"
            raise InputError("inventory.place_missing", name, name=name)
        level = None if self.shakemap is None else self.shakemap.at(lat, lon)
        found: list[tuple[Earthquake, int, float | None]] = []
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
        raise InputError("inventory.no_scenarios", "scenario", path=repr(str(place)))
    cities = tuple(read_city(file) for file in files)
    located = [city for city in cities if city.station is not None]
    if located and len(located) < len(cities):
        other = next(city.name for city in cities if city.station is None)
        raise InputError("inventory.station_missing", "station", name=other)
    if shakemap is not None:
        _check_map(cities)
    return Cities(cities, _events(cities, place.stem), shakemap)


def _check_map(cities: Sequence[City]) -> None:
    if len(cities) > 1 or cities[0].station is not None:
        raise InputError("inventory.map_beside_stations", "shakemap")
    if cities[0].scenario.shaking.scale is not None:
        raise InputError("inventory.scale_beside_map", "shaking.scale")


def _events(cities: Sequence[City], folder: str) -> tuple[Earthquake, ...]:
    if cities[0].station is None:
        return tuple(Earthquake(city.name, (place,)) for place, city in enumerate(cities))
    groups: dict[str, list[int]] = {}
    for place, city in enumerate(cities):
        assert city.station is not None
        groups.setdefault(city.station.event or folder, []).append(place)
    found: list[Earthquake] = []
    for name, places in groups.items():
        tables = [table for place in places if (table := cities[place].station) is not None]
        lats, lons = tuple(one.lat for one in tables), tuple(one.lon for one in tables)
        found.append(Earthquake(name, tuple(places), lats, lons))
    return tuple(found)


def read_city(file: Path) -> City:
    """Read one scenario file, which may have ``[buildings.NAME]`` and ``[station]`` and no furniture.

    Raises
    ------
    InputError
        What is wrong, after the file's name.
    """
    data = dict(read_toml(file))
    try:
        buildings, station = data.pop("buildings", {}), data.pop("station", None)
        data.setdefault("furniture", ANY)
        scenario = Scenario.parse(data, file.parent)
        if scenario.contact != "coulomb":
            raise InputError(
                "verification.needs_coulomb",
                "contact",
                contact=scenario.contact,
                what=phrase("verification.an_assessment"),
            )
        if not isinstance(buildings, dict):
            raise InputError("inventory.buildings_not_a_table", "buildings")
        tables = cast("dict[str, object]", buildings)
        named = {name: building_table(f"buildings.{name}", one) for name, one in tables.items()}
        return City(file.stem, scenario, named, None if station is None else _station(station))
    except InputError as error:
        raise error.at(file.name) from None


def _station(table: object) -> StationTable:
    try:
        return StationTable.model_validate(table)
    except ValidationError as error:
        raise refusal_of(error.errors(), StationTable.model_json_schema(), "station") from None


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
        raise error.renamed("shaking.building", name) from None
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
