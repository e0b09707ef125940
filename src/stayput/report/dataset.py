"""A run as a dataset of xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.report.summary import EVENT_VALUES, sentence
from stayput.simulation.outcome import HISTORIES, QUANTITIES

if TYPE_CHECKING:
    import xarray as xr

    from stayput.measures import DeviceResult
    from stayput.simulation.run import Run

_DEVICE_VALUES = {
    "peak_pull": ("peak_pull", "N", "largest pull"),
    "peak_push": ("peak_push", "N", "largest push"),
    "peak_shear": ("peak_shear", "N", "largest shear"),
    "used": ("utilisation", "", "largest force over its strength; at least 1 where it failed"),
    "failed_at": ("failure_time", "s", "time at which it failed, or nan"),
}
"""Attribute of a device, unit and meaning of each of its values in the dataset."""


def run_to_dataset(run: Run) -> xr.Dataset:
    """Return histories over ``piece`` and ``time``, results over ``piece``, and the events over ``event``.

    Parameters
    ----------
    run : Run
        The run.

    Returns
    -------
    xarray.Dataset
        Every variable with a unit has ``units`` and ``long_name`` in its attributes.
    """
    import xarray as xr  # which takes its time to load

    moved = ("piece", "time")
    histories: dict[str, tuple[tuple[str, ...], Any, str, str]] = {
        "place": ((*moved, "axis"), run.place, "m", "centre of gravity, in axes that move with the floor"),
        "attitude": ((*moved, "part"), run.attitude, "", "unit quaternion that turns the piece's frame"),
        "velocity": ((*moved, "axis"), run.velocity, "m/s", "rate of the place"),
        "rotation_rate": ((*moved, "axis"), run.rotation_rate, "rad/s", "along the room's axes"),
        "tilt": (moved, [piece.tilt for piece in run.pieces], "rad", "angle from rest"),
        "yaw": (moved, [piece.yaw for piece in run.pieces], "rad", "turn about the vertical"),
        "slide": (moved, [piece.slide for piece in run.pieces], "m", "how far the base has slid or rolled"),
        "slide_in_plan": (
            (*moved, "level_axis"),
            [piece.slide_in_plan for piece in run.pieces],
            "m",
            "the same along x and y",
        ),
    }
    if run.engine == "plane":
        histories["slide_rate"] = (("time",), run.slide_rate, *HISTORIES["slide_rate"][1:])
        histories["mode"] = (("time",), run.mode, "", "how the body moves")
    else:
        pressing = "force of the room, and of other bodies, on a piece"
        histories["force"] = ((*moved, "by", "axis"), run.force, "N", pressing)
    data = xr.Dataset(
        {name: (dims, values, _attributes(*about)) for name, (dims, values, *about) in histories.items()},
        {
            "time": ("time", run.time, _attributes("s", "time since the record's first sample")),
            "piece": list(run.names),
            "axis": list("xyz"),
            "level_axis": list("xy"),
            "part": list("wxyz"),
            **({"by": ["room", "bodies"]} if run.engine == "space" else {}),
        },
        {"description": sentence(run), "motion": run.motion.name, "engine": run.engine},
    )
    data["outcome"] = ("piece", [piece.outcome.value for piece in run.pieces])
    for column in QUANTITIES:
        if column.name.startswith("device_"):
            data[column.name] = ((), getattr(run, column.name), column.attributes)
        elif column.name not in ("outcome", "events"):
            values = [getattr(piece, column.name) for piece in run.pieces]
            data[column.name] = ("piece", values, column.attributes)
    fell = _attributes("s", "time at which it fell off what it stood on, or nan")
    data["fall_time"] = ("piece", [piece.fall_time for piece in run.pieces], fell)
    if run.engine == "plane":
        _add_events(data, run)
    if run.devices:
        _add_devices(data, run.devices)
    return data


def _add_events(data: xr.Dataset, run: Run) -> None:
    """Add the events over ``event``."""
    for name, about in EVENT_VALUES.items():
        values = np.array([getattr(event, name) for event in run.events], dtype=np.float64)
        data[f"event_{name}"] = ("event", values, _attributes(*about))
    for name in ("kind", "mode"):
        words = [getattr(event, name).value for event in run.events]
        data[f"event_{name}"] = ("event", np.array(words, dtype=np.str_))


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
