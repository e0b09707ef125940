"""SQLite store of deduplicated simulation units.

A unit is a body with its contents in a room, with a set of measures, at a site (a storey under a shaking of
the ground). Each of these is identified by a spec: a text that keeps every bit of its numbers.
"""

from __future__ import annotations

import hashlib
import json
import sqlite3
from collections import OrderedDict
from contextlib import closing
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from stayput.contents import Contents
from stayput.inventory.places import GroundLevel
from stayput.measures import MEASURES, parameters
from stayput.model.state import State
from stayput.scenario.tables import BuildingTable
from stayput.simulation.flat_fields import flat_fields, from_flat_fields

if TYPE_CHECKING:
    from collections.abc import Hashable, Iterable, Iterator
    from pathlib import Path

    from stayput.measures import Measure
    from stayput.model.body import Body
    from stayput.model.room import Room

MOST_CACHED = 400_000
"""Numbers of pieces and of units that are kept in memory."""

_TABLES = """
CREATE TABLE things (id INTEGER PRIMARY KEY, digest BLOB UNIQUE NOT NULL, spec TEXT NOT NULL);
CREATE TABLE options (id INTEGER PRIMARY KEY, spec TEXT UNIQUE NOT NULL);
CREATE TABLE sites (id INTEGER PRIMARY KEY, ground TEXT NOT NULL, storey INTEGER NOT NULL,
                    UNIQUE (ground, storey));
CREATE TABLE units (site INTEGER, option INTEGER, thing INTEGER, id INTEGER NOT NULL,
                    PRIMARY KEY (site, option, thing)) WITHOUT ROWID;
CREATE TABLE ids (id TEXT PRIMARY KEY, row INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
"""


class NumberCache:
    """Cache of row numbers by key, of which the oldest are dropped."""

    def __init__(self, most: int = MOST_CACHED) -> None:
        self.most = most
        self.numbers: OrderedDict[Hashable, int] = OrderedDict()

    def put(self, key: Hashable, number: int) -> int:
        """Keep a number."""
        self.numbers[key] = number
        if len(self.numbers) > self.most:
            self.numbers.popitem(last=False)
        return number


class Store:
    """The plan on disk, in SQLite.

    Parameters
    ----------
    path : Path
        The file; made where it is not there.
    cache : int
        Bytes that SQLite keeps in memory.
    """

    def __init__(self, path: Path, cache: int = 128 * 2**20) -> None:
        self.base = sqlite3.connect(path, isolation_level=None)
        self.base.execute(f"PRAGMA cache_size = -{max(cache // 1024, 1024)}")
        self.base.execute("PRAGMA temp_store = FILE")
        self.pieces, self.options, self.sites, self.units = (NumberCache() for _ in range(4))
        self.next_unit = 0

    def begin(self) -> None:
        """Make the tables; all is one transaction until `finish`."""
        self.base.execute("PRAGMA journal_mode = OFF")  # a plan that is not finished is thrown away
        self.base.execute("PRAGMA synchronous = OFF")
        self.base.executescript(_TABLES)
        self.base.execute("BEGIN")

    def finish(self, facts: dict[str, Any]) -> None:
        """Write the facts of the plan, and close it."""
        self.base.executemany(
            "INSERT INTO facts VALUES (?, ?)", [(name, json.dumps(value)) for name, value in facts.items()]
        )
        self.base.execute("COMMIT")
        self.base.close()

    def close(self) -> None:
        """Close the file."""
        self.base.close()

    def facts(self) -> dict[str, Any]:
        """Return the facts of the plan."""
        return {name: json.loads(value) for name, value in self.base.execute("SELECT * FROM facts")}

    def row_of(self, name: str, row: int) -> int:
        """Return the row that first had an id: this one, where it is new."""
        try:
            self.base.execute("INSERT INTO ids VALUES (?, ?)", (name, row))
        except sqlite3.IntegrityError:
            return int(self.base.execute("SELECT row FROM ids WHERE id = ?", (name,)).fetchone()[0])
        return row

    def units_of(self, ground: str, storey: int, piece: str, options: Iterable[str]) -> list[int]:
        """Return the numbers of the units of a piece at a site, one for each option; new ones are added.

        Parameters
        ----------
        ground : str
            Spec of the shaking of its building.
        storey : int
            The storey.
        piece : str
            Spec of the piece in its room.
        options : iterable of str
            Specs of the sets of measures.
        """
        site = self._number(self.sites, (ground, storey), "sites", ("ground", "storey"))
        number = self._piece(piece)
        return [
            self._unit(site, self._number(self.options, (spec,), "options", ("spec",)), number)
            for spec in options
        ]

    def _number(
        self,
        cache: NumberCache,
        key: tuple[str | int | bytes, ...],
        table: str,
        columns: tuple[str, ...],
        **others: str,
    ) -> int:
        """Return the number of a row by its key, which is added with its other columns where it is new."""
        if key in cache.numbers:
            return cache.numbers[key]
        where = " AND ".join(f"{column} = ?" for column in columns)
        row = self.base.execute(f"SELECT id FROM {table} WHERE {where}", key).fetchone()
        if row is not None:
            return cache.put(key, int(row[0]))
        names, values = (*columns, *others), (*key, *others.values())
        marks = ", ".join("?" for _ in names)
        added = self.base.execute(f"INSERT INTO {table} ({', '.join(names)}) VALUES ({marks})", values)
        assert added.lastrowid is not None
        return cache.put(key, added.lastrowid)

    def _piece(self, spec: str) -> int:
        digest = hashlib.blake2b(spec.encode(), digest_size=16).digest()
        return self._number(self.pieces, (digest,), "things", ("digest",), spec=spec)

    def _unit(self, site: int, option: int, piece: int) -> int:
        key = (site, option, piece)
        if key in self.units.numbers:
            return self.units.numbers[key]
        row = self.base.execute(
            "SELECT id FROM units WHERE site = ? AND option = ? AND thing = ?", key
        ).fetchone()
        if row is not None:
            return self.units.put(key, int(row[0]))
        number = self.next_unit
        self.base.execute("INSERT INTO units VALUES (?, ?, ?, ?)", (*key, number))
        self.next_unit += 1
        return self.units.put(key, number)

    def count(self, table: str) -> int:
        """Return the number of rows of a table."""
        return int(self.base.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0])

    def grounds(self) -> list[tuple[str, list[tuple[int, int]]]]:
        """Return the shakings of the ground, each with its sites: their numbers and storeys."""
        sites: dict[str, list[tuple[int, int]]] = {}
        for number, ground, storey in self.base.execute("SELECT id, ground, storey FROM sites ORDER BY id"):
            sites.setdefault(ground, []).append((number, storey))
        return list(sites.items())

    def option_specs(self) -> dict[int, str]:
        """Return the measures of each option."""
        return dict(self.base.execute("SELECT id, spec FROM options"))

    def units_at(self, site: int) -> Iterator[tuple[int, int, str]]:
        """Yield the units of a site: number, option, spec of the piece; those of one option together."""
        with closing(self.base.cursor()) as cursor:
            yield from cursor.execute(
                "SELECT units.id, units.option, things.spec "
                "FROM units JOIN things ON things.id = units.thing "
                "WHERE units.site = ? ORDER BY units.option, units.thing",
                (site,),
            )

    def units_by_option(self) -> dict[int, int]:
        """Return how many units each option has."""
        return dict(self.base.execute("SELECT option, COUNT(*) FROM units GROUP BY option"))


def ground_spec(station: int, level: GroundLevel | None, building: BuildingTable | None) -> str:
    """Return the spec of a building's shaking as text: scenario, level from a map, building."""
    table = None if building is None else building.model_dump(exclude_defaults=True)
    return json.dumps([station, level, table], sort_keys=True)


def ground_of(spec: str) -> tuple[int, GroundLevel | None, BuildingTable | None]:
    """Return the scenario, the level and the building of a spec; the inverse of `ground_spec`."""
    station, level, table = json.loads(spec)
    building = None if table is None else BuildingTable.model_validate(table)
    return station, None if level is None else GroundLevel(*level), building


def piece_spec(body: Body, room: Room, contents: Contents | None = None) -> str:
    """Return a body in a room, and what is inside it, as text, each number with all its bits."""
    table = None if contents is None else asdict(contents)
    return json.dumps([flat_fields(body, room, State(), 1.0), table])


def piece_of(spec: str) -> tuple[Body, Room, Contents | None]:
    """Return the body, the room and the contents of a spec; the inverse of `piece_spec`."""
    numbers, table = json.loads(spec)
    body, room, _ = from_flat_fields(numbers)
    if table is None:
        return body, room, None
    loads = table.pop("loads")
    return body, room, Contents(**table, loads=None if loads is None else tuple(loads))


def measures_spec(measures: tuple[Measure, ...]) -> str:
    """Return measures as text."""
    tables = [
        {"type": measure.kind, **{p.name: getattr(measure, p.name) for p in parameters(measure)}}
        for measure in measures
    ]
    return json.dumps(tables, sort_keys=True)


def measures_of(spec: str) -> tuple[Measure, ...]:
    """Return the measures of a spec; the inverse of `measures_spec`."""
    return tuple(MEASURES[table.pop("type")](**table) for table in json.loads(spec))
