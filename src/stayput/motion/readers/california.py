"""Strong-motion files of California, with several channels each: CSMIP's V2 and COSMOS V1.20.

CSMIP V2: for each channel a text, an integer and a real header, then three blocks of samples.

COSMOS V1.20: for each channel 13 text lines, an integer and a real header, comments, and the samples.

Sources: California Strong Motion Instrumentation Program, https://www.strongmotioncenter.org. The
acceleration of V2 follows a line "3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC. (UNITS: ...)" in
fields of fixed width, 8F10.3 unless the line says otherwise; fields can touch. A line "/& END OF DATA FOR
CHANNEL" ends each channel. The fourth of the header's integers is the number of channels. COSMOS
strong-motion data format 1.20 (2001), https://www.strongmotion.org: of the real header, value 62 is the
interval [ms] and 64 the peak, in the samples' unit.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, excerpt, warn
from stayput.motion.channels import LISTED, Channel, plain_label
from stayput.motion.readers.text import Reader, check_count, fields, lacks, lines, not_as_stated, numbers
from stayput.motion.units import acceleration_unit, time_step
from stayput.wording import joined

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

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
_OF_STATION = re.compile(r"\(STA CHN: ?([0-9]{1,3})\)", re.IGNORECASE)
_FROM = re.compile(r" {2}| FROM\b| \(STA CHN", re.IGNORECASE)
_PEAK = re.compile(r"PEAK ACCELERATION ?= ?([^ ]{1,20}) ([^ ]{1,20})", re.IGNORECASE)
_CSMIP_END = re.compile(r"END OF DATA FOR CHANNEL ([0-9]{1,3})\b", re.IGNORECASE)
_HEAD = 20_000  # characters at the beginning in which the first block is looked for
_HEADER_LINES = 100  # more than the header of any channel

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
_LASTS = re.compile(r"\bapprox ([0-9]{1,9}) secs?\b", re.IGNORECASE)
_UNKNOWN = re.compile(r"unknown/unspecified: ?(-?[0-9]{1,9})\b", re.IGNORECASE)
_LABEL = re.compile(
    r"Chan[^:]{0,12}: ?([0-9]{1,3}(?= ?Deg)|Up|Down|Vert|[NEZVHU][A-Z0-9\-]{0,4}\b)", re.IGNORECASE
)
_COSMOS_END = re.compile(
    r"(?:/& ?-* ?)?End[- ]of[- ]data for "
    r"(?:chan(?:nel)? ?([^ ]{1,8})|[^ .]{1,8}\.([^ .]{1,3})\.[^ ]{1,8})"
    rf"(?:$| -+| {_KIND}(?: |$))",
    re.IGNORECASE,
)
"""The last line of samples has the channel's number or code, or station.channel.network.location."""


def _plain(line: str) -> str:
    return " ".join(line.split())


class _Lines:
    """The file's lines one after the other, with a look at the next; ``last`` is how its last one begins."""

    def __init__(self, text: str, last: str) -> None:
        self._last = last
        self._rest: Iterator[str] = (line for _, line in lines(text))
        self.line: str | None = next(self._rest, None)

    @property
    def plain(self) -> str:
        """The next line with single blanks; "" at the end of the file."""
        return _plain(self.line or "")

    def take(self) -> str:
        """Return the line and go on to the next; refuse a file that is at its end."""
        line = self.line
        if line is None:
            raise InputError("motion.no_end", line=self._last)
        self.line = next(self._rest, None)
        return line

    def until(self, ends: Callable[[str], object]) -> Iterator[str]:
        """Yield the lines up to one that ends a part, or to the end of the file."""
        while self.line is not None and not ends(self.line):
            yield self.take()

    def skip_to(self, ends: Callable[[str], object]) -> bool:
        """Pass over the same lines; return whether one is left."""
        for _ in self.until(ends):
            pass
        return self.line is not None


def _check_layout(line: str, *sizes: int) -> None:
    """Refuse a line before samples that announces none, or fields without width."""
    if min(sizes) < 1:
        raise InputError("motion.header_line", line=excerpt(line.strip()), wanted=phrase("motion.a_layout"))


def _not_acceleration() -> InputError:
    where, other = phrase("motion.names_of_blocks"), phrase("motion.velocity_or_displacement")
    return InputError("motion.not_acceleration", where=where, quantity=other)


class _Block(NamedTuple):
    """A block of V2: what the line that announces it says, and its samples where they are accelerations."""

    kind: str
    points: int
    step: float
    rest: str
    samples: NDArray[np.float64]


def _ends_part(line: str) -> bool:
    """Return whether a line ends a channel of V2, or announces a block."""
    return line.lstrip().startswith("/&") or _BLOCK.fullmatch(_plain(line)) is not None


def _csmip_block(rest: _Lines) -> _Block | None:
    """Return the block that comes next; None where none does."""
    block = _BLOCK.fullmatch(rest.plain)
    if block is None:
        return None
    announced, kind = rest.take(), block[2].upper()
    count, step = numbers([block[1], block[3]], "the_line_before_the_samples").tolist()
    layout = _FIELDS.search(block[4])
    per_line, width = (int(layout[1]), int(layout[2])) if layout else (8, 10)
    if kind == "ACCEL":
        _check_layout(announced, int(count), per_line, width)
    samples = numbers(fields(rest.until(_ends_part), width) if kind == "ACCEL" else [], "the_samples")
    rest.skip_to(_ends_part)
    return _Block(kind, int(count), step, block[4], samples)


def _check_number(header: list[str], last_line: str, position: int) -> str:
    """Return the channel's direction; its numbers in the header and in the last line must agree.

    The last line may have the station's number of the channel where the header has the recorder's too.
    """
    matches = list(filter(None, map(_CHANNEL.search, header)))
    end = _CSMIP_END.search(_plain(last_line))
    of_station = {int(m[1]) for line in header if (m := _OF_STATION.search(_plain(line)))}
    numbers = {int(m[1]) for m in matches}
    if end and int(end[1]) not in of_station:
        numbers.add(int(end[1]))
    if len(numbers) > 1:
        first, second, *_ = sorted(numbers)
        what = phrase("motion.the_number")
        raise InputError("motion.stated_twice", what=what, first=first, second=second)
    directions = [_FROM.split(m[2].strip(), maxsplit=1)[0].strip() for m in matches]
    if len({plain_label(direction) for direction in directions}) > 1:
        listing, taken = joined(map(excerpt, directions), LISTED), excerpt(directions[0])
        warn(InputWarning("motion.csmip_directions", channel=position, directions=listing, taken=taken))
    return directions[0] if directions else ""


def _csmip_channel(
    rest: _Lines, position: int, unit: str | None, dt: float | None
) -> tuple[Channel, list[str]]:
    """Return the channel that comes next, and its header."""
    header = list(islice(rest.until(_ends_part), _HEADER_LINES))
    rest.skip_to(_ends_part)
    blocks = list(iter(lambda: _csmip_block(rest), None))
    last_line = rest.take()
    accelerations = [block for block in blocks if block.kind == "ACCEL"]
    if not accelerations:
        raise _not_acceleration()
    if len(accelerations) > 1:
        raise InputError("motion.no_end", line="/&")
    _, count, step, about_samples, samples = accelerations[0]
    # Velocity and displacement last as long as the acceleration, but may have their own, longer time step.
    for other in blocks:
        lasts, other_lasts = count * step, other.points * other.step
        if other.step != step if other.points == count else abs(other_lasts - lasts) > max(step, other.step):
            about: dict[str, Any] = {"lasts": lasts, "kind": other.kind, "other": other_lasts}
            raise InputError("motion.csmip_lengths", channel=position, **about)
    stated = _UNIT.search(about_samples)
    factor = acceleration_unit(stated[1].rstrip(".") if stated else None, unit)
    check_count(len(samples), count)
    label = _check_number(header, last_line, position)
    titles = [line.strip() for line in header]
    first = next((i for i, line in enumerate(titles) if line.upper().startswith("CORRECTED")), len(titles))
    name = f"{titles[first + 6]}, {titles[first + 2]}" if len(titles) > first + 6 else ""
    peak = next((m for line in header if (m := _PEAK.search(_plain(line)))), None)
    stated_peak = peak and float(numbers([peak[1]], "the_peak")[0]) * acceleration_unit(peak[2], None)
    place = " ".join(" ".join(header).split())
    return Channel(label, factor * samples, time_step(step, dt), name, stated_peak, location=place), header


def _read_csmip(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels of a V2 file.

    Raises
    ------
    InputError
        A channel has no acceleration or more than one, no unit, or not as many samples as stated.
    """
    rest, stated = _Lines(text, "/&"), 0
    channels: list[Channel] = []
    while rest.skip_to(str.strip):
        channel, header = _csmip_channel(rest, len(channels) + 1, unit, dt)
        channels.append(channel)
        integers = (row for row in map(str.split, header) if len(row) == 16 and all(map(str.isdecimal, row)))
        stated = max(stated, next((int(row[3]) for row in integers), 0))
    if stated > len(channels):
        warn(InputWarning("motion.csmip_channels_missing", stated=stated, count=len(channels)))
    return channels


def _ends_samples(line: str) -> bool:
    """Return whether a line ends a block of samples of COSMOS."""
    return line.startswith(("E", "e", "/&")) and _COSMOS_END.match(_plain(line)) is not None


def _cosmos_values(rest: _Lines, kind: str, least: int = 0) -> list[float]:
    """Return the values of the integer or the real header."""
    match = _VALUES.match(rest.plain)
    if match is None or match[2].lower() != kind:
        raise lacks(f"the_{kind}_header")
    rest.take()
    some_lines = (rest.take() for _ in range(int(match[3])))
    values = numbers(fields(some_lines, max(1, int(match[4]))), f"the_{kind}_header").tolist()
    if len(values) != int(match[1]) or len(values) < least:
        wanted = match[1] if len(values) != int(match[1]) else f"≥ {least}"
        name = phrase(f"motion.the_{kind}_header")
        raise InputError("common.so_many_values", name=name, count=len(values), wanted=wanted)
    return values


def _cosmos_header(rest: _Lines) -> tuple[list[str], list[float]]:
    """Return the text lines of a channel with single blanks, and the real header; NaN where unknown."""
    first = _FIRST.match(rest.plain)
    if first is None:
        line = excerpt((rest.line or "").strip())
        raise InputError("motion.header_line", line=line, wanted=phrase("motion.the_format"))
    titles = [_plain(rest.take()) for _ in range(max(1, int(first[1])))]
    _cosmos_values(rest, "integer")
    reals = _cosmos_values(rest, "real", 64)
    unknown = next((m for title in titles if (m := _UNKNOWN.search(title))), None)
    blank = float(unknown[1]) if unknown else -999.0
    if comments := _COMMENTS.match(rest.plain):
        for _ in range(1 + int(comments[1])):
            rest.take()
    return titles, [math.nan if value == blank else value for value in reals]


def _cosmos_channel(
    titles: list[str], reals: list[float], rest: _Lines, unit: str | None, dt: float | None
) -> Channel | None:
    """Return the channel of the block of samples that comes next; None where it is no acceleration."""
    announced = rest.take().strip()
    line = _plain(announced)
    count, layout, units = _COUNT.match(line), _FORMAT.search(line), _UNITS.search(line)
    if count is None or layout is None:
        raise InputError("motion.header_line", line=excerpt(announced), wanted=phrase("motion.a_layout"))
    kind, points, width = count[2].lower(), int(count[1]), int(layout[2])
    _check_layout(announced, points, int(layout[1] or 1), width)
    samples = numbers(fields(rest.until(_ends_samples), width) if kind == "accel" else [], "the_samples")
    rest.skip_to(_ends_samples)
    end = _COSMOS_END.match(last := _plain(rest.take()))
    assert end is not None
    if end[3] is not None and end[3].lower() != kind:
        raise InputError("motion.header_line", line=excerpt(last), wanted=excerpt(kind))
    if kind != "accel":
        return None
    check_count(len(samples), points)
    factor = acceleration_unit(units[1].strip() if units else None, unit)
    interval, peak = reals[61], reals[63]
    step = time_step(interval / 1000.0 if interval > 0.0 else None, dt)
    lasts = _LASTS.search(line)
    if lasts is not None and abs(points * step - int(lasts[1])) > 1.0 + 0.01 * int(lasts[1]):
        raise not_as_stated("duration", int(lasts[1]), points * step, " s")
    label = next((m[1] for title in titles if (m := _LABEL.search(title))), end[1] or end[2])
    event = titles[1].removeprefix("Record of ") if len(titles) > 1 else ""
    stated_peak = None if math.isnan(peak) else peak * factor
    origin = f"{event}, {next((title for title in titles if title.startswith('Statn No')), '')}"
    place = " ".join(titles)
    return Channel(label, factor * samples, step, event, stated_peak, location=place, origin=origin)


def _read_cosmos(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels of a COSMOS file.

    Raises
    ------
    InputError
        There is no acceleration, a header block is damaged, or there are not as many samples as stated.
    """
    rest = _Lines(text, "End-of-data")
    channels: list[Channel] = []
    header: tuple[list[str], list[float]] | None = None
    while rest.skip_to(str.strip):
        if header is None or _COUNT.match(rest.plain) is None:
            header = _cosmos_header(rest)
        channel = _cosmos_channel(*header, rest, unit, dt)
        if channel is not None:
            channels.append(channel)
    if not channels:
        raise _not_acceleration()
    return channels


def _is_csmip(text: str) -> bool:
    """Return whether a line announces points of equally spaced data."""
    return _ANNOUNCED.search(text, 0, _HEAD) is not None


def _is_cosmos(text: str) -> bool:
    """Return whether the first line states the format and its text lines."""
    return _FIRST.match(_plain(text[:1000].partition("\n")[0])) is not None


READERS = (Reader("CSMIP V2", _is_csmip, _read_csmip), Reader("COSMOS V1.20", _is_cosmos, _read_cosmos))
