"""Random bodies, rows and stacks in space: what must never happen, as tables in Markdown.

``python benchmarks/space_random.py [FAMILY ...]`` runs 100,000 single bodies and 1,000 rows, towers and
piles, or a ``--share`` of them. The first table counts runs that are given up (in brackets: with masses up
to a ratio of 100, where none must be), that are not finite, and that are ended since they take longer than
the family's limit of processor time; and steps whose impulses did not converge. The second has by what laws
were broken, at any sample: the energy made on a still floor, as a share of the total (kinetic energy and
that of G above the floor, at first); the energy lost where nothing slips, hits or yields, as a share of the
largest kinetic energy; what the momenta of all bodies together are off where no force or only a
frictionless floor acts, as a share of the largest of a body; and depths, of which 99.9 % of the cases have
less, and the deepest. Then come the worst cases, by their numbers: ``--case`` runs one. With a seed case n
of a family is the same.
"""

from __future__ import annotations

import argparse
import math
import multiprocessing
import signal
import time
import warnings
from dataclasses import dataclass
from multiprocessing.connection import wait
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

import stayput as sp
from csv_tables import tell, three
from space_cases import FAMILIES, FLIES, GRAVITY, RATIO, SLIDES, Thrown

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.context import ForkProcess

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

STEP = 1e-3
"""Longest step [s]."""

MADE = 1e-6
"""Share of the total energy that may be made."""


class Found(NamedTuple):
    """What a case did.

    Processor time [s], whether it is finite and was given up, the ratio of masses, simulated time [s], steps,
    unconverged steps, energy made and lost, momentum off, depths in the floor and between bodies [m]; NaN
    where nothing can be said.
    """

    seconds: float
    finite: bool
    given_up: bool
    ratio: float
    duration: float
    steps: int
    unconverged: int
    made: float
    lost: float
    momentum: float
    depth: float
    between: float


def inertias(run: sp.Run, body: int) -> Array:
    """Return a body's tensor of inertia in the room's axes, shape (samples, 3, 3)."""
    turn = run.turn[body]
    return turn @ run.standing[body].solid.inertia @ turn.transpose(0, 2, 1)


def kinetic(run: sp.Run) -> Array:
    """Return the kinetic energy of all bodies at the samples [J]."""
    total = np.zeros(len(run.time))
    for body, one in enumerate(run.standing):
        spin = run.rotation_rate[body]
        total += 0.5 * np.einsum("si,sij,sj->s", spin, inertias(run, body), spin)
        total += 0.5 * one.solid.mass * (run.velocity[body] ** 2).sum(axis=1)
    return total


def energies(run: sp.Run) -> Array:
    """Return the energy of all bodies at the samples [J]."""
    masses = np.array([one.body.mass for one in run.standing])
    return kinetic(run) + GRAVITY * masses @ run.place[:, :, 2]


def momentum_off(run: sp.Run, keeps: str) -> float:
    """Return by how much momentum and moment of momentum about the origin are off at most, as shares.

    In flight gravity adds M g t, and M (r₀ t + v₀ t²/2) × g; on a floor without friction what is in its
    plane, and the moment about the vertical, stay.
    """
    time, mass = run.time[:, np.newaxis], np.array([one.body.mass for one in run.standing])
    linear = np.einsum("b,bsi->si", mass, run.velocity)
    moment = np.einsum("b,bsi->si", mass, np.cross(run.place, run.velocity))
    for body in range(len(mass)):
        moment += np.einsum("sij,sj->si", inertias(run, body), run.rotation_rate[body])
    first, g = mass @ run.place[:, 0], np.array([0.0, 0.0, -GRAVITY])
    speeds = np.linalg.norm(run.velocity, axis=2)
    sizes = (mass[:, np.newaxis] * speeds).max(), (mass[:, np.newaxis] * speeds * _reach(run)).max()
    linear = linear - linear[0] - mass.sum() * g * time
    moment = moment - moment[0] - np.cross(first * time + 0.5 * (mass @ run.velocity[:, 0]) * time**2, g)
    parts = slice(0, 3) if keeps == FLIES else slice(0, 2)
    turns = parts if keeps == FLIES else slice(2, 3)
    off = np.abs(linear[:, parts]).max(), np.abs(moment[:, turns]).max()
    return max(off[0] / sizes[0], off[1] / sizes[1]) if min(sizes) > 0.0 else math.nan


def _reach(run: sp.Run) -> Array:
    """Return how far from the origin a body reaches, shape (bodies, samples) [m]."""
    radii = [
        np.linalg.norm(one.solid.vertices - one.solid.centre_of_gravity, axis=1).max() for one in run.standing
    ]
    return np.linalg.norm(run.place, axis=2) + np.array(radii)[:, np.newaxis]


def corners_of(run: sp.Run, body: int) -> Array:
    """Return the places of a body's corners, shape (samples, corners, 3)."""
    solid = run.standing[body].solid
    return run.place[body, :, np.newaxis] + (solid.vertices - solid.centre_of_gravity) @ run.turn[
        body
    ].transpose(0, 2, 1)


def depth_between(run: sp.Run) -> float:
    """Return how deep any corner of a body was below all faces of another, at samples [m]."""
    deepest, turn = 0.0, run.turn
    corners = [corners_of(run, body) for body in range(len(run.pieces))]
    radii = [np.linalg.norm(c[0] - run.place[b, 0], axis=1).max() for b, c in enumerate(corners)]
    for other, one in enumerate(run.standing):
        middle = one.solid.centre_of_gravity
        heights = np.array([one.solid.vertices[face].mean(axis=0) - middle for face in one.solid.faces])
        heights = (heights * one.solid.normals).sum(axis=1)
        for body in range(len(run.pieces)):
            apart = np.linalg.norm(run.place[body] - run.place[other], axis=1)
            near = apart < radii[body] + radii[other]
            if body != other and near.any():
                seen = (corners[body][near] - run.place[other, near][:, np.newaxis]) @ turn[other, near]
                inside = (heights - seen @ one.solid.normals.T).min(axis=2)
                deepest = max(deepest, float(inside.max()))
    return deepest


def run_one(case: Thrown, step: float = STEP) -> Found:
    """Run a case and look at what came out."""
    began = time.process_time()
    run = sp.simulate(sp.Scene(case.bodies, case.room, friction=case.friction), case.motion, step=step)
    seconds = time.process_time() - began
    arrays = run.place, run.attitude, run.velocity, run.rotation_rate
    made = lost = momentum = math.nan
    masses = [one.body.mass for one in case.bodies]
    if not case.motion.x.any() and not run.given_up:
        total = energies(run)
        made = float((total - np.minimum.accumulate(total)).max() / abs(total[0]))
        if case.keeps and len(case.bodies) == 1:
            lost = float((total[0] - total).max() / kinetic(run).max())
        if case.keeps in (FLIES, SLIDES):
            momentum = momentum_off(run, case.keeps)
    return Found(
        seconds,
        all(bool(np.isfinite(array).all()) for array in arrays),
        run.given_up,
        max(masses) / min(masses),
        float(run.time[-1]),
        run.steps,
        run.unconverged,
        made,
        lost,
        momentum,
        max(0.0, *(-float(corners_of(run, body)[..., 2].min()) for body in range(len(run.pieces)))),
        depth_between(run),
    )


Task = tuple[str, int]
Results = dict[Task, Found | None]


def case_number(family: str, seed: int, number: int) -> Thrown:
    """Return a case of a family."""
    own = list(FAMILIES).index(family)
    return FAMILIES[family].draw(np.random.default_rng((seed, own, number)))


@dataclass
class Worker:
    """A process that runs one case after the other, and which it runs."""

    pipe: Connection
    process: ForkProcess
    task: Task | None = None


def work(pipe: Connection, seed: int, step: float) -> None:
    """Run cases as they are asked for; send what was found, or None for a refused start.

    The process ends itself at the limit of a case, in compiled code too: it has no handler of the signal.
    """
    warnings.simplefilter("ignore", sp.InputWarning)  # strong vertical shaking
    while True:
        family, number = pipe.recv()
        signal.setitimer(signal.ITIMER_VIRTUAL, FAMILIES[family].limit)
        try:
            pipe.send(run_one(case_number(family, seed, number), step))
        except sp.InputError:
            pipe.send(None)


def started(seed: int, step: float) -> Worker:
    context = multiprocessing.get_context("fork")
    here, there = context.Pipe()
    process = context.Process(target=work, args=(there, seed, step), daemon=True)
    process.start()
    there.close()
    return Worker(here, process)


def run_all(tasks: list[Task], processes: int, seed: int, step: float) -> tuple[Results, set[Task]]:
    """Run cases in processes; return what was found, and those that were ended."""
    found: Results = {}
    ended: set[Task] = set()
    left, workers = tasks[::-1], [started(seed, step) for _ in range(processes)]
    while left or any(worker.task for worker in workers):
        for worker in workers:
            if worker.task is None and left:
                worker.task = left.pop()
                worker.pipe.send(worker.task)
        ready = wait([worker.pipe for worker in workers if worker.task])
        for place, worker in enumerate(workers):
            if worker.task is not None and worker.pipe in ready:
                try:
                    found[worker.task], worker.task = worker.pipe.recv(), None
                except EOFError:
                    ended.add(worker.task)
                    workers[place] = started(seed, step)
    for worker in workers:
        worker.process.kill()
    return found, ended


def largest(values: Array, unit: float = 1.0) -> str:
    """Return the largest number that is one."""
    known = values[np.isfinite(values)]
    return f"{unit * known.max():.2g}" if len(known) else ""


def told(tasks: list[Task], found: Results, ended: set[Task], folder: Path | None) -> None:
    """Print the tables, and the numbers of the worst cases."""
    runs: list[list[str]] = []
    laws: list[list[str]] = []
    worst: list[str] = []
    for name in dict.fromkeys(name for name, _ in tasks):
        own = {number: one for (family, number), one in found.items() if family == name and one is not None}
        late = sorted(number for family, number in ended if family == name)
        if not own:
            runs.append([name, f"{len(late)}", "", "", f"{len(late)}", *[""] * 4])
            continue
        numbers = np.array(list(own))
        all_of = {field: np.array([getattr(one, field) for one in own.values()]) for field in Found._fields}
        seconds, steps, given_up = (all_of[field] for field in ("seconds", "steps", "given_up"))
        early = given_up & (all_of["ratio"] <= RATIO)
        unlike = ~all_of["finite"]
        runs.append(
            [
                name,
                f"{len(own) + len(late):,}",
                f"{given_up.sum()} ({early.sum()})",
                f"{unlike.sum()}",
                f"{len(late)} > {FAMILIES[name].limit:g} s",
                three(1e3 * float(np.median(seconds))),
                f"{seconds.max():.3g}",
                f"{(steps / all_of['duration']).max():,.0f}",
                three(1e6 * all_of["unconverged"].sum() / max(1, steps.sum())),
            ]
        )
        made = all_of["made"]
        laws.append(
            [
                name,
                f"{(made > MADE).sum()} of {np.isfinite(made).sum():,}",
                largest(made),
                largest(all_of["lost"]),
                largest(all_of["momentum"]),
                *(
                    f"{1e6 * np.quantile(deep, 0.999):.2g}, {1e6 * deep.max():.2g}"
                    for deep in (all_of["depth"], all_of["between"])
                ),
            ]
        )
        worst += [f"{name} {number}: ended" for number in late]
        for what, those in (("given up", given_up), ("not finite", unlike)):
            worst += [f"{name} {number}: {what}" for number in numbers[those][:10]]
        for field in ("made", "lost", "momentum", "depth", "between", "seconds"):
            values = np.nan_to_num(all_of[field])
            n = int(np.argmax(values))
            if values[n] > 0.0:
                worst.append(f"{name} {numbers[n]}: {field} {values[n]:.3g}")
    tell(
        "space_runs",
        [
            "family",
            "cases",
            "given up",
            "not finite",
            "ended",
            "median [ms]",
            "slowest [s]",
            "most steps a second",
            "unconverged [10⁻⁶]",
        ],
        runs,
        folder,
    )
    tell(
        "space_laws",
        ["family", f"made > {MADE:g}", "made", "lost", "momentum", "into the floor [µm]", "into bodies [µm]"],
        laws,
        folder,
    )
    print("\n".join(worst))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "families", nargs="*", metavar="FAMILY", help=f"{', '.join(FAMILIES)}; all by default"
    )
    parser.add_argument("--share", type=float, default=1.0)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--step", type=float, default=STEP)
    parser.add_argument("--case", type=int)
    parser.add_argument("--tables", type=Path, metavar="FOLDER", help="write the tables as CSV")
    chosen = parser.parse_args()
    names: list[str] = chosen.families or list(FAMILIES)
    run_one(case_number("stacks of 2-3", 0, 0))  # compiled before the clock starts
    if chosen.case is not None:
        for name in names:
            print(name, chosen.case, run_one(case_number(name, chosen.seed, chosen.case), chosen.step))
        return
    numbers = {name: math.ceil(chosen.share * FAMILIES[name].cases) for name in names}
    tasks = [(name, number) for name in reversed(names) for number in range(numbers[name])]
    began = time.monotonic()
    found, ended = run_all(tasks, chosen.processes, chosen.seed, chosen.step)
    told(tasks[::-1], found, ended, chosen.tables)
    refused = sum(one is None for one in found.values())
    minutes = (time.monotonic() - began) / 60.0
    print(f"{refused} refused as begun; {minutes:.1f} min, {chosen.processes} processes")


if __name__ == "__main__":
    main()
