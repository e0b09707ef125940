"""Median overturning capacity of bare furniture over four sizes and five spectra.

The formula is that of Kaneko and Hayashi (2004), whose coefficients are common knowledge that was not
re-checked (`stayput.estimates`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput import Suite, TargetSpectrum, synthetic_suite
from stayput.estimates import SCATTER, kaneko_hayashi_branch, kaneko_hayashi_median
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import IntensityMeasure
from stayput.fragility.trials import Trials
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.model.body import FURNITURE, Body
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.report.figures import plain_log
from stayput.report.palette import INK, MUTED
from stayput.simulation.many import run_columns
from studies.study import COLOURS, Quantity, Study, claim, panels, span

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.motion.record import Motion

CORNERS = (0.2, 0.4, 0.8, 1.6, 3.2)
"""Corner periods of the spectra, from constant acceleration to constant velocity [s]."""

SIZES = ("bookcase", "cupboard", "chest", "refrigerator")
"""Presets whose sizes are taken; each is a uniform rectangle here, as the formula has it."""

BAND = 0.2
"""How far a median may be from the formula's."""

STATED = "as stated"
ROOMS = {
    STATED: Room(Floor(3.0, 3.0)),
    "landings of 0.9 times Housner's rate": Room(Floor(3.0, 3.0, restitution=0.9)),
    "a wall 2 cm behind": Room(Floor(3.0, 3.0), left_wall=Wall(0.02)),
}
"""Rooms in which no body slips; as stated, bodies stand free and land by Housner's rule."""

AMPLITUDE = IntensityMeasure(
    "A/A50", ("peak acceleration over the formula's median", "最大加速度の、式の中央値に対する比"), ""
)
"""What the curves are fitted over: A/A₅₀, with each motion's own Fe in A₅₀."""


def target(corner: float) -> TargetSpectrum:
    """Return a spectrum of the shape of Japan's design spectrum at bedrock, with another corner period.

    3.2 + 30T (T < 0.16 s), 8.0 (to the corner T_c), 8.0 T_c/T m/s². Its strength does not matter here.
    """
    table = np.geomspace(0.02, 10.0, 200)
    flat = np.where(corner > table, 8.0, 8.0 * corner / table)
    return TargetSpectrum(table, np.where(table < 0.16, 3.2 + 30.0 * table, flat), f"corner at {corner:g} s")


def of_spectrum(corner: float, count: int, seed: int) -> tuple[Motion, ...]:
    """Return crustal motions along x alone, each of which meets the spectrum of its corner period [s]."""
    drawn = synthetic_suite("crustal", count, seed)
    along = Suite(tuple(motion.component("x") for motion in drawn), drawn.name)
    return along.matched(target(corner)).motions


def frequencies(motions: Sequence[Motion]) -> NDArray[np.float64]:
    """Return equivalent frequencies Fe = A/(2πV) [Hz] from the peaks of motions."""
    return np.array([motion.pga / (2.0 * math.pi * motion.pgv) for motion in motions])


def body_of(size: str) -> Body:
    """Return a preset's body."""
    preset = FURNITURE[size]
    return Body(preset.width, preset.height, preset.mass)


@dataclass(frozen=True, slots=True, eq=False)
class BodyCapacity:
    """Simulated capacity of one body under motions of one kind, beside the formula's.

    Parameters
    ----------
    curve : FragilityCurve
        Share that overturns over A/A₅₀.
    shares : ndarray, shape [amplitude]
        Share of the motions that overturn it, at each amplitude.
    first : ndarray, shape [motion]
        Lowest amplitude A/A₅₀ at which it overturns; infinite where none does.
    islands : float
        Share of the motions that leave it standing somewhere above their first amplitude.
    given_up : int
        Runs that were given up.
    """

    curve: FragilityCurve
    shares: NDArray[np.float64]
    first: NDArray[np.float64]
    islands: float
    given_up: int

    @property
    def ratio(self) -> float:
        """Simulated median capacity over the formula's A₅₀; NaN where the curve has none."""
        return self.curve.capacity(0.5).estimate

    @property
    def dispersion(self) -> float:
        """Dispersion β of the lognormal curve nearest to the shares; NaN where there is none."""
        return math.nan if self.curve.lognormal is None else self.curve.lognormal.dispersion


def amplitudes(step: float) -> NDArray[np.float64]:
    """Return amplitudes A/A₅₀ from 0.4 to 4, in relative steps of about ``step``."""
    return np.geomspace(0.4, 4.0, 1 + round(np.log(10.0) / step))


def overturning(
    body: Body, room: Room, motions: Sequence[Motion], factors: NDArray[np.float64]
) -> BodyCapacity:
    """Run a body under every motion at every amplitude A/A₅₀, and return its capacity."""
    pga = np.array([motion.pga for motion in motions])
    formula = np.array([kaneko_hayashi_median(body, fe) for fe in frequencies(motions).tolist()])
    shape = len(pga), len(factors)
    cases = np.repeat(case_columns(body, room, State(), STANDARD_GRAVITY), shape[0] * shape[1])
    cases["scale"] = np.outer(formula / pga, factors).ravel()
    place = np.repeat(np.arange(shape[0]), shape[1])
    results, _ = run_columns(cases, None, motions, place)
    outcome = results["outcome"].reshape(shape)
    fell, lost = outcome == OVERTURNED_OUTCOME, outcome == FAILED_OUTCOME
    trials = Trials.from_runs(AMPLITUDE, factors, fell.T[:, :, np.newaxis], lost.T[:, :, np.newaxis])
    return BodyCapacity(
        curve=FragilityCurve("", trials),
        shares=fell.mean(axis=0),
        first=np.where(fell.any(axis=1), factors[fell.argmax(axis=1)], np.inf),
        islands=float((np.maximum.accumulate(fell, axis=1) & ~fell).any(axis=1).mean()),
        given_up=int(lost.sum()),
    )


def capacity(
    motions: int = 40,
    *,
    corners: Sequence[float] = CORNERS,
    sizes: Sequence[str] = SIZES,
    step: float = 0.04,
    variations: bool = True,
    seed: int = 1,
) -> Study:
    """Compare the peak acceleration that overturns half with Kaneko and Hayashi's formula.

    Bodies are uniform rectangles that do not slip and stand free. Every motion is scaled to every amplitude
    (incremental dynamic analysis); a range in which a body stands above its first overturning is kept as it
    is. The median is where half overturn, by a logit fit over the amplitude.

    Parameters
    ----------
    motions : int
        Motions of each kind, at least 2.
    corners : sequence of float
        Corner periods of the spectra that the motions meet [s], 0.16 to 5.
    sizes : sequence of str
        Names of furniture presets.
    step : float
        Relative step of the amplitudes; an island narrower than this can be missed.
    variations : bool
        Whether to run other landings, a wall, and motions as they are drawn, too.
    seed : int
        Seed of the motions.

    Returns
    -------
    Study
        Data over ``run`` (a setting under motions of one kind) and ``body``.
    """
    factors, bodies = amplitudes(step), [body_of(size) for size in sizes]
    spectra = [of_spectrum(corner, motions, seed) for corner in corners]
    rooms = ROOMS if variations else {STATED: ROOMS[STATED]}
    work = [(name, room, shaking) for name, room in rooms.items() for shaking in spectra]
    for family in ("near-fault", "crustal") if variations else ():
        drawn = synthetic_suite(family, motions, seed).motions
        along = tuple(motion.component("x") for motion in drawn)
        work.append((f"{family} motions as drawn, x alone", ROOMS[STATED], along))
        work.append((f"{family} motions as drawn, x and vertical", ROOMS[STATED], drawn))
    found = [[overturning(body, room, shaking, factors) for body in bodies] for _, room, shaking in work]

    def of_each(field: str) -> tuple[tuple[str, str], NDArray[np.float64]]:
        return ("run", "body"), np.array([[getattr(one, field) for one in row] for row in found])

    fe = np.array([np.median(frequencies(shaking)) for _, _, shaking in work])
    medians = [[one.curve.capacity(0.5) for one in row] for row in found]
    formula = [[kaneko_hayashi_median(body, f) for body in bodies] for f in fe.tolist()]
    data = xr.Dataset(
        {
            **{name: of_each(name) for name in ("ratio", "dispersion", "islands", "given_up")},
            "ratio_low": (("run", "body"), [[one.low for one in row] for row in medians]),
            "ratio_high": (("run", "body"), [[one.high for one in row] for row in medians]),
            "first_ratio": (("run", "body"), [[float(np.median(one.first)) for one in row] for row in found]),
            "formula": (("run", "body"), formula, {"units": "m/s2", "long_name": "A50 at the median Fe"}),
        },
        {
            "setting": ("run", [name for name, _, _ in work]),
            "frequency": ("run", fe, {"units": "Hz", "long_name": "median of Fe = A/(2 pi V)"}),
            "body": list(sizes),
            "branch": ("body", [kaneko_hayashi_branch(body) for body in bodies], {"units": "Hz"}),
        },
    )
    ratio = stated(data)["ratio"].to_numpy()
    within = int(inside(ratio).sum())
    return Study(
        name="capacity",
        title="Overturning capacity of bare furniture beside Kaneko and Hayashi's formula",
        quantities=_quantities(data),
        data=data,
        figure=_drawn(data),
        tables={
            "Median peak acceleration that overturns, A₅₀ [m/s²], by the formula and by simulation over it": (
                medians_table(data)
            ),
            "The ratio to the formula by condition": conditions_table(data),
        },
        claims=(
            claim(
                "Kaneko and Hayashi 2004, formula",
                "median acceleration that overturns free pieces that do not slide",
                f"{span(ratio)} times it; {within} of {ratio.size} within ±20 %",
                within,
                ratio.size,
            ),
        ),
    )


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    main = stated(data)
    ratio, first = main["ratio"].to_numpy(), main["first_ratio"].to_numpy()
    reach = ~(inside(main["ratio_low"].to_numpy()) & inside(main["ratio_high"].to_numpy()))
    mean = float(np.exp(np.log(ratio).mean()))
    return {
        "mean": Quantity("Simulated median over the formula's, geometric mean", mean, 1.0, ".2f"),
        "ratio": Quantity("Smallest and largest of these ratios", span(ratio), "1"),
        "within": Quantity("Ratios within ±20 %", int(inside(ratio).sum()), ratio.size, "d"),
        "beyond": Quantity("Their 95 % intervals that reach beyond ±20 %", int(reach.sum()), form="d"),
        "first": Quantity("Smallest and largest ratio of first overturnings", span(first), "1"),
        "scatter": Quantity("Standard deviation of ln A", span(main["dispersion"]), f"{SCATTER:g}"),
        "islands": Quantity("Motions with safe islands [%]", span(100.0 * main["islands"], ".0f")),
        "given_up": Quantity("Runs given up, and left out", int(main["given_up"].sum()), form="d"),
    }


def stated(data: xr.Dataset) -> xr.Dataset:
    """Return the runs in the stated setting."""
    return data.isel(run=np.flatnonzero(data["setting"].to_numpy() == STATED))


def inside(ratio: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which ratios are within the band."""
    return np.abs(ratio - 1.0) <= BAND


def medians_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each size and spectrum."""
    table = stated(data).drop_vars(["setting", "given_up"]).transpose("body", "run").to_dataframe()
    named = {"frequency": "Fe [Hz]", "branch": "Fb [Hz]", "formula": "formula", "ratio": "ratio"}
    named |= {"ratio_low": "from", "ratio_high": "to", "first_ratio": "ratio of first overturnings"}
    named |= {"dispersion": "ζ", "islands": "share with islands"}
    return table.reset_index()[["body", *named]].rename(columns=named).round(2)


def conditions_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each setting: the ratios of each size over its spectra, and how many are within."""
    rows: list[dict[str, object]] = []
    for name, runs in data.groupby("setting"):
        ratio = runs["ratio"]
        row: dict[str, object] = {"condition": name}
        row |= {size: span(ratio.sel(body=size)) for size in ratio["body"].to_numpy().tolist()}
        row["within ±20 %"] = f"{int(inside(ratio.to_numpy()).sum())} of {ratio.size}"
        rows.append(row | {"ζ": span(runs["dispersion"])})
    return pd.DataFrame(rows)


def _drawn(data: xr.Dataset) -> Figure:
    """Draw A₅₀ over Fe, both scaled to where the formula's branches meet."""
    main = stated(data)
    figure, (axis,) = panels(1, width=7.0, height=5.0)
    plain_log(axis)
    fe = main["frequency"]
    for size, colour, marker in zip(main["body"].to_numpy().tolist(), COLOURS, "os^Dv", strict=False):
        one = main.sel(body=size)
        scaled = fe / one["branch"]
        level = np.maximum(1.0, scaled)
        median, low, high = (one[name] * level for name in ("ratio", "ratio_low", "ratio_high"))
        error = np.maximum(np.nan_to_num(np.stack((median - low, high - median)), posinf=0.0), 0.0)
        axis.errorbar(scaled, median, error, fmt=marker, color=colour, capsize=2.5, label=size)
    x = np.geomspace(0.8 * float((fe / main["branch"]).min()), 1.2 * float((fe / main["branch"]).max()), 200)
    unit = np.maximum(1.0, x)
    axis.fill_between(x, (1 - BAND) * unit, (1 + BAND) * unit, color=MUTED, alpha=0.2, label="±20 %")
    axis.plot(x, unit, color=INK, linewidth=1.6, label="formula")
    axis.set(xticks=(0.5, 1.0, 2.0, 3.0), yticks=(0.8, 1.0, 1.5, 2.0, 3.0, 4.0))
    axis.set(xlabel="Fe/Fb [–]; points: simulation (95 %)", ylabel="A₅₀ over the formula's level branch [–]")
    axis.legend(loc="upper left")
    return figure
