"""A baseline that returns to rest: velocity and displacement end at zero, exactly."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

QUANTUM = 1e-6
"""Samples are whole multiples of this [m/s²], so that no library's last bit shows."""


def fft_length(n: int) -> int:
    """Return the power of two that holds n samples."""
    return 1 << (n - 1).bit_length()


def settled(a: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return an acceleration whose velocity and displacement end at zero, in whole quanta.

    Two smooth bumps as long as the record take off what is left of both; after rounding, a few quanta
    near the middle take off the rest. With a₀ = aₙ = 0 the final velocity of the piecewise linear record
    is dt Σ aᵢ and its final displacement dt² Σ (n − i) aᵢ, so both are sums of whole numbers.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²], zero at both ends.
    """
    tau = np.linspace(0.0, 1.0, len(a))
    window = np.sin(math.pi * tau) ** 2
    window[-1] = 0.0
    slant = window * (tau - 0.5)  # the bumps' sums are those of an even and of an odd function
    s0, s1 = float(np.sum(a)), float(np.sum(a * (tau - 0.5)))
    a = a - s0 / float(np.sum(window)) * window - s1 / float(np.sum(slant * (tau - 0.5))) * slant
    whole = np.rint(a / QUANTUM).astype(np.int64)
    _spread(whole, -int(whole.sum()))
    place = np.arange(len(a), dtype=np.int64) - len(a) // 2
    _tilt(whole, -int(np.sum(whole * place)))
    return whole.astype(np.float64) * QUANTUM


def _spread(whole: NDArray[np.int64], excess: int) -> None:
    """Add ``excess`` quanta, each to a sample of its own about the middle."""
    first = (len(whole) - abs(excess)) // 2
    whole[first : first + abs(excess)] += 1 if excess > 0 else -1


def _tilt(whole: NDArray[np.int64], moment: int) -> None:
    """Add pairs of opposite quanta whose distances sum to ``moment`` samples."""
    sign = 1 if moment > 0 else -1
    far = len(whole) // 2
    pairs, rest = divmod(abs(moment), far)
    first = (far - pairs) // 2
    whole[first : first + pairs] -= sign
    whole[first + far : first + far + pairs] += sign
    if rest:
        middle = (len(whole) - rest) // 2
        whole[middle] -= sign
        whole[middle + rest] += sign
