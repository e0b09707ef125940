"""TOML of a scenario file to a table, with bounds on what a parser would otherwise take memory and depth for.

`with_value` changes a table by its keys as refusals write them.

A dotted key of n parts takes memory that grows with n², nested brackets take the parser's own stack, and a
whole number of any length is a whole number: a scenario needs none of the three.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

from stayput.catalogue import phrase
from stayput.errors import InputError, reason_of

LARGEST_FILE = 1024 * 1024
"""Largest scenario file [bytes]."""

MOST_EXTRA_PARTS = 300
"""Most parts of a file's dotted keys beyond two each."""

DEEPEST = 16
"""Deepest nesting of brackets and braces."""

_LITERAL = re.compile(  # strings and comments, up to their end where they are closed, or the file's or line's
    r'"""(?:[^"\\]|\\[\s\S]?|"(?!""))*+"{0,5}'
    r"|'''(?:[^']|'(?!''))*+'{0,5}"
    r'|"(?:[^"\\\n]|\\[^\n]?)*+"?'
    r"|'[^'\n]*+'?"
    r"|#[^\n]*+"
)
_BRACKET = re.compile(r"[\[\]{}]")
_BETWEEN_KEYS = re.compile(r"[=,{}\[\]\n]")

_KEY = re.compile(r"[^.\[\]=\s]+(?:\[\d{1,4}\])*(?:\.[^.\[\]=\s]+(?:\[\d{1,4}\])*)*", re.ASCII)
_STEP = re.compile(r"\[(\d+)\]|([^.\[\]]+)", re.ASCII)


def read_toml(file: Path) -> dict[str, object]:
    """Return the keys and values of a TOML file.

    Parameters
    ----------
    file : Path
        The file, UTF-8.

    Raises
    ------
    InputError
        It cannot be read, is too large, is not TOML, or has keys, brackets or numbers beyond the bounds.
    """
    try:
        with file.open("rb") as opened:
            data = opened.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the path
        raise _refused(file, "not_read", reason=reason_of(error)) from None
    return table_of_bytes(data, file)


def table_of_bytes(data: bytes, file: Path) -> dict[str, Any]:
    """Return the keys and values of a TOML file's bytes, UTF-8.

    Parameters
    ----------
    data : bytes
        The bytes; of a file beyond the bound its beginning is enough.
    file : Path
        What a refusal calls the file.

    Raises
    ------
    InputError
        As `read_toml`.
    """
    if len(data) > LARGEST_FILE:
        raise _refused(file, "too_long", most=LARGEST_FILE)
    try:
        return table_of_toml(data.decode("utf-8-sig"), file)
    except UnicodeDecodeError:
        raise _refused(file, "not_utf8") from None


def table_of_toml(text: str, file: Path) -> dict[str, Any]:
    """Return the keys and values of a TOML file's text.

    Parameters
    ----------
    text : str
        The text.
    file : Path
        What a refusal calls the file.

    Raises
    ------
    InputError
        It is not TOML, or has keys, brackets or numbers beyond the bounds.
    """
    _refuse_excess(file, text)
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _refused(file, "not_toml", reason=error) from None
    except (ValueError, RecursionError):  # of int(), which reads at most 4300 digits
        raise _refused(file, "long_number") from None
    if any(not -(2**63) <= number < 2**63 for number in _whole_numbers(table)):
        raise _refused(file, "long_number")
    return table


def _refused(file: Path, why: str, **values: object) -> InputError:
    reason = phrase(f"scenario.file_{why}", **values)
    return InputError("scenario.file", file=repr(str(file)), reason=reason)


def _refuse_excess(file: Path, text: str) -> None:
    """Refuse what goes beyond the bounds; the text is not yet known to be TOML."""
    bare = _LITERAL.sub(lambda match: "" if match[0].startswith("#") else "s", text)
    depth = 0
    for bracket in _BRACKET.finditer(bare):
        depth = depth + 1 if bracket[0] in "[{" else max(0, depth - 1)
        if depth > DEEPEST:
            raise _refused(file, "too_deep", most=DEEPEST)
    dots = (part.count(".") for part in _BETWEEN_KEYS.split(bare))
    extra = sum(count - 1 for count in dots if count > 1)
    if extra > MOST_EXTRA_PARTS:
        raise _refused(file, "long_keys", count=extra, most=MOST_EXTRA_PARTS)


def _whole_numbers(value: object) -> Iterator[int]:
    if isinstance(value, int):
        yield value
    elif isinstance(value, dict):
        for item in cast("dict[str, Any]", value).values():
            yield from _whole_numbers(item)
    elif isinstance(value, list):
        for item in cast("list[Any]", value):
            yield from _whole_numbers(item)


def steps_of(key: str) -> tuple[str | int, ...]:
    """Return the names and places of a key such as ``furniture[1].mass``; none of another text."""
    steps = _STEP.findall(key) if _KEY.fullmatch(key) else []
    return tuple(int(place) if place else name for place, name in steps)


def with_value(tables: dict[str, Any], key: str, value: object) -> dict[str, Any]:
    """Return tables with another value at a key; they themselves stay as they are.

    Parameters
    ----------
    tables : dict
        Keys and values of a file.
    key : str
        A dotted key. Below a list it is that of all its items, or of the one whose place is in brackets; the
        place behind the last adds one.
    value : object
        The value.

    Raises
    ------
    InputError
        No such key: a place of what is no list, or beyond its end.
    """

    def placed(node: Any, steps: tuple[str | int, ...]) -> Any:
        if not steps:
            return value
        step, below = steps[0], steps[1:]
        if isinstance(step, int):
            items = cast("list[Any]", node or [])
            if not isinstance(node, list | None) or step > len(items):
                raise InputError("scenario.no_such_path", key, path=key)
            item = items[step] if step < len(items) else None
            return [*items[:step], placed(item, below), *items[step + 1 :]]
        if isinstance(node, list):
            return [placed(item, steps) for item in cast("list[Any]", node)]
        table = cast("dict[str, Any]", node if isinstance(node, dict) else {})
        return {**table, step: placed(table.get(step), below)}

    steps = steps_of(key)
    if not steps:
        raise InputError("scenario.no_such_path", key, path=key)
    return placed(tables, steps)
