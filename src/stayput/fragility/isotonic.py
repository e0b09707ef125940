"""Isotonic regression of the share that falls over the intensity, which is only assumed not to decrease.

The estimate is the isotonic regression of the levels' shares (Barlow, Bartholomew, Bremner and Brunk 1972),
by the algorithm of pool-adjacent-violators, drawn straight from level to level. The band is that of the
levels' own intervals, which know that runs of one motion are alike: levels that are put together have the
widest of theirs, and what a level leaves out is left out at weaker ones from above and at stronger ones from
below. From level to level it is drawn straight in Φ⁻¹(p), in which a normal curve is straight: below
a level where the lower end is 0 nothing is known but that it is not less, and so on above. Where the share
rises by more than a half from one level to the next, what lies between was not seen, and the band there is as
wide as at both.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import ndtr, ndtri

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.trials import Level

_JUMP = 0.5
"""Rise of the share from one level to the next above which nothing is said of what lies between."""


@dataclass(frozen=True, slots=True, eq=False)
class Isotonic:
    """The isotonic (non-decreasing) share at the levels, and its 95 % band.

    Parameters
    ----------
    u : ndarray, shape (levels,)
        Coordinates of the levels in which they are drawn, increasing: the intensity, or a peak's logarithm.
    share, low, high : ndarray, shape (levels,)
        Share that falls and the ends of its interval; none of them falls.
    """

    u: NDArray[np.float64]
    share: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    @classmethod
    def of(cls, measure: IntensityMeasure, levels: tuple[Level, ...]) -> Isotonic:
        """Return the regression of the observed shares."""
        observed = [(p.fell, p.runs, p.low, p.high) for p in (level.probability for level in levels)]
        fell, runs, low, high = np.array(observed, np.float64).T
        share = pooled(fell, runs)
        for value in np.unique(share):
            together = share == value
            low[together], high[together] = low[together].min(), high[together].max()
        return cls(
            measure.coordinate([level.im for level in levels]),
            share,
            np.maximum.accumulate(low),
            np.minimum.accumulate(high[::-1])[::-1],
        )

    def jumps(self, place: int) -> bool:
        """Whether the share jumps on the way to a level from the one below."""
        return bool(self.share[place] - self.share[place - 1] > _JUMP)

    def at(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the share at coordinates; NaN outside the levels."""
        return np.interp(u, self.u, self.share, math.nan, math.nan)

    def band(self, u: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the ends of the band at coordinates; NaN outside the levels."""
        low, high = np.full(u.shape, math.nan), np.full(u.shape, math.nan)
        for place in range(1, len(self.u)):
            inside = (u >= self.u[place - 1]) & (u <= self.u[place])
            part = (u[inside] - self.u[place - 1]) / (self.u[place] - self.u[place - 1])
            ends = slice(place - 1, place + 1)
            low[inside] = _between(part, self.low[ends], -math.inf, self.jumps(place))
            high[inside] = _between(part, self.high[ends], math.inf, self.jumps(place))
        return low, high

    def crossing(self, share: float) -> float:
        """Return the coordinate at which a share is reached; ±∞ beyond the levels, NaN within a jump."""
        place = int(np.searchsorted(self.share, share))
        if place == 0:
            return float(self.u[0]) if self.share[0] == share else -math.inf
        if place == len(self.u):
            return math.inf
        if self.share[place] == share:
            return float(self.u[place])
        if self.jumps(place):
            return math.nan
        part = (share - self.share[place - 1]) / (self.share[place] - self.share[place - 1])
        return float(self.u[place - 1] + part * (self.u[place] - self.u[place - 1]))

    def interval(self, share: float) -> tuple[float, float]:
        """Return the coordinates between which the band holds a share; ±∞ beyond the levels."""
        first = int(np.searchsorted(self.high, share))
        last = int(np.searchsorted(self.low, share))
        return (
            -math.inf if first == 0 else self._edge(self.high, first, share, 0.0),
            math.inf if last == len(self.u) else self._edge(self.low, last, share, 1.0),
        )

    def _edge(self, end: NDArray[np.float64], place: int, share: float, unseen: float) -> float:
        """Return where an end of the band reaches a share, on the way to a level from the one below.

        ``unseen`` is the part of that way at which it does where it is not drawn straight.
        """
        if place == 0 or place == len(self.u):
            return float(self.u[min(place, len(self.u) - 1)])
        z, ends = float(ndtri(share)), ndtri(end[place - 1 : place + 1])
        known = not self.jumps(place) and bool(np.isfinite(ends).all())
        part = (z - float(ends[0])) / float(ends[1] - ends[0]) if known else unseen
        return float(self.u[place - 1] + part * (self.u[place] - self.u[place - 1]))


def pooled(fell: NDArray[np.float64], runs: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rising shares nearest to counted ones: neighbours that do not rise are put together.

    Examples
    --------
    >>> pooled(np.array([0.0, 4.0, 2.0, 10.0]), np.full(4, 10.0)).tolist()
    [0.0, 0.3, 0.3, 1.0]
    """
    blocks: list[tuple[float, float, int]] = []
    for block in zip(fell.tolist(), runs.tolist(), [1] * len(fell), strict=True):
        k, n, count = block
        while blocks and blocks[-1][0] * n >= k * blocks[-1][1]:
            before = blocks.pop()
            k, n, count = k + before[0], n + before[1], count + before[2]
        blocks.append((k, n, count))
    return np.repeat([k / n for k, n, _ in blocks], [count for _, _, count in blocks])


def _between(
    part: NDArray[np.float64], ends: NDArray[np.float64], unknown: float, jumps: bool
) -> NDArray[np.float64]:
    """Return an end of the band on the way from one level to the next."""
    z = ndtri(ends)
    if jumps or not np.isfinite(z).all():
        least, most = (z[0], z[1]) if unknown < 0.0 else (z[1], z[0])
        at_the_other = 1.0 if unknown < 0.0 else 0.0
        return ndtr(np.where(part == at_the_other, most, least))
    return ndtr(z[0] + part * (z[1] - z[0]))
