"""A flat base on a floor that gives: the rigid base that takes as much to overturn.

A floor that gives in proportion to the pressure on it (Winkler) sinks by w₀ under the piece at rest. With
half the base a, the centre of gravity at height z and small tilts θ, the force N = mg acts, once part of the
base has lifted, at a third of the length c = √(4 a w₀/θ) that still presses, so that the piece is held by

    M/mg = a − z θ − c/3 = a − z θ − (2/3) √(a w₀/θ)        (partly lifted, θ > w₀/a)

instead of a − z θ on a rigid floor. It overturns where M = 0 for the second time, at θ*; the work up to there
is

    E/mg = a θ* − z θ*²/2 − (4/3) √(a w₀ θ*) + w₀/2.

A rigid base of half length a' takes E/mg = a'²/(2z). The mechanics get that base: the base corners are moved
inwards by a − a'. What is left out is how it rocks: the soft piece begins to tilt at once, and loses energy
in the floor. `tests/validation/test_soft_base.py` sets it beside a body on springs, step by step.

Sources: the moment on a Winkler foundation with uplift is that of Psycharis and Jennings (1983), and that the
energy decides over overturning is Housner's (1963); both were derived anew and not read again.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

LEAST = 0.2
"""Part of the half base that is left at least; a floor so soft is beyond small tilts and this law."""


def rigid_half_base(half_base: ArrayLike, height: ArrayLike, settlement: ArrayLike) -> NDArray[np.float64]:
    """Return a', half the rigid base that takes as much energy to overturn as one that sinks in [m].

    At least a fifth of a is left (`LEAST`), even of a piece that the floor does not hold upright at all.

    Parameters
    ----------
    half_base : float or ndarray
        a, from below the centre of gravity to the edge [m].
    height : float or ndarray
        z, of the centre of gravity above the base [m].
    settlement : float or ndarray
        w₀, by which the base sinks in under the piece at rest [m]; 0 returns a itself, to the bit.

    Examples
    --------
    >>> round(float(rigid_half_base(0.15, 0.9, 0.001)), 4)
    0.1088
    """
    each = (np.asarray(value, np.float64) for value in (half_base, height, settlement))
    a, z, w = np.broadcast_arrays(*each)
    if not w.any():  # as of what stands on its own
        return a.copy()
    with np.errstate(invalid="ignore", divide="ignore"):  # rows are refused where a or z is not above 0
        # √θ* is the largest root of z s³ − a s + (2/3) √(a w₀) = 0
        cosine = np.minimum(1.0, np.sqrt(3.0 * z * w) / a)
        root = np.sqrt(4.0 * a / (3.0 * z)) * np.cos(np.arccos(-cosine) / 3.0)
        tilt = root * root  # a power of a scalar may differ from that of a column in its last bit
        energy = a * tilt - z * tilt * tilt / 2.0 - (4.0 / 3.0) * np.sqrt(a * w) * root + w / 2.0
        stands = 3.0 * z * w < a * a  # else the whole base, still pressed, holds less than the tilt takes
        softer = np.sqrt(np.where(stands, np.maximum(0.0, 2.0 * z * energy), 0.0))
    # not to the last digits, which depend on the processor
    return np.where(w > 0.0, np.minimum(a, np.maximum(LEAST * a, np.round(softer, 10))), a)


def narrower_base(
    ends: tuple[ArrayLike, ArrayLike],
    heights: tuple[ArrayLike, ArrayLike],
    height: ArrayLike,
    settlement: ArrayLike,
) -> tuple[tuple[NDArray[np.float64], NDArray[np.float64]], tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Return the two ends of the rigid base that stands for one that sinks in, each with its height [m].

    It lies in the plane of the body's own base, so that a lean stays what it is.

    Parameters
    ----------
    ends : tuple of float or ndarray
        Of the body's own base at its back, below 0, and at its front, from below the centre of gravity [m].
    heights : tuple of float or ndarray
        Of these ends [m].
    height : float or ndarray
        z, of the centre of gravity [m].
    settlement : float or ndarray
        w₀ [m]; 0 returns the body's own base, to the bit.
    """
    back, front, low, high = (np.asarray(value, np.float64) for value in (*ends, *heights))
    halves = np.array(np.broadcast_arrays(-back, front, height, settlement)[:2])
    feet = rigid_half_base(halves, height, settlement)
    foot_back, foot_front = -feet[0], feet[1]
    rise = (high - low) / (front - back)
    return (foot_back, low + rise * (foot_back - back)), (foot_front, high + rise * (foot_front - front))


def landing_factor(
    place: ArrayLike, half_base_squared: ArrayLike, height: ArrayLike, inertia: ArrayLike
) -> NDArray[np.float64]:
    """Return the rotation rate after a landing inside the base over that after one on the corner.

    With the impulse at ξ a from below the centre of gravity, angular momentum about that place gives the
    ratio of rates r(ξ) = (K − ξ a²)/(K + ξ a²), K = J_G/m + z²; r(1) is Housner's.

    Parameters
    ----------
    place : float or ndarray
        ξ; 1 returns 1, to the bit.
    half_base_squared : float or ndarray
        a² [m²], or the product of the lengths to either side of a centre of gravity off the middle.
    height : float or ndarray
        z, of the centre of gravity above the base [m].
    inertia : float or ndarray
        J_G/m [m²].
    """
    xi, a2, z, I = (np.asarray(value, np.float64) for value in (place, half_base_squared, height, inertia))
    K = I + z * z
    at_corner = np.maximum(1e-3, (K - a2) / (K + a2))  # a body so squat does not rock on after a landing
    inside = (K - xi * a2) / (K + xi * a2)
    return np.where(xi < 1.0, np.maximum(1.0, inside / at_corner), 1.0)
