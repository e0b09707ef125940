"""Response spectra of rows of acceleration samples, by period and damping; Fourier spectra."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import not_allowed, numbers, within
from stayput.wording import check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

PERIODS: NDArray[np.float64] = np.geomspace(0.05, 10.0, 100)
"""Periods at which a spectrum is taken where nothing is said [s], shape (100,)."""
PERIODS.setflags(write=False)

DAMPING = 0.05
"""Damping ratio where nothing is said."""

PERIOD_RANGE = (1e-3, 1e3)
"""Shortest and longest period that is accepted [s]."""


SpectralResponse = Literal["sa", "sv", "sd", "psa", "psv", "sva"]
"""The largest responses that a `ResponseSpectrum` has, by their names there."""


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class ResponseSpectrum:
    """Largest responses of damped oscillators on the floor, over the length of the motion.

    The oscillators start at rest. The motion is linear between its samples and the responses are exact for it
    (Nigam and Jennings 1969), with their peaks between samples; nothing is sought after the motion's end (see
    `Motion.padded`).

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

    Examples
    --------
    >>> import stayput as sp
    >>> spectrum = sp.near_fault().spectrum(periods=[0.1, 0.5, 1.0])
    >>> spectrum.sa.round(1).tolist()
    [10.1, 17.1, 12.3]
    """

    periods: NDArray[np.float64]
    damping: float
    sd: NDArray[np.float64]
    sv: NDArray[np.float64]
    sa: NDArray[np.float64]
    sva: NDArray[np.float64]

    def __repr__(self) -> str:
        place = int(np.argmax(self.sa))
        first, last = float(self.periods[0]), float(self.periods[-1])
        return (
            f"ResponseSpectrum({len(self.periods)} periods from {first:g} to {last:g} s, "
            f"damping={self.damping:g}, largest Sa {self.sa[place]:.4g} m/s² at {self.periods[place]:.3g} s)"
        )

    def _repr_html_(self) -> str:
        from stayput.report.notebook import spectrum_html

        return spectrum_html(self)

    def plot(
        self, ax: Axes | None = None, *, what: SpectralResponse = "sa", language: str = "en", **line: Any
    ) -> Axes:
        """Draw one response over the period on logarithmic axes.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : str
            Absolute acceleration "sa", relative velocity "sv" or displacement "sd", pseudo-acceleration
            "psa" or -velocity "psv", or absolute velocity "sva".
        language : str
            Language of the texts, "en" or "ja".
        **line
            How the line looks, as for ``Axes.plot``.

        Raises
        ------
        InputError
            Another response.
        """
        from stayput.report.figures import plotted
        from stayput.report.spectra import draw_spectrum

        return plotted(ax, draw_spectrum, self, what, check_language(language), **line)

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
    row = np.atleast_1d(numbers("motion.name_period", periods, "periods"))
    for period in row.flat:
        within("motion.name_period", period, *PERIOD_RANGE, "s", "periods")
    if row.ndim != 1 or row.size == 0 or not np.all(np.diff(row) > 0.0):
        name = phrase("common.shape_of", name="periods")
        raise not_allowed(name, str(row.shape), "motion.rising_row", "periods")
    return row


def spectrum_of_samples(
    a: NDArray[np.float64], dt: float, periods: ArrayLike = PERIODS, damping: float = DAMPING
) -> ResponseSpectrum:
    """Return the response spectrum of an acceleration history.

    The oscillators start at rest. The acceleration is linear between its samples and the responses are
    exact for it (Nigam and Jennings 1969), with their peaks between samples; nothing is sought after its
    end.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time step [s].
    periods : array_like, shape (m,)
        Natural periods, increasing, 1e-3 to 1e3 s.
    damping : float
        Damping ratio, 0 to 0.95.

    Raises
    ------
    InputError
        Periods or a damping out of range.
    """
    from stayput.motion.oscillator import RESPONSES, peak_responses  # Numba takes its time to load

    checked = checked_periods(periods)
    zeta = within("motion.name_damping", damping, 0.0, 0.95, field="damping")
    peaks = np.empty((len(checked), RESPONSES))
    # The compiled function takes writable arrays alone; a motion's cannot be written to.
    peak_responses(a.copy(), dt, checked, zeta, peaks)
    sd, sv, sa, sva = (np.ascontiguousarray(column) for column in peaks.T)
    return ResponseSpectrum(checked, zeta, sd, sv, sa, sva)


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
