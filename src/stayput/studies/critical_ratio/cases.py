"""The cases of the critical-ratio study: a table with a row for each, and their critical amplitudes."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd

from stayput.body import Body
from stayput.motion import sine
from stayput.motion.units import STANDARD_GRAVITY
from stayput.room import Floor, Room
from stayput.simulation import LAWS, Case, Contact
from stayput.studies.critical_ratio.first_overturning import first_overturning
from stayput.studies.critical_ratio.fit import EQUATION_4_1, regression

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from stayput.motion import Motion

STICKING = 3.0
"""A coefficient of friction at which no corner slips: rocking only."""

LARGEST = 14.0
"""Largest amplitude that is run, in g·b/h; the smallest is g·b/h, at which the body just does not rise."""

SAMPLES = 100
"""Time steps in a wave."""

HEIGHTS = (0.5, 1.0, 2.0)
"""Sizes of the scale-free form, in the study's height."""

RESTITUTIONS, PHASES = (0.3, 0.6, 0.9, 1.0), (0.0, 45.0, 90.0, 135.0)
"""What the influences vary: e [–] and the sine's phase [°]."""

SWAY = ((1.5, 1.5), (1.15, 1.15), (0.6, 1.2))
"""Friction that lets the body slide too: μ = μ' of the base and of a corner, in b/h.

The last is like the paper's Table 4.2, with more friction under the corner than under the base.
"""


@dataclass(frozen=True, slots=True)
class Conditions:
    """What one critical amplitude is found for; sizes in m, phase in degrees, duration in s.

    ``part`` is what the case is for: ``main``, ``size``, ``restitution``, ``phase`` or ``sway``.
    """

    ratio: float = 0.3
    frequency: float = 1.0
    height: float = 1.4
    restitution: float = 0.3
    phase: float = 90.0
    duration: float = 10.0
    friction: float = STICKING
    corner_friction: float = STICKING
    contact: Contact = "paper"
    part: str = "main"


def rows_of(table: pd.DataFrame, **wanted: float | str) -> pd.DataFrame:
    """Return the rows that have these values in these columns."""
    chosen = np.ones(len(table), np.bool_)
    for column, value in wanted.items():
        chosen &= table[column].to_numpy() == value
    return table[chosen]


def all_conditions(
    base: Conditions, ratios: NDArray[np.float64], frequencies: NDArray[np.float64]
) -> Iterator[Conditions]:
    """Give the conditions of all parts of the study.

    The parts but the first are at the middle ratio; that of the sizes is at three ratios, at frequencies and
    durations that go with √(1/h), so that ωt and ω/p are those of the study's height.
    """
    middle = float(ratios[len(ratios) // 2])
    for f in frequencies.tolist():
        for ratio in ratios.tolist():
            yield replace(base, ratio=ratio, frequency=f)
        for ratio in sorted({float(ratios[0]), middle, float(ratios[-1])}):
            for size in HEIGHTS:
                slower = math.sqrt(size)
                yield replace(
                    base,
                    ratio=ratio,
                    height=size * base.height,
                    frequency=f / slower,
                    duration=base.duration * slower,
                    part="size",
                )
        at = replace(base, ratio=middle, frequency=f)
        for e in RESTITUTIONS:
            yield replace(at, restitution=e, part="restitution")
        for phase in PHASES:
            yield replace(at, phase=phase, part="phase")
        for law in LAWS[::-1]:
            yield replace(at, contact=law, part="sway")
            for base_mu, corner_mu in SWAY:
                mu = {"friction": base_mu * middle, "corner_friction": corner_mu * middle}
                yield replace(at, **mu, contact=law, part="sway")  # type: ignore[arg-type]


@lru_cache(maxsize=1024)
def _motion(frequency: float, phase: float, duration: float) -> Motion:
    return sine(1.0, frequency, duration, math.radians(phase), dt=1.0 / (SAMPLES * frequency))


def critical_amplitudes(conditions: list[Conditions], step: float) -> pd.DataFrame:
    """Find the critical amplitudes of conditions, of amplitudes a ``step`` [g·b/h] apart.

    Returns
    -------
    DataFrame
        A row for each: the fields of `Conditions`; ``critical``, the first amplitude that turns the body over
        [m/s²], NaN where none does; ``last_safe`` [m/s²] and ``safe_share``, of `Edges`; ``eq_4_1`` [m/s²],
        the paper's; ``omega_over_p``, 2πf/√(3g/4R), and ``scaled``, ``critical`` in g·b/h.
    """
    table = pd.DataFrame([asdict(row) for row in conditions])
    ratio, height, frequency = (table[name].to_numpy() for name in ("ratio", "height", "frequency"))
    motions = [_motion(row.frequency, row.phase, row.duration) for row in conditions]
    columns = {
        "body.width": ratio * height,
        "body.height": height,
        "room.floor.static_friction": table["friction"].to_numpy(),
        "room.floor.kinetic_friction": table["friction"].to_numpy(),
        "room.floor.edge_static_friction": table["corner_friction"].to_numpy(),
        "room.floor.edge_kinetic_friction": table["corner_friction"].to_numpy(),
        "room.floor.restitution": table["restitution"].to_numpy(),
        "contact": [row.contact for row in conditions],
        "motion": motions,
    }
    case = Case(Body(0.4, 1.4), Room(Floor(STICKING, STICKING)), motions[0])
    unit = STANDARD_GRAVITY * ratio
    scales = np.arange(1.0, LARGEST + 0.5 * step, step)
    edges = first_overturning(case, columns, unit[:, None] * scales)
    p = np.sqrt(0.75 * STANDARD_GRAVITY / (0.5 * height * np.hypot(1.0, ratio)))
    return table.assign(
        critical=edges.first,
        last_safe=edges.last_safe,
        safe_share=edges.safe_share,
        eq_4_1=regression(EQUATION_4_1, ratio, frequency),
        omega_over_p=2.0 * math.pi * frequency / p,
        scaled=edges.first / unit,
    )
