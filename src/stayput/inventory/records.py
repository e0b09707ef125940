"""Outcomes of simulation units as records of fixed size, in files with a checksum."""

from __future__ import annotations

import hashlib
import os
from typing import TYPE_CHECKING

import numpy as np

from stayput.montecarlo.counting import EVENTS

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from numpy.typing import NDArray

    from stayput.inventory.workspace import Workspace


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


ESTIMATE, LOW, HIGH = range(3)
MEDIAN, P90, MEAN = range(3)

UNITS = "units"
"""Folder of the records."""

_SUM = 32  # bytes of SHA-256


def write_records(space: Workspace, records: NDArray[np.void], plan: str) -> Path:
    """Write records to a file of their own, named by their content.

    Parameters
    ----------
    space : Workspace
        Where.
    records : ndarray of `record_type`
        The records.
    plan : str
        Digest of the plan that they belong to.
    """
    content = records.tobytes()
    total = hashlib.sha256(plan.encode() + content).digest()
    path = space.folder / UNITS / f"{total.hex()[:24]}.units"
    with space.durable(path) as file:
        file.write(content + total)
    return path


def read_records(path: Path, plan: str, kind: np.dtype[np.void]) -> NDArray[np.void] | None:
    """Return the records of a file, or None where it is incomplete or belongs to another plan."""
    content = path.read_bytes()
    body, total = content[:-_SUM], content[-_SUM:]
    if len(total) < _SUM or len(body) % kind.itemsize:
        return None
    if hashlib.sha256(plan.encode() + body).digest() != total:
        return None
    return np.frombuffer(body, kind)


def all_records(folder: Path, plan: str, kind: np.dtype[np.void]) -> Iterator[NDArray[np.void]]:
    """Yield the records of all complete files of a folder."""
    for path in sorted(folder.glob("*.units")):
        records = read_records(path, plan, kind)
        if records is not None:
            yield records


class RecordFile:
    """One file with the records of all units by number, of which only the wanted ones are read into memory.

    Parameters
    ----------
    path : Path
        The file; it is made.
    kind : dtype
        Type of the records.
    """

    def __init__(self, path: Path, kind: np.dtype[np.void]) -> None:
        self.path, self.kind = path, kind

    def gather(self, folder: Path, plan: str, units: int) -> None:
        """Write the file from the records of a folder, of which every unit has one."""
        size = self.kind.itemsize
        with self.path.open("xb") as file:
            file.truncate(units * size)
            for records in all_records(folder, plan, self.kind):
                ordered = records[np.argsort(records["unit"], kind="stable")]
                cuts = np.flatnonzero(np.diff(ordered["unit"]) != 1) + 1
                for part in np.split(ordered, cuts):
                    file.seek(int(part["unit"][0]) * size)
                    file.write(part.tobytes())

    def of(self, units: NDArray[np.int64]) -> NDArray[np.void]:
        """Return the records of some units, in increasing order of their numbers."""
        records = np.empty(len(units), self.kind)
        size = self.kind.itemsize
        with self.path.open("rb", buffering=0) as file:
            descriptor = file.fileno()
            start = 0
            cuts = np.flatnonzero(np.diff(units) != 1) + 1
            for part in np.split(units, cuts):
                content = os.pread(descriptor, len(part) * size, int(part[0]) * size)
                records[start : start + len(part)] = np.frombuffer(content, self.kind)
                start += len(part)
        return records
