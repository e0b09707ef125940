"""The units of a plan, cut into tasks of about a second for an executor to run.

A unit is a piece on a floor, with the sets of measures that are compared there: it is verified as a scenario
of its own is, by the same race under the same motions and draws.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from copy import copy
from dataclasses import replace
from functools import cache, lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.execution import Pool, Shared
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGA, PGV
from stayput.inventory.folder import OUTCOMES
from stayput.inventory.shakemap import GroundLevel
from stayput.inventory.store import GROUND, RECORD, OutcomeStore, Store, ground_of
from stayput.montecarlo.counting import OVERTURNED, Outcomes, Quantiles
from stayput.montecarlo.runs import Runs
from stayput.montecarlo.sampling import Settings
from stayput.montecarlo.scaled_motions import FloorMotions, ScaledMotions
from stayput.saved import from_text
from stayput.scenario.measures import Option
from stayput.scenario.pieces import PieceTable
from stayput.scenario.tables import RoomTable
from stayput.verification.contents import share_out, spilt_by_option
from stayput.verification.entry import tables_of
from stayput.verification.option_runner import OptionRunner
from stayput.verification.race import Race

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.inventory.scenarios import Scenarios
    from stayput.measures import Measure
    from stayput.model.body import Body
    from stayput.model.room import Room
    from stayput.scenario import Scenario
    from stayput.scenario.tables import BuildingTable

SECONDS = 1.0
"""Wanted time of a task [s]: long beside the cost of handing it on, short beside the wait for the last."""

FIRST_GUESS = 0.3
"""Guessed time of a unit [s]; what was measured of all units corrects it."""

SAVE_AFTER = 5.0
"""Time after which outcomes are saved [s]: the most that is lost where the process is killed."""

SAMPLE_BYTES = 60
"""Bytes of a floor's motion for each sample: three components, while they are made and as they are run."""

MOST_UNITS = 1000
"""Units of a task from which it gets no more: some MB of records."""

Unit: TypeAlias = "tuple[int, str]"
"""Number of the first record of a unit, and the spec of its piece."""


def scenario_of(
    stated: Scenario, body: Body, room: Room, options: Sequence[tuple[Measure, ...]]
) -> tuple[Scenario, list[Option]]:
    """Return the scenario in which a piece of an inventory is verified, and its options.

    Parameters
    ----------
    stated : Scenario
        The scenario of the inventory.
    body, room
        The piece and where it stands.
    options : sequence of tuple of Measure
        The options, the first with what is in place already.
    """
    tables, _ = tables_of(body, room)
    stands = {
        "furniture": PieceTable.model_validate(tables["furniture"]).with_python({"measures": options[0]}),
        "room": RoomTable.model_validate(tables["room"]),
    }
    compared = [Option(str(number), (measures,)) for number, measures in enumerate(options)]
    return stated.model_copy(update=stands).with_python(measures=compared[1:]), compared


def evaluate(
    unit: Unit, options: Sequence[str], floor: FloorMotions, stated: Scenario, slide_limit: float
) -> tuple[NDArray[np.void], int]:
    """Verify a unit on this thread.

    Parameters
    ----------
    unit : tuple
        Number of its first record, and the spec of its piece.
    options : sequence of str
        Specs of the options that are compared.
    floor : FloorMotions
        What shakes it.
    stated : Scenario
        The scenario of the inventory.
    slide_limit : float
        Slide that counts as too far [m].

    Returns
    -------
    tuple
        Its records (`stayput.inventory.store.RECORD`), one for each option, and the runs that were made.
    """
    body, room, contents = from_text(unit[1])
    scenario, compared = scenario_of(stated, body, room, [tuple(from_text(spec)) for spec in options])
    if scenario.dimensions == 2 and stated.dimensions == 3 and stated.direction:
        floor = replace(floor, motions=[motion.pointing(stated.direction) for motion in floor.motions])
    made = 0

    def count(runs: int) -> None:
        nonlocal made
        made += runs

    runner = OptionRunner(scenario, slide_limit, 1, floors=floor, advance=count)
    outcomes = _outcomes(runner, compared)
    shares: list[Probability | None] = [None] * len(compared)
    if contents is not None:
        possible = [place for place, runs in enumerate(outcomes) if not runs.missing.all()]
        counts = [len(outcomes[place].members) for place in possible]
        spilt = spilt_by_option(runner, [compared[place] for place in possible], counts, contents)
        for place, of_option in zip(possible, spilt, strict=True):
            shares[place] = share_out(of_option, contents)
    records = np.zeros(len(compared), RECORD)
    records["number"] = unit[0] + np.arange(len(compared))
    for place, (runs, share) in enumerate(zip(outcomes, shares, strict=True)):
        fill_record(records[place], runs, slide_limit, share)
        fill_changes(records[place], runs, outcomes[0], slide_limit, len(compared) - 1)
    return records, made


def _outcomes(runner: OptionRunner, options: Sequence[Option]) -> list[Outcomes]:
    """Return the outcomes of options; of one that is not possible in every draw all runs are given up."""
    try:
        return _raced(runner, options)
    except InputError:
        possible = [option for option in options if _is_possible(runner, option)]
    made = iter(_raced(runner, possible) if possible else ())
    none = Outcomes.impossible(runner.members)
    return [next(made) if option in possible else none for option in options]


def _raced(runner: OptionRunner, options: Sequence[Option]) -> list[Outcomes]:
    race = Race(runner, options)
    for _ in race.looks():
        pass
    return [*race.runs]


def _is_possible(runner: OptionRunner, option: Option) -> bool:
    try:
        runner.run([option], runner.members)
    except InputError:
        return False
    return True


def fill_record(
    record: np.void, outcomes: Outcomes, slide_limit: float, share: Probability | None = None
) -> None:
    """Fill in the record of an option, with the share of the contents that come out."""
    has_devices = not isinstance(outcomes, Runs) or outcomes.devices.shape[1] > 0
    chances = outcomes.probabilities(slide_limit, has_devices=has_devices)
    fallen = chances[OVERTURNED]
    for name in ("motions", "runs", "missing", "fell"):
        record[name] = getattr(fallen, name)
    record["chances"] = [(chance.estimate, chance.low, chance.high) for chance in chances.values()]
    slide = Quantiles.of(outcomes.slide, outcomes.overturned)
    upright = outcomes.slide[~outcomes.missing & ~outcomes.overturned]
    mean = float(upright.sum() / len(upright)) if len(upright) else np.nan
    record["slide"] = (slide.median, slide.p90, mean)
    record["out"] = np.nan if share is None else (share.estimate, share.low, share.high)


def fill_changes(
    record: np.void, outcomes: Outcomes, bare: Outcomes, slide_limit: float, comparisons: int
) -> None:
    """Fill in by how much likelier events are with an option than without a measure."""
    if outcomes is bare:
        record["change"] = np.nan
        return
    each = zip(outcomes.happened(slide_limit), bare.happened(slide_limit), strict=True)
    changes = [
        outcomes.difference(now | outcomes.overturned, bare, then | bare.overturned, comparisons)
        for now, then in each
    ]
    record["change"] = [(change.estimate, change.low, change.high) for change in changes]


class TaskOutcome(NamedTuple):
    """Records of a task, its units and runs, and the time that they took [s]."""

    records: NDArray[np.void]
    units: int
    runs: int
    seconds: float


Floors: TypeAlias = "tuple[Scenario, dict[int, FloorMotions]]"
"""A scenario, and the motions under the furniture of some storeys."""


def floors_of(
    ground: Shared[tuple[Scenario, ScaledMotions]],
    building: BuildingTable | None,
    storeys: tuple[int, ...],
    factors: NDArray[np.float64],
) -> Floors:
    """Return the motions of some storeys of a building, or of the ground, whose motions have factors."""
    scenario, motions = ground.value
    floors, scales = motions.floors(building, storeys, factors, threads=1)
    of_ground = {JMA_INTENSITY: motions.intensities(factors)}
    moved = {
        storey: FloorMotions(under, scales, of_ground) for storey, under in zip(storeys, floors, strict=True)
    }
    return scenario, moved


def run_task(
    floors: Shared[Floors], storey: int, slide_limit: float, groups: Sequence[tuple[Sequence[str], Unit]]
) -> TaskOutcome:
    """Verify units of one storey, each with the specs of its options, on this thread."""
    (scenario, moved), began = floors.value, time.perf_counter()
    results = [evaluate(unit, options, moved[storey], scenario, slide_limit) for options, unit in groups]
    records, runs = zip(*results, strict=True)
    return TaskOutcome(np.concatenate(records), len(groups), sum(runs), time.perf_counter() - began)


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
        self.outcomes = OutcomeStore(folder / OUTCOMES, store.facts()["units"])
        self.done = self.outcomes.done
        self.options = store.option_specs()
        self.units, self.runs, self.seconds = 0, 0, 0.0
        self.ground = cache(self._ground_of)
        """The motions of a scenario, by its place."""
        self.strengths = lru_cache(maxsize=10_000)(self._strengths_of)
        """How strongly the ground shakes in a scenario, at a map's level: the numbers of `GROUND`."""

    def close(self) -> None:
        """Close what outcomes are kept in."""
        self.outcomes.close()

    @property
    def left(self) -> int:
        """Records that are not made."""
        return int(len(self.done) - np.count_nonzero(self.done))

    def _ground_of(self, station: int) -> ScaledMotions:
        file = self.scenarios.all[station]
        ground = ScaledMotions(
            file.ground,
            vertical=bool(file.scenario.shaking.vertical),
            dimensions=file.scenario.dimensions,
            measure=self.scenarios.measure,
        )
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
        grounds: dict[int, Shared[tuple[Scenario, ScaledMotions]]] = {}
        for spec, sites in self.store.grounds():
            station, level, building = ground_of(spec)
            ground, factors = self.ground(station), self._factors(station, level)
            if station not in grounds:
                grounds[station] = Shared(copy, (self.scenarios.all[station].scenario, ground))
            size = SAMPLE_BYTES * sum(len(motion.x) for motion in ground.ground)
            at_a_time = max(1, self.floor_memory // size)
            for start in range(0, len(sites), at_a_time):
                batch = sites[start : start + at_a_time]
                storeys = tuple(storey for _, storey in batch)
                floors = Shared(floors_of, grounds[station], building, storeys, factors)
                limit = self.settings[station].slide_limit
                for site, storey in batch:
                    for units in self._units_at(site, width):
                        yield partial(run_task, floors, storey, limit, units)

    def _units_at(self, site: int, width: int) -> Iterator[list[tuple[list[str], Unit]]]:
        """Yield the units of a site that are not done, with their options, as many as a task takes."""
        units, seconds = list[tuple[list[str], Unit]](), 0.0
        for number, place, spec in self.store.units_at(site):
            options = self.options[place]
            # one that was interrupted may have left records of a part of them
            if self.done[number : number + len(options)].all():
                continue
            units.append((options, (number, spec)))
            pace = self.seconds / self.units if self.units else FIRST_GUESS
            seconds += pace
            # the last tasks are short, so that all threads end at about the same time
            at_the_end = pace * self.left / (4.0 * width * len(options))
            if seconds >= min(SECONDS, max(at_the_end, 0.02)) or len(units) >= MOST_UNITS:
                yield units
                units, seconds = [], 0.0
        if units:
            yield units

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
        self.units += outcome.units
        self.runs += outcome.runs
        self.seconds += outcome.seconds
        fresh = outcome.records[~self.done[outcome.records["number"]]]
        self.done[fresh["number"]] = True
        self.outcomes.add(fresh)
        advance(len(fresh))
