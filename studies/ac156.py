"""What becomes, on the floors of buildings, of a piece that passes a shake-table test by AC156.

A piece passes where no motion of the test overturns it. The floors are those of buildings under earthquakes
whose ground has the spectrum that the test's S_DS stands for. Nothing is tuned.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import whole_within
from stayput.motion.suites import asce7
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import INK
from studies.ac156_runs import (
    BUILDINGS,
    HEIGHTS,
    LONG_PERIOD_RATIO,
    PIECES,
    ROOMS,
    TESTS,
    bodies,
    earthquakes,
    fallen,
    floors,
    slides,
    test_motions,
)
from studies.study import Quantity, Study, increasing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.motion.suites import Suite

OFTEN = 0.1
"""Share of the earthquakes from which on a piece that passed is said to fall often."""

COLOURS = ("#0072b2", "#e69f00", "#009e73")
"""Colours of the tests, in turn."""


def ac156(
    *,
    sds: Sequence[float] = (0.5, 1.0, 1.5),
    tests: int = 5,
    motions: int = 12,
    ground: Suite | None = None,
    seed: int = 1,
) -> Study:
    """Study whether pieces that pass AC156 survive the floors of buildings.

    Each piece stands unanchored. It passes at a height where it stands under every motion of the test there.
    On the floors at that height it is shaken by earthquakes that are scaled, not matched, to the spectrum of
    ASCE 7 with the same S_DS.

    Parameters
    ----------
    sds : sequence of float
        S_DS of the sites [g], increasing.
    tests : int
        Motions of each test.
    motions : int
        Synthetic earthquakes, where no ``ground`` is given.
    ground : Suite, optional
        Earthquakes of one's own, of any strength.
    seed : int
        Seed of all motions.

    Returns
    -------
    Study
        Figure "survival". Data over ``sds``, ``height``, ``piece``, ``floor`` (what the piece stands on),
        ``test`` and ``building``.

    Raises
    ------
    InputError
        A value out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> import studies
    >>> quick = studies.ac156(sds=[1.0], tests=1, ground=sp.Suite((sp.near_fault(),), "near the fault"))
    >>> wardrobe = quick.data.sel(sds=1.0, height=1.0, piece="wardrobe", floor="vinyl")  # on top floors
    >>> bool(wardrobe.passes.sel(test="AC156, ASCE 7-22"))
    True
    >>> wardrobe.overturned.to_series()  # share of the earthquakes
    building
    3-storey RC                  0.0
    10-storey RC                 0.0
    20-storey steel              1.0
    base-isolated 8-storey RC    0.0
    Name: overturned, dtype: float64
    """
    sites = increasing("motion.name_sds", sds, 0.05, 5.0, "g")
    count = whole_within("studies.motions", tests, 1, 1000)
    quakes = whole_within("studies.motions", motions, 1, 1000)
    pieces, rooms = bodies(), list(ROOMS.values())
    shape = len(sites), len(HEIGHTS), len(pieces), len(rooms)
    passes = np.zeros((*shape, len(TESTS)), np.bool_)
    share = np.zeros((*shape, len(BUILDINGS)))
    sliding = np.zeros((2, len(sites), len(HEIGHTS), len(BUILDINGS)))
    given_up = 0
    steps = len(HEIGHTS) * len(TESTS) + len(sites) * len(BUILDINGS)
    with bar(steps, "progress.studying", unit="progress.parts") as advance:
        for height, ratio in enumerate(HEIGHTS):
            for test, kind in enumerate(TESTS):
                unscaled = test_motions(kind, ratio, count, seed)
                for site, level in enumerate(sites.tolist()):
                    fell, lost = fallen(pieces, rooms, [motion.scaled(level) for motion in unscaled])
                    passes[site, height, ..., test] = ~fell.any(axis=-1)
                    given_up += lost
                advance(1)
        for site, level in enumerate(sites.tolist()):
            if ground is None:
                shaking = earthquakes(level, quakes, seed)
            else:
                shaking = ground.to_spectrum(asce7(level, LONG_PERIOD_RATIO * level))
            for place, building in enumerate(BUILDINGS.values()):
                for height, at_height in enumerate(floors(shaking.motions, building)):
                    fell, lost = fallen(pieces, rooms, at_height)
                    share[site, height, ..., place] = fell.mean(axis=-1)
                    sliding[:, site, height, place] = [_median(each) for each in slides(at_height)]
                    given_up += lost
                advance(1)
    over = ("sds", "height", "piece", "floor")
    slid = ("sds", "height", "building")
    data = xr.Dataset(
        {
            "passes": ((*over, "test"), passes, {"long_name": "stands under every motion of the test"}),
            "overturned": ((*over, "building"), share, {"long_name": "share of the earthquakes"}),
            "slide": (slid, sliding[0], {"units": "m", "long_name": "median peak slide, simulated"}),
            "slide_asce43": (slid, sliding[1], {"units": "m", "long_name": "median distance by ASCE 43-05"}),
        },
        {
            "sds": ("sds", sites, {"units": "g"}),
            "height": ("height", list(HEIGHTS), {"long_name": "z/h"}),
            "piece": list(PIECES),
            "floor": list(ROOMS),
            "test": [kind.name for kind in TESTS],
            "building": list(BUILDINGS),
        },
        {"tests": count, "earthquakes": quakes if ground is None else len(ground)},
    )
    return Study(
        name="ac156",
        title="A piece that passes AC156 on the floors of buildings",
        quantities=_quantities(data, given_up),
        data=data,
        figures={"survival": draw_survival(data)},
        tables={
            "Of the pieces that pass, the share of the earthquakes that overturn them [%], on average "
            "and at most": survival_table(data),
            "Pieces that pass though a tenth or more of the earthquakes overturn them, AC156 with ASCE 7-16, "
            "and the shares that do [%]": worst_table(data),
            "Median sliding distance of a squat piece [cm]: simulated, and by ASCE 43-05 (presumed)": (
                sliding_table(data)
            ),
        },
    )


def _median(values: NDArray[np.float64]) -> float:
    """Return the median; NaN where the half of the values or more are NaN."""
    return float(np.nanmedian(values)) if np.isfinite(values).mean() > 0.5 else np.nan


def passing(data: xr.Dataset, test: str) -> xr.DataArray:
    """Return the share that overturns of pieces that pass a test, NaN for others: over all but ``test``."""
    return data["overturned"].where(data["passes"].sel(test=test))


def _mean(shares: xr.DataArray) -> float:
    return 100.0 * float(shares.mean())


def _quantities(data: xr.Dataset, given_up: int) -> dict[str, Quantity]:
    quantities: dict[str, Quantity] = {}
    for place, test in enumerate(data["test"].to_numpy().tolist()):
        of_test = passing(data, test)
        known = of_test.notnull()
        often = 100.0 * float((of_test >= OFTEN).sum()) / max(int(known.sum()), 1)
        passed = int(data["passes"].sel(test=test).sum())
        key = ("edition_16", "edition_22", "whole")[place]
        quantities |= {
            f"{key}_passes": Quantity(
                f"{test}: cases that pass, of {data['passes'].size // 3}", passed, form="d"
            ),
            f"{key}_mean": Quantity(
                f"{test}: share of the earthquakes that overturn what passes [%]", _mean(of_test), form=".1f"
            ),
            f"{key}_often": Quantity(
                f"{test}: what passes and is overturned by a tenth or more of them [%]", often, form=".1f"
            ),
            f"{key}_most": Quantity(
                f"{test}: the largest share that overturns what passes [%]",
                100.0 * float(of_test.max()),
                form=".0f",
            ),
        }
    quantities["given_up"] = Quantity("Runs given up, counted as standing", given_up, form="d")
    return quantities


def survival_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each building and height: mean and largest share that overturns what passes [%]."""
    rows: list[dict[str, str]] = []
    for building in data["building"].to_numpy():
        for height in data["height"].to_numpy():
            row = {"building": str(building), "z/h": f"{height:g}"}
            for test in data["test"].to_numpy():
                shares = passing(data, test).sel(building=building, height=height)
                count = int(shares.notnull().sum())
                text = f"{_mean(shares):.0f}, {100 * float(shares.max()):.0f}" if count else "none passes"
                row[str(test)] = f"{text} ({count})" if count else text
            rows.append(row)
    return pd.DataFrame(rows)


def worst_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each piece that passes and often falls: where, and the share in each building."""
    shares = passing(data, TESTS[0].name)
    rows: list[dict[str, str]] = []
    for site, height, piece, floor in np.argwhere((shares >= OFTEN).any("building").to_numpy()).tolist():
        cell = shares.isel(sds=site, height=height, piece=piece, floor=floor)
        rows.append(
            {
                "piece": str(cell["piece"].item()),
                "floor": str(cell["floor"].item()),
                "S_DS [g]": f"{float(cell['sds']):g}",
                "z/h": f"{float(cell['height']):g}",
                **{
                    str(name): f"{100 * value:.0f}"
                    for name, value in zip(BUILDINGS, cell.values, strict=True)
                },
            }
        )
    return pd.DataFrame(rows)


def sliding_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each building and height: both distances at each S_DS [cm]."""
    rows: list[dict[str, str]] = []
    for building in data["building"].to_numpy():
        for height in data["height"].to_numpy():
            row = {"building": str(building), "z/h": f"{height:g}"}
            for sds in data["sds"].to_numpy():
                cell = 100.0 * data[["slide", "slide_asce43"]].sel(building=building, height=height, sds=sds)
                estimate = float(cell["slide_asce43"])
                formula = "none" if np.isnan(estimate) else f"{estimate:.1f}"
                row[f"S_DS {sds:g} g"] = f"{float(cell['slide']):.1f}, {formula}"
            rows.append(row)
    return pd.DataFrame(rows)


def draw_survival(data: xr.Dataset) -> Figure:
    """Draw how often what passes is overturned: a panel for each height, bars by building and test."""
    heights, buildings = data["height"].to_numpy(), data["building"].to_numpy().tolist()
    tests = data["test"].to_numpy().tolist()
    figure = new_figure(11.0, 4.6)
    panels = figure.subplots(1, len(heights), sharey=True, squeeze=False).ravel()
    across, width = np.arange(len(buildings)), 0.8 / len(tests)
    for axis, height in zip(panels, heights, strict=True):
        style(axis, zero=False)
        for place, (test, colour) in enumerate(zip(tests, COLOURS, strict=True)):
            shares = passing(data, test).sel(height=height)
            mean = 100.0 * shares.mean(("sds", "piece", "floor")).to_numpy()
            axis.bar(across + (place - 1) * width, mean, width, color=colour, edgecolor=INK, label=test)
        labels = [name.replace(" ", "\n").replace("-", "-\n", 1) for name in buildings]
        axis.set_xticks(across, labels, fontsize=FONT - 2.0)
        axis.set_title(f"z/h = {height:g}", fontsize=FONT, color=INK)
    panels[0].set_ylabel("earthquakes that overturn what passes [%]", fontsize=FONT)
    panels[0].legend(fontsize=FONT - 1.0)
    return figure
