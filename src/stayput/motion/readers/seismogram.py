"""SAC and miniSEED, read by ObsPy: the channels of one station, in the unit that the caller states.

Source: SAC's file format, https://ds.iris.edu/files/sac-manual; SEED 2.4, https://www.fdsn.org. Neither says
what a number is in m/s²; SAC's ``idep`` 6 and 7 say that it is no acceleration, and so does a channel's code
of an instrument that is no accelerometer, unless ``idep`` is 8, acceleration.
"""

from __future__ import annotations

import re
import struct
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.files import LARGEST_RECORD
from stayput.motion.readers.header import acceleration_unit, time_step
from stayput.motion.traces import channels_of_traces, other_instrument

if TYPE_CHECKING:
    import os

    from stayput.motion.channels import Channel

FORMAT = "SAC, miniSEED"

FORMATS = {"MSEED": "miniSEED", "SAC": "SAC"}
"""What ObsPy calls the formats, and what sentences do."""

_MSEED = re.compile(rb"[0-9 \0]{6}[DRQM][ \0].{12}", re.DOTALL)
_SAC_HEADER, _SAC_VERSION = 632, 304
"""Bytes of SAC's header, and where the header's version stands in it."""

_OTHER_THAN_ACCELERATION = {6: "displacement", 7: "velocity"}


def format_of(path: str | os.PathLike[str]) -> str | None:
    """Return which of `FORMATS` a file is in, by its first bytes, or None."""
    try:
        file = Path(path)
        if not file.is_file():
            return None
        with file.open("rb") as opened:
            start = opened.read(_SAC_HEADER)
    except (OSError, TypeError, ValueError):  # the reader of texts says why
        return None
    if _MSEED.match(start) and b"\0" in start:
        return "MSEED"
    if len(start) < _SAC_HEADER:
        return None
    versions = (struct.unpack_from(f"{order}i", start, _SAC_VERSION)[0] for order in "<>")
    return "SAC" if any(version in (6, 7) for version in versions) else None


def read(
    path: str | os.PathLike[str], form: str, unit: str | None, dt: float | None, *, location: str | None
) -> list[Channel]:
    """Return the file's channels.

    Parameters
    ----------
    path : str or path
        The file.
    form : str
        One of `FORMATS`.
    unit : str, optional
        Unit of its numbers, which it does not state.
    dt : float, optional
        Time step [s], which it states.
    location : str, optional
        See `channels_of_traces`.

    Raises
    ------
    InputError
        ObsPy is absent, the file is damaged or of no acceleration, no unit; or as `channels_of_traces`.
    """
    acceleration_unit(None, unit)
    if (size := Path(path).stat().st_size) > LARGEST_RECORD:
        raise InputError("motion.file_too_large", path=str(path), size=size, most=LARGEST_RECORD)
    try:
        from obspy import read as obspy_read
    except ImportError:
        raise InputError("motion.no_obspy", format=FORMATS[form]) from None
    try:
        traces: Any = obspy_read(BytesIO(Path(path).read_bytes()), format=form)
        lengths = [int(getattr(getattr(t.stats, "mseed", None), "record_length", 1)) for t in traces]
        if size % (length := min(lengths, default=1)):
            raise InputError("motion.seismogram_cut", size=size % length, length=length)
        for trace in traces:
            kind = _OTHER_THAN_ACCELERATION.get(getattr(getattr(trace.stats, "sac", None), "idep", 0))
            if kind is not None:
                raise InputError("motion.peer_no_acceleration", kind=phrase(f"motion.{kind}"))
            if values := other_instrument(trace):
                raise InputError("motion.other_instrument", **values)
            time_step(float(trace.stats.delta), dt)
        return channels_of_traces(traces, unit or "", None, location)
    except InputError:
        raise
    except Exception:  # a broken file raises whatever it meets
        raise InputError("motion.seismogram_unread") from None
