"""The colours of every picture, in one place; safe for the common kinds of colour blindness.

The mode colours are those of Okabe and Ito (2008), *Color universal design*.
"""

from __future__ import annotations

from stayput.catalogue import say
from stayput.catalogue.names import STABILITY
from stayput.simulation.outcome import EventKind, Mode
from stayput.simulation.space_fate import Stability

STABILITY_COLOURS: dict[Stability, str] = {
    Stability.STAYS: "#dbe7ef",
    Stability.MOVES: "#7fc0ea",
    Stability.MAY_FALL: "#e08a00",
    Stability.FALLS: "#b03200",
}
"""Colour of a piece by how firmly it stands: each darker than the one before, cool while it stands."""

MODE_COLOURS: dict[Mode, str] = {
    Mode.REST: STABILITY_COLOURS[Stability.STAYS],
    Mode.SLIDE: "#56b4e9",
    Mode.ROCK: "#0072b2",
    Mode.SLIDE_ROCK: "#009e73",
    Mode.FLIGHT: "#cc79a7",
    Mode.LEAN: "#f0e442",
    Mode.OVERTURNED: STABILITY_COLOURS[Stability.FALLS],
}
"""Colour of each mode in a plot of histories."""

EVENT_MARKERS: dict[EventKind, tuple[str, str]] = {
    EventKind.FLOOR_IMPACT: ("v", "#1f2933"),
    EventKind.WALL_IMPACT: ("s", "#0072b2"),
    EventKind.CEILING_IMPACT: ("D", "#cc79a7"),
    EventKind.OVERTURNED: ("X", "#d55e00"),
    EventKind.FAILED: ("P", "#d55e00"),
}
"""Marker shape (Matplotlib's letters) and colour of the events that are marked."""

ROLE_COLOURS: dict[str, str] = {
    "tie": "#0072b2",
    "pad": "#cc79a7",
    "rubber": "#8c5a2b",
    "metal": "#3b4cc0",
    "wheel": "#4a5560",
    "mass": "#6b4f8a",
}
"""Colour of what devices are made of."""

INK = "#1f2933"
"""Lines of histories and outlines, and text."""

MUTED = "#6b7580"
"""Reference lines and secondary text."""

FAINT = "#dfe3e8"
"""Grids and the still background."""

ROOM = "#8d99a6"
"""Floor slab, walls and ceiling."""

PAPER = "#ffffff"
"""Background."""

ALARM = "#d55e00"
"""Time cursor and overturning."""

LINE_COLOURS = ("#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#d55e00", "#0072b2")
"""Colours of the lines of several pieces, one after the other."""

COMPONENT_COLOURS: dict[str, str] = {"x": "#0072b2", "y": "#009e73", "z": "#cc79a7"}
"""Colour of each component of a motion."""


def rgb(colour: str) -> tuple[int, int, int]:
    """Red, green and blue, 0 to 255, of a colour written ``#rrggbb``."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def stability_looks(language: str) -> dict[Stability, tuple[str, str]]:
    """Return name and colour of each step of the scale, in "en" or "ja"."""
    return {step: (say(STABILITY[step], language), colour) for step, colour in STABILITY_COLOURS.items()}
