"""What the benchmarks run: a motion, and columns of drawn cases."""

from __future__ import annotations

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

import stayput as sp
from stayput.execution import cores as cores
from stayput.mechanics.runner import run_cases, shaking
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.state import State

if TYPE_CHECKING:
    from numpy.typing import NDArray

RECORD = Path(__file__).parents[2] / "shared" / "motions" / "jma_kobe_1995_ns.AT2"
DURATION = 30.0  # s
EXACT = {"tolerance": 1e-13, "max_step": 1.25e-3}
"""Settings of the converged reference [rad, s]."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """One drawn case; ``gap`` is None where there is no wall."""

    width: float
    height: float
    static: float
    kinetic: float
    gap: float | None
    scale: float

    def columns(self) -> NDArray[np.void]:
        """Return its row of the kernel's table."""
        wall = None if self.gap is None else sp.Wall(self.gap, restitution=0.3, friction=0.3)
        room = sp.Room(sp.Floor(self.static, self.kinetic), right_wall=wall)
        row = case_columns(sp.Body(self.width, self.height, 100.0), room, State(), STANDARD_GRAVITY)
        row["scale"] = self.scale
        return row


def record() -> sp.Motion:
    """Return 30 s of JMA Kobe NS where the file is at hand, else the built-in synthetic motion."""
    motion = sp.read_motion(RECORD) if RECORD.is_file() else sp.near_fault().component("x")
    return motion.trimmed(0.0, min(DURATION, motion.duration))


def mixed(count: int, seed: int = 1) -> list[Drawn]:
    """Draw furniture of all kinds: kinetic friction 0.75 μ, half of it beside a wall."""
    rng = np.random.default_rng(seed)
    low, high = (0.2, 0.6, 0.2, 0.0, 0.3, 0.0), (0.6, 2.0, 0.9, 0.3, 1.5, 1.0)
    drawn: list[Drawn] = []
    for _ in range(count):
        b, h, mu, gap, scale, free = rng.uniform(low, high)
        drawn.append(Drawn(b, h, mu, 0.75 * mu, None if free < 0.5 else gap, scale))
    return drawn


def tall(count: int, seed: int = 2) -> list[Drawn]:
    """Draw tall blocks that stick, rock for long and rarely fall."""
    rng = np.random.default_rng(seed)
    low, high = (0.4, 1.6, 0.4), (0.6, 2.4, 0.7)
    return [Drawn(b, h, 0.9, 0.9, None, scale) for b, h, scale in rng.uniform(low, high, (count, 3))]


def one_friction(cases: list[Drawn]) -> list[Drawn]:
    """Return the same cases with kinetic friction for both coefficients, which is all that MuJoCo has."""
    return [Drawn(c.width, c.height, c.kinetic, c.kinetic, c.gap, c.scale) for c in cases]


def columns(cases: list[Drawn]) -> NDArray[np.void]:
    """Return the kernel's table of the cases."""
    return np.concatenate([case.columns() for case in cases])


@dataclass(frozen=True, slots=True)
class Timed:
    """Results of a batch, and the wall time and threads that it took."""

    results: NDArray[np.void]
    seconds: float
    threads: int

    @property
    def rate(self) -> float:
        """Cases per second and core."""
        return len(self.results) / self.seconds / self.threads

    @property
    def step_time(self) -> float:
        """Time per integration step, events and all else included [ns]."""
        return 1e9 * self.seconds * self.threads / float(self.results["steps"].sum())


def timed(
    table: NDArray[np.void], motion: sp.Motion, *, threads: int = 1, repeats: int = 3, **settings: float
) -> Timed:
    """Run a table through the kernel, in slices where there are several threads; the best of the repeats."""
    floor = shaking(motion.x, None, motion.dt, 0)

    def run(part: NDArray[np.void]) -> NDArray[np.void]:
        return run_cases(part, floor, **settings)

    run(table[:1])
    parts = np.array_split(table, 16 * threads if threads > 1 else 1)
    best, results = np.inf, table[:0]
    with ThreadPoolExecutor(threads) as pool:
        for _ in range(repeats):
            start = time.perf_counter()
            results = np.concatenate(list(pool.map(run, parts)))
            best = min(best, time.perf_counter() - start)
    return Timed(results, best, threads)
