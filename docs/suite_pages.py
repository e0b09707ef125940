"""The tables and figures of the page about suites, from suites that are made as the page is built."""

from __future__ import annotations

from functools import cache, partial
from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np
import validation_run

from stayput.catalogue.names import FAMILIES as NAMES
from stayput.motion.intensity import long_period_response
from stayput.motion.response import mean_period
from stayput.motion.suites.families import FAMILIES, KINDS, MIX
from stayput.motion.suites.synthesis import synthetic_motion, synthetic_suite
from stayput.motion.suites.target import japanese_design

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.motion.suites.suite import Suite

COUNT = 40
suite_of = cache(partial(synthetic_suite, count=COUNT))
"""The suite of a family; each is drawn once."""

PERIODS = np.array([0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0])


def _range(values: tuple[float, float], unit: str = "") -> str:
    low, high = values
    return f"{low:g}{unit}" if low == high else f"{low:g}–{high:g}{unit}"


def _plain(value: float) -> str:
    """Write a number to two digits, without a power."""
    return f"{float(f'{value:.2g}'):g}"


def families() -> str:
    """Return the table of what is drawn for each family."""
    rows = [
        [
            f"`{name}`",
            NAMES[name][1][0],
            _range(kind.magnitudes),
            _range(kind.distances),
            _range(kind.lengths),
            f"{1.0 / kind.low_cut:g}",
            f"{100.0 * MIX[name]:g} %",
        ]
        for name, kind in KINDS.items()
    ]
    heads = [
        "family",
        "stands for",
        "M",
        "distance [km]",
        "length [s]",
        "fades beyond [s]",
        "share of the mix",
    ]
    return validation_run.markdown(heads, rows, "llrrrrr")


def measured() -> str:
    """Return the table of what the families' motions measure: medians, and 5 % and 95 % of the motions."""
    rows = []
    for name in FAMILIES:
        suite = suite_of(name)
        columns = (
            suite.intensities,
            [100.0 * motion.pga for motion in suite],
            [100.0 * motion.pgv for motion in suite],
            [motion.pgv / motion.pga for motion in suite],
            [motion.significant_duration for motion in suite],
            [mean_period(motion.x, motion.dt) for motion in suite],
            [long_period_response(motion.x, motion.y, motion.dt) for motion in suite.to_intensity(6.0)],
        )
        cells = [np.percentile(values, (50, 5, 95)) for values in columns]
        rows.append([f"`{name}`", *(f"{_plain(m)} ({_plain(low)}–{_plain(high)})" for m, low, high in cells)])
    heads = [
        "family",
        "JMA intensity",
        "PGA [cm/s²]",
        "PGV [cm/s]",
        "PGV/PGA [s]",
        "D5–95 [s]",
        "Tm [s]",
        "Sva at intensity 6 [m/s]",
    ]
    return validation_run.markdown(heads, rows, "lrrrrrrr")


def scatter() -> str:
    """Return the table of the standard deviation of ln Sa, as drawn and scaled to an intensity."""
    rows = []
    for name in ("mixed", *FAMILIES):
        suite = suite_of(name)
        for label, one in (("as drawn", suite), ("at one intensity", suite.to_intensity(6.0))):
            rows.append([f"`{name}`", label, *(f"{sigma:.2f}" for sigma in one.log_std(PERIODS))])
    return validation_run.markdown(
        ["suite", "", *(f"{t:g} s" for t in PERIODS)], rows, "ll" + "r" * len(PERIODS)
    )


def matching() -> str:
    """Return the table of how near suites come to a target over its band."""
    target, rows = japanese_design(), []
    suite = suite_of("mixed")
    for label, one in (
        ("one factor a motion (`to_spectrum`)", suite.to_spectrum(target)),
        ("every motion matched (`matched`)", suite.matched(target)),
        ("matched together, after `to_spectrum`", suite.to_spectrum(target).matched(target, together=True)),
    ):
        off, sigma = one.deviation(target), one.log_std(np.geomspace(0.1, 5.0, 52))
        rows.append(
            [
                label,
                f"{100.0 * off.mean:.1f} %",
                f"{100.0 * off.worst:.1f} % at {off.worst_period:.2g} s",
                f"{sigma.min():.2f}–{sigma.max():.2f}",
                f"{np.median([motion.pgd for motion in one]):.2f}",
            ]
        )
    heads = ["", "median off, mean", "worst", "σ of ln Sa", "median PGD [m]"]
    return validation_run.markdown(heads, rows, "lrrrr")


def plot_families(path: Path) -> None:
    """Plot acceleration and velocity of x of the second synthetic motion of every family, with seed 1."""
    figure, axes = plt.subplots(len(FAMILIES), 2, figsize=(9.6, 8.4), layout="constrained")
    for (left, right), family in zip(axes, FAMILIES, strict=True):
        motion = synthetic_motion(family, 2, 1)
        left.plot(motion.time, motion.x, linewidth=0.7)
        right.plot(motion.time, 100.0 * motion.velocity, linewidth=0.7)
        left.set(title=motion.name, ylabel="acceleration [m/s²]", xlim=(0.0, motion.duration))
        right.set(ylabel="velocity [cm/s]", xlim=(0.0, motion.duration))
    for axis in axes[-1]:
        axis.set_xlabel("time [s]")
    figure.savefig(path, dpi=120)
    plt.close(figure)


def write(folder: Path) -> None:
    """Write the tables ``suite_*.md`` and the figures ``suite_*.png`` into a folder."""
    for make in (families, measured, scatter, matching):
        (folder / f"suite_{make.__name__}.md").write_text(make(), encoding="utf-8")
    target = japanese_design()
    mixed: Suite = suite_of("mixed")
    plot_families(folder / "suite_motions.png")
    mixed.to_intensity(6.0).figure().savefig(folder / "suite_intensity.png")
    together = mixed.to_spectrum(target).matched(target, together=True)
    together.figure(target=target).savefig(folder / "suite_together.png")
    mixed.matched(target).figure(target=target).savefig(folder / "suite_matched.png")
