"""What holds furniture: earthquake-proof measures as changed bodies, rooms and force elements."""

from __future__ import annotations

from stayput.measures.bracket import LBracket, LBracketInBoard
from stayput.measures.element import Element
from stayput.measures.floor import AntiSlipSheet, FeltGlides, FreeCasters, LockedCasters, SlidingGlides
from stayput.measures.gel import GelMats
from stayput.measures.isolator import BaseIsolator
from stayput.measures.mass import Ballast, LowerShelves
from stayput.measures.measure import BadlyInstalled, Held, Measure, element_rows, hold
from stayput.measures.place import AgainstWall, AwayFromWall
from stayput.measures.pole import TensionPole
from stayput.measures.results import DeviceResult
from stayput.measures.sketch import Shape, shapes, sketch
from stayput.measures.tie import Belt, Chain
from stayput.measures.wedge import WedgeStopper
from stayput.model.parameters import Parameter, parameters

MEASURES: dict[str, type[Measure]] = {
    measure.kind: measure
    for measure in (
        AntiSlipSheet,
        FeltGlides,
        SlidingGlides,
        GelMats,
        WedgeStopper,
        LBracket,
        LBracketInBoard,
        Belt,
        Chain,
        TensionPole,
        FreeCasters,
        LockedCasters,
        Ballast,
        LowerShelves,
        AgainstWall,
        AwayFromWall,
        BaseIsolator,
    )
}
"""All measures, by their names in a scenario."""

__all__ = [
    "MEASURES",
    "AgainstWall",
    "AntiSlipSheet",
    "AwayFromWall",
    "BadlyInstalled",
    "Ballast",
    "BaseIsolator",
    "Belt",
    "Chain",
    "DeviceResult",
    "Element",
    "FeltGlides",
    "FreeCasters",
    "GelMats",
    "Held",
    "LBracket",
    "LBracketInBoard",
    "LockedCasters",
    "LowerShelves",
    "Measure",
    "Parameter",
    "Shape",
    "SlidingGlides",
    "TensionPole",
    "WedgeStopper",
    "element_rows",
    "hold",
    "parameters",
    "shapes",
    "sketch",
]
