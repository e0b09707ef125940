"""Median overturning capacity of bare furniture over four sizes and five spectra.

The formula is that of Kaneko and Hayashi (2004), whose coefficients are common knowledge that was not
re-checked (`stayput.estimates`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from scipy.special import ndtr

from stayput.errors import whole_within, within
from stayput.estimates import SCATTER, kaneko_hayashi_branch, kaneko_hayashi_median
from stayput.model.body import Body
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, plain_log, style
from stayput.report.palette import INK, MUTED
from studies.capacity_runs import (
    CORNERS,
    DRAWN,
    OTHERS,
    SIZES,
    STATED,
    Setting,
    amplitudes,
    as_drawn,
    body_of,
    of_spectra,
    overturning,
)
from studies.study import Claim, Quantity, Study, outcome_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from studies.capacity_runs import BodyCapacity, Shakings

BAND = 0.2
"""How far a median may be from the formula's."""

RESULTS = {
    "ratio": "simulated median over the formula's, each motion with its own Fe",
    "ratio_low": "lower end of its 95 % interval",
    "ratio_high": "upper end of its 95 % interval",
    "first_ratio": "median of the first amplitudes that overturn, over the formula's median",
    "dispersion": "standard deviation of ln A at overturning, lognormal",
    "islands": "share of motions with safe islands",
    "given_up": "runs that were given up",
}
"""What there is for each run and body."""

LOOKS = (("#0072b2", "-", "o"), ("#d55e00", "--", "s"), ("#009e73", "-.", "^"), ("#cc79a7", ":", "D"))
"""Colour, line and marker of each size, in turn."""

SPECTRA = ("#0072b2", "#009e73", "#e69f00", "#d55e00", "#cc79a7")
"""Colours of the spectra, from the shortest corner period."""

_TICKS = (0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0)

MARKERS = ("o", "s", "^", "D", "v")
"""Their markers."""


@dataclass(frozen=True, slots=True, eq=False)
class SettingResult:
    """All sizes in one setting under motions of one kind."""

    setting: str
    shakings: Shakings
    capacities: list[BodyCapacity]


def capacity(
    motions: int = 60,
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
    is. The median is where half overturn, by isotonic regression of the shares over the amplitude.

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
        Figures "medians" and "shares". Data over ``run`` (a setting under motions of one kind), ``body``,
        ``motion`` and ``amplitude``.

    Raises
    ------
    InputError
        A value out of range, or a preset that is not known.

    Examples
    --------
    >>> import studies
    >>> few = studies.capacity(2, corners=[0.8], sizes=["bookcase"], step=0.2, variations=False)
    >>> for name in ("mean", "first"):  # of a bookcase under two motions; 1 is the formula
    ...     print(few.quantities[name], few.quantities[name].label)
    1.04 Simulated median over the formula's, geometric mean
    1.29 Smallest and largest ratio of first overturnings
    """
    count = whole_within("studies.motions", motions, 2, 1000)
    factors = amplitudes(within("studies.step", step, 0.005, 0.2))
    bodies = {size: body_of(size) for size in sizes}
    spectra = of_spectra(tuple(corners), count, seed)
    work: list[tuple[Setting, Shakings]] = [(STATED, motions_of) for motions_of in spectra]
    if variations:
        work += [(setting, motions_of) for setting in OTHERS for motions_of in spectra]
        for family in DRAWN:
            for vertical in (False, True):
                name = f"{family} motions as drawn, {'x and vertical' if vertical else 'x alone'}"
                shakings = as_drawn(family, count, seed, vertical=vertical)
                work.append((Setting(name, STATED.room), shakings))
    rows: list[SettingResult] = []
    with bar(len(work) * len(bodies) * count * len(factors), "progress.studying") as advance:
        for setting, shakings in work:
            capacities: list[BodyCapacity] = []
            for body in bodies.values():
                capacities.append(overturning(body, setting.room, shakings, factors))
                advance(count * len(factors))
            rows.append(SettingResult(setting.name, shakings, capacities))
    data = _dataset(rows, bodies, factors)
    medians = "Median peak acceleration that overturns, A₅₀ [m/s²], by simulation and by the formula"
    tables = {medians: medians_table(data)}
    if variations:
        tables["The ratio to the formula under other conditions"] = variations_table(data)
    return Study(
        name="capacity",
        title="Overturning capacity of bare furniture beside Kaneko and Hayashi's formula",
        quantities=_quantities(data),
        data=data,
        figures={"medians": draw_medians(data), "shares": draw_shares(data)},
        tables=tables,
        claims=(_claim(data),),
    )


def _claim(data: xr.Dataset) -> Claim:
    """Return the formula beside the simulated medians of bodies that stand free and do not slip."""
    ratio = stated(data)["ratio"].to_numpy()
    return Claim(
        "Kaneko and Hayashi 2004, formula",
        "median acceleration that overturns free pieces that do not slide",
        f"{_span(ratio.ravel())} times it; {int(inside(ratio).sum())} of {ratio.size} within ±20 %",
        outcome_of(int(inside(ratio).sum()), ratio.size),
    )


def _dataset(rows: list[SettingResult], bodies: dict[str, Body], factors: NDArray[np.float64]) -> xr.Dataset:
    """Return all results in one dataset."""
    frequency = np.array([np.median(row.shakings.frequencies) for row in rows])
    formula = np.array(
        [[kaneko_hayashi_median(body, float(fe)) for body in bodies.values()] for fe in frequency]
    )

    def values_of(name: str) -> NDArray[np.float64]:
        return np.array([[getattr(capacity, name) for capacity in row.capacities] for row in rows])

    interval, first = values_of("interval"), values_of("first")
    pga, pgv = (np.array([row.shakings.peaks[place] for row in rows]) for place in (0, 1))
    results = {name: values_of(name) for name in ("ratio", "dispersion", "islands")}
    results |= {"ratio_low": interval[..., 0], "ratio_high": interval[..., 1]}
    results |= {"first_ratio": np.median(first, axis=-1), "given_up": values_of("given_up").astype(np.int64)}
    over = ("run", "body")
    share, lowest = "share of the motions that overturn", "first amplitude that overturns, over A50"
    return xr.Dataset(
        {
            **{name: (over, results[name], {"long_name": about}) for name, about in RESULTS.items()},
            "formula": (over, formula, {"units": "m/s2", "long_name": "A50 of the formula at the median Fe"}),
            "share": ((*over, "amplitude"), values_of("shares"), {"long_name": share}),
            "first": ((*over, "motion"), first, {"long_name": lowest}),
            "pga": (("run", "motion"), pga, {"units": "m/s2"}),
            "pgv": (("run", "motion"), pgv, {"units": "m/s"}),
        },
        {
            "setting": ("run", [row.setting for row in rows]),
            "motions": ("run", [row.shakings.name for row in rows]),
            "corner": ("run", [row.shakings.corner for row in rows], {"units": "s"}),
            "frequency": ("run", frequency, {"units": "Hz", "long_name": "median of Fe = A/(2 pi V)"}),
            "body": list(bodies),
            "width": ("body", [body.width for body in bodies.values()], {"units": "m"}),
            "height": ("body", [body.height for body in bodies.values()], {"units": "m"}),
            "branch": (
                "body",
                [kaneko_hayashi_branch(body) for body in bodies.values()],
                {"units": "Hz", "long_name": "Fb, from which on the velocity counts"},
            ),
            "amplitude": ("amplitude", factors, {"long_name": "A/A50"}),
        },
        {"motions_of_each_kind": len(rows[0].shakings.motions)},
    )


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    main = stated(data)
    ratio, first = main["ratio"].to_numpy(), main["first_ratio"].to_numpy()
    reach = ~(inside(main["ratio_low"].to_numpy()) & inside(main["ratio_high"].to_numpy()))
    mean, scatter = float(np.exp(np.log(ratio).mean())), main["dispersion"].to_numpy()
    return {
        "mean": Quantity("Simulated median over the formula's, geometric mean", mean, 1.0, ".2f"),
        "ratio": Quantity("Smallest and largest of these ratios", _span(ratio), "1"),
        "within": Quantity("Ratios within ±20 %", int(inside(ratio).sum()), ratio.size, "d"),
        "beyond": Quantity("Their 95 % intervals that reach beyond ±20 %", int(reach.sum()), form="d"),
        "first": Quantity("Smallest and largest ratio of first overturnings", _span(first), "1"),
        "first_within": Quantity("of these, within ±20 %", int(inside(first).sum()), first.size, "d"),
        "scatter": Quantity("Standard deviation of ln A", _span(scatter), f"{SCATTER:g}"),
        "given_up": Quantity("Runs given up, and left out", int(main["given_up"].sum()), form="d"),
    }


def stated(data: xr.Dataset) -> xr.Dataset:
    """Return the runs in the stated setting."""
    return data.isel(run=np.flatnonzero(data["setting"].to_numpy() == STATED.name))


def inside(ratio: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which ratios are within the band."""
    return np.abs(ratio - 1.0) <= BAND


def medians_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each size and spectrum."""
    main = stated(data)
    rows: list[dict[str, object]] = []
    for size in main["body"].to_numpy():
        for run in range(main.sizes["run"]):
            cell = main.sel(body=size).isel(run=run)
            formula, ratio, low, high = (
                float(cell[name]) for name in ("formula", "ratio", "ratio_low", "ratio_high")
            )
            fe, fb = float(cell["frequency"]), float(cell["branch"])
            rows.append(
                {
                    "body": f"{size}, {100 * float(cell['width']):g} × {100 * float(cell['height']):g} cm",
                    "corner [s]": float(cell["corner"]),
                    "Fe [Hz]": round(fe, 2),
                    "Fe/Fb": round(fe / fb, 2),
                    "formula": round(formula, 2),
                    "simulation": round(ratio * formula, 2),
                    "ratio": f"{ratio:.2f} ({low:.2f} to {high:.2f})",
                    "within ±20 %": "yes" if bool(inside(np.array(ratio))) else "no",
                    "ratio of first overturnings": round(float(cell["first_ratio"]), 2),
                    "ζ": round(float(cell["dispersion"]), 2),
                    "motions with islands [%]": round(100.0 * float(cell["islands"])),
                }
            )
    return pd.DataFrame(rows)


def variations_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each setting: the ratios of each size over its spectra, and how many are within."""
    rows: list[dict[str, object]] = []
    for name in dict.fromkeys(data["setting"].to_numpy().tolist()):
        runs = data.isel(run=np.flatnonzero(data["setting"].to_numpy() == name))
        ratio = runs["ratio"].to_numpy()
        spread = {str(size): _span(ratio[:, place]) for place, size in enumerate(runs["body"].to_numpy())}
        rows.append(
            {
                "condition": name,
                **spread,
                "within ±20 %": f"{int(inside(ratio).sum())} of {ratio.size}",
                "ζ": _span(runs["dispersion"].to_numpy().ravel()),
            }
        )
    return pd.DataFrame(rows)


def _span(values: NDArray[np.float64]) -> str:
    low, high = float(values.min()), float(values.max())
    return f"{low:.2f}" if values.size == 1 else f"{low:.2f} to {high:.2f}"


def draw_medians(data: xr.Dataset) -> Figure:
    """Draw A₅₀ over Fe beside both branches of the formula, and both scaled to where the branches meet."""
    main = stated(data)
    figure = new_figure(11.0, 5.0)
    left, right = figure.subplots(1, 2)
    fe = main["frequency"].to_numpy()
    over: NDArray[np.float64] = np.geomspace(0.7 * float(fe.min()), 1.4 * float(fe.max()), 200)
    ends: list[float] = []
    for place, size in enumerate(main["body"].to_numpy()):
        colour, line, marker = LOOKS[place % len(LOOKS)]
        of_body = main.sel(body=size)
        b, h, fb = (float(of_body[name]) for name in ("width", "height", "branch"))
        formula = np.array([kaneko_hayashi_median(Body(b, h, 1.0), float(f)) for f in over.tolist()])
        floor = float(formula.min())
        median, error = _with_error(of_body)
        look = {"fmt": marker, "color": colour, "markersize": 6.0, "capsize": 2.5, "elinewidth": 1.0}
        left.plot(over, formula, color=colour, linestyle=line, linewidth=1.6)
        left.errorbar(fe, median, error, label=f"{size}, {100 * b:g} × {100 * h:g} cm", **look)
        right.errorbar(fe / fb, median / floor, error / floor, label=str(size), **look)
        ends += [float(over[0]) / fb, float(over[-1]) / fb]
    x = np.geomspace(min(ends), max(ends), 200)
    unit = np.maximum(1.0, x)
    right.fill_between(x, (1 - BAND) * unit, (1 + BAND) * unit, color=MUTED, alpha=0.2, label="±20 %")
    right.plot(x, unit, color=INK, linewidth=1.6, label="formula")
    labels = (
        ("Fe = A/(2πV) [Hz]", "A₅₀ [m/s²]", "Points: simulation, synthetic motions (95 %); lines: formula"),
        (
            "Fe/Fb [–]",
            "A₅₀ over the formula's level branch [–]",
            "The same, scaled to where the branches meet",
        ),
    )
    for axis, (below, beside, title) in zip((left, right), labels, strict=True):
        across, up = (over[0], over[-1]) if axis is left else (x[0], x[-1]), axis.get_ylim()
        _finish(axis, below, beside, title)
        axis.set_xlim(*across)
        axis.set_ylim(*up)
    left.legend(loc="upper left", fontsize=FONT - 1.0)
    right.legend(loc="upper left", fontsize=FONT - 1.0)
    return figure


def _with_error(of_body: xr.Dataset) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return medians [m/s²] and their distances to the ends of the intervals, shape [2, run]."""
    ratio, low, high = (of_body[name].to_numpy() for name in ("ratio", "ratio_low", "ratio_high"))
    known = np.isfinite(low) & np.isfinite(high)
    error = np.where(known, np.stack((ratio - low, high - ratio)), 0.0)
    formula = of_body["formula"].to_numpy()
    return ratio * formula, np.maximum(error, 0.0) * formula


def _finish(axis: Axes, below: str, beside: str, title: str) -> None:
    plain_log(axis)
    axis.set_xticks(_TICKS)
    axis.set_yticks(_TICKS)
    style(axis, zero=False)
    axis.set_xlabel(below, fontsize=FONT)
    axis.set_ylabel(beside, fontsize=FONT)
    axis.set_title(title, fontsize=FONT, color=INK)


def draw_shares(data: xr.Dataset) -> Figure:
    """Draw the share that overturns over A/A₅₀, a panel for each size, beside the formula's curve."""
    main = stated(data)
    count = main.sizes["body"]
    columns = min(2, count)
    figure = new_figure(5.2 * columns, 3.4 * (-(-count // columns)) + 0.6)
    panels = figure.subplots(-(-count // columns), columns, sharex=True, sharey=True, squeeze=False).ravel()
    r = main["amplitude"].to_numpy()
    for place, axis in enumerate(panels):
        axis.set_visible(place < count)
        if place >= count:
            continue
        axis.plot(r, ndtr(np.log(r) / SCATTER), color=INK, linewidth=2.2, label=f"formula, ζ = {SCATTER:g}")
        for run in range(main.sizes["run"]):
            of_body = main.isel(run=run, body=place)
            axis.plot(
                r,
                of_body["share"],
                color=SPECTRA[run % len(SPECTRA)],
                marker=MARKERS[run % len(MARKERS)],
                markevery=(run % 5, 5),
                markersize=4.5,
                linewidth=1.2,
                label=f"Fe = {float(of_body['frequency']):.2f} Hz (corner {float(of_body['corner']):g} s)",
            )
        plain_log(axis, y=False)
        axis.set_xticks([tick for tick in _TICKS if r[0] <= tick <= r[-1]])
        style(axis, zero=False)
        axis.set_ylim(-0.02, 1.02)
        axis.set_title(str(main["body"].to_numpy()[place]), fontsize=FONT, color=INK)
        if place >= count - columns:
            axis.set_xlabel("A/A₅₀ of the formula [–]", fontsize=FONT)
        if place % columns == 0:
            axis.set_ylabel("share that overturns [–]", fontsize=FONT)
    panels[0].legend(loc="upper left", fontsize=FONT - 2.0)
    figure.suptitle(f"{main.sizes['motion']} synthetic motions of each spectrum", fontsize=FONT, color=INK)
    return figure
