"""When the parts of a synthetic motion come, how long it lasts, and how strong it is over its time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.motion.suites.envelopes import saragoni_hart

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.suites.families import Family, Parameters

DT = 0.01
"""Time step [s]."""

QUIET = 2.0
"""Before the first wave [s]."""

KM_PER_SECOND_LATE = 8.0
"""Distance in km for each second by which S waves come after P waves (Omori)."""

ENVELOPE_LENGTH = 2.0
"""Length of a burst's envelope over its duration (Boore 2003)."""


def s_arrival(parts: Parameters) -> float:
    """Return when the shear waves come [s]; the P waves come at `QUIET`."""
    return QUIET + parts.source.effective_distance / KM_PER_SECOND_LATE


def _bursts(parts: Parameters) -> list[tuple[float, float, float]]:
    """Return start [s], length of the envelope [s] and share of each burst of the shear waves."""
    start, found = s_arrival(parts), list[tuple[float, float, float]]()
    for share in parts.shares:
        duration = share * parts.source.source_duration
        found.append((start, ENVELOPE_LENGTH * (duration + parts.source.path_duration), share))
        start += ENVELOPE_LENGTH * duration
    return found


def steps(kind: Family, parts: Parameters) -> int:
    """Return the number of time steps: whole tens of seconds, till the last envelope has come down."""
    end = max(start + length for start, length, _ in _bursts(parts))
    if parts.waves is not None:
        late = parts.waves.delay + parts.waves.dispersion + 1.3 * parts.waves.length
        end = max(end, s_arrival(parts) + late)
    shortest, longest = kind.lengths
    return round(min(max(10.0 * math.ceil(end / 10.0), shortest), longest) / DT)


def envelope(t: NDArray[np.float64], parts: Parameters, p_waves: float) -> NDArray[np.float64]:
    """Return the strength of the body waves over time, shape of t: bursts of S waves, P waves before them.

    Parameters
    ----------
    t : ndarray, shape (n,)
        Times [s].
    parts : Parameters
        Of the motion.
    p_waves : float
        Strength of the P waves over the S waves'.
    """
    power = np.zeros_like(t)
    for start, length, share in _bursts(parts):
        power += share / length * saragoni_hart(t, start, length) ** 2
        early = QUIET + start - s_arrival(parts)
        power += p_waves**2 * share / length * saragoni_hart(t, early, length) ** 2
    return np.sqrt(power)
