"""K-NET and KiK-net ASCII, read by ObsPy: 17 header lines, then counts, 8 a line; one channel a file.

Source: NIED, https://www.kyoshin.bosai.go.jp/kyoshin/man/knetform_en.html. The acceleration is (count −
mean of all counts) × scale factor, which gives the header's own "Max. Acc."; Dir. 1–3 is KiK-net's
borehole and 4–6 its surface sensor. "Record Time" includes the logger's delay of 15 s (ObsPy takes it
off the start time); the samples are not concerned.
"""

from __future__ import annotations

import re
from io import BytesIO
from typing import Any

import numpy as np

from stayput.errors import InputError
from stayput.motion.channels import Channel
from stayput.motion.readers.fields import number_after, numbers
from stayput.motion.readers.stated import acceleration_unit, time_step

FORMAT = "K-NET ASCII"

_KEYS = {  # as ObsPy wants them, of those that differ between files
    r"Station Lon\.": "Station Long.",
    r"Lon\.": "Long.",
    r"Max Acc\.": "Max. Acc. (gal)",
    r"Memo(?!\.)": "Memo.",
}
_HEADER_LINES = 17


def recognise(text: str) -> bool:
    """Return whether the file begins with "Origin Time" and has a scale factor."""
    return text.startswith("Origin Time") and "Scale Factor" in text[:2000]


def _obspy_read(text: str) -> Any:
    try:
        from obspy import read as obspy_read
    except ImportError:
        raise InputError(
            "ObsPy is absent; it must be installed to read K-NET ASCII: pip install obspy."
        ) from None
    try:
        return obspy_read(BytesIO(text.encode()), format="KNET")[0]
    except Exception as error:  # a broken header raises whatever it meets
        what = " ".join(str(error).split())
        raise InputError(
            f"The header cannot be read ({what}); it must be the 17 lines of the format."
        ) from None


def _header(lines: list[str]) -> list[str]:
    """Return the header lines with their keys as ObsPy wants them, in columns 1 to 18."""
    header: list[str] = []
    for line in lines[:_HEADER_LINES]:
        for pattern, key in _KEYS.items():
            if re.match(pattern, line):
                line = f"{key:<18}{line[18:]}"
        header.append(line)
    return header


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's one channel.

    Raises
    ------
    InputError
        ObsPy is absent, the header or a count is damaged, or the samples are not as long as stated.
    """
    lines = text.split("\n")
    header = _header(lines)
    if len(header) < _HEADER_LINES or not header[-1].startswith("Memo."):
        raise InputError("The header does not end with Memo. on line 17; it must be the format's 17 lines.")
    factor = acceleration_unit("gal", unit)
    counts = numbers(" ".join(lines[_HEADER_LINES:]).split(), "the counts")
    head = "\n".join(header)
    rate = number_after(r"^Sampling Freq\(Hz\) *([0-9.]{1,12})", head, "sampling frequency")
    seconds = number_after(r"^Duration Time\(s\) *([0-9.]{1,12})", head, "duration")
    scale = number_after(r"^Scale Factor *([0-9.]{1,12}) *\(gal\)", head, "scale factor in gal")
    if not (rate > 0.0 and scale > 0.0):
        raise InputError(
            f"The sampling frequency is {rate:g} Hz, the scale {scale:g} gal; both must be positive."
        )
    if abs(len(counts) - rate * seconds) >= 1.0 - 1e-6:
        raise InputError(
            f"The header states {seconds:g} s and the file has {len(counts) / rate:g} s; they must agree."
        )
    trace = _obspy_read("\n".join(header + lines[_HEADER_LINES:]))
    raw = np.asarray(trace.data, dtype=np.float64)
    acceleration = (raw - raw.mean()) * float(trace.stats.calib)  # ObsPy's calib is in m/s² a count
    peak = float(trace.stats.knet.accmax) * factor
    step = time_step(1.0 / rate, dt)
    return [
        Channel(
            str(trace.stats.channel), acceleration, step, str(trace.stats.station), peak, ", offset removed"
        )
    ]
