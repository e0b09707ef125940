"""Presets of furniture: common sizes and masses, as defaults to be changed, not citations."""

from __future__ import annotations

from dataclasses import dataclass, field

from stayput.model.body import MASS_RANGE, SIZE_RANGE
from stayput.model.parameters import parameter, quantity


@dataclass(frozen=True, slots=True)
class Preset:
    """A common piece of furniture, seen from its side.

    Parameters
    ----------
    width : float
        Depth of the piece, which is its base length along the shaking [m].
    height : float
        Height [m].
    length : float
        Length across the shaking [m].
    mass : float
        Mass as it usually stands, with its load [kg].
    carcass_mass : float, optional
        Mass when it is empty [kg], for pieces whose loads may be given shelf by shelf.
    """

    width: float = field(metadata=quantity("m", *SIZE_RANGE, ("width (depth)", "奥行き")))
    height: float = field(metadata=quantity("m", *SIZE_RANGE, ("height", "高さ")))
    length: float = field(metadata=quantity("m", *SIZE_RANGE, ("length (across)", "幅")))
    mass: float = field(metadata=quantity("kg", *MASS_RANGE, ("mass", "質量")))
    carcass_mass: float | None = parameter(None, "kg", *MASS_RANGE, ("empty carcass", "空の本体の質量"))


FURNITURE: dict[str, Preset] = {
    "bookcase": Preset(0.30, 1.80, 0.80, 200.0, carcass_mass=35.0),
    "empty bookcase": Preset(0.30, 1.80, 0.80, 35.0, carcass_mass=35.0),
    "wardrobe": Preset(0.60, 1.90, 1.00, 115.0),
    "cupboard": Preset(0.40, 1.80, 0.885, 100.0),
    "chest": Preset(0.42, 1.365, 0.885, 81.0),
    "refrigerator": Preset(0.68, 1.82, 0.65, 105.0),
    "television": Preset(0.27, 0.76, 1.23, 18.0),
    "vending machine": Preset(0.83, 1.83, 1.10, 350.0),
    "server rack": Preset(1.00, 2.00, 0.70, 500.0),
    "upright piano": Preset(0.62, 1.25, 1.50, 230.0),
}
"""Pieces of furniture by name: typical Japanese sizes; masses in the middle of the usual range."""
