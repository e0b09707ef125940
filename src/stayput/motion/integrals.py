"""Integrals and peaks of an acceleration that is linear between its samples, without approximation.

In a segment of length h the acceleration is a(τ) = a₀ + sτ with s = (a₁ − a₀)/h, so the velocity is a
parabola, the displacement a cubic, and ∫a² a cubic too: every peak below is the peak of those curves,
not of their samples. The floor starts at rest.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stayput.model.parameters import STANDARD_GRAVITY


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


@dataclass(frozen=True, slots=True)
class Peaks:
    """Peaks and integral measures of one component.

    Parameters
    ----------
    pga, pgv, pgd : float
        Largest magnitude of acceleration [m/s²], velocity [m/s] and displacement [m].
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
            arias=arias_intensity(a, dt),
            cav=magnitude(a, dt),
            significant_duration=significant_duration(a, dt),
        )
