"""The engine in space beside the engine in the plane: mixed boxes under one component, over the step.

Prints, for each step, how far peak tilt, residual slide and the time of overturning are from the planar
engine's, as quantiles, and how many outcomes differ. Cases are boxes that stand free, between walls, or under
a ceiling, and rest, slide, rock or fall under the near-fault motion with its vertical component.

A case counts where the planar engine's own answer hangs neither on the shaking nor on the friction: with
either larger and smaller by each of `SHARES` it must end alike, and as near as the engine in space is asked
to be. That is asked of the planar engine alone, before the engine in space runs.
"""

from __future__ import annotations

import argparse
import math
import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

STEPS = (1e-3, 5e-4, 2e-4, 1e-4)
"""Steps [s]."""

SHARES = (1e-6, 1e-4, 1e-3)
"""By what shaking and friction are changed to see whether a case is chaotic."""

SAME = 1e-2
"""By how much its answer may change, as `difference` counts."""

DURATION = 14.0
"""Of the motion [s]."""

KINDS = ("free", "free", "walls", "ceiling")
"""Half of the boxes stand free."""


@dataclass(frozen=True, slots=True)
class BesidePlane:
    """A case of both engines.

    Parameters
    ----------
    kind : str
        Of `KINDS`.
    body : Body
        The section, with its length.
    room : Room
        The room.
    motion : Motion
        Components x and z.
    """

    kind: str
    body: sp.Body
    room: sp.Room
    motion: sp.Motion


@dataclass(frozen=True, slots=True)
class Answer:
    """What either engine says: whether and when a body fell [s], peak tilt [rad], residual slide [m]."""

    overturned: bool
    overturn_time: float
    peak_tilt: float
    residual_slide: float


def draw(seed: int) -> Iterator[BesidePlane]:
    """Draw cases without end."""
    rng = np.random.default_rng(seed)
    whole = sp.near_fault()
    count = round(DURATION / whole.dt)
    assert whole.z is not None
    while True:
        kind = KINDS[rng.integers(len(KINDS))]
        static = rng.uniform(0.2, 0.8)
        floor = sp.Floor(static, static * rng.uniform(0.7, 1.0))
        width, height = rng.uniform(0.2, 0.7), rng.uniform(0.6, 2.2)
        walls, ceiling = (None, None), None
        if kind == "walls":
            walls = tuple(
                sp.Wall(gap, rng.uniform(0.0, 0.5), rng.uniform(0.1, 0.5)) for gap in rng.uniform(0.0, 0.3, 2)
            )
        if kind == "ceiling":
            # a body that tilts rises to half its diagonal and its corner to more: within reach
            ceiling = sp.Ceiling(height + rng.uniform(0.05, 1.0) * (math.hypot(width, height) - height))
        scale = rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 1.5)
        motion = sp.Motion(
            dt=whole.dt, x=scale * whole.x[:count], z=abs(scale) * whole.z[:count], name="in the plane"
        )
        body = sp.Body(width, height, 100.0, length=rng.uniform(0.3, 1.5))
        yield BesidePlane(kind, body, sp.Room(floor, *walls, ceiling=ceiling), motion)


def in_the_plane(case: BesidePlane, shaking: float = 1.0, friction: float = 1.0) -> Answer:
    """Run the engine in the plane, with shaking and friction of the floor times a factor."""
    floor = case.room.floor
    floor = replace(
        floor,
        static_friction=friction * floor.static_friction,
        kinetic_friction=friction * floor.kinetic_friction,
    )
    run = sp.simulate(case.body, replace(case.room, floor=floor), case.motion.scaled(shaking), dimensions=2)
    return Answer(run.overturned, run.overturn_time, run.peak_tilt, run.residual_slide)


def in_space(case: BesidePlane, step: float) -> Answer:
    """Run the engine in space."""
    run = sp.simulate(case.body, case.room, case.motion, dimensions=3, step=step)
    tilt, slide = float(run[0].peak_tilt), float(run[0].slide_in_plan[-1, 0])
    return Answer(bool(run[0].overturned), float(run[0].overturn_time), tilt, slide)


def difference(one: Answer, other: Answer) -> float:
    """Return how far two answers are apart: inf where one fell and the other did not.

    Of bodies that stand it is the larger of the differences of the peak tilts and of the residual slides,
    relative to the first answer, or to 0.01 rad and 0.01 m where that is smaller; of those that fell that of
    the times.
    """
    if one.overturned != other.overturned:
        return math.inf
    if one.overturned:
        return abs(other.overturn_time / one.overturn_time - 1.0)
    tilt = abs(other.peak_tilt - one.peak_tilt) / max(one.peak_tilt, 1e-2)
    slide = abs(other.residual_slide - one.residual_slide) / max(abs(one.residual_slide), 1e-2)
    return max(tilt, slide)


def settled(seed: int, count: int) -> tuple[list[tuple[BesidePlane, Answer]], int]:
    """Return cases that are not chaotic with the planar answers, and how many were drawn for them."""
    found: list[tuple[BesidePlane, Answer]] = []
    drawn = 0
    for case in draw(seed):
        drawn += 1
        answer = in_the_plane(case)
        factors = [1.0 + sign * share for share in SHARES for sign in (-1, 1)]
        others = [in_the_plane(case, shaking=factor) for factor in factors]
        others += [in_the_plane(case, friction=factor) for factor in factors]
        if all(difference(answer, other) <= SAME for other in others):
            found.append((case, answer))
        if len(found) == count:
            break
    return found, drawn


def mode(answer: Answer) -> str:
    """Name what a body did."""
    if answer.overturned:
        return "falls"
    if answer.peak_tilt > 1e-3:
        return "rocks"
    return "slides" if abs(answer.residual_slide) > 1e-6 else "rests"


def table(cases: list[tuple[BesidePlane, Answer]], errors: NDArray[np.float64]) -> None:
    """Print the quantiles of the errors, shape (cases, steps), of all cases and by kind and mode."""
    names = np.array([[case.kind, mode(answer)] for case, answer in cases])
    groups = [("all", np.ones(len(cases), np.bool_))]
    groups += [(name, names[:, column] == name) for column in (0, 1) for name in np.unique(names[:, column])]
    print("| cases | number | step [s] | median | 90 % | 95 % | largest | within 1 % | other outcome |")
    print("| :-- | --: | --: | --: | --: | --: | --: | --: | --: |")
    for name, group in groups:
        for step, column in zip(STEPS, errors[group].T, strict=True):
            quantiles = (f"{value:.1e}" for value in np.quantile(column, (0.5, 0.9, 0.95), method="lower"))
            largest = column[np.isfinite(column)].max()
            within, other = np.mean(column <= SAME), int(np.isinf(column).sum())
            print(
                f"| {name} | {len(column)} | {step:g} | {' | '.join(quantiles)} | {largest:.1e}"
                f" | {100.0 * within:.1f} % | {other} |"
            )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    cases, drawn = settled(chosen.seed, chosen.cases)
    print(f"{len(cases)} cases that are not chaotic, of {drawn} drawn (seed {chosen.seed})\n")
    errors = np.empty((len(cases), len(STEPS)))
    began = time.process_time()
    for row, (case, answer) in zip(errors, cases, strict=True):
        row[:] = [difference(answer, in_space(case, step)) for step in STEPS]
    table(cases, errors)
    print(f"\n{time.process_time() - began:.0f} s of one core; the worst at {STEPS[-1]:g} s:")
    for k in np.argsort(-errors[:, -1])[:8]:
        case, answer = cases[k]
        size = f"{case.body.width:.3f} × {case.body.height:.3f} m"
        print(f"  {np.array2string(errors[k], precision=4)} {case.kind}, {mode(answer)}, {size}")


if __name__ == "__main__":
    main()
