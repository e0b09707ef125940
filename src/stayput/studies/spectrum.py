"""Overturning and rocking spectra: what falls, by size and slenderness, under a pulse and under a record.

Source of the pulse's spectrum: Zhang and Makris (2001), Rocking response of free-standing blocks under
cycloidal pulses, J. Eng. Mech. 127(5), 473-483.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.collections import PolyCollection
from matplotlib.ticker import NullFormatter

from stayput.errors import InputError, within
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.motion import near_fault
from stayput.report.figures import FONT, new_figure, plain_log, style
from stayput.report.palette import ALARM, INK, MUTED
from stayput.studies.spectrum_runs import (
    PULSE_E,
    PULSE_PERIOD,
    PULSE_SLENDERNESS,
    REFERENCE_EDGES,
    REFERENCE_RATIO,
    falling_ranges,
    frequency_parameter,
    half_diagonal,
    housner_ratio,
    outer_edges,
    pulse_branches,
    pulse_spectrum,
    record_spectrum,
    reference_edges,
)
from stayput.studies.study import Quantity, Study, increasing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion import Motion

SLENDERNESS = (0.15, 0.2, 0.3, 0.4)
"""α of the bodies under the record [rad]: from a bookcase to a cupboard."""

WITH_IMPACT, WITHOUT_IMPACT = "#e69f00", "#0072b2"
"""Colours of the two ways to fall."""

LINES = (("#0072b2", "-", "o"), ("#d55e00", "--", "s"), ("#009e73", "-.", "^"), ("#cc79a7", ":", "D"))
"""Colour, line and marker of each slenderness, in turn."""


def spectrum(
    motion: Motion | None = None,
    *,
    slenderness: Sequence[float] = SLENDERNESS,
    periods: ArrayLike | None = None,
    step: float = 0.01,
) -> Study:
    """Study what falls by size: overturning spectra of a one-cycle sine and of a record, rocking spectra.

    Bodies are rectangles on a floor so rough that they rock, under the coulomb law.

    Parameters
    ----------
    motion : Motion, optional
        The record; default the built-in near-fault motion along the shaking only.
    slenderness : sequence of float
        α of the bodies under the record [rad], increasing.
    periods : array_like, optional
        Their sizes, as 2π/p [s], increasing; default 0.5 to 5 s. Under the one-cycle sine the same sizes
        give ωp/p = 2π/p over the sine's period of 0.5 s.
    step : float
        Relative step of the amplitudes that are sampled; islands narrower than this can be missed.

    Returns
    -------
    Study
        Figures "pulse", "record" and "rocking". Data over ``curve`` (the sine, then each slenderness under
        the record), ``period`` (2π/p) and ``edge``.

    Raises
    ------
    InputError
        Values out of range or not increasing, a motion that is still, or bodies too small or too large.

    Examples
    --------
    >>> from stayput import studies
    >>> quick = studies.spectrum(slenderness=[0.2], periods=[1.0, 2.0], step=0.1)
    >>> for name in ("edge_1", "edge_2", "edge_3"):  # amplitudes over αg
    ...     print(f"{quick.quantities[name].value:.2f}, published {quick.quantities[name].published:.2f}")
    3.03, published 3.03
    6.74, published 6.74
    7.49, published 7.49
    """
    record = near_fault().component("x") if motion is None else motion
    alpha = _increasing("studies.slenderness", slenderness, 0.01, 1.2, "rad")
    sizes = np.geomspace(0.5, 5.0, 61) if periods is None else periods
    period = _increasing("studies.period", sizes, 0.05, 20.0, "s")
    if len(alpha) < 1 or len(period) < 2:
        raise InputError("studies.spectrum_too_small", slendernesses=len(alpha), periods=len(period))
    step = within("studies.step", step, 1e-4, 0.2)
    pulse = pulse_spectrum(period, step)
    by_record = record_spectrum(record, alpha, period, step)
    reference = reference_edges(step)
    data = _merged(pulse, by_record, record)
    return Study(
        name="spectrum",
        title="Overturning and rocking spectra",
        quantities=_quantities(by_record, _reference_table(reference)),
        data=data,
        figures={
            "pulse": pulse_figure(pulse.isel(slenderness=0)),
            "record": record_figure(by_record, record),
            "rocking": rocking_figure(by_record, record),
        },
        tables={
            f"Edges under one sine at ωp/p = {REFERENCE_RATIO:g}, a_p/(αg)": _reference_table(reference),
            f"Bodies under {record.name or 'the record'}, all sizes": _record_table(by_record),
        },
    )


def _increasing(name: str, values: ArrayLike, low: float, high: float, unit: str) -> NDArray[np.float64]:
    return increasing(name, values, low, high, unit, least=0, refusal="studies.not_sorted")


def _quantities(under: xr.Dataset, reference: pd.DataFrame) -> dict[str, Quantity]:
    quantities = {
        f"edge_{place}": Quantity(f"Under one sine, edge above which it {above} [αg]", run, paper, ".3f")
        for place, (above, run, paper, _) in enumerate(reference.itertuples(index=False), 1)
    }
    islands, falls = under["islands"].to_numpy(), under["overturned"].to_numpy()
    for key, label, value in (
        ("bodies", "Bodies under the record", islands.size),
        ("with_islands", "Bodies with islands of safety", int((islands > 0).sum())),
        ("most_islands", "Most islands of one body", int(islands.max())),
        ("falls", "Bodies that fall under the record as it is", int(falls.sum())),
        ("given_up", "Runs given up, counted as falls", int(under["failed"].sum())),
    ):
        quantities[key] = Quantity(label, value, form="d")
    return quantities


def _merged(pulse: xr.Dataset, under: xr.Dataset, record: Motion) -> xr.Dataset:
    """Return one dataset over curve, period and edge: the pulse first."""
    edges = under.drop_vars(["peak_tilt", "overturned"])
    parts = [part.rename(slenderness="curve").drop_vars("curve") for part in (pulse, edges)]
    missing = {"amplitude": np.nan, "lower": np.nan, "upper": np.nan, "direction": 0, "floor_impacts": -1}
    data = xr.concat(parts, "curve", join="outer", fill_value=missing, combine_attrs="override")
    alpha = np.append(PULSE_SLENDERNESS, under["slenderness"])
    size = half_diagonal(frequency_parameter(data["period"].values))
    data = data.assign_coords(
        motion=("curve", ["one-cycle sine", *[record.name or "record"] * (len(alpha) - 1)]),
        slenderness=("curve", alpha, {"units": "rad", "long_name": "slenderness"}),
        restitution=("curve", [PULSE_E, *map(housner_ratio, alpha[1:])], {"long_name": "ratio of rates"}),
        half_diagonal=("period", size, {"units": "m", "long_name": "R = 3g/(4p2)"}),
        frequency_ratio=("period", data["period"].values / PULSE_PERIOD, {"long_name": "wp/p of the sine"}),
    )
    data["period"].attrs = {"units": "s", "long_name": "2 pi/p, the size of the body"}
    data["amplitude"].attrs["comment"] = "of the sine: a_p/(alpha g); of the record: factor on it"
    for name, unit in (("peak_tilt", "rad"), ("overturned", "")):
        values = under[name].transpose("slenderness", "period").values.astype(np.float64)
        data[name] = (("curve", "period"), np.vstack((np.full(values.shape[1], np.nan), values)))
        data[name].attrs = {"units": unit, "long_name": f"{name} under the record as it is; nan: the sine"}
    for name in ("lowest_amplitude", "highest_amplitude"):
        sampled = [pulse.attrs[name], *[under.attrs[name]] * (len(alpha) - 1)]
        data = data.assign_coords({name: ("curve", sampled, {"long_name": "of those sampled"})})
    data.attrs = {name: under.attrs[name] for name in ("tolerance", "largest_relative_step", "resolution")}
    return data.assign_attrs(pulse_period=PULSE_PERIOD, record=record.name)


def _reference_table(known: xr.Dataset) -> pd.DataFrame:
    edges = known["amplitude"].values[: len(REFERENCE_EDGES)]
    edges = np.pad(edges, (0, len(REFERENCE_EDGES) - len(edges)), constant_values=math.nan)
    above = ["falls, after an impact", "stands", "falls, without impact"]
    table = pd.DataFrame({"above it": above, "this run": edges, "reference": REFERENCE_EDGES})
    table["difference [%]"] = 100.0 * (table["this run"] / table["reference"] - 1.0)
    return table


def _record_table(under: xr.Dataset) -> pd.DataFrame:
    first, last = outer_edges(under)
    falls, alpha = under["overturned"].values, under["slenderness"].values
    diagonal = np.broadcast_to(2.0 * half_diagonal(frequency_parameter(under["period"].values)), falls.shape)
    return pd.DataFrame(
        {
            "α [rad]": alpha,
            "b/h": np.tan(alpha),
            "sizes that fall, record as it is [%]": 100.0 * falls.mean(1),
            "largest diagonal that falls [m]": _largest(np.where(falls, diagonal, np.nan)),
            "lowest factor that overturns any": -_largest(-first),
            "sizes with islands [%]": 100.0 * (under["islands"].values > 0).mean(1),
            "most islands": under["islands"].values.max(1),
            "largest ratio of last to first edge": _largest(last / first),
        }
    )


def _largest(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest of each row, NaN where it has none."""
    largest = np.where(np.isnan(values), -math.inf, values).max(1)
    return np.where(np.isinf(largest), math.nan, largest)


def _size_ticks(axis: Axes, period: NDArray[np.float64]) -> None:
    """Label 2π/p below and the diagonal 2R above."""
    plain_log(axis, y=False)
    ticks = [t for t in (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0) if period[0] <= t <= period[-1]]
    axis.set_xticks(ticks)
    axis.set_xlim(period[0], period[-1])
    k = 3.0 * STANDARD_GRAVITY / (8.0 * math.pi**2)  # 2R = k (2π/p)²
    above = axis.secondary_xaxis(
        "top", functions=(lambda t: k * np.asarray(t) ** 2, lambda d: np.sqrt(np.abs(d) / k))
    )
    shown = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
    above.set_xticks(shown, [f"{d:g}" for d in shown])
    above.xaxis.set_minor_formatter(NullFormatter())
    above.tick_params(labelsize=FONT - 1.0, colors=INK)
    above.set_xlabel("Diagonal 2R [m]", fontsize=FONT)


def pulse_figure(pulse: xr.Dataset) -> Figure:
    """Draw the two branches under the one-cycle sine over ωp/p."""
    figure = new_figure(7.2, 5.0)
    axis = figure.subplots()
    style(axis, zero=False)
    ratio = pulse["period"].values / PULSE_PERIOD
    lower, upper, without = pulse_branches(pulse)
    top = 1.3 * float(np.nanmax([np.nanmax(pulse["amplitude"].values), *REFERENCE_EDGES]))
    look: dict[str, Any] = {"color": WITH_IMPACT, "alpha": 0.35, "hatch": "//", "linewidth": 0.0}
    axis.fill_between(ratio, lower, upper, label="falls after an impact", **look)
    look: dict[str, Any] = {"color": WITHOUT_IMPACT, "alpha": 0.25, "linewidth": 0.0}
    axis.fill_between(ratio, without, top, label="falls without impact", **look)
    axis.plot(ratio, lower, color=WITH_IMPACT, linewidth=2.0, label="with impact, lower edge")
    axis.plot(ratio, upper, color=WITH_IMPACT, linewidth=2.0, linestyle="--", label="with impact, upper edge")
    axis.plot(ratio, without, color=WITHOUT_IMPACT, linewidth=2.0, linestyle="-.", label="without impact")
    known = [REFERENCE_RATIO] * len(REFERENCE_EDGES), REFERENCE_EDGES
    look: dict[str, Any] = {"color": "white", "markeredgecolor": INK, "markersize": 7.0}
    axis.plot(*known, "o", label="reference values", **look)
    plain_log(axis, x=False)
    axis.set_yticks([1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0])
    axis.set_ylim(0.9, top)
    axis.set_xlim(ratio[0], ratio[-1])
    axis.set_xlabel("ωp/p [–]", fontsize=FONT)
    axis.set_ylabel("Amplitude of the sine, a_p/(αg) [–]", fontsize=FONT)
    axis.set_title(
        f"One full sine, α = {PULSE_SLENDERNESS:g} rad, e = {PULSE_E:g}, nonlinear; white: it stands",
        fontsize=FONT + 1.0,
        color=INK,
    )
    axis.legend(loc="upper left", fontsize=FONT - 1.0)
    return figure


def record_figure(under: xr.Dataset, record: Motion) -> Figure:
    """Draw where bodies fall over their size and the factor on the record, a panel for each slenderness."""
    count = under.sizes["slenderness"]
    columns = min(2, count)
    rows = math.ceil(count / columns)
    figure = new_figure(1.0 + 4.4 * columns, 0.8 + 3.6 * rows)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False).ravel()
    period = under["period"].values
    first, last = outer_edges(under)
    for place, axis in enumerate(panels):
        if place >= count:
            axis.set_visible(False)
            continue
        style(axis, zero=False)
        of_alpha = under.isel(slenderness=place)
        look: dict[str, Any] = {"facecolor": ALARM, "alpha": 0.45, "edgecolor": "none"}
        axis.add_collection(PolyCollection(_bars(of_alpha), label="falls", **look))
        axis.plot(period, first[place], color=INK, linewidth=1.6, label="first edge: below it all stand")
        axis.plot(period, last[place], "_", color=INK, markersize=7.0, label="last edge: above it all fall")
        axis.axhline(1.0, color=MUTED, linewidth=1.2, linestyle=":", label="the record as it is")
        _size_ticks(axis, period)
        plain_log(axis, x=False)
        axis.set_yticks((0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0))
        axis.set_ylim(_bottom(first, under), under.attrs["highest_amplitude"])
        alpha = float(of_alpha["slenderness"])
        axis.set_title(f"α = {alpha:g} rad (b/h = {math.tan(alpha):.2f})", fontsize=FONT)
        if place >= count - columns:
            axis.set_xlabel("2π/p [s]", fontsize=FONT)
        if place % columns == 0:
            axis.set_ylabel("Factor on the record [–]", fontsize=FONT)
    panels[0].legend(loc="upper left", fontsize=FONT - 2.0)
    name, peak = record.name or "the record", record.pga / STANDARD_GRAVITY
    figure.suptitle(f"Overturning under {name} (peak {peak:.2f} g)", fontsize=FONT + 1.0, color=INK)
    return figure


def _bottom(first: NDArray[np.float64], under: xr.Dataset) -> float:
    """Return where the panels begin: below the lowest edge that is drawn."""
    if np.isnan(first).all():
        return float(under.attrs["lowest_amplitude"])
    return 0.8 * float(np.nanmin(first))


def _bars(of_alpha: xr.Dataset) -> list[NDArray[np.float64]]:
    """Return rectangles over size and factor in which the bodies of one slenderness fall."""
    t = of_alpha["period"].values
    middle = np.sqrt(t[1:] * t[:-1])
    sides = np.concatenate((t[:1], middle, t[-1:]))
    return [
        np.array([(left, low), (right, low), (right, high), (left, high)])
        for place, (left, right) in enumerate(pairwise(sides.tolist()))
        for low, high in falling_ranges(of_alpha.isel(period=place))
    ]


def rocking_figure(under: xr.Dataset, record: Motion) -> Figure:
    """Draw the peak tilt over α under the record as it is, a line for each slenderness."""
    figure = new_figure(7.4, 4.8)
    axis = figure.subplots()
    style(axis)
    period = under["period"].values
    count = under.sizes["slenderness"]
    relative = (under["peak_tilt"] / under["slenderness"]).where(~under["overturned"])
    top = max(1.0, 1.05 * float(relative.max())) if bool(relative.notnull().any()) else 1.0
    for place in range(count):
        colour, line, marker = LINES[place % len(LINES)]
        alpha = float(under["slenderness"][place])
        look: dict[str, Any] = {"color": colour, "linestyle": line, "marker": marker, "markersize": 3.5}
        axis.plot(period, relative.isel(slenderness=place), label=f"α = {alpha:g} rad", **look)
        fallen = period[under["overturned"].isel(slenderness=place).values]
        height = np.full(len(fallen), top + 0.05 * (count - place))
        axis.plot(fallen, height, marker, color=colour, markersize=4.5)
    axis.axhline(top, color=MUTED, linewidth=0.8)
    look: dict[str, Any] = {"ha": "right", "va": "center", "fontsize": FONT - 1.0, "color": INK}
    axis.text(period[-1], top + 0.05 * (count + 1), "above the line: it falls ", **look)
    axis.set_ylim(0.0, top + 0.05 * (count + 2))
    _size_ticks(axis, period)
    axis.set_xlabel("2π/p [s]", fontsize=FONT)
    axis.set_ylabel("Peak tilt / α [–]", fontsize=FONT)
    axis.set_title(f"Rocking under {record.name or 'the record'} as it is", fontsize=FONT + 1.0, color=INK)
    axis.legend(loc="lower left", fontsize=FONT - 1.0)
    return figure
