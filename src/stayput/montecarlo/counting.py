"""Outcomes of Monte Carlo runs: probabilities of events, quantiles of peaks, and what is ranked by them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import lru_cache
from typing import Self

import numpy as np
from numpy.typing import NDArray

from stayput.fragility.probabilities import Probability, probability_of_counts
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.simulation.space_fate import ROCKS, Stability, expected

OVERTURNED, SLID, HIT_WALL, DEVICE_FAILED = "overturned", "slid", "hit_wall", "device_failed"
EVENTS = (OVERTURNED, SLID, HIT_WALL, DEVICE_FAILED)
"""Events that are counted: it overturns; it slides farther than the limit; it hits a wall; a device fails."""

SLIDE_LIMIT = 0.10
"""Default of the slide that counts as too far [m]."""


@dataclass(frozen=True, slots=True)
class Quantiles:
    """Median and 90 % quantile of a peak over all runs; infinite where so many overturn."""

    median: float
    p90: float

    @classmethod
    def of(cls, peaks: NDArray[np.float64], overturned: NDArray[np.bool_]) -> Quantiles:
        """Return the quantiles of peaks, those of bodies that overturn counted as infinite.

        The 90 % quantile is the least peak that nine in ten of the runs do not exceed.
        """
        values = np.sort(np.where(overturned, np.inf, peaks).ravel())
        if values.size == 0:
            return cls(np.nan, np.nan)
        n = len(values)
        return cls(float(values[round(0.5 * (n - 1))]), float(values[(9 * n + 9) // 10 - 1]))


@dataclass(frozen=True, slots=True, eq=False)
class Outcomes:
    """Outcomes of a piece with one set of measures at one level, over motions and samples.

    Parameters
    ----------
    overturned, missing, hit_wall, device_failed : ndarray of bool, shape (motions, samples)
        Whether it overturned; whether the run was given up; whether it hit a wall; whether a device failed.
    slide, tilt : ndarray, shape (motions, samples)
        Peak slide [m], less what a measure is made to let it slide, and tilt [rad].
    """

    overturned: NDArray[np.bool_]
    missing: NDArray[np.bool_]
    hit_wall: NDArray[np.bool_]
    device_failed: NDArray[np.bool_]
    slide: NDArray[np.float64]
    tilt: NDArray[np.float64]

    @classmethod
    def of(cls, results: NDArray[np.void], device_failed: NDArray[np.bool_]) -> Outcomes:
        """Return the outcomes of results, and of whether a device failed, of shape (motions, samples)."""
        return Outcomes(
            overturned=results["outcome"] == OVERTURNED_OUTCOME,
            missing=results["outcome"] == FAILED_OUTCOME,
            hit_wall=results["wall_impacts"] > 0,
            device_failed=device_failed,
            slide=results["peak_slide"],
            tilt=results["peak_tilt"],
        )

    @classmethod
    def impossible(cls, shape: tuple[int, int]) -> Outcomes:
        """Return the outcomes of runs that could not be set up: all count as given up."""
        no, unknown = np.zeros(shape, np.bool_), np.full(shape, np.nan)
        return Outcomes(no, ~no, no, no, unknown, unknown)

    @classmethod
    def joined(cls, parts: list[Self]) -> Self:
        """Join the samples of several batches."""
        if len(parts) == 1:
            return parts[0]
        columns = {field.name: [getattr(part, field.name) for part in parts] for field in fields(cls)}
        return cls(**{name: np.concatenate(values, axis=1) for name, values in columns.items()})

    def probability_of_overturning(self) -> Probability:
        """Return the probability of overturning."""
        return self._probability(self.overturned)

    def happened(self, slide_limit: float) -> tuple[NDArray[np.bool_], ...]:
        """Return whether each of `EVENTS` happened; ``slide_limit`` is the slide that is too far [m]."""
        return self.overturned, self.slide > slide_limit, self.hit_wall, self.device_failed

    def moved(self, slide_limit: float) -> NDArray[np.bool_]:
        """Return whether it slid farther than a limit [m] or overturned: what falls has moved."""
        return self.overturned | (self.slide > slide_limit)

    def probabilities(self, slide_limit: float) -> dict[str, Probability]:
        """Return the probability of each of `EVENTS`; ``slide_limit`` is the slide that is too far [m]."""
        happened = self.happened(slide_limit)
        return {event: self._probability(flags) for event, flags in zip(EVENTS, happened, strict=True)}

    def stability(self, slide_limit: float) -> Stability:
        """Return how firmly it stands; it moves where it slides too far or rocks."""
        moves = self.moved(slide_limit) | (self.tilt > ROCKS)
        shares = (self._probability(flags).estimate for flags in (self.overturned, moves))
        return expected(*shares)

    def _probability(self, happened: NDArray[np.bool_]) -> Probability:
        known = ~self.missing
        counts = ((happened & known).sum(axis=1), known.sum(axis=1), self.missing.sum(axis=1))
        return _probability(*(tuple(count.tolist()) for count in counts))


@lru_cache(maxsize=16_384)
def _probability(fell: tuple[int, ...], runs: tuple[int, ...], missing: tuple[int, ...]) -> Probability:
    """Return a probability from counts by motion; cached, since counts repeat often in an inventory."""
    return probability_of_counts(fell, runs, missing)


RANKING_ORDER = (OVERTURNED, SLID, DEVICE_FAILED, HIT_WALL)
"""Events by which options are ranked, the most important first."""

RANKING_RESOLUTION = 0.005
"""Probabilities that differ by no more than this are equal in the ranking: half a per cent."""


@dataclass(frozen=True, slots=True)
class Member:
    """A representative run: its place among motions and samples."""

    motion: int
    sample: int


def severity(probabilities: Mapping[str, Probability], cost: int) -> tuple[float, ...]:
    """Return the sort key of an option: its probabilities in `RANKING_ORDER`, then its number of measures."""
    shares = (probabilities[event].estimate for event in RANKING_ORDER)
    return (
        *(
            round(share / RANKING_RESOLUTION) * RANKING_RESOLUTION if np.isfinite(share) else 1.0
            for share in shares
        ),
        float(cost),
    )


def worst_of(runs: Outcomes) -> Member:
    """Return the worst run: by overturning, failing devices, tilt, slide; one given up only where all are.

    Tilts of what does not rock are all alike, so that of what only slides the slide decides.
    """
    tilt = np.where(runs.tilt > ROCKS, runs.tilt, 0.0)
    columns = runs.slide, tilt, runs.device_failed, runs.overturned, ~runs.missing
    order = np.lexsort([column.ravel() for column in columns])
    return Member(*divmod(int(order[-1]), runs.tilt.shape[1]))
