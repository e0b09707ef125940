"""Storey shears of Japanese seismic design, and the stiffnesses that follow from them.

Building Standard Law of Japan, enforcement order, article 88, and notification 1793 of 1980.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.building.modes import natural_modes

if TYPE_CHECKING:
    from numpy.typing import NDArray

CORNER_PERIOD = 0.6
"""Period from which the spectral factor falls, medium ground (default, low confidence) [s]."""


def weight_above(masses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the mass that each storey carries [kg], shape (n,), bottom to top."""
    return np.cumsum(masses[::-1])[::-1]


def ai_distribution(masses: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Return Ai = 1 + (1/√αi − αi)·2T/(1 + 3T), αi the share of the weight that storey i carries.

    Parameters
    ----------
    masses : ndarray, shape (n,)
        Of the floors above the storeys [kg], bottom to top.
    period : float
        T, the building's fundamental period [s].

    Returns
    -------
    ndarray, shape (n,)
        1 at the lowest storey.
    """
    above = weight_above(masses)
    alpha = above / above[0]
    return 1.0 + (1.0 / np.sqrt(alpha) - alpha) * 2.0 * period / (1.0 + 3.0 * period)


def spectral_factor(period: float) -> float:
    """Return Rt, which reduces the shears of a slow building: 1, then a parabola, then 1.6 Tc/T."""
    ratio = period / CORNER_PERIOD
    if ratio < 1.0:
        return 1.0
    return 1.0 - 0.2 * (ratio - 1.0) ** 2 if ratio < 2.0 else 1.6 / ratio


def storey_stiffnesses(masses: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Return the stiffnesses [N/m], shape (n,), under which Ai's shears give every storey the same drift.

    They are scaled so that the first natural period is ``period``.
    """
    shape = ai_distribution(masses, period) * weight_above(masses)
    omega = float(natural_modes(masses, shape).omega[0])
    return shape * (2.0 * math.pi / period / omega) ** 2
