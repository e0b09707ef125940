"""The tables and the figure of the page about intervals: studies repeated as the page is built."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np
import validation_run
from interval_coverage import (
    CHANGE,
    DESIGNS,
    FAMILIES,
    PROBABILITY,
    QUANTITIES,
    RARE,
    SHARES,
    Coverage,
    Falls,
    Population,
    coverage,
)

import stayput as sp
from stayput.measures import MEASURES
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.motion.suites.synthesis import synthetic_suite
from stayput.uncertainty import uniforms

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

STUDIES = 300
"""Studies of each design: a share of 95 % is then known to ± 2.5 points."""

MOTIONS, DRAWS = 120, 10
"""Size of the simulated population."""

HERE, WEAK = 5.95, 5.75
"""Intensities at which falls are counted in it."""

LEVELS = np.linspace(5.15, 6.95, 10)
"""Intensities at which all of it was run; a study has those at, 0.4 below and 0.4 above `HERE`."""

_OF_STUDY = slice(2, 7, 2)

HEADS = {
    PROBABILITY: "probability",
    RARE: "small probability",
    CHANGE: "difference",
    **{name: f"intensity at which {name[1:]} % fall" for name in QUANTITIES[3:]},
}
"""What each quantity is called on the page."""

COLOURS = ("#0072b2", "#d55e00", "#009e73")


@dataclass(frozen=True)
class Simulated:
    """A population of simulated runs, of a cabinet without and with its heavy things at the bottom.

    A study draws motions, and draws of each, with replacement; the truth is that of all runs.
    """

    name: str = "simulated runs"

    @property
    def levels(self) -> NDArray[np.float64]:
        """JMA intensities of the curve."""
        return LEVELS[_OF_STUDY]

    @cached_property
    def runs(self) -> Falls:
        """Falls of all motions and draws."""
        body, room = sp.Body(0.40, 1.60, 80.0), sp.Room(floor=sp.Floor.of("wood flooring"))
        scaled_motions = ScaledMotions(synthetic_suite(count=MOTIONS, seed=11))
        drawn = draws(MOTIONS, DRAWS, 3)
        sets = (), (MEASURES["lower_shelves"](),)
        bare, held = (rows_of(body, room, measures, drawn, 9.81) for measures in sets)

        def fell(intensity: float) -> NDArray[np.bool_]:
            return run_level([bare], scaled_motions.at(intensity))[0].overturned.reshape(MOTIONS, DRAWS)

        without, with_it = (
            runs.overturned.reshape(MOTIONS, DRAWS)
            for runs in run_level([bare, held], scaled_motions.at(HERE))
        )
        by_level = np.stack([fell(float(level)) for level in LEVELS])
        return Falls(by_level, without, with_it, fell(WEAK))

    def truth(self) -> dict[str, float]:
        """Return the true value of each of `QUANTITIES`."""
        runs = self.runs
        bare = float(runs.bare.mean())
        shares = np.maximum.accumulate(runs.by_level.mean(axis=(1, 2)))
        capacities = (float(np.interp(share, shares, LEVELS)) for share in SHARES)
        change = float(runs.held.mean()) - bare
        return dict(zip(QUANTITIES, (bare, float(runs.rare.mean()), change, *capacities), strict=True))

    def draw(self, motions: int, samples: int, bits: np.random.PCG64) -> Falls:
        """Return what falls in a study."""

        def places(count: int, of: int) -> NDArray[np.intp]:
            return (uniforms(bits.random_raw(count)) * of).astype(np.intp)

        motion = places(motions, MOTIONS)[:, np.newaxis]
        draw = places(motions * samples, DRAWS).reshape(motions, samples)
        runs = self.runs
        by_level, bare, held, rare = (
            fell[..., motion, draw] for fell in (runs.by_level[_OF_STUDY], runs.bare, runs.held, runs.rare)
        )
        return Falls(by_level, bare, held, rare)


def populations() -> list[Population]:
    """Return the synthetic families and the simulated runs."""
    return [*FAMILIES, Simulated()]


Found = dict[tuple[str, tuple[int, int]], Coverage]


def truths(of: list[Population]) -> str:
    """Return the table of what is true of each population."""
    rows: list[list[str]] = []
    for one in of:
        true = one.truth()
        percents = [f"{100.0 * true[name]:.1f}".replace("-", "−") for name in QUANTITIES[:3]]
        rows.append([one.name, *percents, *(f"{true[name]:.2f}" for name in QUANTITIES[3:])])
    heads = [f"{HEADS[name]} [%]" for name in QUANTITIES[:2]]
    heads += ["difference [points]", *(HEADS[name] for name in QUANTITIES[3:])]
    return validation_run.markdown(["population", *heads], rows, "lrrrrr")


def held(found: Found) -> str:
    """Return the table of the shares of intervals that hold the truth."""
    rows = [
        [name, f"{design[0]} × {design[1]}", *(f"{100.0 * one.held[q]:.1f}" for q in QUANTITIES)]
        for (name, design), one in found.items()
    ]
    heads = ["population", "motions × draws", *(HEADS[name] for name in QUANTITIES)]
    return validation_run.markdown(heads, rows, "lrrrrrr")


def clear(found: Found) -> str:
    """Return the table of how often the difference is called clear."""
    rows = [
        [name, f"{design[0]} × {design[1]}", f"{100.0 * one.clear:.0f}", f"{100.0 * one.at_best:.0f}"]
        for (name, design), one in found.items()
    ]
    heads = ["population", "motions × draws", "called clear [%]", "standard error known [%]"]
    return validation_run.markdown(heads, rows, "lrrr")


def plot(found: Found, path: Path) -> None:
    """Draw the shares that hold, by quantity, a row of dots for each population and design."""
    names = list(dict.fromkeys(name for name, _ in found))
    figure, axes = plt.subplots(figsize=(7.6, 4.2), layout="constrained")
    axes.axvspan(93.0, 97.0, color="#dfe6ec", linewidth=0.0)
    axes.axvline(95.0, color="#52606d", linewidth=0.8)
    for (name, design), one in found.items():
        place = names.index(name)
        offset = 0.22 * (DESIGNS.index(design) - 1) + 0.05 * (place - 1)
        axes.plot(
            [100.0 * one.held[q] for q in QUANTITIES],
            np.arange(len(QUANTITIES)) + offset,
            linestyle="none",
            marker="os^"[DESIGNS.index(design)],
            markersize=6,
            color=COLOURS[place],
            markerfacecolor="white",
            label=f"{name}, {design[0]} × {design[1]}",
        )
    axes.set_yticks(np.arange(len(QUANTITIES)), [HEADS[q] for q in QUANTITIES])
    axes.invert_yaxis()
    axes.set_xlim(89.0, 100.5)
    axes.set_xlabel("95 % intervals that hold the truth [%]")
    axes.grid(visible=True, axis="x", linewidth=0.4, alpha=0.5)
    figure.legend(loc="outside lower center", ncols=3, fontsize="small", frameon=False)
    figure.savefig(path)
    plt.close(figure)


def write(folder: Path) -> None:
    """Repeat the studies; write tables and figure."""
    of = populations()
    found = {(one.name, design): coverage(one, *design, STUDIES, seed=5) for one in of for design in DESIGNS}
    (folder / "calibration_truths.md").write_text(truths(of), encoding="utf-8")
    (folder / "calibration_held.md").write_text(held(found), encoding="utf-8")
    (folder / "calibration_clear.md").write_text(clear(found), encoding="utf-8")
    plot(found, folder / "calibration.svg")
