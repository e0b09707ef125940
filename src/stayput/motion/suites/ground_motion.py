"""The stochastic model of the ground's motion (Boore 2003): Fourier amplitudes and envelopes.

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
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.suites.families import Family, Parameters

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

    @property
    def source_duration(self) -> float:
        """1/(2 fa) [s] (Atkinson and Silva 2000)."""
        return 0.5 / self.lower_corner

    @property
    def path_duration(self) -> float:
        """What the path adds [s]."""
        return DURATION_PER_KM * self.effective_distance

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
    for share in params.shares:
        duration = share * params.source.source_duration
        bursts.append((start, ENVELOPE_LENGTH * (duration + params.source.path_duration), share))
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
