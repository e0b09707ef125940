"""The text of a file, its lines and the numbers in them; files of other kinds, which are not read.

Numbers go to arrays batch by batch: a list of all words of a file would take some forty times its size.
"""

from __future__ import annotations

import codecs
import io
import math
import os
import re
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt, instance_of, reason_of, too_many
from stayput.files import LARGEST_RECORD

if TYPE_CHECKING:
    from stayput.motion.channels import Channel

_ARCHIVES = (b"PK\x03\x04", b"\x1f\x8b", b"BZh", b"\xfd7zXZ", b"7z\xbc\xaf", b"Rar!")
_OLD_SPREADSHEET = b"\xd0\xcf\x11\xe0"
_IN_SPREADSHEETS = (b"xl/workbook", b"opendocument.spreadsheet")  # names of parts: Excel's, LibreOffice's

LONGEST_LINE = 10_000
"""Longest line that is read; the formats' own end below 500 characters."""

_CONTROLS = bytes(set(range(32)) - set(b"\t\n\v\f\r\x1a")) + b"\x7f"  # in no text file
_DECIMALS = re.compile(r"\.([0-9]+(?:[eE][+\-]?[0-9]+)?)$")
_BEGUN = re.compile(r"[+\-]?[0-9]*\.?[0-9]*(?:[eE][+\-]?[0-9]*)?")
_LETTER = re.compile(r"[A-DF-Za-df-z]")  # any but the e of an exponent
_WORDS = re.compile(r"[ \t,;]+")


def _refused(path: str | os.PathLike[str], kind: str) -> InputError:
    return InputError("motion.file_is", path=str(path), what=phrase(f"motion.{kind}"))


def file_bytes(path: str | os.PathLike[str]) -> bytes:
    """Return what a file holds.

    Raises
    ------
    InputError
        The file is missing, unreadable, a directory or too large.
    """
    instance_of("path", path, (str, os.PathLike))
    try:
        file = Path(path)
        if file.is_dir():
            raise _refused(path, "a_folder")
        size = file.stat().st_size
        if not file.is_file():
            raise _refused(path, "a_device")
        if size > LARGEST_RECORD:
            raise InputError("common.too_many_bytes", file=repr(str(path)), size=size, most=LARGEST_RECORD)
        return file.read_bytes()
    except InputError:
        raise
    except (OSError, ValueError) as error:  # of a text that is no path
        raise InputError("common.unreadable", file=repr(str(path)), reason=reason_of(error)) from None


def text_of(path: str | os.PathLike[str], data: bytes) -> str:
    r"""Return a file's text with "\n" line ends, whatever they were and whichever of its codings it has.

    Raises
    ------
    InputError
        The file is empty or not text.
    """
    if not data.strip():
        raise _refused(path, "empty")
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        data = data.decode("utf-16", "replace").encode()
    if len(data.translate(None, _CONTROLS)) < len(data):
        spreadsheet = data.startswith(_OLD_SPREADSHEET) or any(part in data for part in _IN_SPREADSHEETS)
        packed = "an_archive" if data.startswith(_ARCHIVES) else "binary"
        raise _refused(path, "a_spreadsheet" if spreadsheet else packed)
    data = data.rstrip(b"\x1a")  # DOS's end of file
    if b"\r" in data:  # in none of the codings part of another character
        data = data.replace(b"\r\r\n", b"\n").replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    longest = len(_decoded(max(io.BytesIO(data), key=len).rstrip(b"\n")))
    if longest > LONGEST_LINE:
        line = phrase("motion.a_line_of", file=str(path))
        raise too_many(line, longest, "motion.characters", LONGEST_LINE)
    return _decoded(data)


def lines(text: str, start: int = 0) -> Iterator[tuple[int, str]]:
    """Yield the lines of a text from a place on: where each begins, and the line without its end."""
    while start < len(text):
        end = text.find("\n", start)
        line = text[start:] if end < 0 else text[start:end]
        yield start, line
        start += len(line) + 1


def _decoded(data: bytes) -> str:
    # UTF-8 refuses nearly every text of another coding; cp932 is Japan's; Latin-1 takes any byte.
    for coding in ("utf-8-sig", "cp932"):
        try:
            return data.decode(coding)
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1")


def check_end(text: str) -> None:
    """Raise `InputError` when the text ends within a number, as a download that broke off does.

    It does so when there is no line end after the last number and that number has fewer decimals than the
    last of each line before it, or where there are fewer than two such lines, than all numbers before it.
    """
    if text.endswith("\n"):
        return
    rows: list[list[int]] = []  # decimals of each number, the last line first
    for line in reversed(text[-4000:].split("\n")[-21:]):  # some twenty lines show the file's way of writing
        words = _WORDS.split(line.strip(" \t,;"))
        row = [len(m[1]) if (m := _DECIMALS.search(word)) else 0 for word in words]
        # Words end the block of numbers, and so does a line that ends in a whole number; the last line may
        # end in any beginning of a number.
        if _LETTER.search(line) or not (row[-1] if rows else _BEGUN.fullmatch(words[-1])):
            break
        rows.append(row)
    if not rows:
        return
    last = rows[0].pop()
    others = [row[-1] for row in rows[1:]] if len(rows) > 2 else [digits for row in rows for digits in row]
    if len(others) >= 2 and len(set(others)) == 1 and last < others[0]:
        tail = text[-100:].rsplit("\n", 1)[-1].strip()[-40:]
        raise InputError("motion.file_cut", tail=tail)


_DECIMAL = re.compile(r"[+\-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-]?[0-9]+)?")
_COMMA = re.compile(r"[+\-]?[0-9]*,[0-9]+(?:[eE][+\-]?[0-9]+)?")
_BATCH = 8192  # numbers of which a list is made at a time
_QUANTITY = re.compile(rf"({_DECIMAL.pattern}) ?([A-Za-z/²^]{{0,12}})\.?,?")


class Reader(NamedTuple):
    """A reader of one format.

    Attributes
    ----------
    name : str
        Name of the format; what a file of it holds is a paragraph of its module's docstring.
    recognise : callable
        Returns whether a text is of this format.
    read : callable
        Returns the channels of a text; ``unit`` and ``dt`` are the caller's, for files that do not state
        theirs.
    """

    name: str
    recognise: Callable[[str], object]
    read: Callable[[str, str | None, float | None], list[Channel]]


def numbers(tokens: Iterable[str], what: str) -> NDArray[np.float64]:
    """Return tokens as numbers, shape (n,).

    Parameters
    ----------
    tokens : iterable of str
        The numbers, blanks around them.
    what : str
        What they are: the key of their name in `stayput.catalogue.motion`.

    Raises
    ------
    InputError
        A token is not a finite decimal number.
    """
    values, rest = array("d"), iter(tokens)
    while batch := list(islice(rest, _BATCH)):
        plain = "".join(batch)
        # float() reads all tokens fast, but takes "nan", "1_000" and other scripts' digits too.
        try:
            read = np.array(list(map(float, batch)), dtype=np.float64)
        except ValueError:
            read = None
        if read is None or not np.isfinite(read).all() or "_" in plain or not plain.isascii():
            place, token = next(((i, t) for i, t in enumerate(batch) if not is_decimal(t)), (0, ""))
            raise InputError(
                "motion.decimal_comma" if _COMMA.fullmatch(token.strip()) else "motion.not_a_decimal",
                option="decimal_comma",
                index=len(values) + place + 1,
                what=phrase(f"motion.{what}"),
                value=excerpt(token.strip()),
            )
        values.frombytes(read.tobytes())
    return np.frombuffer(values, dtype=np.float64)


def is_decimal(token: str) -> bool:
    """Return whether a text is one finite decimal number."""
    return _DECIMAL.fullmatch(token.strip()) is not None and bool(np.isfinite(float(token)))


def words(text: str, start: int) -> Iterator[str]:
    """Yield the words of a text from a place on."""
    return (word for _, line in lines(text, start) for word in line.split())


def fields(some_lines: Iterable[str], width: int) -> Iterator[str]:
    """Yield the fields of lines that have a fixed width, and may touch."""
    trimmed = map(str.rstrip, some_lines)
    return (line[i : i + width] for line in trimmed for i in range(0, len(line), width))


def rows_of(
    text: str, start: int, columns: int, split: Callable[[str], list[str] | None], aside: int = 0
) -> NDArray[np.float64]:
    """Return the numbers in the lines of a text from a place on, shape (rows, columns).

    Parameters
    ----------
    text, start
        The text, and where its rows begin.
    columns : int
        How many numbers a row has.
    split : callable
        Returns the fields of a line, or None of one that is passed over.
    aside : int
        How many fields before the numbers are something else.

    Raises
    ------
    InputError
        A row has another number of values, or one that is not a finite decimal number.
    """

    def values() -> Iterator[str]:
        row = 0
        for _, line in lines(text, start):
            if (items := split(line)) is None:
                continue
            row += 1
            if len(items) != aside + columns:
                said = excerpt(line.rstrip(", \t"))
                raise InputError("motion.row_width", row=row, value=said, columns=aside + columns)
            yield from items[aside:]

    return numbers(values(), "the_samples").reshape(-1, columns)


def quantity(text: str, units: Sequence[str], what: str) -> float:
    """Return a header's value: one number and nothing else but a unit, or none.

    Parameters
    ----------
    text : str
        What the header says: "100Hz", ".0200 SEC,".
    units : sequence of str
        The units that may stand behind it, in capitals.
    what : str
        What it is: the key of its name in `stayput.catalogue.motion`.

    Raises
    ------
    InputError
        There is none, it is not one finite number, or has another unit.
    """
    if not text.strip():
        raise lacks(what)
    match = _QUANTITY.fullmatch(" ".join(text.split()))
    value = float(match[1]) if match and match[2].upper() in ("", *units) else math.nan
    if not math.isfinite(value) or (units == ("HZ",) and value <= 0.0):
        unit = f" [{units[0].capitalize()}]" if units else ""
        said = excerpt(text.strip())
        raise InputError("motion.not_one_number", what=phrase(f"motion.{what}"), value=said, unit=unit)
    return value


def lacks(what: str) -> InputError:
    """Return the refusal of a header without an entry; ``what`` is the key of its name."""
    return InputError("motion.no_header_entry", what=phrase(f"motion.{what}"))


def not_as_stated(what: str, stated: float, actual: float, unit: str = "") -> InputError:
    """Return the refusal of a file whose header states another value than its samples have."""
    return InputError(
        "motion.not_as_stated", what=phrase(f"motion.{what}"), stated=stated, found=actual, unit=unit
    )


def check_count(count: int, stated: float) -> None:
    """Raise `InputError` when there are not as many samples as the header states."""
    if count != stated:
        raise not_as_stated("number_of_samples", stated, count)


_FORMATS = {
    "USGS SMC": r"\s*[0-6] (?:(?:UN)?CORRECTED ACCELEROGRAM|VELOCITY|DISPLACEMENT|RESPONSE|FOURIER)",
    "RENADIC": r"[^#%/][^#%]*\bRENADIC\b",
    "GeoNet V1A/V2A": r"\s*(?:UN)?CORRECTED ACCELEROGRAM[^\n]* GNS\b",
    "CSMIP V1": r"\s*UNCORRECTED ACCELEROGRAM\b",
    "BRI .ac": r"\s*[0-9]{4}/[0-9]{2}/[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2} +[0-9]+ +[0-9]+ +[0-9]+ ",
    "HTML": r"\s*<(?:!doctype|html|\?xml)\b",
}
_HEAD = 2000  # characters at the beginning in which the format is looked for


def other_format(text: str) -> str | None:
    """Return the name of the format of a text that is known but not read, or None."""
    head = text[:_HEAD]
    return next((name for name, begin in _FORMATS.items() if re.match(begin, head, re.IGNORECASE)), None)
