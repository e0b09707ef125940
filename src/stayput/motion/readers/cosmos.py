"""COSMOS V1.20: for each channel 13 text lines, an integer and a real header, comments, and the samples.

Source: COSMOS strong-motion data format 1.20 (2001), https://www.strongmotion.org. Of the real header,
value 62 is the interval [ms] and 64 the peak, in the samples' unit.
"""

from __future__ import annotations

import re

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.csmip import block_samples
from stayput.motion.readers.fields import fixed_numbers, number_after
from stayput.motion.readers.stated import acceleration_unit, time_step

FORMAT = "COSMOS V1.20"

_FIRST = re.compile(r"[^\n]{0,80}\(Format +v0?1\.[0-9]{1,2} +with +[0-9]{1,2} +text +lines", re.IGNORECASE)
_BLOCK = re.compile(
    r"^ *([0-9]{1,9}) +(acceleration|velocity|displacement|[a-z ]{1,30}?) +(?:pts|points)\b[^\n]*?units *= *"
    r"([^,(\n]{1,20})[^\n]*?Format *= *\( *([0-9]{0,3})[FEIG]([0-9]{1,2})",
    re.IGNORECASE | re.MULTILINE,
)
_REAL = re.compile(
    r"^ *([0-9]{1,4}) +Real-header values follow on +([0-9]{1,3}) +lines"
    r"[^\n]*Format *= *\( *[0-9]{1,3}[FEG]([0-9]{1,2})",
    re.IGNORECASE | re.MULTILINE,
)
_LABEL = re.compile(
    r"Chan[^:\n]{0,12}: *([0-9]{1,3}(?= *Deg)|Up|Down|Vert|[NEZVH][A-Z0-9\-]{0,3}\b)", re.IGNORECASE
)
_END = re.compile(r"^End-of-data for Chan *([^\s]{1,8}) acceleration", re.IGNORECASE | re.MULTILINE)
_UNKNOWN = -999.0


def recognise(text: str) -> bool:
    """Return whether the first line states the format and its text lines."""
    return _FIRST.match(text) is not None


def _real_header(header: str) -> list[float]:
    found = _REAL.search(header)
    if found is None:
        raise InputError("The header has no real-header block; it must have one.")
    lines = header[found.end() :].split("\n")[1 : int(found[2]) + 1]
    values = fixed_numbers(lines, max(1, int(found[3])), "the real header").tolist()
    if len(values) != int(found[1]) or len(values) < 64:
        raise InputError(
            f"The real header has {len(values)} values; it must have the {found[1]} it states, 64 or more."
        )
    unknown = re.search(r"unknown/unspecified: *(-?[0-9]+)", header, re.IGNORECASE)
    blank = float(unknown[1]) if unknown else _UNKNOWN
    return [float("nan") if value == blank else value for value in values]


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        There is no acceleration, a header block is damaged, or there are not as many samples as stated.
    """
    channels: list[Channel] = []
    before = 0
    while block := _BLOCK.search(text, before):
        header, before = text[before : block.start()], block.end()
        if block[2].strip().lower() != "acceleration":
            continue
        factor = acceleration_unit(block[3], unit)
        values = _real_header(header)
        interval, peak = values[61], values[63]
        step = time_step(interval / 1000.0 if interval > 0.0 else None, dt)
        count, per_line = int(number_after(r"^ *([0-9]+)", block[0], "number of samples")), int(block[4] or 1)
        if count < 1 or per_line < 1 or int(block[5]) < 1:
            raise InputError(f"The line {block[0].strip()!r} announces no samples; it must announce some.")
        start = text.find("\n", block.end()) + 1 or len(text)
        samples = block_samples(text[start:], count, per_line, int(block[5]))
        end, label = _END.search(text, start), _LABEL.search(header)
        if end is None:
            raise InputError("The samples have no line End-of-data after them; the file must be complete.")
        before = end.end()
        titles = [line.strip() for line in header.strip("\n").split("\n")]
        event = titles[1].removeprefix("Record of ") if len(titles) > 1 else ""
        stated_peak = None if peak != peak else peak * factor
        channels.append(Channel(label[1] if label else end[1], factor * samples, step, event, stated_peak))
    if not channels:
        raise InputError("The file has no block of acceleration; it must have at least one.")
    return channels
