"""Response spectra of motions, of one and of many at once; Fourier spectra, and the mean period."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from stayput.execution import Pool
from stayput.motion.record import Motion
from stayput.motion.response import DAMPING, PERIODS, ResponseSpectrum, checked_periods

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

__all__ = ["DAMPING", "PERIODS", "ResponseSpectrum", "response_spectrum", "spectra"]


def response_spectrum(
    motion: Motion, periods: ArrayLike = PERIODS, damping: float = DAMPING, component: str = "x"
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

    Examples
    --------
    >>> import stayput as sp
    >>> sp.response_spectrum(sp.near_fault(), periods=[1.0]).sa.round(2).tolist()
    [12.34]
    """
    return Motion.given(motion).spectrum(periods, damping, component)


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
    checked = checked_periods(periods)
    with Pool(threads) as pool:
        calls = (partial(response_spectrum, motion, checked, damping, component) for motion in motions)
        return list(pool.in_order(calls))


def fourier_amplitude(a: NDArray[np.float64], dt: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the frequencies [Hz] and the amplitude of the Fourier integral |∫a e^(−2πift) dt| there [m/s].

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time between samples [s].

    Returns
    -------
    tuple of ndarray, shape (n // 2 + 1,)
        From 0 to the Nyquist frequency, in steps of 1/(n dt).
    """
    return np.fft.rfftfreq(len(a), dt).astype(np.float64), dt * np.abs(np.fft.rfft(a))


def konno_ohmachi(
    frequencies: NDArray[np.float64], amplitude: NDArray[np.float64], at: NDArray[np.float64], b: float = 20.0
) -> NDArray[np.float64]:
    """Return an amplitude spectrum smoothed over equal parts of the logarithm of frequency.

    The window is [sin(b log₁₀ f/fc) / (b log₁₀ f/fc)]⁴ (Konno and Ohmachi 1998).

    Parameters
    ----------
    frequencies, amplitude : ndarray, shape (n,)
        The spectrum; 0 Hz is left out.
    at : ndarray, shape (m,)
        Frequencies fc at which it is wanted [Hz].
    b : float
        Bandwidth; 20 is strong smoothing, 40 weaker.
    """
    f, size = frequencies[frequencies > 0.0], amplitude[frequencies > 0.0]
    log_f = np.log10(f)
    smooth = np.empty(len(at))
    for i, centre in enumerate(np.log10(at)):
        weight = np.sinc(b / np.pi * (log_f - centre)) ** 4
        smooth[i] = float((weight * size).sum() / weight.sum())
    return smooth


def mean_period(a: NDArray[np.float64], dt: float) -> float:
    """Return Tm = Σ C²/f / Σ C² over 0.25 to 20 Hz, C the Fourier amplitudes [s]; NaN of a still floor.

    Rathje, Abrahamson and Bray (1998). A motion shorter than 4 s holds no such low frequencies: what it has
    is taken.
    """
    f, amplitude = fourier_amplitude(a, dt)
    band = (f >= 0.25) & (f <= 20.0)
    power = amplitude[band] ** 2
    total = float(power.sum())
    return float((power / f[band]).sum()) / total if total > 0.0 else float("nan")
