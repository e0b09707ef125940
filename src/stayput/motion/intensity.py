"""JMA's scales of shaking: instrumental intensity and its classes, and the class of long-period motion.

Intensity: notification 4 of the Japan Meteorological Agency (1996). Class of long-period motion: the agency's
scale of 2013, from the absolute-velocity response at 5 % damping (that its horizontal components are added as
vectors is common knowledge, not re-checked).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, finite

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.record import Motion

EXCEEDED = 0.3
"""Time in all for which the level that counts is reached [s]."""

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


def filtered_level(motion: Motion) -> float:
    """Return a₀ [gal]: the vector sum of the filtered components is at least this for 0.3 s in all.

    Raises
    ------
    InputError
        A motion shorter than 0.3 s.
    """
    n = len(motion)
    counted = math.ceil(EXCEEDED / motion.dt - 1e-9)
    if counted > n:
        raise InputError(f"The motion lasts {motion.duration:g} s; an intensity needs at least {EXCEEDED} s.")
    weight = intensity_filter(np.fft.rfftfreq(n, motion.dt).astype(np.float64))
    total = np.zeros(n)
    for a in motion.components.values():
        total += np.fft.irfft(np.fft.rfft(100.0 * a) * weight, n) ** 2
    return math.sqrt(float(np.partition(total, n - counted)[n - counted]))


def jma_intensity(motion: Motion) -> float:
    """Return JMA's instrumental seismic intensity I = 2 log₁₀ a₀ + 0.94, not rounded.

    All components that are there count; JMA takes three. A motion times k has an intensity higher by
    2 log₁₀ k. A still floor's is −∞.
    """
    level = filtered_level(motion)
    return 2.0 * math.log10(level) + 0.94 if level > 0.0 else -math.inf


def published_intensity(intensity: float) -> float:
    """Return an intensity as JMA publishes it: the second decimal rounded from the third, then cut to one."""
    return math.floor(round(100.0 * intensity) / 10.0 + 1e-9) / 10.0 if math.isfinite(intensity) else 0.0


def intensity_class(intensity: float) -> str:
    """Return the class of an instrumental intensity: "0" to "4", "5-lower", ... "6-upper", "7"."""
    value = published_intensity(intensity)
    return next(name for name, start in reversed(CLASSES) if value >= start)


def intensity_of_class(name: str) -> float:
    """Return the intensity in the middle of a class: 5.25 for "5-upper"; 0.25 and 6.75 for "0" and "7".

    Raises
    ------
    InputError
        No such class.
    """
    names = [known for known, _ in CLASSES]
    if name not in names:
        raise InputError(f"The intensity is {name!r}; it must be a number or one of {', '.join(names)}.")
    i = names.index(name)
    if name == "0":
        return 0.25
    start = CLASSES[i][1]
    return start + 0.25 if name == "7" else 0.5 * (start + CLASSES[i + 1][1])


def factor_to_intensity(motion: Motion, intensity: float) -> float:
    """Return the factor on a motion that gives it an intensity.

    Raises
    ------
    InputError
        A still floor, or an intensity that is not finite.
    """
    wanted = finite("Intensity", intensity)
    now = jma_intensity(motion)
    if not math.isfinite(now):
        raise InputError("The motion is a still floor; it cannot be scaled to an intensity.")
    return 10.0 ** (0.5 * (wanted - now))


def long_period_response(motion: Motion) -> float:
    """Return the largest absolute-velocity response Sva over 1.6 to 7.8 s, 5 % damping [m/s].

    The two horizontal components are added as vectors at every instant; of a motion without y it is x alone.
    """
    from stayput.motion.oscillator import horizontal_velocities  # Numba takes its time to load

    x = motion.x.copy()
    y = np.zeros(len(x)) if motion.y is None else motion.y.copy()
    peaks = np.empty(len(LONG_PERIODS))
    horizontal_velocities(x, y, motion.dt, LONG_PERIODS.copy(), 0.05, peaks)
    return float(peaks.max())


def long_period_class(response: float) -> int:
    """Return JMA's class of long-period motion, 0 to 4, of an absolute-velocity response [m/s]."""
    return sum(response >= bound for bound in LONG_PERIOD_BOUNDS)
