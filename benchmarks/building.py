"""Floors of a 50-storey building under 1,000 motions: rate, memory and equal bits, and what yielding costs.

Every row is one call over all cores (and once on one thread), the motions made as they are asked for:
30 s at 0.01 s, one horizontal component. One wanted storey comes out as `Motion`s that are thrown away; of
all storeys the peaks are kept.
"""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console
from rich.table import Table

import stayput as sp
import workload as work
from ensemble import peak_memory
from stayput.building.building import Building

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

STOREY = 40
YIELDING_SHARE = 10
"""Yielding storeys are followed under one motion in as many."""


def motions(count: int) -> Iterator[sp.Motion]:
    """Make scaled versions of the built-in record's x, one after the other."""
    base = sp.near_fault().component("x")
    for factor in np.geomspace(0.2, 1.5, count):
        yield base.scaled(float(factor))


def one_storey(building: Building, count: int, threads: int) -> int:
    """Return a number that differs if any bit of a floor motion does."""
    found = building.floor_motions(motions(count), [STOREY], threads=threads)
    return hash(tuple(hash(floor) for (floor,) in found))


def all_storeys(building: Building, count: int, threads: int) -> int:
    """Return a number that differs if any bit of a peak does."""
    peaks = building.floor_peaks(motions(count), threads=threads)
    return hash(peaks.acceleration.tobytes() + peaks.velocity.tobytes())


def run(count: int) -> Table:
    """Run everything; return the table."""
    linear, yielding = Building(storeys=50, nonlinear=False), Building(storeys=50)
    few = max(1, count // YIELDING_SHARE)
    title = "Floors of a 50-storey building"
    table = Table(title=title, title_justify="left")
    heads = ("wanted", "motions", "threads", "seconds", "motions/s", "peak memory [MiB]", "same bits")
    for heading in heads:
        table.add_column(heading, justify="right")
    rows: list[tuple[str, Callable[[Building, int, int], int], Building, int]] = [
        (f"storey {STOREY}, histories", one_storey, linear, count),
        ("all storeys, peaks", all_storeys, linear, count),
        ("all storeys, peaks, yielding", all_storeys, yielding, few),
    ]
    for name, work_of, building, asked in rows:
        work_of(building, 2, 1)  # compiled
        truth = 0
        for threads in sorted({1, work.cores()}):
            start = time.perf_counter()
            bits = work_of(building, asked, threads)
            seconds = time.perf_counter() - start
            truth = truth or bits
            table.add_row(
                name,
                f"{asked:,}",
                str(threads),
                f"{seconds:.2f}",
                f"{asked / seconds:,.0f}",
                f"{peak_memory():,.0f}",
                "yes" if bits == truth else "NO",
            )
    return table


if __name__ == "__main__":
    Console(width=110).print(run(int(float(sys.argv[1])) if len(sys.argv) > 1 else 1000))
