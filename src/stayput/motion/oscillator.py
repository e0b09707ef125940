"""A damped oscillator on a floor whose acceleration is linear between samples, without approximation.

    ü + 2ζω u̇ + ω²u = −a(t),    a(τ) = a₀ + (a₁ − a₀) τ/h   for 0 ≤ τ ≤ h

u is the displacement relative to the floor. Over a step the solution is a line plus a damped sine, so that
(u, u̇) at its end is a linear function of (u, u̇, a₀, a₁) at its start (Nigam and Jennings 1969).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.compiling import entry, inline, inner
from stayput.mechanics.elementary import exponential, sine_and_cosine

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

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
