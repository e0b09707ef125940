"""The paper's regression of the critical amplitude (Eq. 4.1), and the same form fitted to other values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

EQUATION_4_1 = (6.8983, 1.227, -1.6468, 0.8758)
"""The paper's c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²] (Eq. 4.1)."""

CONFIDENCE = 0.95
"""Level of the confidence intervals."""


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """A fit of S₁ = c₁ exp(c₂ S₂) (b/h) + c₃ S₂ + c₄.

    Attributes
    ----------
    coefficients : ndarray, shape (4,)
        c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²].
    half_widths : ndarray, shape (4,)
        Half widths of their 95 % confidence intervals.
    residuals : ndarray, shape (n,)
        What the values have above the fit, in parts of the value.
    """

    coefficients: NDArray[np.float64]
    half_widths: NDArray[np.float64]
    residuals: NDArray[np.float64]


def regression(
    coefficients: NDArray[np.float64] | tuple[float, ...],
    ratio: NDArray[np.float64],
    frequency: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return S₁ = c₁ exp(c₂ S₂) (b/h) + c₃ S₂ + c₄ [m/s²].

    Parameters
    ----------
    coefficients : array_like, shape (4,)
        c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²].
    ratio : ndarray
        b/h [–].
    frequency : ndarray
        S₂ [Hz].
    """
    c1, c2, c3, c4 = coefficients
    return c1 * np.exp(c2 * frequency) * ratio + c3 * frequency + c4


def fitted(
    ratio: NDArray[np.float64],
    frequency: NDArray[np.float64],
    amplitude: NDArray[np.float64],
    *,
    relative: bool = True,
) -> Fit:
    """Fit the form of Eq. 4.1 by least squares.

    The confidence intervals are those of the linearised problem: t-quantile times the standard error from
    s²(JᵀJ)⁻¹, J the residuals' Jacobian. They hold for independent errors of one size, which residuals of a
    form that does not quite fit are not.

    Parameters
    ----------
    ratio, frequency, amplitude : ndarray, shape (n,)
        b/h [–], S₂ [Hz], S₁ [m/s²]; n > 4, all finite, S₁ above zero.
    relative : bool
        Whether the squares are of relative residuals, so that small amplitudes count as much as large ones,
        or of absolute ones.

    Raises
    ------
    InputError
        Fewer than five values.
    """
    from scipy.optimize import least_squares  # pyright: ignore[reportUnknownVariableType]
    from scipy.stats import t

    if len(amplitude) < 5:
        raise InputError(f"The regression has {len(amplitude)} values; it must have five or more.")
    weight = 1.0 / amplitude if relative else np.ones_like(amplitude)

    def off(c: NDArray[np.float64]) -> NDArray[np.float64]:
        return weight * (regression(c, ratio, frequency) - amplitude)

    solved: Any = least_squares(  # pyright: ignore[reportUnknownVariableType]
        off,
        EQUATION_4_1,
        jac=lambda c: weight[:, None] * _jacobian(c, ratio, frequency),  # type: ignore[arg-type]
        x_scale="jac",
        xtol=1e-12,
    )
    free = len(amplitude) - 4
    coefficients = np.asarray(solved.x, np.float64)
    J = weight[:, None] * _jacobian(coefficients, ratio, frequency)
    variance = np.sum(off(coefficients) ** 2) / free
    errors = np.sqrt(np.diag(np.linalg.inv(J.T @ J)) * variance)
    half_widths = float(t.ppf(0.5 + CONFIDENCE / 2.0, free)) * errors
    return Fit(coefficients, half_widths, 1.0 - regression(coefficients, ratio, frequency) / amplitude)


def _jacobian(
    coefficients: NDArray[np.float64], ratio: NDArray[np.float64], frequency: NDArray[np.float64]
) -> NDArray[np.float64]:
    c1, c2 = coefficients[:2]
    grown = np.exp(c2 * frequency) * ratio
    return np.column_stack((grown, c1 * frequency * grown, frequency, np.ones_like(frequency)))
