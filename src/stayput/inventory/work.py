"""The work of a plan in tasks of about a second, whoever does them: `stayput.inventory.crews`."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from stayput.inventory.floors import Floor, Ground, floors_of
from stayput.inventory.records import RECORD, all_records, write_records
from stayput.inventory.specs import ground_of
from stayput.inventory.units import Sampling, Unit, evaluate

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator
    from pathlib import Path

    from numpy.typing import NDArray

    from stayput.inventory.city import Cities
    from stayput.inventory.store import Store
    from stayput.scenario.building import BuildingTable

SECONDS = 1.0
"""Wanted time of a task [s]: long beside the cost of handing it on, short beside the wait for the last."""

FIRST_GUESS = {False: 3e-4, True: 6e-3}
"""Time of a run before any was measured, without and with devices [s]."""

KEEP_AFTER, KEEP_UNITS = 5.0, 50_000
"""Outcomes are written after so many seconds or units: what a kill may cost."""

AHEAD = 3
"""Tasks handed in for each thread."""

SAMPLE_BYTES = 40
"""Bytes of a floor's motion for each sample: two components, as they are made and as they are kept."""


@dataclass(frozen=True, slots=True, eq=False)
class Shaken:
    """What is needed to shake the storeys of one building: made once, for all tasks there.

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

    def floors(self, ground: Ground) -> dict[int, Floor]:
        """Return what shakes the furniture of each storey."""
        return floors_of(ground, self.building, self.storeys, self.factors)


@dataclass(frozen=True, slots=True, eq=False)
class Task:
    """Units of one storey, the same measures together."""

    shaken: Shaken
    storey: int
    sampling: Sampling
    groups: tuple[tuple[int, str, tuple[Unit, ...]], ...]

    def run(self, floors: dict[int, Floor]) -> Done:
        """Simulate the units on this thread."""
        found = [
            (option, *evaluate(units, measures, floors[self.storey], self.sampling))
            for option, measures, units in self.groups
        ]
        records = np.concatenate([one[1] for one in found])
        return Done(records, tuple((option, runs, seconds) for option, _, runs, seconds in found))


@dataclass(frozen=True, slots=True, eq=False)
class Done:
    """Outcomes of a task, and for each option the runs and the seconds."""

    records: NDArray[np.void]
    costs: tuple[tuple[int, int, float], ...]


class Crew(Protocol):
    """Who does the tasks."""

    def width(self) -> int:
        """Return how many tasks are done at a time."""
        ...

    def hand_in(self, task: Task) -> None:
        """Take a task; the floors it needs are made where they are not yet."""
        ...

    def done(self) -> Iterator[Done]:
        """Give what is done, at least one task's where there are any."""
        ...

    def waiting(self) -> int:
        """Return how many tasks are not done."""
        ...


class Costs:
    """Seconds a run for each option, measured as the work goes on."""

    def __init__(self, options: dict[int, str], left: dict[int, int], runs: int) -> None:
        self.mean = {number: FIRST_GUESS["{" in spec] for number, spec in options.items()}
        self.seen: dict[int, list[float]] = {}
        self.left = dict(left)
        self.runs = runs  # of a unit

    def unit(self, option: int) -> float:
        """Return the time of a unit [s]."""
        return self.mean[option] * self.runs

    def learn(self, done: Done) -> None:
        """Take in what a task took."""
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
    """All units of a plan, those done already left out.

    Parameters
    ----------
    store : Store
        The plan.
    cities : Cities
        The scenarios.
    folder : Path
        Where outcomes are kept.
    plan : str
        Digest of the plan.
    slide_limit : float
        Slide that counts as too far [m].
    room_for_floors : int
        Bytes for the floors of a building.
    """

    def __init__(
        self,
        store: Store,
        cities: Cities,
        folder: Path,
        plan: str,
        *,
        slide_limit: float,
        room_for_floors: int,
    ) -> None:
        self.store, self.cities, self.folder, self.plan = store, cities, folder, plan
        self.room_for_floors = room_for_floors
        folder.mkdir(exist_ok=True)
        self.done = np.zeros(store.facts()["units"], np.bool_)
        for records in all_records(folder, plan):
            self.done[records["unit"]] = True
        self.grounds: dict[int, Ground] = {}
        self.samplings = [sampling_of(cities, place, slide_limit) for place in range(len(cities.all))]
        self.options = store.option_specs()
        runs = max(one.motions * one.samples for one in self.samplings)
        self.costs = Costs(self.options, store.work_left(), runs)
        self.runs, self.seconds = 0, 0.0

    @property
    def left(self) -> int:
        """Units that are not done."""
        return int(len(self.done) - np.count_nonzero(self.done))

    def ground(self, station: int) -> Ground:
        """Return the motions of a scenario."""
        if station not in self.grounds:
            city = self.cities.all[station]
            vertical = bool(city.scenario.shaking.vertical)
            self.grounds[station] = Ground.of(city.ground, vertical, self.cities.strength)
        return self.grounds[station]

    def tasks(self, width: Callable[[], int]) -> Generator[Task]:
        """Give tasks, each for one storey, those of a building one after another."""
        for spec, sites in self.store.grounds():
            station, level, building = ground_of(spec)
            ground, shaking = self.ground(station), self.cities.all[station].scenario.shaking
            wanted = shaking.wanted_intensity if level is None else level
            factors = ground.factors(wanted, 1.0 if shaking.scale is None else shaking.scale)
            for some in self._storeys_at_a_time(ground, sites):
                shaken = Shaken(station, building, tuple(storey for _, storey in some), factors)
                for site, storey in some:
                    yield from self._tasks_at(site, storey, shaken, self.samplings[station], width)

    def _storeys_at_a_time(
        self, ground: Ground, sites: list[tuple[int, int]]
    ) -> Iterator[list[tuple[int, int]]]:
        size = SAMPLE_BYTES * sum(len(motion.x) for motion in ground.motions)
        many = max(1, self.room_for_floors // size)
        for start in range(0, len(sites), many):
            yield sites[start : start + many]

    def _tasks_at(
        self, site: int, storey: int, shaken: Shaken, sampling: Sampling, width: Callable[[], int]
    ) -> Iterator[Task]:
        groups: dict[int, list[Unit]] = {}
        time = 0.0

        def task() -> Task:
            return Task(
                shaken,
                storey,
                sampling,
                tuple((option, self.options[option], tuple(units)) for option, units in groups.items()),
            )

        for number, option, spec in self.store.units_at(site):
            self.costs.left[option] -= 1
            if self.done[number]:
                continue
            groups.setdefault(option, []).append((number, spec))
            time += self.costs.unit(option)
            if time >= self.costs.wanted(width()):
                yield task()
                groups, time = {}, 0.0
        if groups:
            yield task()

    def run(self, crew: Crew, tell: Callable[[int], None], clock: Callable[[], float]) -> None:
        """Have all tasks done, and keep their outcomes as they come.

        Parameters
        ----------
        crew : Crew
            Who does them.
        tell : callable
            Told of units that are done.
        clock : callable
            The time [s].
        """
        waiting: deque[NDArray[np.void]] = deque()
        kept_at = clock()
        tasks = self.tasks(crew.width)
        more = True

        def keep() -> None:
            nonlocal kept_at
            if waiting:
                write_records(self.folder, np.concatenate(waiting), self.plan)
                waiting.clear()
            kept_at = clock()

        try:
            while True:
                while more and crew.waiting() < AHEAD * crew.width():
                    task = next(tasks, None)
                    if task is None:
                        more = False
                    else:
                        crew.hand_in(task)
                if not more and not crew.waiting():
                    break
                for found in crew.done():
                    self._take(found, waiting, tell)
                if clock() - kept_at > KEEP_AFTER or sum(map(len, waiting)) >= KEEP_UNITS:
                    keep()
        finally:
            tasks.close()
            keep()

    def _take(self, found: Done, waiting: deque[NDArray[np.void]], tell: Callable[[int], None]) -> None:
        self.costs.learn(found)
        self.runs += sum(runs for _, runs, _ in found.costs)
        self.seconds += sum(seconds for _, _, seconds in found.costs)
        records = found.records
        fresh = records[~self.done[records["unit"]]].astype(RECORD)
        self.done[fresh["unit"]] = True
        if len(fresh):
            waiting.append(fresh)
        tell(len(fresh))


def sampling_of(cities: Cities, station: int, slide_limit: float) -> Sampling:
    """Return what a scenario says of its samples: as many for each motion as a verification takes."""
    city = cities.all[station]
    said, motions = city.scenario.uncertainty, len(city.ground)
    samples = max(1, -(-said.samples // motions))
    return Sampling(motions, samples, said.seed, said.precision, slide_limit, city.scenario.gravity)
