"""Intervals of a fragility curve by drawing the motions anew: slower, and without a formula to trust."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import ndtri

from stayput.errors import InputError, within
from stayput.fragility.curve import State
from stayput.fragility.probabilities import CONFIDENCE
from stayput.fragility.probit import fit, separated
from stayput.randomness import random_bits, uniforms

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.fragility.curve import FragilityCurve

_CELLS_AT_ONCE = 200_000


@dataclass(frozen=True, slots=True, eq=False)
class Bootstrap:
    """Curves fitted to motions drawn anew.

    Parameters
    ----------
    curve : FragilityCurve
        The curve itself.
    ab : ndarray, shape (replicates, 2)
        Parameters of p = Φ(a + b u) of each replicate; NaN where its motions gave no curve.
    """

    curve: FragilityCurve
    ab: NDArray[np.float64]

    @property
    def unfitted(self) -> int:
        """Replicates whose motions gave no curve; the intervals are over the others."""
        return int(np.isnan(self.ab[:, 0]).sum())

    def capacity_interval(self, share: float = 0.5) -> tuple[float, float]:
        """Return the 95 % percentile interval of the intensity [SI] at which a share falls."""
        u = (float(ndtri(share)) - self.ab[:, 0]) / self.ab[:, 1]
        low, high = np.nanquantile(u, (0.5 - 0.5 * CONFIDENCE, 0.5 + 0.5 * CONFIDENCE))
        return float(self.curve.measure.value(low)), float(self.curve.measure.value(high))


def bootstrap(curve: FragilityCurve, replicates: int = 500, seed: int = 1) -> Bootstrap:
    """Fit a curve's trials again with motions drawn with replacement (Efron 1979; by clusters).

    Parameters
    ----------
    curve : FragilityCurve
        A fitted curve of trials that have motions.
    replicates : int
        How many times.
    seed : int
        Seed of the draws, ≥ 0; the same seed gives the same bits.

    Raises
    ------
    InputError
        A curve that is not fitted or has no motions, or less than 20 replicates.
    """
    trials = curve.trials
    if curve.state is not State.FITTED or trials.motion is None:
        raise InputError(
            f"The curve is {curve.state.value!r} or has one motion; to be drawn anew it must be fitted and "
            "have several."
        )
    count = int(within("Replicates", replicates, 20, 100_000))
    motions = int(trials.motion.max()) + 1
    drawn = (uniforms(random_bits(seed).random_raw(count * motions)) * motions).astype(np.intp)
    rows = np.repeat(np.arange(count), motions)
    times = np.bincount(rows * motions + drawn, minlength=count * motions).reshape(count, motions)
    u = curve.measure.coordinate(trials.im)
    middle, spread = float(u.mean()), float(u.std())
    v = (u - middle) / spread
    b = float(curve.ab[1]) * spread
    start = np.array([float(curve.ab[0]) + float(curve.ab[1]) * middle, b])
    found = np.full((count, 2), math.nan)
    batch = max(1, _CELLS_AT_ONCE // len(v))
    for first in range(0, count, batch):
        weights = times[first : first + batch][:, trials.motion].astype(np.float64)
        fell, stood = weights * trials.fell, weights * (trials.runs - trials.fell)
        first_fall, last_fall, first_stand, last_stand = separated(v, fell, stood)
        good = (first_fall < last_stand) & (first_stand < last_fall)
        fitted = fit(v, fell[good], stood[good], start)
        in_u = np.stack((fitted[:, 0] - fitted[:, 1] * middle / spread, fitted[:, 1] / spread), axis=1)
        in_u[fitted[:, 1] <= 0.0] = math.nan
        found[first : first + batch][good] = in_u
    return Bootstrap(curve, found)
