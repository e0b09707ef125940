"""`verify`: what happens to a piece of furniture without and with each measure, and how likely it is."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.fragility import JMA_INTENSITY, Trials, difference, fragility_curve, probability, samples_needed
from stayput.measures import hold
from stayput.progress import bar
from stayput.verification.devices import device_summaries
from stayput.verification.draws import draws, rows_of
from stayput.verification.estimates import Estimates
from stayput.verification.hazard import Hazard
from stayput.verification.options import options_of
from stayput.verification.ranking import members, severity
from stayput.verification.runs import Runs, run_level
from stayput.verification.verdict import (
    DEVICE_FAILED,
    HIT_WALL,
    OVERTURNED,
    SLID,
    OptionVerdict,
    Quantiles,
    Verdict,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.fragility import FragilityCurve, IntensityMeasure, Probability
    from stayput.measures import Held
    from stayput.scenario import Scenario
    from stayput.verification.draws import Rows
    from stayput.verification.hazard import Floors
    from stayput.verification.options import Option

LEVELS: NDArray[np.float64] = np.linspace(4.1, 6.95, 20)
"""JMA intensities of the ground for the fragility curves: from 4 to 7."""
LEVELS.setflags(write=False)

SLIDE_LIMIT = 0.10
"""Slide that counts as too far where nothing is said [m]."""

FIRST_SAMPLES = 4
"""Samples of each motion before the precision is looked at for the first time."""

CAPACITIES = (0.1, 0.5)
"""Shares of overturning for which the intensity is given."""


@dataclass(slots=True, eq=False)
class _Work:
    """What is needed to run the options, and how far that has got."""

    options: tuple[Option, ...]
    scenario: Scenario
    motions: int
    seed: int
    threads: int | None
    tell: Callable[[int], None]
    done: int = 0

    def rows(self, samples: int, start: int = 0) -> list[Rows]:
        """Return the rows of every option, for some samples of each motion."""
        body, room = self.scenario.furniture.body(), self.scenario.room.room()
        drawn = draws(self.motions, samples, self.seed, start)
        initial, gravity = self.scenario.initial.state(), self.scenario.gravity
        return [rows_of(option, body, room, drawn, gravity, initial) for option in self.options]

    def run(self, rows: list[Rows], floors: Floors) -> list[Runs]:
        """Run every option at a level."""
        self.done += sum(len(one.cases) for one in rows)
        return run_level(rows, floors, threads=self.threads, progress=self.tell)


def verify(
    scenario: Scenario,
    *,
    levels: Sequence[float] | NDArray[np.float64] = LEVELS,
    slide_limit: float = SLIDE_LIMIT,
    threads: int | None = None,
    progress: bool | None = None,
    told: Callable[[int, int], None] | None = None,
) -> Verdict:
    """Compare what a scenario's measures do, over its motions and over what is not known.

    Every option meets the same motions and the same draws. At the scenario's own shaking samples are added
    until every probability is as precise as was asked, or as many as were allowed are done; then all are
    run at every level for the fragility curves.

    Parameters
    ----------
    scenario : Scenario
        Furniture, room, shaking, measures, uncertainty.
    levels : sequence of float
        JMA intensities of the ground for the fragility curves, increasing; with none there are no curves.
    slide_limit : float
        Slide that counts as too far [m].
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    told : callable, optional
        Called with the runs done and the runs in all, for a bar of one's own; what it raises stops the work.

    Returns
    -------
    Verdict
        The options, the best first.

    Raises
    ------
    InputError
        The paper's contact law, which knows no devices; a measure that cannot be applied; a record that
        cannot be read.
    """
    began = time.perf_counter()
    if scenario.contact != "coulomb":
        raise InputError(f'The contact is "{scenario.contact}"; a verification needs "coulomb".')
    rows = np.asarray(levels, np.float64)
    if np.any(np.diff(rows) <= 0.0):
        raise InputError("The levels are not increasing; each must be higher than the one before it.")
    options, shaking = options_of(scenario), scenario.shaking
    ground = shaking.ground(scenario.folder)
    hazard = Hazard(ground, shaking.building, shaking.storey or 1, vertical=bool(shaking.vertical))
    most = max(1, -(-scenario.uncertainty.samples // len(ground)))
    total = len(options) * len(ground) * most * (1 + len(rows))
    with bar(total, "Verifying", progress) as tell:
        seen = 0

        def count(runs: int) -> None:
            nonlocal seen
            seen += runs
            tell(runs)
            if told is not None:
                told(seen, total)

        work = _Work(options, scenario, len(ground), scenario.uncertainty.seed, threads, count)
        wanted = shaking.wanted_intensity
        scale = 1.0 if shaking.scale is None else shaking.scale
        floors = hazard.as_given(scale, threads) if wanted is None else hazard.at(wanted, threads)
        here, samples, precise = _at_the_scenario(work, floors, most, scenario.uncertainty.precision)
        by_level, measures = _at_all_levels(work, hazard, rows, samples)
    body, room = scenario.furniture.body(), scenario.room.room()
    held = [hold(body, room, option.measures) for option in options]
    verdicts = _verdicts(options, held, here, by_level, measures, slide_limit)
    return Verdict(
        scenario=scenario,
        intensity=float(np.median(floors.measures[JMA_INTENSITY])),
        slide_limit=slide_limit,
        options=verdicts,
        estimates=Estimates.of(body, floors, scenario.gravity),
        levels=rows,
        motions=len(ground),
        samples=samples,
        runs=work.done,
        precise=precise,
        seed=scenario.uncertainty.seed,
        seconds=time.perf_counter() - began,
    )


def _at_the_scenario(
    work: _Work, floors: Floors, most: int, precision: float | None
) -> tuple[list[Runs], int, bool]:
    """Run the scenario's own shaking, more and more samples until the precision is reached."""
    parts: list[list[Runs]] = [[] for _ in work.options]
    done = 0
    while True:
        wanted = most if precision is None else min(most, max(FIRST_SAMPLES, 2 * done))
        for kept, found in zip(parts, work.run(work.rows(wanted - done, done), floors), strict=True):
            kept.append(found)
        done = wanted
        joined = [Runs.joined(kept) for kept in parts]
        if precision is None:
            return joined, done, True
        found = [probability(runs.overturned, runs.missing) for runs in joined]
        plans = [samples_needed(one, precision) for one in found if one.runs]
        enough = all(plan.samples <= done for plan in plans if plan.reachable)
        if enough or done >= most:
            return (
                joined,
                done,
                enough and len(plans) == len(joined) and all(plan.reachable for plan in plans),
            )


def _at_all_levels(
    work: _Work, hazard: Hazard, levels: NDArray[np.float64], samples: int
) -> tuple[list[list[Runs]], list[Floors]]:
    rows = work.rows(samples) if len(levels) else []
    found: list[list[Runs]] = []
    measures: list[Floors] = []
    for level in levels:
        floors = hazard.at(float(level), work.threads)
        found.append(work.run(rows, floors))
        measures.append(floors)
    return found, measures


def _curves(
    number: int, name: str, by_level: list[list[Runs]], measures: list[Floors]
) -> dict[IntensityMeasure, FragilityCurve]:
    if not by_level:
        return {}
    fallen = np.stack([runs[number].overturned for runs in by_level])
    missing = np.stack([runs[number].missing for runs in by_level])
    return {
        im: fragility_curve(
            Trials.from_runs(im, np.stack([floors.measures[im] for floors in measures]), fallen, missing),
            name=name,
        )
        for im in measures[0].measures
    }


def _probabilities(runs: Runs, slide_limit: float) -> dict[str, Probability]:
    happened = {
        OVERTURNED: runs.overturned,
        SLID: runs.slide > slide_limit,
        HIT_WALL: runs.hit_wall,
        DEVICE_FAILED: runs.device_failed,
    }
    return {event: probability(values, runs.missing) for event, values in happened.items()}


def _verdicts(
    options: tuple[Option, ...],
    held: list[Held],
    here: list[Runs],
    by_level: list[list[Runs]],
    measures: list[Floors],
    slide_limit: float,
) -> tuple[OptionVerdict, ...]:
    chances = [_probabilities(runs, slide_limit) for runs in here]
    order = sorted(range(len(options)), key=lambda i: (*severity(chances[i], len(options[i].measures)), i))
    found: list[OptionVerdict] = []
    for rank, i in enumerate(order, start=1):
        runs, option = here[i], options[i]
        curves = _curves(i, option.name, by_level, measures)
        typical, worst = members(runs)
        found.append(
            OptionVerdict(
                option=option,
                rank=rank,
                probabilities=chances[i],
                change=difference(runs.overturned, here[0].overturned, runs.missing | here[0].missing)
                if option.measures
                else None,
                slide=Quantiles.of(runs.slide, runs.overturned),
                tilt=Quantiles.of(runs.tilt, runs.overturned),
                devices=device_summaries(held[i], runs),
                curves=curves,
                capacities={p: curves[JMA_INTENSITY].capacity(p) for p in CAPACITIES} if curves else {},
                typical=typical,
                worst=worst,
            )
        )
    return tuple(found)
