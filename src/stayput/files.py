"""Output paths and atomic writes, CSV that is safe in spreadsheets; optional libraries."""

from __future__ import annotations

import csv
import errno
import io
import os
import re
import secrets
import shutil
from collections.abc import Generator, Iterable, Sequence
from contextlib import contextmanager, suppress
from importlib import import_module
from os import PathLike
from pathlib import Path
from typing import Any, TextIO

from stayput.catalogue import phrase
from stayput.errors import InputError, absent, excerpt, instance_of, not_allowed, quoted, reason_of


def arrow(part: str = "") -> Any:
    """Return PyArrow, or a part of it such as "parquet"; it has no types for a checker.

    Raises
    ------
    InputError
        It is not installed.
    """
    try:
        return import_module(f"pyarrow.{part}" if part else "pyarrow")
    except ImportError:
        raise absent("An assessment", "PyArrow", "inventory") from None


CSV_ENCODING = "utf-8-sig"
"""Encoding of the CSV files that people open: by its byte order mark Excel tells that they are UTF-8."""

FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""How a text begins that a spreadsheet takes for a formula; East Asian ones take the wide signs as well."""


def harmless(cell: object) -> object:
    """Return a cell as it is written: nothing for None, a quote before a text that looks like a formula."""
    if cell is None:
        return ""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULA) else cell


def csv_text(names: Sequence[str], rows: Iterable[Iterable[object]], end: str = "\r\n") -> str:
    """Return a table as CSV, whose lines end in CR LF or in LF alone; see `harmless`.

    With LF alone `csv` leaves a lone carriage return without quotes, and it would end the row: it becomes
    a blank.
    """
    text = io.StringIO()
    lines = csv.writer(text, lineterminator=end)
    for row in (names, *rows):
        cells = map(harmless, row)
        lines.writerow(
            cell.replace("\r", " ") if isinstance(cell, str) and end == "\n" else cell for cell in cells
        )
    return text.getvalue()


LARGEST_LINE = 2**24
"""Characters of a line from which a text is no table [-]."""


def table_lines(file: TextIO, path: Path) -> Generator[str]:
    """Yield the lines of a table; `InputError` where one is so long that reading it would fill the memory."""
    while line := file.readline(LARGEST_LINE + 1):
        if len(line) > LARGEST_LINE:
            raise InputError("common.endless_line", file=repr(str(path)), most=LARGEST_LINE)
        yield line


_NEXT_PAIR = re.compile(r",(?=[^,=]*=)")
"""The comma before a pair; another one is in a table's name of a column."""


def named_columns(text: str, otherwise: str, field: str = "columns") -> list[tuple[str, str]]:
    """Return the names and the columns of a text such as "width=奥行,height=高さ[cm]".

    Parameters
    ----------
    text : str
        The text.
    otherwise : str
        Id of the sentence that refuses a part of it.
    field : str
        What the text is of.

    Raises
    ------
    InputError
        A part that has no name or no column.
    """
    pairs: list[tuple[str, str]] = []
    for part in _NEXT_PAIR.split(text):
        name, _, column = (side.strip() for side in part.partition("="))
        if not (name and column):
            raise InputError(otherwise, field, name=field, value=excerpt(part))
        pairs.append((name, column))
    return pairs


LARGEST_RECORD = 2**28
"""Largest file of a record [bytes]: twenty million samples of a dozen characters."""

PLOT_SUFFIXES = (".png", ".svg", ".pdf")
"""The kinds of file a plot is saved as."""

ANIMATION_SUFFIXES = (".gif", ".mp4", ".html")
"""The kinds of file an animation is written as."""


def check_target(path: str | Path, suffixes: Sequence[str]) -> Path:
    """Return where a file is to be written, or refuse it before any work is done.

    Parameters
    ----------
    path : str or Path
        The file to write.
    suffixes : sequence of str
        The endings that are allowed, with their dot.

    Raises
    ------
    InputError
        An unknown ending, a folder that does not exist or cannot be written to, a folder in the file's place,
        too long a name, or one with a null character.
    """
    instance_of("path", path, (str, PathLike))
    target = Path(path)
    if "\0" in str(target):
        raise not_allowed("model.file_to_write", quoted(str(target)), "model.null_in_name")
    if target.suffix.lower() not in suffixes:
        allowed = phrase("model.wrong_suffix", suffixes=", ".join(suffixes))
        raise not_allowed("model.file_to_write", target, allowed)
    try:
        if not target.parent.is_dir():
            raise not_allowed("model.file_to_write", target, "model.no_folder")
        if target.is_dir():
            raise not_allowed("model.file_to_write", target, "model.file_is_folder")
    except OSError as error:
        raise _not_written(target, error) from None
    check_writable(target)
    return target


def check_writable(target: Path) -> None:
    """Refuse a path where nothing can be made in the first folder above it that there is.

    Raises
    ------
    InputError
        It could not be written.
    """
    above = next(folder for folder in target.absolute().parents if folder.exists())
    if not os.access(above, os.W_OK):
        raise _not_written(target, PermissionError(errno.EACCES, os.strerror(errno.EACCES)))


def check_apart(outputs: Iterable[Path | None], inputs: Iterable[Path]) -> None:
    """Refuse to write a file in the place of one that is read, by whichever name or link.

    Parameters
    ----------
    outputs : iterable of Path or None
        The files to write; None where one is not asked for.
    inputs : iterable of Path
        What is read. What does not exist is passed over: its reader refuses it.

    Raises
    ------
    InputError
        One of them is both.
    """
    read = list(inputs)
    for target in outputs:
        for source in read:
            try:
                same = target is not None and target.samefile(source)
            except OSError:  # one of them does not exist
                continue
            if same:
                allowed = phrase("model.file_is_input", source=repr(str(source)))
                raise not_allowed("model.file_to_write", repr(str(target)), allowed)


@contextmanager
def draft(target: Path) -> Generator[Path]:
    """Give a temporary path beside ``target`` to write to; it takes the target's place at the end.

    When the writing fails or is interrupted the draft is removed and an older ``target`` stays as it was.

    Raises
    ------
    InputError
        The folder does not let a file be written.
    """
    # a part of the name alone: with all of it the draft's would be too long where the file's just is not
    path = target.with_name(f".{target.stem[:_DRAFTED]}-{secrets.token_hex(4)}{target.suffix}")
    try:
        yield path
        path.replace(target)
    except OSError as error:
        raise _not_written(target, error) from error
    finally:
        with suppress(OSError):  # a name that no file can have
            path.unlink(missing_ok=True)


def _not_written(target: Path, error: OSError) -> InputError:
    return InputError("common.not_written", path=target, reason=reason_of(error))


@contextmanager
def folder_draft(folder: Path) -> Generator[Path]:
    """Give a temporary folder within ``folder``; at the end all files in it take their places.

    When the writing fails or is interrupted no file takes its place, and folders that were made are removed.

    Raises
    ------
    InputError
        The folder cannot be made, or does not let its files be written.
    """
    fresh: list[Path] = []
    path = folder / f".draft-{secrets.token_hex(4)}"
    try:
        fresh += [path for path in (folder, *folder.parents) if not path.exists()]
        path.mkdir(parents=True)
        yield path
        for file in sorted(path.rglob("*")):
            target = folder / file.relative_to(path)
            if file.is_dir():
                target.mkdir(exist_ok=True)
            else:
                file.replace(target)
    except OSError as error:
        raise _not_written(folder, error) from error
    except InputError as error:
        raise error.renamed(f"{path}{os.sep}", f"{folder}{os.sep}") from None
    finally:
        shutil.rmtree(path, ignore_errors=True)
        with suppress(OSError):  # the first that is not empty
            for made in fresh:
                made.rmdir()


_DRAFTED = 40
"""Most letters of a file's name in that of its draft."""

_LONGEST = 100
"""Most bytes of a name that becomes part of a file's name: file systems allow 255, drafts and endings too."""


def name_part(name: str, otherwise: str) -> str:
    """Return a name as part of a file's name: letters of any script, digits, dots and hyphens.

    What stands before it must tell the file from others and from a system's reserved names: a number.

    Parameters
    ----------
    name : str
        The name.
    otherwise : str
        What is taken where nothing of it is left.
    """
    plain = re.sub(r"[^\w.]+", "-", name)
    short = plain.encode(errors="ignore")[:_LONGEST].decode(errors="ignore")
    return short.strip("-.") or otherwise


def check_animation(path: str | Path) -> Path:
    """Return where an animation is to be written, or refuse it before any work is done.

    Raises
    ------
    InputError
        As `check_target`, and no ffmpeg for an MP4.
    """
    target = check_target(path, ANIMATION_SUFFIXES)
    if target.suffix.lower() == ".mp4" and shutil.which("ffmpeg") is None:
        raise not_allowed("model.file_to_write", target, "model.without_ffmpeg")
    return target
