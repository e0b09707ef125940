"""Natural modes of a shear building, their damping and steps; its stiffnesses by Japanese seismic design.

Storey shears: Building Standard Law of Japan, enforcement order, article 88, and notification 1793 of 1980.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

STEPS_IN_A_PERIOD = 10.0
"""Fewest steps in a period of the modes that matter; lines through such samples of a sine cut off ≤ 5 %."""

MASS_THAT_MATTERS = 0.95
"""Share of the mass that the modes that matter move together."""


@dataclass(frozen=True, slots=True, eq=False)
class Modes:
    """Modes of K φ = ω² M φ with φᵀMφ = 1, the slowest first.

    Parameters
    ----------
    omega : ndarray, shape (n,)
        Natural circular frequencies ω [rad/s].
    shapes : ndarray, shape (n, n)
        φ: a row for each mass, bottom to top, a column for each mode [1/√kg].
    participation : ndarray, shape (n,)
        Γ = φᵀM1 [√kg]; the signs of the modes are such that none is negative.
    """

    omega: NDArray[np.float64]
    shapes: NDArray[np.float64]
    participation: NDArray[np.float64]

    @property
    def periods(self) -> NDArray[np.float64]:
        """Natural periods [s], shape (n,), the longest first."""
        return 2.0 * math.pi / self.omega

    @property
    def effective_mass(self) -> NDArray[np.float64]:
        """Share of the whole mass that each mode moves, Γ²/ΣM, shape (n,); the sum is 1."""
        square = self.participation**2
        return square / square.sum()

    @property
    def drifts(self) -> NDArray[np.float64]:
        """Drift of each storey in each mode, φᵢ − φᵢ₋₁ [1/√kg], shape (n, n)."""
        return np.diff(self.shapes, axis=0, prepend=0.0)


def natural_modes(masses: NDArray[np.float64], stiffnesses: NDArray[np.float64]) -> Modes:
    """Return the modes of masses [kg] on storeys of given stiffness [N/m], both shape (n,), bottom to top.

    M^(−1/2) K M^(−1/2) is tridiagonal, and its solver calls no threaded library: the same bits every time.
    """
    from scipy.linalg import eigh_tridiagonal  # pyright: ignore[reportUnknownVariableType]

    root = np.sqrt(masses)
    diagonal = (stiffnesses + np.append(stiffnesses[1:], 0.0)) / masses
    beside = -stiffnesses[1:] / (root[1:] * root[:-1])
    squares, vectors = diagonal, np.ones((1, 1))
    if len(masses) > 1:
        squares, vectors = cast("tuple[NDArray[np.float64], ...]", eigh_tridiagonal(diagonal, beside))
    shapes = vectors / root[:, None]
    gamma = (masses[:, None] * shapes).sum(axis=0)
    sign = np.where(gamma < 0.0, -1.0, 1.0)
    return Modes(np.sqrt(squares), np.ascontiguousarray(shapes * sign), gamma * sign)


def strain_energy_damping(
    modes: Modes, stiffnesses: NDArray[np.float64], ratios: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the damping ratio of each mode: the storeys' ratios, weighted by their strain energies.

    ζⱼ = Σₛ ζₛ Eₛⱼ / Σₛ Eₛⱼ with Eₛⱼ = ½ kₛ (φₛⱼ − φₛ₋₁,ⱼ)² (composite damping).

    Parameters
    ----------
    modes : Modes
        The modes.
    stiffnesses : ndarray, shape (n,)
        Of the storeys [N/m], bottom to top.
    ratios : ndarray, shape (n,)
        Damping ratio of each storey.
    """
    energy = stiffnesses[:, None] * modes.drifts**2
    return (ratios[:, None] * energy).sum(axis=0) / energy.sum(axis=0)


def parts_of_step(modes: Modes, dt: float) -> int:
    """Return into how many parts to divide a record's step, so that the floors' motion is well sampled.

    The solution is exact at any step, but a floor's motion is taken as linear between its samples from then
    on. Counted are the slowest modes that together move `MASS_THAT_MATTERS` of the mass. Modes faster than
    two of the record's steps (its Nyquist frequency) are not, as the record does not contain their motion.
    """
    share = np.cumsum(modes.effective_mass)
    shortest = float(modes.periods[min(int(np.searchsorted(share, MASS_THAT_MATTERS)), len(share) - 1)])
    return max(1, math.ceil(STEPS_IN_A_PERIOD * dt / max(shortest, 2.0 * dt) - 1e-9))


CORNER_PERIOD = 0.6
"""Period from which the spectral factor falls, medium ground (default, low confidence) [s]."""


def weight_above(masses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the mass that each storey carries [kg], shape (n,), bottom to top."""
    return np.cumsum(masses[::-1])[::-1]


def ai_distribution(masses: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Return Ai = 1 + (1/√αi − αi)·2T/(1 + 3T), αi the share of the weight that storey i carries.

    Parameters
    ----------
    masses : ndarray, shape (n,)
        Of the floors above the storeys [kg], bottom to top.
    period : float
        T, the building's fundamental period [s].

    Returns
    -------
    ndarray, shape (n,)
        1 at the lowest storey.
    """
    above = weight_above(masses)
    alpha = above / above[0]
    return 1.0 + (1.0 / np.sqrt(alpha) - alpha) * 2.0 * period / (1.0 + 3.0 * period)


def spectral_factor(period: float) -> float:
    """Return Rt, which reduces the shears of a slow building: 1, then a parabola, then 1.6 Tc/T."""
    ratio = period / CORNER_PERIOD
    if ratio < 1.0:
        return 1.0
    return 1.0 - 0.2 * (ratio - 1.0) ** 2 if ratio < 2.0 else 1.6 / ratio


def storey_stiffnesses(masses: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Return the stiffnesses [N/m], shape (n,), under which Ai's shears give every storey the same drift.

    They are scaled so that the first natural period is ``period``.
    """
    shape = ai_distribution(masses, period) * weight_above(masses)
    omega = float(natural_modes(masses, shape).omega[0])
    return shape * (2.0 * math.pi / period / omega) ** 2
