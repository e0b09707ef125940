"""ASCE/SEI 43-05, appendix A: the approximate sliding distance of an unanchored body.

Partly legible: μ_e, c_s and the frequency f_es were read; that the distance is c_s/(2π f_es)² is presumed,
since the equation itself was not legible. The appendix's method for rocking was not legible enough.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import not_allowed, within
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY
from stayput.motion.record import Motion

DAMPING = 0.10
"""Damping ratio of the vector spectral acceleration."""

FRICTION_RANGE = (0.001, 10.0)
"""Smallest and largest μ of which the method is asked."""

VERTICAL_SHARE = 0.4
"""Part of the peak vertical acceleration that lightens the body as it slides."""

FREQUENCIES = np.geomspace(0.1, 33.0, 201)
"""Frequencies at which the spectrum is taken, increasing [Hz], shape (201,)."""
FREQUENCIES.setflags(write=False)

COARSE = 2
"""Which of them are computed at first: every second."""

AT_ONCE = 20
"""How many of these at once, from the lowest on: those far above the crossing take longest, and are not."""


@dataclass(frozen=True, slots=True)
class SlidingEstimate:
    """What the approximate method says of sliding.

    Parameters
    ----------
    effective_friction : float
        μ_e.
    coefficient : float
        c_s = 2 μ_e g [m/s²].
    frequency : float
        f_es, the lowest frequency at which the spectrum reaches c_s [Hz]; NaN where it nowhere does, or is
        above it from the first of `FREQUENCIES` on.
    distance : float
        Best-estimate sliding distance, presumably c_s/(2π f_es)² [m]; NaN without f_es, of which what was
        read says nothing.
    """

    effective_friction: float
    coefficient: float
    frequency: float
    distance: float


def asce43_sliding(motion: Motion, friction: float, gravity: float = STANDARD_GRAVITY) -> SlidingEstimate:
    """Return the approximate sliding distance of an unanchored body by ASCE/SEI 43-05, appendix A.

    μ_e = μ(1 − 0.4 A_v/g) with the peak vertical acceleration A_v, c_s = 2 μ_e g; f_es is the lowest
    frequency at which the 10 % damped vector spectral acceleration, √(Sa,x² + Sa,y²), equals c_s.

    Parameters
    ----------
    motion : Motion
        The floor's motion; without y the vector is x alone, without z there is no A_v.
    friction : float
        μ.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A friction or a gravity out of range, or A_v of 2.5 g and more, which leaves no friction: beyond the
        method.

    Examples
    --------
    >>> import stayput as sp
    >>> estimate = sp.asce43_sliding(sp.near_fault(), friction=0.3)
    >>> round(estimate.frequency, 2), round(estimate.distance, 2)  # Hz, m
    (0.56, 0.4)
    >>> low, floor = sp.Body(width=1.0, height=0.5, mass=100.0), sp.Floor(0.3, 0.3)
    >>> run = sp.simulate(low, sp.Room(floor), sp.near_fault())
    >>> round(run.peak_slide, 2)  # simulated [m]
    0.17
    """
    Motion.given(motion)
    mu = within("friction", friction, *FRICTION_RANGE, field="friction")
    GRAVITY.check(gravity)
    vertical = 0.0 if motion.z is None else float(np.abs(motion.z).max())
    most = gravity / VERTICAL_SHARE
    if vertical >= most:
        allowed = phrase("common.under", share=f"{most:.3g} m/s²")
        raise not_allowed("model.vertical_peak", f"{vertical:.3g} m/s²", allowed, "motion")
    effective = mu * (1.0 - VERTICAL_SHARE * vertical / gravity)
    c_s = 2.0 * effective * gravity
    frequency = _first_crossing(motion, c_s)
    return SlidingEstimate(effective, c_s, frequency, c_s / (2.0 * math.pi * frequency) ** 2)


def _first_crossing(motion: Motion, level: float) -> float:
    """Return the lowest frequency at which the spectrum reaches a level [Hz], in log-log lines, or NaN.

    Only every second frequency is computed, and that in between where it is reached: with such damping a
    spectrum has no peak as narrow as that, 6 % of its frequency.
    """
    coarse = FREQUENCIES[::COARSE]
    for first in range(0, len(coarse), AT_ONCE):
        above = np.flatnonzero(_vector_spectrum(motion, coarse[first : first + AT_ONCE]) >= level)
        if len(above):
            break
    else:
        return math.nan
    place = first + int(above[0])
    if place == 0:
        return math.nan
    fine = FREQUENCIES[COARSE * (place - 1) : COARSE * place + 1]
    sa = _vector_spectrum(motion, fine)
    last = int(np.flatnonzero(sa >= level)[0])
    ends = slice(last - 1, last + 1)
    return float(np.exp(np.interp(math.log(level), np.log(sa[ends]), np.log(fine[ends]))))


def _vector_spectrum(motion: Motion, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return √(Sa,x² + Sa,y²) at increasing frequencies [m/s²]."""
    rows = [motion.spectrum(1.0 / frequencies[::-1], DAMPING, name).sa[::-1] for name in motion.horizontal]
    return np.sqrt(sum(np.square(row) for row in rows))
