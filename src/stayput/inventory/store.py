"""What is to be simulated, each thing once, on disk: bodies in rooms, options, sites, and units of them."""

from __future__ import annotations

import hashlib
import json
import sqlite3
from collections import OrderedDict
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Hashable, Iterator
    from pathlib import Path

    from stayput.inventory.pieces import Meeting

KEPT = 400_000
"""Numbers of things and of units that are kept in memory."""

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


class Numbers:
    """Numbers by key, the newest in memory."""

    def __init__(self, most: int = KEPT) -> None:
        self.most = most
        self.found: OrderedDict[Hashable, int] = OrderedDict()

    def put(self, key: Hashable, number: int) -> int:
        """Keep a number."""
        self.found[key] = number
        if len(self.found) > self.most:
            self.found.popitem(last=False)
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
        self.things, self.options, self.sites, self.units = (Numbers() for _ in range(4))
        self.next_unit = 0

    def begin(self) -> None:
        """Make the tables; all is one transaction until `finish`."""
        self.base.execute("PRAGMA journal_mode = OFF")  # a plan that is not finished is thrown away
        self.base.execute("PRAGMA synchronous = OFF")
        self.base.executescript(_TABLES)
        self.base.execute("BEGIN")

    def finish(self, facts: dict[str, Any]) -> None:
        """Keep what is to be known of the plan, and close it."""
        self.base.executemany(
            "INSERT INTO facts VALUES (?, ?)", [(name, json.dumps(value)) for name, value in facts.items()]
        )
        self.base.execute("COMMIT")
        self.base.close()

    def close(self) -> None:
        """Close the file."""
        self.base.close()

    def facts(self) -> dict[str, Any]:
        """Return what is known of the plan."""
        return {name: json.loads(value) for name, value in self.base.execute("SELECT * FROM facts")}

    def row_of(self, name: str, row: int) -> int:
        """Return the row that first had an id: this one, where it is new."""
        try:
            self.base.execute("INSERT INTO ids VALUES (?, ?)", (name, row))
        except sqlite3.IntegrityError:
            return int(self.base.execute("SELECT row FROM ids WHERE id = ?", (name,)).fetchone()[0])
        return row

    def units_of(self, met: Meeting) -> list[int]:
        """Return the numbers of the units of a piece under an event, one an option; new ones are added."""
        site = self._number(self.sites, (met.ground, met.storey), "sites", ("ground", "storey"))
        thing = self._thing(met.thing)
        found: list[int] = []
        for option in met.options:
            number = self._number(self.options, (option.spec,), "options", ("spec",))
            found.append(self._unit(site, number, thing))
        return found

    def _number(self, kept: Numbers, key: tuple[str | int, ...], table: str, columns: tuple[str, ...]) -> int:
        if key in kept.found:
            return kept.found[key]
        where = " AND ".join(f"{column} = ?" for column in columns)
        row = self.base.execute(f"SELECT id FROM {table} WHERE {where}", key).fetchone()
        if row is None:
            marks = ", ".join("?" for _ in columns)
            added = self.base.execute(f"INSERT INTO {table} ({', '.join(columns)}) VALUES ({marks})", key)
            assert added.lastrowid is not None
            return kept.put(key, added.lastrowid)
        return kept.put(key, int(row[0]))

    def _thing(self, spec: str) -> int:
        digest = hashlib.blake2b(spec.encode(), digest_size=16).digest()
        if digest in self.things.found:
            return self.things.found[digest]
        row = self.base.execute("SELECT id FROM things WHERE digest = ?", (digest,)).fetchone()
        if row is not None:
            return self.things.put(digest, int(row[0]))
        added = self.base.execute("INSERT INTO things (digest, spec) VALUES (?, ?)", (digest, spec))
        assert added.lastrowid is not None
        return self.things.put(digest, added.lastrowid)

    def _unit(self, site: int, option: int, thing: int) -> int:
        key = (site, option, thing)
        if key in self.units.found:
            return self.units.found[key]
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
        found: dict[str, list[tuple[int, int]]] = {}
        for number, ground, storey in self.base.execute("SELECT id, ground, storey FROM sites ORDER BY id"):
            found.setdefault(ground, []).append((number, storey))
        return list(found.items())

    def option_specs(self) -> dict[int, str]:
        """Return the measures of each option."""
        return dict(self.base.execute("SELECT id, spec FROM options"))

    def units_at(self, site: int) -> Iterator[tuple[int, int, str]]:
        """Give the units of a site: number, option, and what stands; those of one option together."""
        cursor = self.base.cursor()
        cursor.execute(
            "SELECT units.id, units.option, things.spec FROM units JOIN things ON things.id = units.thing "
            "WHERE units.site = ? ORDER BY units.option, units.thing",
            (site,),
        )
        yield from cursor

    def work_left(self) -> dict[int, int]:
        """Return how many units each option has."""
        return dict(self.base.execute("SELECT option, COUNT(*) FROM units GROUP BY option"))
