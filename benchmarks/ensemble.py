"""The ensemble: scaling over threads, cost per case over the number of cases, memory, and equal bits.

Run by `make bench` after the kernel's table. Every row is one call of `simulate_many` on mixed cases.
"""

from __future__ import annotations

import resource
import sys
import time
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.console import Console
from rich.table import Table

import stayput as sp
import workload as work

if TYPE_CHECKING:
    from numpy.typing import NDArray


def columns(count: int, seed: int = 1) -> dict[str, NDArray[np.float64]]:
    """Draw mixed cases as `workload.mixed` does, by the column; a wall 1 km away is none."""
    rng = np.random.default_rng(seed)
    friction = rng.uniform(0.2, 0.9, count)
    return {
        "body.width": rng.uniform(0.2, 0.6, count),
        "body.height": rng.uniform(0.6, 2.0, count),
        "room.floor.static_friction": friction,
        "room.floor.kinetic_friction": 0.75 * friction,
        "room.right_wall.gap": np.where(rng.random(count) < 0.5, 1e3, rng.uniform(0.0, 0.3, count)),
        "motion.scale": rng.uniform(0.3, 1.5, count),
    }


def peak_memory() -> float:
    """Return the largest resident size of this process so far [MiB]."""
    size = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return size / (2**20 if sys.platform == "darwin" else 2**10)


def timed(case: sp.Case, asked: dict[str, Any], threads: int, repeats: int) -> tuple[float, dict[str, Any]]:
    """Return the best wall time of the repeats [s], and the results."""
    best, results = np.inf, {}
    for _ in range(repeats):
        start = time.perf_counter()
        results = sp.simulate_many(case, asked, threads=threads)
        best = min(best, time.perf_counter() - start)
    return best, results


def digest(results: dict[str, Any]) -> int:
    """Return a number that differs if any bit does."""
    return hash(tuple(values.tobytes() for values in results.values()))


def run(most: int) -> Table:
    """Run everything up to ``most`` cases; return the table."""
    motion = work.record()
    case = sp.Case(sp.Body(1.0, 1.0, 100.0), sp.Room(right_wall=sp.Wall(1e3, 0.3, 0.3)), motion)
    table = Table(title="simulate_many, mixed cases", title_justify="left")
    for heading in (
        "cases",
        "threads",
        "cases/s",
        "cases/s/core",
        "scaling",
        "peak memory [MiB]",
        "beyond the columns",
        "same bits",
    ):
        table.add_column(heading, justify="right")
    timed(case, columns(1000), 1, 1)
    count = 1000
    while count <= most:
        asked = columns(count)
        alone, truth = 0.0, 0
        for threads in sorted({1, 2, work.cores()}) if count <= 100_000 else (work.cores(),):
            seconds, results = timed(case, asked, threads, 3 if count <= 100_000 else 1)
            rate, peak = count / seconds, peak_memory()
            columns_size = sum(values.nbytes for values in (*asked.values(), *results.values())) / 2**20
            if threads == 1:
                alone, truth = rate, digest(results)
            table.add_row(
                f"{count:,}",
                str(threads),
                f"{rate:,.0f}",
                f"{rate / threads:,.0f}",
                f"{rate / threads / alone:.0%}" if alone else "",
                f"{peak:,.0f}",
                f"{peak - columns_size:,.0f}",
                ("yes" if digest(results) == truth else "NO") if alone else "",
            )
        count *= 10
    return table


if __name__ == "__main__":
    Console(width=120).print(run(int(float(sys.argv[1])) if len(sys.argv) > 1 else 1_000_000))
