"""What an assessment keeps in SQLite: its plan (checked rows, rejects, units to simulate), and the outcomes.

A unit is a body with its contents in a room, at a site (a storey under a shaking of the ground), with the
options that are compared there: sets of measures. Each of these is identified by a spec: its text by
`stayput.saved`, with every bit. The outcomes of options are records of fixed size, numbered on from that of
the unit; what was saved stays when the process is killed.
"""

from __future__ import annotations

import hashlib
import json
import sqlite3
import zlib
from collections.abc import Hashable, Iterator, Mapping, Sequence
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from cachetools import FIFOCache
from numpy.typing import NDArray

from stayput.montecarlo.counting import EVENTS
from stayput.saved import from_text, to_text
from stayput.scenario.tables import BuildingTable

if TYPE_CHECKING:
    from stayput.inventory.shakemap import GroundLevel

MOST_CACHED = 800_000
"""Numbers of pieces, units and the like that are kept in memory."""

GROUND = ("intensity", "sa", "pga", "pgv")
"""How strongly the ground shakes."""

_TABLES = """
CREATE TABLE things (id INTEGER PRIMARY KEY, digest BLOB UNIQUE NOT NULL, spec TEXT NOT NULL);
CREATE TABLE options (id INTEGER PRIMARY KEY, spec TEXT UNIQUE NOT NULL);
CREATE TABLE sites (id INTEGER PRIMARY KEY, ground TEXT NOT NULL, storey INTEGER NOT NULL,
                    UNIQUE (ground, storey));
CREATE TABLE units (site INTEGER, options INTEGER, thing INTEGER, id INTEGER NOT NULL,
                    PRIMARY KEY (site, options, thing)) WITHOUT ROWID;
CREATE TABLE ids (id TEXT PRIMARY KEY, row INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE rejects (row INTEGER, id TEXT, name TEXT, reason TEXT, reason_ja TEXT);
CREATE TABLE parts (number INTEGER PRIMARY KEY, rows BLOB NOT NULL);
CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
"""


class Store:
    """The plan on disk.

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
        self.numbers: FIFOCache[Hashable, int] = FIFOCache(MOST_CACHED)
        self.next_record = 0

    def begin(self) -> None:
        """Make the tables; all is one transaction until `finish`."""
        self.base.execute("PRAGMA journal_mode = OFF")  # a plan that is not finished is thrown away
        self.base.execute("PRAGMA synchronous = OFF")
        self.base.executescript(_TABLES)
        self.base.execute("BEGIN")

    def finish(self, facts: dict[str, Any]) -> None:
        """Write the facts of the plan: it is complete."""
        self.base.executemany(
            "INSERT INTO facts VALUES (?, ?)", [(name, json.dumps(value)) for name, value in facts.items()]
        )
        self.base.execute("COMMIT")

    def close(self) -> None:
        """Close the file."""
        self.base.close()

    def facts(self) -> dict[str, Any]:
        """Return the facts of the plan."""
        return {name: json.loads(value) for name, value in self.base.execute("SELECT * FROM facts")}

    def row_of(self, name: str, row: int) -> int:
        """Return the row that first had an id: this one, where it is new."""
        self.base.execute("INSERT OR IGNORE INTO ids VALUES (?, ?)", (name, row))
        return int(self.base.execute("SELECT row FROM ids WHERE id = ?", (name,)).fetchone()[0])

    def records_of(self, ground: str, storey: int, piece: str, options: Sequence[str]) -> list[int]:
        """Return the numbers of the records of a unit, one for each option; a new unit is added.

        Parameters
        ----------
        ground : str
            Spec of the shaking of its building.
        storey : int
            The storey.
        piece : str
            Spec of the piece in its room.
        options : sequence of str
            Specs of the sets of measures, that without a measure first.
        """
        site = self._number("sites", {"ground": ground, "storey": storey})
        digest = hashlib.blake2b(piece.encode(), digest_size=16).digest()
        thing = self._number("things", {"digest": digest}, spec=piece)
        compared = self._number("options", {"spec": json.dumps(options)})
        key = {"site": site, "options": compared, "thing": thing}
        first = self._number("units", key, id=self.next_record)
        if first == self.next_record:
            self.next_record += len(options)
        return [*range(first, first + len(options))]

    def _number(self, table: str, key: Mapping[str, str | int | bytes], **others: str | int) -> int:
        """Return the number of a row by its key, which is added with its other columns where it is new."""
        cached = table, *key.values()
        if cached not in self.numbers:
            columns, values = (*key, *others), (*key.values(), *others.values())
            marks, first = ", ".join("?" * len(columns)), columns[0]
            (row,) = self.base.execute(
                f"INSERT INTO {table} ({', '.join(columns)}) VALUES ({marks}) "
                f"ON CONFLICT ({', '.join(key)}) DO UPDATE SET {first} = {first} RETURNING id",
                values,
            )
            self.numbers[cached] = row[0]
        return self.numbers[cached]

    def add_part(self, rows: list[dict[str, Any]]) -> None:
        """Add the checked rows of a part of the results: one for each piece and event."""
        self.base.execute("INSERT INTO parts (rows) VALUES (?)", (zlib.compress(json.dumps(rows).encode()),))

    def part(self, number: int) -> list[dict[str, Any]]:
        """Return the checked rows of a part, the first being 0."""
        (rows,) = self.base.execute("SELECT rows FROM parts WHERE number = ?", (number + 1,)).fetchone()
        return json.loads(zlib.decompress(rows))

    def reject(self, line: tuple[int, str, str | None, str, str]) -> None:
        """Add a row that is not assessed: its number, id, name, and the reason in both languages."""
        self.base.execute("INSERT INTO rejects VALUES (?, ?, ?, ?, ?)", line)

    def rejects(self) -> Iterator[tuple[int, str, str | None, str, str]]:
        """Yield the rows that are not assessed."""
        with closing(self.base.cursor()) as cursor:
            yield from cursor.execute("SELECT * FROM rejects ORDER BY rowid")

    def grounds(self) -> list[tuple[str, list[tuple[int, int]]]]:
        """Return the shakings of the ground, each with its sites: their numbers and storeys."""
        sites: dict[str, list[tuple[int, int]]] = {}
        for number, ground, storey in self.base.execute("SELECT id, ground, storey FROM sites ORDER BY id"):
            sites.setdefault(ground, []).append((number, storey))
        return list(sites.items())

    def option_specs(self) -> dict[int, list[str]]:
        """Return the specs of the options that are compared together, by the number of each such list."""
        lists = self.base.execute("SELECT id, spec FROM options")
        return {number: json.loads(spec) for number, spec in lists}

    def units_at(self, site: int) -> Iterator[tuple[int, int, str]]:
        """Yield the units of a site: number of the first record and of the options, spec of the piece."""
        with closing(self.base.cursor()) as cursor:
            yield from cursor.execute(
                "SELECT units.id, units.options, things.spec "
                "FROM units JOIN things ON things.id = units.thing "
                "WHERE units.site = ? ORDER BY units.options, units.thing",
                (site,),
            )


def ground_spec(station: int, level: GroundLevel | None, building: BuildingTable | None) -> str:
    """Return the spec of a building's shaking: scenario, level from a map, building."""
    table = None if building is None else building.model_dump(exclude_defaults=True)
    return to_text((station, level, table))


def ground_of(spec: str) -> tuple[int, GroundLevel | None, BuildingTable | None]:
    """Return the scenario, the level and the building of a spec; the inverse of `ground_spec`."""
    station, level, table = from_text(spec)
    return station, level, None if table is None else BuildingTable.model_validate(table)


RECORD = np.dtype(
    [
        ("number", "<i8"),
        ("motions", "<i4"),
        ("runs", "<i4"),  # without those given up
        ("missing", "<i4"),
        ("fell", "<i4"),
        ("chances", "<f8", (len(EVENTS), 3)),  # estimate, low, high of each event
        ("slide", "<f8", (3,)),  # median, 90 % quantile, mean of those that stay upright [m]
        ("out", "<f8", (3,)),  # share of the contents that come out: estimate, low, high; NaN without any
        # how much likelier it is than without a measure that the event or overturning happens, run by run
        ("change", "<f8", (len(EVENTS), 3)),
    ]
)
"""Type of the outcome of an option of a unit."""

_OUTCOMES = """
CREATE TABLE IF NOT EXISTS outcomes
    (number INTEGER PRIMARY KEY, record BLOB NOT NULL, checksum INTEGER NOT NULL);
CREATE TABLE IF NOT EXISTS parts (name TEXT PRIMARY KEY, rows INTEGER NOT NULL, digest TEXT NOT NULL);
"""


class OutcomeStore:
    """What is done of an assessment.

    Parameters
    ----------
    path : Path
        The file; made where it is not there, and anew where it is no data base.
    records : int
        How many records there are; ``done`` says which of them are made.
    """

    def __init__(self, path: Path, records: int) -> None:
        self.done = np.zeros(records, np.bool_)
        try:
            self._open(path)
        except sqlite3.OperationalError as error:
            if error.sqlite_errorcode != sqlite3.SQLITE_ERROR:  # of the disk, not of other columns
                raise
            self._open_anew(path)
        except (sqlite3.DatabaseError, ValueError):
            self._open_anew(path)

    def _open(self, path: Path) -> None:
        """Open the file; refuse one that is damaged, or has other records than the plan."""
        self._base = sqlite3.connect(path)
        self._base.executescript(_OUTCOMES)
        (state,) = self._base.execute("PRAGMA quick_check(1)").fetchone()
        if state != "ok":
            raise ValueError(state)
        self.done[:] = False
        # SQLite notices damaged pages, but no damaged record: it reads zeros where the file's end is cut off
        for number, record, checksum in self._base.execute("SELECT number, record, checksum FROM outcomes"):
            if zlib.crc32(record) != checksum or len(record) != RECORD.itemsize or number >= len(self.done):
                raise ValueError(number)
            self.done[number] = True

    def _open_anew(self, path: Path) -> None:
        self._base.close()
        for damaged in (path, path.with_name(f"{path.name}-journal")):
            damaged.unlink(missing_ok=True)
        self._open(path)

    def close(self) -> None:
        """Close the file."""
        self._base.close()

    def add(self, records: NDArray[np.void]) -> None:
        """Add records that are not there yet; they are kept once `commit` is called."""
        contents = ((int(record["number"]), record.tobytes()) for record in records)
        rows = ((number, content, zlib.crc32(content)) for number, content in contents)
        self._base.executemany("INSERT INTO outcomes VALUES (?, ?, ?)", rows)

    def commit(self) -> None:
        """Keep what was added."""
        self._base.commit()

    def of(self, numbers: NDArray[np.int64]) -> NDArray[np.void]:
        """Return the records of some numbers, in increasing order."""
        records: list[bytes] = []
        for part in np.split(numbers, np.flatnonzero(np.diff(numbers) != 1) + 1):
            rows = self._base.execute(
                "SELECT record FROM outcomes WHERE number BETWEEN ? AND ? ORDER BY number",
                (int(part[0]), int(part[-1])),
            )
            records += [record for (record,) in rows]
        return np.frombuffer(b"".join(records), RECORD)

    def part(self, name: str) -> tuple[int, str] | None:
        """Return the rows and the digest of a part of the results that is complete."""
        return self._base.execute("SELECT rows, digest FROM parts WHERE name = ?", (name,)).fetchone()

    def complete(self, name: str, rows: int, digest: str) -> None:
        """Note that a part of the results is complete."""
        with self._base:
            self._base.execute("INSERT OR REPLACE INTO parts VALUES (?, ?, ?)", (name, rows, digest))
