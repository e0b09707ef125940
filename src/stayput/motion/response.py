"""Response spectra of rows of acceleration samples, by period and damping; Fourier spectra.

A damped oscillator stands on a floor whose acceleration is linear between samples, without approximation:

    ü + 2ζω u̇ + ω²u = −a(t),    a(τ) = a₀ + (a₁ − a₀) τ/h   for 0 ≤ τ ≤ h

u is the displacement relative to the floor. Over a step the solution is a line plus a damped sine, so that
(u, u̇) at its end is a linear function of (u, u̇, a₀, a₁) at its start (Nigam and Jennings 1969).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import phrase
from stayput.compiling import entry, inline, inner
from stayput.errors import not_allowed, numbers, within
from stayput.mechanics.elementary import exponential, sine_and_cosine
from stayput.wording import check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes


STEPS_IN_A_PERIOD = 20.0
"""Fewest steps in a period: what is between them is a peak to 3e-5."""

STEPS_OF_A_VECTOR = 100.0
"""Fewest steps in a period where two components are added: their largest sum is then met to 5e-4."""

RESPONSES = 4
"""What `peak_responses` finds: peaks of u, of u̇, of ü + a, and of u̇ + the floor's velocity."""


@inner
def step_coefficients(omega: float, zeta: float, h: float) -> tuple[float, ...]:
    """Coefficients of (u, u̇, a₀, a₁) in u at the end of a step, then in u̇ there; ω > 0, 0 ≤ ζ < 1."""
    omega_d = omega * math.sqrt(1.0 - zeta * zeta)
    decay = exponential(-zeta * omega * h)
    sine, cosine = sine_and_cosine(omega_d * h)
    s, c = decay * sine, decay * cosine
    r = zeta * omega / omega_d
    w2 = omega * omega
    # free vibration from (u, u̇)
    uu, uv = c + r * s, s / omega_d
    vu, vv = -w2 * s / omega_d, c - r * s
    # the line −a₀/ω² − (τ − 2ζ/ω)(a₁ − a₀)/(hω²), and the free vibration that takes it off at τ = 0
    late = 2.0 * zeta / omega
    slope = 1.0 / (h * w2)
    # the load a₁ alone: line (2ζ/ω − τ)·slope, that starts at late·slope with the rate −slope
    u1 = (late - h) * slope - uu * late * slope + uv * slope
    v1 = -slope - vu * late * slope + vv * slope
    # a constant load: line −1/ω², that starts there with no rate; the load a₀ alone is that less a₁'s
    u0 = (uu - 1.0) / w2 - u1
    v0 = vu / w2 - v1
    return uu, uv, u0, u1, vu, vv, v0, v1


@inline
def _between(y0: float, y1: float, rate0: float, rate1: float, h: float) -> float:
    """Largest magnitude of y over a step: at its ends, or in between where its rate changes sign."""
    peak = max(abs(y0), abs(y1))
    if rate0 * rate1 < 0.0:  # the rate taken as linear
        t = h * rate0 / (rate0 - rate1)
        peak = max(peak, abs(y0 + 0.5 * rate0 * t), abs(y1 - 0.5 * rate1 * (h - t)))
    return peak


@entry
def peak_responses(
    a: NDArray[np.float64], dt: float, periods: NDArray[np.float64], zeta: float, peaks: NDArray[np.float64]
) -> None:
    """Find the peaks of oscillators that start at rest, over the length of a record.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Floor acceleration [m/s²].
    dt : float
        Time between samples [s].
    periods : ndarray, shape (m,)
        Natural periods [s].
    zeta : float
        Damping ratio.
    peaks : ndarray, shape (m, RESPONSES)
        Filled with the largest |u| [m], |u̇| [m/s], |ü + a| [m/s²] and |u̇ + v| [m/s], v being the
        floor's velocity.
    """
    for i in range(len(periods)):
        omega = 2.0 * math.pi / periods[i]
        parts = max(1, math.ceil(dt * STEPS_IN_A_PERIOD / float(periods[i])))
        h = dt / parts
        uu, uv, u0, u1, vu, vv, v0, v1 = step_coefficients(omega, zeta, h)
        u, rate, floor = 0.0, 0.0, 0.0
        disp, vel, acc, absolute = 0.0, 0.0, 0.0, 0.0
        force, jerk = 0.0, 2.0 * zeta * omega * a[0]  # ü + a = −(2ζωu̇ + ω²u), and its rate
        for k in range(len(a) - 1):
            for part in range(parts):
                a0 = a[k] + (a[k + 1] - a[k]) * (part / parts)
                a1 = a[k] + (a[k + 1] - a[k]) * ((part + 1) / parts)
                start, start_rate, start_force, start_jerk = u, rate, force, jerk
                u = uu * start + uv * start_rate + u0 * a0 + u1 * a1
                rate = vu * start + vv * start_rate + v0 * a0 + v1 * a1
                force = -(2.0 * zeta * rate + omega * u) * omega
                jerk = -(2.0 * zeta * (force - a1) + omega * rate) * omega
                total = rate + floor + 0.5 * h * (a0 + a1)
                disp = max(disp, _between(start, u, start_rate, rate, h))
                vel = max(vel, _between(start_rate, rate, start_force - a0, force - a1, h))
                acc = max(acc, _between(start_force, force, start_jerk, jerk, h))
                absolute = max(absolute, _between(start_rate + floor, total, start_force, force, h))
                floor += 0.5 * h * (a0 + a1)
        peaks[i, 0], peaks[i, 1], peaks[i, 2], peaks[i, 3] = disp, vel, acc, absolute


@entry
def horizontal_velocities(
    ax: NDArray[np.float64],
    ay: NDArray[np.float64],
    dt: float,
    periods: NDArray[np.float64],
    zeta: float,
    peaks: NDArray[np.float64],
) -> None:
    """Find the largest absolute velocity of oscillators that move freely in the horizontal plane.

    Parameters
    ----------
    ax, ay : ndarray, shape (n,)
        Floor acceleration along x and y [m/s²].
    dt, periods, zeta
        As for `peak_responses`.
    peaks : ndarray, shape (m,)
        Filled with the largest magnitude of the vector of (u̇ + v) along x and y [m/s].
    """
    for i in range(len(periods)):
        parts = max(1, math.ceil(dt * STEPS_OF_A_VECTOR / float(periods[i])))
        h = dt / parts
        uu, uv, u0, u1, vu, vv, v0, v1 = step_coefficients(2.0 * math.pi / periods[i], zeta, h)
        x, x_rate, x_floor, y, y_rate, y_floor, peak = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(len(ax) - 1):
            for part in range(parts):
                start, end = part / parts, (part + 1) / parts
                a0, a1 = ax[k] + (ax[k + 1] - ax[k]) * start, ax[k] + (ax[k + 1] - ax[k]) * end
                b0, b1 = ay[k] + (ay[k + 1] - ay[k]) * start, ay[k] + (ay[k + 1] - ay[k]) * end
                x, x_rate = uu * x + uv * x_rate + u0 * a0 + u1 * a1, vu * x + vv * x_rate + v0 * a0 + v1 * a1
                y, y_rate = uu * y + uv * y_rate + u0 * b0 + u1 * b1, vu * y + vv * y_rate + v0 * b0 + v1 * b1
                x_floor += 0.5 * h * (a0 + a1)
                y_floor += 0.5 * h * (b0 + b1)
                peak = max(peak, (x_rate + x_floor) ** 2 + (y_rate + y_floor) ** 2)
        peaks[i] = math.sqrt(peak)


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
