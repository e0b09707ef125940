"""The plan of an assessment on disk: checked rows, rejects with their reasons, simulation units."""

from __future__ import annotations

import csv
import sqlite3
from collections import Counter
from contextlib import ExitStack, closing
from itertools import chain, islice
from typing import TYPE_CHECKING, Any, Self

from stayput.catalogue import is_phrase, phrase
from stayput.errors import InputError, excerpt, not_allowed, quoted
from stayput.extras import arrow
from stayput.inventory.cells import Unusable, is_empty
from stayput.inventory.columns import COLUMNS, JAPANESE
from stayput.inventory.folder import remove
from stayput.inventory.header import header_of
from stayput.inventory.items import SIZES, RowReader, name_of, numbered
from stayput.inventory.store import Store
from stayput.inventory.tables import open_table
from stayput.spreadsheets import CSV_ENCODING, harmless

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from stayput.inventory.cells import Cell
    from stayput.inventory.columns import ColumnMapping
    from stayput.inventory.folder import Workspace
    from stayput.inventory.header import Header
    from stayput.inventory.items import Item
    from stayput.inventory.scenarios import Scenarios

ROWS_PER_PART = 20_000
"""Rows of the inventory in a part of the results."""

REJECTED = ("row", "id", "name", "reason", "reason_ja")
"""What is told of a row that is not assessed."""

REJECTS = ("rejects.parquet", "rejects.csv")
ROWS, STORE = "rows", "plan.sqlite"

ROWS_LOOKED_AT = 200
"""Rows whose numbers tell whether the header is understood."""

FIRST_ALIKE = 5
"""Rows that are told of those that are refused for the same."""

MAY_BE_EMPTY = ("id", *SIZES, "count")
"""Columns of which it is told how many cells are empty in rows that are assessed."""

COUNTED = ("rows", "empty rows", "pieces", "choices", "parts", "with coordinates", "narrower than deep")
"""What is counted in a plan, as its facts name it."""

ROWS_PER_UPDATE = 2000
"""Rows between updates of the progress bar."""


def schema() -> Any:
    """Return the schema of the checked rows: one for each piece and event."""
    pa = arrow()
    text, real, texts = pa.string(), pa.float64(), pa.list_(pa.string())
    kinds = {"row": pa.int64(), "id": text, "name": text, "count": pa.int32()}
    kinds |= dict.fromkeys(("value", "lat", "lon"), real) | dict.fromkeys(("event", "station"), text)
    kinds |= {"level": real, "shaking_scatter": real, "building": text, "storey": pa.int32()}
    kinds |= {"options": texts, "costs": pa.list_(real), "units": pa.list_(pa.int64())}
    return pa.schema([*kinds.items(), ("not_possible", not_possible())])


def not_possible() -> Any:
    """Return the type of the sets of measures that cannot be put in place: their names, and why not."""
    pa = arrow()
    return pa.list_(pa.struct([("name", pa.string()), ("reason", pa.string()), ("reason_ja", pa.string())]))


class Findings:
    """What is found in many rows, each once, with the number of rows and the first few of them."""

    def __init__(self) -> None:
        self.found: dict[tuple[str | None, ...], dict[str, Any]] = {}

    def add(self, row: Sequence[Any], *about: str | None) -> None:
        """Add a row, id, name, reason and reason_ja, with what tells its kind of finding from others."""
        *piece, english, japanese = row
        if about not in self.found:
            reasons = {"reason": english, "reason_ja": japanese, "same": True}
            self.found[about] = {"about": about[0], **reasons, "rows": 0, "first": []}
        finding = self.found[about]
        finding["same"] &= finding["reason"] == english
        finding["rows"] += 1
        if len(finding["first"]) < FIRST_ALIKE:
            finding["first"].append(dict(zip(REJECTED, piece, strict=False)))

    def told(self) -> list[dict[str, Any]]:
        """Return the findings, that of most rows first."""
        return sorted(self.found.values(), key=lambda finding: -finding["rows"])


class Rejects:
    """Writes the rows that are not assessed, with their reasons."""

    def __init__(self, folder: Path) -> None:
        pa = arrow()
        kinds = [pa.int64(), *[pa.string()] * (len(REJECTED) - 1)]
        self.schema = pa.schema(list(zip(REJECTED, kinds, strict=True)))
        self.files = ExitStack()
        file = self.files.enter_context((folder / REJECTS[0]).open("wb"))
        writer = arrow("parquet").ParquetWriter(file, self.schema, compression="zstd")
        self.parquet: Any = self.files.enter_context(writer)
        text = (folder / REJECTS[1]).open("w", encoding=CSV_ENCODING, newline="")
        self.lines = csv.writer(self.files.enter_context(text))
        self.lines.writerow(REJECTED)
        self.buffered: list[tuple[int, str, str | None, str, str]] = []
        self.count = 0
        self.findings = Findings()

    def add(self, row: int, piece: Cell, called: Cell, error: InputError) -> None:
        """Add a row that is refused, with its id and what its piece is called."""
        identifier = numbered(called, row) if is_empty(piece) else piece
        identifier = "" if isinstance(identifier, Unusable) else str(identifier)[:200]
        line = row, identifier, name_of(called), error.told("en"), error.told("ja")
        self.buffered.append(line)
        self.count += 1
        self.findings.add(line, error.code, error.field)
        if len(self.buffered) >= ROWS_PER_PART:
            self.flush()

    def flush(self) -> None:
        """Write the rows that are buffered."""
        if not self.buffered:
            return
        named = [dict(zip(REJECTED, line, strict=True)) for line in self.buffered]
        self.parquet.write_table(arrow().Table.from_pylist(named, schema=self.schema))
        self.lines.writerows(
            (row, harmless(" ".join(piece.split())), *map(harmless, texts))
            for row, piece, *texts in self.buffered
        )
        self.buffered.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        """Write the rest, unless it is given up; close the files in any case."""
        with self.files:
            if kind is None:
                self.flush()


def make_plan(
    space: Workspace,
    inventory: Path,
    scenarios: Scenarios,
    cache: int,
    advance: Callable[[int], None],
    check_unchanged: Callable[[], None] = lambda: None,
    columns: ColumnMapping | None = None,
) -> dict[str, Any]:
    """Read and check the whole inventory, once; return the facts of the plan.

    An existing plan is used if it is complete; a damaged one is made again, with the same numbers of units,
    so that what was simulated of it stays valid.

    Parameters
    ----------
    space : Workspace
        Where the plan goes.
    inventory : Path
        The table.
    scenarios : Scenarios
        The scenarios.
    cache : int
        Bytes for the cache of the data base.
    advance : callable
        Called with the number of rows that were just read.
    check_unchanged : callable, optional
        Called when all is read; raises where the table is no longer that which was asked for.
    columns : ColumnMapping, optional
        Which of the table's columns is which, where its header does not say it.

    Raises
    ------
    InputError
        A table that cannot be read, a wrong header, or no row.
    """
    place = space.folder / "plan"
    facts = _facts(place)
    if facts is None:
        if place.exists():
            remove(place)
        draft = space.draft()
        try:
            (draft / ROWS).mkdir(parents=True)
            _fill(draft, inventory, scenarios, cache, advance, columns)
            check_unchanged()
            space.publish(draft, place)
        finally:
            if draft.exists():
                remove(draft)
        facts = _facts(place)
        assert facts is not None
    return facts


def _facts(place: Path) -> dict[str, Any] | None:
    """Return the facts of a plan; None where there is none, or one of its files has not its size."""
    if not (place / STORE).is_file():
        return None
    try:
        with closing(Store(place / STORE)) as store:
            facts = store.facts()
    except sqlite3.DatabaseError:
        return None
    return facts if facts.pop("sizes", None) == _sizes(place) else None


def _sizes(place: Path) -> dict[str, int]:
    """Return the sizes of the files of a plan but its data base."""
    files = (path for path in sorted(place.rglob("*")) if path.is_file() and not path.match(f"{STORE}*"))
    return {path.relative_to(place).as_posix(): path.stat().st_size for path in files}


def _fill(
    folder: Path,
    inventory: Path,
    scenarios: Scenarios,
    cache: int,
    advance: Callable[[int], None],
    columns: ColumnMapping | None,
) -> None:
    reader, impossible = RowReader(scenarios), Findings()
    counts = Counter[str]()
    left_empty = Counter[str]()
    buffered: list[dict[str, Any]] = []

    def flush() -> None:
        if buffered:
            table = arrow().Table.from_pylist(buffered, schema=schema())
            path = folder / ROWS / f"part-{counts['parts']:06d}.parquet"
            arrow("parquet").write_table(table, path, compression="zstd")
            counts["parts"] += 1
            buffered.clear()

    with closing(Store(folder / STORE, cache)) as store:
        store.begin()
        with Rejects(folder) as rejects, open_table(inventory) as table:
            first = list(islice(table.rows, ROWS_LOOKED_AT))
            sample = [[] if isinstance(cells, InputError) else cells for _, cells in first]
            header = header_of(table.header, sample, columns, table.decimal_comma)
            for number, cells in chain(first, table.rows):
                counts["rows"] += 1
                if counts["rows"] % ROWS_PER_UPDATE == 0:
                    advance(ROWS_PER_UPDATE)
                if not isinstance(cells, InputError) and all(map(is_empty, cells)):
                    counts["empty rows"] += 1
                    continue
                item = _checked(number, cells, header, reader, store, rejects)
                if item is None or isinstance(cells, InputError):
                    continue
                units = [
                    store.units_of(each.ground, each.storey, each.piece, each.options)
                    for each in item.exposures
                ]
                not_put = chain.from_iterable(each.row["not_possible"] for each in item.exposures)
                for named in {each["name"]: each for each in not_put}.values():
                    cause = (item.row["row"], item.id, item.row["name"], named["reason"], named["reason_ja"])
                    impossible.add(cause, named["name"])
                width = header.width_of(cells)
                counts["choices"] += sum(map(len, units))
                counts["pieces"] += 1
                counts["with coordinates"] += item.row["lat"] is not None
                counts["narrower than deep"] += width is not None and 0.0 < width < item.depth
                places = ((name, header.places.get(name)) for name in MAY_BE_EMPTY)
                left_empty.update(n for n, place in places if place is not None and is_empty(cells[place]))
                buffered += [
                    {**item.row, **each.row, "units": numbers}
                    for each, numbers in zip(item.exposures, units, strict=True)
                ]
                if counts["pieces"] % ROWS_PER_PART == 0:
                    flush()
            flush()
        if counts["rows"] == counts["empty rows"]:
            raise not_allowed("inventory.the_file", repr(str(inventory)), "inventory.no_rows", "inventory")
        store.finish(
            {
                **{name: counts[name] for name in COUNTED},
                "sizes": _sizes(folder),
                "empty cells": {header.called.get(name, name): left_empty[name] for name in left_empty},
                "rejects": rejects.count,
                "rejects alike": rejects.findings.told(),
                "measures not possible": impossible.told(),
                "units": store.next_unit,
                "read as": table.read_as,
                "columns not used": list(header.unused),
                "columns renamed": list(header.renamed),
                "roofs": reader.roofs,
            }
        )


def _checked(
    number: int,
    cells: list[Cell] | InputError,
    header: Header,
    reader: RowReader,
    store: Store,
    rejects: Rejects,
) -> Item | None:
    """Return the item of a row, or None where it is refused: it is then among the rejects."""
    name: Cell = None
    called: Cell = None
    try:
        if isinstance(cells, InputError):
            raise cells
        known = dict(enumerate(cells))
        name, called = (known.get(header.places.get(column, -1)) for column in ("id", "name"))
        piece = reader.item(number, header.cells(cells))
        first = store.row_of(piece.id, number)
        if first != number:
            raise InputError("inventory.id_twice", "id", name="id", id=quoted(piece.id), row=first)
    except InputError as error:
        rejects.add(number, name, called, _in_words_of_the_table(error, header))
        return None
    return piece


def _in_words_of_the_table(error: InputError, header: Header) -> InputError:
    """Return a refusal that names the column as the table does, and none by stayput's key in Japanese."""

    def named(value: object) -> object:
        name = value[0] if is_phrase(value) else value
        if not isinstance(name, str) or name not in COLUMNS:
            return value
        if name in header.places and name not in header.called:  # it is the table's own name
            return value
        return name, JAPANESE.get(name, header.called.get(name, name))

    context = error.context
    if (written := header.called.get(error.field or "")) is not None:
        context = phrase("inventory_tables.column", header=excerpt(written)), *context
    values = {key: named(value) for key, value in error.values.items()}
    return InputError(error.code, error.field, context=context, **values)
