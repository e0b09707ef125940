"""What is known of a run: histories and results, with their units and meanings, for every table of them."""

from __future__ import annotations

HISTORIES: dict[str, tuple[str, str]] = {
    "slide": ("m", "displacement of the base relative to the floor, + right"),
    "slide_rate": ("m/s", "rate of the slide"),
    "tilt": ("rad", "rotation, + clockwise"),
    "tilt_rate": ("rad/s", "rate of the tilt"),
    "x": ("m", "centre of gravity right of where the middle of the base stood"),
    "z": ("m", "centre of gravity above the floor"),
}
"""Unit and meaning of each history."""

RESULTS: dict[str, tuple[str, str]] = {
    "overturn_time": ("s", "time at which the tilt reached 90°, or nan"),
    "peak_slide": ("m", "largest magnitude of the slide"),
    "residual_slide": ("m", "slide at the end"),
    "peak_tilt": ("rad", "largest magnitude of the tilt"),
    "residual_tilt": ("rad", "tilt at the end"),
    "device_failure_time": ("s", "time at which the first device failed, or nan"),
    "device_utilisation": ("", "largest force in a device over its strength; at least 1 where one failed"),
}
"""Unit and meaning of each result that is a quantity."""

COUNTS: dict[str, str] = {
    "floor_impacts": "landings on the floor",
    "wall_impacts": "hits on the walls and the ceiling",
    "device_failures": "devices that failed",
}
"""Meaning of each result that is a number of events."""
