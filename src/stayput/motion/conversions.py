"""From peaks of a record to other scales of intensity, by published regressions.

Each is a mean over many records with a scatter of about half a degree; none replaces the intensity that is
computed from the record itself.
"""

from __future__ import annotations

import math

from stayput.errors import InputError, finite


def _logarithm(name: str, value: float, unit: str) -> float:
    number = finite(name, value)
    if not number > 0.0:
        raise InputError(f"{name} is {number:g} {unit}; it must be larger than 0.")
    return math.log10(100.0 * number)


def jma_from_pgv(pgv: float) -> float:
    """Return JMA's intensity 2.68 + 1.72 log₁₀ PGV[cm/s] of a peak velocity [m/s] (Midorikawa et al. 1999).

    Made for intensities from 4 to 7.
    """
    return 2.68 + 1.72 * _logarithm("PGV", pgv, "m/s")


def kawasumi(pga: float) -> float:
    """Return the intensity 2 log₁₀ PGA[gal] + 0.7 of a peak acceleration [m/s²] (Kawasumi 1951)."""
    return 2.0 * _logarithm("PGA", pga, "m/s²") + 0.7


def mercalli(pga: float, pgv: float) -> float:
    """Return the modified Mercalli intensity, 1 to 10, of PGA [m/s²] and PGV [m/s] (Worden et al. 2012).

    The mean of the two bilinear regressions of that paper, which were made for California; the larger
    horizontal component counts.

    Raises
    ------
    InputError
        A peak that is not larger than 0.
    """
    a, v = _logarithm("PGA", pga, "m/s²"), _logarithm("PGV", pgv, "m/s")
    from_a = 1.78 + 1.55 * a if a <= 1.57 else -1.60 + 3.70 * a
    from_v = 3.78 + 1.47 * v if v <= 0.53 else 2.89 + 3.16 * v
    return min(10.0, max(1.0, 0.5 * (from_a + from_v)))
