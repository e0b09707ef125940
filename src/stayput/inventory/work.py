"""The simulation units of a plan, cut into tasks of about a second for an executor to run.

A unit is a piece with a set of measures on a floor, under all motions and all draws.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import closing
from copy import copy
from functools import cache, lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.execution import Pool, Shared
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGA, PGV
from stayput.inventory.folder import OUTCOMES
from stayput.inventory.results import GROUND
from stayput.inventory.shakemap import GroundLevel
from stayput.inventory.store import OutcomeStore, Store, ground_of, record_type
from stayput.montecarlo.counting import OVERTURNED, Members, Outcomes, Quantiles
from stayput.montecarlo.runs import run_prepared
from stayput.montecarlo.sampling import DrawTable, Rows, Settings, draws, rows_of
from stayput.montecarlo.scaled_motions import PreparedFloor, ScaledMotions
from stayput.saved import from_text
from stayput.verification.contents import first_draws, share_out, spilt_under

if TYPE_CHECKING:
    from stayput.contents.contents import Contents
    from stayput.inventory.scenarios import Scenarios
    from stayput.measures import Measure
    from stayput.model.body import Body
    from stayput.model.room import Room
    from stayput.scenario.tables import BuildingTable

FIRST_SAMPLES = 4
"""Samples of each motion after which it is first looked whether a unit is as precise as asked."""

SECONDS = 1.0
"""Wanted time of a task [s]: long beside the cost of handing it on, short beside the wait for the last."""

FIRST_GUESS = {False: 3e-4, True: 6e-3}
"""Guessed time of a run, without and with devices [s]; what was measured of all runs corrects it."""

SAVE_AFTER = 5.0
"""Time after which outcomes are saved [s]: the most that is lost where the process is killed."""

SAMPLE_BYTES = 40
"""Bytes of a floor's motion for each sample: two components, while they are made and as they are prepared."""

Unit: TypeAlias = "tuple[int, str]"
"""Number of a unit, and the spec of its piece."""

MOST_RUNS = 32_768
"""Runs of a task from which it gets no more: some 10 MB."""

_draws, _first_draws = lru_cache(maxsize=64)(draws), lru_cache(maxsize=64)(first_draws)
"""The draws: all units of a scenario have the same."""


def evaluate(
    units: Sequence[Unit], measures: str, floor: PreparedFloor, settings: Settings, kind: np.dtype[np.void]
) -> tuple[NDArray[np.void], int]:
    """Simulate units of one set of measures and one floor on this thread.

    Parameters
    ----------
    units : sequence
        Numbers, and specs of the pieces.
    measures : str
        Spec of their measures.
    floor : PreparedFloor
        What shakes them.
    settings : Settings
        Monte Carlo settings.
    kind : dtype
        Type of their records; see `stayput.inventory.store.record_type`.

    Returns
    -------
    tuple
        Their records, and the runs that were done.
    """
    option: tuple[Measure, ...] = tuple(from_text(measures))
    pieces: list[tuple[Body, Room, Contents | None]] = [from_text(spec) for _, spec in units]
    runs = 0
    records = np.zeros(len(units), kind)
    records["unit"] = [number for number, _ in units]
    records["out"] = np.nan

    def run(places: list[int], samples: int, start: int) -> list[Outcomes]:
        nonlocal runs
        runs += len(places) * settings.motions * samples
        drawn = _draws(settings.motions, samples, settings.seed, start, as_stated=settings.as_stated)
        rows = [_rows_or_none(*pieces[place][:2], option, drawn, settings.gravity) for place in places]
        possible = [row for row in rows if row is not None]
        outcomes = iter(run_prepared(possible, floor, start) if possible else ())
        none = Outcomes.impossible(Members.of_samples(settings.motions, samples, start))
        return [none if row is None else next(outcomes) for row in rows]

    parts: list[list[Outcomes]] = [[] for _ in units]
    going: list[int] = [*range(len(units))]
    done, precision = 0, settings.precision
    while going and done < settings.samples:
        count = settings.samples if precision is None else min(settings.samples, max(FIRST_SAMPLES, 2 * done))
        for place, outcomes in zip(going, run(going, count - done, done), strict=True):
            parts[place] = [Outcomes.joined([*parts[place], outcomes])]
        done = count
        if precision is not None:
            going = [n for n in going if parts[n][0].probability_of_overturning().half_width > precision]
    for place, ((outcome,), (body, room, contents)) in enumerate(zip(parts, pieces, strict=True)):
        fill_record(records[place : place + 1], outcome, settings.slide_limit)
        if contents is not None:
            records["out"][place] = _share_out(body, room, contents, option, floor, settings)
    return records, runs


def _share_out(
    body: Body,
    room: Room,
    contents: Contents,
    option: tuple[Measure, ...],
    floor: PreparedFloor,
    settings: Settings,
) -> tuple[float, float, float]:
    """Return the share of the contents that comes out, and its interval, as a verification follows them."""
    drawn = _first_draws(settings.motions, settings.seed, settings.as_stated)
    rows = _rows_or_none(body, room, option, drawn, settings.gravity)
    if rows is None:
        return np.nan, np.nan, np.nan
    spilt = [spilt_under(rows, number, floor, body, contents, leaving=False) for number in range(len(drawn))]
    share = share_out(spilt, contents)
    return share.estimate, share.low, share.high


def _rows_or_none(
    body: Body, room: Room, option: tuple[Measure, ...], drawn: DrawTable, gravity: float
) -> Rows | None:
    try:
        return rows_of(body, room, option, drawn, gravity)
    except InputError:  # a draw in which the measure is not possible: all its runs count as given up
        return None


def fill_record(out: NDArray[np.void], outcomes: Outcomes, slide_limit: float) -> None:
    """Fill in the record of a unit, shape (1,)."""
    chances = outcomes.probabilities(slide_limit)
    fallen = chances[OVERTURNED]
    for name in ("motions", "runs", "missing", "fell"):
        out[name] = getattr(fallen, name)
    out["chances"][0] = [(chance.estimate, chance.low, chance.high) for chance in chances.values()]
    slide = Quantiles.of(outcomes.slide, outcomes.overturned)
    upright = outcomes.slide[~outcomes.missing & ~outcomes.overturned]
    mean = float(upright.sum() / len(upright)) if len(upright) else np.nan
    out["slide"][0] = (slide.median, slide.p90, mean)
    planes, rows, columns = out["each"].shape[1:]
    each = np.zeros((planes, rows, 8 * columns), np.bool_)
    each[-1] = True
    members = outcomes.members
    each[:, members.motion, members.sample] = (*outcomes.happened(slide_limit), outcomes.missing)
    out["each"][0] = np.packbits(each, axis=-1)


class TaskOutcome(NamedTuple):
    """Outcomes of a task, its runs, and the time that they took and that they were guessed to take [s]."""

    records: NDArray[np.void]
    runs: int
    seconds: float
    guessed: float


def prepared_floors(
    shared: Shared[ScaledMotions],
    building: BuildingTable | None,
    storeys: tuple[int, ...],
    factors: NDArray[np.float64],
) -> dict[int, PreparedFloor]:
    """Return the motions of some storeys of a building, or of the ground, whose motions have factors."""
    floors, scales = shared.value.floors(building, storeys, factors, threads=1)
    prepared = (PreparedFloor.of(motions, scales) for motions in floors)
    return dict(zip(storeys, prepared, strict=True))


def run_task(
    floors: Shared[dict[int, PreparedFloor]],
    storey: int,
    settings: Settings,
    groups: Mapping[str, Sequence[Unit]],
    kind: np.dtype[np.void],
) -> TaskOutcome:
    """Simulate units of one storey, grouped by the specs of their measures, on this thread."""
    floor, began = floors.value[storey], time.perf_counter()
    results = [evaluate(units, measures, floor, settings, kind) for measures, units in groups.items()]
    records, runs = zip(*results, strict=True)
    guessed = sum(n * FIRST_GUESS["{" in measures] for n, measures in zip(runs, groups, strict=True))
    return TaskOutcome(np.concatenate(records), sum(runs), time.perf_counter() - began, guessed)


class Work:
    """The units of a plan that are not done yet.

    Parameters
    ----------
    store : Store
        The plan.
    scenarios : Scenarios
        The scenarios.
    folder : Path
        Where outcomes are kept.
    slide_limit : float
        Slide that counts as too far [m].
    floor_memory : int
        Bytes for the floors of a building.
    """

    def __init__(
        self, store: Store, scenarios: Scenarios, folder: Path, slide_limit: float, floor_memory: int
    ) -> None:
        self.store, self.scenarios = store, scenarios
        self.floor_memory = floor_memory
        self.settings = [Settings.of(file.scenario, len(file.ground), slide_limit) for file in scenarios.all]
        motions, samples = (max(getattr(case, of) for case in self.settings) for of in ("motions", "samples"))
        self.kind = record_type(motions, samples)
        self.outcomes = OutcomeStore(folder / OUTCOMES, self.kind, store.facts()["units"])
        self.done = self.outcomes.done
        self.options = store.option_specs()
        self.runs_of_a_unit = runs = motions * samples
        self.guesses = {option: runs * FIRST_GUESS["{" in spec] for option, spec in self.options.items()}
        self.guess_left = sum(self.guesses[option] * n for option, n in store.units_by_option().items())
        self.runs, self.seconds, self.guessed = 0, 0.0, 0.0
        self.ground = cache(self._ground_of)
        """The motions of a scenario, by its place."""
        self.strengths = lru_cache(maxsize=10_000)(self._strengths_of)
        """How strongly the ground shakes in a scenario, at a map's level: the numbers of `GROUND`."""

    def close(self) -> None:
        """Close what outcomes are kept in."""
        self.outcomes.close()

    @property
    def left(self) -> int:
        """Units that are not done."""
        return int(len(self.done) - np.count_nonzero(self.done))

    def _ground_of(self, station: int) -> ScaledMotions:
        file = self.scenarios.all[station]
        vertical = bool(file.scenario.shaking.vertical)
        ground = ScaledMotions(file.ground, vertical=vertical, measure=self.scenarios.measure)
        _ = ground.to_jma_zero  # the intensity is reported in any case: refuse a still motion now
        return ground

    def _factors(self, station: int, level: GroundLevel | None) -> NDArray[np.float64]:
        """Return the factors of a scenario's motions: to the strength that it states, or to a map's level."""
        shaking, seed = self.scenarios.all[station].scenario.shaking, self.settings[station].seed
        if level is None:
            return self.ground(station).stated_factors(shaking.strength, shaking.scale, seed)
        return self.ground(station).factors(level.level, level.scatter, seed)

    def _strengths_of(self, scenario: str, level: float | None) -> dict[str, float | None]:
        station = next(n for n, file in enumerate(self.scenarios.all) if file.name == scenario)
        measure, stated = self.scenarios.measure, self.scenarios.all[station].scenario.shaking.strength
        numbers = dict[str, float | None].fromkeys(GROUND)
        if level is not None and measure == JMA_INTENSITY:
            return {**numbers, "intensity": float(level)}
        if level is None and stated is not None and stated.measure == "JMA":
            return {**numbers, "intensity": stated.level}
        if level is not None:
            name = "sa" if measure.period is not None else "pga" if measure == PGA else "pgv"
            numbers[name] = 10.0**level * (PGV.shown if name == "pgv" else 1.0)
        factors = self._factors(station, None if level is None else GroundLevel(level))
        return {**numbers, "intensity": self.ground(station).median_intensity(factors)}

    def tasks(self, width: int) -> Generator[Callable[[], TaskOutcome]]:
        """Yield tasks, each for one storey, those of a building one after another.

        The motions of the ground and of a building's floors are made once in each process.
        """
        grounds: dict[int, Shared[ScaledMotions]] = {}
        for spec, sites in self.store.grounds():
            station, level, building = ground_of(spec)
            ground, factors = self.ground(station), self._factors(station, level)
            if station not in grounds:
                grounds[station] = Shared(copy, ground)
            size = SAMPLE_BYTES * sum(len(motion.x) for motion in ground.ground)
            at_a_time = max(1, self.floor_memory // size)
            for start in range(0, len(sites), at_a_time):
                batch = sites[start : start + at_a_time]
                storeys = tuple(storey for _, storey in batch)
                floors = Shared(prepared_floors, grounds[station], building, storeys, factors)
                for site, storey in batch:
                    for groups in self._groups_at(site, width):
                        yield partial(run_task, floors, storey, self.settings[station], groups, self.kind)

    def _groups_at(self, site: int, width: int) -> Iterator[dict[str, list[Unit]]]:
        """Yield the units of a site that are not done, grouped by their measures, as much as a task takes."""
        groups: dict[str, list[Unit]] = {}
        seconds, runs = 0.0, 0
        for number, option, spec in self.store.units_at(site):
            self.guess_left -= self.guesses[option]
            if self.done[number]:
                continue
            groups.setdefault(self.options[option], []).append((number, spec))
            pace = self.seconds / self.guessed if self.guessed else 1.0
            seconds += self.guesses[option] * pace
            shorter_at_the_end = max(self.guess_left * pace / (4.0 * width), 0.02)
            runs += self.runs_of_a_unit
            if seconds >= min(SECONDS, shorter_at_the_end) or runs >= MOST_RUNS:
                yield groups
                groups, seconds, runs = {}, 0.0, 0
        if groups:
            yield groups

    def run(self, pool: Pool, advance: Callable[[int], None]) -> None:
        """Run all tasks, and save their outcomes as they are completed.

        Parameters
        ----------
        pool : Pool
            Runs them.
        advance : callable
            Called with the number of units that were just done.
        """
        saved_at = time.monotonic()
        try:
            with closing(self.tasks(pool.width)) as calls, closing(pool.as_completed(calls)) as outcomes:
                for _, outcome in outcomes:
                    self._store_outcome(outcome, advance)
                    if time.monotonic() - saved_at > SAVE_AFTER:
                        self.outcomes.commit()
                        saved_at = time.monotonic()
        finally:
            self.outcomes.commit()

    def _store_outcome(self, outcome: TaskOutcome, advance: Callable[[int], None]) -> None:
        self.runs += outcome.runs
        self.seconds += outcome.seconds
        self.guessed += outcome.guessed
        fresh = outcome.records[~self.done[outcome.records["unit"]]]
        self.done[fresh["unit"]] = True
        self.outcomes.add(fresh)
        advance(len(fresh))
