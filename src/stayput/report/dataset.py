"""A run as an `xarray.Dataset`, with units in the attributes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.report.summary import sentence
from stayput.simulation.outcome import HISTORIES, QUANTITIES

if TYPE_CHECKING:
    from stayput.measures import DeviceResult
    from stayput.simulation.run import Run

_EVENT_VALUES = {
    "time": ("s", "time of the event"),
    "tilt": ("rad", "tilt just after the event"),
    "tilt_rate": ("rad/s", "tilt rate just after the event"),
    "slide": ("m", "slide just after the event"),
    "slide_rate": ("m/s", "slide rate just after the event"),
}

_DEVICE_VALUES = {
    "peak_pull": ("peak_pull", "N", "largest pull"),
    "peak_push": ("peak_push", "N", "largest push"),
    "peak_shear": ("peak_shear", "N", "largest shear"),
    "used": ("utilisation", "", "largest force over its strength; at least 1 where it failed"),
    "failed_at": ("failure_time", "s", "time at which it failed, or nan"),
}
"""Attribute of a device, unit and meaning of each of its values in the dataset."""


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
    for name, (_, unit, meaning) in HISTORIES.items():
        data[name] = ("time", getattr(run, name), {"units": unit, "long_name": meaning})
    data["mode"] = ("time", run.mode, {"long_name": "how the body moves"})
    for name, (unit, meaning) in _EVENT_VALUES.items():
        values = np.array([getattr(event, name) for event in run.events], dtype=np.float64)
        data[f"event_{name}"] = ("event", values, {"units": unit, "long_name": meaning})
    data["event_kind"] = ("event", np.array([event.kind.value for event in run.events], dtype=np.str_))
    data["event_mode"] = ("event", np.array([event.mode.value for event in run.events], dtype=np.str_))
    for column in QUANTITIES:
        if column.name not in ("outcome", "overturned", "events"):  # which are told above
            data[column.name] = ((), getattr(run, column.name), column.attributes)
    if run.devices:
        _add_devices(data, run.devices)
    return data


def _attributes(unit: str, meaning: str) -> dict[str, str]:
    return {"units": unit, "long_name": meaning} if unit else {"long_name": meaning}


def _add_devices(data: xr.Dataset, devices: tuple[DeviceResult, ...]) -> None:
    """Add the devices' results over ``device``, and their forces over ``time`` too."""
    names = [" ".join(filter(None, (device.kind, device.place))) for device in devices]
    data["device"] = ("device", np.array(names, dtype=np.str_), {"long_name": "measure and place"})
    for name, (attribute, unit, meaning) in _DEVICE_VALUES.items():
        values = np.array([getattr(device, attribute) for device in devices], dtype=np.float64)
        data[f"device_{name}"] = ("device", values, _attributes(unit, meaning))
    causes = np.array([device.cause or "" for device in devices], dtype=np.str_)
    data["device_cause"] = ("device", causes, {"long_name": "why it failed; empty where it holds"})
    for name, meaning in (("pull", "force along its normal, + pull"), ("shear", "force along its tangent")):
        forces = np.stack([getattr(device, name) for device in devices], axis=-1)
        data[f"device_{name}"] = (("time", "device"), forces, {"units": "N", "long_name": meaning})
