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
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any
from xml.parsers import expat

from openpyxl.styles.numbers import BUILTIN_FORMATS, is_date_format

from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator
    from pathlib import Path

ROWS, COLUMNS = 2**20, 2**14
"""Most rows and columns of a sheet, as in Excel."""

LONGEST_TEXT = 2**24
"""Most characters of a cell."""

LARGEST_WORKBOOK = 2**33
"""Largest size of an unpacked workbook [bytes]."""

_CHUNK, _TAG, _DEPTH, _MANY = 2**16, 2**20, 50, 100_000  # bytes, bytes, levels, formats or sheets
_JAPANESE_DATES = {*range(27, 37), *range(50, 59)}  # built-in formats that are dates in Japan
_REFERENCE = re.compile(r"([A-Z]{1,3})([0-9]{1,7})", re.ASCII)
_WHOLE = re.compile(r"[+-]?\d{1,15}", re.ASCII)


@dataclass(frozen=True, slots=True)
class SheetCell:
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
        self._sheets = self._related(book, "worksheet")
        self.names = self._names(book)
        self._styles = next(iter(self._related(book, "styles").values()), None)
        self._shared = next(iter(self._related(book, "sharedStrings").values()), None)

    def _related(self, part: str, kind: str) -> dict[str, str]:
        """Return the parts of a kind that a part names, by their ids."""
        folder, name = posixpath.split(part)
        parts: dict[str, str] = {}

        def start(tag: str, attributes: dict[str, str]) -> None:
            if (
                tag == "Relationship"
                and attributes.get("Type", "").endswith(f"/{kind}")
                and len(parts) < _MANY
            ):
                path = posixpath.join("/", folder, attributes["Target"])
                parts[attributes["Id"]] = posixpath.normpath(path).lstrip("/")

        for _ in self._parsed(posixpath.join(folder, "_rels", f"{name}.rels"), start):
            pass
        return parts

    def _names(self, book: str) -> dict[str, str]:
        """Return the parts of the sheets of cells by their names, in their order."""
        names: dict[str, str] = {}

        def start(tag: str, attributes: dict[str, str]) -> None:
            part = self._sheets.get(next((attributes[key] for key in attributes if key.endswith(":id")), ""))
            if tag == "sheet" and part is not None:
                names[attributes["name"]] = part

        for _ in self._parsed(book, start):
            pass
        return names

    @cached_property
    def _formats(self) -> list[str]:
        """The number format of each style of a cell."""
        if self._styles is None:
            return []
        own: dict[int, str] = {}
        used: list[int] = []
        inside: list[str] = []

        def start(tag: str, attributes: dict[str, str]) -> None:
            inside.append(tag)
            if tag == "numFmt":
                own[int(attributes["numFmtId"])] = attributes["formatCode"]
            elif tag == "xf" and inside[-2:-1] == ["cellXfs"]:
                used.append(int(attributes.get("numFmtId", 0)))
            if len(own) + len(used) > _MANY:
                raise ValueError(f"it has more than {_MANY} formats")

        for _ in self._parsed(self._styles, start, lambda tag: inside.pop()):
            pass
        dates = dict.fromkeys(_JAPANESE_DATES, "yyyy/m/d")
        return [own.get(number) or dates.get(number) or BUILTIN_FORMATS.get(number, "") for number in used]

    @cached_property
    def _texts(self) -> list[str]:
        """The texts that cells share."""
        if self._shared is None:
            return []
        texts: list[str] = []
        text = _Text()
        used = 0

        def end(tag: str) -> None:
            nonlocal used
            if text.ends(tag):
                texts.append(text.take().replace("x005F_", ""))  # Excel escapes underscores so
                used += sys.getsizeof(texts[-1]) + 8
                if used > self._memory:
                    raise InputError("inventory.workbook_texts", size=self._memory / 2**20)

        for _ in self._parsed(self._shared, text.start, end, text.add):
            pass
        return texts

    def rows(self, name: str) -> Iterator[tuple[int, dict[int, SheetCell]]]:
        """Give the rows of a sheet that are in the file: number, and cells by columns, both from 1.

        Raises
        ------
        InputError
            After the last row, which is where a file says so: cells of several rows are merged.
        """
        reader = _Rows(self._formats)
        part = self.names[name]
        for _ in self._parsed(part, reader.start, reader.end, reader.text.add):
            for number, cells in reader.done:
                yield number, {column: self._resolved(cell) for column, cell in cells.items()}
            reader.done.clear()
        if reader.merged is not None:
            top = _place(reader.merged.partition(":")[0])[0]
            code = "inventory_tables.merged_headings" if top == 1 else "inventory.merged_cells"
            raise InputError(code, "inventory", cells=reader.merged)

    def _resolved(self, cell: SheetCell) -> SheetCell:
        if cell.kind != "s":
            return cell
        number = int(cell.value)
        if not 0 <= number < len(self._texts):
            raise ValueError(f"it has no text {number}")
        return SheetCell("str", self._texts[number], cell.formula, "")

    def _parsed(
        self,
        part: str,
        start: Callable[[str, dict[str, str]], None],
        end: Callable[[str], object] = lambda tag: None,
        text: Callable[[str], None] | None = None,
    ) -> Iterator[None]:
        """Parse a part, and pause after each chunk of it."""
        depth = 0

        def started(tag: str, attributes: dict[str, str]) -> None:
            nonlocal depth
            depth += 1
            if depth > _DEPTH:
                raise ValueError(f"it nests more than {_DEPTH} elements")
            start(tag.rpartition(":")[2], attributes)

        def ended(tag: str) -> None:
            nonlocal depth
            depth -= 1
            end(tag.rpartition(":")[2])

        def refused(*_: object) -> None:
            raise ValueError("it declares a document type")

        parser: Any = expat.ParserCreate()
        parser.StartElementHandler, parser.EndElementHandler = started, ended
        parser.StartDoctypeDeclHandler = refused
        parser.buffer_text = True
        if text is not None:
            parser.CharacterDataHandler = text
        try:
            file = self._packed.open(part)
        except KeyError:
            raise ValueError(f"it has no part {part[:80]!r}") from None
        fed = 0
        with file:
            while chunk := file.read(_CHUNK):
                parser.Parse(chunk, False)
                fed += len(chunk)
                if fed - parser.CurrentByteIndex > _TAG:
                    raise ValueError(f"it has a tag of more than {_TAG} bytes")
                yield
            parser.Parse(b"", True)
            yield


class _Text:
    """Text of an element, without the readings that Japanese workbooks add."""

    def __init__(self) -> None:
        self._parts: list[str] = []
        self._length, self._open, self._reading = 0, False, False

    def start(self, tag: str, _given: dict[str, str]) -> None:
        """Take in that an element starts."""
        if tag == "si":
            self.take()
        self._reading = self._reading or tag == "rPh"
        self._open = tag in ("t", "v") and not self._reading

    def add(self, text: str) -> None:
        """Take in characters."""
        if self._open:
            self._parts.append(text)
            self._length += len(text)
            if self._length > LONGEST_TEXT:
                raise ValueError(f"a cell goes beyond {LONGEST_TEXT:,} characters")

    def ends(self, tag: str) -> bool:
        """Take in that an element ends, and return whether the text is complete."""
        self._open = False
        if tag == "rPh":
            self._reading = False
        return tag == "si"

    def take(self) -> str:
        """Return the text, and begin another."""
        text = "".join(self._parts)
        self._parts.clear()
        self._length = 0
        return text


@dataclass(slots=True)
class _Rows:
    """Makes rows of the elements of a sheet."""

    formats: list[str]
    done: list[tuple[int, dict[int, SheetCell]]] = field(default_factory=list[Any])
    text: _Text = field(default_factory=_Text)
    row: int = 0
    column: int = 0
    width: int = 0
    filled: int = 0
    merged: str | None = None
    inside: bool = False
    formula: bool = False
    attributes: dict[str, str] = field(default_factory=dict[str, str])
    cells: dict[int, SheetCell] = field(default_factory=dict[int, SheetCell])

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Take in that an element starts."""
        if tag == "sheetData":
            self.inside = True
        elif tag == "mergeCell":
            self._merge(attributes.get("ref", ""))
        if not self.inside:
            return
        if tag == "row":
            number = int(attributes.get("r", self.row + 1))
            if not self.row < number <= ROWS:
                raise ValueError(f"row {number} does not follow row {self.row}, or is beyond {ROWS}")
            self.row, self.column, self.cells = number, 0, {}
        elif tag == "c":
            self.column = self._column(attributes.get("r"))
            self.attributes, self.formula = attributes, False
            self.text.take()
        elif tag == "f":
            self.formula = True
        self.text.start(tag, attributes)

    def end(self, tag: str) -> None:
        """Take in that an element ends."""
        if not self.inside:
            return
        self.text.ends(tag)
        if tag == "c":
            value = self.text.take()
            kind, style = self.attributes.get("t", "n"), int(self.attributes.get("s", 0))
            if value or self.formula:
                shown = self.formats[style] if 0 <= style < len(self.formats) else ""
                self.cells[self.column] = SheetCell(kind, value, self.formula, shown)
        elif tag == "row":
            if self.cells:
                self.filled, self.width = self.row, self.width or max(self.cells)
            self.done.append((self.row, self.cells))
            self.cells = {}
        elif tag == "sheetData":
            self.inside = False

    def _merge(self, area: str) -> None:
        """Keep the first merged cells that go over rows of the table: only the first row has the value."""
        first, _, last = area.partition(":")
        (top, left), (bottom, _) = _place(first), _place(last or first)
        if self.merged is None and top < bottom and top <= self.filled and left <= self.width:
            self.merged = area

    def _column(self, reference: str | None) -> int:
        column = self.column + 1 if reference is None else _place(reference)[1]
        if not self.column < column <= COLUMNS:
            raise ValueError(f"column {column} does not follow column {self.column}, or is beyond {COLUMNS}")
        return column


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
    wrong = InputError("inventory.not_a_workbook", "inventory", path=repr(str(path)))
    try:
        packed = zipfile.ZipFile(path)
    except zipfile.BadZipFile:
        raise wrong from None
    with packed:
        if sum(part.file_size for part in packed.infolist()) > LARGEST_WORKBOOK:
            raise InputError("inventory.workbook_too_large", "inventory", path=repr(str(path)))
        try:
            book = Workbook(packed, memory)
        except (ValueError, KeyError, expat.ExpatError):
            raise wrong from None
        if not book.names:
            raise wrong
        yield book
