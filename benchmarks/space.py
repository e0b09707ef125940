"""The engine in space beside MuJoCo's rollout, a verification in space, and what compiling costs.

``python benchmarks/space.py [PART ...]``, the parts being `boxes`, `verification` and `start`; all where none
is said. Each is in one process that does nothing else, but compare the ratios: the figures are the machine's.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from dataclasses import dataclass
from statistics import median
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from mujoco import rollout
from rich.console import Console
from rich.table import Table

import stayput as sp
import workload as work
from mujoco_block import middles
from start import program_seconds
from stayput.mechanics.columns import OVERTURNED_OUTCOME
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.simulation.space import ENDS, results_of, trace_together
from stayput.simulation.space_engine import SpaceShaking

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

STEP, EXACT = 1e-3, 2e-5
"""Step of both engines, and that of the converged reference [s]."""

ROCKS, FALLEN = 1e-3, np.deg2rad(80.0)
"""Peak tilts from which on a box rocks, and has fallen in MuJoCo [rad]."""

SOFTNESS = 4.0
"""Time constant of MuJoCo's contacts, in steps, as in `space_mujoco.py`; MuJoCo allows 2."""

_BOX = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{gravity}" cone="elliptic" impratio="10" integrator="implicitfast"/>
  <default><geom condim="3" friction="{friction} 0 0" solref="{soft} 1" solimp="0.99 0.999 0.0001"/></default>
  <worldbody>
    <geom type="plane" size="0 0 1"/>
    <body pos="0 0 {z}"><freejoint/><geom type="box" mass="1" size="{x} {y} {z}"/></body>
  </worldbody>
</mujoco>
"""


@dataclass(frozen=True, slots=True)
class FreeBox:
    """A box on a floor of one coefficient of friction, which is all that MuJoCo has; shaken times a scale."""

    width: float
    length: float
    height: float
    friction: float
    scale: float

    def scene(self) -> sp.Scene:
        """Return it by itself on its floor."""
        body = sp.Body(self.width, self.height, 1.0, length=self.length)
        return sp.Scene([sp.Piece(body)], sp.Room(sp.Floor(self.friction, self.friction)))

    def model(self, step: float) -> mujoco.MjModel:
        """Compile it for MuJoCo."""
        return mujoco.MjModel.from_xml_string(
            _BOX.format(
                step=step,
                gravity=STANDARD_GRAVITY,
                friction=self.friction,
                soft=SOFTNESS * step,
                x=self.width / 2,
                y=self.length / 2,
                z=self.height / 2,
            )
        )


KINDS = {
    "mixed": ((0.2, 0.2, 0.6, 0.2, 0.3), (0.6, 1.2, 2.0, 0.9, 1.5)),
    "tall": ((0.3, 0.3, 1.2, 0.4, 0.3), (0.6, 1.2, 2.0, 0.9, 0.9)),
}
"""Least and most width, length, height, friction and scale: as the planar benchmark's, and more that rock."""


def drawn(kind: str, count: int, seed: int = 1) -> list[FreeBox]:
    """Draw free boxes of a kind."""
    return [FreeBox(*row) for row in np.random.default_rng(seed).uniform(*KINDS[kind], (count, 5)).tolist()]


def shaken() -> sp.Motion:
    """Return 30 s of two horizontal components: the near-fault motion."""
    motion = sp.near_fault()
    two = sp.Motion(dt=motion.dt, x=motion.x, y=motion.y, name="near-fault, x and y")
    return two.trimmed(0.0, min(work.DURATION, two.duration))


@dataclass(frozen=True, slots=True)
class Tilts:
    """Peak tilts, those of boxes that fell as infinite [rad], and processor time of each case [s].

    A rollout has one time for all its cases.
    """

    peak: Array
    seconds: Array

    @property
    def fell(self) -> NDArray[np.bool_]:
        """Whether boxes overturned."""
        return np.isinf(self.peak)

    @property
    def rate(self) -> float:
        """Cases a second."""
        return 1.0 / float(self.seconds.mean())


def ours(boxes: list[FreeBox], motion: sp.Motion, step: float) -> Tilts:
    """Run the boxes here, on this thread; after the first step size solids are made, as MuJoCo's models."""
    shaking, scenes = SpaceShaking.of(motion), [box.scene() for box in boxes]
    trace_together(scenes[0], shaking, STANDARD_GRAVITY, step)
    peak, seconds = np.zeros(len(boxes)), np.zeros(len(boxes))
    for n, (box, scene) in enumerate(zip(boxes, scenes, strict=True)):
        start = time.process_time()
        scaled = SpaceShaking(box.scale * shaking.acceleration, shaking.dt)
        traced = trace_together(scene, scaled, STANDARD_GRAVITY, step, stop_after_rest=ENDS)
        result = results_of(traced, shaking.dt)[0]
        seconds[n] = time.process_time() - start
        peak[n] = np.inf if result["outcome"] == OVERTURNED_OUTCOME else result["peak_tilt"]
    return Tilts(peak, seconds)


def theirs(boxes: list[FreeBox], motion: sp.Motion, step: float) -> Tilts:
    """Roll the boxes out in MuJoCo, on this thread; models and forces are made beforehand."""
    models = [box.model(step) for box in boxes]
    grid, at = motion.dt * np.arange(len(motion.x)), middles(motion.duration, step)
    applied = np.zeros((len(boxes), len(at), 6))
    for axis, samples in enumerate((motion.x, motion.y)):
        assert samples is not None
        applied[:, :, axis] = -np.array([box.scale for box in boxes])[:, None] * np.interp(at, grid, samples)
    states = np.zeros((len(boxes), 14))
    states[:, 3], states[:, 4] = [box.height / 2 for box in boxes], 1.0
    spec = int(mujoco.mjtState.mjSTATE_QFRC_APPLIED.value)
    data = [mujoco.MjData(models[0])]
    start = time.process_time()
    histories, _ = rollout.rollout(models, data, states, applied, control_spec=spec)
    seconds = (time.process_time() - start) / len(boxes)
    upright = 1.0 - 2.0 * (histories[:, :, 5] ** 2 + histories[:, :, 6] ** 2)
    peak = np.arccos(np.clip(upright, -1.0, 1.0)).max(axis=1)
    return Tilts(np.where(peak > FALLEN, np.inf, peak), np.full(len(boxes), seconds))


def compared(kind: str, count: int) -> Table:
    """Run the same boxes in both engines at several steps, and compare them with ours converged."""
    motion, boxes = shaken(), drawn(kind, count)
    exact = ours(boxes, motion, EXACT)
    runs = {("stayput", step): ours(boxes, motion, step) for step in (STEP, STEP / 4)}
    runs |= {("MuJoCo", step): theirs(boxes, motion, step) for step in (STEP, STEP / 2)}
    runs["stayput", EXACT] = exact
    rocks = ~exact.fell & (exact.peak > ROCKS)
    table = Table(
        title=f"{kind}: {count} free boxes, {rocks.sum()} rock and stand, {exact.fell.sum()} fall; "
        f"{motion.name}, {motion.duration:g} s, one core\n"
        f"errors of the peak tilt against steps of {EXACT:g} s: of the median of all, and of "
        "each that rocks and stands",
        title_justify="left",
    )
    for heading in ("", "step [ms]", "cases/s", "ratio", "slowest", "of the median", "half", "90 %", "flips"):
        table.add_column(heading, justify="right")
    for (name, step), run in sorted(runs.items()):
        both = rocks & ~run.fell
        off = np.abs(run.peak[both] / exact.peak[both] - 1.0)
        found, truth = float(np.median(run.peak)), float(np.median(exact.peak))
        middle = f"{100.0 * (found / truth - 1.0):+.2f} %" if 0.0 < truth < np.inf else "none"
        table.add_row(
            name,
            f"{1e3 * step:g}",
            f"{run.rate:.1f}",
            f"{run.rate / runs['MuJoCo', STEP].rate:.1f}",
            f"{1e3 * run.seconds.max():.0f} ms",
            middle,
            f"{100.0 * np.median(off):.2f} %",
            f"{100.0 * np.quantile(off, 0.9):.2f} %",
            f"{(run.fell != exact.fell).sum()}",
        )
    return table


def verified(family: str, motions: int = 20, samples: int = 8) -> Table:
    """Verify a full bookcase with the usual measures in plane and space, at one level."""
    table = Table(
        title=f"verification, {motions} {family} motions × {samples} draws, one level, {work.cores()} cores",
        title_justify="left",
    )
    for heading in ("dimensions", "options", "runs", "wall [s]", "processor [s]", "ms a run"):
        table.add_column(heading, justify="right")
    for dimensions in (2, 3):
        scenario = {
            "dimensions": dimensions,
            "furniture": {"preset": "bookcase"},
            "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
            "shaking": {"intensity": "6-upper", "suite": {"family": family, "count": motions}},
        }
        first, all_draws = (
            sp.Scenario.parse({**scenario, "uncertainty": {"samples": count}})
            for count in (motions, motions * samples)
        )
        sp.verify(first, levels=[], progress=False)  # compiles, and makes the motions
        began = time.process_time()
        verdict = sp.verify(all_draws, levels=[], progress=False)
        spent = time.process_time() - began
        table.add_row(
            str(dimensions),
            str(len(verdict.options)),
            f"{verdict.runs:,}",
            f"{verdict.seconds:.1f}",
            f"{spent:.1f}",
            f"{1e3 * spent / verdict.runs:.1f}",
        )
    return table


_FIRST = """
import stayput as sp
body = sp.Body(0.4, 1.8, 100.0, length=0.9)
sp.simulate(body, sp.Room(), sp.sine(3.0, 1.0, 0.1), dimensions={dimensions})
"""


def started(turns: int = 3) -> Table:
    """Time first runs in processes of their own, without and with machine code on disk."""
    table = Table(title="processor time of a first run, whole process; medians", title_justify="left")
    for heading in ("", "cold [s]", "warm [s]", "compiling [s]"):
        table.add_column(heading, justify="right")
    for dimensions, name in ((2, "in the plane"), (3, "in space")):
        program = _FIRST.format(dimensions=dimensions)
        spent: list[tuple[float, float]] = []
        for _ in range(turns):
            with tempfile.TemporaryDirectory() as folder:
                spent.append(
                    (program_seconds(["-c", program], folder), program_seconds(["-c", program], folder))
                )
        cold, warm = (median(column) for column in zip(*spent, strict=True))
        table.add_row(name, f"{cold:.1f}", f"{warm:.1f}", f"{cold - warm:.1f}")
    return table


PARTS: dict[str, Callable[[int], Iterable[Table]]] = {
    "boxes": lambda count: (compared(kind, count) for kind in KINDS),
    "verification": lambda count: map(verified, ("near-fault", "mixed")),
    "start": lambda count: (started(),),
}
"""The parts, given the number of free boxes."""


def main() -> None:
    """Run the parts and print their tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "parts", nargs="*", metavar="PART", help=f"{', '.join(PARTS)}; all where none is said"
    )
    parser.add_argument("--boxes", type=int, default=60, help="free boxes of a kind")
    wanted = parser.parse_args()
    for part in wanted.parts or PARTS:
        for table in PARTS[part](wanted.boxes):
            Console(width=120).print(table)


if __name__ == "__main__":
    main()
