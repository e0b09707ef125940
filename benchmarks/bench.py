"""Speed and accuracy of stayput's kernel beside MuJoCo's rollout, in one run: `make bench`.

Both answer the same question (the planar block, Coulomb friction, a wall) under the same 30 s of shaking.
Compare the ratios; the figures themselves are the machine's. Each error is taken against stayput converged
(tolerance 1e-13 rad, steps of at most 1.25 ms) on the same cases.
"""

from __future__ import annotations

import argparse
import math
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console
from rich.table import Table

import mujoco_block as mb
import workload as work
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.report.figures import FONT, new_figure, saved, style

if TYPE_CHECKING:
    from numpy.typing import NDArray

    import stayput as sp

OVERTURNED, FAILED = 4, 5  # places in stayput.Outcome
NOTES = (
    "Mixed: b 0.2-0.6 m, h 0.6-2.0 m, μ 0.2-0.9, μ' = 0.75 μ, half of them beside a wall at 0-0.3 m with "
    "e_w = 0.3, record × 0.3-1.5. Tall: b 0.4-0.6 m, h 1.6-2.4 m, μ = 0.9, record × 0.4-0.7. "
    "Flips: overturned in one, standing in the other. MuJoCo has one friction coefficient: it gets μ' for "
    "both, and so does the reference it is held against. It cannot stop at an overturning; stayput does."
)


@dataclass(frozen=True, slots=True)
class Line:
    """A row of the table."""

    name: str
    cases: int
    rate: float
    step_time: float
    errors: tuple[float, float, float]
    flips: int
    failed: int


def errors(
    tilt: NDArray[np.float64], fell: NDArray[np.bool_], exact: NDArray[np.void]
) -> tuple[tuple[float, float, float], int]:
    """Return the median, 99 % and largest error of the peak tilt where both stand [rad], and the flips."""
    truth = exact["outcome"] == OVERTURNED
    stands = ~truth & ~fell & (exact["outcome"] != FAILED)
    off = np.abs(tilt - exact["peak_tilt"])[stands]
    half, most, worst = np.quantile(off, (0.5, 0.99, 1.0))
    return (float(half), float(most), float(worst)), int((fell != truth).sum())


def ours(name: str, cases: list[work.Drawn], motion: sp.Motion, threads: int, **settings: float) -> Line:
    """Time the kernel on the cases, and compare it with itself converged."""
    table = work.columns(cases)
    run = work.timed(table, motion, threads=threads, **settings)
    exact = work.timed(table, motion, threads=work.cores(), repeats=1, **work.EXACT).results
    fell = run.results["outcome"] == OVERTURNED
    off, flips = errors(run.results["peak_tilt"], fell, exact)
    failed = int((run.results["outcome"] == FAILED).sum())
    return Line(name, len(cases), run.rate, run.step_time, off, flips, failed)


def theirs(name: str, cases: list[work.Drawn], motion: sp.Motion, threads: int, step: float) -> Line:
    """Time MuJoCo's rollout on the cases (models made beforehand), and compare it with stayput converged."""
    exact = work.timed(work.columns(cases), motion, threads=work.cores(), repeats=1, **work.EXACT).results
    blocks = [
        mb.Block(c.width, c.height, friction=c.static, right_gap=math.inf if c.gap is None else c.gap)
        for c in cases
    ]
    models = [block.model(step, STANDARD_GRAVITY) for block in blocks]
    states = np.array([block.state() for block in blocks])
    middles = mb.middles(motion.duration, step)
    scales = np.array([case.scale for case in cases])
    applied = mb.forces(blocks, middles, motion.dt, motion.x, None, scales)
    start = time.perf_counter()
    found = mb.run(models, states, applied, threads=threads)
    seconds = time.perf_counter() - start
    off, flips = errors(found.peak_tilt, found.overturned, exact)
    per_step = 1e9 * seconds * threads / (len(cases) * len(middles))
    return Line(name, len(cases), len(cases) / seconds / threads, per_step, off, flips, 0)


def standing(cases: list[work.Drawn], motion: sp.Motion) -> list[work.Drawn]:
    """Return the cases that do not overturn: a rollout cannot stop early, stayput does."""
    found = work.timed(work.columns(cases), motion, threads=work.cores(), repeats=1).results
    return [case for case, row in zip(cases, found, strict=True) if row["outcome"] != OVERTURNED]


def table_of(lines: list[Line], motion: sp.Motion, peer: Line) -> Table:
    """Lay the lines out; the ratio is to MuJoCo at 1 ms on one core."""
    head = f"{motion.name}, {motion.duration:g} s; errors of the peak tilt where both stand, in rad"
    table = Table(title=head, title_justify="left")
    table.add_column("")
    for heading in ("cases", "cases/s/core", "ratio", "ns/step", "50 %", "99 %", "100 %", "flips", "failed"):
        table.add_column(heading, justify="right")
    for line in lines:
        table.add_row(
            line.name,
            f"{line.cases:,}",
            f"{line.rate:,.1f}" if line.rate < 1e3 else f"{line.rate:,.0f}",
            f"{line.rate / peer.rate:,.1f}",
            f"{line.step_time:,.0f}",
            *(f"{value:.1e}" for value in line.errors),
            str(line.flips),
            str(line.failed),
        )
    return table


def plot(lines: list[Line], path: str) -> None:
    """Plot speed over error: right and up is better."""
    figure = new_figure(8.0, 5.0)
    axis = figure.subplots()
    style(axis, zero=False)
    shown = [line for line in lines if "threads" not in line.name and line.errors[1] > 0.0]
    for line, marker in zip(shown, "os^Dv<>pPX*", strict=False):
        axis.loglog(line.errors[1], line.rate, marker, markersize=9, label=line.name)
    axis.invert_xaxis()
    axis.set_xlabel("99 % error of the peak tilt [rad], smaller to the right", fontsize=FONT)
    axis.set_ylabel("cases a second, one thread", fontsize=FONT)
    axis.legend(fontsize=FONT - 2.0, loc="center")
    saved(figure, path)


def main() -> None:
    """Run everything and print one table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=10_000, help="mixed cases for stayput")
    parser.add_argument("--peer-cases", type=int, default=64, help="mixed cases for MuJoCo")
    parser.add_argument("--plot", help="where to save the plot of work and precision")
    wanted = parser.parse_args()
    motion, threads = work.record(), work.cores()
    drawn, long_rocking = work.mixed(wanted.cases), work.tall(max(1, wanted.cases // 10))
    peers = work.one_friction(work.mixed(wanted.peer_cases, seed=3))
    peer = theirs("MuJoCo 1 ms, μ' = μ", peers, motion, 1, 1e-3)
    lines = [
        ours("stayput, mixed", drawn, motion, 1),
        ours(f"stayput, mixed, {threads} threads", drawn, motion, threads),
        ours("stayput, mixed, that stand", standing(drawn, motion), motion, 1),
        ours("stayput, tall blocks that rock long", long_rocking, motion, 1),
        ours("stayput, mixed, tolerance 1e-6 rad", drawn, motion, 1, tolerance=1e-6),
        ours("stayput, mixed, tolerance 1e-12 rad", drawn, motion, 1, tolerance=1e-12),
        ours("stayput, the cases of the rows below", peers, motion, 1),
        peer,
        theirs(f"MuJoCo 1 ms, μ' = μ, {threads} threads", peers, motion, threads, 1e-3),
        theirs("MuJoCo 0.25 ms, μ' = μ", peers[: max(1, len(peers) // 4)], motion, threads, 2.5e-4),
    ]
    console = Console(width=max(132, Console().width))
    console.print(table_of(lines, motion, peer))
    console.print(NOTES, highlight=False)
    if wanted.plot is not None:
        plot(lines, wanted.plot)
        console.print(f"Wrote {wanted.plot}")


if __name__ == "__main__":
    main()
