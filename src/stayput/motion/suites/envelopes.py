"""How strong shaking is over its time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

EPSILON, ETA = 0.2, 0.05
"""The envelope peaks at ε of its length and has come down to η of its peak at its end (Boore 2003)."""


def saragoni_hart(t: NDArray[np.float64], start: float, length: float) -> NDArray[np.float64]:
    """Return w = a τᵇ e^(−cτ), τ = (t − start)/length, of peak 1; zero before the start.

    b = −ε ln η / [1 + ε(ln ε − 1)], c = b/ε, a = (e/ε)ᵇ. Saragoni and Hart (1974), as in Boore (2003),
    doi:10.1007/PL00012553.

    Parameters
    ----------
    t : ndarray, shape (n,)
        Times [s].
    start, length : float
        When it begins, and the time after which it has come down to η [s].
    """
    b = -EPSILON * math.log(ETA) / (1.0 + EPSILON * (math.log(EPSILON) - 1.0))
    tau = np.maximum(t - start, 0.0) / length
    return (math.e * tau / EPSILON) ** b * np.exp(-b * tau / EPSILON)


def ends_tapered(t: NDArray[np.float64], taper: float) -> NDArray[np.float64]:
    """Return 1 that comes smoothly from 0 over the first and to 0 over the last ``taper`` seconds of t."""
    tau = np.clip(np.minimum(t - t[0], t[-1] - t) / taper, 0.0, 1.0)
    return 0.5 - 0.5 * np.cos(math.pi * tau)
