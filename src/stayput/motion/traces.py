"""From ObsPy's traces to a motion; ObsPy itself is not needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError
from stayput.motion.channels import Channel, motion_of_channels
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    from collections.abc import Iterable

    from stayput.motion.record import Motion


def motion_of_traces(traces: Iterable[Any], unit: str, component: str | None, name: str | None) -> Motion:
    """Make a motion of traces; see `Motion.from_obspy`.

    Raises
    ------
    InputError
        No traces, gaps, different starts, an unknown unit or component.
    """
    factor = unit_factor(unit)
    pieces = list(traces)
    if not pieces:
        raise InputError("The stream has no traces; it must have one a channel.")
    channels: list[Channel] = []
    start = pieces[0].stats.starttime
    for trace in pieces:
        stats = trace.stats
        code, dt = str(stats.channel), float(stats.delta)
        if any(channel.label == code for channel in channels):
            raise InputError(
                f"The stream has more than one trace of {code!r}; merge it: it must have no gaps."
            )
        if np.ma.is_masked(trace.data):
            raise InputError(f"The trace of {code!r} has gaps; it must be complete.")
        if abs(float(stats.starttime - start)) > 0.01 * dt:
            raise InputError(
                f"The trace of {code!r} starts {float(stats.starttime - start):g} s after the first; "
                f"all must start together."
            )
        station = ".".join(part for part in (str(stats.network), str(stats.station)) if part)
        channels.append(Channel(code, factor * np.asarray(trace.data, dtype=np.float64), dt, name or station))
    return motion_of_channels(channels, component, f"ObsPy traces [{unit}]")
