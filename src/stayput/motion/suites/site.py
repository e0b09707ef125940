"""What the ground under a site does to the waves: the crust's gradient, and one soft layer."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

_FREQUENCIES = (0.01, 0.09, 0.16, 0.51, 0.84, 1.25, 2.26, 3.17, 6.05, 16.6, 61.2, 100.0)
_AMPLIFICATIONS = (1.00, 1.10, 1.18, 1.42, 1.58, 1.74, 2.06, 2.25, 2.58, 3.13, 4.00, 4.40)


def crust(f: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the amplification of generic rock, which gets softer upwards (Boore and Joyner 1997)."""
    return np.interp(np.log(np.maximum(f, 1e-3)), np.log(_FREQUENCIES), _AMPLIFICATIONS)


@dataclass(frozen=True, slots=True)
class SoilLayer:
    """A uniform damped layer on elastic rock.

    Parameters
    ----------
    period : float
        T = 4H/Vs for shear waves [s].
    impedance : float
        Ratio of the layer's impedance to the rock's, below 1.
    damping : float
        Damping ratio of the soil.
    """

    period: float
    impedance: float
    damping: float = 0.05

    def amplification(self, f: NDArray[np.float64], faster: float = 1.0) -> NDArray[np.float64]:
        """Return 1/|cos k + iα sin k|, k = (π/2) f T (1 − iξ) (Kramer 1996), shape of f.

        Parameters
        ----------
        f : ndarray, shape (n,)
            Frequencies [Hz].
        faster : float
            Velocity of these waves in the layer over that of shear waves.
        """
        k = 0.5 * math.pi * f * self.period / faster * (1.0 - 1j * self.damping)
        return 1.0 / np.abs(np.cos(k) + 1j * self.impedance * np.sin(k))
