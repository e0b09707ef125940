"""Reading the rows of an inventory, a few at a time: CSV, Parquet, Excel."""

from __future__ import annotations

import codecs
import csv
import re
import zipfile
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from datetime import date, time
from decimal import Decimal
from functools import lru_cache
from typing import TYPE_CHECKING, Any, cast

from stayput.errors import InputError
from stayput.inventory.arrow import arrow, parquet
from stayput.inventory.cells import Unusable

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator
    from pathlib import Path

    from stayput.inventory.cells import Cell

ENCODINGS = ("utf-8-sig", "cp932")
"""What a CSV file is read as: the first of these in which all of it is text. The first is UTF-8, with
or without a byte order mark; the second is Japan's Windows encoding."""

LARGEST_CELL = 2**24
"""Characters of a cell, or from a quote that opens, after which a CSV file is given up."""

LARGEST_SHEET = 2**33
"""Largest size of an unpacked workbook [bytes]."""

BATCH = 8192
"""Rows of a Parquet file that are read at a time."""

UNITS_SHOWN = frozenset(("mm", "cm", "m", "㎜", "㎝", "in", "ft", "g", "kg", "㎏", "t", "lb", "lbs", "°"))
"""Units in formats of a workbook's numbers with which a number is not taken."""

_LITERAL = re.compile(r'"([^"]*)"|\\(.)')

Row = tuple[int, "list[Cell] | InputError"]
"""Number of a row, the header being row 1, and its cells or why it cannot be read."""


@dataclass(frozen=True, slots=True)
class Table:
    """An open inventory.

    Parameters
    ----------
    header : list
        Cells of its first row.
    rows : iterator
        Its other rows with their numbers.
    how : str
        How it was read: the encoding, the sheet.
    """

    header: list[Cell]
    rows: Iterator[Row]
    how: str


@contextmanager
def open_table(path: Path) -> Generator[Table]:
    """Open an inventory for reading from its beginning.

    Raises
    ------
    InputError
        Another kind of file, one that cannot be read, or an empty one.
    """
    openers: dict[str, Callable[[Path], Any]] = {
        ".csv": _csv,
        ".parquet": _parquet,
        ".xlsx": _excel,
    }
    if path.suffix.lower() not in openers:
        raise InputError(f"The inventory is {str(path)!r}; its name must end in {', '.join(openers)}.")
    with ExitStack() as stack:
        with _readable(path):
            table = stack.enter_context(openers[path.suffix.lower()](path))
        yield replace(table, rows=_guarded(path, table.rows))


def _guarded(path: Path, rows: Iterator[Row]) -> Iterator[Row]:
    with _readable(path):
        yield from rows


@contextmanager
def _readable(path: Path) -> Generator[None]:
    """Turn what a system or a library says of a broken file into a sentence."""
    try:
        yield
    except InputError:
        raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower().rstrip(".")
        raise InputError(f"The inventory is {str(path)!r}; it could not be read: {reason}.") from None
    except Exception as error:  # of a broken file libraries say this or that
        told = " ".join(str(error).split())[:200].rstrip(".")
        raise InputError(
            f"The inventory is {str(path)!r}; it must be whole, and is broken: {told}."
        ) from error


def _encoding(path: Path) -> str:
    for encoding in ENCODINGS:
        decoder = codecs.getincrementaldecoder(encoding)()
        with path.open("rb") as file:
            try:
                while chunk := file.read(2**20):
                    if "\0" in decoder.decode(chunk):
                        break
                else:
                    decoder.decode(b"", final=True)
                    return encoding
            except UnicodeDecodeError:
                continue
    raise InputError(f"The inventory is {str(path)!r}; it must be a text in UTF-8 or cp932.")


@contextmanager
def _csv(path: Path) -> Generator[Table]:
    encoding = _encoding(path)
    before = csv.field_size_limit(LARGEST_CELL)
    try:
        with path.open(encoding=encoding, newline="") as file:
            rows = _csv_rows(csv.reader(file, strict=True))
            first = next(rows, None)
            if first is None or isinstance(first[1], InputError):
                told = "it is empty" if first is None else str(first[1])
                raise InputError(
                    f"The inventory is {str(path)!r}; its first row must name the columns: {told}."
                )
            yield Table(first[1], rows, "UTF-8" if encoding == "utf-8-sig" else encoding)
    finally:
        csv.field_size_limit(before)


def _csv_rows(reader: Any) -> Iterator[Row]:
    number = 0
    while True:
        number += 1
        line = reader.line_num + 1
        try:
            row = next(reader)
        except StopIteration:
            return
        except csv.Error as error:
            where = f"In row {number} of the inventory (line {line})"
            if "unexpected end" in str(error):
                raise InputError(f"{where} a quote opens that does not close; it must close.") from None
            if "field limit" in str(error):
                raise InputError(
                    f"{where} a cell goes beyond {LARGEST_CELL:,} characters; it must be shorter "
                    "(is a quote not closed?)."
                ) from None
            yield number, InputError(f"The row cannot be read: {str(error).rstrip('.')}.")
            continue
        yield number, cast("list[Cell]", row)


@contextmanager
def _parquet(path: Path) -> Generator[Table]:
    pa, pq = arrow(), parquet()

    try:
        file: Any = pq.ParquetFile(path)
    except pa.ArrowInvalid:
        raise InputError(f"The inventory is {str(path)!r}; it must be a Parquet file.") from None
    with file:
        names = cast("list[Cell]", list(file.schema_arrow.names))
        yield Table(names, _parquet_rows(file), "Parquet")


def _parquet_rows(file: Any) -> Iterator[Row]:
    number = 1
    for batch in file.iter_batches(BATCH):
        columns = [column.to_pylist() for column in batch.columns]
        for row in zip(*columns, strict=True):
            number += 1
            yield number, [_cell(value) for value in row]


def _cell(value: Any) -> Cell:
    match value:
        case None | str():
            return value
        case bool():
            return Unusable("true or false")
        case int() | float():
            return value
        case Decimal():
            return float(value)
        case date() | time():
            return Unusable("a date")
        case _:
            return Unusable("neither text nor number")


@contextmanager
def _excel(path: Path) -> Generator[Table]:
    import openpyxl

    wrong = InputError(f"The inventory is {str(path)!r}; it must be an Excel workbook.")
    try:
        with zipfile.ZipFile(path) as packed:
            size = sum(part.file_size for part in packed.infolist())
    except zipfile.BadZipFile:
        raise wrong from None
    if size > LARGEST_SHEET:
        raise InputError(f"The inventory is {str(path)!r}; unpacked it must be below 8 GiB.")
    try:
        book: Any = openpyxl.load_workbook(path, read_only=True, data_only=False, keep_links=False)
    except OSError:
        raise
    except Exception:  # of a file that is no workbook it says this or that
        raise wrong from None
    try:
        sheets: list[Any] = book.worksheets
        if not sheets:
            raise wrong
        sheet = sheets[0]
        rows = _excel_rows(sheet)
        first = next(rows, None)
        if first is None or isinstance(first[1], InputError):
            raise InputError(f"The inventory is {str(path)!r}; its first sheet must not be empty.")
        others = [other.title for other in sheets[1:]]
        told = f"sheet {sheet.title!r}" + (f"; not {', '.join(map(repr, others))}" if others else "")
        yield Table(first[1], rows, told)
    finally:
        book.close()


def _excel_rows(sheet: Any) -> Iterator[Row]:
    sheet.reset_dimensions()  # what the file says of its size may be wrong
    width = 0
    for number, row in enumerate(sheet.iter_rows(), 1):
        cells = [_excel_cell(cell) for cell in row]
        while len(cells) > width and cells[-1] is None:
            cells.pop()
        width = width or len(cells)
        yield number, cells + [None] * (width - len(cells))


def _excel_cell(cell: Any) -> Cell:
    if cell.data_type == "f":
        return Unusable("a formula")
    if cell.data_type == "e":
        return Unusable(f"an error of the spreadsheet ({cell.value})")
    if cell.data_type == "n" and cell.value is not None and (unit := _unit_shown(cell.number_format)):
        return Unusable(f"a number that is shown in {unit}")
    return _cell(cell.value)


@lru_cache(maxsize=1000)
def _unit_shown(number_format: str) -> str | None:
    """Return the unit that a number format adds: the number may be in that unit, and nobody sees it."""
    if "%" in number_format:
        return "%"
    told = "".join(quoted or single for quoted, single in _LITERAL.findall(number_format)).strip()
    return told if told.lower() in UNITS_SHOWN else None
