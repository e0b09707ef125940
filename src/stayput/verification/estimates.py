"""Quick estimates by formulas, for the piece as it stands, to stand beside the simulation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.estimates import ishiyama_velocity, kaneko_hayashi, rocking_acceleration
from stayput.fragility import PFA, PFV

if TYPE_CHECKING:
    from stayput.body import Body
    from stayput.verification.hazard import Floors


@dataclass(frozen=True, slots=True)
class Estimates:
    """What formulas say of the piece without a measure, on a floor on which it does not slide.

    Parameters
    ----------
    rocking_acceleration : float
        Floor acceleration at which rocking starts (West) [m/s²].
    overturning_velocity : float
        Floor velocity that overturning needs as well (Ishiyama 1982) [m/s].
    possible : float
        Share of the motions that reach both.
    overturning_ratio : float
        Share that overturns by Kaneko and Hayashi, on average over the motions.
    """

    rocking_acceleration: float
    overturning_velocity: float
    possible: float
    overturning_ratio: float

    @classmethod
    def of(cls, body: Body, floors: Floors, gravity: float) -> Estimates:
        """Return the estimates of a body under the motions of a level."""
        b, h = body.width, body.height
        a, v = floors.measures[PFA], floors.measures[PFV]
        a0, v0 = rocking_acceleration(b, h, gravity), ishiyama_velocity(b, h, gravity)
        ratios = [kaneko_hayashi(b, h, float(x), float(y), gravity).ratio for x, y in zip(a, v, strict=True)]
        return cls(a0, v0, float(np.mean((a >= a0) & (v >= v0))), float(np.mean(ratios)))
