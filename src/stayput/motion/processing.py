"""Rows of acceleration samples: which are accepted, resampling, baseline correction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from stayput.catalogue import phrase
from stayput.errors import InputError, too_many
from stayput.motion.integrals import velocity

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

STEP_RANGE = (1e-6, 1.0)
"""Smallest and largest time step that is accepted [s]."""

LARGEST_ACCELERATION = 1e4
"""Largest acceleration that is accepted [m/s²]."""

MOST_SAMPLES = 20_000_000
"""Largest number of samples that is accepted."""

_KAISER_BETA = 8.0
"""Kaiser window of the anti-alias filter: about 80 dB of stop band."""

_TAPS_PER_STEP = 24
"""Half-length of the anti-alias filter, in steps of the coarser record."""

QUANTUM = 1e-6
"""Samples are whole multiples of this [m/s²], so that no library's last bit shows."""


def check_size(component: str, samples: NDArray[np.float64], field: str) -> None:
    """Raise `InputError` when an acceleration is larger than any that is accepted.

    Parameters
    ----------
    component : str
        What the samples are: "x", "y" or "z".
    samples : ndarray, shape (n,)
        Acceleration [m/s²].
    field : str
        Name of the input that is wrong.
    """
    index = int(np.abs(samples).argmax())
    value = float(samples[index])
    if abs(value) > LARGEST_ACCELERATION:
        most = LARGEST_ACCELERATION
        raise InputError(
            "motion.samples_too_large", field, component=component, index=index, value=value, most=most
        )


def checked_samples(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return a read-only, contiguous copy of a row of accelerations [m/s²], shape (n,).

    Raises
    ------
    InputError
        Not one row of 2 or more finite, sane, real numbers without gaps.
    """

    def refused(why: str, **values: object) -> InputError:
        kind = phrase(f"motion.{why}", **values)
        return InputError("motion.samples_not_a_row", name, component=name, kind=kind)

    if np.ma.is_masked(values):
        raise refused("masked")
    try:
        raw = np.asarray(values)
    except (TypeError, ValueError):
        raise refused("no_array") from None
    if raw.dtype.kind not in "iuf":
        raise refused("of_kind", kind=raw.dtype)
    if raw.ndim != 1:
        raise refused("of_shape", shape=str(raw.shape))
    if not 2 <= raw.size <= MOST_SAMPLES:
        raise InputError("motion.samples_count", name, component=name, count=raw.size, most=MOST_SAMPLES)
    array = np.array(raw, dtype=np.float64, order="C")
    bad = np.flatnonzero(~np.isfinite(array))
    if bad.size:
        value, index = float(array[bad[0]]), int(bad[0])
        raise InputError("motion.samples_not_finite", name, component=name, value=value, index=index)
    check_size(name, array, name)
    array.setflags(write=False)
    return array


def whole_ratio(larger: float, smaller: float) -> int:
    """Return the whole number larger/smaller, or 0 when it is not whole (to 1e-6)."""
    ratio = larger / smaller
    nearest = round(ratio)
    # A step of 0.01 s that was read as 0.0099999 s still is a hundredth.
    return nearest if nearest >= 1 and abs(ratio - nearest) <= 1e-6 * nearest else 0


def refine(a: NDArray[np.float64], parts: int) -> NDArray[np.float64]:
    """Return the same piecewise linear function with each step cut into ``parts``, shape ((n−1)·parts+1,)."""
    if (len(a) - 1) * parts >= MOST_SAMPLES:
        count = (len(a) - 1) * parts + 1
        raise too_many("motion.the_motion", count, "motion.the_samples", MOST_SAMPLES, "dt")
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
        raise InputError("motion.resampled_too_short", "dt", count=len(a), ratio=steps, least=steps + 1)
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


def fft_length(n: int) -> int:
    """Return the power of two that holds n samples."""
    return 1 << (n - 1).bit_length()


def ending_at_rest(a: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return an acceleration whose velocity and displacement end at zero, in whole quanta.

    Two smooth bumps as long as the record take off what is left of both; after rounding, a few quanta
    near the middle take off the rest. With a₀ = aₙ = 0 the final velocity of the piecewise linear record
    is dt Σ aᵢ and its final displacement dt² Σ (n − i) aᵢ, so both are sums of whole numbers.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²], zero at both ends.
    """
    tau = np.linspace(0.0, 1.0, len(a))
    window = np.sin(math.pi * tau) ** 2
    window[-1] = 0.0  # sin²π is 1.5e-32
    slant = window * (tau - 0.5)  # the bumps' sums are those of an even and of an odd function
    s0, s1 = float(np.sum(a)), float(np.sum(a * (tau - 0.5)))
    a = a - s0 / float(np.sum(window)) * window - s1 / float(np.sum(slant * (tau - 0.5))) * slant
    whole = np.rint(a / QUANTUM).astype(np.int64)
    excess = -int(whole.sum())
    first = (len(whole) - abs(excess)) // 2
    whole[first : first + abs(excess)] += 1 if excess > 0 else -1  # each to a sample of its own
    place = np.arange(len(a), dtype=np.int64) - len(a) // 2
    _add_couples(whole, -int(np.sum(whole * place)))
    return whole.astype(np.float64) * QUANTUM


def _add_couples(whole: NDArray[np.int64], moment: int) -> None:
    """Add pairs of opposite quanta whose distances sum to ``moment`` samples."""
    sign = 1 if moment > 0 else -1
    far = len(whole) // 2
    pairs, rest = divmod(abs(moment), far)
    first = (far - pairs) // 2
    whole[first : first + pairs] -= sign
    whole[first + far : first + far + pairs] += sign
    if rest:
        middle = (len(whole) - rest) // 2
        whole[middle] -= sign
        whole[middle + rest] += sign
