"""Floors of a linear building by modal superposition, exact for a ground that is linear between its samples.

    q̈ⱼ + 2ζⱼωⱼ q̇ⱼ + ωⱼ² qⱼ = −Γⱼ a(t),    u = Σⱼ φⱼ qⱼ

The absolute acceleration of the floors is ü + a = −Σⱼ φⱼ (2ζⱼωⱼ q̇ⱼ + ωⱼ² qⱼ), because Σⱼ φⱼ Γⱼ = 1. Every
mode is kept, and every sum is taken in the order of the modes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.compiled import entry, inner
from stayput.motion.oscillator import step_coefficients

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

STEP_ROWS = 10
"""Rows of a step's coefficients: those of `step_coefficients`, then 2ζω and ω²."""


@entry
def fill_step(
    omega: NDArray[np.float64], zeta: NDArray[np.float64], h: float, step: NDArray[np.float64]
) -> None:
    """Fill the coefficients of a step h [s] of every mode, shape (STEP_ROWS, n)."""
    for j in range(len(omega)):
        uu, uv, u0, u1, vu, vv, v0, v1 = step_coefficients(omega[j], zeta[j], h)
        step[0, j], step[1, j], step[2, j], step[3, j] = uu, uv, u0, u1
        step[4, j], step[5, j], step[6, j], step[7, j] = vu, vv, v0, v1
        step[8, j], step[9, j] = 2.0 * zeta[j] * omega[j], omega[j] * omega[j]


@inner
def combine(weights: NDArray[np.float64], values: NDArray[np.float64], out: NDArray[np.float64]) -> None:
    """Fill out = Σⱼ weights[j] values[j], each sum in the order of j; weights has shape (n, rows)."""
    for r in range(len(out)):
        out[r] = 0.0
    for j in range(len(values)):
        value = values[j]
        for r in range(len(out)):
            out[r] += weights[j, r] * value


@entry
def linear_histories(
    a: NDArray[np.float64],
    step: NDArray[np.float64],
    gamma: NDArray[np.float64],
    shapes: NDArray[np.float64],
    drifts: NDArray[np.float64],
    scratch: NDArray[np.float64],
    acceleration: NDArray[np.float64],
    drift: NDArray[np.float64],
) -> None:
    """Find the floors' absolute accelerations and the storeys' drifts at the samples of the ground.

    Parameters
    ----------
    a : ndarray, shape (m,)
        Acceleration of the ground [m/s²].
    step : ndarray, shape (STEP_ROWS, n)
        Coefficients of one step, of `fill_step`.
    gamma : ndarray, shape (n,)
        Participation of the modes.
    shapes : ndarray, shape (n, floors)
        A row for each mode, a column for each floor that is wanted.
    drifts : ndarray, shape (n, storeys)
        The same for the drifts; no columns where none are wanted.
    scratch : ndarray, shape (3, n)
        Room to work in.
    acceleration : ndarray, shape (m, floors)
        Filled [m/s²].
    drift : ndarray, shape (m, storeys)
        Filled [m].
    """
    q, rate, force = scratch[0], scratch[1], scratch[2]
    for j in range(len(q)):
        q[j], rate[j], force[j] = 0.0, 0.0, 0.0
    combine(shapes, force, acceleration[0])
    combine(drifts, q, drift[0])
    for k in range(1, len(a)):
        before, now = a[k - 1], a[k]
        for j in range(len(q)):
            a0, a1 = gamma[j] * before, gamma[j] * now
            u, v = q[j], rate[j]
            q[j] = step[0, j] * u + step[1, j] * v + step[2, j] * a0 + step[3, j] * a1
            rate[j] = step[4, j] * u + step[5, j] * v + step[6, j] * a0 + step[7, j] * a1
            force[j] = -(step[8, j] * rate[j] + step[9, j] * q[j])
        combine(shapes, force, acceleration[k])
        combine(drifts, q, drift[k])
