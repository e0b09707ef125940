"""Histories as second differences of whole numbers, which compress to half of the numbers themselves."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from stayput.report.scene import LENGTH_DIGITS, TIME_DIGITS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

DIGITS = {
    "time_s": TIME_DIGITS,
    **dict.fromkeys(
        (
            "x_m",
            "z_m",
            "tilt_rad",
            "slide_m",
            "yaw_rad",
            "place_m",
            "attitude",
            "shift_m",
            "ground_x_m",
            "roof_x_m",
        ),
        LENGTH_DIGITS,
    ),
    **dict.fromkeys(("acceleration_m_s2", "x", "y", "z"), 3),
    **dict.fromkeys(("pull_n", "shear_n"), 1),
}
"""The histories of a reply by their names, and their digits; x, y and z are accelerations."""

WIDTHS = {"place_m": 3, "attitude": 4, "shift_m": 3}
"""How many numbers there are at each time, where it is not one."""


def with_differences(reply: Mapping[str, Any]) -> dict[str, Any]:
    """Return a reply about runs with its histories as differences.

    A list of numbers has no more digits than are kept, so that the differences give the same numbers to the
    bit. What is in base 64 is rounded.

    Parameters
    ----------
    reply : mapping
        The reply as plain values.
    """
    return {name: _changed(name, value) for name, value in reply.items()}


def _changed(name: str, value: Any) -> Any:
    if isinstance(value, dict):
        return with_differences(cast("dict[str, Any]", value))
    if name in DIGITS and isinstance(value, str):
        return _differences(name, np.frombuffer(base64.b64decode(value), "<f4"))
    if not isinstance(value, list):
        return value
    values = cast("list[Any]", value)
    if name in DIGITS and all(isinstance(one, int | float) for one in values):
        return _differences(name, np.array(values, dtype=np.float64))
    return [with_differences(cast("dict[str, Any]", one)) if isinstance(one, dict) else one for one in values]


def _differences(name: str, values: NDArray[np.floating]) -> dict[str, Any]:
    width, digits = WIDTHS.get(name, 1), DIGITS[name]
    whole = np.rint(values.astype(np.float64).reshape(-1, width) * 10.0**digits).astype(np.int64)
    start = np.zeros((1, width), dtype=np.int64)
    second = np.diff(np.diff(whole, axis=0, prepend=start), axis=0, prepend=start)
    return {"digits": digits, "width": width, "second_differences": second.ravel().tolist()}
