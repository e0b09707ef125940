"""A run as an `xarray.Dataset`, with units in the attributes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.quantities import COUNTS, HISTORIES, RESULTS
from stayput.report.summary import sentence

if TYPE_CHECKING:
    from stayput.simulation import Run

_EVENT_VALUES = {
    "time": ("s", "time of the event"),
    "tilt": ("rad", "tilt just after the event"),
    "tilt_rate": ("rad/s", "tilt rate just after the event"),
    "slide": ("m", "slide just after the event"),
    "slide_rate": ("m/s", "slide rate just after the event"),
}


def run_to_dataset(run: Run) -> xr.Dataset:
    """Return the histories over ``time``, the events over ``event``, and the results as scalars.

    Parameters
    ----------
    run : Run
        The run.

    Returns
    -------
    xarray.Dataset
        Every variable with a unit has ``units`` and ``long_name`` in its attributes.
    """
    data = xr.Dataset(
        coords={
            "time": ("time", run.time, {"units": "s", "long_name": "time since the record's first sample"})
        },
        attrs={
            "description": sentence(run),
            "outcome": run.outcome.value,
            "overturned": int(run.overturned),
            "contact": run.contact,
            "gravity": run.gravity,
            "motion": run.motion.name,
        },
    )
    for name, (unit, meaning) in HISTORIES.items():
        data[name] = ("time", getattr(run, name), {"units": unit, "long_name": meaning})
    data["mode"] = ("time", run.mode, {"long_name": "how the body moves"})
    for name, (unit, meaning) in _EVENT_VALUES.items():
        values = np.array([getattr(event, name) for event in run.events], dtype=np.float64)
        data[f"event_{name}"] = ("event", values, {"units": unit, "long_name": meaning})
    data["event_kind"] = ("event", np.array([event.kind.value for event in run.events], dtype=np.str_))
    data["event_mode"] = ("event", np.array([event.mode.value for event in run.events], dtype=np.str_))
    for name, (unit, meaning) in RESULTS.items():
        data[name] = ((), getattr(run, name), {"units": unit, "long_name": meaning})
    for name, meaning in COUNTS.items():
        data[name] = ((), getattr(run, name), {"long_name": meaning})
    return data
