"""The numbers that sum up one component of a record."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.motion import integrals
from stayput.motion.units import STANDARD_GRAVITY

if TYPE_CHECKING:
    from numpy.typing import NDArray


def arias_intensity(a: NDArray[np.float64], dt: float) -> float:
    """Return π/(2g)·∫a² dt [m/s] of an acceleration [m/s²], shape (n,) (Arias 1970)."""
    return math.pi / (2.0 * STANDARD_GRAVITY) * float(integrals.square(a, dt)[-1])


def significant_duration(a: NDArray[np.float64], dt: float) -> float:
    """Return the time in which ∫a² dt grows from 5 % to 95 % [s] (Trifunac and Brady 1975)."""
    return integrals.time_of_share(a, dt, 0.95) - integrals.time_of_share(a, dt, 0.05)


@dataclass(frozen=True, slots=True)
class Peaks:
    """What an engineer reads first of one component.

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
            pgv=integrals.peak_velocity(a, dt),
            pgd=integrals.peak_displacement(a, dt),
            arias=arias_intensity(a, dt),
            cav=integrals.magnitude(a, dt),
            significant_duration=significant_duration(a, dt),
        )
