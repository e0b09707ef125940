"""Presets of contents: usual sizes and friction, as defaults to be changed, not citations."""

from __future__ import annotations

from dataclasses import dataclass, field

from stayput.model.body import SIZE_RANGE
from stayput.model.parameters import quantity
from stayput.model.room import FRICTION_RANGE

_SIZE = ("m", *SIZE_RANGE)


@dataclass(frozen=True, slots=True)
class ContentsKind:
    """What stands on a shelf, seen from the side of the furniture.

    Parameters
    ----------
    width : float
        Depth of an item, which lies along the shaking [m].
    height : float
        Its height [m].
    static_friction, kinetic_friction : float
        Friction on the shelf.
    setback : float
        Distance from the front edge of the shelf to the items [m].
    mass_share : float
        Mass of all contents as a part of the loaded furniture's.
    """

    width: float = field(metadata=quantity(*_SIZE, ("item depth", "物の奥行き")))
    height: float = field(metadata=quantity(*_SIZE, ("item height", "物の高さ")))
    static_friction: float = field(
        metadata=quantity("", *FRICTION_RANGE, ("static friction", "静止摩擦係数"))
    )
    kinetic_friction: float = field(
        metadata=quantity("", *FRICTION_RANGE, ("kinetic friction", "動摩擦係数"))
    )
    setback: float = field(metadata=quantity("m", 0.0, 10.0, ("setback from the edge", "棚の縁からの距離")))
    mass_share: float = field(metadata=quantity("", 0.0, 0.99, ("share of the mass", "質量の割合")))


CONTENTS: dict[str, ContentsKind] = {
    "books": ContentsKind(0.15, 0.21, 0.35, 0.30, 0.03, 0.80),
    "files": ContentsKind(0.24, 0.31, 0.35, 0.30, 0.02, 0.75),
    "dishes": ContentsKind(0.20, 0.12, 0.25, 0.20, 0.05, 0.50),
    "bottles": ContentsKind(0.08, 0.28, 0.30, 0.25, 0.05, 0.50),
    "boxes": ContentsKind(0.28, 0.25, 0.42, 0.38, 0.02, 0.60),
    "pallet loads": ContentsKind(1.00, 1.20, 0.41, 0.37, 0.05, 0.85),
}
"""Contents by name.

The friction of pallet loads lies within the 0.37 to 0.45 that Sideris and Filiatrault (2010) measured; boxes
have about the same. All other numbers are usual values of low confidence.
"""
