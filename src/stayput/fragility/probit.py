"""Maximum likelihood of the probit model p = Φ(a + b v), for many sets of weights at once.

Shinozuka, Feng, Lee and Naganuma (2000); Baker (2015), equations 10 to 12. Its log-likelihood is concave, so
that Newton's method with halved steps finds the one maximum wherever there is one.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import log_ndtr, ndtri

if TYPE_CHECKING:
    from numpy.typing import NDArray

_STEPS = 40
_TOLERANCE = 1e-10
_HALVINGS = 12
_LOG_ROOT_2PI = 0.5 * math.log(2.0 * math.pi)


def log_likelihood(
    v: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64], ab: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return Σ k ln Φ(η) + (n − k) ln Φ(−η), η = a + b v, shape (sets,)."""
    eta = ab[:, :1] + ab[:, 1:] * v
    return (fell * log_ndtr(eta) + stood * log_ndtr(-eta)).sum(axis=1)


def derivatives(
    v: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64], ab: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return each cell's slope and curvature of the log-likelihood in η, shapes (sets, cells).

    With λ(η) = φ(η)/Φ(η): slope k λ(η) − (n − k) λ(−η); curvature, its sign turned,
    k λ(η)(λ(η) + η) + (n − k) λ(−η)(λ(−η) − η).
    """
    eta = ab[:, :1] + ab[:, 1:] * v
    log_density = -0.5 * eta * eta - _LOG_ROOT_2PI
    up = np.exp(log_density - log_ndtr(eta))
    down = np.exp(log_density - log_ndtr(-eta))
    return fell * up - stood * down, fell * up * (up + eta) + stood * down * (down - eta)


def information(v: NDArray[np.float64], curvature: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the observed information of (a, b) from each cell's curvature, shape (sets, 2, 2)."""
    aa, ab, bb = curvature.sum(axis=1), (curvature * v).sum(axis=1), (curvature * v * v).sum(axis=1)
    return np.stack((aa, ab, ab, bb), axis=1).reshape(-1, 2, 2)


def fit(
    v: NDArray[np.float64],
    fell: NDArray[np.float64],
    stood: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return (a, b) of the largest likelihood, shape (sets, 2).

    Parameters
    ----------
    v : ndarray, shape (cells,)
        Coordinate of each cell, of mean 0 and spread 1 or so.
    fell, stood : ndarray, shape (sets, cells)
        Counts, or weights, of each set. Each set must have a maximum: see `separated`.
    """
    ab = np.zeros((len(fell), 2))
    share = np.clip(fell.sum(axis=1) / (fell + stood).sum(axis=1), 1e-3, 1.0 - 1e-3)
    ab[:, 0] = ndtri(share)
    height = log_likelihood(v, fell, stood, ab)
    moving = np.arange(len(fell))
    for _ in range(_STEPS):
        k, s = fell[moving], stood[moving]
        slope, curvature = derivatives(v, k, s, ab[moving])
        gradient = np.stack((slope.sum(axis=1), (slope * v).sum(axis=1)), axis=1)
        step = solved(information(v, curvature), gradient)
        gain = 0.5 * (gradient * step).sum(axis=1)
        tried = ab[moving] + step
        reached = log_likelihood(v, k, s, tried)
        for _ in range(_HALVINGS):
            worse = reached < height[moving] - 1e-12 * np.abs(height[moving])
            if not worse.any():
                break
            step[worse] *= 0.5
            tried[worse] = ab[moving[worse]] + step[worse]
            reached[worse] = log_likelihood(v, k[worse], s[worse], tried[worse])
        ab[moving], height[moving] = tried, reached
        moving = moving[gain > _TOLERANCE]
        if not len(moving):
            break
    return ab


def solved(matrix: NDArray[np.float64], right: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the solution of each 2 × 2 system, shape (sets, 2)."""
    (p, q), (_, r) = matrix[:, 0].T, matrix[:, 1].T
    determinant = p * r - q * q
    x = (r * right[:, 0] - q * right[:, 1]) / determinant
    y = (p * right[:, 1] - q * right[:, 0]) / determinant
    return np.stack((x, y), axis=1)


def separated(
    v: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the lowest and highest fall, and the lowest and highest stand, of each set, shapes (sets,).

    There is a maximum with a finite slope where the two ranges overlap by more than a point (Albert and
    Anderson 1984). A range without a run is (∞, −∞).
    """
    falls, stands = fell > 0.0, stood > 0.0
    infinite = np.inf
    return (
        np.where(falls, v, infinite).min(axis=1),
        np.where(falls, v, -infinite).max(axis=1),
        np.where(stands, v, infinite).min(axis=1),
        np.where(stands, v, -infinite).max(axis=1),
    )
