"""`intensity_from_fallen`: how strong the shaking of a place was, from what fell there and what stood.

All pieces of a place are shaken by one motion, and nobody knows which: the likelihood is the mean over the
motions of the product over the kinds of pieces, so that the scatter from record to record makes the counts
as overdispersed as it does. Under one motion a kind's count is beta-binomial, for its share is known from
some runs only; what all motions of the level say of it counts as one run more. The interval is of the
likelihood ratio: where ln L is less than 1.92 below its peak; of a bound, 3.00.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import betaln, gammaln

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, not_allowed, numbers, whole_within, within
from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Room
from stayput.montecarlo.runs import run_levels
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.motion.floors import of_the_ground
from stayput.motion.suites.families import SEED_RANGE
from stayput.motion.suites.suite import Suite
from stayput.motion.suites.synthesis import synthetic_suite

LEVELS: NDArray[np.float64] = np.linspace(4.5, 7.5, 31)
"""JMA intensities that are tried by default: every tenth from 4.5 to 7.5."""
LEVELS.setflags(write=False)

MOST_PIECES = 1_000_000
"""Most pieces of a kind."""


DROP = 1.92
"""ln L of the peak less that at the ends of a 95 % interval: half the 95 % quantile of χ² with 1 degree."""

BOUND_DROP = -math.log(0.05)
"""The same at a bound: beyond it what was seen is less than a twentieth as likely as at the peak."""


@dataclass(frozen=True, slots=True, eq=False)
class IntensityEstimate:
    """An intensity and its interval from what fell and what stood.

    Parameters
    ----------
    intensity : float
        Mean of the levels, weighted by their likelihood; NaN where an end of the interval is open: there
        `most_likely` tells where the peak is.
    low, high : float
        Ends of the 95 % interval; −∞ or ∞ where even the weakest or the strongest level fits.
    levels : ndarray, shape (levels,)
        JMA intensities that were run.
    log_likelihood : ndarray, shape (levels,)
        ln L there, 0 at its peak.
    shares : ndarray, shape (kinds, levels)
        Share of each kind that falls at each level, over all motions.
    """

    intensity: float
    low: float
    high: float
    levels: NDArray[np.float64]
    log_likelihood: NDArray[np.float64]
    shares: NDArray[np.float64]

    @property
    def most_likely(self) -> float:
        """The level at which what was seen is most likely; the first or the last where it is beyond them."""
        return float(self.levels[np.argmax(self.log_likelihood)])


@dataclass(frozen=True, slots=True)
class Fallen:
    """Pieces of one kind in one place: how many fell of how many.

    Parameters
    ----------
    body : Body
        Such a piece, along the direction in which it is weakest.
    fell, total : int
        How many fell, and how many there were.
    room : Room
        What they stand on and beside; default a floor without walls.
    name : str
        What they are called.

    Raises
    ------
    InputError
        Not a whole number, no pieces, or more that fell than there were.

    Examples
    --------
    >>> import stayput as sp
    >>> stones = sp.Fallen(sp.Body(0.24, 0.62, 95.0), fell=12, total=30, name="gravestones")
    >>> lanterns = sp.Fallen(sp.Body(0.30, 1.50, 180.0), fell=8, total=9, name="lanterns")
    >>> for kind in (stones, lanterns):  # the share that fell, and the acceleration that tips one [m/s²]
    ...     tips, _ = kind.body.overturning_acceleration()
    ...     print(f"{kind.name}: {kind.fell / kind.total:.0%}, {tips:.1f}")
    gravestones: 40%, 3.8
    lanterns: 89%, 2.0
    """

    body: Body
    fell: int
    total: int
    room: Room = field(default_factory=Room)
    name: str = ""

    def __post_init__(self) -> None:
        instance_of("body", self.body, Body)
        instance_of("room", self.room, Room)
        total = _count("total", self.total, 1, MOST_PIECES)
        object.__setattr__(self, "total", total)
        object.__setattr__(self, "fell", _count("fell", self.fell, 0, total))


def _count(name: str, value: int, low: int, high: int) -> int:
    return whole_within(f"fragility.{name}", value, low, high, "", name)


def intensity_from_fallen(
    pieces: Sequence[Fallen],
    *,
    motions: Suite | None = None,
    scatter: float = 0.2,
    samples: int = 16,
    levels: ArrayLike = LEVELS,
    vertical: bool = True,
    seed: int = 1,
    threads: int | None = None,
) -> IntensityEstimate:
    """Return the JMA intensity of a place, with a 95 % interval, from what fell there and what stood.

    Each kind is run under every motion, scaled to each level, with the usual draws of friction, landings,
    mass and height of the centre of gravity: every piece of the place has its own draw, but all share one
    motion that is not known. So the likelihood of an intensity is the mean over the motions of the product
    of the kinds' (beta-)binomial likelihoods: the scatter from record to record widens the interval as it
    should, and more pieces narrow it only down to what one motion leaves open.

    What is estimated is what the pieces say in the model: where real ones fall more easily than rigid blocks
    on clean bases in one plane, it is too high.

    Parameters
    ----------
    pieces : sequence of Fallen
        The kinds of pieces, all on the ground of one place; those of which none fell count as well.
    motions : Suite, optional
        What may have shaken them, of any strength; default 40 synthetic crustal earthquakes.
    scatter : float
        Standard deviation of the intensity from piece to piece (default of low confidence).
    samples : int
        Draws of each kind under each motion.
    levels : sequence of float
        Intensities that are tried, increasing; at least 3.
    vertical : bool
        Whether the vertical motion acts on the pieces; the intensity counts it in any case.
    seed : int
        Seed of draws and of the default motions.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.

    Returns
    -------
    IntensityEstimate
        The intensity and its interval. It is open to below where none fell, or so few that the weakest level
        fits, and to above where all did, or so many that the strongest fits.

    Raises
    ------
    InputError
        No pieces, or a value out of range.

    Examples
    --------
    >>> from stayput import Body, Floor, Room, synthetic_suite
    >>> stone, base = Body(0.24, 0.62, 95.0), Room(Floor(0.6, 0.5))
    >>> motions = synthetic_suite("crustal", 20)
    >>> found = intensity_from_fallen([Fallen(stone, 12, 30, base)], motions=motions, samples=4)
    >>> 5.7 < found.low < found.intensity < found.high < 7.2
    True
    """
    kinds = list_of("pieces", pieces, Fallen)
    if not kinds:
        raise InputError("common.empty", "pieces")
    rows = numbers("fragility.level", levels, "levels")
    if rows.ndim != 1 or len(rows) < 3 or not (np.diff(rows) > 0.0).all():
        name = phrase("common.shape_of", name="levels")
        raise not_allowed(name, str(rows.shape), "fragility.rising_levels", "levels")
    for end in (rows[0], rows[-1]):
        within("fragility.level", float(end), 0.0, 9.0, "", "levels")
    spread = within("fragility.scatter", scatter, 0.0, 1.0, "", "scatter")
    count = _count("samples", samples, 1, 10_000)
    number = whole_within("common.seed", seed, *SEED_RANGE, field="seed")
    suite = (
        synthetic_suite("crustal", 40, number) if motions is None else instance_of("motions", motions, Suite)
    )
    for motion in suite:
        of_the_ground(motion, "here")
    drawn = draws(len(suite), count, number)
    cases = [rows_of(kind.body, kind.room, (), drawn, STANDARD_GRAVITY) for kind in kinds]
    scaled_motions = ScaledMotions(suite, vertical=vertical)
    falls = run_levels(cases, rows, cache(scaled_motions.at), threads=threads)
    fell = np.array([(kind.overturned & ~kind.missing).sum(axis=2) for kind in falls], np.float64)
    runs = np.array([(~kind.missing).sum(axis=2) for kind in falls], np.float64)
    return estimate_from_counts(
        rows, fell, runs, [kind.fell for kind in kinds], [kind.total for kind in kinds], spread
    )


def estimate_from_counts(
    levels: NDArray[np.float64],
    runs_fell: NDArray[np.float64],
    runs: NDArray[np.float64],
    fell: Sequence[int],
    totals: Sequence[int],
    scatter: float,
) -> IntensityEstimate:
    """Return the intensity from counts of fallen pieces.

    Parameters
    ----------
    levels : ndarray, shape (levels,)
        Intensities, increasing.
    runs_fell, runs : ndarray, shape (kinds, levels, motions)
        Runs in which a piece of a kind fell, and all runs.
    fell, totals : sequence of int, length kinds
        Pieces that fell, and all pieces.
    scatter : float
        Standard deviation of the intensity from piece to piece.
    """
    near = _kernel(levels, scatter)
    fell_near, runs_near = near @ runs_fell, near @ runs
    before = (fell_near.sum(axis=2, keepdims=True) + 0.5) / (runs_near.sum(axis=2, keepdims=True) + 1.0)
    a, b = fell_near + before, runs_near - fell_near + (1.0 - before)
    k, n = (np.asarray(counts, np.float64)[:, np.newaxis, np.newaxis] for counts in (fell, totals))
    choices = gammaln(n + 1.0) - gammaln(k + 1.0) - gammaln(n - k + 1.0)
    by_kind = choices + betaln(k + a, n - k + b) - betaln(a, b)
    summed = np.logaddexp.reduce(by_kind.sum(axis=0), axis=1)
    log_l = summed - summed.max()
    low, high = _ends(levels, log_l)
    closed = math.isfinite(low) and math.isfinite(high)
    weights = np.exp(log_l) * np.gradient(levels)
    intensity = float(np.average(levels, weights=weights)) if closed else math.nan
    shares = fell_near.sum(axis=2) / runs_near.sum(axis=2)
    return IntensityEstimate(intensity, low, high, levels, log_l, shares)


def _kernel(levels: NDArray[np.float64], scatter: float) -> NDArray[np.float64]:
    """Return the weights of each level's neighbours for a normal scatter, shape (levels, levels)."""
    if scatter == 0.0:
        return np.eye(len(levels))
    apart = (levels[:, np.newaxis] - levels) / scatter
    weights = np.exp(-0.5 * apart**2) * np.gradient(levels)
    return weights / weights.sum(axis=1, keepdims=True)


def _ends(levels: NDArray[np.float64], log_l: NDArray[np.float64]) -> tuple[float, float]:
    """Return where ln L first and last comes within `DROP` of its peak; ±∞ beyond the levels.

    The only end of an interval that is open to the other side is where it comes within `BOUND_DROP`.
    """

    def reach(drop: float) -> tuple[float, float]:
        inside = np.flatnonzero(log_l >= -drop)
        first, last = int(inside[0]), int(inside[-1])

        def crossing(out: int, within: int) -> float:
            part = (-drop - log_l[out]) / (log_l[within] - log_l[out])
            return float(levels[out] + part * (levels[within] - levels[out]))

        low = -math.inf if first == 0 else crossing(first - 1, first)
        return low, math.inf if last == len(levels) - 1 else crossing(last + 1, last)

    ends = reach(DROP)
    return ends if all(map(math.isfinite, ends)) else reach(BOUND_DROP)
