"""K-NET and KiK-net ASCII: 17 lines of a header, then counts, 8 a line; one channel a file.

Source: NIED, https://www.kyoshin.bosai.go.jp/kyoshin/man/knetform_en.html. The acceleration is (count −
mean of all counts) × scale factor, which gives the header's own "Max. Acc."; Dir. 1–3 is KiK-net's
borehole and 4–6 its surface sensor.
"""

from __future__ import annotations

import re
from itertools import islice

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel, in_borehole
from stayput.motion.readers.fields import free_numbers, quantity
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.readers.text import lines

FORMAT = "K-NET ASCII"

_HEADER_LINES = 17
_DIRECTIONS = {"1": "NS1", "2": "EW1", "3": "UD1", "4": "NS2", "5": "EW2", "6": "UD2"} | {
    name: name for name in ("NS", "EW", "UD")
}
_SCALE = re.compile(
    r"([0-9]{1,9}(?:\.[0-9]{0,9})?) *\(gal\) */ *([0-9]{1,12}(?:\.[0-9]{0,9})?)", re.IGNORECASE
)


def recognise(text: str) -> bool:
    """Return whether the file begins with "Origin Time" and has a scale factor."""
    head = text[:2000].lower()
    return head.startswith("origin time") and "scale factor" in head


def _entry(header: dict[str, str], key: str, what: str) -> str:
    """Return what the header has behind a key."""
    if value := header.get(_letters(key), ""):
        return value
    raise InputError("motion.no_header_entry", what=phrase(f"motion.{what}"))


def _letters(key: str) -> str:
    """Return the letters of a key, by which it is known: some files leave out points and blanks."""
    return "".join(filter(str.isalpha, key.lower()))


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

    Raises
    ------
    InputError
        The header or a count is damaged, or the samples are not as long as stated.
    """
    top = list(islice(lines(text), _HEADER_LINES + 1))
    header = {_letters(line[:18]): line[18:].strip() for _, line in top[:_HEADER_LINES]}
    if len(top) <= _HEADER_LINES or "memo" not in header:
        raise InputError("motion.knet_no_memo")
    factor = acceleration_unit("gal", unit)
    counts = free_numbers(text, top[_HEADER_LINES][0], "the_counts")
    rate = quantity(_entry(header, "Sampling Freq(Hz)", "sampling_frequency"), ("HZ",), "sampling_frequency")
    seconds = quantity(_entry(header, "Duration Time(s)", "duration"), ("S",), "duration")
    peak = quantity(_entry(header, "Max. Acc. (gal)", "the_peak"), ("GAL",), "the_peak")
    scale = _SCALE.fullmatch(_entry(header, "Scale Factor", "scale_factor"))
    if scale is None:
        raise InputError("motion.knet_no_scale")
    if not (rate > 0.0 and float(scale[1]) > 0.0 and float(scale[2]) > 0.0):
        raise InputError("motion.knet_not_positive", rate=rate)
    if abs(len(counts) - rate * seconds) >= 1.0 - 1e-6:
        raise InputError("motion.knet_duration", stated=seconds, duration=len(counts) / rate)
    counts -= counts.mean()
    counts *= 0.01 * float(scale[1]) / float(scale[2])  # m/s² a count
    direction = _entry(header, "Dir.", "direction")
    label = _DIRECTIONS.get(direction.replace("-", "").upper())
    if label is None:
        raise InputError("motion.knet_direction", direction=excerpt(direction))
    sensor = {"1": ", borehole", "2": ", surface"}.get(label[-1], "")
    origin = f"{header.get('stationcode', '')}{sensor}, {header.get('origintime', '')}"
    return [
        Channel(
            label,
            counts,
            time_step(1.0 / rate, dt),
            header.get("stationcode", ""),
            peak * factor,
            ", offset removed",
            origin=origin,
            borehole=in_borehole(label),
        )
    ]
