"""Our stand-ins for the devices of the test: measures with values over the ranges of the literature.

The products' own values are not published. A pad's sides and thickness, a wedge's thickness, a pole's preload
and what the ceiling bears go over the usual ranges (defaults, low confidence): nothing is fitted to the test.
"""

from __future__ import annotations

from stayput.measures import GelMats, TensionPole, WedgeStopper
from stayput.verification import Option


def _mats(side: float, thickness: float) -> Option:
    name = f"mats {1e3 * side:g} × {1e3 * side:g} × {1e3 * thickness:g} mm"
    return Option(name, (GelMats(area=side * side, thickness=thickness),))


def _stopper(thickness: float) -> Option:
    return Option(f"stopper {1e3 * thickness:g} mm", (WedgeStopper(thickness=thickness),))


def _poles(preload: float, strength: float) -> Option:
    name = f"poles {preload:g} N, ceiling {strength:g} N"
    return Option(name, (TensionPole(preload=preload, strength=strength),))


NOTHING = Option("no device")

MATS = (_mats(0.03, 0.003), _mats(0.04, 0.004), _mats(0.05, 0.005))
"""Four pads each; 100 kPa in tension and 50 kPa in shear on the label, of which 0.7 are reached."""

STOPPERS = (_stopper(0.005), _stopper(0.010))
"""About 0.7° and 1.4° of tilt for a cupboard."""

POLES = (_poles(100.0, 300.0), _poles(200.0, 1000.0))
"""Two poles each: the lower and the upper ends of the usual preload and of what a ceiling bears."""

ALONE = (*MATS, *STOPPERS, *POLES)
"""The seven devices that are tested alone."""

TOGETHER = tuple(
    Option(f"{stopper.name} + {poles.name}", stopper.measures + poles.measures)
    for stopper in STOPPERS
    for poles in POLES
)
"""A stopper with poles."""

OPTIONS = (NOTHING, *ALONE, *TOGETHER)
"""All that is run."""
