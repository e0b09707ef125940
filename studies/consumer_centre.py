"""The Japanese consumer centre's shake-table test of June 2018, as far as it was published, beside the model.

Read: opening pages and press. A cupboard fell at 6-lower without a device and stayed with a wedge; a
refrigerator moved and nearly fell at 6-upper and stayed with a pole; at 7 the cupboard fell. Sizes, masses,
records, floor, wall and products were not read: the pieces are presets, the devices defaults, the motions
synthetic ones scaled to the class. Nothing is fitted.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.measures import TensionPole, WedgeStopper
from stayput.model.body import FURNITURE, Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.motion.suites.synthesis import synthetic_suite
from stayput.report.palette import ALARM, INK
from studies.study import NO, PARTLY, YES, Quantity, Study, claim, panels, span

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from stayput.measures import Measure

LOOKS = {
    "overturned": ("overturns", ALARM, "////"),
    "moved": ("moves 10 cm or more", "#f0e442", ""),
    "stayed": ("stays", "#b9d9ee", ""),
}
"""What became of a piece, what that is called, its colour and its hatch; 10 cm is ours."""

MOST = 0.5
"""Share of the cases from which on a result counts as ours."""

GAPS = {"touching": 0.0, "2 cm": 0.02, "5 cm": 0.05, "no wall": None}
"""Distances to the wall behind, which was not read [m]."""

SHAKINGS = {
    "crustal": ("crustal", 0.0),
    "crustal, 0.2 stronger": ("crustal", 0.2),
    "near-fault": ("near-fault", 0.0),
    "near-fault, 0.2 stronger": ("near-fault", 0.2),
}
"""Families of motions, and how far above the middle of the class: the records were not read either."""


@dataclass(frozen=True, slots=True)
class ShownTest:
    """A test that was shown, and what became of the piece.

    Parameters
    ----------
    piece : str
        Preset that stands for it.
    device : str
        What held it.
    measures : tuple of Measure
        The same here.
    strength : str
        Class of intensity.
    intensity : float
        The middle of the class, at which it is run.
    published : tuple of str
        Outcomes that agree with what was published.
    """

    piece: str
    device: str
    measures: tuple[Measure, ...]
    strength: str
    intensity: float
    published: tuple[str, ...]

    @property
    def name(self) -> str:
        """What it is called: "cupboard, wedge, 6-lower"."""
        return f"{self.piece}, {self.device}, {self.strength}"


TESTS = (
    ShownTest("cupboard", "no device", (), "6-lower", 5.75, ("overturned",)),
    ShownTest("cupboard", "wedge", (WedgeStopper(),), "6-lower", 5.75, ("stayed", "moved")),
    ShownTest("refrigerator", "no device", (), "6-upper", 6.25, ("moved",)),
    ShownTest("refrigerator", "poles", (TensionPole(),), "6-upper", 6.25, ("stayed",)),
    ShownTest("cupboard", "no device", (), "7", 6.75, ("overturned",)),
)
"""The tests; of a wedge it was said only that the piece did not fall."""


def consumer_centre(motions: int = 24, *, samples: int = 8, seed: int = 1) -> Study:
    """Study the consumer centre's tests of 2018 over motions, draws and distances to the wall.

    Parameters
    ----------
    motions : int
        Synthetic motions of each family, scaled to the middle of the class and to its upper end.
    samples : int
        Draws of friction, landings, mass, centre of gravity and strength under each motion.
    seed : int
        Seed of motions and draws.

    Returns
    -------
    Study
        Data over ``test``, ``shaking``, ``gap`` and ``outcome``: ``share`` of the cases.
    """
    drawn = draws(motions, samples, seed)
    share = np.zeros((len(TESTS), len(SHAKINGS), len(GAPS), len(LOOKS)))
    given_up = 0
    scaled_motions = {
        name: ScaledMotions(synthetic_suite(name, motions, seed)) for name in ("crustal", "near-fault")
    }
    for (row, test), (shaking, (family, above)) in product(enumerate(TESTS), enumerate(SHAKINGS.values())):
        preset = FURNITURE[test.piece]
        body = Body(preset.width, preset.height, preset.mass)
        floors = scaled_motions[family].at(test.intensity + above)
        for column, gap in enumerate(GAPS.values()):
            wall = None if gap is None else Wall(gap)
            room = Room(Floor.of("wood flooring"), left_wall=wall, ceiling=Ceiling(2.4))
            (runs,) = run_level([rows_of(body, room, test.measures, drawn, STANDARD_GRAVITY)], floors)
            known = ~runs.missing
            fell, moved = known & runs.overturned, known & ~runs.overturned & (runs.slide >= 0.10)
            counts = np.array([fell.sum(), moved.sum(), (known & ~fell & ~moved).sum()])
            share[row, shaking, column] = counts / max(int(known.sum()), 1)
            given_up += int(runs.missing.sum())
    data = xr.DataArray(
        share,
        {
            "test": [test.name for test in TESTS],
            "shaking": list(SHAKINGS),
            "gap": list(GAPS),
            "outcome": list(LOOKS),
        },
        name="share",
    ).to_dataset()
    claims = tuple(_claim(data, place) for place in range(len(TESTS)))
    met = [one["comes out"] for one in claims].count(YES)
    return Study(
        name="consumer_centre",
        title="The consumer centre's shake table of 2018",
        quantities={
            "met": Quantity("Tests that come out at every distance to the wall", met, len(TESTS), "d"),
            "given_up": Quantity("Runs given up, and left out", given_up, form="d"),
        },
        data=data,
        figure=_drawn(data),
        tables={
            "What was published, and ours under crustal motions": pd.DataFrame(claims),
            "The share of our cases that agree [%], by motions and distance to the wall": pd.DataFrame(
                [
                    {"test": test.name, "motions": shaking} | _percents(data, place, shaking)
                    for (place, test), shaking in product(enumerate(TESTS), SHAKINGS)
                ]
            ),
        },
        claims=claims,
    )


def agreement(data: xr.Dataset, place: int) -> xr.DataArray:
    """Return the share of a test's cases that agree with what was published, over ``shaking`` and ``gap``."""
    return data["share"].isel(test=place).sel(outcome=list(TESTS[place].published)).sum("outcome")


def _percents(data: xr.Dataset, place: int, shaking: str) -> dict[str, float]:
    agrees = 100.0 * agreement(data, place).sel(shaking=shaking)
    return dict(zip(GAPS, agrees.round().to_numpy().tolist(), strict=True))


def _claim(data: xr.Dataset, place: int) -> dict[str, str]:
    """Return a test beside the share of our cases that agree, by distance to the wall."""
    test, agrees = TESTS[place], agreement(data, place).isel(shaking=0).to_numpy()
    row = claim(
        f"Consumer centre 2018, {test.name}",
        " or ".join(LOOKS[kind][0] for kind in test.published),
        f"so in {span(100.0 * agrees, '.0f')} % of the cases by distance to the wall",
        int((agrees >= MOST).sum()),
        len(GAPS),
    )
    bare = next(n for n, one in enumerate(TESTS) if (one.piece, one.strength) == (test.piece, test.strength))
    if row["comes out"] == YES and test.measures and _claim(data, bare)["comes out"] == NO:
        row["comes out"] = PARTLY  # what does not fall without the device says little of the device
    return row


def _drawn(data: xr.Dataset) -> Figure:
    """Draw the shares of each outcome by test and distance to the wall, under crustal motions."""
    labels = [f"{test.name}; {gap}" for test, gap in product(TESTS, GAPS)]
    figure, (axis,) = panels(1, width=9.0, height=7.0)
    start = np.zeros(len(labels))
    for outcome, (words, colour, hatch) in LOOKS.items():
        width = 100.0 * data["share"].isel(shaking=0).sel(outcome=outcome).to_numpy().ravel()
        axis.barh(labels, width, 0.78, start, color=colour, hatch=hatch, edgecolor=INK, label=words)
        start = start + width
    axis.set_ylim(len(labels) - 0.5, -0.5)
    axis.set(xlim=(0.0, 100.0), xlabel="share of the cases [%]")
    figure.legend(loc="outside lower center", ncols=3, frameon=False)
    return figure
