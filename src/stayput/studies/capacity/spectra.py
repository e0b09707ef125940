"""The motions of the study of capacities: five spectra of one shape, and families as they are drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.motion.suites import Suite, TargetSpectrum, synthetic_suite

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion

CORNERS = (0.2, 0.4, 0.8, 1.6, 3.2)
"""Corner periods of the spectra, from constant acceleration to constant velocity [s]."""

FAMILY = "crustal"
"""Family of the motions that are made to meet the spectra."""

DRAWN = ("near-fault", "crustal")
"""Families of the motions that are taken as they are drawn."""

_TABLE = np.geomspace(0.02, 10.0, 200)
"""Periods of a target's table [s]."""


def target(corner: float) -> TargetSpectrum:
    """Return a spectrum of the shape of Japan's design spectrum at bedrock, with another corner period.

    3.2 + 30T (T < 0.16 s), 8.0 (to the corner T_c), 8.0 T_c/T m/s². Its strength does not matter here.

    Parameters
    ----------
    corner : float
        T_c [s].
    """
    flat = np.where(corner > _TABLE, 8.0, 8.0 * corner / _TABLE)
    sa = np.where(_TABLE < 0.16, 3.2 + 30.0 * _TABLE, flat)
    return TargetSpectrum(_TABLE, sa, f"corner at {corner:g} s")


@dataclass(frozen=True, slots=True, eq=False)
class Shakings:
    """Motions of one kind.

    Parameters
    ----------
    name : str
        What they are called.
    corner : float
        Corner period of the spectrum that each meets [s]; NaN where they meet none.
    motions : tuple of Motion
        The motions.
    """

    name: str
    corner: float
    motions: tuple[Motion, ...]

    @property
    def peaks(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Peak accelerations [m/s²] and velocities [m/s] of the motions, shape [motion]."""
        return (
            np.array([motion.pga for motion in self.motions]),
            np.array([motion.pgv for motion in self.motions]),
        )

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """Equivalent frequencies Fe = A/(2πV) of the motions [Hz], shape [motion]."""
        pga, pgv = self.peaks
        return pga / (2.0 * math.pi * pgv)


def of_spectra(corners: Sequence[float], count: int, seed: int) -> list[Shakings]:
    """Return motions along x alone, each of which meets the spectrum of its corner period.

    Raises
    ------
    InputError
        No corner period, or one out of range.
    """
    if not corners or not all(0.16 <= corner <= 5.0 for corner in corners):
        raise InputError(f"The corner periods are {list(corners)}; they must lie between 0.16 and 5 s.")
    drawn = synthetic_suite(FAMILY, count, seed)
    along = Suite(tuple(motion.component("x") for motion in drawn), drawn.name)
    return [
        Shakings(f"corner at {corner:g} s", corner, along.matched(target(corner)).motions)
        for corner in corners
    ]


def as_drawn(family: str, count: int, seed: int, *, vertical: bool) -> Shakings:
    """Return motions of a family as they are drawn, along x alone or with their vertical component."""
    motions = synthetic_suite(family, count, seed).motions
    if not vertical:
        motions = tuple(motion.component("x") for motion in motions)
    return Shakings(f"{family}, as drawn", math.nan, motions)
