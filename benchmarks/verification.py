"""Verifications: what it saves not to run what other levels tell, and how often that rule is wrong.

``python benchmarks/verification.py speed [MOTIONS SAMPLES TURNS]``: all runs, and those that are needed, in
turns, of a bookcase with the usual measures; 20 motions, 40 samples and 1 turn where nothing is said.
``python benchmarks/verification.py rule [SCENARIOS IN_SPACE]``: all runs of drawn scenarios in the plane and
in space, 140 and 8 where nothing is said, beside those that the rule settles and what it makes of the curves.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field
from functools import cache
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

import workload as work
from stayput.errors import InputError
from stayput.fragility.curve import fragility_curve
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.fragility.trials import Trials
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.scenario import Scenario
from stayput.verification import LEVELS, verify
from stayput.verification.compare import CAPACITIES
from stayput.verification.contest import Contest
from stayput.verification.options import compared_options

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.verification import Verdict

ROOM = {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}}


def bookcase(motions: int, samples: int) -> Scenario:
    """A full bookcase on the ground with all usual measures: nine options."""
    return Scenario.parse(
        {
            "furniture": {"preset": "bookcase"},
            "room": ROOM,
            "shaking": {"intensity": "6-upper", "suite": {"count": motions}},
            "uncertainty": {"samples": samples},
        }
    )


def speed(motions: int = 20, samples: int = 40, turns: int = 1) -> Table:
    """Time both kinds of verification in turns."""
    scenario = bookcase(motions, samples)
    verify(bookcase(2, 2), progress=False)  # compiles
    spent: dict[bool, list[tuple[float, float]]] = {True: [], False: []}
    verdicts: dict[bool, Verdict] = {}
    for _ in range(turns):
        for every_run in (True, False):
            processor = time.process_time()
            verdicts[every_run] = verify(scenario, every_run=every_run, progress=False)
            spent[every_run].append((verdicts[every_run].seconds, time.process_time() - processor))
    pairs = zip(verdicts[True].options, verdicts[False].options, strict=True)
    shifts = [abs(one.capacities[0.5].estimate - other.capacities[0.5].estimate) for one, other in pairs]
    table = Table(
        title=f"{motions} motions, {samples} samples, {work.cores()} cores; median of the turns",
        title_justify="left",
    )
    for heading in ("verification", "runs", "settled", "wall [s]", "processor [s]", "largest shift of I50"):
        table.add_column(heading, justify="right")
    for every_run, verdict in verdicts.items():
        wall, processor = (median(values) for values in zip(*spent[every_run], strict=True))
        name = "every run" if every_run else "as usual"
        shift = "" if every_run else f"{np.nanmax(shifts):.3f}"
        numbers = f"{verdict.runs:,}", f"{verdict.settled:,}", f"{wall:.1f}", f"{processor:.1f}"
        table.add_row(name, *numbers, shift)
    return table


PRESETS = ("bookcase", "empty bookcase", "cupboard", "chest", "refrigerator", "television", "server rack")
FLOORS = ("wood flooring", "vinyl", "carpet")
KINDS = ("mixed", "crustal", "subduction", "near-fault", "basin")
MEASURES = (
    {"type": "anti_slip_sheet"},
    {"type": "sliding_glides"},
    {"type": "free_casters"},
    {"type": "gel_mats"},
    {"type": "l_bracket"},
    {"type": "l_bracket_board"},
    {"type": "belt"},
    {"type": "chain"},
    {"type": "tension_pole"},
    {"type": "ballast"},
    {"type": "lower_shelves"},
    {"type": "away_from_wall"},
    {"type": "base_isolator"},
)
MOTIONS, SAMPLES = 8, 8


def drawn(seed: int, **further: Any) -> Scenario:
    """Draw a scenario of any kind: half of them in a building, half with measures of drawn strength."""
    rng = np.random.default_rng(seed)

    def between(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    furniture: dict[str, Any] = {"preset": str(rng.choice(PRESETS))}
    if rng.random() < 0.3:
        furniture = {"width": between(0.15, 0.8), "height": between(0.5, 2.2), "mass": between(10.0, 400.0)}
        furniture["length"] = between(0.2, 1.2)
    friction = between(0.15, 1.2)
    room: dict[str, Any] = {
        "floor": str(rng.choice(FLOORS))
        if rng.random() < 0.7
        else {"static_friction": friction, "kinetic_friction": 0.8 * friction}
    }
    if rng.random() < 0.8:
        room["left_wall"] = {"gap": float(rng.choice([0.0, 0.01, 0.02, 0.05, 0.1, 0.3]))}
    if rng.random() < 0.3:
        room["right_wall"] = {"gap": between(0.1, 1.0)}
    if rng.random() < 0.6:
        room["ceiling"] = {"height": 2.4}
    suite = {"family": str(rng.choice(KINDS)), "count": MOTIONS, "seed": int(rng.integers(1, 1000))}
    shaking: dict[str, Any] = {"intensity": 6.0, "suite": suite, "vertical": bool(rng.random() < 0.7)}
    if rng.random() < 0.5:
        storeys = int(rng.choice([2, 5, 10, 20]))
        shaking["building"] = {"storeys": storeys, "nonlinear": bool(rng.random() < 0.6)}
        shaking["storey"] = int(rng.integers(1, storeys + 2))
    tables: dict[str, Any] = {"furniture": furniture, "room": room, "shaking": shaking}
    if rng.random() < 0.5:
        chosen = [dict(MEASURES[n]) for n in rng.choice(len(MEASURES), 8, replace=False)]
        for table in chosen:
            if table["type"] in ("l_bracket", "belt", "chain"):
                table["strength"] = between(100.0, 3000.0)
        tables["measures"] = chosen
    tables["uncertainty"] = {"samples": MOTIONS * SAMPLES, "seed": seed + 1}
    return Scenario.parse(tables | further)


@dataclass(slots=True)
class Count:
    """How often the rule is wrong.

    Parameters
    ----------
    runs, made : int
        All runs of the curves, and those that are made.
    falls, stands : int
        Settled runs that are told to stand but fall, and the other way round.
    shifts : list of ndarray, shape (2,)
        By how much the intensities at which 10 % and 50 % overturn move.
    """

    runs: int = 0
    made: int = 0
    falls: int = 0
    stands: int = 0
    shifts: list[NDArray[np.float64]] = field(default_factory=list[Any])

    def add(self, scenario: Scenario) -> None:
        """Make all runs of a scenario, and those that are needed."""
        (options, _), scaled_motions = compared_options(scenario), ScaledMotions.of(scenario)
        contest = Contest(scenario, SLIDE_LIMIT, None, scaled_motions=scaled_motions)
        stated = contest.run(options, contest.settings.samples)
        floors_at = cache(scaled_motions.at)
        (every, runs), (few, made) = (
            contest.falls(options, stated, LEVELS, floors_at, every_run=each) for each in (True, False)
        )
        self.runs, self.made = self.runs + runs, self.made + made
        strength = np.stack([floors_at(float(level)).measures[JMA_INTENSITY] for level in LEVELS])
        for true, told in zip(every, few, strict=True):
            self.falls += int((true.overturned & ~told.overturned & ~told.missing).sum())
            self.stands += int((told.overturned & ~true.overturned & ~true.missing).sum())
            curves = (
                fragility_curve(Trials.from_runs(JMA_INTENSITY, strength, each.overturned, each.missing))
                for each in (true, told)
            )
            first, second = (np.array([curve.capacity(p).estimate for p in CAPACITIES]) for curve in curves)
            self.shifts.append(second - first)

    def row(self) -> list[str]:
        """Return the numbers as they are shown."""
        shifts, settled = np.array(self.shifts), self.runs - self.made
        moved = np.abs(shifts[np.isfinite(shifts)])
        return [
            f"{self.runs:,}",
            f"{self.made / self.runs:.1%}",
            f"{self.falls / settled:.2%}",
            f"{self.stands / settled:.2%}",
            f"{np.nanmean(shifts):+.3f}",
            *(f"{np.quantile(moved, q):.2f}" for q in (0.5, 0.9, 0.99, 1.0)),
        ]


def rule(scenarios: int = 140, in_space: int = 8) -> Table:
    """Count how often the rule is wrong in either engine, and by how much the curves move."""
    table = Table()
    shifts = ("shift [JMA]", "median |shift|", "90 %", "99 %", "most")
    for heading in ("engine", "runs", "made", "told to stand, falls", "told to fall, stands", *shifts):
        table.add_column(heading, justify="right")
    for engine, seeds, options in (("plane", scenarios, {"dimensions": 2}), ("space", in_space, {})):
        count = Count()
        for seed in track(range(seeds), engine, console=Console(stderr=True)):
            try:
                count.add(drawn(seed, **options))
            except InputError:  # no measure can be put there, or the piece is higher than the room
                continue
        table.add_row(engine, *count.row())
    return table


if __name__ == "__main__":
    part, numbers = sys.argv[1], [int(number) for number in sys.argv[2:]]
    made = speed(*numbers) if part == "speed" else rule(*numbers)
    Console(width=120).print(made)
