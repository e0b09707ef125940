"""Reading the rows of an inventory, a few at a time: CSV, Parquet, Excel."""

from __future__ import annotations

import codecs
import csv
import re
import warnings
from collections.abc import Callable, Generator, Iterator
from contextlib import AbstractContextManager, ExitStack, closing, contextmanager
from datetime import date, time
from decimal import Decimal
from functools import lru_cache
from itertools import count
from pathlib import Path
from typing import Any, NamedTuple, TextIO, cast
from xml.etree.ElementTree import iterparse

from stayput.catalogue import phrase
from stayput.errors import InputError, absent, not_allowed
from stayput.files import arrow, table_lines
from stayput.inventory.cells import Cell, Unusable
from stayput.inventory.folder import unreadable

ENCODINGS = ("utf-8-sig", "cp932")
"""Encodings of a text without a byte order mark of UTF-16: the first in which all of it can be decoded is
used. The first is UTF-8, with or without a byte order mark; the second is Japan's Windows encoding."""

DELIMITERS = (",", ";", "\t", "|")
"""Marks between the cells of a text: that which cuts the first row into most cells."""

LINES_OF_A_TITLE = 20
"""Most lines above the headings in which marks between cells are looked for."""

LARGEST_CELL = 2**24
"""Characters of a cell, or from a quote that opens, after which a CSV file is given up."""

ROWS_OF_EXCEL = 2**20
"""Most rows of a sheet."""

BATCH = 8192
"""Rows of a Parquet file that are read at a time."""

UNITS_SHOWN = frozenset(("mm", "cm", "m", "㎜", "㎝", "in", "ft", "g", "kg", "㎏", "t", "lb", "lbs", "°"))
"""Units in a cell's number format for which the cell is refused."""

_LITERAL = re.compile(r'"([^"]*)"|\\(.)')

_JAPANESE = re.compile(r"[々぀-ヿ㐀-鿿ｦ-ﾟ]{2}")
_TORN = re.compile(r"[A-Za-z][㐀-鿿ｦ-ﾟ\ue000-\uf8ff][a-z]")

TableRow = tuple[int, "list[Cell] | InputError"]
"""Number of a row, the header being row 1, and its cells or why it cannot be read."""

Opened = tuple["Iterator[TableRow]", str, bool]
"""The rows of a file, the header among them, how it was read, and whether commas may be decimal."""


class OpenTable(NamedTuple):
    """An open inventory.

    Parameters
    ----------
    header : list
        Cells of its first row.
    rows : iterator
        Its other rows with their numbers.
    read_as : str
        How it was read: the encoding, the sheet.
    decimal_comma : bool
        Whether numbers may have a comma in the place of a point.
    """

    header: list[Cell]
    rows: Iterator[TableRow]
    read_as: str
    decimal_comma: bool = False


@contextmanager
def open_table(path: Path) -> Generator[OpenTable]:
    """Open an inventory for reading from its beginning.

    Parameters
    ----------
    path : Path
        The table.

    Raises
    ------
    InputError
        Another kind of file, one that cannot be read, or an empty one.
    """
    openers: dict[str, Callable[[Path], AbstractContextManager[Opened]]] = {
        **dict.fromkeys((".csv", ".tsv", ".txt"), _csv),
        ".parquet": _parquet,
        ".xlsx": _excel,
    }
    opener = openers.get(path.suffix.lower())
    if opener is None:
        raise _refused(path, "inventory.file_ending", endings=", ".join(openers))
    with ExitStack() as stack:
        with _readable(path):
            rows, read_as, decimal_comma = stack.enter_context(opener(path))
            _, header = next(rows, (1, None))
        if header is None or isinstance(header, InputError):
            empty = phrase("inventory.is_empty")
            reason = empty if header is None else (header.told("en"), header.told("ja"))
            raise InputError("inventory.first_row", "inventory", reason=reason)
        yield OpenTable(header, _guarded(path, rows), read_as, decimal_comma)


def _guarded(path: Path, rows: Iterator[TableRow]) -> Iterator[TableRow]:
    with _readable(path):
        yield from rows


@contextmanager
def _readable(path: Path) -> Generator[None]:
    """Turn errors of the system or of a library about a broken file into an `InputError`."""
    try:
        yield
    except InputError:
        raise
    except OSError as error:
        raise unreadable(path, error) from None
    except Exception as error:  # of a broken file libraries say this or that
        reason = " ".join(str(error).split())[:200].rstrip(" .")
        raise InputError("common.unreadable", "inventory", file=path, reason=reason) from error


def _refused(path: Path, allowed: str, **values: object) -> InputError:
    return not_allowed("inventory.the_file", path, phrase(allowed, **values), "inventory")


def _encoding(path: Path) -> str:
    with path.open("rb") as file:
        marks = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
        encodings = ("utf-16",) if file.read(2) in marks else ENCODINGS
    for encoding in encodings:
        decoder = codecs.getincrementaldecoder(encoding)()
        with path.open("rb") as file:
            try:
                while chunk := file.read(2**20):
                    text = decoder.decode(chunk)
                    if "\0" in text or (encoding == "cp932" and _is_western(text)):
                        break
                else:
                    decoder.decode(b"", final=True)
                    return encoding
            except UnicodeDecodeError:
                continue
    raise _refused(path, "inventory.encoding")


def _is_western(text: str) -> bool:
    """Return whether what was read as cp932 is text of Western Europe.

    An accented letter then takes the next letter with it, and both make a single Japanese one within a word.
    """
    return _TORN.search(text) is not None and _JAPANESE.search(text) is None


@contextmanager
def _csv(path: Path) -> Generator[Opened]:
    encoding = _encoding(path)
    before = csv.field_size_limit(LARGEST_CELL)
    try:
        with path.open(encoding=encoding, newline="") as file:
            delimiter = _delimiter(file)
            rows = _csv_rows(csv.reader(table_lines(file, path), strict=True, delimiter=delimiter))
            read_as = {"utf-8-sig": "UTF-8", "utf-16": "UTF-16"}.get(encoding, encoding)
            between = {";": " with semicolons", "\t": " with tabs", "|": " with bars"}.get(delimiter, "")
            yield rows, read_as + between, delimiter == ";"
    finally:
        csv.field_size_limit(before)


def _delimiter(file: TextIO) -> str:
    """Return what stands between the cells of a text, which is then at its first row.

    Excel's first line ``sep=;`` says it, and is no row; a title above the headings has no such marks.
    """
    start = file.tell()
    line = file.readline(LARGEST_CELL)
    stated = re.fullmatch(r"sep=(.)\r?\n?", line)
    if stated is not None and stated[1] in DELIMITERS:
        return stated[1]
    for _ in range(LINES_OF_A_TITLE):
        if not line or any(mark in line for mark in DELIMITERS):
            break
        line = file.readline(LARGEST_CELL)
    file.seek(start)

    def cells(delimiter: str) -> int:
        try:
            return len(next(csv.reader([line], delimiter=delimiter), ()))
        except csv.Error:
            return 0

    return max(DELIMITERS, key=cells)


def _csv_rows(reader: Any) -> Iterator[TableRow]:
    for number in count(1):
        line = reader.line_num + 1
        try:
            row = next(reader)
        except StopIteration:
            return
        except csv.Error as error:
            if "unexpected end" in str(error) or "field limit" in str(error):
                raise InputError("inventory.open_quote", row=number, line=line, most=LARGEST_CELL) from None
            reason = str(error).rstrip(".")
            yield number, InputError("common.unreadable", file=phrase("inventory.a_row"), reason=reason)
            continue
        yield number, cast("list[Cell]", row)


@contextmanager
def _parquet(path: Path) -> Generator[Opened]:
    try:
        file: Any = arrow("parquet").ParquetFile(path)
    except arrow().ArrowInvalid:
        raise _refused(path, "inventory.other_kind", kind="Parquet") from None
    with file:
        yield _parquet_rows(file), "Parquet", False


def _parquet_rows(file: Any) -> Iterator[TableRow]:
    yield 1, list(file.schema_arrow.names)
    batches = ([column.to_pylist() for column in batch.columns] for batch in file.iter_batches(BATCH))
    for number, row in enumerate((row for columns in batches for row in zip(*columns, strict=True)), 2):
        yield number, [_cell(value) for value in row]


def _cell(value: Any) -> Cell:
    match value:
        case None | "":
            return None
        case bool():
            return str(value).lower()
        case str() | int() | float():
            return value
        case Decimal():
            return float(value)
        case date() | time():
            return _unusable("date")
        case _:
            return _unusable("other")


EAST_ASIAN_DATES = frozenset((*range(27, 37), *range(50, 59)))
"""East Asian dates and times among Excel's formats (ECMA-376, 18.8.30), which openpyxl reads as numbers."""


@contextmanager
def _excel(path: Path) -> Generator[Opened]:
    try:
        from openpyxl import load_workbook
    except ModuleNotFoundError as error:
        raise absent("A workbook", error.name or "a library", "inventory") from None
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module="openpyxl")  # of what else is in the file, which is not read
        try:
            book: Any = load_workbook(path, read_only=True)
            sheet, *others = book.worksheets
        except OSError:
            raise
        except Exception:  # of something else than a workbook openpyxl says this or that
            raise _refused(path, "inventory.other_kind", kind="Excel") from None
        with closing(book):
            names = ", ".join(repr(other.title) for other in others)
            yield _excel_rows(sheet), f"sheet {sheet.title!r}" + (f"; not {names}" if names else ""), False


def _excel_rows(sheet: Any) -> Iterator[TableRow]:
    sheet.reset_dimensions()  # which some programs write wrongly
    width = filled = 0
    for number, cells in enumerate(sheet.iter_rows(), 1):
        if number > ROWS_OF_EXCEL:
            raise ValueError(f"it has rows beyond {ROWS_OF_EXCEL}")
        row = [_excel_cell(cell) for cell in cells]
        while row and row[-1] is None:
            row.pop()
        if row:
            filled, width = number, width or len(row)
        yield number, row + [None] * (width - len(row))
    _refuse_merged_cells(sheet, filled, width)


def _excel_cell(cell: Any) -> Cell:
    if cell.data_type == "f":
        return _unusable("formula")
    if cell.data_type == "e":
        return _unusable("error", error=str(cell.value or "")[:40])
    if not isinstance(cell.value, int | float):
        return _cell(cell.value)
    if cell.style_array.numFmtId in EAST_ASIAN_DATES:
        return _unusable("date")
    unit = _unit_shown(cell.number_format)
    return _cell(cell.value) if unit is None else _unusable("unit", unit=unit)


def _refuse_merged_cells(sheet: Any, filled: int, width: int) -> None:
    """Refuse cells of several rows of the table that are merged: only the first row has their value.

    openpyxl does not say which are, where it reads rows one after another.
    """
    from openpyxl.utils.cell import range_boundaries

    with sheet.parent._archive.open(sheet._worksheet_path) as file:
        for _, element in iterparse(file):
            if element.tag.endswith("}mergeCell"):
                place: Any = range_boundaries(element.get("ref", ""))
                left, top, _, bottom = place
                if top < bottom and top <= filled and left <= width:
                    raise InputError("inventory.merged_cells", "inventory", cells=element.get("ref"))
            element.clear()


def _unusable(kind: str, **values: str) -> Unusable:
    return Unusable(phrase(f"inventory.cell_{kind}", **values))


@lru_cache(maxsize=1000)
def _unit_shown(number_format: str) -> str | None:
    """Return the unit that a number format adds: the number may be in that unit, and nobody sees it."""
    if "%" in number_format:
        return "%"
    unit = "".join(quoted or single for quoted, single in _LITERAL.findall(number_format)).strip()
    return unit if unit.lower() in UNITS_SHOWN else None
