"""Outcomes of simulation units as records of fixed size, and which parts of the results are complete."""

from __future__ import annotations

import sqlite3
from typing import TYPE_CHECKING

import numpy as np

from stayput.montecarlo.counting import EVENTS

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray


def record_type(motions: int, samples: int) -> np.dtype[np.void]:
    """Return the type of the outcome of a unit, of which so many runs are made at most."""
    return np.dtype(
        [
            ("unit", "<i8"),
            ("motions", "<i4"),
            ("runs", "<i4"),  # without those given up
            ("missing", "<i4"),
            ("fell", "<i4"),
            ("chances", "<f8", (len(EVENTS), 3)),  # estimate, low, high of each event
            ("slide", "<f8", (3,)),  # median, 90 % quantile, mean of those that stay upright [m]
            ("out", "<f8", (3,)),  # share of the contents that come out: estimate, low, high; nan without any
            # a bit a sample: each event, and at last whether the run was given up or not made
            ("each", "u1", (len(EVENTS) + 1, motions, -(-samples // 8))),
        ]
    )


_TABLES = """
CREATE TABLE IF NOT EXISTS outcomes (unit INTEGER PRIMARY KEY, record BLOB NOT NULL);
CREATE TABLE IF NOT EXISTS parts (name TEXT PRIMARY KEY, rows INTEGER NOT NULL, digest TEXT NOT NULL);
"""


class OutcomeStore:
    """What is done of an assessment, in SQLite: what was saved stays when the process is killed.

    Parameters
    ----------
    path : Path
        The file; made where it is not there, and anew where it is no data base.
    kind : dtype
        Type of the records.
    units : int
        How many units there are; ``done`` says which of them have an outcome.
    """

    def __init__(self, path: Path, kind: np.dtype[np.void], units: int) -> None:
        self.kind = kind
        self.done = np.zeros(units, np.bool_)
        try:
            self._open(path)
        except sqlite3.OperationalError:  # of the disk
            raise
        except sqlite3.DatabaseError:
            for damaged in (path, path.with_name(f"{path.name}-journal")):
                damaged.unlink(missing_ok=True)
            self._open(path)

    def _open(self, path: Path) -> None:
        self._base = sqlite3.connect(path)
        self._base.executescript(_TABLES)
        units = self._base.execute("SELECT unit FROM outcomes")
        self.done[np.fromiter((unit for (unit,) in units), np.int64)] = True

    def close(self) -> None:
        """Close the file."""
        self._base.close()

    def save(self, records: NDArray[np.void]) -> None:
        """Save the outcomes of units that have none yet."""
        with self._base:  # a transaction
            rows = ((int(record["unit"]), record.tobytes()) for record in records)
            self._base.executemany("INSERT INTO outcomes VALUES (?, ?)", rows)

    def of(self, units: NDArray[np.int64]) -> NDArray[np.void]:
        """Return the records of some units, in increasing order of their numbers."""
        records: list[bytes] = []
        for part in np.split(units, np.flatnonzero(np.diff(units) != 1) + 1):
            rows = self._base.execute(
                "SELECT record FROM outcomes WHERE unit BETWEEN ? AND ? ORDER BY unit",
                (int(part[0]), int(part[-1])),
            )
            records += [record for (record,) in rows]
        return np.frombuffer(b"".join(records), self.kind)

    def part(self, name: str) -> tuple[int, str] | None:
        """Return the rows and the digest of a part of the results that is complete."""
        return self._base.execute("SELECT rows, digest FROM parts WHERE name = ?", (name,)).fetchone()

    def complete(self, name: str, rows: int, digest: str) -> None:
        """Note that a part of the results is complete."""
        with self._base:
            self._base.execute("INSERT OR REPLACE INTO parts VALUES (?, ?, ?)", (name, rows, digest))


ESTIMATE, LOW, HIGH = range(3)
MEDIAN, P90, MEAN = range(3)
