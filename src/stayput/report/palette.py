"""The colours of every picture, in one place; safe for the common kinds of colour blindness.

The mode colours are those of Okabe and Ito (2008), *Color universal design*.
"""

from __future__ import annotations

from stayput.catalogue import say
from stayput.catalogue.names import MODES
from stayput.simulation.outcome import EventKind, Mode

MODE_COLOURS: dict[Mode, str] = {
    Mode.REST: "#b9bec5",
    Mode.SLIDE: "#56b4e9",
    Mode.ROCK: "#e69f00",
    Mode.SLIDE_ROCK: "#009e73",
    Mode.FLIGHT: "#cc79a7",
    Mode.LEAN: "#f0e442",
    Mode.OVERTURNED: "#d55e00",
}
"""Colour of each mode."""

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

BODY_COLOURS = ("#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#d55e00", "#0072b2")
"""Colours of bodies in space, one after the other."""

COMPONENT_COLOURS: dict[str, str] = {"x": "#0072b2", "y": "#009e73", "z": "#cc79a7"}
"""Colour of each component of a motion."""


def rgb(colour: str) -> tuple[int, int, int]:
    """Red, green and blue, 0 to 255, of a colour written ``#rrggbb``."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def mode_looks(language: str) -> dict[str, dict[str, str]]:
    """Return colour and name of each mode, for a page in a language.

    Parameters
    ----------
    language : str
        "en" or "ja".
    """
    return {
        mode.value: {"colour": colour, "label": say(MODES[mode], language)}
        for mode, colour in MODE_COLOURS.items()
    }
