"""COSMOS V1.20: for each channel 13 text lines, an integer and a real header, comments, and the samples.

Source: COSMOS strong-motion data format 1.20 (2001), https://www.strongmotion.org. Of the real header,
value 62 is the interval [ms] and 64 the peak, in the samples' unit.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import FixedBlock, check_count
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.readers.text import lines

if TYPE_CHECKING:
    from collections.abc import Iterator

FORMAT = "COSMOS V1.20"

_FIRST = re.compile(r"[^\n(]{0,80}\(Format v0?1\.[0-9]{1,2} with ([0-9]{1,2}) text lines", re.IGNORECASE)
_VALUES = re.compile(
    r"([0-9]{1,4}) (Integer|Real)-header values follow on ([0-9]{1,3}) lines"
    r".*Format ?= ?\( ?[0-9]{1,3}[FEGI]([0-9]{1,2})",
    re.IGNORECASE,
)
_COMMENTS = re.compile(r"([0-9]{1,6}) Comment line\(?s?\)? follow", re.IGNORECASE)
_KIND = (
    r"(?:(?:raw|unc?orr?(?:ected)?\.?|corr?(?:ected)?\.?) )?(accel|veloc|displ)(?:\.|eration|ity|acement)?"
)
_COUNT = re.compile(rf"([0-9]{{1,9}}) {_KIND} (?:pts|points)\b", re.IGNORECASE)
_UNITS = re.compile(r"units ?= ?([^,(]{1,20})", re.IGNORECASE)
_FORMAT = re.compile(r"Format ?= ?\( ?([0-9]{0,3})[FEIG]([0-9]{1,2})", re.IGNORECASE)
_KINDS = {"accel": "acceleration", "veloc": "velocity", "displ": "displacement"}
_LASTS = re.compile(r"\bapprox ([0-9]{1,9}) secs?\b", re.IGNORECASE)
_UNKNOWN = re.compile(r"unknown/unspecified: ?(-?[0-9]{1,9})\b", re.IGNORECASE)
_LABEL = re.compile(
    r"Chan[^:]{0,12}: ?([0-9]{1,3}(?= ?Deg)|Up|Down|Vert|[NEZVHU][A-Z0-9\-]{0,4}\b)", re.IGNORECASE
)
_END = re.compile(
    rf"(?:/& ?-* ?)?End[- ]of[- ]data for chan(?:nel)? ?([^ ]{{1,8}})(?:$| -+| {_KIND}(?: |$))", re.IGNORECASE
)


def _plain(line: str) -> str:
    return " ".join(line.split())


def recognise(text: str) -> bool:
    """Return whether the first line states the format and its text lines."""
    return _FIRST.match(_plain(text[:1000].partition("\n")[0])) is not None


@dataclass(frozen=True)
class _Header:
    """What a channel's headers state.

    Attributes
    ----------
    titles : list of str
        The text lines, with single blanks.
    reals : list of float
        Values of the real header; NaN where unknown.
    """

    titles: list[str]
    reals: list[float]


class _Lines:
    """The file's lines one after the other, with a look at the next."""

    def __init__(self, text: str) -> None:
        self._rest: Iterator[str] = (line for _, line in lines(text))
        self.line: str | None = next(self._rest, None)

    def take(self) -> str:
        """Return the line and go on to the next.

        Raises
        ------
        InputError
            The file is at its end.
        """
        line = self.line
        if line is None:
            raise InputError("motion.cosmos_no_end")
        self.line = next(self._rest, None)
        return line

    def until_end(self) -> Iterator[str]:
        """Yield the lines up to one that ends a block of samples, or to the end of the file."""
        line = self.line
        while line is not None and not (line.startswith(("E", "e", "/&")) and _END.match(_plain(line))):
            yield line
            line = next(self._rest, None)
        self.line = line

    def skip_blank(self) -> bool:
        """Pass over blank lines; return whether a line is left."""
        while self.line is not None and not self.line.strip():
            self.take()
        return self.line is not None


def _values(rest: _Lines, kind: str) -> list[float]:
    """Return the values of the integer or the real header."""
    match = _VALUES.match(_plain(rest.line or ""))
    if match is None or match[2].lower() != kind:
        raise InputError("motion.cosmos_no_header", kind=kind)
    rest.take()
    block = FixedBlock(f"the_{kind}_header", max(1, int(match[4])))
    for _ in range(int(match[3])):
        block.add(rest.take())
    values = block.array().tolist()
    if len(values) != int(match[1]):
        raise InputError("motion.cosmos_header_count", kind=kind, count=len(values), stated=match[1])
    return values


def _header(rest: _Lines) -> _Header:
    first = _FIRST.match(_plain(rest.line or ""))
    if first is None:
        raise InputError("motion.cosmos_no_format", line=excerpt((rest.line or "").strip()))
    titles = [_plain(rest.take()) for _ in range(max(1, int(first[1])))]
    _values(rest, "integer")
    reals = _values(rest, "real")
    if len(reals) < 64:
        raise InputError("motion.cosmos_short_header", count=len(reals))
    unknown = next((m for title in titles if (m := _UNKNOWN.search(title))), None)
    blank = float(unknown[1]) if unknown else -999.0
    if comments := _COMMENTS.match(_plain(rest.line or "")):
        for _ in range(1 + int(comments[1])):
            rest.take()
    return _Header(titles, [math.nan if value == blank else value for value in reals])


def _channel(header: _Header, rest: _Lines, unit: str | None, dt: float | None) -> Channel | None:
    """Return the channel of the block of samples that comes next; None where it is no acceleration."""
    announced = rest.take().strip()
    line = _plain(announced)
    count, layout, units = _COUNT.match(line), _FORMAT.search(line), _UNITS.search(line)
    if count is None or layout is None:
        raise InputError("motion.cosmos_no_layout", line=excerpt(announced))
    kind, points, width = count[2].lower(), int(count[1]), int(layout[2])
    if points < 1 or int(layout[1] or 1) < 1 or width < 1:
        raise InputError("motion.no_samples_announced", line=excerpt(announced))
    block = FixedBlock("the_samples", width)
    for sample_line in rest.until_end():
        if kind == "accel":
            block.add(sample_line)
    end = _END.match(_plain(rest.take()))
    assert end is not None
    if end[2] is not None and end[2].lower() != kind:
        begun, ended = _KINDS[kind], _KINDS[end[2].lower()]
        raise InputError("motion.cosmos_another_end", begun=begun, ended=ended)
    if kind != "accel":
        return None
    samples = block.array()
    check_count(len(samples), points)
    factor = acceleration_unit(units[1].strip() if units else None, unit)
    interval, peak = header.reals[61], header.reals[63]
    step = time_step(interval / 1000.0 if interval > 0.0 else None, dt)
    lasts = _LASTS.search(line)
    if lasts is not None and abs(points * step - int(lasts[1])) > 1.0 + 0.01 * int(lasts[1]):
        duration = points * step
        raise InputError(
            "motion.cosmos_duration", stated=lasts[1], count=points, step=step, duration=duration
        )
    titles = header.titles
    label = next((m[1] for title in titles if (m := _LABEL.search(title))), end[1])
    event = titles[1].removeprefix("Record of ") if len(titles) > 1 else ""
    stated_peak = None if math.isnan(peak) else peak * factor
    station = next((title for title in titles if title.startswith("Statn No")), "")
    origin = f"{event}, {station}"
    return Channel(
        label, factor * samples, step, event, stated_peak, location=" ".join(titles), origin=origin
    )


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        There is no acceleration, a header block is damaged, or there are not as many samples as stated.
    """
    rest = _Lines(text)
    channels: list[Channel] = []
    header: _Header | None = None
    while rest.skip_blank():
        if header is None or _COUNT.match(_plain(rest.line or "")) is None:
            header = _header(rest)
        channel = _channel(header, rest, unit, dt)
        if channel is not None:
            channels.append(channel)
    if not channels:
        raise InputError("motion.cosmos_no_acceleration")
    return channels
