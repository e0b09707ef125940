"""Coverage of the 95 % intervals of a probability, and their width, where the truth is known.

Of each motion a share of the draws falls: Φ((Φ⁻¹(p) + √ρ z) / √(1 − ρ)) with z standard normal, p in the mean
(Vasicek's distribution). Beside the interval in use stand others that were tried, and the one of somebody who
knows the design effect.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from scipy.special import betaincinv, ndtr, ndtri

from stayput.fragility.probabilities import design_effect, probability_of_counts, student, wilson
from stayput.uncertainty import random_bits, uniforms
from studies.study import COLOURS, Quantity, Study, panels, span

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    Interval = Callable[[NDArray[np.float64], int], tuple[float, float]]

CORRELATIONS = (0.3, 0.7)
"""ρ: how alike the draws of a motion are; 0.7 is of motions that decide nearly alone."""

LEAST = 0.94
"""Coverage below which an interval of 95 % is not adopted."""


def shares_of(p: float, rho: float, z: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the share that falls of each motion."""
    return ndtr((ndtri(p) + np.sqrt(rho) * z) / np.sqrt(1.0 - rho))


def in_use(fell: NDArray[np.float64], draws: int) -> tuple[float, float]:
    """Return the interval that verdicts have."""
    chance = probability_of_counts(fell, np.full(len(fell), draws))
    return chance.low, chance.high


def with_weight(weight: float, units: int) -> Interval:
    """Return Wilson's interval with another shrinkage, and Student's t of units beside the motions."""

    def interval(fell: NDArray[np.float64], draws: int) -> tuple[float, float]:
        runs = len(fell) * draws
        independent = runs / design_effect(fell, np.full(len(fell), float(draws)), weight)
        return wilson(float(fell.sum()) / runs * independent, independent, student(len(fell) + units))

    return interval


def jeffreys(fell: NDArray[np.float64], draws: int) -> tuple[float, float]:
    """Return Jeffreys's interval on the effective number of runs, corrected by t (Korn and Graubard 1998)."""
    runs, motions = len(fell) * draws, len(fell)
    independent = runs / design_effect(fell, np.full(motions, float(draws)))
    independent *= (student(10**9) / student(motions)) ** 2
    k = float(fell.sum()) / runs * independent
    low = 0.0 if k <= 0.0 else float(betaincinv(k + 0.5, independent - k + 0.5, 0.025))
    return low, 1.0 if k >= independent else float(betaincinv(k + 0.5, independent - k + 0.5, 0.975))


NORMAL = 10**6
"""So many units that Student's t is normal."""

TRIED: dict[str, Interval] = {
    "in use": in_use,
    "normal quantile": with_weight(1.0, NORMAL),
    "half the shrinkage": with_weight(0.5, 2),
    "a tenth of the shrinkage": with_weight(0.1, 2),
    "Jeffreys, t of the motions alone": jeffreys,
}
"""The interval in use, and others."""


def interval_coverage(
    studies: int = 1000,
    *,
    motions: Sequence[int] = (8, 20, 40),
    draws: Sequence[int] = (1, 2, 10),
    probabilities: Sequence[float] = (0.02, 0.05, 0.1, 0.25, 0.5),
    seed: int = 1,
) -> Study:
    """Count how often 95 % intervals hold the truth, and compare their widths with what could be known.

    Parameters
    ----------
    studies : int
        Studies of each cell, each with other motions and draws.
    motions, draws : sequence of int
        Motions of a study, and draws of each.
    probabilities : sequence of float
        True probabilities.
    seed : int
        Seed of the draws.
    """
    cells = list(product(motions, draws, CORRELATIONS, probabilities))
    names, nodes = list(TRIED), ndtri((np.arange(2000) + 0.5) / 2000.0)
    held, width = np.zeros((2, len(names), len(cells)))
    for number, (count, each, rho, p) in enumerate(cells):
        bits = random_bits(seed, number)
        z = ndtri(uniforms(bits.random_raw(studies * count))).reshape(studies, count, 1)
        falls = uniforms(bits.random_raw(studies * count * each)).reshape(studies, count, each)
        fell = (falls < shares_of(p, rho, z)).sum(axis=2).astype(np.float64)
        known = 1.0 + (each - 1.0) * float(np.var(shares_of(p, rho, nodes))) / (p * (1.0 - p))
        independent = count * each / known
        ends = [wilson(float(k.sum()) / (count * each) * independent, independent) for k in fell]
        could_be = float(np.mean([high - low for low, high in ends]))
        for place, interval in enumerate(TRIED.values()):
            low, high = np.array([interval(k, each) for k in fell]).T
            held[place, number] = np.mean((low <= p) & (p <= high))
            width[place, number] = np.mean(high - low) / could_be
    found = {"coverage": (("interval", "cell"), held), "width": (("interval", "cell"), width)}
    names_of_cell = "motions", "draws", "rho", "probability"
    of_cell = {name: ("cell", row) for name, row in zip(names_of_cell, np.array(cells).T, strict=True)}
    data = xr.Dataset(found, {"interval": names, **of_cell})
    rows = [
        {"interval": name, "motions": count, "least coverage [%]": 100.0 * held[n, of].min()}
        | {"cells below 94 %": f"{(held[n, of] < LEAST).sum()} of {of.sum()}"}
        | {"median coverage [%]": 100.0 * np.median(held[n, of]), "median width": np.median(width[n, of])}
        for n, name in enumerate(names)
        for count in motions
        for of in [np.array([cell[0] == count for cell in cells])]
    ]
    figure, axes = panels(2)
    for axis, values in zip(axes, (100.0 * held, width), strict=True):
        for name, colour, row in zip(names, COLOURS, values, strict=True):
            axis.plot(np.sort(row), label=name, color=colour)
    axes[0].set(xlabel="cells, each interval's in order", ylabel="intervals that hold the truth [%]")
    axes[1].set(xlabel="cells, each interval's in order", ylabel="width over that of a known effect [–]")
    axes[0].legend(loc="lower right", fontsize="small")
    return Study(
        name="interval_coverage",
        title="Coverage and width of the intervals of a probability",
        quantities={
            "coverage": Quantity("Coverage of the interval in use [%]", span(100.0 * held[0], ".1f"), "95"),
            "median": Quantity("Its median [%]", 100.0 * float(np.median(held[0])), 95.0, ".1f"),
            "width": Quantity("Its width over that of a known design effect", span(width[0]), "1"),
            "usual_width": Quantity("Median of these ratios", float(np.median(width[0])), 1.0, ".2f"),
            "least": Quantity("Least coverage of the narrowest with t [%]", 100.0 * float(held[3].min())),
        },
        data=data,
        figure=figure,
        tables={"Intervals by the number of motions": pd.DataFrame(rows).round(2)},
    )
