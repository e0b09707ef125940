"""Scales of intensity, and all measures of how strongly a motion shakes, in one record.

JMA's instrumental intensity, its classes, classes of long-period motion, regressions on peaks.

Intensity: notification 4 of the Japan Meteorological Agency (1996). Class of long-period motion: the agency's
scale of 2013, from the absolute-velocity response at 5 % damping (that its horizontal components are added as
vectors is common knowledge, not re-checked). The published regressions on peaks are means over many records,
with a scatter of about half a degree; none replaces the intensity that is computed from the record itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, finite, not_allowed, warn, within
from stayput.motion.response import PERIODS, mean_period
from stayput.vocabulary import preset_meant

if TYPE_CHECKING:
    from stayput.motion.record import Motion

EXCEEDED = 0.3
"""Time in all for which the level that counts is reached [s]."""

INTENSITY_RANGE = -3.0, 7.5
"""Ends of what is accepted as an instrumental intensity; the classes end with 7, which begins at 6.5."""

RECORDED = 7.0
"""Intensity above which nothing has been recorded."""

CLASSES = (
    ("0", -math.inf),
    ("1", 0.5),
    ("2", 1.5),
    ("3", 2.5),
    ("4", 3.5),
    ("5-lower", 4.5),
    ("5-upper", 5.0),
    ("6-lower", 5.5),
    ("6-upper", 6.0),
    ("7", 6.5),
)
"""Names of the classes of intensity, and where each begins."""

MERCALLI_OF_PGV = ((3.78, 1.47), (2.89, 3.16))
"""Modified Mercalli intensity a + b·log₁₀ PGV[cm/s] of weak and of strong shaking (Worden et al. 2012)."""

LONG_PERIODS: NDArray[np.float64] = np.arange(8, 40) / 5.0
"""Periods of the class of long-period motion: 1.6 to 7.8 s in steps of 0.2 s, shape (32,)."""
LONG_PERIODS.setflags(write=False)

LONG_PERIOD_BOUNDS = (0.05, 0.15, 0.50, 1.00)
"""Absolute-velocity responses from which the classes 1 to 4 of long-period motion begin [m/s]."""


def intensity_filter(f: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the weight of each frequency [Hz]: period effect, high cut and low cut; 0 at 0 Hz."""
    weight = np.zeros_like(f)
    f = f[f > 0.0]
    y2 = (f / 10.0) ** 2
    high = 1.0 + y2 * (
        0.694 + y2 * (0.241 + y2 * (0.0557 + y2 * (0.009664 + y2 * (0.00134 + y2 * 0.000155))))
    )
    weight[-len(f) :] = np.sqrt(1.0 / f) * np.sqrt(-np.expm1(-((f / 0.5) ** 3))) / np.sqrt(high)
    return weight


def filtered_level(components: Iterable[NDArray[np.float64]], dt: float) -> float:
    """Return a₀ [gal]: the vector sum of the filtered components is at least this for 0.3 s in all.

    Parameters
    ----------
    components : iterable of ndarray, shape (n,)
        Accelerations of one motion [m/s²].
    dt : float
        Time step [s].

    Raises
    ------
    InputError
        A motion shorter than 0.3 s.
    """
    rows = list(components)
    n = len(rows[0])
    counted = math.ceil(EXCEEDED / dt - 1e-9)
    if counted > n:
        raise InputError("motion.too_short_for_intensity", duration=(n - 1) * dt, least=EXCEEDED)
    weight = intensity_filter(np.fft.rfftfreq(n, dt).astype(np.float64))
    total = np.zeros(n)
    for a in rows:
        total += np.fft.irfft(np.fft.rfft(100.0 * a) * weight, n) ** 2
    return math.sqrt(float(np.partition(total, n - counted)[n - counted]))


def jma_intensity(components: Iterable[NDArray[np.float64]], dt: float) -> float:
    """Return JMA's instrumental seismic intensity I = 2 log₁₀ a₀ + 0.94, not rounded; see `filtered_level`.

    All components that are there count; JMA takes three. A motion times k has an intensity higher by
    2 log₁₀ k. A still floor's is −∞.
    """
    level = filtered_level(components, dt)
    return 2.0 * math.log10(level) + 0.94 if level > 0.0 else -math.inf


def published_intensity(intensity: float) -> float:
    """Return an intensity as JMA publishes it: rounded to two decimals, then cut to one."""
    return math.floor(round(100.0 * intensity) / 10.0 + 1e-9) / 10.0 if math.isfinite(intensity) else 0.0


def intensity_class(intensity: float) -> str:
    """Return the class of an instrumental intensity: "0" to "4", "5-lower", ... "6-upper", "7"."""
    value = published_intensity(intensity)
    return next(name for name, start in reversed(CLASSES) if value >= start)


def intensity_of_class(name: str) -> float:
    """Return the intensity in the middle of a class: 5.25 for "5-upper"; 0.25 and 6.75 for "0" and "7".

    The name may be any that `stayput.vocabulary.WORDS` knows, as "5強".

    Raises
    ------
    InputError
        No such class.
    """
    names = [known for known, _ in CLASSES]
    i = names.index(preset_meant("intensity", "motion.name_intensity", name, names, "intensity"))
    bounds = [0.0, *(start for _, start in CLASSES[1:]), 7.0]
    return 0.5 * (bounds[i] + bounds[i + 1])


def possible_intensity(stated: float | str) -> float:
    """Return an instrumental intensity, or that of a class, with a warning where none so strong was recorded.

    Raises
    ------
    InputError
        Beyond `INTENSITY_RANGE`, or no such class.
    """
    value = intensity_of_class(stated) if isinstance(stated, str) else stated
    intensity = within("motion.name_intensity", value, *INTENSITY_RANGE, field="intensity")
    if intensity > RECORDED:
        warn(InputWarning("motion.intensity_unrecorded", "intensity", value=intensity, most=RECORDED))
    return intensity


def factor_to_intensity(intensity: float, wanted: float) -> float:
    """Return the factor on a motion of an intensity that gives it another one, to ten digits.

    The last digits of NumPy's functions, and so of an intensity, depend on the processor: runs shall not.

    Raises
    ------
    InputError
        The intensity of a still floor, or a wanted one that is not finite.
    """
    target = finite("motion.name_intensity", wanted, "intensity")
    if not math.isfinite(intensity):
        raise InputError("motion.still_floor")
    return float(f"{10.0 ** (0.5 * (target - intensity)):.10g}")


def long_period_response(x: NDArray[np.float64], y: NDArray[np.float64] | None, dt: float) -> float:
    """Return the largest absolute-velocity response Sva over 1.6 to 7.8 s, 5 % damping [m/s].

    The two horizontal components are added as vectors at every instant; of a motion without y it is x alone.

    Parameters
    ----------
    x, y : ndarray, shape (n,)
        Horizontal accelerations [m/s²].
    dt : float
        Time step [s].
    """
    from stayput.motion.oscillator import horizontal_velocities  # Numba takes its time to load

    # The compiled function takes writable arrays alone; a motion's cannot be written to.
    across = np.zeros(len(x)) if y is None else y.copy()
    peaks = np.empty(len(LONG_PERIODS))
    horizontal_velocities(x.copy(), across, dt, LONG_PERIODS.copy(), 0.05, peaks)
    return float(peaks.max())


def long_period_class(response: float) -> int:
    """Return JMA's class of long-period motion, 0 to 4, of an absolute-velocity response [m/s]."""
    return sum(response >= bound for bound in LONG_PERIOD_BOUNDS)


def _logarithm(name: str, value: float, unit: str) -> float:
    called = phrase(f"motion.name_{name}")
    number = finite(called, value, name)
    if not number > 0.0:
        raise not_allowed(called, f"{number:g} {unit}", "common.above_zero", name)
    return math.log10(100.0 * number)


def jma_from_pgv(pgv: float) -> float:
    """Return JMA's intensity 2.68 + 1.72 log₁₀ PGV[cm/s] of a peak velocity [m/s] (Midorikawa et al. 1999).

    Made for intensities from 4 to 7.
    """
    return 2.68 + 1.72 * _logarithm("pgv", pgv, "m/s")


def kawasumi(pga: float) -> float:
    """Return the intensity 2 log₁₀ PGA[gal] + 0.7 of a peak acceleration [m/s²] (Kawasumi 1951)."""
    return 2.0 * _logarithm("pga", pga, "m/s²") + 0.7


def mercalli(pga: float, pgv: float) -> float:
    """Return the modified Mercalli intensity, 1 to 10, of PGA [m/s²] and PGV [m/s] (Worden et al. 2012).

    The mean of the two bilinear regressions of that paper, which were made for California; the larger
    horizontal component counts.

    Raises
    ------
    InputError
        A peak that is not larger than 0.
    """
    return min(10.0, max(1.0, mercalli_beyond(pga, pgv)))


def mercalli_beyond(pga: float, pgv: float) -> float:
    """Return what `mercalli` returns, beyond the ends of the scale too: there the lines go on.

    Raises
    ------
    InputError
        A peak that is not larger than 0.
    """
    a, v = _logarithm("pga", pga, "m/s²"), _logarithm("pgv", pgv, "m/s")
    from_a = 1.78 + 1.55 * a if a <= 1.57 else -1.60 + 3.70 * a
    (low, rise), (high, steep) = MERCALLI_OF_PGV
    from_v = low + rise * v if v <= 0.53 else high + steep * v
    return 0.5 * (from_a + from_v)


def mercalli_rise(mercalli: ArrayLike) -> NDArray[np.float64]:
    """Return by how much a modified Mercalli intensity rises where the peak velocity grows tenfold."""
    (_, rise), (_, steep) = MERCALLI_OF_PGV
    return np.where(np.asarray(mercalli) < 4.56, rise, steep)


def pgv_of_mercalli(mercalli: float) -> float:
    """Return the peak velocity [m/s] of a modified Mercalli intensity from 2 to 10 (Worden et al. 2012).

    That paper fits its lines so that they may be read both ways; they meet at 4.56.
    """
    (low, rise), (high, steep) = MERCALLI_OF_PGV
    v = (mercalli - low) / rise if mercalli < 4.56 else (mercalli - high) / steep
    return 0.01 * 10.0**v


HOUSNER_PERIODS = np.linspace(0.1, 2.5, 121)
"""Periods over which a spectrum intensity is taken [s]; steps of 0.02 s."""


@dataclass(frozen=True, slots=True)
class SpectralMeasures:
    """Measures of one component from the response of oscillators.

    Parameters
    ----------
    housner_intensity : float
        ∫ PSv dT from 0.1 to 2.5 s at 5 % [m] (Housner 1952).
    spectrum_intensity : float
        SI: the mean of Sv from 0.1 to 2.5 s at 20 % [m/s], as gas meters in Japan use it.
    predominant_period : float
        Period of the largest Sa at 5 % [s]; NaN of a still floor.
    mean_period : float
        Tm of the Fourier spectrum, 0.25 to 20 Hz [s] (Rathje and others 1998); NaN of a still floor.
    """

    housner_intensity: float
    spectrum_intensity: float
    predominant_period: float
    mean_period: float

    @classmethod
    def of(cls, motion: Motion, component: str = "x") -> SpectralMeasures:
        """Return the measures of one component of a motion."""
        a = motion.components[component]
        spectrum = motion.spectrum(PERIODS, 0.05, component)
        housner = motion.spectrum(HOUSNER_PERIODS, 0.05, component).psv
        damped = motion.spectrum(HOUSNER_PERIODS, 0.20, component).sv
        span = float(HOUSNER_PERIODS[-1] - HOUSNER_PERIODS[0])
        moves = bool(np.any(a))
        return cls(
            housner_intensity=float(np.trapezoid(housner, HOUSNER_PERIODS)),
            spectrum_intensity=float(np.trapezoid(damped, HOUSNER_PERIODS)) / span,
            predominant_period=float(spectrum.periods[int(np.argmax(spectrum.sa))]) if moves else math.nan,
            mean_period=mean_period(a, motion.dt),
        )
