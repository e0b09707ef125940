"""How exact runs in space are at the default step, and what they cost, beside what they were.

``python benchmarks/space_accuracy.py [free held walls mirror cost]`` prints tables; ``--tables`` writes them
to a folder. `held` runs pieces at a wall, with measures and without, in steps of 1 and 0.1 ms. `free` runs
boxes under three components of shaking and counts those as not chaotic
whose answers in steps of 0.1 and 0.06 ms are within 0.2 % of each other. `walls` runs pieces that hit a wall,
which is chaotic, in steps of 1 and 0.1 ms: what must agree are shares and medians. `mirror` runs boxes and
their mirror images. `cost` runs a bookcase held in six ways, in a batch, on one core.
"""

from __future__ import annotations

import argparse
import multiprocessing
import time
from functools import partial
from pathlib import Path

import numpy as np

import stayput as sp
from csv_tables import tell, three

STEP, FINER, FINEST = 1e-3, 1e-4, 6e-5
"""The default step, and those of references [s]."""

PIECES = 20_000
"""Pieces that hit a wall: half an hour of processor time."""

DRAWS = 350
"""Pieces held in each way."""

STABLE = 2e-3
"""Relative difference of the references up to which a run is not chaotic."""

KINDS = {
    "none": 53.0,
    "l_bracket": 176.0,
    "belt": 156.0,
    "tension_pole": 98.0,
    "anti_slip_sheet": 29.0,
    "gel_mats": 66.0,
}
"""Measures, and what a run took before steps were refined, on the machine of the table [ms]."""


def shaken(suite: list[sp.Motion], number: int, rng: np.random.Generator, vertical: float) -> sp.Motion:
    """Return a motion of a suite along any direction, with parts of two others across and upward."""
    x, n = suite[number % len(suite)].x, len(suite[number % len(suite)].x)
    others = [np.resize(suite[(number + k) % len(suite)].x, n) for k in (7, 13)]
    across, up = 0.7 * rng.uniform(0.3, 1.0) * others[0], vertical * others[1]
    angle, size = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.35, 1.0)
    cos, sin = size * np.cos(angle), size * np.sin(angle)
    return sp.Motion(
        dt=suite[0].dt, x=cos * x - sin * across, y=sin * x + cos * across, z=size * up, name="three"
    )


def free_box(suite: list[sp.Motion], step: float, number: int) -> tuple[float, float, str]:
    """Run a box that stands free; return its peak tilt and slide, and what becomes of it."""
    rng = np.random.default_rng(1000 + number)
    box = sp.Body.box(rng.uniform(0.3, 0.6), rng.uniform(0.3, 1.2), rng.uniform(0.8, 2.0), 80.0)
    friction = float(rng.uniform(0.2, 0.9))
    motion = shaken(suite, number, rng, 0.4)
    run = sp.simulate(box, sp.Room(sp.Floor(friction, 0.8 * friction)), motion, step=step)
    return float(run[0].peak_tilt), float(run[0].peak_slide), run.outcome.value


def at_a_wall(suite: list[sp.Motion], step: float, number: int) -> tuple[float, float, str]:
    """Run a piece in front of a wall; return the same."""
    rng = np.random.default_rng(number)
    body = sp.Body(rng.uniform(0.25, 0.45), rng.uniform(1.2, 1.9), 80.0, length=rng.uniform(0.5, 1.2))
    friction = float(rng.uniform(0.3, 0.7))
    room = sp.Room(sp.Floor(friction, 0.8 * friction), left_wall=sp.Wall(rng.uniform(0.005, 0.1)))
    run = sp.simulate(body, room, shaken(suite, number, rng, 0.0), step=step, dimensions=3)
    return float(run[0].peak_tilt), float(run[0].peak_slide), run.outcome.value


def held_piece(suite: list[sp.Motion], step: float, case: tuple[str, int]) -> tuple[float, float, str]:
    """Run a piece at a wall with a measure; return the same."""
    kind, number = case
    rng = np.random.default_rng([number, 5])
    body = sp.Body(
        rng.uniform(0.25, 0.6), rng.uniform(1.0, 2.1), rng.uniform(40, 150), length=rng.uniform(0.4, 1.2)
    )
    friction = float(rng.uniform(0.3, 0.8))
    floor = sp.Floor(friction, 0.8 * friction)
    room = sp.Room(floor, left_wall=sp.Wall(rng.uniform(0.0, 0.05)), ceiling=sp.Ceiling(2.4))
    motion = suite[number % len(suite)].to_intensity(float(rng.uniform(5.0, 6.4)))
    motion = shaken([motion, *suite], 0, rng, 0.0)
    measures = [] if kind == "none" else [sp.MEASURES[kind]()]
    run = sp.simulate(body, room, motion, measures=measures, step=step, dimensions=3)
    return float(run.peak_tilt), float(run.peak_slide), run.outcome.value


def held(folder: Path | None, processes: int) -> None:
    """Tell how far pieces at a wall are from finer steps, with and without measures."""
    suite = [*sp.synthetic_suite("crustal", 12, seed=5), *sp.synthetic_suite("near-fault", 12, seed=5)]
    rows: list[list[str]] = []
    with multiprocessing.Pool(processes) as pool:
        for kind in KINDS:
            cases = [(kind, number) for number in range(DRAWS)]
            now, finer = (pool.map(partial(held_piece, suite, step), cases) for step in (STEP, FINER))
            alike = np.mean([one[2] == other[2] for one, other in zip(now, finer, strict=True)])
            falls = [sum(run[2] == "overturned" for run in runs) for runs in (now, finer)]
            tilts = np.array([(one[0], other[0]) for one, other in zip(now, finer, strict=True)])
            tilts = tilts[tilts[:, 1] > 1e-3]
            off = 100.0 * np.abs(tilts[:, 0] / tilts[:, 1] - 1.0)
            quantiles = map(three, np.quantile(off, (0.5, 0.75, 0.9)))
            rows.append([kind, f"{100.0 * alike:.1f}", *map(str, falls), *quantiles])
    heads = ["held by", "outcome agrees [%]", "overturn", "in steps of 0.1 ms"]
    tell("space_held", [*heads, "median off [%]", "75 %", "90 %"], rows, folder)


def free(folder: Path | None, processes: int) -> None:
    """Tell how far free boxes are from finer steps."""
    suite = list(sp.synthetic_suite("mixed", 24, seed=2).to_intensity("6-upper"))
    with multiprocessing.Pool(processes) as pool:
        found, finer, finest = (
            pool.map(partial(free_box, suite, step), range(600)) for step in (STEP, FINER, FINEST)
        )
    rows: list[list[str]] = []
    for name, column, least, was in (("peak tilt", 0, 3e-3, "17"), ("peak slide", 1, 2e-3, "–")):
        now, one, two = (np.array([run[column] for run in runs]) for runs in (found, finer, finest))
        moves = (one > least) & [run[2] != "overturned" for run in finer]
        stable = moves & (np.abs(two / np.where(moves, one, 1.0) - 1.0) <= STABLE)
        off = 100.0 * np.abs(now[stable] / one[stable] - 1.0)
        rows.append(
            [name, f"{stable.sum()} of {moves.sum()}", *map(three, np.quantile(off, (0.5, 0.75, 0.9))), was]
        )
    tell("space_free", ["", "not chaotic", "median off [%]", "75 %", "90 %", "90 % before"], rows, folder)


def walls(folder: Path | None, processes: int) -> None:
    """Tell the statistics of pieces that hit a wall."""
    suite = list(sp.synthetic_suite("mixed", 100, seed=11).to_intensity("6-upper"))
    rows: list[list[str]] = []
    with multiprocessing.Pool(processes) as pool:
        for step in (STEP, FINER):
            runs = pool.map(partial(at_a_wall, suite, step), range(PIECES), chunksize=20)
            rocked = np.array([run[:2] for run in runs if run[2] not in ("overturned", "failed")])
            shares = [100.0 * np.mean([run[2] == one for run in runs]) for one in ("overturned", "rocked")]
            medians = np.median(rocked[rocked[:, 0] > 1e-3, 0]), np.median(rocked[:, 1])
            rows.append(
                [f"{1e3 * step:g}", *(f"{one:.2f}" for one in shares), *(f"{one:.4f}" for one in medians)]
            )
    heads = [
        "step [ms]",
        "overturn [%]",
        "rock [%]",
        "median peak tilt of these [rad]",
        "median peak slide [m]",
    ]
    tell("space_walls", heads, rows, folder)


def mirror(folder: Path | None, processes: int) -> None:
    """Tell how far mirror images are from each other, at the default step."""
    suite = list(sp.synthetic_suite("mixed", 24, seed=2).to_intensity("6-upper"))
    with multiprocessing.Pool(processes) as pool:
        pairs = np.array(pool.map(partial(both_images, suite), range(200)))
    rocks = (pairs[:, 0] > 1e-3) & (pairs.max(axis=1) < 1.2)
    off = 100.0 * np.abs(pairs[rocks, 1] / pairs[rocks, 0] - 1.0)
    row = ["peak tilt", str(rocks.sum()), *map(three, np.quantile(off, (0.5, 0.75, 0.9)))]
    tell("space_mirror", ["", "boxes", "median off [%]", "75 %", "90 %"], [row], folder)


def both_images(suite: list[sp.Motion], number: int) -> tuple[float, float]:
    """Return the peak tilts of a box and of its mirror image."""
    rng = np.random.default_rng(number)
    box = sp.Body.box(rng.uniform(0.3, 0.6), rng.uniform(0.4, 1.0), rng.uniform(0.8, 1.8), 100.0)
    motion = shaken(suite, number, rng, 0.0)
    image = sp.Motion(dt=motion.dt, x=motion.x, y=-motion.y, name="image")
    room = sp.Room(sp.Floor(0.5, 0.4))
    one, other = (sp.simulate(box, room, each).peak_tilt for each in (motion, image))
    return float(one), float(other)


def cost(folder: Path | None, processes: int) -> None:
    """Tell what a run in a batch takes of one core."""
    bookcase = sp.Body(0.3, 1.8, 100.0, length=0.9)
    room = sp.Room(sp.Floor.of("wood flooring"), left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
    motions = [motion.to_intensity("6-upper") for motion in sp.synthetic_suite("mixed", 8, seed=1)]
    rows: list[list[str]] = []
    for kind, was in KINDS.items():
        measures = [] if kind == "none" else [sp.MEASURES[kind]()]
        case = sp.Case(bookcase, room, motions[0], measures=measures, dimensions=3)
        spent: list[float] = []
        for _ in range(4):  # the first compiles
            start = time.process_time()
            sp.simulate_many(case, {"motion": motions}, threads=1, progress=False)
            spent.append(time.process_time() - start)
        rows.append([kind, f"{125.0 * min(spent):.0f}", f"{was:.0f}"])
    means = [np.mean([float(row[column]) for row in rows]) for column in (1, 2)]
    tell("space_cost", ["held by", "ms a run", "before"], [*rows, ["mean", *map(three, means)]], folder)


PARTS = {part.__name__: part for part in (free, held, walls, mirror, cost)}


def main() -> None:
    """Run the parts that are asked for."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("parts", nargs="*", choices=[*PARTS, []], default=[])
    parser.add_argument("--tables", type=Path)
    parser.add_argument("--processes", type=int, default=2)
    chosen = parser.parse_args()
    for name in chosen.parts or PARTS:
        PARTS[name](chosen.tables, chosen.processes)


if __name__ == "__main__":
    main()
