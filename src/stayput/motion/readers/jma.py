"""JMA CSV: seven header lines, then NS, EW, UD in gal.

Source: Japan Meteorological Agency, strong-motion data of major earthquakes,
https://www.data.jma.go.jp/eqev/data/kyoshin/jishin/. Coded in cp932 or UTF-8; times are JST.
"""

from __future__ import annotations

import re
from itertools import islice
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import Numbers, quantity
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.readers.text import chunks, lines

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FORMAT = "JMA CSV"

_SITE = re.compile(r"\s*SITE +CODE", re.IGNORECASE)
_SAMPLING = re.compile("SAMPLING", re.IGNORECASE)
_RATE = re.compile(r"SAMPLING +(?:RATE|FREQ)", re.IGNORECASE)
_START = re.compile("INITIAL TIME", re.IGNORECASE)
_UNIT = re.compile("UNIT$", re.IGNORECASE)
_DIRECTIONS = {"NS", "EW", "UD"}
_HEADER_LINES = 12


def recognise(text: str) -> bool:
    """Return whether the file begins with its site code and states a sampling rate."""
    return _SITE.match(text) is not None and _SAMPLING.search(text, 0, 2000) is not None


def _header(text: str) -> tuple[list[str], list[str], int]:
    """Return the lines above the component names, the names, and where the rows begin."""
    header: list[str] = []
    for start, line in islice(lines(text), _HEADER_LINES):
        names = [name.strip().upper() for name in line.rstrip(", \t").split(",")]
        if len(names) > 1 and all(len(name) == 2 and name.isalpha() for name in names):
            return header, names, start + len(line) + 1
        header.append(line)
    raise InputError("motion.jma_no_names")


def _entry(header: list[str], key: re.Pattern[str]) -> str | None:
    """Return what stands behind "=" in the header line of a key."""
    for line in header:
        name, equals, value = line.partition("=")
        if equals and key.match(name.strip()):
            return value.strip(" ,\t")
    return None


def _rows(text: str, start: int, columns: int) -> NDArray[np.float64]:
    """Return the comma-separated rows from a place of a text on, shape (rows, columns).

    Raises
    ------
    InputError
        A row has another number of values, or one that is not a finite decimal number.
    """
    samples = Numbers("the_samples")
    empty = 0  # lines without a value may stand only at the end of the file
    for chunk in chunks(text, start):
        tokens: list[str] = []
        for line in chunk.removesuffix("\n").split("\n"):
            row = line.rstrip(", \t")
            if not row:
                empty += 1
                continue
            values = row.split(",")
            if empty or len(values) != columns:
                number = (len(samples) + len(tokens)) // columns + 1
                shown = excerpt("" if empty else row)
                raise InputError("motion.row_width", row=number, value=shown, columns=columns)
            tokens += values
        samples.add(tokens)
    return samples.array().reshape(-1, columns)


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        No sampling rate, unit or line of names; a row with too few or too many values.
    """
    header, labels, start = _header(text)
    stated_rate = _entry(header, _RATE)
    if not stated_rate:
        raise InputError("motion.no_header_entry", what=phrase("motion.sampling_rate"))
    rate = quantity(stated_rate, ("HZ",), "sampling_rate")
    if not rate > 0.0:
        raise InputError("motion.jma_rate", rate=rate)
    stated = _entry(header, _UNIT)
    factor = acceleration_unit(stated or None, unit)
    if len(set(labels)) < len(labels):
        raise InputError("motion.jma_names_repeated", names=", ".join(labels))
    if unknown := [label for label in labels if label not in _DIRECTIONS]:
        raise InputError("motion.jma_unknown_name", name=unknown[0])
    samples = factor * _rows(text, start, len(labels))
    site = header[0].partition("=")[2].split(",")[0].strip() if header else ""
    step = time_step(1.0 / rate, dt)
    origin = f"{site}, {_entry(header, _START) or ''}"
    return [
        Channel(name, samples[:, i], step, site, location=site, origin=origin)
        for i, name in enumerate(labels)
    ]
