"""A file's unit and time step: the file's own, or the caller's where the file is silent."""

from __future__ import annotations

import math

from stayput.errors import InputError, within
from stayput.motion.samples import STEP_RANGE
from stayput.motion.units import ACCELERATION_UNITS, unit_factor


def acceleration_unit(stated: str | None, given: str | None) -> float:
    """Return the size of the unit of a file's numbers [m/s²].

    Parameters
    ----------
    stated : str, optional
        Unit that the file states.
    given : str, optional
        Unit that the caller states.

    Raises
    ------
    InputError
        Neither does, they contradict each other, or the name is unknown.
    """
    if stated is None and given is None:
        raise InputError(
            f"The file states no unit; unit must be given as one of {', '.join(ACCELERATION_UNITS)}."
        )
    if stated is not None and given is not None and unit_factor(stated) != unit_factor(given):
        raise InputError(
            f"The unit is given as {given!r}; it must be the one that the file states, {stated!r}."
        )
    return unit_factor(stated if stated is not None else given or "")


def time_step(stated: float | None, given: float | None) -> float:
    """Return the time step of a file's samples [s], with the same rules."""
    if stated is None and given is None:
        raise InputError("The file states no time step; dt must be given [s].")
    if stated is not None and given is not None and not math.isclose(stated, given, rel_tol=1e-4):
        raise InputError(
            f"The dt is given as {given:g} s; it must be the one that the file states, {stated:g} s."
        )
    return within("The time step", stated if stated is not None else given or 0.0, *STEP_RANGE, "s")
