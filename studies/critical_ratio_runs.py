"""The cases of the critical-ratio study, their critical amplitudes, and the form of Eq. 4.1 fitted to them.

Overturning is not monotonic in amplitude, so a bisection from any two amplitudes can end on any edge. Here
all amplitudes of a grid are run and the first that overturns is refined; the safe islands above it are
reported as well.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from stayput.model.body import Body
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.motion import sine
from stayput.simulation.case import Case
from stayput.simulation.many import simulate_many
from stayput.simulation.run import LAWS, Contact

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

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

PARTS, ROUNDS = 8, 4
"""Each round of refinement splits a bracket in these parts: the edge is known to 8⁻⁴ of the grid's step."""

EQUATION_4_1 = (6.8983, 1.227, -1.6468, 0.8758)
"""The paper's c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²] (Eq. 4.1)."""

CONFIDENCE = 0.95
"""Level of the confidence intervals."""


@dataclass(frozen=True, slots=True)
class Conditions:
    """Conditions of one critical amplitude; sizes in m, phase in degrees, duration in s.

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
    """Yield the conditions of all parts of the study.

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
                scaled = replace(base, height=size * base.height, duration=base.duration * slower)
                yield replace(scaled, ratio=ratio, frequency=f / slower, part="size")
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
    floor = {
        "static_friction": "friction",
        "kinetic_friction": "friction",
        "edge_static_friction": "corner_friction",
        "edge_kinetic_friction": "corner_friction",
        "restitution": "restitution",
    }
    columns = {f"room.floor.{name}": table[column].to_numpy() for name, column in floor.items()}
    columns |= {"body.width": ratio * height, "body.height": height, "motion": motions}
    columns["contact"] = [row.contact for row in conditions]
    case = Case(Body(0.4, 1.4, 100.0), Room(Floor(STICKING, STICKING)), motions[0])
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


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """Overturning amplitudes of cases; each of shape [cases].

    Attributes
    ----------
    first : ndarray
        Smallest factor on the motion that overturns; NaN where none of the grid does.
    last_safe : ndarray
        Largest factor of the grid that does not overturn, islands included.
    safe_share : ndarray
        Share of the grid's factors from the first on that do not overturn: the islands.
    """

    first: NDArray[np.float64]
    last_safe: NDArray[np.float64]
    safe_share: NDArray[np.float64]


def first_overturning(case: Case, columns: Mapping[str, Any], scales: NDArray[np.float64]) -> Edges:
    """Find the first overturning amplitude of columns of cases.

    Parameters
    ----------
    case : Case
        What no column changes.
    columns : mapping of str to sequence, each of length n
        As for `stayput.simulate_many`.
    scales : ndarray, shape (n, k)
        Rising factors on the motion, for each case; at the first the body must stand.

    Returns
    -------
    Edges
        The edge is the first of the grid: an overturning band narrower than a step may be passed over, and
        edges of rocking can be ragged at every scale.
    """
    over = _overturned(case, columns, scales)
    turns = over.any(axis=1)
    place = np.maximum(over.argmax(axis=1), 1)
    rows = np.arange(len(scales))
    since = np.logical_or.accumulate(over, axis=1)
    islands = np.sum(since & ~over, axis=1) / np.maximum(1, np.sum(since, axis=1))
    low, high = scales[rows, place - 1], scales[rows, place]
    for _ in range(ROUNDS):
        inner = np.linspace(low, high, PARTS + 1, axis=1)
        over_inner = _overturned(case, columns, inner[:, 1:-1])
        step = np.where(over_inner.any(axis=1), over_inner.argmax(axis=1), PARTS - 1)
        low, high = inner[rows, step], inner[rows, step + 1]
    return Edges(
        first=np.where(turns, 0.5 * (low + high), np.nan),
        last_safe=np.where(over, -np.inf, scales).max(axis=1),
        safe_share=np.where(turns, islands, np.nan),
    )


def _overturned(case: Case, columns: Mapping[str, Any], scales: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether cases turn over at some scales each, shape [n, k]."""
    count, per_case = scales.shape
    repeated = {name: [v for v in values for _ in range(per_case)] for name, values in columns.items()}
    results = simulate_many(case, {**repeated, "motion.scale": scales.ravel()}, progress=False)
    return results["overturned"].reshape(count, per_case)


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """A fit of S₁ = c₁ exp(c₂ S₂) (b/h) + c₃ S₂ + c₄.

    Attributes
    ----------
    coefficients : ndarray, shape (4,)
        c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²].
    half_widths : ndarray, shape (4,)
        Half widths of their 95 % confidence intervals.
    residuals : ndarray, shape (n,)
        Values less the fit, relative to the value.
    """

    coefficients: NDArray[np.float64]
    half_widths: NDArray[np.float64]
    residuals: NDArray[np.float64]


def regression(
    coefficients: NDArray[np.float64] | tuple[float, ...],
    ratio: NDArray[np.float64],
    frequency: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return S₁ = c₁ exp(c₂ S₂) (b/h) + c₃ S₂ + c₄ [m/s²].

    Parameters
    ----------
    coefficients : array_like, shape (4,)
        c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²].
    ratio : ndarray
        b/h [–].
    frequency : ndarray
        S₂ [Hz].
    """
    c1, c2, c3, c4 = coefficients
    return c1 * np.exp(c2 * frequency) * ratio + c3 * frequency + c4


def fitted(
    ratio: NDArray[np.float64],
    frequency: NDArray[np.float64],
    amplitude: NDArray[np.float64],
    *,
    relative: bool = True,
) -> Fit:
    """Fit the form of Eq. 4.1 by least squares.

    The confidence intervals are those of the linearised problem: t-quantile times the standard error from
    s²(JᵀJ)⁻¹, J the residuals' Jacobian. They hold for independent errors of one size, which residuals of a
    form that does not quite fit are not.

    Parameters
    ----------
    ratio, frequency, amplitude : ndarray, shape (n,)
        b/h [–], S₂ [Hz], S₁ [m/s²]; n > 4, all finite, S₁ above zero.
    relative : bool
        Whether the squares are of relative residuals, so that small amplitudes count as much as large ones,
        or of absolute ones.
    """
    from scipy.optimize import least_squares  # pyright: ignore[reportUnknownVariableType]
    from scipy.stats import t

    weight = 1.0 / amplitude if relative else np.ones_like(amplitude)

    def off(c: NDArray[np.float64]) -> NDArray[np.float64]:
        return weight * (regression(c, ratio, frequency) - amplitude)

    solved: Any = least_squares(  # pyright: ignore[reportUnknownVariableType]
        off,
        EQUATION_4_1,
        jac=lambda c: weight[:, None] * _jacobian(c, ratio, frequency),  # type: ignore[arg-type]
        x_scale="jac",
        xtol=1e-12,
    )
    free = len(amplitude) - 4
    coefficients = np.asarray(solved.x, np.float64)
    J = weight[:, None] * _jacobian(coefficients, ratio, frequency)
    variance = np.sum(off(coefficients) ** 2) / free
    errors = np.sqrt(np.diag(np.linalg.inv(J.T @ J)) * variance)
    half_widths = float(t.ppf(0.5 + CONFIDENCE / 2.0, free)) * errors
    return Fit(coefficients, half_widths, 1.0 - regression(coefficients, ratio, frequency) / amplitude)


def _jacobian(
    coefficients: NDArray[np.float64], ratio: NDArray[np.float64], frequency: NDArray[np.float64]
) -> NDArray[np.float64]:
    c1, c2 = coefficients[:2]
    grown = np.exp(c2 * frequency) * ratio
    return np.column_stack((grown, c1 * frequency * grown, frequency, np.ones_like(frequency)))
