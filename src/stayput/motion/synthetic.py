"""Computed motions: sines, single pulses, and the built-in near-fault record of a fixed seed."""

from __future__ import annotations

import math
import random
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, too_many, within, word_of
from stayput.model.parameters import arguments, parameters, quantity
from stayput.motion.processing import LARGEST_ACCELERATION, MOST_SAMPLES, QUANTUM, STEP_RANGE
from stayput.motion.record import Motion

PULSE_KINDS = ("rectangular", "half-sine", "ricker", "mavroeidis-papageorgiou")
"""The kinds of `pulse`."""

_FEWEST_STEPS = 20
"""Fewest time steps in a period, so that a chain of straight lines is a sine to 1 %."""


def _steps(duration: float, dt: float, quiet: float) -> tuple[int, int, float]:
    """Return the steps of the shaking and of the quiet after it, and the step that fits the former [s]."""
    steps = max(1, math.ceil(duration / dt - 1e-9))
    step = duration / steps
    still = math.ceil(quiet / step - 1e-9)
    if steps + still >= MOST_SAMPLES:
        count = steps + still + 1
        raise too_many("motion.the_motion", count, "motion.the_samples", MOST_SAMPLES, "duration")
    return steps, still, step


def _check_step(step: float, period: float) -> None:
    """Refuse a time step that is too long for the period, or for the length of a pulse [s]."""
    most = period / _FEWEST_STEPS
    if step > most * (1.0 + 1e-9):
        raise InputError("motion.coarse_step", "dt", step=step, most=most, fewest=_FEWEST_STEPS)


def _then_quiet(a: NDArray[np.float64], still: int) -> NDArray[np.float64]:
    """Append ``still`` zeros; the last sample is put half way, so that the jump's impulse stays exact."""
    if not still:
        return a
    return np.concatenate((a[:-1], [0.5 * a[-1]], np.zeros(still)))


@arguments(
    amplitude=quantity(
        "m/s²", -LARGEST_ACCELERATION, LARGEST_ACCELERATION, ("Sine amplitude", "正弦波の振幅")
    ),
    frequency=quantity("Hz", 1e-3, 1e3, ("Sine frequency", "正弦波の振動数")),
    duration=quantity("s", 1e-3, 1e5, ("Sine duration", "正弦波の継続時間")),
    phase=quantity("rad", -1e3, 1e3, ("Sine phase", "正弦波の位相")),
    dt=quantity("s", *STEP_RANGE, ("Sine dt", "正弦波の時間刻み")),
    quiet=quantity("s", 0.0, 1e5, ("Sine quiet", "正弦波の後の静止時間")),
)
def sine(
    amplitude: float,
    frequency: float,
    duration: float = 30.0,
    phase: float = 0.0,
    dt: float = 0.005,
    *,
    quiet: float = 0.0,
) -> Motion:
    """Make a harmonic motion a = A sin(2πft + φ).

    Parameters
    ----------
    amplitude : float
        Amplitude A [m/s²].
    frequency : float
        Frequency f [Hz].
    duration : float
        Time of shaking [s]; ``1 / frequency`` is one full wave.
    phase : float
        Phase φ [rad]; π/2 is a cosine.
    dt : float
        Largest time step [s]; the step is made to divide ``duration`` exactly.
    quiet : float
        Still floor after the shaking [s]. Where the shaking ends off zero, the jump is spread over the
        two steps around its end; the impulse is that of the jump.

    Raises
    ------
    InputError
        A value out of range, or fewer than 20 steps in a wave.

    Examples
    --------
    >>> sine(5.0, 1.0).pga
    5.0
    """
    values = (amplitude, frequency, duration, phase, dt, quiet)
    a0, f, length, angle, step, still = (
        about.check(value) for about, value in zip(parameters(sine), values, strict=True)
    )
    _check_step(step, 1.0 / f)
    n, zeros, step = _steps(length, step, still)
    a = a0 * np.sin(2.0 * math.pi * f * step * np.arange(n + 1) + angle)
    name = f"sine {a0:g} m/s², {f:g} Hz"
    return Motion(step, _then_quiet(a, zeros), name=name, synthetic=True, source=f"{name}, {length:g} s")


def _ricker(tau: NDArray[np.float64], f: float) -> NDArray[np.float64]:
    """Return a Ricker wavelet of unit peak acceleration about τ = 0 (Ricker 1953)."""
    squared = (math.pi * f * tau) ** 2
    return (1.0 - 2.0 * squared) * np.exp(-squared)


def mavroeidis_papageorgiou(
    tau: NDArray[np.float64], f: float, gamma: float, nu: float
) -> NDArray[np.float64]:
    """Return the acceleration of v = ½[1 + cos(2πfτ/γ)] cos(2πfτ + ν), |τ| ≤ γ/(2f).

    Source: Mavroeidis and Papageorgiou (2003), doi:10.1785/0120020100.
    """
    w = 2.0 * math.pi * f
    carrier = w * tau + nu
    envelope = 1.0 + np.cos(w * tau / gamma)
    a = -0.5 * w * (np.sin(w * tau / gamma) * np.cos(carrier) / gamma + envelope * np.sin(carrier))
    return np.where(np.abs(tau) <= gamma / (2.0 * f), a, 0.0)


def pulse(
    kind: str,
    amplitude: float,
    duration: float | None = None,
    frequency: float | None = None,
    *,
    gamma: float = 2.0,
    nu: float = 0.0,
    quiet: float = 10.0,
    dt: float | None = None,
) -> Motion:
    """Make a single pulse and a still floor after it.

    Parameters
    ----------
    kind : str
        "rectangular" (A for ``duration``) and "half-sine" (A sin(πt/``duration``)) begin at t = 0;
        "ricker" (A(1 − 2π²f²τ²)exp(−π²f²τ²), 3 periods long) and "mavroeidis-papageorgiou" (velocity
        (A/2)[1 + cos(2πfτ/γ)]cos(2πfτ + ν), γ periods long) have τ = 0 at their middle.
    amplitude : float
        A: peak acceleration [m/s²]; for "mavroeidis-papageorgiou" the velocity [m/s].
    duration : float, optional
        Length of the first two kinds [s].
    frequency : float, optional
        f of the last two kinds [Hz].
    gamma, nu : float
        γ ≥ 1 and ν [rad] of "mavroeidis-papageorgiou".
    quiet : float
        Still floor after the pulse [s].
    dt : float, optional
        Largest time step [s]; the step is made to divide the pulse exactly. Default 1 ms, or 1/200 of
        the pulse or period where that is less. A record is linear between samples, so the end of a
        rectangular pulse is a ramp over the two steps around it; its impulse A·T is exact.

    Raises
    ------
    InputError
        An unknown kind, a value out of range, or a length where a frequency belongs or the reverse.

    Examples
    --------
    >>> import stayput as sp
    >>> shake = sp.pulse("ricker", amplitude=5.0, frequency=1.0)
    >>> round(shake.pga, 2)
    5.0
    """
    word_of("kind", kind, PULSE_KINDS, "kind")
    by_length = kind in PULSE_KINDS[:2]
    needed, other = (duration, frequency) if by_length else (frequency, duration)
    quantity = "duration" if by_length else "frequency"
    if needed is None or other is not None:
        about: dict[str, Any] = {"kind": kind, "duration": duration, "frequency": frequency}
        raise InputError("motion.pulse_needs", quantity, wanted=phrase(f"motion.{quantity}"), **about)
    largest = LARGEST_ACCELERATION if kind != PULSE_KINDS[3] else 100.0
    unit = "m/s" if kind == PULSE_KINDS[3] else "m/s²"
    a0 = within("amplitude", amplitude, -largest, largest, unit, "amplitude")
    still = within("quiet", quiet, 0.0, 1e5, "s", "quiet")
    g = within("gamma", gamma, 1.0, 50.0, field="gamma")
    phase = within("nu", nu, -1e3, 1e3, "rad", "nu")
    if by_length:
        period = within("duration", needed, 1e-3, 1e3, "s", "duration")
        length = period
    else:
        period = 1.0 / within("frequency", needed, 1e-3, 1e3, "Hz", "frequency")
        length = period * (3.0 if kind == "ricker" else g)
    usual = min(1e-3, period / 200.0)
    step = usual if dt is None else within("motion.name_dt", dt, *STEP_RANGE, "s", "dt")
    _check_step(step, period)
    half, zeros, step = _steps(length / 2.0, step, still)
    tau = np.arange(-half, half + 1, dtype=np.float64) * step
    if kind == "rectangular":
        a = np.ones(2 * half + 1)
    elif kind == "half-sine":
        a = np.cos(math.pi * tau / length)
    elif kind == "ricker":
        a = _ricker(tau, 1.0 / period)
    else:
        a = mavroeidis_papageorgiou(tau, 1.0 / period, g, phase)
    name = f"{kind} pulse {a0:g} {unit}, {quantity} {needed:g} {'s' if by_length else 'Hz'}"
    return Motion(step, _then_quiet(a0 * a, zeros), name=name, synthetic=True, source=name)


_DT = 0.01
_SAMPLES = 3001
_SEED = 19950117
_PULSE_TIME = 7.0
_PARTS = {  # velocity of the pulse [m/s], its ν, strength of the rest [m/s²], its corner frequency [Hz]
    "x": (0.95, 0.4, 1.7, 3.0),
    "y": (0.30, 2.0, 1.7, 3.0),
    "z": (0.15, 1.0, 1.3, 7.0),
}


def _rise(t: NDArray[np.float64], start: float, end: float) -> NDArray[np.float64]:
    """Return a smooth step from 0 at ``start`` to 1 at ``end``: τ³(10 − 15τ + 6τ²)."""
    tau = np.clip((t - start) / (end - start), 0.0, 1.0)
    return tau**3 * (10.0 - 15.0 * tau + 6.0 * tau**2)


def _envelope(t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the strength with time: a weak P phase from 2 s, the strong part to 11 s, a decay."""
    onset = 0.15 * _rise(t, 2.0, 4.0) + 0.85 * _rise(t, 5.0, 6.5)
    decay = np.exp(-0.28 * np.logaddexp(0.0, t - 11.0))
    return onset * decay * _rise(t[-1] - t, 0.0, 6.0)


def _band(t: NDArray[np.float64], corner: float, draw: random.Random) -> NDArray[np.float64]:
    """Return a random band, 0.3–20 Hz and strongest below ``corner``, of unit mean square in its strong part.

    The envelope shapes the displacement, so that velocity and displacement come back to zero.
    """
    f = np.arange(0.3, 20.0, 1.0 / t[-1])
    size = (f / 0.6) ** 2 / (1.0 + (f / 0.6) ** 2) / (1.0 + (f / corner) ** 2)
    phase = np.array([2.0 * math.pi * draw.random() for _ in f])
    w = 2.0 * math.pi * f
    waves = size / (w * w) @ np.cos(w[:, None] * t + phase[:, None])
    shaped = np.pad(_envelope(t) * waves, 1)
    return np.diff(shaped, 2) / _DT**2 / math.sqrt(0.5 * float(size @ size))


def _ending_at_rest(a: NDArray[np.float64], t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Take off two smooth bumps so that velocity and displacement end at zero, in whole quanta.

    `stayput.motion.processing.ending_at_rest` does so to the last quantum; this record keeps the bits
    that it always had.
    """
    window = np.sin(math.pi * t / t[-1]) ** 2
    bumps = np.stack((window, window * (t / t[-1] - 0.5)))
    moments = np.stack((np.ones_like(t), t))  # ∫a dt and ∫a t dt: both ends of the record are zero
    a = a - np.linalg.solve(moments @ bumps.T, moments @ a) @ bumps
    whole = np.rint(a / QUANTUM)
    excess = int(whole.sum())
    first = (len(whole) - abs(excess)) // 2
    whole[first : first + abs(excess)] -= math.copysign(1.0, excess)
    return whole * QUANTUM


@cache
def near_fault() -> Motion:
    """Make the built-in near-fault record: synthetic, three components, the same bits every time.

    A Mavroeidis–Papageorgiou velocity pulse of 0.9 s period, as large as the 1995 Kobe earthquake's, and
    a random band around it under an envelope. It shows what such shaking does; it is no
    recorded earthquake and no code's design motion.

    Returns
    -------
    Motion
        30 s at 0.01 s; velocity and displacement end at zero.

    Examples
    --------
    >>> import stayput as sp
    >>> motion = sp.near_fault()
    >>> for name, peaks in motion.peaks().items():
    ...     print(f"{name}: {peaks.pga:.1f} m/s², {100 * peaks.pgv:.0f} cm/s, {100 * peaks.pgd:.0f} cm")
    x: 7.3 m/s², 89 cm/s, 15 cm
    y: 5.5 m/s², 63 cm/s, 15 cm
    z: 3.8 m/s², 26 cm/s, 5 cm
    >>> round(motion.intensity, 1)  # JMA's
    6.3
    """
    t = _DT * np.arange(_SAMPLES, dtype=np.float64)
    draw = random.Random(_SEED)
    samples: dict[str, Any] = {}
    for name, (velocity, nu, strength, corner) in _PARTS.items():
        pulse = velocity * mavroeidis_papageorgiou(t - _PULSE_TIME, 1.0 / 0.9, 2.0, nu)
        samples[name] = _ending_at_rest(pulse + strength * _band(t, corner, draw), t)
    source = "Mavroeidis-Papageorgiou pulse and a random band, fixed seed; not a recorded earthquake"
    return Motion(_DT, **samples, name="synthetic near-fault motion", synthetic=True, source=source)
