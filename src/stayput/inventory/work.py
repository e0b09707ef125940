"""The simulation units of a plan, cut into tasks of about a second for an executor to run."""

from __future__ import annotations

from collections import deque
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from stayput.execution import Shared
from stayput.inventory.records import OutcomeStore, record_type
from stayput.inventory.store import ground_of
from stayput.inventory.units import Unit, evaluate
from stayput.inventory.workspace import OUTCOMES
from stayput.montecarlo.hazard import Ground, PreparedFloor
from stayput.montecarlo.sampling import Settings

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator
    from pathlib import Path

    from numpy.typing import NDArray

    from stayput.execution import Pool
    from stayput.inventory.scenarios import Scenarios
    from stayput.inventory.store import Store
    from stayput.scenario.tables import BuildingTable

SECONDS = 1.0
"""Wanted time of a task [s]: long beside the cost of handing it on, short beside the wait for the last."""

FIRST_GUESS = {False: 3e-4, True: 6e-3}
"""Time of a run before any was measured, without and with devices [s]."""

SAVE_AFTER, SAVE_UNITS = 5.0, 50_000
"""Outcomes are saved after so many seconds or units: the most that is lost where the process is killed."""

SAMPLE_BYTES = 40
"""Bytes of a floor's motion for each sample: two components, while they are made and as they are prepared."""


@dataclass(frozen=True, slots=True, eq=False)
class FloorRequest:
    """A request for the floor motions of one building: computed once, for all tasks there.

    Parameters
    ----------
    station : int
        The scenario.
    building : BuildingTable, optional
        The building; none on the ground.
    storeys : tuple of int
        The wanted storeys.
    factors : ndarray
        Factors on the ground's motions.
    """

    station: int
    building: BuildingTable | None
    storeys: tuple[int, ...]
    factors: NDArray[np.float64]

    def floors(self, shared: Shared[Ground]) -> dict[int, PreparedFloor]:
        """Return the floor motions of each storey."""
        ground = shared.value
        floors, scales = ground.floors(self.building, self.storeys, self.factors, threads=1)
        if self.building is None:  # the same motions for all
            return dict.fromkeys(self.storeys, PreparedFloor.of(ground.acting, scales))
        return {
            storey: PreparedFloor.of(motions, scales)
            for storey, motions in zip(self.storeys, floors, strict=True)
        }


@dataclass(frozen=True, slots=True, eq=False)
class UnitTask:
    """Units of one storey, grouped by their measures, as one task of an executor."""

    request: FloorRequest
    storey: int
    settings: Settings
    groups: tuple[tuple[int, str, tuple[Unit, ...]], ...]
    kind: np.dtype[np.void]

    def run(self, floors: Shared[dict[int, PreparedFloor]]) -> TaskOutcome:
        """Simulate the units on this thread."""
        floor = floors.value[self.storey]
        results = [
            (option, *evaluate(units, measures, floor, self.settings, self.kind))
            for option, measures, units in self.groups
        ]
        records = np.concatenate([result[1] for result in results])
        return TaskOutcome(records, tuple((option, runs, seconds) for option, _, runs, seconds in results))


@dataclass(frozen=True, slots=True, eq=False)
class TaskOutcome:
    """Outcomes of a task, and for each option the runs and the seconds."""

    records: NDArray[np.void]
    costs: tuple[tuple[int, int, float], ...]


class Costs:
    """Measured time of a run for each option [s], from which the size of tasks follows."""

    def __init__(self, options: dict[int, str], left: dict[int, int], runs: int) -> None:
        self.mean = {number: FIRST_GUESS["{" in spec] for number, spec in options.items()}
        self.seen: dict[int, list[float]] = {}
        self.left = dict(left)
        self.runs = runs  # of a unit

    def unit(self, option: int) -> float:
        """Return the time of a unit [s]."""
        return self.mean[option] * self.runs

    def update(self, done: TaskOutcome) -> None:
        """Update the times by those of a task."""
        for option, runs, seconds in done.costs:
            total = self.seen.setdefault(option, [0.0, 0.0])
            total[0] += seconds
            total[1] += runs
            self.mean[option] = total[0] / max(total[1], 1.0)

    def wanted(self, width: int) -> float:
        """Return the time that the next task is to take [s]: shorter towards the end."""
        rest = sum(count * self.unit(option) for option, count in self.left.items())
        return min(SECONDS, max(rest / (4.0 * width), 0.02))


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
        self,
        store: Store,
        scenarios: Scenarios,
        folder: Path,
        slide_limit: float,
        floor_memory: int,
    ) -> None:
        self.store, self.scenarios = store, scenarios
        self.floor_memory = floor_memory
        self.settings = [Settings.of(file.scenario, len(file.ground), slide_limit) for file in scenarios.all]
        motions, samples = (max(getattr(one, of) for one in self.settings) for of in ("motions", "samples"))
        self.kind = record_type(motions, samples)
        self.outcomes = OutcomeStore(folder / OUTCOMES, self.kind, store.facts()["units"])
        self.done = self.outcomes.done
        self.grounds: dict[int, Ground] = {}
        self.options = store.option_specs()
        runs = max(settings.motions * settings.samples for settings in self.settings)
        self.costs = Costs(self.options, store.units_by_option(), runs)
        self.runs, self.seconds = 0, 0.0

    def close(self) -> None:
        """Close what outcomes are kept in."""
        self.outcomes.close()

    @property
    def left(self) -> int:
        """Units that are not done."""
        return int(len(self.done) - np.count_nonzero(self.done))

    def ground(self, station: int) -> Ground:
        """Return the motions of a scenario."""
        if station not in self.grounds:
            file = self.scenarios.all[station]
            vertical = bool(file.scenario.shaking.vertical)
            ground = Ground(file.ground, vertical, self.scenarios.measure)
            _ = ground.to_jma_zero  # the intensity is reported in any case: refuse a still motion now
            self.grounds[station] = ground
        return self.grounds[station]

    def tasks(self, width: int) -> Generator[UnitTask]:
        """Yield tasks, each for one storey, those of a building one after another."""
        for spec, sites in self.store.grounds():
            station, level, building = ground_of(spec)
            ground, shaking = self.ground(station), self.scenarios.all[station].scenario.shaking
            if level is None:
                factors = ground.stated(shaking.strength, shaking.scale, self.settings[station].seed)
            else:
                factors = ground.factors(level.level, level.scatter, self.settings[station].seed)
            for batch in self._storeys_at_a_time(ground, sites):
                storeys = tuple(storey for _, storey in batch)
                request = FloorRequest(station, building, storeys, factors)
                for site, storey in batch:
                    yield from self._tasks_at(site, storey, request, width)

    def _storeys_at_a_time(
        self, ground: Ground, sites: list[tuple[int, int]]
    ) -> Iterator[list[tuple[int, int]]]:
        size = SAMPLE_BYTES * sum(len(motion.x) for motion in ground.motions)
        batch_size = max(1, self.floor_memory // size)
        for start in range(0, len(sites), batch_size):
            yield sites[start : start + batch_size]

    def _tasks_at(self, site: int, storey: int, request: FloorRequest, width: int) -> Iterator[UnitTask]:
        groups: dict[int, list[Unit]] = {}
        time = 0.0

        def task() -> UnitTask:
            return UnitTask(
                request,
                storey,
                self.settings[request.station],
                tuple((option, self.options[option], tuple(units)) for option, units in groups.items()),
                self.kind,
            )

        for number, option, spec in self.store.units_at(site):
            self.costs.left[option] -= 1
            if self.done[number]:
                continue
            groups.setdefault(option, []).append((number, spec))
            time += self.costs.unit(option)
            if time >= self.costs.wanted(width):
                yield task()
                groups, time = {}, 0.0
        if groups:
            yield task()

    def _calls(self, width: int) -> Generator[Callable[[], TaskOutcome]]:
        """Yield the tasks as calls; the motions of the ground and of a building's floors are made once."""
        grounds: dict[int, Shared[Ground]] = {}
        request: FloorRequest | None = None
        floors: Shared[dict[int, PreparedFloor]] | None = None
        for task in self.tasks(width):
            if task.request is not request or floors is None:
                request = task.request
                if request.station not in grounds:
                    grounds[request.station] = Shared(_itself, self.ground(request.station))
                floors = Shared(request.floors, grounds[request.station])
            yield partial(task.run, floors)

    def run(self, pool: Pool, advance: Callable[[int], None], clock: Callable[[], float]) -> None:
        """Run all tasks, and save their outcomes as they are completed.

        Parameters
        ----------
        pool : Pool
            Runs them.
        advance : callable
            Called with the number of units that were just done.
        clock : callable
            The time [s].
        """
        unsaved: deque[NDArray[np.void]] = deque()
        saved_at = clock()

        def save() -> None:
            nonlocal saved_at
            if unsaved:
                self.outcomes.save(np.concatenate(unsaved))
                unsaved.clear()
            saved_at = clock()

        try:
            with (
                closing(self._calls(pool.width)) as calls,
                closing(pool.as_completed(calls)) as outcomes,
            ):
                for _, outcome in outcomes:
                    self._store_outcome(outcome, unsaved, advance)
                    if clock() - saved_at > SAVE_AFTER or sum(map(len, unsaved)) >= SAVE_UNITS:
                        save()
        finally:
            save()

    def _store_outcome(
        self, outcome: TaskOutcome, unsaved: deque[NDArray[np.void]], advance: Callable[[int], None]
    ) -> None:
        self.costs.update(outcome)
        self.runs += sum(runs for _, runs, _ in outcome.costs)
        self.seconds += sum(seconds for _, _, seconds in outcome.costs)
        records = outcome.records
        fresh = records[~self.done[records["unit"]]]
        self.done[fresh["unit"]] = True
        if len(fresh):
            unsaved.append(fresh)
        advance(len(fresh))


def _itself(ground: Ground) -> Ground:
    return ground
