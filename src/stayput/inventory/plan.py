"""From the table to a plan on disk: rows that are checked, rejects with their reasons, units of work."""

from __future__ import annotations

import csv
import io
import os
import secrets
import shutil
from contextlib import closing
from typing import TYPE_CHECKING, Any, Self

from stayput.errors import InputError
from stayput.inventory.arrow import arrow, parquet
from stayput.inventory.cells import Unusable
from stayput.inventory.folder import digest_of, read_json, sync_folder, write_json
from stayput.inventory.header import header_of
from stayput.inventory.pieces import Reader
from stayput.inventory.store import Store
from stayput.inventory.tables import open_table

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from stayput.inventory.cells import Cell
    from stayput.inventory.city import Cities
    from stayput.inventory.header import Header
    from stayput.inventory.pieces import Piece

IN_A_PART = 20_000
"""Rows of the inventory in a part of the results."""

REJECTS = ("rejects.parquet", "rejects.csv")
ROWS, STORE, SUMS = "rows", "plan.sqlite", "sums.json"

_TELL = 2000  # rows between words of progress


def schema() -> Any:
    """Return the schema of the checked rows: one for each piece and event."""
    pa = arrow()

    return pa.schema(
        [
            ("row", pa.int64()),
            ("id", pa.string()),
            ("count", pa.int32()),
            ("value", pa.float64()),
            ("lat", pa.float64()),
            ("lon", pa.float64()),
            ("event", pa.string()),
            ("station", pa.string()),
            ("level", pa.float64()),
            ("building", pa.string()),
            ("storey", pa.int32()),
            ("options", pa.list_(pa.string())),
            ("costs", pa.list_(pa.float64())),
            ("units", pa.list_(pa.int64())),
        ]
    )


class Rejects:
    """Writes the rows that are not assessed, with their reasons."""

    def __init__(self, folder: Path) -> None:
        pa, pq = arrow(), parquet()

        self.schema = pa.schema([("row", pa.int64()), ("id", pa.string()), ("reason", pa.string())])
        self.file = (folder / REJECTS[0]).open("wb")
        self.parquet: Any = pq.ParquetWriter(self.file, self.schema, compression="zstd")
        self.text = (folder / REJECTS[1]).open("w", encoding="utf-8", newline="")
        self.lines = csv.writer(self.text)
        self.lines.writerow(self.schema.names)
        self.waiting: list[tuple[int, str, str]] = []
        self.count = 0

    def add(self, row: int, name: object, reason: str) -> None:
        """Add a row."""
        told = "" if name is None or isinstance(name, Unusable) else str(name)[:200]
        self.waiting.append((row, told, reason))
        self.count += 1
        if len(self.waiting) >= IN_A_PART:
            self.flush()

    def flush(self) -> None:
        """Write what waits."""
        pa = arrow()

        if not self.waiting:
            return
        columns = dict(zip(self.schema.names, map(list, zip(*self.waiting, strict=True)), strict=True))
        self.parquet.write_table(pa.table(columns, schema=self.schema))
        self.lines.writerows([(row, _harmless(name), reason) for row, name, reason in self.waiting])
        self.waiting.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        """Write the rest, unless it is given up; close the files in any case."""
        try:
            if kind is None:
                self.flush()
            self.parquet.close()
        finally:
            self.file.close()
            self.text.close()


def _harmless(text: str) -> str:
    """Return a text that a spreadsheet does not take for a formula, on one line."""
    plain = " ".join(text.split())
    return f"'{plain}" if plain.startswith(("=", "+", "-", "@")) else plain


def make_plan(
    work: Path, inventory: Path, cities: Cities, cache: int, tell: Callable[[int], None]
) -> dict[str, Any]:
    """Read and check the whole inventory, once; return what is known of the plan.

    A plan that is there already is taken if it is whole; a broken one is made again, with the same numbers,
    so that what was simulated of it still holds.

    Parameters
    ----------
    work : Path
        Folder of the plan.
    inventory : Path
        The table.
    cities : Cities
        The scenarios.
    cache : int
        Bytes for the cache of the data base.
    tell : callable
        Told of rows that are read.

    Raises
    ------
    InputError
        A table that cannot be read, a wrong header, or no row.
    """
    place = work / "plan"
    if place.exists() and not _is_whole(place):
        broken = _draft_of(place)
        place.replace(broken)
        shutil.rmtree(broken)
    if not place.exists():
        draft = _draft_of(place)
        draft.mkdir()
        try:
            (draft / ROWS).mkdir()
            _fill(draft, inventory, cities, cache, tell)
            write_json(draft / SUMS, _sums(draft))
            for path in draft.rglob("*"):
                if path.is_file():
                    with path.open("rb+") as file:
                        os.fsync(file.fileno())
            draft.replace(place)
            sync_folder(work)
        finally:
            if draft.exists():
                shutil.rmtree(draft)
    with closing(Store(place / STORE)) as store:
        return store.facts()


def _draft_of(place: Path) -> Path:
    """Return a name beside a folder that is swept up if it is left behind."""
    return place.with_name(f".{place.name}-{secrets.token_hex(4)}")


def _sums(place: Path) -> dict[str, str]:
    """Return the digests of all files of a plan but that of the digests."""
    files = (path for path in sorted(place.rglob("*")) if path.is_file())
    return {path.relative_to(place).as_posix(): digest_of(path) for path in files if path.name != SUMS}


def _is_whole(place: Path) -> bool:
    return read_json(place / SUMS) == _sums(place)


def _fill(folder: Path, inventory: Path, cities: Cities, cache: int, tell: Callable[[int], None]) -> None:
    reader = Reader(cities)
    seen = empty = parts = pieces = choices = 0
    waiting: list[tuple[Piece, list[list[int]]]] = []

    def flush() -> None:
        nonlocal parts
        if waiting:
            _write_rows(folder / ROWS / f"part-{parts:06d}.parquet", waiting, cities)
            parts += 1
            waiting.clear()

    with closing(Store(folder / STORE, cache)) as store:
        store.begin()
        with Rejects(folder) as rejects, open_table(inventory) as table:
            header = header_of(table.header)
            for number, cells in table.rows:
                seen += 1
                if seen % _TELL == 0:
                    tell(_TELL)
                if not isinstance(cells, InputError) and all(cell in (None, "") for cell in cells):
                    empty += 1
                    continue
                found = _checked(number, cells, header, reader, store, rejects)
                if found is not None:
                    units = [store.units_of(met) for met in found.met]
                    choices += sum(map(len, units))
                    pieces += 1
                    waiting.append((found, units))
                    if len(waiting) >= IN_A_PART:
                        flush()
            flush()
        if seen == empty:
            raise InputError(f"The inventory is {str(inventory)!r}; it must have a row below its header.")
        store.finish(
            {
                "rows": seen,
                "empty rows": empty,
                "pieces": pieces,
                "rejects": rejects.count,
                "parts": parts,
                "units": store.next_unit,
                "choices": choices,
                "read as": table.how,
                "columns not used": list(header.unused),
            }
        )


def _checked(
    number: int,
    cells: list[Cell] | InputError,
    header: Header,
    reader: Reader,
    store: Store,
    rejects: Rejects,
) -> Piece | None:
    name: Cell = None
    try:
        if isinstance(cells, InputError):
            raise cells
        place = header.places["id"]
        name = cells[place] if place < len(cells) else None
        piece = reader.piece(number, header.cells(cells))
        first = store.row_of(piece.id, number)
        if first != number:
            raise InputError(
                f"id is {piece.id!r}, which is that of row {first}; every row must have its own."
            )
    except InputError as error:
        rejects.add(number, name, str(error))
        return None
    return piece


def _write_rows(path: Path, rows: list[tuple[Piece, list[list[int]]]], cities: Cities) -> None:
    pa, pq = arrow(), parquet()

    lines: Iterator[tuple[Any, ...]] = (
        (
            piece.row,
            piece.id,
            piece.count,
            piece.value,
            piece.lat,
            piece.lon,
            met.event,
            cities.all[met.station].name,
            met.level,
            met.building,
            None if met.building is None else met.storey,
            [option.name for option in met.options],
            list(piece.costs) or None,
            numbers,
        )
        for piece, units in rows
        for met, numbers in zip(piece.met, units, strict=True)
    )
    columns = [list(column) for column in zip(*lines, strict=True)]
    table = pa.table(dict(zip(schema().names, columns, strict=True)), schema=schema())
    pq.write_table(table, path, compression="zstd")


def csv_text(names: list[str], rows: list[list[Any]]) -> str:
    """Return a table as CSV."""
    text = io.StringIO()
    lines = csv.writer(text)
    lines.writerow(names)
    lines.writerows([["" if cell is None else cell for cell in row] for row in rows])
    return text.getvalue()
