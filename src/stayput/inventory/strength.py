"""How strongly the ground shakes at a place, as a shake map says it: JMA's intensity, or Sa at a period."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.motion.intensity import factor_to_intensity
from stayput.motion.spectrum import DAMPING, response_spectrum
from stayput.motion.units import STANDARD_GRAVITY

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from stayput.motion import Motion

INTENSITY = "intensity"

PERIODS = (0.01, 10.0)
"""Shortest and longest period of an Sa [s]."""

_SA = re.compile(r"sa_(\d{1,2}(?:\.\d{1,4})?)", re.ASCII)


@dataclass(frozen=True, slots=True)
class Strength:
    """A measure of the ground's shaking that a map may hold.

    Between places, and rounded, it is taken as a level: a number that grows by `growth` where a motion
    grows tenfold. JMA's intensity is one; of Sa it is log10 of Sa over g.

    Parameters
    ----------
    period : float, optional
        Period of Sa [s]; none of JMA's intensity.
    """

    period: float | None = None

    @classmethod
    def of(cls, column: str) -> Strength | None:
        """Return the measure of a column, "intensity" or "sa_0.3", or None where it is another column.

        Raises
        ------
        InputError
            A period out of range.
        """
        if column == INTENSITY:
            return JMA
        found = _SA.fullmatch(column)
        if found is None:
            return None
        period = float(found[1])
        if not PERIODS[0] <= period <= PERIODS[1]:
            low, high = PERIODS
            raise InputError(
                f"The column {column!r} has the period {period:g} s; it must be {low:g} to {high:g} s."
            )
        return cls(period)

    @property
    def growth(self) -> float:
        """By how much a level grows where a motion grows tenfold."""
        return 2.0 if self.period is None else 1.0

    @property
    def steps(self) -> int:
        """Steps of a level to which maps are rounded, in 1: 0.1 of intensity, 1/40 of a decade of Sa."""
        return 10 if self.period is None else 40

    @property
    def limits(self) -> tuple[float, float, str]:
        """Smallest and largest value in a map, and their unit."""
        return (-3.0, 9.0, "") if self.period is None else (1e-6, 10.0, "g")

    @property
    def about(self) -> str:
        """What it is, in words."""
        if self.period is None:
            return "JMA intensity, rounded to 0.1"
        return (
            f"Sa at {self.period:g} s, {100.0 * DAMPING:g} % damping, geometric mean of the horizontal "
            "components, rounded by at most 3 %"
        )

    def level(self, value: float) -> float:
        """Return the level of a value of a map."""
        return value if self.period is None else math.log10(value)

    def rounded(self, level: float) -> float:
        """Return a level at the nearest step."""
        return round(level * self.steps) / self.steps

    def to_zero(self, motions: Iterable[Motion]) -> NDArray[np.float64]:
        """Return the factors that bring motions to level 0, shape (motions,).

        Raises
        ------
        InputError
            A motion that is still.
        """
        if self.period is None:
            return np.array([factor_to_intensity(motion, 0.0) for motion in motions])
        return np.array([STANDARD_GRAVITY / horizontal_sa(motion, self.period) for motion in motions])


JMA = Strength()
"""JMA's instrumental intensity."""


def horizontal_sa(motion: Motion, period: float) -> float:
    """Return the geometric mean of Sa of the horizontal components [m/s²]; of a motion without y it is x's.

    Parameters
    ----------
    motion : Motion
        The motion.
    period : float
        The period [s]; the damping is 5 %.

    Raises
    ------
    InputError
        A component that is still.
    """
    names = [name for name in ("x", "y") if name in motion.components]
    found = [float(response_spectrum(motion, period, DAMPING, name).sa[0]) for name in names]
    for name, sa in zip(names, found, strict=True):
        if not sa > 0.0:
            raise InputError(f"The {name} component of {motion.name!r} is still; it cannot have an Sa.")
    return math.prod(found) ** (1.0 / len(found))
