"""Response spectra: what a motion does to oscillators of every period."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import repeat
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, within

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from stayput.motion.record import Motion

PERIODS: NDArray[np.float64] = np.geomspace(0.05, 10.0, 100)
"""Periods at which a spectrum is taken where nothing is said [s], shape (100,)."""
PERIODS.setflags(write=False)

DAMPING = 0.05
"""Damping ratio where nothing is said."""

PERIOD_RANGE = (1e-3, 1e3)
"""Shortest and longest period that is accepted [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class ResponseSpectrum:
    """Largest responses of damped oscillators on the floor, over the length of the motion.

    Parameters
    ----------
    periods : ndarray, shape (m,)
        Natural periods T [s].
    damping : float
        Damping ratio.
    sd : ndarray, shape (m,)
        Displacement relative to the floor [m].
    sv : ndarray, shape (m,)
        Velocity relative to the floor [m/s].
    sa : ndarray, shape (m,)
        Absolute acceleration [m/s²].
    sva : ndarray, shape (m,)
        Absolute velocity [m/s].
    """

    periods: NDArray[np.float64]
    damping: float
    sd: NDArray[np.float64]
    sv: NDArray[np.float64]
    sa: NDArray[np.float64]
    sva: NDArray[np.float64]

    @property
    def psv(self) -> NDArray[np.float64]:
        """Pseudo-velocity ω·Sd [m/s], shape (m,)."""
        return 2.0 * math.pi / self.periods * self.sd

    @property
    def psa(self) -> NDArray[np.float64]:
        """Pseudo-acceleration ω²·Sd [m/s²], shape (m,)."""
        return (2.0 * math.pi / self.periods) ** 2 * self.sd


def checked_periods(periods: ArrayLike) -> NDArray[np.float64]:
    """Return periods [s] as an increasing row of floats, shape (m,).

    Raises
    ------
    InputError
        No periods, or periods that are not increasing or out of range.
    """
    row = np.atleast_1d(np.array(periods, np.float64))
    if row.ndim != 1 or row.size == 0:
        raise InputError(f"The periods have shape {row.shape}; they must be one row of at least one.")
    for period in row:
        within("Period", period, *PERIOD_RANGE, "s")
    if not np.all(np.diff(row) > 0.0):
        raise InputError("The periods are not increasing; each must be longer than the one before it.")
    return row


def response_spectrum(
    motion: Motion,
    periods: ArrayLike = PERIODS,
    damping: float = DAMPING,
    component: str = "x",
) -> ResponseSpectrum:
    """Return the response spectrum of one component of a motion.

    The oscillators start at rest. The motion is linear between its samples and the responses are exact
    for it (Nigam and Jennings 1969), with their peaks between samples; nothing is sought after the
    motion's end (see `Motion.padded`).

    Parameters
    ----------
    motion : Motion
        The floor's motion.
    periods : array_like, shape (m,)
        Natural periods, increasing, 1e-3 to 1e3 s.
    damping : float
        Damping ratio, 0 to 0.95.
    component : str
        "x", "y" or "z".

    Raises
    ------
    InputError
        Periods or a damping out of range; a component that the motion has not.
    """
    from stayput.motion.oscillator import RESPONSES, peak_responses  # Numba takes its time to load

    row = checked_periods(periods)
    zeta = within("Damping ratio", damping, 0.0, 0.95)
    peaks = np.empty((len(row), RESPONSES))
    peak_responses(motion.component(component).x.copy(), motion.dt, row, zeta, peaks)
    sd, sv, sa, sva = (np.ascontiguousarray(column) for column in peaks.T)
    return ResponseSpectrum(row, zeta, sd, sv, sa, sva)


def spectra(
    motions: Sequence[Motion],
    periods: ArrayLike = PERIODS,
    damping: float = DAMPING,
    component: str = "x",
    *,
    threads: int | None = None,
) -> list[ResponseSpectrum]:
    """Return the response spectra of many motions, in their order, computed on several threads.

    Parameters
    ----------
    motions : sequence of Motion
        The motions.
    periods, damping, component
        As for `response_spectrum`.
    threads : int, optional
        Threads; as many as there are cores by default. The bits do not depend on them.
    """
    rows = checked_periods(periods)
    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(response_spectrum, motions, *map(repeat, (rows, damping, component))))
