"""Verifications: what the race of the options takes beside all runs, and how wide the intervals of both are.

``python benchmarks/verification.py [MOTIONS SAMPLES TURNS]``: a bookcase in the plane and in space with the
usual measures; 40 motions, 40 samples where all are run, and 1 turn where nothing is said.
"""

from __future__ import annotations

import sys
import time
from statistics import median
from typing import Any

from rich.console import Console
from rich.table import Table

import workload as work
from stayput.scenario import Scenario
from stayput.verification import Verdict, verify

BOOKCASE: dict[str, Any] = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
}


def bookcase(dimensions: int, motions: int, samples: int | None) -> Scenario:
    """A full bookcase on the ground with all usual measures: nine options."""
    shaking = {"intensity": "6-upper", "suite": {"count": motions}}
    asked = {} if samples is None else {"samples": samples}
    return Scenario.parse({**BOOKCASE, "shaking": shaking, "dimensions": dimensions, "uncertainty": asked})


def half_widths(verdict: Verdict) -> str:
    """Return how wide the intervals of overturning are: without anything, of the best, and the widest."""
    each = [option.probabilities["overturned"].half_width for option in verdict]
    return " ".join(
        f"{width:.2f}" for width in (each[verdict.options.index(verdict.without)], each[0], max(each))
    )


def speed(motions: int = 40, samples: int = 40, turns: int = 1) -> Table:
    """Time the race, and all runs, in turns."""
    table = Table(
        title=f"{motions} motions, {work.cores()} cores; medians of {turns} turns", title_justify="left"
    )
    for heading in (
        "engine",
        "runs",
        "of each",
        "wall [s]",
        "processor [s]",
        "half-widths: none, best, widest",
    ):
        table.add_column(heading, justify="right")
    asked = {"race": None, "all": samples}
    for dimensions, engine in ((2, "plane"), (3, "space")):
        scenarios = {name: bookcase(dimensions, motions, most) for name, most in asked.items()}
        verify(bookcase(dimensions, motions, 1), levels=[], progress=False)  # compiles, and makes the motions
        verdicts, spent = dict[str, Verdict](), dict[str, list[tuple[float, float]]]()
        for _ in range(turns):
            for name, scenario in scenarios.items():
                began = time.process_time()
                verdicts[name] = verdict = verify(scenario, progress=False)
                spent.setdefault(name, []).append((verdict.seconds, time.process_time() - began))
        for name, verdict in verdicts.items():
            times = (f"{median(column):.1f}" for column in zip(*spent[name], strict=True))
            runs = f"{verdict.runs:,}", verdict.runs_each[0]
            table.add_row(f"{engine}, {name}", *runs, *times, half_widths(verdict))
    return table


if __name__ == "__main__":
    Console(width=120).print(speed(*map(int, sys.argv[1:])))
