"""Units of acceleration, by the names that records and their users write."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.errors import InputError, excerpt
from stayput.model.gravity import STANDARD_GRAVITY

if TYPE_CHECKING:
    from stayput.catalogue import Phrase

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
