"""The families of earthquakes that furniture meets, and the random draw of each motion's parameters.

The ranges are common knowledge of the field, not re-checked: defaults of low confidence.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np

from stayput.motion.suites.ground_motion import PointSource, SoilLayer
from stayput.uncertainty import random_bits, uniforms

if TYPE_CHECKING:
    from numpy.typing import NDArray

SEED_RANGE = (0, 2**32 - 1)
"""Smallest and largest seed that is accepted."""

NUMBER_RANGE = (1, 1_000_000)
"""Numbers of the motions of one family and seed."""

_TRUNCATION = 2.0
"""Normal draws are cut at this many standard deviations, so that no motion is absurd."""


class Draws:
    """A stream of random numbers of several distributions, whose bits depend on its key alone.

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
        return standard.inv_cdf(self.uniform(standard.cdf(-_TRUNCATION), standard.cdf(_TRUNCATION)))

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


@dataclass(frozen=True, slots=True)
class Family:
    """What motions of one kind have in common.

    Parameters
    ----------
    label : str
        What it is called in a motion's name.
    magnitudes : (float, float)
        Moment magnitudes, all equally likely.
    distances : (float, float)
        Distances from the fault [km], their logarithms equally likely.
    packets : tuple of float
        Shares of motions whose source breaks in 1, 2, ... parts.
    low_cut : float
        Frequency below which the motion fades out, so that it comes back to where it was [Hz].
    lengths : (float, float)
        Shortest and longest motion [s].
    pulse : bool
        Whether there is a velocity pulse along x.
    basin : bool
        Whether late surface waves of a basin follow.
    """

    label: str
    magnitudes: tuple[float, float]
    distances: tuple[float, float]
    packets: tuple[float, ...]
    low_cut: float
    lengths: tuple[float, float]
    pulse: bool = False
    basin: bool = False


KINDS: dict[str, Family] = {
    "near-fault": Family(
        label="near-fault",
        magnitudes=(6.5, 7.2),
        distances=(2.0, 12.0),
        packets=(1.0,),
        low_cut=0.10,
        lengths=(30.0, 30.0),
        pulse=True,
    ),
    "crustal": Family(
        label="crustal",
        magnitudes=(6.2, 7.3),
        distances=(10.0, 60.0),
        packets=(0.7, 0.3),
        low_cut=0.08,
        lengths=(40.0, 60.0),
    ),
    "subduction": Family(
        label="subduction",
        magnitudes=(7.8, 8.8),
        distances=(40.0, 120.0),
        packets=(0.4, 0.4, 0.2),
        low_cut=0.05,
        lengths=(100.0, 240.0),
    ),
    "basin": Family(
        label="long-period basin",
        magnitudes=(7.6, 8.8),
        distances=(50.0, 160.0),
        packets=(0.5, 0.5),
        low_cut=0.04,
        lengths=(240.0, 300.0),
        basin=True,
    ),
}
"""The families by name."""

FAMILIES: tuple[str, ...] = tuple(KINDS)
"""Names of the families."""

MIX: dict[str, float] = {"crustal": 0.35, "subduction": 0.30, "near-fault": 0.20, "basin": 0.15}
"""Shares of the families in a mixed suite: what furniture in Japan meets (a judgement, low confidence)."""


@dataclass(frozen=True, slots=True)
class Pulse:
    """A velocity pulse of Mavroeidis and Papageorgiou (2003): period [s], velocity [m/s], γ, ν [rad]."""

    period: float
    velocity: float
    gamma: float
    nu: float


@dataclass(frozen=True, slots=True)
class BasinWaves:
    """Late surface waves: period [s], strength over the body waves', delay [s], length [s], dispersion [s].

    The dispersion is by how much a wave of half the period comes later.
    """

    period: float
    strength: float
    delay: float
    length: float
    dispersion: float


@dataclass(frozen=True, slots=True)
class Parameters:
    """What is drawn for one motion: source, soil, the parts' shares of the source, pulse and basin waves."""

    source: PointSource
    soil: SoilLayer
    shares: tuple[float, ...]
    pulse: Pulse | None
    waves: BasinWaves | None

    def __str__(self) -> str:
        parts = [
            f"stochastic point source, M {self.source.magnitude:.2f} at {self.source.distance:.1f} km",
            f"stress drop {self.source.stress_drop:.1f} MPa, kappa {self.source.kappa:.3f} s",
            f"soil period {self.soil.period:.2f} s, impedance ratio {self.soil.impedance:.2f}",
        ]
        if len(self.shares) > 1:
            parts.append(f"{len(self.shares)} bursts")
        if self.pulse is not None:
            parts.append(f"pulse of {self.pulse.period:.2f} s, {self.pulse.velocity:.2f} m/s")
        if self.waves is not None:
            parts.append(f"basin waves of {self.waves.period:.1f} s, {self.waves.strength:.1f} times")
        return "; ".join(parts)


def draw_parameters(kind: Family, draw: Draws) -> Parameters:
    """Return the parameters of one motion of a family, drawn at random."""
    source = PointSource(
        magnitude=draw.uniform(*kind.magnitudes),
        distance=draw.log_uniform(*kind.distances),
        stress_drop=draw.lognormal(10.0, 0.5),
        kappa=draw.lognormal(0.035, 0.3),
    )
    soil = SoilLayer(period=draw.lognormal(0.5, 0.5), impedance=draw.uniform(0.25, 0.60))
    weights = [draw.uniform(0.5, 1.5) for _ in range(1 + draw.choice(kind.packets))]
    pulse = waves = None
    if kind.pulse:
        pulse = Pulse(
            period=draw.lognormal(1.1, 0.3),
            velocity=draw.lognormal(0.75, 0.35),
            gamma=draw.uniform(1.5, 2.5),
            nu=draw.uniform(0.0, 2.0 * math.pi),
        )
    if kind.basin:
        waves = BasinWaves(
            period=draw.uniform(3.0, 8.0),
            strength=draw.lognormal(2.6, 0.3),
            delay=draw.uniform(20.0, 50.0),
            length=draw.uniform(90.0, 150.0),
            dispersion=draw.uniform(15.0, 40.0),
        )
    return Parameters(source, soil, tuple(w / sum(weights) for w in weights), pulse, waves)
