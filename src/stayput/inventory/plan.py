"""The plan of an assessment: checked rows, rejects with their reasons, simulation units."""

from __future__ import annotations

import math
import sqlite3
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import closing, suppress
from itertools import chain, islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from stayput.catalogue import is_phrase, phrase
from stayput.errors import InputError, excerpt, not_allowed, quoted
from stayput.inventory.cells import Cell, Unusable, is_empty
from stayput.inventory.columns import COLUMNS, JAPANESE, ColumnMapping
from stayput.inventory.folder import PLAN, Workspace
from stayput.inventory.header import Header
from stayput.inventory.items import SIZES, RowReader, name_of, numbered
from stayput.inventory.store import Store
from stayput.inventory.tables import open_table

if TYPE_CHECKING:
    from stayput.inventory.scenarios import Scenarios

ROWS_PER_PART = 20_000
"""Rows of the inventory in a part of the results."""

REJECTED = ("row", "id", "name", "reason", "reason_ja")
"""What is told of a row that is not assessed."""

ROWS_LOOKED_AT = 200
"""Rows whose numbers tell whether the header is understood."""

FIRST_ALIKE = 5
"""Rows that are told of those that are refused for the same."""

MAY_BE_EMPTY = ("id", *SIZES, "count", "fixed")
"""Columns of which it is told how many cells are empty in rows that are assessed."""

COUNTED = (
    *("rows", "empty rows", "rejects", "pieces", "choices", "parts"),
    *("with coordinates", "in the plane", "without mass"),
)
"""What is counted in a plan, as its facts name it."""

ROWS_PER_UPDATE = 2000
"""Rows between updates of the progress bar."""


class Findings:
    """What is found in many rows, each once, with the number of rows and the first few of them."""

    def __init__(self) -> None:
        self.found: dict[tuple[str | None, ...], dict[str, Any]] = {}

    def add(self, row: Sequence[Any], *about: str | None) -> None:
        """Add a row, id, name, reason and reason_ja, with what tells its kind of finding from others."""
        *piece, english, japanese = row
        reasons = {"reason": english, "reason_ja": japanese, "same": True}
        finding = self.found.setdefault(about, {"about": about[0], **reasons, "rows": 0, "first": []})
        finding["same"] &= finding["reason"] == english
        finding["rows"] += 1
        if len(finding["first"]) < FIRST_ALIKE:
            finding["first"].append(dict(zip(REJECTED, piece, strict=False)))

    def told(self) -> list[dict[str, Any]]:
        """Return the findings, that of most rows first."""
        return sorted(self.found.values(), key=lambda finding: -finding["rows"])


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
    path = space.folder / PLAN
    if path.exists():
        with suppress(sqlite3.DatabaseError), closing(Store(path)) as store:  # of a damaged one
            return store.facts()
    reader, impossible, rejects, fixed = RowReader(scenarios), Findings(), Findings(), Findings()
    counts, left_empty = Counter[str](), Counter[str]()
    buffered: list[dict[str, Any]] = []
    with space.draft(path) as draft, closing(Store(draft, cache)) as store, open_table(inventory) as table:
        store.begin()
        first = list(islice(table.rows, ROWS_LOOKED_AT))
        sample = [[] if isinstance(cells, InputError) else cells for _, cells in first]
        header = Header(table.header, sample, columns, table.decimal_comma)
        for number, cells in chain(first, table.rows):
            counts["rows"] += 1
            if counts["rows"] % ROWS_PER_UPDATE == 0:
                advance(ROWS_PER_UPDATE)
            if not isinstance(cells, InputError) and all(map(is_empty, cells)):
                counts["empty rows"] += 1
                continue
            try:
                if isinstance(cells, InputError):
                    raise cells
                known = header.cells(cells)
                exposures = reader.exposures(number, known)
                piece = exposures[0].row
                before = store.row_of(piece["id"], number)
                if before != number:
                    other = phrase("inventory.row", row=before)
                    raise InputError("scenario.same_name", "id", value=quoted(piece["id"]), other=other)
            except InputError as error:
                counts["rejects"] += 1
                line = _rejected(number, cells, _in_words_of_the_table(error, header), header)
                store.reject(line)
                rejects.add(line, error.code, error.field)
                continue
            for each in exposures:
                records = store.records_of(each.ground, each.storey, each.piece, each.options)
                counts["choices"] += len(records)
                buffered.append({**each.row, "records": records})
            not_put = chain.from_iterable(each.row["not_possible"] for each in exposures)
            for named in {each["name"]: each for each in not_put}.values():
                cause = (number, piece["id"], piece["name"], named["reason"], named["reason_ja"])
                impossible.add(cause, named["name"], named["code"])
            counts["pieces"] += 1
            counts["with coordinates"] += piece["lat"] is not None
            counts["in the plane"] += piece["in_plane"]
            counts["without mass"] += not piece["weighed"]
            if piece["fixed"] is not None:
                fixed.add((number, piece["id"], piece["name"], None, None), piece["fixed"])
            left_empty.update(name for name in MAY_BE_EMPTY if name in known and is_empty(known[name]))
            if counts["pieces"] % ROWS_PER_PART == 0:
                store.add_part(buffered)
                buffered.clear()
        if buffered:
            store.add_part(buffered)
        counts["parts"] = math.ceil(counts["pieces"] / ROWS_PER_PART)
        if counts["rows"] == counts["empty rows"]:
            raise not_allowed("inventory.the_file", inventory, "inventory.no_rows", "inventory")
        left_empty -= Counter({"mass": counts["without mass"]})  # which no preset has
        store.finish(
            {
                **{name: counts[name] for name in COUNTED},
                "empty cells": {header.called.get(name, name): left_empty[name] for name in left_empty},
                "rejects alike": rejects.told(),
                "measures not possible": impossible.told(),
                "fixed": fixed.told(),
                "currency": next(
                    (unit.currency for unit in map(header.units.get, ("value", "costs")) if unit), ""
                ),
                "units": store.next_record,
                "read as": table.read_as,
                "columns not used": header.unused,
                "columns renamed": header.renamed,
                "roofs": reader.roofs,
            }
        )
        check_unchanged()
        return store.facts()


def _rejected(
    number: int, cells: list[Cell] | InputError, error: InputError, header: Header
) -> tuple[int, str, str | None, str, str]:
    """Return what is told of a row that is refused, by the names of `REJECTED`."""
    known = {} if isinstance(cells, InputError) else dict(enumerate(cells))
    piece, called = (known.get(header.places.get(column, -1)) for column in ("id", "name"))
    identifier = numbered(called, number) if is_empty(piece) else piece
    identifier = "" if isinstance(identifier, Unusable) else str(identifier)[:200]
    return number, identifier, name_of(called), error.told("en"), error.told("ja")


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
