"""Units of work: one thing with one set of measures on one floor, under all motions and all draws."""

from __future__ import annotations

import time
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.cases import State, case_rows, leaves, leaves_of_body, leaves_of_room
from stayput.ensemble.columns import run_rows
from stayput.errors import InputError
from stayput.fragility import samples_needed
from stayput.fragility.probabilities import probability_of_counts
from stayput.inventory.records import RECORD
from stayput.inventory.specs import measures_of, thing_of
from stayput.measures import element_rows, hold
from stayput.measures.results import failures_of
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.mechanics.restrained.runner import no_elements
from stayput.verification.compare import FIRST_SAMPLES
from stayput.verification.draws import QUANTITIES, Draw, drawn_body
from stayput.verification.verdict import Quantiles

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.body import Body
    from stayput.cases import Numbers
    from stayput.fragility import Probability
    from stayput.inventory.floors import Floor
    from stayput.measures import Measure
    from stayput.room import Room

Columns: TypeAlias = "dict[str, NDArray[np.float64]]"
Unit: TypeAlias = "tuple[int, str]"
"""Number of a unit, and what stands."""

BLOCK = 32_768
"""Most runs that are in hand at a time: some 10 MB."""


@dataclass(frozen=True, slots=True)
class Sampling:
    """What is tried of what is not known, as in a verification.

    Parameters
    ----------
    motions, samples : int
        Motions, and most draws for each.
    seed : int
        Seed of the draws.
    precision : float, optional
        Half-width of the interval of the probability of overturning that is enough.
    slide_limit : float
        Slide that counts as too far [m].
    gravity : float
        Acceleration of gravity [m/s²].
    """

    motions: int
    samples: int
    seed: int
    precision: float | None
    slide_limit: float
    gravity: float


@lru_cache(maxsize=64)
def _drawn(motions: int, samples: int, seed: int, start: int) -> tuple[Columns, tuple[Draw, ...]]:
    """Return the draws of `stayput.verification.draws.draws`, by the column and one by one."""
    from stayput.uncertainty import USUAL

    found = QUANTITIES.sample(samples, seed, motions=motions, start=start)
    columns = dict(zip(Draw.__slots__, (found[name].ravel() for name in USUAL), strict=True))
    rows = zip(*(column.tolist() for column in columns.values()), strict=True)
    return columns, tuple(Draw(*row) for row in rows)


def unit_rows(
    body: Body,
    room: Room,
    measures: tuple[Measure, ...],
    drawn: tuple[Columns, tuple[Draw, ...]],
    gravity: float,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Return the rows of CASE and ELEMENT of a unit under all draws: those of `stayput.verification.draws`.

    Where measures leave mass and centre of gravity alone and bear no force, all rows are made at once.
    """
    columns, draws = drawn
    held = hold(body, room, measures)
    numbers: dict[str, Numbers] = {**leaves(held.body, held.room, State(), gravity)}
    if not held.elements and _same_mass(body, held.body):
        z = body.cg_offset[1]
        height = np.minimum(0.95, columns["gravity_height"] * (0.5 + z / body.height)) * body.height
        numbers |= {
            "body.mass": columns["mass"] * body.mass,
            "body.cg_offset.z": height - 0.5 * body.height,
        }
        if body.inertia is not None:
            numbers["body.inertia"] = columns["mass"] * body.inertia
        elements = no_elements(0, len(draws))
    else:
        each = [hold(drawn_body(body, draw), room, measures) for draw in draws]
        found = [{**leaves_of_body(one.body), **leaves_of_room(one.room)} for one in each]
        numbers |= {path: np.array([one[path] for one in found]) for path in found[0]}
        elements = np.stack([element_rows(one, draw.strength) for one, draw in zip(each, draws, strict=True)])
    for path in numbers:
        if path.startswith("room.floor.") and path.endswith("friction"):
            numbers[path] = columns["friction"] * numbers[path]
    numbers["room.floor.restitution"] = columns["restitution"] * numbers["room.floor.restitution"]
    for wall in ("left_wall", "right_wall"):
        if getattr(held.room, wall) is not None:
            numbers[f"room.{wall}.restitution"] = columns["wall_restitution"]
    return case_rows(numbers, len(draws)), elements


def _same_mass(body: Body, held: Body) -> bool:
    same = ("width", "height", "mass", "cg_offset", "inertia")
    return all(getattr(body, name) == getattr(held, name) for name in same)


def evaluate(
    units: Sequence[Unit], measures: str, floor: Floor, sampling: Sampling
) -> tuple[NDArray[np.void], int, float]:
    """Simulate units of one option and one floor on this thread.

    Parameters
    ----------
    units : sequence
        Numbers, and what stands.
    measures : str
        Their measures.
    floor : Floor
        What shakes them.
    sampling : Sampling
        What is tried.

    Returns
    -------
    tuple
        Their RECORDs, the runs that were done, and the time they took [s].
    """
    began = time.perf_counter()
    option, runs = measures_of(measures), 0
    records = np.zeros(len(units), RECORD)
    records["unit"] = [number for number, _ in units]
    size = max(1, BLOCK // (sampling.motions * sampling.samples))
    for first in range(0, len(units), size):
        last = min(first + size, len(units))
        runs += _block([spec for _, spec in units[first:last]], option, floor, sampling, records[first:last])
    return records, runs, time.perf_counter() - began


def _block(
    specs: list[str], option: tuple[Measure, ...], floor: Floor, sampling: Sampling, out: NDArray[np.void]
) -> int:
    """Simulate a block of units, with more and more samples where a precision is asked for."""
    left, done, runs = list(range(len(specs))), 0, 0
    parts: list[list[Outcome]] = [[] for _ in specs]
    while left:
        most, precision = sampling.samples, sampling.precision
        wanted = most if precision is None else min(most, max(FIRST_SAMPLES, 2 * done))
        drawn = _drawn(sampling.motions, wanted - done, sampling.seed, done)
        found = _run([specs[n] for n in left], option, floor, drawn, sampling)
        runs += len(left) * sampling.motions * (wanted - done)
        done = wanted
        going: list[int] = []
        for n, outcome in zip(left, found, strict=True):
            parts[n].append(outcome)
            joined = Outcome.joined(parts[n])
            fallen = joined.record(sampling.slide_limit, out[n : n + 1])
            if done < most and precision is not None and fallen.runs:
                plan = samples_needed(fallen, precision)
                if plan.reachable and plan.samples > done:
                    going.append(n)
        left = going
    return runs


def _run(
    specs: list[str],
    option: tuple[Measure, ...],
    floor: Floor,
    drawn: tuple[Columns, tuple[Draw, ...]],
    sampling: Sampling,
) -> list[Outcome]:
    motions, count = sampling.motions, len(drawn[1])
    rows = [_rows_or_none(spec, option, drawn, sampling.gravity) for spec in specs]
    possible = [row for row in rows if row is not None]
    shape = (motions, count // motions)
    if not possible:
        return [Outcome.none(shape) for _ in specs]
    cases = np.stack([row[0].reshape(shape) for row in possible])
    elements = np.stack([row[1].reshape((*shape, -1)) for row in possible])
    results: list[NDArray[np.void]] = []
    failed: list[NDArray[np.bool_]] = []
    for motion in range(motions):
        mine = np.ascontiguousarray(cases[:, motion]).ravel()
        mine["scale"] = floor.scales[motion]
        ties = np.ascontiguousarray(elements[:, motion]).reshape(len(mine), -1)
        result, devices = run_rows(mine, ties, floor.shakings[motion])
        results.append(result.reshape(len(possible), -1))
        failed.append((failures_of(ties, devices).count > 0).reshape(len(possible), -1))
    together, broken = np.stack(results, axis=1), np.stack(failed, axis=1)
    outcomes = iter(Outcome.of(one, bad) for one, bad in zip(together, broken, strict=True))
    return [Outcome.none(shape) if row is None else next(outcomes) for row in rows]


def _rows_or_none(
    spec: str, option: tuple[Measure, ...], drawn: tuple[Columns, tuple[Draw, ...]], gravity: float
) -> tuple[NDArray[np.void], NDArray[np.void]] | None:
    try:
        return unit_rows(*thing_of(spec), option, drawn, gravity)
    except InputError:  # a draw in which the measure is not possible: all its runs count as given up
        return None


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """What became of a unit, each of shape (motions, samples)."""

    overturned: NDArray[np.bool_]
    missing: NDArray[np.bool_]
    hit_wall: NDArray[np.bool_]
    device_failed: NDArray[np.bool_]
    slide: NDArray[np.float64]

    @classmethod
    def of(cls, results: NDArray[np.void], failed: NDArray[np.bool_]) -> Outcome:
        """Return the outcome of rows of results."""
        ended = results["outcome"]
        return cls(
            ended == OVERTURNED_OUTCOME,
            ended == FAILED_OUTCOME,
            results["wall_impacts"] > 0,
            failed,
            results["peak_slide"],
        )

    @classmethod
    def none(cls, shape: tuple[int, int]) -> Outcome:
        """Return the outcome of runs that could not be."""
        no = np.zeros(shape, np.bool_)
        return cls(no, ~no, no, no, np.full(shape, np.nan))

    @classmethod
    def joined(cls, parts: list[Outcome]) -> Outcome:
        """Join the samples of several calls."""
        if len(parts) == 1:
            return parts[0]
        return cls(*(np.concatenate([getattr(p, name) for p in parts], axis=1) for name in cls.__slots__))

    def record(self, slide_limit: float, out: NDArray[np.void]) -> Probability:
        """Fill in a RECORD; return the probability of overturning."""
        there = ~self.missing
        runs, given_up = there.sum(axis=1), self.missing.sum(axis=1)
        events = (self.overturned, self.slide > slide_limit, self.hit_wall, self.device_failed)
        told = tuple(runs.tolist()), tuple(given_up.tolist())
        chances = [_chance(tuple((event & there).sum(axis=1).tolist()), *told) for event in events]
        fallen = chances[0]
        out["motions"], out["runs"], out["missing"], out["fell"] = (
            fallen.motions,
            fallen.runs,
            fallen.missing,
            fallen.fell,
        )
        out["chances"][0] = [(one.estimate, one.low, one.high) for one in chances]
        middle = Quantiles.of(self.slide, self.overturned)
        upright = self.slide[there & ~self.overturned]
        mean = float(upright.sum() / len(upright)) if len(upright) else np.nan
        out["slide"][0] = (middle.median, middle.p90, mean)
        return fallen


@lru_cache(maxsize=65_536)
def _chance(fell: tuple[int, ...], runs: tuple[int, ...], missing: tuple[int, ...]) -> Probability:
    """Return a probability from counts by motion; the same counts come again and again."""
    return probability_of_counts(fell, runs, missing)
