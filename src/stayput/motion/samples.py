"""What a row of acceleration samples may be."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, within

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

STEP_RANGE = (1e-6, 1.0)
"""Smallest and largest time step that is accepted [s]."""

LARGEST_ACCELERATION = 1e4
"""Largest acceleration that is accepted [m/s²]."""

MOST_SAMPLES = 20_000_000
"""Largest number of samples that is accepted."""


def checked_samples(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return a read-only, contiguous copy of a row of accelerations [m/s²], shape (n,).

    Raises
    ------
    InputError
        Not one row of 2 or more finite, sane, real numbers without gaps.
    """
    if np.ma.is_masked(values):
        raise InputError(f"Motion {name} has gaps (masked samples); it must be complete.")
    try:
        given = np.asarray(values)
    except (TypeError, ValueError):
        raise InputError(f"Motion {name} is not an array; it must be one row of numbers [m/s²].") from None
    if given.dtype.kind not in "iuf":
        raise InputError(f"Motion {name} holds {given.dtype} values; it must be real numbers [m/s²].")
    if given.ndim != 1:
        raise InputError(f"Motion {name} has shape {given.shape}; it must be one row of samples.")
    if not 2 <= given.size <= MOST_SAMPLES:
        raise InputError(f"Motion {name} has {given.size} samples; it must have 2 to {MOST_SAMPLES}.")
    array = np.array(given, dtype=np.float64, order="C")
    bad = np.flatnonzero(~np.isfinite(array))
    if bad.size:
        raise InputError(f"Motion {name} is {array[bad[0]]} at sample {bad[0]}; it must be finite.")
    where = int(np.abs(array).argmax())
    within(
        f"Motion {name} at sample {where}", array[where], -LARGEST_ACCELERATION, LARGEST_ACCELERATION, "m/s²"
    )
    array.setflags(write=False)
    return array
