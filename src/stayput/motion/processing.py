"""What changes a record's samples on request: another time step, a baseline correction."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from stayput.errors import InputError
from stayput.motion.integrals import velocity
from stayput.motion.samples import MOST_SAMPLES

if TYPE_CHECKING:
    from numpy.typing import NDArray

_KAISER_BETA = 8.0
"""Kaiser window of the anti-alias filter: about 80 dB of stop band."""

_TAPS_PER_STEP = 24
"""Half-length of the anti-alias filter, in steps of the coarser record."""


def whole_ratio(larger: float, smaller: float) -> int:
    """Return the whole number larger/smaller, or 0 when it is not whole (to 1e-6)."""
    ratio = larger / smaller
    nearest = round(ratio)
    return nearest if nearest >= 1 and abs(ratio - nearest) <= 1e-6 * nearest else 0


def refine(a: NDArray[np.float64], parts: int) -> NDArray[np.float64]:
    """Return the same piecewise linear function with each step cut into ``parts``, shape ((n−1)·parts+1,)."""
    if (len(a) - 1) * parts >= MOST_SAMPLES:
        raise InputError(
            f"The finer record would have {(len(a) - 1) * parts + 1} samples; {MOST_SAMPLES} are allowed."
        )
    steps = np.arange(parts) / parts
    cut = a[:-1, None] + np.diff(a)[:, None] * steps
    return np.append(cut.ravel(), a[-1])


def coarsen(a: NDArray[np.float64], steps: int) -> NDArray[np.float64]:
    """Return every ``steps``-th sample after a low-pass that removes what the new step cannot show.

    The filter is a zero-phase windowed sinc with its −6 dB point at 0.8 of the new Nyquist frequency
    and unit gain at zero frequency; beyond its ends the record is continued by its end values.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²].
    steps : int
        Ratio of the time steps, ≥ 2.

    Raises
    ------
    InputError
        Fewer than two samples would be left.
    """
    if len(a) <= steps:
        raise InputError(
            f"The record has {len(a)} samples; a step {steps} times as long needs at least {steps + 1}."
        )
    half = _TAPS_PER_STEP * steps
    window = np.kaiser(2 * half + 1, _KAISER_BETA)
    taps = np.sinc(0.8 / steps * np.arange(-half, half + 1)) * window
    taps /= taps.sum()
    reaches = sliding_window_view(np.pad(a, half, mode="edge"), len(taps))
    return reaches[::steps] @ taps


def without_baseline(a: NDArray[np.float64], dt: float, order: int) -> NDArray[np.float64]:
    """Return the acceleration less the polynomial that takes the trend out of the velocity.

    The polynomial p of the given order is the one whose integral, zero at t = 0, fits the velocity
    best in the least-squares sense.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time step [s].
    order : int
        0 removes a constant, 1 a line, 2 a parabola, ...
    """
    t = np.linspace(0.0, 1.0, len(a))
    powers = np.arange(1, order + 2)
    fit = np.linalg.lstsq(t[:, None] ** powers, velocity(a, dt), rcond=None)[0]
    length = dt * (len(a) - 1)
    return a - (t[:, None] ** (powers - 1)) @ (fit * powers) / length
