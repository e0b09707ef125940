"""CSMIP/CGS V2: for each channel a text, an integer and a real header, then three blocks of samples.

Source: California Strong Motion Instrumentation Program, https://www.strongmotioncenter.org. The
acceleration follows a line "3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC. (UNITS: ...)" in fields
of fixed width, 8F10.3 unless the line says otherwise; fields can touch. A line "/& END OF DATA FOR CHANNEL"
ends each channel. The fourth of the header's integers is the number of channels.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import NamedTuple

from stayput.errors import InputError, InputWarning, excerpt, warn
from stayput.motion.channels import Channel, plain_label
from stayput.motion.readers.fields import FixedBlock, check_count, numbers
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.readers.text import lines

FORMAT = "CSMIP V2"

_ANNOUNCED = re.compile(
    r"^ *[0-9]{1,9} +POINTS +OF +(?:ACCEL|VELOC|DISPL) +DATA +EQUALLY[ -]+SPACED +AT",
    re.IGNORECASE | re.MULTILINE,
)
_BLOCK = re.compile(
    r"([0-9]{1,9}) POINTS OF (ACCEL|VELOC|DISPL) DATA EQUALLY[ -]SPACED AT ([^ ]{1,20}) SEC\b(.*)",
    re.IGNORECASE,
)
_UNIT = re.compile(r"(?:UNITS: ?|\bIN )([^ ),]{1,20})", re.IGNORECASE)
_FIELDS = re.compile(r"\(([0-9]{1,3})[FEG]([0-9]{1,2})\.[0-9]{1,2}\)", re.IGNORECASE)
_CHANNEL = re.compile(r"\bCHAN +([0-9]{1,3}):(.*)", re.IGNORECASE)
_FROM = re.compile(r" {2}| FROM\b", re.IGNORECASE)
_PEAK = re.compile(r"PEAK ACCELERATION ?= ?([^ ]{1,20}) ([^ ]{1,20})", re.IGNORECASE)
_END = re.compile(r"END OF DATA FOR CHANNEL ([0-9]{1,3})\b", re.IGNORECASE)
_HEAD = 20_000  # characters at the beginning in which the first block is looked for
_HEADER_LINES = 100  # more than the header of any channel


def recognise(text: str) -> bool:
    """Return whether a line announces points of equally spaced data."""
    return _ANNOUNCED.search(text, 0, _HEAD) is not None


class _Block(NamedTuple):
    """The line that announces a block."""

    kind: str
    points: int
    step: float
    rest: str


@dataclass
class _ChannelText:
    """What the file says of one channel.

    Attributes
    ----------
    header : list of str
        The lines above its blocks.
    blocks : list of _Block
        What announces its blocks.
    samples : FixedBlock
        The acceleration.
    """

    header: list[str] = field(default_factory=list[str])
    blocks: list[_Block] = field(default_factory=list[_Block])
    samples: FixedBlock = field(default_factory=lambda: FixedBlock("the_samples"))

    def take(self, line: str) -> None:
        """Read a line."""
        block = _BLOCK.fullmatch(" ".join(line.split()))
        if block is not None:
            count, step = numbers([block[1], block[3]], "the_line_before_the_samples")
            self.blocks.append(_Block(block[2].upper(), int(count), float(step), block[4]))
            if block[2].upper() == "ACCEL":
                fields = _FIELDS.search(block[4])
                per_line, self.samples.width = (int(fields[1]), int(fields[2])) if fields else (8, 10)
                if not (count >= 1 and per_line >= 1 and self.samples.width >= 1):
                    raise InputError("motion.no_samples_announced", line=excerpt(line.strip()))
        elif not self.blocks:
            if len(self.header) < _HEADER_LINES:
                self.header.append(line)
        elif self.blocks[-1].kind == "ACCEL":
            self.samples.add(line)

    def labels(self) -> list[tuple[int, str]]:
        """Return the numbers and the directions that the header gives the channel."""
        matches = filter(None, map(_CHANNEL.search, self.header))
        return [(int(m[1]), _FROM.split(m[2].strip(), maxsplit=1)[0].strip()) for m in matches]

    def channels_of_file(self) -> int:
        """Return how many channels the header's integers state; 0 where they are not there."""
        rows = (line.split() for line in self.header)
        first = next((row for row in rows if len(row) == 16 and all(map(str.isdecimal, row))), None)
        return int(first[3]) if first else 0

    def name(self) -> str:
        """Return station and event."""
        titles = [line.strip() for line in self.header]
        while titles and not titles[0].upper().startswith("CORRECTED"):
            titles.pop(0)
        return f"{titles[6]}, {titles[2]}" if len(titles) > 6 else ""

    def peak(self) -> float | None:
        """Return the peak acceleration that the header states [m/s²]."""
        match = next((m for line in self.header if (m := _PEAK.search(" ".join(line.split())))), None)
        if match is None:
            return None
        return float(numbers([match[1]], "the_peak")[0]) * acceleration_unit(match[2], None)


def _check_number(part: _ChannelText, last_line: str, position: int) -> str:
    """Return the channel's direction; its numbers in the header and in the last line must agree."""
    labels = part.labels()
    end = _END.search(" ".join(last_line.split()))
    given = [number for number, _ in labels] + ([int(end[1])] if end else [])
    if len(set(given)) > 1:
        listing = " and ".join(map(str, sorted(set(given))))
        raise InputError("motion.csmip_two_numbers", channel=position, numbers=listing)
    directions = [direction for _, direction in labels]
    if len({plain_label(direction) for direction in directions}) > 1:
        english, japanese = zip(*map(excerpt, directions), strict=True)
        listing = ", ".join(english), "".join(japanese)
        taken = excerpt(directions[0])
        warn(InputWarning("motion.csmip_directions", channel=position, directions=listing, taken=taken))
    return directions[0] if directions else ""


def _channel(
    part: _ChannelText, last_line: str, position: int, unit: str | None, dt: float | None
) -> Channel:
    accelerations = [block for block in part.blocks if block.kind == "ACCEL"]
    if len(accelerations) != 1:
        raise InputError("motion.csmip_acceleration_lines", channel=position, count=len(accelerations))
    _, count, step, rest = accelerations[0]
    # Velocity and displacement last as long as the acceleration, but may have their own, longer time step.
    for other in part.blocks:
        apart = abs(other.points * other.step - count * step)
        if other.step != step if other.points == count else apart > max(step, other.step):
            raise InputError(
                "motion.csmip_lengths",
                channel=position,
                count=count,
                step=step,
                other_count=other.points,
                kind=other.kind,
                other_step=other.step,
            )
    stated = _UNIT.search(rest)
    factor = acceleration_unit(stated[1].rstrip(".") if stated else None, unit)
    samples = part.samples.array()
    check_count(len(samples), count)
    label = _check_number(part, last_line, position)
    step = time_step(step, dt)
    place = " ".join(" ".join(part.header).split())
    return Channel(label, factor * samples, step, part.name(), part.peak(), location=place)


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        A channel has no acceleration or more than one, no unit, or not as many samples as stated.
    """
    channels: list[Channel] = []
    part, stated = _ChannelText(), 0
    for _, line in lines(text):
        if not line.lstrip().startswith("/&"):
            part.take(line)
            continue
        channels.append(_channel(part, line, len(channels) + 1, unit, dt))
        stated = max(stated, part.channels_of_file())
        part = _ChannelText()
    if part.blocks or any(line.strip() for line in part.header):
        raise InputError("motion.csmip_no_end")
    if stated > len(channels):
        warn(InputWarning("motion.csmip_channels_missing", stated=stated, count=len(channels)))
    return channels
