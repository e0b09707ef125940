"""Fallen gravestones against intensity, beside surveys: what closes the gap, and what does not."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import whole_within
from stayput.fallen import Fallen, intensity_from_fallen
from stayput.model.body import Body
from stayput.model.room import Floor, Room
from stayput.motion.suites import synthetic_suite
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from studies.study import Claim, Quantity, Study, outcome_of
from studies.tombstones_runs import (
    ASPECT,
    DENSITY,
    FRICTION,
    LEVELS,
    OBSERVED,
    RESTITUTION,
    SETTINGS,
    STATED,
    SUN,
    cemeteries,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from stayput.fragility.fallen import IntensityEstimate
    from studies.tombstones_runs import CemeterySetting


COUNTED, FELL = 40, (0, 4, 10, 20, 30, 36, 40)
"""Stones of a place, and how many of them fell, for the inverse."""


def tombstones(
    motions: int = 32,
    *,
    stones: int = 24,
    settings: Sequence[CemeterySetting] = SETTINGS,
    seed: int = 1,
) -> Study:
    """Study which share of gravestones falls at each class of intensity, changing one assumption at a time.

    Upper stones stand loose on flat bases and rock in one plane. Each motion stands for a place: the mean
    share is over all places, its spread from place to place that of the motions.

    Parameters
    ----------
    motions : int
        Earthquakes, each scaled to the middle of each class.
    stones : int
        Stones of a place.
    settings : sequence of CemeterySetting
        What is assumed; the first is the setting as stated.
    seed : int
        Seed of motions, sizes and draws.

    Returns
    -------
    Study
        Figure "shares". Data over ``setting``, ``level`` and ``place``.

    Raises
    ------
    InputError
        A number out of range.

    Examples
    --------
    >>> import studies
    >>> quick = studies.tombstones(motions=2, stones=2)
    >>> for name in ("share_5_upper", "share_7"):  # of the stones [%], ours and observed
    ...     print(f"{quick.quantities[name]}, {quick.quantities[name].published}")
    0, 0 to 23
    100, 90 to 100
    """
    count = whole_within("studies.motions", motions, 2, 1000)
    of_a_place = whole_within("studies.stones", stones, 1, 10_000)
    share = np.zeros((len(settings), len(LEVELS), count))
    given_up = 0
    with bar(len(settings), "progress.studying", unit="progress.settings") as advance:
        for row, setting in enumerate(settings):
            found = cemeteries(setting, count, of_a_place, seed)
            share[row] = found.fell.mean(axis=2)
            given_up += found.given_up
            advance(1)
    low, high = np.array(list(OBSERVED.values())).T
    data = xr.Dataset(
        {
            "share": (("setting", "level", "place"), share, {"long_name": "share of the stones that fall"}),
            "observed_low": ("level", low, {"long_name": "smallest share observed"}),
            "observed_high": ("level", high, {"long_name": "largest share observed"}),
        },
        {
            "setting": [setting.name for setting in settings],
            "level": list(LEVELS),
            "intensity": ("level", list(LEVELS.values())),
        },
        {"stones": of_a_place},
    )
    return Study(
        name="tombstones",
        title="Fallen gravestones and intensity",
        quantities=_quantities(data, given_up),
        data=data,
        figures={"shares": draw_shares(data)},
        tables={
            "Share of the stones that fall [%]: mean over the places, and the tenth and ninth tenth of the "
            "places in brackets": shares_table(data),
            "The inverse: intensity, with its 95 % interval, of a place where so many of "
            f"{COUNTED} stones of 9 sun fell": inverse_table(count, seed),
        },
        claims=claims(data),
    )


def claims(data: xr.Dataset) -> tuple[Claim, ...]:
    """Return the surveys of each class beside our mean share, as stated."""
    share = 100.0 * data["share"].isel(setting=0).mean("place")
    met = inside(data).isel(setting=0)
    return tuple(
        Claim(
            f"Gravestones, surveys: JMA {level}",
            f"{100.0 * low:.0f} to {100.0 * high:.0f} % fell",
            f"{float(share.sel(level=level)):.0f} %, {STATED.name}",
            outcome_of(int(met.sel(level=level)), 1),
        )
        for level, (low, high) in OBSERVED.items()
    )


def inside(data: xr.Dataset) -> xr.DataArray:
    """Return whether the mean share is within what was observed, over setting and level."""
    mean = data["share"].mean("place")
    return (mean >= data["observed_low"]) & (mean <= data["observed_high"])


def _quantities(data: xr.Dataset, given_up: int) -> dict[str, Quantity]:
    mean = 100.0 * data["share"].isel(setting=0).mean("place")
    quantities: dict[str, Quantity] = {}
    for level in data["level"].to_numpy().tolist():
        low, high = (100.0 * edge for edge in OBSERVED[level])
        key = level.replace("-", "_")
        label = f"Share that falls at {level}, {STATED.name} [%]"
        quantities[f"share_{key}"] = Quantity(
            label, f"{float(mean.sel(level=level)):.0f}", f"{low:.0f} to {high:.0f}"
        )
    met = inside(data).sum("level").to_numpy()
    quantities["met"] = Quantity("Classes within what was observed, as stated", int(met[0]), len(LEVELS), "d")
    quantities["most_met"] = Quantity("The most in any setting", int(met.max()), len(LEVELS), "d")
    quantities["given_up"] = Quantity("Runs given up, counted as standing", given_up, form="d")
    return quantities


def shares_table(data: xr.Dataset) -> pd.DataFrame:
    """Return what was observed, then a row for each setting."""
    observed = {level: f"{100 * low:.0f} to {100 * high:.0f}" for level, (low, high) in OBSERVED.items()}
    rows = [{"setting": "**observed**", **observed, "within": ""}]
    met = inside(data)
    for place, name in enumerate(data["setting"].to_numpy().tolist()):
        row = {"setting": name}
        for level in data["level"].to_numpy().tolist():
            share = 100.0 * data["share"].isel(setting=place).sel(level=level).to_numpy()
            low, high = np.quantile(share, [0.1, 0.9])
            row[level] = f"{share.mean():.0f} ({low:.0f} to {high:.0f})"
        row["within"] = f"{int(met.isel(setting=place).sum())} of {len(LEVELS)}"
        rows.append(row)
    return pd.DataFrame(rows)


def inverse_table(motions: int, seed: int) -> pd.DataFrame:
    """Return a row for each count of fallen stones: the intensity under motions of two families."""
    width = 9.0 * SUN
    height = ASPECT * width
    stone = Body(width, height, DENSITY * width**2 * height)
    room = Room(Floor(*FRICTION, restitution=RESTITUTION))
    rows: list[dict[str, str]] = []
    for fell in FELL:
        row = {"fell": f"{fell}"}
        for family in ("crustal", "near-fault"):
            suite = synthetic_suite(family, motions, seed)
            pieces = [Fallen(stone, fell, COUNTED, room)]
            found = intensity_from_fallen(pieces, motions=suite, samples=8, seed=seed)
            row[f"{family} motions"] = _estimate(found)
        rows.append(row)
    return pd.DataFrame(rows)


def _estimate(found: IntensityEstimate) -> str:
    if np.isfinite(found.intensity):
        return f"{found.intensity:.1f} ({found.low:.1f} to {found.high:.1f})"
    if np.isfinite(found.high):
        return f"at most {found.high:.1f}"
    return f"at least {found.low:.1f}" if np.isfinite(found.low) else "unknown"


def draw_shares(data: xr.Dataset) -> Figure:
    """Draw the mean share of each setting over the classes, over the bands that were observed."""
    levels = data["level"].to_numpy().tolist()
    figure = new_figure(9.5, 5.4)
    axis = figure.subplots()
    style(axis, zero=False)
    across = np.arange(len(levels), dtype=np.float64)
    low, high = (100.0 * data[f"observed_{end}"].to_numpy() for end in ("low", "high"))
    axis.bar(across, high - low, 0.86, low, color="#b9d9ee", edgecolor="none", label="observed")
    mean = 100.0 * data["share"].mean("place").to_numpy()
    spread = np.linspace(-0.36, 0.36, len(mean))
    names = data["setting"].to_numpy().tolist()
    last = len(mean) - 1
    for place, shares in enumerate(mean):
        colour = ALARM if place == 0 else INK if place == last else MUTED
        size = 7.0 if place in (0, last) else 4.5
        label = (
            names[place]
            if place in (0, last)
            else "one change each, in the table's order"
            if place == 1
            else None
        )
        axis.plot(across + spread[place], shares, "o", color=colour, markersize=size, label=label)
    axis.set_xticks(across, levels, fontsize=FONT)
    axis.set_ylim(0.0, 101.0)
    axis.set_xlabel("class of intensity", fontsize=FONT)
    axis.set_ylabel("stones that fall [%]", fontsize=FONT)
    figure.legend(loc="outside lower center", ncols=2, fontsize=FONT - 1.0, frameon=False)
    return figure
