"""The text of a file: what every reader starts from."""

from __future__ import annotations

import codecs
import io
import re
from pathlib import Path
from typing import TYPE_CHECKING

from stayput.errors import InputError, reason_of
from stayput.files import LARGEST_RECORD
from stayput.motion.readers.others import kind_of_binary

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator

LONGEST_LINE = 10_000
"""Longest line that is read; the formats' own end below 500 characters."""

_CHUNK = 1 << 16  # characters of a text of which lists are made at a time

_CONTROLS = bytes(set(range(32)) - set(b"\t\n\v\f\r\x1a")) + b"\x7f"  # in no text file
_DECIMALS = re.compile(r"\.([0-9]+(?:[eE][+\-]?[0-9]+)?)$")
_BEGUN = re.compile(r"[+\-]?[0-9]*\.?[0-9]*(?:[eE][+\-]?[0-9]*)?")
_LETTER = re.compile(r"[A-DF-Za-df-z]")  # any but the e of an exponent
_WORDS = re.compile(r"[ \t,;]+")


def file_text(path: str | os.PathLike[str]) -> str:
    r"""Return a file's text with "\n" line ends, whatever they were and whichever of its codings it has.

    Raises
    ------
    InputError
        The file is missing, unreadable, a directory, empty, too large or not text.
    """
    try:
        file = Path(path)
        if file.is_dir():
            raise InputError("motion.file_is_folder", path=str(path))
        size = file.stat().st_size
        if not file.is_file():
            raise InputError("motion.file_is_device", path=str(path))
        if size > LARGEST_RECORD:
            raise InputError("motion.file_too_large", path=str(path), size=size, most=LARGEST_RECORD)
        data = file.read_bytes()
    except FileNotFoundError:
        raise InputError("motion.file_missing", path=str(path)) from None
    except OSError as error:
        reason = reason_of(error)
        raise InputError("motion.file_unreadable", path=str(path), reason=reason) from None
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("motion.file_no_path", path=path) from None
    if not data.strip():
        raise InputError("motion.file_empty", path=str(path))
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        data = data.decode("utf-16", "replace").encode()
    if len(data.translate(None, _CONTROLS)) < len(data):
        raise InputError(f"motion.file_{kind_of_binary(data)}", path=str(path))
    data = data.rstrip(b"\x1a")  # DOS's end of file
    if b"\r" in data:  # in none of the codings part of another character
        data = data.replace(b"\r\r\n", b"\n").replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    longest = len(_decoded(max(io.BytesIO(data), key=len).rstrip(b"\n")))
    if longest > LONGEST_LINE:
        raise InputError("motion.file_long_line", path=str(path), length=longest, most=LONGEST_LINE)
    return _decoded(data)


def chunks(text: str, start: int = 0) -> Iterator[str]:
    """Yield a text from a place on in chunks of whole lines, as a list of all its words would be large."""
    while start < len(text):
        line_end = text.find("\n", start + _CHUNK)
        stop = len(text) if line_end < 0 else line_end + 1
        yield text[start:stop]
        start = stop


def lines(text: str) -> Iterator[tuple[int, str]]:
    """Yield the lines of a text: where each begins, and the line without its end."""
    start = 0
    for chunk in chunks(text, start):
        for line in chunk.removesuffix("\n").split("\n"):
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
