"""The numbers in a file's lines, and whether there are as many as there must be.

Numbers go to arrays chunk by chunk: a list of all words of a file would take some forty times its size.
"""

from __future__ import annotations

import re
from array import array
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt
from stayput.motion.readers.text import chunks

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

_DECIMAL = re.compile(r"[+\-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-]?[0-9]+)?")
_COMMA = re.compile(r"[+\-]?[0-9]*,[0-9]+(?:[eE][+\-]?[0-9]+)?")
_BUFFERED = 8192  # fields of which a list is made at a time
_QUANTITY = re.compile(rf"({_DECIMAL.pattern}) ?([A-Za-z/²^]{{0,12}})\.?,?")


class Numbers:
    """An array of numbers that grows with what is read.

    Parameters
    ----------
    what : str
        What the numbers are: the key of their name in `stayput.catalogue.motion`.
    """

    def __init__(self, what: str) -> None:
        self._what = what
        self._values = array("d")

    def __len__(self) -> int:
        return len(self._values)

    def add(self, tokens: Sequence[str]) -> None:
        """Read tokens as numbers.

        Raises
        ------
        InputError
            A token is not a finite decimal number.
        """
        plain = "".join(tokens)
        # float() reads all tokens fast, but takes "nan", "1_000" and other scripts' digits too.
        try:
            values = np.array(list(map(float, tokens)), dtype=np.float64)
        except ValueError:
            values = None
        if values is None or not np.isfinite(values).all() or "_" in plain or not plain.isascii():
            position, token = next(
                ((i, t) for i, t in enumerate(tokens) if not _is_finite_decimal(t)), (0, "")
            )
            comma = _COMMA.fullmatch(token.strip()) is not None
            raise InputError(
                "motion.decimal_comma" if comma else "motion.not_a_decimal",
                option="decimal_comma",
                index=len(self) + position + 1,
                what=phrase(f"motion.{self._what}"),
                value=excerpt(token.strip()),
            )
        self._values.frombytes(values.tobytes())

    def array(self) -> NDArray[np.float64]:
        """Return the numbers, shape (n,); none can be added afterwards."""
        return np.frombuffer(self._values, dtype=np.float64)


def numbers(tokens: Sequence[str], what: str) -> NDArray[np.float64]:
    """Return the tokens as numbers, shape (n,).

    Raises
    ------
    InputError
        A token is not a finite decimal number.
    """
    values = Numbers(what)
    values.add(tokens)
    return values.array()


def _is_finite_decimal(token: str) -> bool:
    return _DECIMAL.fullmatch(token.strip()) is not None and bool(np.isfinite(float(token)))


def free_numbers(text: str, start: int, what: str) -> NDArray[np.float64]:
    """Return the blank-separated numbers of a text from a place on, shape (n,)."""
    values = Numbers(what)
    for chunk in chunks(text, start):
        values.add(chunk.split())
    return values.array()


class FixedBlock:
    """A block of numbers in fields of a fixed width, which may touch.

    Parameters
    ----------
    what : str
        What the numbers are: the key of their name in `stayput.catalogue.motion`.
    width : int
        Characters of a field.
    """

    def __init__(self, what: str, width: int = 10) -> None:
        self.width = width
        self._numbers = Numbers(what)
        self._buffer: list[str] = []

    def add(self, line: str) -> None:
        """Read a line.

        Raises
        ------
        InputError
            A field is not a finite decimal number.
        """
        trimmed = line.rstrip()
        # The last line of a block may hold one number that is not padded to the width.
        if 0 < len(trimmed) <= self.width:
            self._buffer.append(trimmed)
        else:
            self._buffer += [trimmed[i : i + self.width] for i in range(0, len(trimmed), self.width)]
        if len(self._buffer) > _BUFFERED:
            self._flush()

    def _flush(self) -> None:
        self._numbers.add(self._buffer)
        self._buffer.clear()

    def array(self) -> NDArray[np.float64]:
        """Return the numbers, shape (n,); none can be added afterwards."""
        self._flush()
        return self._numbers.array()


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
        It is not one finite number, or has another unit.
    """
    match = _QUANTITY.fullmatch(" ".join(text.split()))
    if match is None or match[2].upper() not in ("", *units) or not np.isfinite(float(match[1])):
        name, value = phrase(f"motion.{what}"), excerpt(text.strip())
        if not units:
            raise InputError("motion.not_one_number", what=name, value=value)
        unit = units[0].capitalize()
        raise InputError("motion.not_one_number_with_unit", what=name, value=value, unit=unit)
    return float(match[1])


def check_count(count: int, stated: float) -> None:
    """Raise `InputError` when there are not as many samples as the header states."""
    if count != stated:
        raise InputError("motion.sample_count", stated=stated, count=count)
