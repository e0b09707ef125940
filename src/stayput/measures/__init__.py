"""What holds furniture: earthquake-proof measures as changed bodies, rooms and force elements."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.measures.edges import GelMats, WedgeStopper
from stayput.measures.element import DeviceResult, Element
from stayput.measures.floor import (
    AntiSlipSheet,
    BaseIsolator,
    FeltGlides,
    FreeCasters,
    LockedCasters,
    SlidingGlides,
)
from stayput.measures.measure import BadlyInstalled, Held, Measure, Sets, element_rows, hold
from stayput.measures.place import AgainstWall, AwayFromWall, Ballast, LowerShelves
from stayput.measures.pole import TensionPole
from stayput.measures.sketch import Shape, sketch
from stayput.measures.wall import Belt, Chain, LBracket, LBracketInBoard
from stayput.model.parameters import Parameter, parameters

if TYPE_CHECKING:
    from collections.abc import Callable

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


def sets_of(where: Callable[[type[Measure]], Sets]) -> list[tuple[str, ...]]:
    """Return the sets of kinds that an attribute of the measures names: first those of one measure."""
    return sorted(
        ((kind, *others) for kind, measure in MEASURES.items() for others in where(measure)), key=len
    )


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
    "sketch",
]
