"""Units of acceleration, by the names that records and their users write."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.errors import InputError, excerpt
from stayput.model.parameters import Parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s²]: one "g" of a record, and the default of a simulation."""

GRAVITY = Parameter("gravity", STANDARD_GRAVITY, "m/s²", 0.01, 1e3, ("Gravity", "重力加速度"))
"""Acceleration of gravity where a function asks for it."""

ACCELERATION_UNITS = {"m/s²": 1.0, "cm/s²": 0.01, "gal": 0.01, "mm/s²": 0.001, "g": STANDARD_GRAVITY}
"""Size of each accepted unit [m/s²]."""

UNIT_NAMES: Phrase = ", ".join(ACCELERATION_UNITS), "、".join(ACCELERATION_UNITS)
"""The accepted units, as a sentence lists them."""


def unit_name(unit: str) -> str:
    """Return the name that `ACCELERATION_UNITS` has for a unit of acceleration.

    Parameters
    ----------
    unit : str
        A name of `ACCELERATION_UNITS` in any spelling that is in use: ``cm/s2``, ``cm/s/s``,
        ``CM/SEC/SEC``, ``gal(cm/s/s)``, ...

    Raises
    ------
    InputError
        The name is none of them.
    """
    plain = str(unit).lower().split("(")[0].replace(" ", "").rstrip(".")
    plain = plain.replace("sec", "s").replace("gals", "gal").replace("ガル", "gal")
    for ending in ("/s/s", "/s**2", "/s^2", "/s2"):
        if plain.endswith(ending):
            plain = plain.removesuffix(ending) + "/s²"
    if plain not in ACCELERATION_UNITS:
        raise InputError("motion.unknown_unit", "unit", unit=excerpt(str(unit)), known=UNIT_NAMES)
    return plain


def unit_factor(unit: str) -> float:
    """Return the size of a unit of acceleration [m/s²]; argument and errors as for `unit_name`."""
    return ACCELERATION_UNITS[unit_name(unit)]
