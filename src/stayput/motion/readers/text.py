"""The text of a file: what every reader starts from."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from stayput.errors import InputError

if TYPE_CHECKING:
    import os

LARGEST_FILE = 512 * 1024 * 1024
"""Largest file that is read [bytes]."""

LONGEST_LINE = 10_000
"""Longest line that is read; the formats' own end below 500 characters."""

_CONTROLS = bytes(set(range(32)) - set(b"\t\n\v\f\r\x1a")) + b"\x7f"
_DECIMALS = re.compile(r"\.([0-9]+(?:[eE][+\-]?[0-9]+)?)[ \t,;]*$")


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
            raise InputError(f"The motion file {str(path)!r} is a directory; it must be a file.")
        size = file.stat().st_size
        if not file.is_file():
            raise InputError(f"The motion file {str(path)!r} is a device or a pipe; it must be a file.")
        if size > LARGEST_FILE:
            raise InputError(
                f"The motion file {str(path)!r} has {size} bytes; at most {LARGEST_FILE} are read."
            )
        data = file.read_bytes()
    except FileNotFoundError:
        raise InputError(
            f"The motion file {str(path)!r} does not exist; it must be a readable file."
        ) from None
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise InputError(
            f"The motion file {str(path)!r} cannot be read ({reason}); it must be readable."
        ) from None
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"The motion file is {path!r}; it must be the path of a file.") from None
    if not data.strip():
        raise InputError(f"The motion file {str(path)!r} is empty; it must hold a record.")
    if len(data.translate(None, _CONTROLS)) < len(data):
        raise InputError(
            f"The motion file {str(path)!r} is binary; it must be text "
            f"(read other formats with ObsPy and use Motion.from_obspy)."
        )
    text = _decoded(data).rstrip("\x1a")  # DOS's end of file
    text = text.replace("\r\r\n", "\n").replace("\r\n", "\n").replace("\r", "\n")
    longest = max(map(len, text.split("\n")))
    if longest > LONGEST_LINE:
        raise InputError(
            f"The motion file {str(path)!r} has a line of {longest} characters; {LONGEST_LINE} are allowed."
        )
    return text


def _decoded(data: bytes) -> str:
    for coding in ("utf-8-sig", "cp932"):
        try:
            return data.decode(coding)
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1")


def check_end(text: str) -> None:
    """Raise `InputError` when the text ends within a number.

    It does so when there is no line end after the last number and that has fewer decimals than the last
    number of every line before it, which all have as many.
    """
    if text.endswith("\n"):
        return
    *before, last = ((m := _DECIMALS.search(line)) and len(m[1]) for line in text[-4000:].split("\n")[-21:])
    if len(before) >= 2 and len(set(before)) == 1 and before[0] and (last or 0) < before[0]:
        tail = text.rsplit("\n", 1)[-1].strip()[-40:]
        raise InputError(f"The file ends within a number, with {tail!r}; it must be complete.")
