"""Random boxes, hulls, cylinders and stacks in space, thrown and shaken for a moment: what must never happen.

Each case runs for `DURATION`. Counted are numbers that are not finite, cases slower than `SLOW`, steps whose
impulses did not converge, how deep anything got into the floor and corners into other bodies, and, on a
still floor, the energy that was made, relative to the total: kinetic energy and that of G above the floor,
at first. A case has a seed of its own, and runs in a process that is ended when the case hangs.
``--minutes`` ends the run early.
"""

from __future__ import annotations

import argparse
import multiprocessing
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import stayput as sp

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

GRAVITY = 9.80665
DURATION, SAMPLE, STEP = 0.1, 0.01, 1e-3
"""Of a case, between samples, and the longest step [s]."""

SLOW = 2.0
"""Time of a case [s] from which on it hangs: its process is ended."""

MADE = 1e-6
"""Share of the total energy that may be made."""


@dataclass(frozen=True, slots=True)
class Thrown:
    """A case: what stands where and how fast, in what room, on a floor that moves or not."""

    bodies: tuple[sp.Standing, ...]
    room: sp.Room
    motion: sp.Motion
    friction: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Found:
    """What a case did: all finite, process time [s], steps, unconverged steps, energy made, depths [m]."""

    finite: bool
    seconds: float
    steps: int
    unconverged: int
    made: float
    depth: float
    between: float


def shapes(rng: np.random.Generator, count: int) -> list[sp.Solid]:
    """Return a pool of bodies: boxes, upright cylinders, hulls of points."""
    found: list[sp.Solid] = []
    for number in range(count):
        mass = float(rng.uniform(1.0, 200.0))
        kind = number % 3
        if kind == 0:
            found.append(sp.Solid.box(*rng.uniform(0.1, 1.5, 3), mass))
        elif kind == 1:
            found.append(sp.Solid.cylinder(rng.uniform(0.1, 0.8), rng.uniform(0.1, 1.6), mass))
        else:
            points = rng.uniform(-0.4, 0.4, (rng.integers(5, 16), 3)) + 0.1 * rng.normal(size=3)
            found.append(sp.Solid(points, mass))
    return found


def case_of(rng: np.random.Generator, pool: list[sp.Solid]) -> Thrown:
    """Draw a case: one body, or a stack of two or three; what is uppermost is thrown, or stands there."""
    count = int(rng.choice([1, 1, 2, 3]))
    bodies: list[sp.Standing] = []
    top = 0.0
    for number in range(count):
        solid = pool[rng.integers(len(pool))]
        last = number == count - 1
        gap = rng.choice([0.0, 1e-3, 0.05]) if last else 0.0
        flung = last and rng.random() < 0.7
        bodies.append(
            sp.Standing(
                solid,
                (*rng.uniform(-0.1, 0.1, 2), top + gap - float(solid.vertices[:, 2].min())),
                heading=rng.uniform(-3.0, 3.0),
                velocity=tuple(rng.normal(0.0, 1.0, 3)) if flung else (0.0, 0.0, 0.0),
                rotation_rate=tuple(rng.normal(0.0, 3.0, 3)) if flung else (0.0, 0.0, 0.0),
            )
        )
        top += gap + float(np.ptp(solid.vertices[:, 2])) + 1e-9
    static, between = rng.uniform(0.0, 1.0, 2)
    floor = sp.Floor(
        static, static * rng.uniform(0.5, 1.0), normal_restitution=rng.choice([0.0, rng.uniform(0, 0.8)])
    )
    t = SAMPLE * np.arange(round(DURATION / SAMPLE) + 1)
    size = rng.choice([0.0, 0.0, 8.0])
    x, y, z = (size * rng.normal() * np.sin(rng.uniform(5.0, 40.0) * t) for _ in range(3))
    motion = sp.Motion(dt=SAMPLE, x=x, y=y, z=0.5 * z)
    return Thrown(tuple(bodies), sp.Room(floor), motion, (between, 0.8 * between))


def energies(run: sp.SpaceRun) -> np.ndarray:
    """Return the energy of all bodies at the samples [J]."""
    total = np.zeros(len(run.time))
    for body, one in enumerate(run.standing):
        turn, spin, mass = run.turn[body], run.rotation_rate[body], one.solid.mass
        inertia = turn @ one.solid.inertia @ turn.transpose(0, 2, 1)
        total += 0.5 * np.einsum("si,sij,sj->s", spin, inertia, spin)
        total += 0.5 * mass * (run.velocity[body] ** 2).sum(axis=1) + mass * GRAVITY * run.place[body, :, 2]
    return total


def corners_of(run: sp.SpaceRun, body: int) -> np.ndarray:
    """Return the places of a body's corners, shape (samples, corners, 3)."""
    solid = run.standing[body].solid
    return run.place[body, :, np.newaxis] + (solid.vertices - solid.centre_of_gravity) @ run.turn[
        body
    ].transpose(0, 2, 1)


def depth_between(run: sp.SpaceRun) -> float:
    """Return how deep any corner of a body was below all faces of another, at samples [m]."""
    deepest = 0.0
    for other, one in enumerate(run.standing):
        middle = one.solid.centre_of_gravity
        heights = np.array([one.solid.vertices[face].mean(axis=0) - middle for face in one.solid.faces])
        heights = (heights * one.solid.normals).sum(axis=1)
        for body in range(len(run.standing)):
            if body != other:
                seen = (corners_of(run, body) - run.place[other, :, np.newaxis]) @ run.turn[other]
                inside = (heights - seen @ one.solid.normals.T).min(axis=2)
                deepest = max(deepest, float(inside.max()))
    return deepest


def run_one(case: Thrown, step: float = STEP) -> Found:
    """Run a case and look at what came out."""
    began = time.process_time()
    run = sp.simulate(sp.Assembly(case.bodies, case.friction), case.room, case.motion, step=step)
    seconds = time.process_time() - began
    arrays = run.place, run.attitude, run.velocity, run.rotation_rate
    finite = all(bool(np.isfinite(array).all()) for array in arrays)
    made = 0.0
    if not case.motion.x.any():
        total = energies(run)
        made = float(np.diff(total).max() / abs(total[0]))
    depth = -min(float(corners_of(run, body)[..., 2].min()) for body in range(len(run.standing)))
    return Found(finite, seconds, run.steps, run.unconverged, made, depth, depth_between(run))


def work(pool: list[sp.Solid], seed: int, pipe: Connection) -> None:
    """Run cases by their numbers as they are asked for; send what was found, or None for a refused start."""
    while True:
        number, step = pipe.recv()
        try:
            pipe.send(run_one(case_of(np.random.default_rng((seed, number)), pool), step))
        except sp.InputError:
            pipe.send(None)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", type=int, default=100_000)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--step", type=float, default=STEP)
    chosen = parser.parse_args()
    pool = shapes(np.random.default_rng(chosen.seed), 300)
    run_one(case_of(np.random.default_rng((chosen.seed, 0)), pool))  # compiled before the clock starts
    context = multiprocessing.get_context("fork")
    found: list[Found] = []
    hung: list[int] = []
    refused, number, end, worker = 0, 0, time.monotonic() + 60.0 * chosen.minutes, None
    here, there = context.Pipe()
    while number < chosen.cases and time.monotonic() < end:
        if worker is None:
            here, there = context.Pipe()
            worker = context.Process(target=work, args=(pool, chosen.seed, there), daemon=True)
            worker.start()
        here.send((number, chosen.step))
        if here.poll(SLOW):
            one = here.recv()
            refused += one is None
            if one is not None:
                found.append(one)
                if not one.finite or one.made > 1e-2:
                    print(f"case {number}: {one}")
        else:
            hung.append(number)
            worker.kill()
            worker.join()
            worker = None
        number += 1
    if worker is not None:
        worker.kill()
    names = ("seconds", "made", "depth", "between", "unconverged")
    seconds, made, depth, between, unconverged = (
        np.array([getattr(one, name) for one in found]) for name in names
    )
    print(f"{len(found)} cases, {refused} more refused as begun, in {seconds.sum():.0f} s of one core")
    print(f"ended after {SLOW:g} s: {len(hung)}, numbers {hung[:20]}")
    print(f"not finite: {sum(not one.finite for one in found)}")
    print(f"slowest: {seconds.max():.2f} s; median {1e3 * np.median(seconds):.2f} ms")
    print(f"cases with unconverged steps: {(unconverged > 0).sum()}, the most {unconverged.max()}")
    for where, deep in (("the floor", depth), ("another body", between)):
        print(
            f"deepest in {where}: {1e6 * deep.max():.2f} µm; 99.9 %: {1e6 * np.quantile(deep, 0.999):.2f} µm"
        )
    print(f"cases on a still floor that made more than {MADE:g} of their energy: {(made > MADE).sum()}")
    print("energy made, quantiles 50, 90, 99, 99.9, 100 %:", np.quantile(made, (0.5, 0.9, 0.99, 0.999, 1.0)))


if __name__ == "__main__":
    main()
