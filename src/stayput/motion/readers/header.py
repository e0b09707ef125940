"""A file's unit and time step: as its header states them, else as the caller gives them."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, InputWarning, excerpt, warn, within
from stayput.motion.processing import STEP_RANGE
from stayput.motion.units import UNIT_NAMES, unit_factor

if TYPE_CHECKING:
    from numpy.typing import NDArray

_STATED = re.compile(r"(?:\bUNITS?(?: ?[:=] ?| OF )|単位 ?[:=：（(]? ?)([^\s,;)、。）]{1,40})", re.IGNORECASE)
_STEP_TOLERANCE = 1e-4
"""Relative difference up to which two time steps are the same one, rounded to five digits or more."""

_ROUNDING_OF_TIMES = 0.2
"""Error of a printed time, in time steps, that is taken for rounding; a missing sample is one of 1."""

_PER_SECOND_TWICE = r"/s(?:ec)?(?:/s(?:ec)?|²|\^?2|\*\*2)"
_MENTIONED = re.compile(
    rf"(?<![a-z])(gals?|[cm]?m{_PER_SECOND_TWICE})(?![a-z0-9/^²*])|[(\[_](g)(?:[)\]]|(?![a-z0-9/^²*]))",
    re.IGNORECASE,
)


def stated_unit(header: str) -> str | None:
    """Return the unit that a header states in so many words: "unit: gal", "UNITS OF G"."""
    match = _STATED.search(" ".join(header.split()))
    return match[1].rstrip(".") if match else None


def mentioned_unit(header: str) -> str | None:
    """Return the one unit of acceleration that a header mentions: "acc_gal", "PGA [cm/s²]"."""
    names = {(m[1] or m[2]).lower() for m in _MENTIONED.finditer(header)}
    return names.pop() if len({unit_factor(name) for name in names}) == 1 else None


def acceleration_unit(
    stated: str | None, given: str | None, header: str = "", *, step_missing: bool = False
) -> float:
    """Return the size of the unit of a file's numbers [m/s²].

    Parameters
    ----------
    stated : str, optional
        Unit that the file states.
    given : str, optional
        Unit that the caller states.
    header : str
        What the file says besides; a unit that it mentions is not taken, but compared.
    step_missing : bool
        Whether the time step must be given too, so that the refusal asks for both at once.

    Raises
    ------
    InputError
        Neither does, they contradict each other, or the name is unknown.
    """
    mentioned = None if stated is not None else mentioned_unit(header)
    if stated is None and given is None:
        if mentioned is not None:
            raise InputError("motion.no_unit_but_mentioned", "unit", mentioned=mentioned, known=UNIT_NAMES)
        if step_missing:
            raise InputError("motion.no_unit_nor_step", "unit", known=UNIT_NAMES)
        raise InputError("motion.no_unit", "unit", known=UNIT_NAMES)
    if stated is not None and given is not None and unit_factor(stated) != unit_factor(given):
        raise InputError("motion.another_unit", "unit", given=given, stated=excerpt(stated))
    factor = unit_factor(stated if stated is not None else given or "")
    if mentioned is not None and unit_factor(mentioned) != factor:
        warn(InputWarning("motion.unit_mentioned", "unit", given=given, mentioned=mentioned))
    return factor


def time_step(stated: float | None, given: float | None) -> float:
    """Return the time step of a file's samples [s]; arguments and errors as for `acceleration_unit`."""
    if stated is None and given is None:
        raise InputError("motion.no_time_step", "dt")
    if stated is not None and given is not None and not math.isclose(stated, given, rel_tol=_STEP_TOLERANCE):
        raise InputError("motion.another_time_step", "dt", given=given, stated=stated)
    step = stated if stated is not None else given or 0.0
    return within("motion.name_time_step", step, *STEP_RANGE, "s", "dt")


def regular_step(time: NDArray[np.float64]) -> float:
    """Return the step of equally spaced times [s]; they may be rounded to a fifth of it.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Times [s], n ≥ 2.

    Raises
    ------
    InputError
        The times do not grow, or not by equal steps.
    """
    n = len(time)
    step = float(time[-1] - time[0]) / (n - 1)
    if not step > 0.0:
        raise InputError("motion.time_not_growing", start=float(time[0]), end=float(time[-1]))
    error = np.abs(time - (time[0] + step * np.arange(n)))
    if error.max() > _ROUNDING_OF_TIMES * step:
        worst = int(error.argmax())
        raise InputError("motion.irregular_sampling", time=float(time[worst]))
    # Printed times are rounded, and so is the step that they give: 0.0099999 s of 0.01 s. The shortest
    # decimal that keeps the last sample within a thousandth of a step is what was meant.
    for digits in range(1, 12):
        nominal = round(step, digits)
        if nominal > 0.0 and abs(nominal - step) * (n - 1) <= 1e-3 * step + 1e-9:
            return nominal
    return step
