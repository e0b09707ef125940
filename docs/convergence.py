"""How the error falls with the step, through events, and what accuracy costs: computed and drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np

import stayput as sp
import workload
from stayput.mechanics.runner import Traced, shaking, trace
from stayput.model.flat_fields import case_columns
from stayput.model.state import State

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

G = 9.81
STEPS = (0.2, 0.1, 0.05, 0.025, 0.0125)
NO_TOLERANCE = 1e300
FINEST = {"tolerance": 1e-15, "max_step": 1e-3}
SAMPLINGS = (0.1, 0.01)
"""Steps of the record in the work–precision table [s]; it is linear between the samples of the first."""

TOLERANCES = (1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14)
OVERTURNED = list(sp.Outcome).index(sp.Outcome.OVERTURNED)


@dataclass(frozen=True, slots=True)
class Curve:
    """Errors of an event's time, one for each of `STEPS` [s]."""

    name: str
    errors: tuple[float, ...]

    @property
    def order(self) -> float:
        """Slope of the least-squares line through the logarithms."""
        return float(np.polyfit(np.log(STEPS), np.log(self.errors), 1)[0])


def _curve(
    name: str, event: int, friction: float, samples: NDArray[np.float64], dt: float, tilt: float
) -> Curve:
    body, room = sp.Body(0.4, 1.6, 100.0), sp.Room(sp.Floor(friction, friction))
    case = case_columns(body, room, State(tilt=tilt), G)[0]

    def run(**settings: float) -> Traced:
        return trace(case, shaking(samples, None, dt, 0), **settings)

    true = run(**FINEST).events[event].time
    found = (run(tolerance=NO_TOLERANCE, max_step=h).events[event].time for h in STEPS)
    return Curve(name, tuple(abs(time - true) for time in found))


def curves() -> list[Curve]:
    """Run the three problems; their records have few samples, so that the step alone limits the error."""
    shake = 0.6 * np.array([0.0, 4.0, -6.0, 5.0, -3.0, 6.0, -4.0, 2.0, -1.0, 0.0, 0.0, 0.0, 0.0])
    return [
        _curve("free rocking, fifth impact", 4, 3.0, np.zeros(20), 0.5, math.atan(0.25) / 2),
        _curve("forced rocking, fifth impact", 5, 3.0, shake, 0.5, 0.0),
        _curve("slide-rock, stick and slip again", 1, 0.3, np.full(4, 0.6 * G), 0.3, 0.0),
    ]


def plot(found: list[Curve], path: Path) -> None:
    """Draw the errors over the step, and a line of slope 4 to compare with."""
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for curve, marker in zip(found, "os^", strict=True):
        label = f"{curve.name} (order {curve.order:.1f})"
        axes.loglog(STEPS, curve.errors, marker=marker, markersize=5, linewidth=1.2, label=label)
    h = np.array([STEPS[-1], STEPS[0]])
    guide = 3.0 * max(curve.errors[0] for curve in found) * (h / h[1]) ** 4
    axes.loglog(h, guide, "k--", linewidth=0.8, label="slope 4")
    axes.set_xticks(STEPS, [f"{step:g}" for step in STEPS])
    axes.minorticks_off()
    axes.set_xlabel("step [s]")
    axes.set_ylabel("error of the event's time [s]")
    axes.grid(visible=True, which="major", linewidth=0.4, alpha=0.5)
    axes.legend(fontsize="small", frameon=False)
    figure.savefig(path)
    plt.close(figure)


def work_precision(cases: int = 1000) -> list[tuple[float, float, float, float, float, int, float]]:
    """Run mixed cases at several tolerances, under a record that is sampled coarsely and finely.

    Returns the step of the record [s], the tolerance [rad], the median, 99 % and largest error of the peak
    tilt of those that rock and stand [rad], the flipped verdicts, and the cases per second and core.
    """
    coarse = sp.near_fault().component("x").resampled(SAMPLINGS[0])
    table = workload.columns(workload.mixed(cases))
    rows: list[tuple[float, float, float, float, float, int, float]] = []
    for step in SAMPLINGS:
        motion = coarse.resampled(step)  # linear between samples, so the same motion
        exact = workload.timed(table, motion, repeats=1, **workload.EXACT).results
        for tolerance in TOLERANCES:
            run = workload.timed(table, motion, repeats=3, tolerance=tolerance)
            fell, falls = run.results["outcome"] == OVERTURNED, exact["outcome"] == OVERTURNED
            rocked = ~fell & ~falls & (exact["peak_tilt"] > 0.0)
            off = np.abs(run.results["peak_tilt"] - exact["peak_tilt"])[rocked]
            half, most, worst = (float(q) for q in np.quantile(off, (0.5, 0.99, 1.0)))
            rows.append((step, tolerance, half, most, worst, int((fell != falls).sum()), run.rate))
    return rows
