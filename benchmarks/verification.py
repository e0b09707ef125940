"""Verifications: what it saves not to run what stronger shaking tells, and how often such rules are wrong.

``python benchmarks/verification.py speed [MOTIONS SAMPLES TURNS]``: all runs, and those that are needed, in
turns, of a bookcase with the usual measures; 40 motions, 640 samples and 3 turns where nothing is said.
``python benchmarks/verification.py rule [SCENARIOS]``: full grids of drawn scenarios, 140 where nothing is
said; of the runs that a rule settles, those that fall all the same, by the tilt and slide of a calm run.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

import workload as work
from stayput.errors import InputError
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.runs import CALM_SLIDE, CALM_TILT, GROUP, group_starts, overturning_tilts, run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.report.verdict.data import verdict_data
from stayput.scenario import Scenario
from stayput.verification import LEVELS, verify
from stayput.verification.options import compared_options

if TYPE_CHECKING:
    from collections.abc import Iterator

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


def told(verdict: Verdict) -> dict[str, Any]:
    """All that a verdict says, but how it was come by."""
    data = verdict_data(verdict)
    return {name: data[name] for name in data.keys() - {"runs", "settled_runs", "seconds"}}


def speed(motions: int = 40, samples: int = 640, turns: int = 3) -> Table:
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
    same = "yes" if told(verdicts[True]) == told(verdicts[False]) else "NO"
    table = Table(
        title=f"{motions} motions, {samples} samples, {work.cores()} cores; median of the turns",
        title_justify="left",
    )
    for heading in ("verification", "runs", "settled", "wall [s]", "processor [s]", "same verdict"):
        table.add_column(heading, justify="right")
    for every_run, verdict in verdicts.items():
        wall, processor = (median(values) for values in zip(*spent[every_run], strict=True))
        name = "every run" if every_run else "as usual"
        table.add_row(
            name, f"{verdict.runs:,}", f"{verdict.settled:,}", f"{wall:.1f}", f"{processor:.1f}", same
        )
    return table


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """Every run of a scenario, shape [options, levels, motions, samples] each.

    Parameters
    ----------
    fell : ndarray of bool
        Whether it overturned or was given up.
    tilt, slide : ndarray
        Peak tilt over the overturning one; peak slide over the width of the base.
    """

    fell: NDArray[np.bool_]
    tilt: NDArray[np.float64]
    slide: NDArray[np.float64]


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


def drawn(seed: int) -> Scenario:
    """Draw a scenario of any kind: half of them in a building, half with measures of drawn strength."""
    rng = np.random.default_rng(seed)

    def between(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    furniture: dict[str, Any] = {"preset": str(rng.choice(PRESETS))}
    if rng.random() < 0.3:
        furniture = {"width": between(0.15, 0.8), "height": between(0.5, 2.2), "mass": between(10.0, 400.0)}
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
    return Scenario.parse(tables)


def grid(scenario: Scenario) -> Grid:
    """Run all options of a scenario at all levels."""
    (options, _), shaking = compared_options(scenario), scenario.shaking
    ground = shaking.ground(scenario.folder)
    hazard = Hazard.of(scenario, ground=ground)
    draw = draws(len(ground), SAMPLES, scenario.uncertainty.seed)
    body, room = scenario.piece.body(), scenario.room.room()
    rows = [rows_of(body, room, option.measures, draw, scenario.gravity) for option in options]
    by_level = [run_level(rows, hazard.at(float(level))) for level in LEVELS]

    def column(name: str) -> NDArray[Any]:
        return np.stack([[getattr(runs, name) for runs in level] for level in by_level], axis=1)

    cases = np.stack([option.cases for option in rows])
    shape = (len(rows), 1, len(ground), SAMPLES)
    overturning = np.stack([overturning_tilts(option) for option in cases]).reshape(shape)
    width = (cases["u"][..., 1] - cases["u"][..., 0]).reshape(shape)
    return Grid(
        column("overturned") | column("missing"),
        column("tilt") / overturning,
        column("slide") / width,
    )


def settled(runs: Grid, tilt: float, slide: float, group: int, successive: int) -> NDArray[np.bool_]:
    """Which runs a rule settles: those below as many successive levels at which all of a group are calm."""
    calm = ~runs.fell & (runs.tilt < tilt) & (runs.slide < slide)
    if group > 1:
        starts, motions = group_starts(*calm.shape[2:]), calm.shape[2]
        together = np.logical_and.reduceat(calm.all(axis=3), starts, axis=2)
        calm[:] = np.repeat(together, np.diff(starts, append=motions), axis=2)[..., np.newaxis]
    decided = np.zeros_like(calm)
    for level in reversed(range(calm.shape[1] - successive)):
        enough = calm[:, level + 1 : level + 1 + successive].all(axis=1)
        decided[:, level] = decided[:, level + 1] | enough
    return decided


def split(runs: Grid, samples: int) -> Iterator[Grid]:
    """Split a grid into grids with so many samples of each motion."""
    for first in range(0, SAMPLES, samples):
        chosen = np.s_[..., first : first + samples]
        yield Grid(*(getattr(runs, name)[chosen] for name in Grid.__slots__))


RULES = {
    "one run, one level": (SAMPLES, 1, 1),
    "one run, two levels": (SAMPLES, 1, 2),
    f"{GROUP} runs of one motion, one level": (SAMPLES, GROUP, 1),
    f"{GROUP} runs of one motion, two levels": (SAMPLES, GROUP, 2),
    f"{GROUP} runs of two motions, two levels": (SAMPLES // 2, GROUP, 2),
    f"{GROUP} runs of four motions, two levels": (SAMPLES // 4, GROUP, 2),
}
"""Samples of each motion in the grid, runs in a group, levels at which they are calm."""

MARGINS = [(tilt, CALM_SLIDE) for tilt in (0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0)] + [
    (CALM_TILT, slide) for slide in (0.5, 1.0, np.inf)
]
"""Largest tilt and slide of a calm run."""


def rule(scenarios: int = 140) -> Table:
    """Count, for rules of several margins, the runs that fall though they were settled."""
    wrong = {name: np.zeros(len(MARGINS), np.int64) for name in RULES}
    decided_runs = dict.fromkeys(RULES, 0)
    runs = above = stand = 0
    for seed in track(range(scenarios), "Full grids", console=Console(stderr=True)):
        try:
            full = grid(drawn(seed))
        except InputError:  # no measure can be put there, or the piece is higher than the room
            continue
        runs += full.fell.size
        fell_below = np.logical_or.accumulate(full.fell, axis=1)[:, :-1]
        above += int(fell_below.sum())
        stand += int((fell_below & ~full.fell[:, 1:]).sum())
        for name, (samples, group, successive) in RULES.items():
            for part in split(full, samples):
                for n, (tilt, slide) in enumerate(MARGINS):
                    decided = settled(part, tilt, slide, group, successive)
                    wrong[name][n] += (decided & part.fell).sum()
                    if (tilt, slide) == (CALM_TILT, CALM_SLIDE):
                        decided_runs[name] += int(decided.sum())
    title = f"{runs:,} runs; of {above:,} at levels above one at which they fall, {stand:,} stand"
    table = Table(title=title, title_justify="left")
    table.add_column("calm")
    table.add_column("settled", justify="right")
    for tilt, slide in MARGINS:
        table.add_column(f"{tilt:g}" + ("" if slide == CALM_SLIDE else f", {slide:g}"), justify="right")
    for name, counts in wrong.items():
        table.add_row(name, f"{decided_runs[name]:,}", *(f"{count:,}" for count in counts))
    return table


if __name__ == "__main__":
    part, numbers = sys.argv[1], [int(number) for number in sys.argv[2:]]
    made = speed(*numbers) if part == "speed" else rule(*numbers)
    Console(width=120).print(made)
