"""``-`` where a file is meant: standard input for what is read, standard output for what is written."""

from __future__ import annotations

import os
import sys
from collections.abc import Generator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from contextvars import ContextVar
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, BinaryIO, TextIO

import typer

from stayput.catalogue import phrase
from stayput.errors import InputError, reason_of
from stayput.files import check_target, draft
from stayput.progress import language_of_bars

STREAM = "-"
"""What is typed in the place of a file's name."""

NAME = "standard input"
"""What standard input is called, as files are by their names."""

MOST_INPUT = 2**30
"""Most bytes of a table or a map on standard input."""

_CHUNK = 2**20


class _Taken:
    """Who reads standard input, and the temporary file that holds it.

    Attributes
    ----------
    by : str
        The flag or argument; "" where it is not read.
    folder : str
        Where the file is; "" where there is none.
    stack : ExitStack
        Removes the folder.
    """

    def __init__(self, stack: ExitStack) -> None:
        self.by, self.folder, self.stack = "", "", stack


_taken: ContextVar[_Taken] = ContextVar("taken")


@contextmanager
def standard_input() -> Generator[None]:
    """Let a command read standard input; what was kept of it is removed at the end, and in no refusal."""
    with ExitStack() as stack:
        taken = _Taken(stack)
        before = _taken.set(taken)
        try:
            yield
        except InputError as error:
            if not taken.by:
                raise
            from stayput.report.names import given_name

            plain = error.renamed(f"{taken.folder}{os.sep}", "") if taken.folder else error
            raise plain.renamed(NAME, given_name(NAME, language_of_bars())) from None
        finally:
            _taken.reset(before)


def is_stream(path: str | Path | None) -> bool:
    """Return whether ``-`` stands for a file."""
    return str(path) == STREAM


def called(path: Path) -> str:
    """Return what a file that is read is called in sentences."""
    return NAME if is_stream(path) else path.name


def table_of_input(flag: str) -> dict[str, Any]:
    """Return the keys and values of a TOML file that comes on standard input.

    Parameters
    ----------
    flag : str
        The flag or argument that is ``-``.

    Raises
    ------
    InputError
        Another one has read it, it cannot be read, or is no such file.
    """
    from stayput.scenario.toml import LARGEST_FILE, table_of_bytes

    with _reading(flag) as source:
        data = source.read(LARGEST_FILE + 1)
    return table_of_bytes(data, Path(NAME))


def file_of(text: str, flag: str, ending: str = "", most: int = MOST_INPUT) -> str:
    """Return the file that a flag names: of ``-`` one that holds what comes on standard input.

    Parameters
    ----------
    text : str
        The flag's text.
    flag : str
        The flag or argument.
    ending : str
        What the name of that file ends in.
    most : int, optional
        Most bytes that are read, as some input never ends.

    Raises
    ------
    InputError
        Another flag or argument has read standard input, it cannot be read, or does not end.
    """
    if not is_stream(text):
        return text
    with _reading(flag) as source:
        taken = _taken.get()
        taken.folder = taken.stack.enter_context(TemporaryDirectory(prefix="stayput-"))
        file = Path(taken.folder) / f"{NAME}{ending}"
        with file.open("wb") as kept:
            while (chunk := source.read(_CHUNK)) and kept.tell() <= most:
                kept.write(chunk)
    if chunk:
        raise InputError("cli.input_too_large", flag, flag=flag, most=most)
    return str(file)


@contextmanager
def _reading(flag: str) -> Generator[BinaryIO]:
    taken = _taken.get()
    if taken.by:
        raise InputError("cli.same_file", flag, flag=flag, other=taken.by, value=STREAM)
    taken.by = flag
    source: TextIO | None = sys.stdin
    file = phrase("cli.standard_input", flag=flag)
    if source is None:
        raise InputError("common.unreadable", flag, file=file, reason=phrase("cli.closed"))
    try:
        yield source.buffer
    except OSError as error:
        raise InputError("common.unreadable", flag, file=file, reason=reason_of(error)) from None


def closed_output() -> TextIO:
    """Return what takes the place of a closed standard output: the system refuses what is written to it."""
    return os.fdopen(os.open(os.devnull, os.O_RDONLY), "w", encoding="utf-8")


def check_output(path: Path | None, suffixes: Sequence[str], *, stream: bool = True) -> None:
    """Refuse a file that cannot be written before any work is done; ``-`` can, where it may be a stream.

    Raises
    ------
    InputError
        As `stayput.files.check_target`.
    """
    if path is not None and not (stream and is_stream(path)):
        check_target(path, suffixes)


def to_output(outputs: Mapping[str, Path | None], json: bool = False) -> bool:
    """Return whether one of several outputs goes to standard output, in the place of what is printed.

    Parameters
    ----------
    outputs : mapping
        What is written, by its flag.
    json : bool
        Whether ``--json`` is given, which goes there too.

    Raises
    ------
    InputError
        More than one of them goes there.
    """
    there = [flag for flag, path in outputs.items() if is_stream(path)]
    there += ["--json"] if json and there else []
    if len(there) > 1:
        value = phrase("cli.standard_output")
        raise InputError("cli.same_file", there[0], flag=there[0], other=there[1], value=value)
    return bool(there)


def write_text(path: Path, text: str, encoding: str = "utf-8") -> None:
    """Write a text to a file in an encoding, whole or not at all; or to standard output as it is.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    if is_stream(path):
        typer.echo(text, nl=False)
        return
    with draft(path) as unfinished:
        unfinished.write_text(text, encoding=encoding)
