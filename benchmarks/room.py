"""A room's verdict and the ranking of its changes, and pieces held to a wall in space beside the plane.

``python benchmarks/room.py [TURNS]``: the example bedroom, on one thread and on two, in turns; 3 by default.
Then each change by a measure: what a run takes and its ratio to one of a piece that stands free in
the plane, and how many runs overturn at the usual step and at half of it.
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
from stayput.mechanics.columns import OVERTURNED_OUTCOME
from stayput.montecarlo.several import trace_draw, turned
from stayput.rooms.changes import measures_tried
from stayput.rooms.runs import RoomPart
from stayput.rooms.verify import question_of
from stayput.scenario import read_scenario
from stayput.simulation.space import results_of
from stayput.simulation.space_engine import STEP

if TYPE_CHECKING:
    from stayput.rooms.runs import Question
    from stayput.rooms.verdict import RoomVerdict

BEDROOM = Path(__file__).parents[1] / "examples" / "bedroom.toml"


def ranked(turns: int) -> Table:
    """Time the first verdict and the whole ranking, in turns of one thread and of two."""
    room = read_scenario(BEDROOM)
    sp.verify_room(room, progress=False)  # compiles, and makes the motions
    spent: dict[int, list[tuple[float, ...]]] = {1: [], 2: []}
    changes = 0
    for _ in range(turns):
        for threads, rows in spent.items():
            times: list[tuple[float, float]] = []

            def note(_: RoomVerdict, times: list[tuple[float, float]] = times) -> None:
                times.append((time.perf_counter(), time.process_time()))

            began = time.perf_counter(), time.process_time()
            verdict = sp.verify_room(room, threads=threads, progress=False, on_verdict=note)
            changes = len(verdict.changes)
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


def overturned(question: Question, part: RoomPart, step: float) -> list[bool]:
    """Return whether the piece of a part overturns in space, by motion and sample, at a longest step [s]."""
    found: list[bool] = []
    for motion, row in enumerate(question.drawn):
        for draw in row:
            floors = question.floors
            shaking = turned(floors.motions[motion], float(floors.scales[motion]), draw.direction)
            own, gravity = draw.of(part.bodies), question.scenario.gravity
            traced = trace_draw(part.scene, own, shaking, gravity, step)
            outcome = results_of(traced, shaking.times)["outcome"]
            found.append(bool((outcome == OVERTURNED_OUTCOME).any()))
    return found


def held() -> Table:
    """Time runs of pieces held to a wall beside those of the same pieces free, and halve their steps."""
    question = question_of(read_scenario(BEDROOM), 1)
    table = Table(title=f"held in space, one thread, step {1e3 * STEP:g} ms", title_justify="left")
    for heading in ("piece", "measure", "ms a run", "to the plane", "overturned", "half step", "differ"):
        table.add_column(heading, justify="right")
    for body, name in enumerate(question.scenario.names):
        began = time.process_time()
        question.run([RoomPart.of(question.whole, (body,))])
        plane = time.process_time() - began
        for change, part in measures_tried(question.scenario, question.whole, body):
            if part.in_plane or change.measure is None:
                continue
            began = time.process_time()
            question.run([part])
            spent = time.process_time() - began
            usual, half = (overturned(question, part, step) for step in (STEP, STEP / 2))
            table.add_row(
                name,
                type(change.measure).__name__,
                f"{1e3 * spent / len(usual):.0f}",
                f"{spent / plane:.0f}",
                f"{sum(usual)} of {len(usual)}",
                str(sum(half)),
                str(sum(a != b for a, b in zip(usual, half, strict=True))),
            )
    return table


if __name__ == "__main__":
    console = Console(width=110)
    console.print(ranked(int(sys.argv[1]) if len(sys.argv) > 1 else 3))
    console.print(held())
