"""Reading the first sheet of a workbook as a stream: memory stays bounded, whatever the file unpacks to.

A sheet of a megabyte may unpack to gigabytes, so no tree is made of its XML: rows are given as they are
parsed, and texts that cells share are counted as they are kept.
"""

from __future__ import annotations

import posixpath
import re
import sys
import zipfile
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple
from xml.parsers.expat import ExpatError

from openpyxl.styles.numbers import BUILTIN_FORMATS, is_date_format

from stayput.errors import InputError
from stayput.inventory.xml_events import xml_events

if TYPE_CHECKING:
    from collections.abc import Generator, Iterator
    from pathlib import Path

ROWS, COLUMNS = 2**20, 2**14
"""Most rows and columns of a sheet, as in Excel."""

LONGEST_TEXT = 2**24
"""Most characters of a cell."""

LARGEST_WORKBOOK = 2**33
"""Largest size of an unpacked workbook [bytes]."""

MOST_PARTS = 100_000
"""Most formats or sheets."""

_JAPANESE_DATES = {*range(27, 37), *range(50, 59)}  # built-in formats that are dates in Japan
_REFERENCE = re.compile(r"([A-Z]{1,3})([0-9]{1,7})", re.ASCII)
_WHOLE = re.compile(r"[+-]?\d{1,15}", re.ASCII)


class SheetCell(NamedTuple):
    """A cell: its type as the file says, its text, whether a formula is in it, and the format of a number."""

    kind: str
    value: str
    formula: bool
    number_format: str

    @property
    def is_date(self) -> bool:
        """Whether it is a date or a time."""
        return self.kind == "d" or (self.kind == "n" and is_date_format(self.number_format))

    def number(self) -> float | int:
        """Return the number that it holds."""
        return int(self.value) if _WHOLE.fullmatch(self.value) else float(self.value)


class Workbook:
    """An open workbook.

    Parameters
    ----------
    packed : ZipFile
        The file.
    memory : int
        Bytes that the texts of its cells may take.

    Attributes
    ----------
    names : dict
        The parts of the sheets of cells by their names, in their order.

    Raises
    ------
    ValueError
        It is damaged, or no workbook.
    InputError
        Its texts need more memory.
    """

    def __init__(self, packed: zipfile.ZipFile, memory: int) -> None:
        self._packed, self._memory = packed, memory
        (book,) = self._related("", "officeDocument").values()
        sheets = self._related(book, "worksheet")
        self._styles = next(iter(self._related(book, "styles").values()), None)
        self._shared = next(iter(self._related(book, "sharedStrings").values()), None)
        self.names: dict[str, str] = {}
        for kind, tag, given in self._events(book):
            part = sheets.get(next((given[key] for key in given if key.endswith(":id")), ""))
            if (kind, tag) == ("start", "sheet") and part is not None:
                self.names[given["name"]] = part

    def _events(self, part: str) -> Iterator[tuple[str, str, dict[str, str]]]:
        """Yield the events of a part; the text of a cell or a shared text comes with its end.

        The readings that Japanese workbooks add are left out.
        """
        try:
            file = self._packed.open(part)
        except KeyError:
            raise ValueError(f"it has no part {part[:80]!r}") from None
        text: list[str] = []
        length, inside, reading = 0, False, False
        with file:
            for kind, tag, given in xml_events(file):
                if kind == "text":
                    if inside and not reading:
                        text.append(tag)
                        length += len(tag)
                        if length > LONGEST_TEXT:
                            raise ValueError(f"a cell goes beyond {LONGEST_TEXT:,} characters")
                    continue
                inside = kind == "start" and tag in ("t", "v")
                if tag == "rPh":
                    reading = kind == "start"
                elif tag in ("c", "si"):
                    yield kind, tag, given if kind == "start" else {"text": "".join(text)}
                    text, length = [], 0
                    continue
                yield kind, tag, given

    def _related(self, part: str, wanted: str) -> dict[str, str]:
        """Return the parts of a kind that a part names, by their ids."""
        folder, name = posixpath.split(part)
        parts: dict[str, str] = {}
        for kind, tag, given in self._events(posixpath.join(folder, "_rels", f"{name}.rels")):
            named = (kind, tag) == ("start", "Relationship") and given.get("Type", "").endswith(f"/{wanted}")
            if named and len(parts) < MOST_PARTS:
                path = posixpath.join("/", folder, given["Target"])
                parts[given["Id"]] = posixpath.normpath(path).lstrip("/")
        return parts

    @cached_property
    def _formats(self) -> list[str]:
        """The number format of each style of a cell."""
        formats = BUILTIN_FORMATS | dict.fromkeys(_JAPANESE_DATES, "yyyy/m/d")
        used: list[int] = []
        of_cells = False
        for kind, tag, given in self._events(self._styles) if self._styles is not None else ():
            if tag == "cellXfs":
                of_cells = kind == "start"
            elif kind == "start" and tag == "numFmt":
                formats[int(given["numFmtId"])] = given["formatCode"]
            elif kind == "start" and tag == "xf" and of_cells:
                used.append(int(given.get("numFmtId", 0)))
            if len(formats) + len(used) > MOST_PARTS:
                raise ValueError(f"it has more than {MOST_PARTS} formats")
        return [formats.get(number, "") for number in used]

    @cached_property
    def _texts(self) -> list[str]:
        """The texts that cells share."""
        texts: list[str] = []
        size = 0
        for kind, tag, given in self._events(self._shared) if self._shared is not None else ():
            if (kind, tag) == ("end", "si"):
                texts.append(given["text"].replace("x005F_", ""))  # Excel escapes underscores so
                size += sys.getsizeof(texts[-1]) + 8
                if size > self._memory:
                    raise InputError("inventory.workbook_texts", size=self._memory / 2**20)
        return texts

    def rows(self, name: str) -> Iterator[tuple[int, dict[int, SheetCell]]]:
        """Give the rows of a sheet that are in the file: number, and cells by columns, both from 1.

        Raises
        ------
        InputError
            After the last row, which is where a file says so: cells of several rows are merged.
        """
        row = column = width = filled = 0
        merged: str | None = None
        inside = formula = False
        cell: dict[str, str] = {}
        cells: dict[int, SheetCell] = {}
        for kind, tag, given in self._events(self.names[name]):
            match kind, tag:
                case _, "sheetData":
                    inside = kind == "start"
                case "start", "mergeCell":
                    first, _, last = (area := given.get("ref", "")).partition(":")
                    (top, left), (bottom, _) = _place(first), _place(last or first)
                    # only the first row has the value
                    if merged is None and top < bottom and top <= filled and left <= width:
                        merged = area
                case "start", "row" if inside:
                    number = int(given.get("r", row + 1))
                    if not row < number <= ROWS:
                        raise ValueError(f"row {number} does not follow row {row}, or is beyond {ROWS}")
                    row, column, cells = number, 0, {}
                case "start", "c" if inside:
                    number = _place(given["r"])[1] if "r" in given else column + 1
                    if not column < number <= COLUMNS:
                        raise ValueError(
                            f"column {number} does not follow column {column}, or is beyond {COLUMNS}"
                        )
                    column, cell, formula = number, given, False
                case "start", "f" if inside:
                    formula = True
                case "end", "c" if inside:
                    if given["text"] or formula:
                        cells[column] = self._cell(cell, given["text"], formula)
                case "end", "row" if inside:
                    if cells:
                        filled, width = row, width or max(cells)
                    yield row, cells
                    cells = {}
                case _:
                    pass
        if merged is not None:
            top = _place(merged.partition(":")[0])[0]
            code = "inventory_tables.merged_headings" if top == 1 else "inventory.merged_cells"
            raise InputError(code, "inventory", cells=merged)

    def _cell(self, given: dict[str, str], text: str, formula: bool) -> SheetCell:
        kind, style = given.get("t", "n"), int(given.get("s", 0))
        if kind != "s":
            shown = self._formats[style] if 0 <= style < len(self._formats) else ""
            return SheetCell(kind, text, formula, shown)
        if not 0 <= int(text) < len(self._texts):
            raise ValueError(f"it has no text {int(text)}")
        return SheetCell("str", self._texts[int(text)], formula, "")


def _place(reference: str) -> tuple[int, int]:
    """Return the row and the column of a place such as "B7", both from 1."""
    match = _REFERENCE.fullmatch(reference)
    if match is None:
        raise ValueError(f"{reference[:20]!r} is no place of a cell")
    column = 0
    for letter in match[1]:
        column = 26 * column + ord(letter) - ord("A") + 1
    return int(match[2]), column


@contextmanager
def open_workbook(path: Path, memory: int) -> Generator[Workbook]:
    """Open a workbook for reading.

    Raises
    ------
    InputError
        It is none, or too large.
    """
    wrong = InputError("inventory.other_kind", "inventory", path=repr(str(path)), kind="Excel")
    try:
        packed = zipfile.ZipFile(path)
    except zipfile.BadZipFile:
        raise wrong from None
    with packed:
        if sum(part.file_size for part in packed.infolist()) > LARGEST_WORKBOOK:
            raise InputError("inventory.workbook_too_large", "inventory", path=repr(str(path)))
        try:
            book = Workbook(packed, memory)
        except (ValueError, KeyError, ExpatError):
            raise wrong from None
        if not book.names:
            raise wrong
        yield book
