"""Rows of acceleration samples: which are accepted, resampling, baseline correction, integrals and peaks.

Records that cannot be the ground's as they are have an offset, gravity, or a time step that is too long.

An acceleration is linear between its samples: in a segment of length h it is a(τ) = a₀ + sτ with
s = (a₁ − a₀)/h, so the velocity is a parabola, the displacement a cubic, and ∫a² a cubic too: every peak is
the peak of those curves, not of their samples. The floor starts at rest.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, not_allowed, shown, too_many, warn, within
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from stayput.motion.record import Motion


def _running(steps: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.concatenate(([0.0], np.cumsum(steps)))


def velocity(a: NDArray[np.float64], dt: float) -> NDArray[np.float64]:
    """Return the velocity at the samples [m/s], shape (n,), from the acceleration [m/s²], shape (n,)."""
    return _running(0.5 * dt * (a[:-1] + a[1:]))


def displacement(a: NDArray[np.float64], dt: float) -> NDArray[np.float64]:
    """Return the displacement at the samples [m], shape (n,), from the acceleration [m/s²], shape (n,)."""
    v = velocity(a, dt)
    return _running(v[:-1] * dt + dt * dt * (2.0 * a[:-1] + a[1:]) / 6.0)


def peak_velocity(a: NDArray[np.float64], dt: float) -> float:
    """Return the largest magnitude of the velocity [m/s], between the samples too."""
    v = velocity(a, dt)
    a0, a1 = a[:-1], a[1:]
    turns = a0 * a1 < 0.0
    inside = v[:-1][turns] + 0.5 * dt * a0[turns] ** 2 / (a0[turns] - a1[turns])
    return float(max(np.abs(v).max(), np.abs(inside).max(initial=0.0)))


def peak_displacement(a: NDArray[np.float64], dt: float) -> float:
    """Return the largest magnitude of the displacement [m], between the samples too."""
    d, v = displacement(a, dt), velocity(a, dt)[:-1]
    a0, s = a[:-1], np.diff(a) / dt
    peak = float(np.abs(d).max())
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(a0 * a0 - 2.0 * s * v)
        q = -0.5 * (a0 + np.copysign(root, a0))
        still = (2.0 * q / s, v / q)  # where the velocity v + a₀τ + sτ²/2 vanishes
    for tau in still:
        inside = (tau > 0.0) & (tau < dt)
        t = tau[inside]
        turned = d[:-1][inside] + t * (v[inside] + t * (a0[inside] / 2.0 + t * s[inside] / 6.0))
        peak = max(peak, float(np.abs(turned).max(initial=0.0)))
    return peak


def square(a: NDArray[np.float64], dt: float) -> NDArray[np.float64]:
    """Return ∫a² dt up to each sample [m²/s³], shape (n,)."""
    a0, a1 = a[:-1], a[1:]
    return _running(dt / 3.0 * (a0 * a0 + a0 * a1 + a1 * a1))


def magnitude(a: NDArray[np.float64], dt: float) -> float:
    """Return ∫|a| dt over the record [m/s]."""
    a0, a1 = np.abs(a[:-1]), np.abs(a[1:])
    crosses = a[:-1] * a[1:] < 0.0
    areas = 0.5 * dt * (a0 + a1)
    areas[crosses] -= dt * a0[crosses] * a1[crosses] / (a0[crosses] + a1[crosses])
    return float(areas.sum())


def time_of_share(a: NDArray[np.float64], dt: float, share: float) -> float:
    """Return the time at which ∫a² dt reaches ``share`` of its final value [s]; 0 for a still floor."""
    sums = square(a, dt)
    wanted = share * float(sums[-1])
    if not wanted > 0.0:
        return 0.0
    i = min(int(np.searchsorted(sums, wanted, side="left")), len(a) - 1) - 1
    rest, a0, rise = float(wanted - sums[i]), float(a[i]), float(a[i + 1] - a[i])
    if abs(rise) > 1e-6 * abs(a0):
        s = rise / dt
        tau = (float(np.cbrt(a0**3 + 3.0 * s * rest)) - a0) / s
    else:
        tau = rest / (a0 * a0) if a0 * a0 > 0.0 else dt
    return i * dt + min(max(tau, 0.0), dt)


def arias_intensity(a: NDArray[np.float64], dt: float) -> float:
    """Return π/(2g)·∫a² dt [m/s] of an acceleration [m/s²], shape (n,) (Arias 1970)."""
    return math.pi / (2.0 * STANDARD_GRAVITY) * float(square(a, dt)[-1])


def significant_duration(a: NDArray[np.float64], dt: float) -> float:
    """Return the time in which ∫a² dt grows from 5 % to 95 % [s] (Trifunac and Brady 1975)."""
    return time_of_share(a, dt, 0.95) - time_of_share(a, dt, 0.05)


DRIFTING = 0.8
"""A displacement drifts where its peak is below this share once a line is taken off the acceleration."""


@dataclass(frozen=True, slots=True)
class Peaks:
    """Peaks and integral measures of one component.

    Parameters
    ----------
    pga, pgv, pgd : float
        Largest magnitude of acceleration [m/s²], velocity [m/s] and displacement [m].
    pgd_baseline_corrected : float
        That of the displacement less a line in the acceleration, as `Motion.baseline_corrected` takes it
        off [m].
    arias : float
        Arias intensity [m/s].
    cav : float
        Cumulative absolute velocity ∫|a| dt [m/s] (EPRI 1988, without the later thresholds).
    significant_duration : float
        D5–95 [s].
    """

    pga: float
    pgv: float
    pgd: float
    pgd_baseline_corrected: float
    arias: float
    cav: float
    significant_duration: float

    @classmethod
    def of(cls, a: NDArray[np.float64], dt: float) -> Peaks:
        """Return the peaks of an acceleration [m/s²], shape (n,), of time step dt [s]."""
        return cls(
            pga=float(np.abs(a).max()),
            pgv=peak_velocity(a, dt),
            pgd=peak_displacement(a, dt),
            pgd_baseline_corrected=peak_displacement(without_baseline(a, dt, 1), dt),
            arias=arias_intensity(a, dt),
            cav=magnitude(a, dt),
            significant_duration=significant_duration(a, dt),
        )

    @property
    def displacement_drifts(self) -> bool:
        """Whether its peak is mostly one of the baseline: of an offset, a tilt, a start that is cut off."""
        return self.pgd_baseline_corrected < DRIFTING * self.pgd


STEP_RANGE = (1e-6, 1.0)
"""Smallest and largest time step that is accepted [s]."""

LARGEST_ACCELERATION = 1e3
"""Largest acceleration that is accepted [m/s²]: some 25 times the strongest recorded on the ground."""

MOST_SAMPLES = 20_000_000
"""Largest number of samples that is accepted."""

_KAISER_BETA = 8.0
"""Kaiser window of the anti-alias filter: about 80 dB of stop band."""

_TAPS_PER_STEP = 24
"""Half-length of the anti-alias filter, in steps of the coarser record."""

QUANTUM = 1e-6
"""Samples are whole multiples of this [m/s²], so that no library's last bit shows."""


def check_size(component: str, samples: NDArray[np.float64], field: str) -> None:
    """Raise `InputError` when an acceleration is not finite, or larger than any that is accepted.

    Parameters
    ----------
    component : str
        What the samples are: "x", "y" or "z".
    samples : ndarray, shape (n,)
        Acceleration [m/s²].
    field : str
        Name of the input that is wrong.
    """
    index = int(np.abs(samples).argmax())  # the first NaN, where there is any
    name, most = phrase("motion.sample_of", component=component, index=index), LARGEST_ACCELERATION
    within(name, samples[index], -most, most, "m/s²", field)


def checked_samples(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return a read-only, contiguous copy of a row of accelerations [m/s²], shape (n,).

    Raises
    ------
    InputError
        Not one row of 2 or more finite, sane, real numbers without gaps.
    """
    try:
        raw = np.asarray(values)
    except (TypeError, ValueError):
        raw = np.array(None)
    if np.ma.is_masked(values) or raw.dtype.kind not in "iuf" or raw.ndim != 1:
        called = phrase("motion.samples_of", component=name)
        raise not_allowed(called, shown(values), "motion.row_of_samples", name)
    within(phrase("motion.samples_count", component=name), raw.size, 2, MOST_SAMPLES, field=name)
    array = np.array(raw, dtype=np.float64, order="C")
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
        Ratio of the time steps, ≥ 2 and less than n.
    """
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


LONGEST_STEP = 0.1
"""Longest time step that is read without a warning [s]; a record shows nothing faster than 1/(2 dt)."""

_OVER_PEAK_VELOCITY = 5.0
_FEWEST_CROSSINGS = 10
_SHARE_OF_PEAK = 1e-3
_LATE_SHARE = 0.02
_GRAVITY_TOLERANCE = 0.05
_SHORTEST_PART = 2.0  # s
_TURNED_SHARE = 0.1
_FASTEST_LEFT = 5.0
"""Velocity at a record's end that no floor is left with [m/s]."""
_MOST_OF_PEAK = 0.1


def oscillates_about_offset(a: NDArray[np.float64], dt: float) -> bool:
    """Return whether an acceleration oscillates about a value other than zero.

    The ground is at rest before and after an earthquake, so its mean acceleration is zero; a mean ā leaves it
    moving at ā T after the duration T. That is taken for an offset of the instrument where ā is at least a
    thousandth of the peak, ā T is more than five times the peak velocity of the record less ā, and the record
    crosses ā at least ten times. A pulse that leaves the floor at another velocity, half a sine, a rectangle
    or a constant acceleration, crosses its mean a few times at most and is none; records with the noise and
    the drift of an instrument stay below one peak velocity.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time step [s].
    """
    mean = float(a.mean())
    if abs(mean) < _SHARE_OF_PEAK * max(float(a.max()), -float(a.min())):
        return False
    rest = a - mean
    crossings = int(np.count_nonzero(rest[:-1] * rest[1:] < 0.0))
    final_velocity = abs(mean) * dt * (len(a) - 1)
    return crossings >= _FEWEST_CROSSINGS and final_velocity > _OVER_PEAK_VELOCITY * peak_velocity(rest, dt)


def offset_begins(a: NDArray[np.float64], dt: float) -> int:
    """Return about where an offset begins that lasts to the end of an acceleration; 0 where none does.

    It is looked for in the last half, quarter and eighth. Its least size is larger than that of an offset of
    the whole record: shaking tilts instruments and leaves a thousandth of the peak behind in many of them.

    Parameters
    ----------
    a, dt
        As for `oscillates_about_offset`.
    """
    peak = float(np.abs(a).max())
    for part in (2, 4, 8):
        begin = len(a) - len(a) // part
        rest = a[begin:]
        if len(rest) and abs(rest.mean()) > _LATE_SHARE * peak and oscillates_about_offset(rest, dt):
            return begin
    return 0


def check_baseline(motion: Motion, *, recorded: bool = False) -> None:
    """Refuse or warn of a motion that cannot be the ground's, or a floor's, as it is.

    Parameters
    ----------
    motion : Motion
        The motion.
    recorded : bool
        Whether it comes from a record. One that was made of arrays may be any input, such as a fall: it is
        only warned of, and its time step is taken as it is.

    Raises
    ------
    InputError
        A component of a record whose mean is gravity, within 5 %, or the means of all together are; an offset
        of more than a tenth of the peak that would leave the floor moving faster than 5 m/s. The ground has
        moved at 3 to 4 m/s at most; of corrected records a mean is some thousandths of the peak at most.

    Warns
    -----
    InputWarning
        An offset, see `oscillates_about_offset` and `offset_begins`; gravity in z of a motion of
        arrays; a record whose time step is longer than 0.1 s.
    """
    if recorded and motion.dt > LONGEST_STEP:
        warn(InputWarning("motion.long_step", "dt", dt=motion.dt, frequency=0.5 / motion.dt))
    option = "remove_mean" if recorded else "baseline_corrected"
    means = {name: float(a.mean()) for name, a in motion.components.items()}
    together = f"{', '.join(means)} together", f"{', '.join(means)}を合わせた"  # of a tilted instrument
    for component, mean in (*means.items(), (together, math.hypot(*means.values()))):
        if recorded and _is_gravity(mean):
            raise InputError("motion.gravity", option, component=component, mean=mean, option=option)
    for name, a in motion.components.items():
        mean = means[name]
        if name == "z" and _is_gravity(mean):
            warn(InputWarning("motion.gravity", "z", component=name, mean=mean, option=option))
        elif oscillates_about_offset(a, motion.dt):
            velocity, share = abs(mean) * motion.duration, abs(mean) / float(np.abs(a).max())
            about: dict[str, Any] = {"component": name, "mean": mean, "velocity": velocity, "option": option}
            if recorded and velocity > _FASTEST_LEFT and share > _MOST_OF_PEAK:
                raise InputError("motion.offset", option, share=100.0 * share, **about)
            warn(InputWarning("motion.offset", option, share=100.0 * share, **about))
        elif begin := offset_begins(a, motion.dt):
            about = {"component": name, "mean": float(a[begin:].mean()), "begin": begin * motion.dt}
            warn(InputWarning("motion.late_offset", name, **about))


def checked_record(motion: Motion, *, remove_mean: bool) -> Motion:
    """Return a motion that was read, less the mean of each component where that is asked for.

    Its source says what was taken off. Raises and warns as `check_baseline` does; a record of an instrument
    that was turned is refused.
    """
    _check_orientation(motion)
    if remove_mean:
        means = {name: float(a.mean()) for name, a in motion.components.items()}
        removed = ", ".join(f"{name} {mean:.4g}" for name, mean in means.items())
        samples: dict[str, Any] = {name: a - means[name] for name, a in motion.components.items()}
        motion = replace(motion, **samples, source=f"{motion.source}; mean removed [m/s²]: {removed}")
    check_baseline(motion, recorded=True)
    return motion


def _check_orientation(motion: Motion) -> None:
    """Refuse a record of an instrument that was turned by hand, as a phone is: no mean takes its gravity off.

    The magnitude of its components is gravity, in the median and within 5 %, and the mean of an eighth of the
    record differs from that of all by more than a tenth of gravity, as by 6°. Shaking moves such a mean by
    the change of velocity over that time.
    """
    parts = min(8, int(motion.duration / _SHORTEST_PART))
    if parts < 2 or len(motion.components) == 1:
        return
    samples = np.stack(list(motion.components.values()))
    magnitude = float(np.median(np.linalg.norm(samples, axis=0)))
    means = np.stack([part.mean(axis=1) for part in np.array_split(samples, parts, axis=1)])
    change = float(np.linalg.norm(means - samples.mean(axis=1), axis=1).max())
    if _is_gravity(magnitude) and change > _TURNED_SHARE * STANDARD_GRAVITY:
        raise InputError("motion.turned", components=", ".join(motion.components), magnitude=magnitude)


def _is_gravity(mean: float) -> bool:
    return abs(abs(mean) - STANDARD_GRAVITY) <= _GRAVITY_TOLERANCE * STANDARD_GRAVITY
