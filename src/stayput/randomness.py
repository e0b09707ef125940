"""Random bits that depend on a key alone, not on the version of a library.

NumPy promises the raw bits of PCG64 and of a seed sequence for good, but not those of its distributions:
what is drawn here is made from the bits themselves.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def random_bits(*key: int) -> np.random.PCG64:
    """Return a stream of random bits; ``random_raw`` gives 64 a number.

    Parameters
    ----------
    *key : int
        Whole numbers ≥ 0 that name the stream; another key gives an independent stream.
    """
    return np.random.PCG64(np.random.SeedSequence(key))


def uniforms(raw: NDArray[np.uint64]) -> NDArray[np.float64]:
    """Return numbers inside (0, 1), all equally likely, from the first 53 of each number's 64 bits."""
    return ((raw >> np.uint64(11)).astype(np.float64) + 0.5) * 2.0**-53
