"""Units of acceleration, by the names that records and their users write."""

from __future__ import annotations

from stayput.errors import InputError

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s²]: one "g" of a record, and the default of a simulation."""

ACCELERATION_UNITS = {"m/s²": 1.0, "cm/s²": 0.01, "gal": 0.01, "mm/s²": 0.001, "g": STANDARD_GRAVITY}
"""Size of each accepted unit [m/s²]."""


def unit_factor(unit: str) -> float:
    """Return the size of a unit of acceleration [m/s²].

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
    plain = plain.replace("sec", "s").replace("gals", "gal")
    for ending in ("/s/s", "/s**2", "/s^2", "/s2"):
        if plain.endswith(ending):
            plain = plain.removesuffix(ending) + "/s²"
    if plain not in ACCELERATION_UNITS:
        raise InputError(
            f"The unit of acceleration is {unit!r}; it must be one of {', '.join(ACCELERATION_UNITS)}."
        )
    return ACCELERATION_UNITS[plain]
