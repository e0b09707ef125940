"""The channels of ObsPy's traces."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError, InputWarning, warn
from stayput.motion.channels import Channel, labels_phrase
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    from collections.abc import Iterable

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
        if any(channel.label == code for channel in channels):
            raise InputError("motion.trace_repeated", channel=code)
        if np.ma.is_masked(trace.data):
            raise InputError("motion.trace_gaps", channel=code)
        if (kind := np.asarray(trace.data).dtype).kind not in "biuf":  # miniSEED may hold a text
            raise InputError("motion.samples_not_real", component=code, kind=kind.name)
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
        raise InputError("motion.no_traces")
    stations = list(dict.fromkeys(_station(trace.stats) for trace in items))
    if len(stations) > 1:
        raise InputError("motion.several_stations", one=stations[0], other=stations[1])
    codes = sorted({_location(trace.stats) for trace in items})
    wanted = codes[0] if location is None else location.strip() or _NO_LOCATION
    listed = labels_phrase(codes)
    if location is None and len(codes) > 1:
        about: dict[str, Any] = {"count": len(codes), "known": listed, "option": "location"}
        raise InputError("motion.several_locations", "location", **about)
    if wanted not in codes:
        raise InputError("motion.no_such_location", "location", location=location, known=listed)
    return [trace for trace in items if _location(trace.stats) == wanted]
