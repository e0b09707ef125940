"""The critical amplitude of a sine over aspect ratio and frequency (the paper, §4.3 and Eq. 4.1).

Overturning is not monotonic in amplitude, so a bisection from any two amplitudes can end on any edge. Here
all amplitudes of a grid are run and the first that overturns is refined; the safe islands above it are
reported as well.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib import colormaps
from scipy.optimize import curve_fit  # pyright: ignore[reportUnknownVariableType]
from scipy.stats import t

from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.motion.synthetic import sine
from stayput.report.palette import INK
from stayput.simulation.case import Case
from stayput.simulation.many import simulate_many
from stayput.simulation.run import LAWS, Contact
from studies.study import Quantity, Study, panels

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion.record import Motion

    Array = NDArray[np.float64]

RATIOS, FREQUENCIES = np.round(np.linspace(0.2, 0.6, 9), 3), np.round(np.arange(0.5, 2.01, 0.25), 3)
"""Aspect ratios b/h [–] and frequencies [Hz]."""

STICKING = 3.0
"""A coefficient of friction at which no corner slips: rocking only."""

LARGEST = 14.0
"""Largest amplitude that is run, in g·b/h; the smallest is g·b/h, at which the body just does not rise."""

HEIGHTS, RESTITUTIONS, PHASES = (0.5, 1.0, 2.0), (0.3, 0.6, 0.9, 1.0), (0.0, 45.0, 90.0, 135.0)
"""What the influences vary: size, in the study's height, e [–] and the sine's phase [°]."""

SWAY = ((STICKING, STICKING), (1.5, 1.5), (1.15, 1.15), (0.6, 1.2))
"""Friction that lets the body slide too: μ = μ' of the base and of a corner; but for the first, in b/h.

The last is like the paper's Table 4.2, with more friction under the corner than under the base.
"""

PARTS, ROUNDS = 8, 4
"""Each round of refinement splits a bracket in these parts: the edge is known to 8⁻⁴ of the grid's step."""

EQUATION_4_1 = (6.8983, 1.227, -1.6468, 0.8758)
"""The paper's c₁ [m/s²], c₂ [s], c₃ [m/s²·s], c₄ [m/s²] (Eq. 4.1)."""


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


def all_conditions(base: Conditions, ratios: Array, frequencies: Array) -> Iterator[Conditions]:
    """Yield the conditions of all parts of the study.

    The parts but the first are at the middle ratio; that of the sizes is at frequencies and durations that go
    with √(1/h), so that ωt and ω/p are those of the study's height.
    """
    middle = float(ratios[len(ratios) // 2])
    for f in frequencies.tolist():
        for ratio in ratios.tolist():
            yield replace(base, ratio=ratio, frequency=f)
        at = replace(base, ratio=middle, frequency=f)
        for size in HEIGHTS:
            slower = math.sqrt(size)
            scaled = replace(at, height=size * base.height, duration=base.duration * slower)
            yield replace(scaled, frequency=f / slower, part="size")
        for e in RESTITUTIONS:
            yield replace(at, restitution=e, part="restitution")
        for phase in PHASES:
            yield replace(at, phase=phase, part="phase")
        for law in LAWS:
            for mu, corner in SWAY:
                unit = 1.0 if mu == STICKING else middle
                yield replace(at, friction=mu * unit, corner_friction=corner * unit, contact=law, part="sway")


@lru_cache(maxsize=1024)
def _motion(frequency: float, phase: float, duration: float) -> Motion:
    return sine(1.0, frequency, duration, math.radians(phase), dt=0.01 / frequency)


def critical_amplitudes(conditions: list[Conditions], step: float) -> pd.DataFrame:
    """Find the critical amplitudes of conditions, of amplitudes a ``step`` [g·b/h] apart.

    Returns
    -------
    DataFrame
        A row for each: the fields of `Conditions`; ``first``, the first amplitude that turns the body over
        [m/s²], NaN where none does; ``last_safe`` [m/s²] and ``safe_share`` of `first_overturning`;
        ``eq_4_1`` [m/s²], the paper's; ``omega_over_p``, 2πf/√(3g/4R), and ``scaled``, ``first`` in g·b/h.
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
        **edges,
        eq_4_1=regression((ratio, frequency), *EQUATION_4_1),
        omega_over_p=2.0 * math.pi * frequency / p,
        scaled=edges["first"] / unit,
    )


def first_overturning(case: Case, columns: Mapping[str, Any], scales: Array) -> dict[str, Array]:
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
    dict of str to ndarray, shape (n,)
        ``first``, the smallest factor that overturns (NaN where none does; a band narrower than a step may be
        passed over); ``last_safe``, the largest of the grid that does not; ``safe_share``, the share of the
        grid's factors from the first on that do not: the islands.
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
    return {
        "first": np.where(turns, 0.5 * (low + high), np.nan),
        "last_safe": np.where(over, -np.inf, scales).max(axis=1),
        "safe_share": np.where(turns, islands, np.nan),
    }


def _overturned(case: Case, columns: Mapping[str, Any], scales: Array) -> NDArray[np.bool_]:
    """Return whether cases turn over at some scales each, shape [n, k]."""
    count, per_case = scales.shape
    repeated = {name: [v for v in values for _ in range(per_case)] for name, values in columns.items()}
    results = simulate_many(case, {**repeated, "motion.scale": scales.ravel()}, progress=False)
    return results["overturned"].reshape(count, per_case)


def regression(at: tuple[Array, Array], c1: float, c2: float, c3: float, c4: float) -> Array:
    """Return S₁ = c₁ exp(c₂ S₂) (b/h) + c₃ S₂ + c₄ [m/s²] at (b/h [–], S₂ [Hz])."""
    ratio, frequency = at
    return c1 * np.exp(c2 * frequency) * ratio + c3 * frequency + c4


def fitted(ratio: Array, frequency: Array, amplitude: Array, *, relative: bool = True) -> tuple[Array, Array]:
    """Fit the form of Eq. 4.1 by least squares; return c₁ to c₄ and half widths of their 95 % intervals.

    The intervals are those of the linearised problem. They hold for independent errors of one size, which
    residuals of a form that does not quite fit are not.

    Parameters
    ----------
    ratio, frequency, amplitude : ndarray, shape (n,)
        b/h [–], S₂ [Hz], S₁ [m/s²]; n > 4, all finite, S₁ above zero.
    relative : bool
        Whether the squares are of relative residuals, so that small amplitudes count as much as large ones.
    """
    sigma = amplitude if relative else None
    coefficients, covariance = cast(
        "tuple[Array, Array]",
        curve_fit(regression, (ratio, frequency), amplitude, EQUATION_4_1, sigma, xtol=1e-12),
    )
    return coefficients, float(t.ppf(0.975, len(amplitude) - 4)) * np.sqrt(np.diag(covariance))


def critical_ratio(
    *,
    ratios: ArrayLike = RATIOS,
    frequencies: ArrayLike = FREQUENCIES,
    base: Conditions = Conditions(),
    step: float = 0.02,
) -> Study:
    """Study the critical amplitude of turnover under a sine, as the paper's §4.3.

    Rocking only, under the paper's contact law; the critical amplitude is the first that turns the body over.

    Parameters
    ----------
    ratios, frequencies : array_like
        Aspect ratios b/h [–] and frequencies [Hz]; at least two of each, rising.
    base : Conditions
        Height, restitution, phase and duration.
    step : float
        Step of the amplitudes that are run, in g·b/h; a band of turnover narrower than it may be missed.

    Returns
    -------
    Study
        The data have a row for each critical amplitude.
    """
    b_h, f = np.asarray(ratios, np.float64), np.asarray(frequencies, np.float64)
    table = critical_amplitudes(list(all_conditions(base, b_h, f)), step)
    turned = table[table["part"] == "main"].dropna(subset="first")
    coefficients, half_widths = fitted(*(turned[name].to_numpy() for name in ("ratio", "frequency", "first")))
    at = table["ratio"].to_numpy(), table["frequency"].to_numpy()
    table["fit"] = regression(at, *coefficients)
    data = xr.Dataset.from_dataframe(table.rename_axis("case"))
    for name in ("first", "last_safe", "eq_4_1", "fit"):
        data[name].attrs["units"] = "m/s2"
    return Study(
        name="critical_ratio",
        title="The critical amplitude of turnover under a sine",
        quantities=_quantities(table, coefficients, half_widths),
        data=data,
        figure=_drawn(table, coefficients),
        tables={
            "Mean deviation of our critical amplitudes by frequency [%]": _by_frequency(table),
            "Where the body may slide too: of how many frequencies it turns over, and critical amplitudes "
            "[m/s²]": table[table["part"] == "sway"]
            .groupby(["contact", "friction", "corner_friction"])["first"]
            .agg(["size", "count", "min", "max"])
            .reset_index(),
        },
    )


def _quantities(table: pd.DataFrame, coefficients: Array, half_widths: Array) -> dict[str, Quantity]:
    quantities = {
        f"c{n + 1}": Quantity(f"c{'₁₂₃₄'[n]} of the regression, ± {half_widths[n]:.3f}", ours, paper, ".3f")
        for n, (ours, paper) in enumerate(zip(coefficients.tolist(), EQUATION_4_1, strict=True))
    }
    main, size = table[table["part"] == "main"], table[table["part"] == "size"]
    off = 100.0 * (main["first"] / main["eq_4_1"] - 1.0)
    fit_off = 100.0 * (main["first"] / main["fit"] - 1.0).abs()
    islands = main[main["safe_share"] > 0.0]
    alike = size.assign(at=size["omega_over_p"].round(9)).groupby("at")["scaled"]
    rows: list[tuple[str, str, float, str]] = [
        ("off", "Mean size of the deviation from Eq. 4.1 [%]", off.abs().mean(), ".1f"),
        ("off_worst", "Largest deviation from Eq. 4.1 [%]", off.loc[off.abs().idxmax()], "+.1f"),
        ("fit_off", "Mean size of the deviation from our fit [%]", fit_off.mean(), ".1f"),
        ("fit_worst", "Largest size of the deviation from our fit [%]", fit_off.max(), ".1f"),
        ("never", "Bodies that never turn over", int(off.isna().sum()), "d"),
        ("islands", f"Bodies with safe islands, of {len(main)}", len(islands), "d"),
        (
            "farthest",
            "Farthest island over the first amplitude",
            (islands["last_safe"] / islands["first"]).max(),
            ".2f",
        ),
        (
            "size_spread",
            "Difference of sizes at the same ω/p [%]",
            100.0 * (alike.max() / alike.min() - 1.0).max(),
            ".1g",
        ),
    ]
    for part in ("restitution", "phase"):
        of_part = table[table["part"] == part].groupby("frequency")["first"]
        factor = float((of_part.max() / of_part.min()).max())
        rows.append((f"by_{part}", f"Largest factor between values of the {part}", factor, ".2f"))
    return quantities | {key: Quantity(label, value, form=form) for key, label, value, form in rows}


def _by_frequency(table: pd.DataFrame) -> pd.DataFrame:
    main = table[table["part"] == "main"]
    from_paper = 100.0 * (main["first"] / main["eq_4_1"] - 1.0)
    columns = {
        "f [Hz]": main["frequency"],
        "from Eq. 4.1, size": from_paper.abs(),
        "from Eq. 4.1, signed": from_paper,
        "from our fit, size": 100.0 * (main["first"] / main["fit"] - 1.0).abs(),
    }
    return pd.DataFrame(columns).groupby("f [Hz]").mean().reset_index()


def _drawn(table: pd.DataFrame, coefficients: Array) -> Figure:
    """Draw the critical amplitude over b/h for each frequency beside Eq. 4.1 and our fit, and residuals."""
    main = table[table["part"] == "main"]
    figure, (left, right) = panels(2, width=6.0, height=5.4)
    line = np.linspace(float(main["ratio"].min()), float(main["ratio"].max()), 50)
    groups = list(main.groupby("frequency"))
    for shade, marker, (f, rows) in zip(
        np.linspace(0.0, 0.85, len(groups)), "osD^vPX<>*" * 9, groups, strict=False
    ):
        look: dict[str, Any] = {"color": colormaps["viridis"](shade)}
        at = line, np.full(50, f)
        left.plot(rows["ratio"], rows["first"], marker, label=f"{f:g} Hz", **look)
        left.plot(line, regression(at, *coefficients), **look)
        left.plot(line, regression(at, *EQUATION_4_1), "--", **look)
        right.plot(rows["ratio"], 100.0 * (rows["first"] / rows["eq_4_1"] - 1.0), f"--{marker}", **look)
        right.plot(rows["ratio"], 100.0 * (rows["first"] / rows["fit"] - 1.0), f"-{marker}", **look)
    for dashes, name in (("-", "our fit"), ("--", "the paper's Eq. 4.1")):
        left.plot([], [], dashes, color=INK, label=name)
    left.set(title="First amplitude that turns the body over", ylabel="critical amplitude S₁ [m/s²]")
    right.set(title="Its deviation: full lines from our fit, dashed from Eq. 4.1", ylabel="deviation [%]")
    for axis in (left, right):
        axis.set_xlabel("aspect ratio b/h [–]")
    left.legend(ncols=2)
    return figure
