"""K-NET and KiK-net ASCII, read by ObsPy: 17 header lines, then counts, 8 a line; one channel a file.

Source: NIED, https://www.kyoshin.bosai.go.jp/kyoshin/man/knetform_en.html. The acceleration is (count −
mean of all counts) × scale factor, which gives the header's own "Max. Acc."; Dir. 1–3 is KiK-net's
borehole and 4–6 its surface sensor. "Record Time" includes the logger's delay of 15 s (ObsPy takes it
off the start time); the samples are not concerned.
"""

from __future__ import annotations

import re
from io import BytesIO
from itertools import islice
from typing import Any

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import free_numbers, quantity
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.readers.text import lines

FORMAT = "K-NET ASCII"

_KEYS = {  # as ObsPy wants them, by their letters and by what else some files write
    "".join(filter(str.isalpha, key.lower())): key
    for key in (
        *("Origin Time", "Lat.", "Long.", "Depth. (km)", "Mag.", "Station Code", "Station Lat."),
        *(
            "Station Long.",
            "Station Height(m)",
            "Record Time",
            "Sampling Freq(Hz)",
            "Duration Time(s)",
            "Dir.",
        ),
        *("Scale Factor", "Max. Acc. (gal)", "Last Correction", "Memo."),
    )
} | {"lon": "Long.", "stationlon": "Station Long.", "maxacc": "Max. Acc. (gal)"}
_HEADER_LINES = 17
_SCALE = re.compile(
    r"([0-9]{1,9}(?:\.[0-9]{0,9})?) *\(gal\) */ *([0-9]{1,12}(?:\.[0-9]{0,9})?)", re.IGNORECASE
)


def recognise(text: str) -> bool:
    """Return whether the file begins with "Origin Time" and has a scale factor."""
    head = text[:2000].lower()
    return head.startswith("origin time") and "scale factor" in head


def _entry(header: list[str], key: str, what: str) -> str:
    """Return what the header has behind a key."""
    value = next((line[18:].strip() for line in header if line.startswith(key)), "")
    if not value:
        raise InputError("motion.no_header_entry", what=phrase(f"motion.{what}"))
    return value


def _obspy_read(text: str) -> Any:
    try:
        from obspy import read as obspy_read
    except ImportError:
        raise InputError("motion.no_obspy", format=FORMAT) from None
    try:
        return obspy_read(BytesIO(text.encode()), format="KNET")[0]
    except Exception as error:  # a broken header raises whatever it meets
        raise InputError("motion.knet_header_unread", reason=" ".join(str(error).split())) from None


def _header(lines: list[str]) -> list[str]:
    """Return the header lines with their keys as ObsPy wants them, in columns 1 to 18."""
    header: list[str] = []
    for line in lines[:_HEADER_LINES]:
        key = _KEYS.get("".join(filter(str.isalpha, line[:18].lower())), line[:18])
        header.append(f"{key:<18}{line[18:]}")
    return header


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

    Raises
    ------
    InputError
        ObsPy is absent, the header or a count is damaged, or the samples are not as long as stated.
    """
    top = list(islice(lines(text), _HEADER_LINES + 1))
    header = _header([line for _, line in top[:_HEADER_LINES]])
    if len(top) <= _HEADER_LINES or not header[-1].startswith("Memo."):
        raise InputError("motion.knet_no_memo")
    factor = acceleration_unit("gal", unit)
    start, first_row = top[_HEADER_LINES]
    counts = free_numbers(text, start, "the_counts")
    rate = quantity(_entry(header, "Sampling Freq(Hz)", "sampling_frequency"), ("HZ",), "sampling_frequency")
    seconds = quantity(_entry(header, "Duration Time(s)", "duration"), ("S",), "duration")
    scale = _SCALE.fullmatch(_entry(header, "Scale Factor", "scale_factor"))
    if scale is None:
        raise InputError("motion.knet_no_scale")
    if not (rate > 0.0 and float(scale[1]) > 0.0 and float(scale[2]) > 0.0):
        raise InputError("motion.knet_not_positive", rate=rate)
    if abs(len(counts) - rate * seconds) >= 1.0 - 1e-6:
        raise InputError("motion.knet_duration", stated=seconds, duration=len(counts) / rate)
    trace = _obspy_read("\n".join([*header, first_row]))  # the header alone; a row because it needs one
    counts -= counts.mean()
    counts *= float(trace.stats.calib)  # ObsPy's calib is in m/s² a count
    peak = float(trace.stats.knet.accmax) * factor
    step = time_step(1.0 / rate, dt)
    label, station = str(trace.stats.channel), str(trace.stats.station)
    below = label.endswith("1")
    sensor = {"1": ", borehole", "2": ", surface"}.get(label[-1:], "")
    origin = f"{station}{sensor}, {header[0][18:].strip()}"
    note = ", offset removed"
    return [Channel(label, counts, step, station, peak, note, origin=origin, borehole=below)]
