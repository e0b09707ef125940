"""CSMIP/CGS V2: for each channel a text, an integer and a real header, then three blocks of samples.

Source: California Strong Motion Instrumentation Program, https://www.strongmotioncenter.org. The
acceleration follows a line "3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC. (UNITS: ...)" in fields
of fixed width, 8F10.3 unless the line says otherwise; fields can touch.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import check_count, fixed_numbers, numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FORMAT = "CSMIP V2"

_BLOCK = re.compile(
    r"^ *([0-9]{1,9}) +POINTS OF ACCEL DATA EQUALLY SPACED AT +([0-9.]{1,12}) +SEC\b(.*)$",
    re.IGNORECASE | re.MULTILINE,
)
_UNIT = re.compile(r"(?:UNITS: *|\bIN )(CM/SEC/SEC|CM/SEC\^?2|CM/S\^?2|GAL|G)\b", re.IGNORECASE)
_FIELDS = re.compile(r"\(([0-9]{1,3})[FEG]([0-9]{1,2})\.[0-9]{1,2}\)", re.IGNORECASE)
_CHANNEL = re.compile(r"\bCHAN +([0-9]{1,3}): *([^\n]*?)(?: {2,}| +FROM\b|$)", re.IGNORECASE | re.MULTILINE)
_PEAK = re.compile(r"PEAK +ACCELERATION *= *([0-9.+\-]{1,12}) +([A-Z/0-9^]{1,12})", re.IGNORECASE)


def recognise(text: str) -> bool:
    """Return whether a line announces points of equally spaced acceleration data."""
    return "POINTS OF ACCEL DATA" in text.upper() and _BLOCK.search(text) is not None


def block_samples(body: str, count: int, per_line: int, width: int) -> NDArray[np.float64]:
    """Return a block's samples, shape (count,), from the text that begins with it.

    Raises
    ------
    InputError
        The block is shorter or longer than the header states, or a field is not a number.
    """
    rows = -(-count // per_line)
    lines = body.split("\n", rows + 1)
    samples = fixed_numbers(lines[:rows], width, "the samples")
    check_count(len(samples), count, "samples")
    following = lines[rows].strip() if len(lines) > rows else ""
    if following and not re.search(r"[A-DF-Z/]", following, re.IGNORECASE):
        raise InputError(
            f"More numbers follow the {count} samples that the header states; they must be as many."
        )
    return samples


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        A block has no unit or not as many samples as stated.
    """
    channels: list[Channel] = []
    before = 0
    for block in _BLOCK.finditer(text):
        header = text[before : block.start()].rsplit("POINTS OF DISPL DATA", 1)[-1]
        before = block.end()
        count, step = numbers([block[1], block[2]], "the line before the samples")
        stated = _UNIT.search(block[3])
        factor = acceleration_unit(stated[1] if stated else None, unit)
        fields = _FIELDS.search(block[3])
        per_line, width = (int(fields[1]), int(fields[2])) if fields else (8, 10)
        if not (count >= 1 and per_line >= 1 and width >= 1):
            raise InputError(f"The line {block[0].strip()!r} announces no samples; it must announce some.")
        samples = block_samples(text[block.end() + 1 :], int(count), per_line, width)
        channel, peak = _CHANNEL.search(header), _PEAK.search(header)
        stated_peak = (
            float(numbers([peak[1]], "the peak")[0]) * acceleration_unit(peak[2], None) if peak else None
        )
        titles = [line.strip() for line in header.strip("\n").split("\n")]
        start = next((i for i, line in enumerate(titles) if line.upper().startswith("CORRECTED")), None)
        name = (
            f"{titles[start + 6]}, {titles[start + 2]}"
            if start is not None and len(titles) > start + 6
            else ""
        )
        label = channel[2].strip() if channel else ""
        channels.append(Channel(label, factor * samples, time_step(float(step), dt), name, stated_peak))
    if text.rfind("\n/&") < before:
        raise InputError("The last channel has no end-of-data line /&; the file must be complete.")
    return channels
