"""Random numbers of several distributions, whose bits depend on the seed alone."""

from __future__ import annotations

import math
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np

from stayput.randomness import random_bits, uniforms

if TYPE_CHECKING:
    from numpy.typing import NDArray

_TRUNCATED = 2.0
"""Normal draws are cut at this many standard deviations, so that no motion is absurd."""


class Draws:
    """A stream of random numbers.

    Parameters
    ----------
    *key : int
        Whole numbers from 0 to 2³² − 1 that name the stream; another key gives an independent stream.
    """

    def __init__(self, *key: int) -> None:
        self._bits = random_bits(len(key), *key)

    def _uniforms(self, n: int) -> NDArray[np.float64]:
        """Return numbers inside (0, 1), of 53 bits, shape (n,)."""
        return uniforms(self._bits.random_raw(n))

    def uniform(self, low: float, high: float) -> float:
        """Return a number from low to high, all equally likely."""
        return low + (high - low) * float(self._uniforms(1)[0])

    def log_uniform(self, low: float, high: float) -> float:
        """Return a number from low to high whose logarithm is uniform."""
        return low * (high / low) ** self.uniform(0.0, 1.0)

    def normal(self) -> float:
        """Return a standard normal number, cut at ±2."""
        standard = NormalDist()
        return standard.inv_cdf(self.uniform(standard.cdf(-_TRUNCATED), standard.cdf(_TRUNCATED)))

    def lognormal(self, median: float, sigma: float) -> float:
        """Return a number of a median and a standard deviation of its logarithm, cut at ±2 of them."""
        return median * math.exp(sigma * self.normal())

    def choice(self, shares: tuple[float, ...]) -> int:
        """Return a place in ``shares``, which sum to 1, each as likely as its share."""
        u = self.uniform(0.0, 1.0)
        return min(sum(u > edge for edge in np.cumsum(shares)), len(shares) - 1)

    def noise(self, n: int) -> NDArray[np.float64]:
        """Return standard normal noise, shape (n,) (Box and Muller 1958)."""
        half = (n + 1) // 2
        u = self._uniforms(2 * half)
        radius, angle = np.sqrt(-2.0 * np.log(u[:half])), 2.0 * math.pi * u[half:]
        return np.concatenate((radius * np.cos(angle), radius * np.sin(angle)))[:n]
