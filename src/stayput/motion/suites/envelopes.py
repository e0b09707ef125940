"""Envelopes of a synthetic motion: when its waves arrive, how long they last, how strong they are."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.suites.families import Family, Parameters

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
