"""Inertia tensors: from second moments, of a truncated cone, and their principal axes."""

from __future__ import annotations

from itertools import permutations

import numpy as np
from numpy.typing import ArrayLike, NDArray


def inertia_of(second_moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the inertia tensor of a unit mass with these second moments, tr(S) 1 − S, shape (3, 3) [m²]."""
    return np.trace(second_moments) * np.eye(3) - second_moments


def moments_of_furniture(
    width: ArrayLike, length: ArrayLike, height: ArrayLike, inertia: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the principal moments of inertia of a piece of furniture over its mass, about x, y and z [m²].

    Along its length the mass is spread evenly. In the section it is spread as in the uniform rectangle, and
    drawn together or apart in both directions so that the moment about y is as given.

    Parameters
    ----------
    width, length, height : float or ndarray
        Sides along x, y and z [m].
    inertia : float or ndarray
        Moment of inertia about y over the mass [m²].
    """
    b, l, h, I = (np.asarray(value, np.float64) for value in (width, length, height, inertia))
    spread = I / (b * b + h * h)
    deep, tall = spread * b * b, spread * h * h
    across = l * l / 12.0
    return across + tall, deep + tall, deep + across


def uniform_cone(R: float, r: float, h: float) -> tuple[float, NDArray[np.float64]]:
    """Return where the centroid of an evenly filled truncated cone is, and its second moments.

    Integrals over the height of powers of the radius, which goes from R to r.

    Parameters
    ----------
    R, r : float
        Radius of the lower and of the upper end [m].
    h : float
        Height [m].

    Returns
    -------
    height : float
        Height of the centroid above the lower end [m].
    second_moments : ndarray, shape (3, 3)
        Mean of x xᵀ over the volume, x from the centroid, z along the axis [m²].
    """
    squares = R * R + R * r + r * r
    height = h * (R * R + 2.0 * R * r + 3.0 * r * r) / (4.0 * squares)
    across = 3.0 * (R**4 + R**3 * r + R * R * r * r + R * r**3 + r**4) / (20.0 * squares)
    along = h * h * (R * R + 3.0 * R * r + 6.0 * r * r) / (10.0 * squares) - height * height
    return height, np.diag([across, across, along])


def principal_axes(inertia: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the principal moments, shape (3,), and the rotation R, shape (3, 3), whose columns are the axes.

    The tensor is R diag(moments) Rᵀ. The axes have the order and the signs that bring R nearest to the
    identity; of a diagonal tensor it is the identity itself.

    Parameters
    ----------
    inertia : ndarray, shape (3, 3)
        A symmetric tensor.
    """
    diagonal = np.diag(np.diag(inertia))
    # what is left of rounding would turn the axes of equal moments anywhere
    slight = np.abs(inertia) <= 1e-13 * np.trace(inertia)
    moments, axes = np.linalg.eigh(np.where(slight, diagonal, inertia))
    order = list(max(permutations(range(3)), key=lambda p: sum(abs(axes[i, p[i]]) for i in range(3))))
    moments, axes = moments[order], axes[:, order]
    axes *= np.where(np.diag(axes) < 0.0, -1.0, 1.0)
    if np.linalg.det(axes) < 0.0:
        axes[:, np.argmin(np.diag(axes))] *= -1.0
    return moments, axes
