"""The numbers in a file's lines, and whether there are as many as there must be."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from numpy.typing import NDArray

_DECIMAL = re.compile(r"[+\-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-]?[0-9]+)?")


def numbers(tokens: Sequence[str], what: str) -> NDArray[np.float64]:
    """Return the tokens as numbers, shape (n,).

    Raises
    ------
    InputError
        A token is not a finite decimal number.
    """
    plain = "".join(tokens)
    try:
        values = np.array(list(map(float, tokens)), dtype=np.float64)
    except ValueError:
        values = None
    if values is None or not np.isfinite(values).all() or "_" in plain or not plain.isascii():
        position, token = next(((i, t) for i, t in enumerate(tokens) if not _is_finite_decimal(t)), (0, ""))
        raise InputError(
            f"Value {position + 1} of {what} is {token.strip()!r}; it must be a finite decimal number."
        )
    return values


def _is_finite_decimal(token: str) -> bool:
    return _DECIMAL.fullmatch(token.strip()) is not None and bool(np.isfinite(float(token)))


def free_numbers(lines: Iterable[str], what: str) -> NDArray[np.float64]:
    """Return the numbers of lines in which blanks part them, shape (n,)."""
    return numbers(" ".join(lines).split(), what)


def fixed_numbers(lines: Sequence[str], width: int, what: str) -> NDArray[np.float64]:
    """Return the numbers of lines of fields of a fixed width, which may touch, shape (n,)."""
    trimmed = [line.rstrip() for line in lines]
    if max(map(len, trimmed), default=0) <= width:
        return numbers(trimmed, what)
    fields = [line[i : i + width] for line in trimmed for i in range(0, len(line), width)]
    return numbers(fields, what)


def number_after(pattern: str, text: str, what: str) -> float:
    """Return the number in the first group of a pattern, which the text must have.

    Raises
    ------
    InputError
        There is none, or it is not a finite number.
    """
    found = re.search(pattern, text, re.IGNORECASE | re.MULTILINE)
    if found is None:
        raise InputError(f"The header has no {what}; it must state it.")
    return float(numbers([found[1]], what)[0])


def check_count(found: int, stated: float, what: str) -> None:
    """Raise `InputError` when there are not as many numbers as the header states."""
    if found != stated:
        raise InputError(
            f"The header states {stated:.0f} {what} and the file has {found}; they must be as many."
        )


def check_rows(rows: Sequence[str], commas: int) -> None:
    """Raise `InputError` when a row has not one value more than the given number of commas."""
    found = [row.count(",") for row in rows]
    if any(count != commas for count in found):
        i = next(i for i, count in enumerate(found) if count != commas)
        raise InputError(f"Row {i + 1} is {rows[i][:60]!r}; it must have {commas + 1} values.")
