"""The families of earthquakes that furniture meets, the draw of each motion's parameters, and the model.

The ranges are common knowledge of the field, not re-checked: defaults of low confidence. The model is the
stochastic one of the ground's motion (Boore 2003), Fourier amplitudes and envelopes:

    A(f) = C M₀ (2πf)² S(f) · G(R) · e^(−πfR/(Qβ)) · e^(−πκf) · site(f),   C = Rθφ F V / (4πρβ³ · 1 km)
    S(f) = (1 − ε)/[1 + (f/fa)²] + ε/[1 + (f/fb)²],   f₀² = (1 − ε) fa² + ε fb²,   f₀ = 0.4906 β (Δσ/M₀)^(1/3)

Boore (2003), *Simulation of ground motion using the stochastic method*, doi:10.1007/PL00012553. A large fault
is no point: its spectrum sags between two corners. log₁₀ ε = 0.605 − 0.255 M and log₁₀ fa = 2.181 − 0.496 M
are those of Atkinson and Silva (2000) for California; fb is such that high frequencies are those of an ω²
source of the stress drop Δσ (Boore, Di Alessandro and Abrahamson 2014). The crust's values are those that are
usual for western North America (Campbell 2003). For Japan all are a default of low confidence; the
coefficients are not re-checked.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from stayput.errors import whole_within
from stayput.uncertainty import random_bits, uniforms

BETA = 3500.0
"""Velocity of shear waves β at the source [m/s]."""

DENSITY = 2800.0
"""Density ρ at the source [kg/m³]."""

RADIATION = 0.55
"""Radiation pattern Rθφ, the mean of all directions."""

SURFACE = 2.0
"""Free-surface factor F."""

SHARE = math.sqrt(0.5)
"""Share V of the shear wave in each horizontal component."""

QUALITY, QUALITY_POWER = 180.0, 0.45
"""Q = 180 f^0.45: damping along the path."""

BODY_WAVES = 40.0
"""Distance to which waves spread as 1/R; beyond it as 1/√R [km]."""

DURATION_PER_KM = 0.05
"""What the path adds to the duration [s/km]."""

# Amplification of generic rock by frequency [Hz] (Boore and Joyner 1997).
_CRUST_FREQUENCIES = (0.01, 0.09, 0.16, 0.51, 0.84, 1.25, 2.26, 3.17, 6.05, 16.6, 61.2, 100.0)
_CRUST_AMPLIFICATIONS = (1.00, 1.10, 1.18, 1.42, 1.58, 1.74, 2.06, 2.25, 2.58, 3.13, 4.00, 4.40)


@dataclass(frozen=True, slots=True)
class PointSource:
    """An earthquake as a site sees it.

    Parameters
    ----------
    magnitude : float
        Moment magnitude.
    distance : float
        From the fault's nearest part [km].
    stress_drop : float
        Δσ [MPa].
    kappa : float
        Site damping κ [s].
    """

    magnitude: float
    distance: float
    stress_drop: float
    kappa: float

    @property
    def moment(self) -> float:
        """Seismic moment M₀ = 10^(1.5 M + 9.05) [N m] (Hanks and Kanamori 1979)."""
        return 10.0 ** (1.5 * self.magnitude + 9.05)

    @property
    def effective_distance(self) -> float:
        """R = √(distance² + h²), h = 10^(0.235 M − 0.405) [km]: a large fault is not all near.

        Yenier and Atkinson (2015), doi:10.1785/0120140334 (the coefficients are not re-checked).
        """
        return math.hypot(self.distance, 10.0 ** (0.235 * self.magnitude - 0.405))

    @property
    def corner_frequency(self) -> float:
        """f₀ of the ω² source with the same high frequencies [Hz] (Brune 1970)."""
        return 0.4906 * BETA * (1e6 * self.stress_drop / self.moment) ** (1.0 / 3.0)

    @property
    def lower_corner(self) -> float:
        """Corner fa of the whole fault [Hz]."""
        return 10.0 ** (2.181 - 0.496 * self.magnitude)

    @property
    def weight(self) -> float:
        """ε: share of the source that has the upper corner."""
        return 10.0 ** (0.605 - 0.255 * self.magnitude)

    @property
    def upper_corner(self) -> float:
        """Corner fb of the fault's parts [Hz]; at least fa."""
        rest = self.corner_frequency**2 - (1.0 - self.weight) * self.lower_corner**2
        return math.sqrt(max(rest / self.weight, self.lower_corner**2))

    def amplitude(self, f: NDArray[np.float64], kappa_factor: float = 1.0) -> NDArray[np.float64]:
        """Return A(f) of a horizontal component on the crust's hardest rock [m/s], shape of f.

        Parameters
        ----------
        f : ndarray, shape (n,)
            Frequencies [Hz].
        kappa_factor : float
            On κ, for a component with its own.
        """
        r = self.effective_distance
        spread = 1.0 / r if r <= BODY_WAVES else 1.0 / math.sqrt(BODY_WAVES * r)
        c = RADIATION * SURFACE * SHARE / (4.0 * math.pi * DENSITY * BETA**3 * 1e3)
        whole = (1.0 - self.weight) / (1.0 + (f / self.lower_corner) ** 2)
        parts = self.weight / (1.0 + (f / self.upper_corner) ** 2)
        source = c * self.moment * (2.0 * math.pi * f) ** 2 * (whole + parts)
        path = 1e3 * r / (QUALITY * BETA) * f ** (1.0 - QUALITY_POWER)  # R f / (Q β)
        return source * spread * np.exp(-math.pi * (path + kappa_factor * self.kappa * f))


def crust_amplification(f: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the amplification of generic rock, which gets softer upwards (Boore and Joyner 1997)."""
    return np.interp(np.log(np.maximum(f, 1e-3)), np.log(_CRUST_FREQUENCIES), _CRUST_AMPLIFICATIONS)


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


EPSILON, ETA = 0.2, 0.05
"""The envelope peaks at ε of its length and has come down to η of its peak at its end (Boore 2003)."""

DT = 0.01
"""Time step [s]."""

QUIET = 2.0
"""Still time before the P waves [s]."""

OMORI_VELOCITY = 8.0
"""Distance over the time from P to S waves [km/s] (Omori's formula)."""

ENVELOPE_LENGTH = 2.0
"""Length of a burst's envelope over its duration (Boore 2003)."""


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


def cosine_taper(t: NDArray[np.float64], taper: float) -> NDArray[np.float64]:
    """Return a cosine taper: 0 at both ends of t, 1 beyond ``taper`` seconds from them."""
    tau = np.clip(np.minimum(t - t[0], t[-1] - t) / taper, 0.0, 1.0)
    return 0.5 - 0.5 * np.cos(math.pi * tau)


def s_arrival(params: Parameters) -> float:
    """Return when the shear waves come [s]; the P waves come at `QUIET`."""
    return QUIET + params.source.effective_distance / OMORI_VELOCITY


def _bursts(params: Parameters) -> list[tuple[float, float, float]]:
    """Return start [s], length of the envelope [s] and share of each burst of the shear waves."""
    start, bursts = s_arrival(params), list[tuple[float, float, float]]()
    of_path = DURATION_PER_KM * params.source.effective_distance
    for share in params.shares:
        duration = share * (0.5 / params.source.lower_corner)  # of 1/(2 fa) (Atkinson and Silva 2000)
        bursts.append((start, ENVELOPE_LENGTH * (duration + of_path), share))
        start += ENVELOPE_LENGTH * duration
    return bursts


def step_count(family: Family, params: Parameters) -> int:
    """Return the number of time steps: whole tens of seconds, till the last envelope has come down."""
    end = max(start + length for start, length, _ in _bursts(params))
    if params.waves is not None:
        late = params.waves.delay + params.waves.dispersion + 1.3 * params.waves.length
        end = max(end, s_arrival(params) + late)
    shortest, longest = family.lengths
    return round(min(max(10.0 * math.ceil(end / 10.0), shortest), longest) / DT)


def envelope(t: NDArray[np.float64], params: Parameters, p_waves: float) -> NDArray[np.float64]:
    """Return the strength of the body waves over time, shape of t: bursts of S waves, P waves before them.

    Parameters
    ----------
    t : ndarray, shape (n,)
        Times [s].
    params : Parameters
        The motion's.
    p_waves : float
        Strength of the P waves over the S waves'.
    """
    power = np.zeros_like(t)
    for start, length, share in _bursts(params):
        power += share / length * saragoni_hart(t, start, length) ** 2
        early = QUIET + start - s_arrival(params)
        power += p_waves**2 * share / length * saragoni_hart(t, early, length) ** 2
    return np.sqrt(power)


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

    @staticmethod
    def key(seed: int, kind: int, number: int) -> tuple[int, int, int]:
        """Return the beginning of the keys of a motion's streams; refuse a seed or a number out of range."""
        first = whole_within("common.seed", seed, *SEED_RANGE, field="seed")
        return first, kind, whole_within("number", number, *NUMBER_RANGE, field="number")

    def __init__(self, *key: int) -> None:
        self._bits = random_bits(len(key), *key)

    def uniform(self, low: float, high: float) -> float:
        """Return a number from low to high, all equally likely."""
        return low + (high - low) * float(uniforms(self._bits.random_raw(1))[0])

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
        u = uniforms(self._bits.random_raw(2 * half))
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
