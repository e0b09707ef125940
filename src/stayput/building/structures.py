"""What is assumed of a building when its structure is known: defaults of low confidence."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Structure:
    """Common values of a kind of structure (defaults, low confidence).

    Parameters
    ----------
    period_per_height : float
        First natural period over height [s/m].
    damping : float
        Damping ratio of every mode.
    yield_coefficient : float
        Shear of the lowest storey at yielding over the weight above, for a fast building.
    post_yield : float
        Ratio of a storey's stiffness after yielding to that before it.
    """

    period_per_height: float
    damping: float
    yield_coefficient: float
    post_yield: float


ISOLATED = "base-isolated"
"""Name of the structure that stands on isolators."""

STRUCTURES: dict[str, Structure] = {
    "RC": Structure(0.02, 0.03, 0.45, 0.05),
    "steel": Structure(0.03, 0.02, 0.35, 0.05),
    "wood": Structure(0.03, 0.05, 0.40, 0.05),
    ISOLATED: Structure(0.02, 0.03, 0.45, 0.05),
}
"""Values by structure; those of a base-isolated building are of the RC building above the isolators."""

STOREY_HEIGHT = 3.0
"""Height of a storey (default, low confidence) [m]."""

FLOOR_MASS = 5e5
"""Mass of every floor [kg]; it plays no part in any motion, and scales forces and energies."""
