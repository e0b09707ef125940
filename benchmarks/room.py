"""A room's verdict and the ranking of its changes, and what runs of its pieces take, free and held.

``python benchmarks/room.py [TURNS]``: the example bedroom, on one thread and on two, in turns; 3 by default.
Then each change by a measure: what a run takes and its ratio to one of the piece that stands free, and how
many runs overturn at the usual step and at half of it.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

import stayput as sp
from stayput.measures import MEASURES
from stayput.mechanics.columns import OVERTURNED_OUTCOME
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.montecarlo.scene_draws import drawn_shaking
from stayput.montecarlo.scenes import trace_draw
from stayput.scenario import read
from stayput.simulation.space import results_of
from stayput.simulation.space_engine import STEP
from stayput.verification.changes import Change, refuse_unheld, with_changes
from stayput.verification.contest import Contest
from stayput.verification.options import TRIED_ALONE

if TYPE_CHECKING:
    from stayput.scenario.measures import Option
    from stayput.verification import Verdict

BEDROOM = Path(__file__).parents[1] / "examples" / "bedroom.toml"


def ranked(turns: int) -> Table:
    """Time the first verdict and the whole ranking, in turns of one thread and of two."""
    room = read(BEDROOM)
    sp.verify(room, progress=False)  # compiles, and makes the motions
    spent: dict[int, list[tuple[float, ...]]] = {1: [], 2: []}
    changes = 0
    for _ in range(turns):
        for threads, rows in spent.items():
            times: list[tuple[float, float]] = []

            def note(_: Verdict, times: list[tuple[float, float]] = times) -> None:
                times.append((time.perf_counter(), time.process_time()))

            began = time.perf_counter(), time.process_time()
            verdict = sp.verify(room, threads=threads, progress=False, on_verdict=note)
            changes = len(verdict.others)
            rows.append(
                tuple(
                    end - start
                    for one in (times[0], times[-1])
                    for start, end in zip(began, one, strict=True)
                )
            )
    table = Table(title=f"bedroom, {changes} changes; medians of {turns} turns", title_justify="left")
    for heading in ("threads", "first verdict [s]", "processor [s]", "ranking [s]", "processor [s]"):
        table.add_column(heading, justify="right")
    for threads, rows in spent.items():
        table.add_row(str(threads), *(f"{median(column):.1f}" for column in zip(*rows, strict=True)))
    return table


def overturned(contest: Contest, option: Option, body: int, step: float) -> list[bool]:
    """Return whether a piece overturns with an option, by motion and sample, at a longest step [s]."""
    scene, found = contest.scene(option).part((body,)), list[bool]()
    floors, gravity = contest.floors, contest.settings.gravity
    for motion in range(len(floors.motions)):
        for sample in range(contest.settings.samples):
            draw = contest.runner.draw(motion, sample)
            shaking = drawn_shaking(floors.motions[motion], float(floors.scales[motion]), draw, gravity)
            traced = trace_draw(scene, draw.of((body,)), shaking, gravity, step=step)
            outcome = results_of(traced, shaking.times)["outcome"]
            found.append(bool((outcome == OVERTURNED_OUTCOME).any()))
    return found


def held() -> Table:
    """Time runs of pieces held to a wall beside those of the same pieces free, and halve their steps."""
    room = read(BEDROOM)
    contest = Contest(room, SLIDE_LIMIT, 1)
    table = Table(title=f"one thread, step {1e3 * STEP:g} ms", title_justify="left")
    for heading in ("piece", "measure", "ms a run", "to free", "overturned", "half step", "differ"):
        table.add_column(heading, justify="right")
    for body, name in enumerate(room.names):
        spent: list[float] = []
        for kind in ("", *TRIED_ALONE):
            changes = [Change(name, MEASURES[kind]())] if kind else []
            option = with_changes(room.stated, changes, room.names)
            if kind:
                try:
                    refuse_unheld(contest.scene(option), body)
                except sp.InputError:
                    continue
            began = time.process_time()
            usual = overturned(contest, option, body, STEP)
            spent.append(time.process_time() - began)
            half = overturned(contest, option, body, STEP / 2)
            table.add_row(
                name,
                kind or "none",
                f"{1e3 * spent[-1] / len(usual):.0f}",
                f"{spent[-1] / spent[0]:.1f}",
                f"{sum(usual)} of {len(usual)}",
                str(sum(half)),
                str(sum(a != b for a, b in zip(usual, half, strict=True))),
            )
    return table


if __name__ == "__main__":
    console = Console(width=110)
    console.print(ranked(int(sys.argv[1]) if len(sys.argv) > 1 else 3))
    console.print(held())
