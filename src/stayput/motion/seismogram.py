"""SAC, miniSEED: the channels of one station, read by ObsPy, in the unit that the caller states.

Source: SAC's file format, https://ds.iris.edu/files/sac-manual; SEED 2.4, https://www.fdsn.org. Neither says
what a number is in m/s²; SAC's ``idep`` 6 and 7 say that it is no acceleration, and so does a channel's code
of an instrument that is no accelerometer, unless ``idep`` is 8, acceleration.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from io import BytesIO
from typing import Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, absent, not_allowed, unknown, warn
from stayput.motion.channels import Channel, labels_phrase
from stayput.motion.units import acceleration_unit, time_step, unit_factor

_OTHER_INSTRUMENT = re.compile(r"(?!EW|UD)[BCDEFGHLMQRSTV](?![NLG])[A-Z][NEZ0-9FO]")
"""SEED's codes of band, instrument and orientation (SEED 2.4, appendix A) but those of accelerometers."""

_ACCELERATION = 8  # idep of SAC

_NO_LOCATION = "--"  # as the codes of SEED are written where there is none
_START_TOLERANCE = 0.01  # of a time step, between the starts of two traces


def channels_of_traces(
    traces: Iterable[Any], unit: str, name: str | None, location: str | None = None
) -> list[Channel]:
    """Return the channels of ObsPy's traces; ObsPy itself is not needed.

    Parameters
    ----------
    traces : iterable of obspy.Trace
        One complete trace a channel, all of one station and one start.
    unit : str
        Unit of the traces' numbers as they stand.
    name : str, optional
        What they are called; default network and station.
    location : str, optional
        Code of the sensor, where the station has several; "--" of the one without a code.

    Raises
    ------
    InputError
        No traces, gaps, different starts, several stations or sensors, an unknown unit.
    """
    factor = unit_factor(unit)
    items = _of_one_sensor(list(traces), location)
    channels: list[Channel] = []
    start = items[0].stats.starttime
    for trace in items:
        stats = trace.stats
        code, dt = str(stats.channel), float(stats.delta)
        if np.ma.is_masked(trace.data) or any(channel.label == code for channel in channels):
            raise InputError("motion.trace_gaps", channel=code)
        if (kind := np.asarray(trace.data).dtype).kind not in "biuf":  # miniSEED may hold a text
            called = phrase("motion.samples_of", component=code)
            raise not_allowed(called, kind.name, "motion.row_of_samples")
        if values := other_instrument(trace):
            warn(InputWarning("motion.other_instrument", **values))
        late = float(stats.starttime - start)
        if abs(late) > _START_TOLERANCE * dt:
            raise InputError("motion.trace_start", channel=code, late=late)
        station, samples = _station(stats), factor * np.asarray(trace.data, dtype=np.float64)
        below = hasattr(stats, "knet") and code.endswith("1")
        origin = f"{station} {_location(stats)}, {str(start)[:22]}"
        channels.append(Channel(code, samples, dt, name or station, origin=origin, borehole=below))
    return channels


def other_instrument(trace: Any) -> dict[str, Any] | None:
    """Return the values of the sentence that a trace is of no accelerometer, or None where it may be."""
    code = str(trace.stats.channel)
    stated = getattr(getattr(trace.stats, "sac", None), "idep", 0)
    of_other = stated != _ACCELERATION and _OTHER_INSTRUMENT.fullmatch(code)
    return {"channel": code, "letter": code[1]} if of_other else None


def _station(stats: Any) -> str:
    return ".".join(part for part in (str(stats.network), str(stats.station)) if part)


def _location(stats: Any) -> str:
    return str(getattr(stats, "location", "")).strip() or _NO_LOCATION


def _of_one_sensor(items: list[Any], location: str | None) -> list[Any]:
    """Return the traces of a location, all of one station."""
    if not items:
        raise InputError("common.empty", name="stream")
    stations = list(dict.fromkeys(_station(trace.stats) for trace in items))
    if len(stations) > 1:
        raise InputError("motion.several_stations", one=stations[0], other=stations[1])
    codes = sorted({_location(trace.stats) for trace in items})
    wanted = codes[0] if location is None else location.strip() or _NO_LOCATION
    if location is None and len(codes) > 1:
        about: dict[str, Any] = {"count": len(codes), "known": labels_phrase(codes), "option": "location"}
        raise InputError("motion.several_locations", "location", **about)
    if wanted not in codes:
        raise unknown("motion.location", location, codes, "location")
    return [trace for trace in items if _location(trace.stats) == wanted]


FORMATS = {"SAC": "SAC", "MSEED": "miniSEED"}
"""What ObsPy calls the formats, and what sentences do."""

_MSEED = re.compile(rb"[0-9 \0]{6}[DRQM][ \0].{12}", re.DOTALL)
_SAC_HEADER, _SAC_VERSION = 632, 304
"""Bytes of SAC's header, and where the header's version stands in it."""

_OTHER_THAN_ACCELERATION = {6: "displacement", 7: "velocity"}


def format_of(data: bytes) -> str | None:
    """Return which of `FORMATS` a file is in, by its first bytes, or None."""
    start = data[:_SAC_HEADER]
    if _MSEED.match(start) and b"\0" in start:
        return "MSEED"
    if len(start) < _SAC_HEADER:
        return None
    versions = (struct.unpack_from(f"{order}i", start, _SAC_VERSION)[0] for order in "<>")
    return "SAC" if any(version in (6, 7) for version in versions) else None


def read(
    data: bytes, form: str, unit: str | None, dt: float | None, *, location: str | None
) -> list[Channel]:
    """Return the file's channels.

    Parameters
    ----------
    data : bytes
        What the file holds.
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
    try:
        from obspy import read as obspy_read
    except ImportError:
        raise absent(FORMATS[form], "ObsPy", "formats") from None
    try:
        traces: Any = obspy_read(BytesIO(data), format=form)
        lengths = [int(getattr(getattr(t.stats, "mseed", None), "record_length", 1)) for t in traces]
        if len(data) % min(lengths, default=1):
            raise InputError("motion.seismogram_unread")
        for trace in traces:
            kind = _OTHER_THAN_ACCELERATION.get(getattr(getattr(trace.stats, "sac", None), "idep", 0))
            if kind is not None:
                raise InputError("motion.not_acceleration", where="idep", quantity=phrase(f"motion.{kind}"))
            if values := other_instrument(trace):
                raise InputError("motion.other_instrument", **values)
            time_step(float(trace.stats.delta), dt)
        acceleration_unit(None, unit)  # asked for once the file is known to be of accelerometers
        return channels_of_traces(traces, unit or "", None, location)
    except InputError:
        raise
    except Exception:  # a broken file raises whatever it meets
        raise InputError("motion.seismogram_unread") from None
