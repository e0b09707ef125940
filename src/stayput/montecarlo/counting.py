"""Outcomes of Monte Carlo runs: probabilities of events, quantiles of peaks, and what is ranked by them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from stayput.fragility.fit import RunsAround
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.fragility.paired import Difference, difference_of_runs
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


OFFSETS = (0.0, 0.4, -0.4)
"""By how much the shaking of a level is stronger than stated, in JMA's intensity: by nothing, more, less.

Curves need runs beside the stated level; so near to it one tells of the share there as much as 0.4 runs."""

_LEVELS_IN_TURN = (0, 2, 0, 0, 1)


class Member(NamedTuple):
    """A run by itself: the number of its motion, and of the draw under it."""

    motion: int
    sample: int


@dataclass(frozen=True, slots=True, eq=False)
class Members:
    """Which motion and which draw each of some runs has, and how strong the shaking is.

    Parameters
    ----------
    motion, sample, level : ndarray of int, shape (runs,)
        The number of each run's motion, of the draw under it, and of the level: of those in `OFFSETS`, or of
        further ones.
    """

    motion: NDArray[np.intp]
    sample: NDArray[np.intp]
    level: NDArray[np.intp]

    @classmethod
    def of_samples(cls, motions: int, samples: int, start: int = 0, level: int = 0) -> Self:
        """Return so many draws of each motion, one motion after the other, at one level."""
        motion, sample = np.indices((motions, samples)).reshape(2, -1)
        return cls(motion, sample + start, np.full(len(motion), level))

    @classmethod
    def in_turn(cls, motions: int, runs: int, *, beside: bool) -> Self:
        """Return runs of all motions in turn, the first draw of each before the second.

        Parameters
        ----------
        motions, runs : int
            How many there are.
        beside : bool
            Whether two in five are at the levels beside the stated one. The order of the levels moves on with
            the draw, so that a motion does not always have the same.
        """
        sample, motion = np.divmod(np.arange(runs), motions)
        # families of motions alternate, too, about every fifth is of one: without the step of two from five
        # motions to the next, no motion near a fault would come at the stated level in the first 40 runs
        turn = motion + 2 * (motion // 5) + sample
        level = np.array(_LEVELS_IN_TURN)[turn % len(_LEVELS_IN_TURN)]
        return cls(motion, sample, level if beside else np.zeros_like(level))

    def __len__(self) -> int:
        return len(self.motion)

    def __iter__(self) -> Iterator[tuple[int, int, int]]:
        """Yield motion, draw and level of each run."""
        return zip(self.motion.tolist(), self.sample.tolist(), self.level.tolist(), strict=True)

    def __getitem__(self, run: int) -> Member:
        """Return motion and draw of a single run."""
        return Member(int(self.motion[run]), int(self.sample[run]))

    def chosen(self, runs: slice | NDArray[np.bool_]) -> Members:
        """Return some of the runs."""
        return Members(*(getattr(self, field.name)[runs] for field in fields(self)))


@dataclass(frozen=True, slots=True, eq=False)
class Outcomes:
    """Outcomes of a piece with one set of measures, run by run.

    Parameters
    ----------
    members : Members
        The runs.
    overturned, missing, hit_wall, device_failed : ndarray of bool, shape (runs,)
        Whether it overturned; whether the run was given up; whether it hit a wall; whether a device failed.
    slide, tilt : ndarray, shape (runs,)
        Peak slide [m], less what a measure is made to let it slide, and tilt [rad].
    """

    members: Members
    overturned: NDArray[np.bool_]
    missing: NDArray[np.bool_]
    hit_wall: NDArray[np.bool_]
    device_failed: NDArray[np.bool_]
    slide: NDArray[np.float64]
    tilt: NDArray[np.float64]

    @classmethod
    def of(cls, members: Members, results: NDArray[np.void], device_failed: NDArray[np.bool_]) -> Outcomes:
        """Return the outcomes of results, and of whether a device failed, both of shape (runs,)."""
        return Outcomes(
            members,
            overturned=results["outcome"] == OVERTURNED_OUTCOME,
            missing=results["outcome"] == FAILED_OUTCOME,
            hit_wall=results["wall_impacts"] > 0,
            device_failed=device_failed,
            slide=results["peak_slide"],
            tilt=results["peak_tilt"],
        )

    @classmethod
    def impossible(cls, members: Members) -> Outcomes:
        """Return the outcomes of runs that could not be set up: all count as given up."""
        no, unknown = np.zeros(len(members), np.bool_), np.full(len(members), np.nan)
        return Outcomes(members, no, ~no, no, no, unknown, unknown)

    @classmethod
    def joined(cls, parts: list[Self]) -> Self:
        """Join several batches."""
        if len(parts) == 1:
            return parts[0]
        columns = [[getattr(part, field.name) for part in parts] for field in fields(cls)]
        members = (
            np.concatenate([getattr(part.members, field.name) for part in parts]) for field in fields(Members)
        )
        return cls(Members(*members), *map(np.concatenate, columns[1:]))

    def chosen(self, runs: slice | NDArray[np.bool_]) -> Self:
        """Return some of the runs."""
        columns = (getattr(self, field.name)[runs] for field in fields(self)[1:])
        return type(self)(self.members.chosen(runs), *columns)

    @property
    def stated(self) -> Self:
        """The runs at the shaking that is stated."""
        return self.chosen(self.members.level == 0) if self.members.level.any() else self

    def probability_of_overturning(self) -> Probability:
        """Return the probability of overturning."""
        return self.probability(self.overturned)

    def happened(self, slide_limit: float) -> tuple[NDArray[np.bool_], ...]:
        """Return whether each of `EVENTS` happened; ``slide_limit`` is the slide that is too far [m]."""
        return self.overturned, self.slide > slide_limit, self.hit_wall, self.device_failed

    def moved(self, slide_limit: float) -> NDArray[np.bool_]:
        """Return whether it slid farther than a limit [m] or overturned: what falls has moved."""
        return self.overturned | (self.slide > slide_limit)

    def probabilities(self, slide_limit: float, *, has_devices: bool = True) -> dict[str, Probability]:
        """Return the probability of each of `EVENTS`.

        Parameters
        ----------
        slide_limit : float
            The slide that is too far [m].
        has_devices : bool
            Whether devices hold it: where none does, none can fail.
        """
        happened = self.happened(slide_limit)
        chances = {event: self.probability(flags) for event, flags in zip(EVENTS, happened, strict=True)}
        if not has_devices:
            chances[DEVICE_FAILED] = replace(chances[DEVICE_FAILED], estimate=0.0, low=0.0, high=0.0)
        return chances

    def stability(self, slide_limit: float) -> Stability:
        """Return how firmly it stands; it moves where it slides too far or rocks."""
        moves = self.moved(slide_limit) | (self.tilt > ROCKS)
        shares = (self.probability(flags).estimate for flags in (self.overturned, moves))
        return expected(*shares)

    def probability(self, happened: NDArray[np.bool_]) -> Probability:
        """Return the probability at the stated shaking of what happened (bool, shape (runs,)) or did not.

        From runs at several levels it is that of a fit to all of them.
        """
        known, motion = ~self.missing, self.members.motion
        if self.members.level.any():
            return self._around(happened).probability()
        counts = (np.bincount(motion, flags) for flags in (happened & known, known, self.missing))
        return _probability(*(tuple(count.astype(np.intp).tolist()) for count in counts))

    def difference(
        self, happened: NDArray[np.bool_], other: Outcomes, then: NDArray[np.bool_], comparisons: int = 1
    ) -> Difference:
        """Return how much likelier something is than in other outcomes.

        Parameters
        ----------
        happened, then : ndarray of bool, shape (runs,)
            Whether it happened in these runs, and in the others.
        other : Outcomes
            The others; of one the runs are the first ones of the other, which may have more.
        comparisons : int
            As of `stayput.fragility.paired.difference`.
        """
        if self.members.level.any() or other.members.level.any():
            return self._around(happened).difference(other._around(then), comparisons)
        both = slice(min(len(happened), len(then)))
        missing, motion = self.missing[both] | other.missing[both], self.members.motion[both]
        return difference_of_runs(happened[both], then[both], missing, motion, comparisons=comparisons)

    def _around(self, happened: NDArray[np.bool_]) -> RunsAround:
        offset = np.array(OFFSETS)[self.members.level]
        return RunsAround(JMA_INTENSITY, offset, happened, self.missing, self.members.motion)


@lru_cache(maxsize=16_384)
def _probability(fell: tuple[int, ...], runs: tuple[int, ...], missing: tuple[int, ...]) -> Probability:
    """Return a probability from counts by motion; cached, since counts repeat often in an inventory."""
    return probability_of_counts(fell, runs, missing)


RANKING_ORDER = (OVERTURNED, SLID, DEVICE_FAILED, HIT_WALL)
"""Events by which options are ranked, the most important first."""

RANKING_RESOLUTION = 0.005
"""Probabilities that differ by no more than this are equal in the ranking: half a per cent."""


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
    order = np.lexsort(columns)
    return runs.members[int(order[-1])]
