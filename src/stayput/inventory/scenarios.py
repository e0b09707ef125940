"""The scenario files of an assessment, with their stations and named buildings, and the events they make."""

from __future__ import annotations

import hashlib
import json
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, cast

from pydantic import ValidationError

from stayput.building.building import STRUCTURES
from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, not_allowed, shown, warn
from stayput.fragility.intensity_measures import JMA_INTENSITY, IntensityMeasure
from stayput.inventory.shakemap import GroundLevel, ShakeMap, distances
from stayput.motion.floors import of_the_ground
from stayput.scenario import Scenario
from stayput.scenario.fields import Table, Text, between
from stayput.scenario.tables import BuildingTable
from stayput.scenario.toml import read_toml, refusal_of
from stayput.vocabulary import meant

if TYPE_CHECKING:
    from stayput.motion.suites.suite import Suite

Checked = TypeVar("Checked", bound=Table)

Changed = Callable[[Mapping[str, Any], Path], Mapping[str, Any]]

ANY_FURNITURE: dict[str, Any] = {"preset": "chest"}
"""Placeholder for the furniture of a scenario that leaves it to the inventory."""

_STATED = re.compile(r"(\d{1,3})(?:\s*,\s*|\s+|\s*$)([A-Za-z-]*)", re.ASCII)
_IN_WORDS = (
    re.compile(r"(?P<storeys>\d{1,3})(?: ?階建て?[ ,、]*|[ ,、]+)(?P<structure>\D+)", re.ASCII),
    re.compile(r"(?P<structure>\D+?)[ ,、]*(?P<storeys>\d{1,3}) ?階建て?", re.ASCII),
)
"""Storeys and structure as people write them in Japanese: 10階建て 鉄骨造, 木造2階建て."""


class StationTable(Table):
    """Station and event of a scenario's shaking."""

    lat: Annotated[float, between(-90.0, 90.0, "°")]
    lon: Annotated[float, between(-180.0, 360.0, "°")]
    event: Text | None = None


@dataclass(frozen=True, eq=False)
class ScenarioFile:
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
        """The motions, which must be of the ground."""
        suite = self.scenario.ground()
        for motion in suite:
            of_the_ground(motion, "here")
        return suite

    @cached_property
    def digest(self) -> str:
        """Digest of the scenario, its buildings and the samples of its motions."""
        digest = hashlib.sha256(self.scenario.to_toml().encode())
        place = None if self.station is None else self.station.model_dump()
        tables = {name: table.model_dump() for name, table in sorted(self.buildings.items())}
        digest.update(json.dumps([self.name, place, tables]).encode())
        for motion in self.ground:
            digest.update(json.dumps([motion.name, motion.dt]).encode())
            for values in motion.components.values():
                digest.update(values.tobytes())
        return digest.hexdigest()


@dataclass(frozen=True, eq=False)
class Scenarios:
    """All scenarios of an assessment.

    Parameters
    ----------
    all : tuple of ScenarioFile
        The scenarios.
    events : dict of str to list of int
        For each earthquake the place of its scenario among all, or of those of its stations.
    shakemap : ShakeMap, optional
        What says how strongly the ground shakes.
    """

    all: tuple[ScenarioFile, ...]
    events: dict[str, list[int]]
    shakemap: ShakeMap | None = None

    @cached_property
    def buildings(self) -> dict[str, BuildingTable]:
        """The named buildings of all scenarios.

        Raises
        ------
        InputError
            One name for two buildings.
        """
        buildings: dict[str, BuildingTable] = {}
        for file in self.all:
            for name, table in file.buildings.items():
                if buildings.setdefault(name, table) != table:
                    raise InputError("inventory.other_building", name=repr(name), scenario=file.name)
        return buildings

    @property
    def measure(self) -> IntensityMeasure:
        """Intensity measure of the ground's levels: the map's, else JMA's intensity."""
        return JMA_INTENSITY if self.shakemap is None else self.shakemap.measure

    @property
    def in_plane(self) -> bool:
        """Whether a scenario says that pieces are run in the plane."""
        return any(file.scenario.stated_dimensions == 2 for file in self.all)

    def events_at(self, lat: float | None, lon: float | None) -> list[tuple[str, int, GroundLevel | None]]:
        """Return the events at a place: each with its scenario there, and a level from a map.

        Where there are stations each piece takes the nearest.

        Raises
        ------
        InputError
            The place is missing, or lies outside the map.
        """
        located = self.all[0].station is not None  # then all are
        if not located and self.shakemap is None:
            return [(event, places[0], None) for event, places in self.events.items()]
        if lat is None or lon is None:
            name = "lat" if lat is None else "lon"
            raise InputError("scenario.missing", name, allowed=phrase("inventory.place_missing"))
        level = None if self.shakemap is None else self.shakemap.at(lat, lon)
        here: list[tuple[str, int, GroundLevel | None]] = []
        for event, places in self.events.items():
            stations = [station for place in places if (station := self.all[place].station) is not None]
            lats, lons = [station.lat for station in stations], [station.lon for station in stations]
            near = int(distances(lat, lon, lats, lons).argmin()) if stations else 0
            here.append((event, places[near], level))
        return here


def read_scenarios(
    path: str | Path | ScenarioFile, shakemap: ShakeMap | None = None, changed: Changed | None = None
) -> Scenarios:
    """Read a scenario file, or a folder of them; one that has been read is taken as it is.

    In a folder, scenarios with a ``[station]`` are grouped by its ``event`` and joined to pieces by the
    nearest station; without one, every file is an event for all pieces.

    Raises
    ------
    InputError
        A scenario that is not possible; stations beside scenarios without one; a map beside stations.
    """
    if isinstance(path, ScenarioFile):
        return _joined((path,), path.name, shakemap)
    place = Path(path)
    paths = sorted(place.glob("*.toml")) if place.is_dir() else [place]
    if not paths:
        raise not_allowed("scenario", place, "inventory.scenarios", "scenario")
    return _joined([read_scenario_file(path, changed) for path in paths], place.stem, shakemap)


def _joined(scenarios: Sequence[ScenarioFile], folder: str, shakemap: ShakeMap | None) -> Scenarios:
    located = [file for file in scenarios if file.station is not None]
    if located and len(located) < len(scenarios):
        other = next(file.name for file in scenarios if file.station is None)
        allowed = phrase("inventory.as_in_others")
        raise InputError("scenario.missing", "station", allowed=allowed).at(f"{other}.toml")
    if shakemap is not None and (located or len(scenarios) > 1):
        raise InputError("common.left_out", "shakemap", where=phrase("inventory.map_beside_stations"))
    if shakemap is not None and scenarios[0].scenario.shaking.scale is not None:
        raise InputError("scenario.only_one", "shaking.scale", other="shakemap")
    events: dict[str, list[int]] = {}
    for place, file in enumerate(scenarios):
        event = file.name if file.station is None else file.station.event or folder
        events.setdefault(event, []).append(place)
    return Scenarios(tuple(scenarios), events, shakemap)


def read_scenario_file(file: Path, changed: Changed | None = None) -> ScenarioFile:
    """Read one scenario file, which may have ``[buildings.NAME]`` and ``[station]`` and no furniture.

    What is ``changed`` in its tables is checked as if the file said it.

    Raises
    ------
    InputError
        What is wrong, after the file's name.
    """
    tables = read_toml(file)
    return scenario_file_of(tables if changed is None else changed(tables, file), file)


def scenario_file_of(data: Mapping[str, object], file: Path) -> ScenarioFile:
    """Return the scenario of the tables of a file, whose paths begin in the file's folder.

    Raises
    ------
    InputError
        What is wrong, after the file's name.
    """
    data = dict(data)
    try:
        buildings, station = data.pop("buildings", {}), data.pop("station", None)
        data.setdefault("furniture", ANY_FURNITURE)
        scenario = Scenario.parse(data, file.parent)
        unused = {
            "[uncertainty] installation": "installation" in scenario.uncertainty.model_fields_set,
            "[everyday]": "everyday" in scenario.model_fields_set,
        }
        for key in filter(unused.get, unused):
            warn(InputWarning("inventory.not_used", scenario=file.name, key=key))
        if not isinstance(buildings, dict):
            raise not_allowed("buildings", shown(buildings), "scenario.table", "buildings")
        tables = cast("dict[str, object]", buildings)
        named = {name: building_table(f"buildings.{name}", table) for name, table in tables.items()}
        place = None if station is None else checked_table(StationTable, station, "station")
        return ScenarioFile(file.stem, scenario, named, place)
    except InputError as error:
        raise error.at(file.name) from None


def checked_table(kind: type[Checked], table: object, key: str) -> Checked:
    """Return a table of a scenario, or refuse it by its key."""
    try:
        return kind.model_validate(table)
    except ValidationError as error:
        raise refusal_of(error.errors(), kind.model_json_schema(), key) from None


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
    try:
        return checked_table(BuildingTable, table, "shaking.building")
    except InputError as error:
        raise error.renamed("shaking.building", name) from None


def stated_building(text: str) -> BuildingTable | None:
    """Return the building of a text such as "10 RC", or None where it is another text.

    Raises
    ------
    InputError
        Storeys or a structure that cannot be.
    """
    plain = unicodedata.normalize("NFKC", text).strip()
    if match := _STATED.fullmatch(plain):
        table: dict[str, Any] = {"storeys": int(match[1])}
        return building_table("building", {**table, "structure": match[2]} if match[2] else table)
    for written in _IN_WORDS:
        if (match := written.fullmatch(plain)) and meant("structure", match["structure"]) in STRUCTURES:
            table = {"storeys": int(match["storeys"]), "structure": match["structure"]}
            return building_table("building", table)
    return None
