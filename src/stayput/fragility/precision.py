"""How many more runs an asked precision needs."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.errors import InputError, within
from stayput.fragility.probabilities import student

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability


@dataclass(frozen=True, slots=True)
class Plan:
    """What an asked half width of an interval needs.

    Parameters
    ----------
    samples : int
        Samples a motion, in all, that reach it with these motions; 0 where none do.
    motions : int
        Motions, in all, that reach it with the samples a motion that there are.
    """

    samples: int
    motions: int

    @property
    def reachable(self) -> bool:
        """Whether more samples of the same motions can reach it."""
        return self.samples > 0


def samples_needed(found: Probability, half_width: float) -> Plan:
    """Return how many samples a motion an interval of an asked half width needs.

    With correlation ρ = (deff − 1) / (m − 1) between the runs of a motion, m samples of M motions tell as
    much as M m / (1 + (m − 1) ρ) independent runs (Kish 1965): never more than M / ρ, however many samples.

    Parameters
    ----------
    found : Probability
        What has been found so far. With one sample a motion ρ is unknown and taken as 0.
    half_width : float
        Asked half width of the 95 % interval.

    Raises
    ------
    InputError
        A half width that is not between 0.001 and 0.5, or a probability without runs.
    """
    asked = within("Half width", half_width, 1e-3, 0.5)
    if found.runs == 0:
        raise InputError("The probability has 0 runs; a plan needs at least one.")
    motions = found.motions
    m = found.runs / motions
    if motions == 1:
        needed = math.ceil(independent_runs(found.estimate, asked, student(found.runs)))
        return Plan(needed, 1)
    rho = min((found.design_effect - 1.0) / (m - 1.0), 1.0) if m > 1.0 else 0.0
    runs = independent_runs(found.estimate, asked, student(motions))
    more_motions = math.ceil(runs * (1.0 + (m - 1.0) * rho) / m)
    left = motions - runs * rho
    if left <= 0.0:
        return Plan(0, more_motions)
    return Plan(max(math.ceil(runs * (1.0 - rho) / left), 1), more_motions)


def independent_runs(p: float, half_width: float, quantile: float) -> float:
    """Return the number n of independent runs whose Wilson interval has an asked half width.

    With y = 1/n and q the square of the quantile, h²(1 + q y)² = q p(1 − p) y + q² y²/4.
    """
    q, h = quantile**2, half_width**2
    a, b = q * q * (h - 0.25), q * (2.0 * h - p * (1.0 - p))
    if a == 0.0:
        return 1.0
    root = math.sqrt(max(b * b - 4.0 * a * h, 0.0))
    y = (-b - root) / (2.0 * a)
    return max(1.0 / y, 1.0)
