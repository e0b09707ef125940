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
from matplotlib.patches import Patch

from stayput.errors import whole_within
from stayput.measures import TensionPole, WedgeStopper
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.motion.suites import synthetic_suite
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK
from studies.study import NO, PARTLY, YES, Claim, Quantity, Study, outcome_of, span

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from stayput.measures import Measure

OVERTURNED, MOVED, STAYED = "overturned", "moved", "stayed"
"""What became of a piece: it fell; it moved 10 cm or more; it stayed within that."""

MOVED_FROM = 0.10
"""Slide from which on a piece that stands has moved [m] (ours)."""

MOST = 0.5
"""Share of the cases from which on a result counts as ours."""

GAPS = (0.0, 0.02, 0.05, None)
"""Distances to the wall behind, which was not read [m]; None is no wall."""

SHAKINGS = {
    "crustal": ("crustal", 0.0),
    "crustal, 0.2 stronger": ("crustal", 0.2),
    "near-fault": ("near-fault", 0.0),
    "near-fault, 0.2 stronger": ("near-fault", 0.2),
}
"""Families of motions, and how far above the middle of the class: the records were not read either."""

CEILING = Ceiling(2.4)
"""Height of the ceiling, which was not read."""


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


TESTS = (
    ShownTest("cupboard", "no device", (), "6-lower", 5.75, (OVERTURNED,)),
    ShownTest("cupboard", "wedge", (WedgeStopper(),), "6-lower", 5.75, (STAYED, MOVED)),
    ShownTest("refrigerator", "no device", (), "6-upper", 6.25, (MOVED,)),
    ShownTest("refrigerator", "poles", (TensionPole(),), "6-upper", 6.25, (STAYED,)),
    ShownTest("cupboard", "no device", (), "7", 6.75, (OVERTURNED,)),
)
"""The tests; of a wedge it was said only that the piece did not fall."""

LOOKS = {
    OVERTURNED: ("overturns", ALARM, "////"),
    MOVED: ("moves 10 cm or more", "#f0e442", ""),
    STAYED: ("stays", "#b9d9ee", ""),
}
"""What each outcome is called, its colour and its hatch."""


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
        Figure "outcomes". Data over ``test``, ``shaking``, ``gap`` (NaN: no wall) and ``outcome``: ``share``
        of the cases.

    Raises
    ------
    InputError
        A number out of range.

    Examples
    --------
    >>> import studies
    >>> quick = studies.consumer_centre(motions=2, samples=1)
    >>> print(quick.quantities["met"], "of", quick.quantities["met"].published)
    1 of 5
    >>> dict(quick.data.share.sizes)
    {'test': 5, 'shaking': 4, 'gap': 4, 'outcome': 3}
    """
    count = whole_within("studies.motions", motions, 1, 1000)
    each = whole_within("studies.samples", samples, 1, 10_000)
    drawn = draws(count, each, seed)
    share = np.zeros((len(TESTS), len(SHAKINGS), len(GAPS), len(LOOKS)))
    given_up = 0
    hazards = {family: Hazard(synthetic_suite(family, count, seed)) for family in ("crustal", "near-fault")}
    work = list(product(enumerate(TESTS), enumerate(SHAKINGS.values())))
    with bar(len(work), "progress.studying", unit="progress.cases") as advance:
        for (row, test), (shaking, (family, above)) in work:
            preset = FURNITURE[test.piece]
            body = Body(preset.width, preset.height, preset.mass)
            floors = hazards[family].at(test.intensity + above)
            for column, gap in enumerate(GAPS):
                wall = None if gap is None else Wall(gap)
                room = Room(Floor.of("wood flooring"), left_wall=wall, ceiling=CEILING)
                rows = rows_of(body, room, test.measures, drawn, STANDARD_GRAVITY)
                (runs,) = run_level([rows], floors)
                known = ~runs.missing
                moved = known & ~runs.overturned & (runs.slide >= MOVED_FROM)
                fell = known & runs.overturned
                counts = np.array([fell.sum(), moved.sum(), (known & ~fell & ~moved).sum()])
                share[row, shaking, column] = counts / max(int(known.sum()), 1)
                given_up += int(runs.missing.sum())
            advance(1)
    data = xr.Dataset(
        {"share": (("test", "shaking", "gap", "outcome"), share, {"long_name": "share of the cases"})},
        {
            "test": [name_of(test) for test in TESTS],
            "shaking": list(SHAKINGS),
            "gap": ("gap", [np.nan if gap is None else gap for gap in GAPS], {"units": "m"}),
            "outcome": list(LOOKS),
        },
        {"motions": count, "samples": each},
    )
    table = outcomes_table(data)
    met = table["comes out"].tolist().count("yes")
    return Study(
        name="consumer-centre",
        title="The consumer centre's shake table of 2018",
        quantities={
            "met": Quantity("Tests that come out at every distance to the wall", met, len(TESTS), "d"),
            "given_up": Quantity("Runs given up, and left out", given_up, form="d"),
        },
        data=data,
        figures={"outcomes": draw_outcomes(data)},
        tables={
            "What was published, and the share of our cases that agree [%], by distance to the wall, under "
            "crustal motions": table,
            "The same by motions, with a wall at 2 cm and without one": shakings_table(data),
        },
        claims=tuple(_claim(data, place) for place in range(len(TESTS))),
    )


def name_of(test: ShownTest) -> str:
    """Return what a test is called: "cupboard, wedge, 6-lower"."""
    return f"{test.piece}, {test.device}, {test.strength}"


def agreement(data: xr.Dataset, place: int) -> xr.DataArray:
    """Return the share of a test's cases that agree with what was published, over ``shaking`` and ``gap``."""
    return data["share"].isel(test=place).sel(outcome=list(TESTS[place].published)).sum("outcome")


def _claim(data: xr.Dataset, place: int) -> Claim:
    """Return a test beside the share of our cases that agree, by distance to the wall."""
    test, agrees = TESTS[place], agreement(data, place).isel(shaking=0).to_numpy()
    outcome = outcome_of(int((agrees >= MOST).sum()), len(GAPS))
    bare = next(n for n, one in enumerate(TESTS) if (one.piece, one.strength) == (test.piece, test.strength))
    if outcome == YES and test.measures and _claim(data, bare).outcome == NO:
        outcome = PARTLY  # what does not fall without the device says little of the device
    return Claim(
        f"Consumer centre 2018, {name_of(test)}",
        " or ".join(LOOKS[kind][0] for kind in test.published),
        f"so in {span(100.0 * agrees, '.0f')} % of the cases by distance to the wall",
        outcome,
    )


def outcomes_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each test."""
    rows: list[dict[str, str]] = []
    for place, test in enumerate(TESTS):
        agrees = agreement(data, place).isel(shaking=0).to_numpy()
        row = {"test": name_of(test), "published": " or ".join(LOOKS[kind][0] for kind in test.published)}
        for gap, share in zip(GAPS, agrees, strict=True):
            row["no wall" if gap is None else f"{100 * gap:g} cm"] = f"{100 * share:.0f}"
        row["comes out"] = _claim(data, place).outcome
        rows.append(row)
    return pd.DataFrame(rows)


def shakings_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each test: the share that agrees [%] by motions, with a wall and without."""
    near, none = GAPS.index(0.02), GAPS.index(None)
    rows: list[dict[str, str]] = []
    for place, test in enumerate(TESTS):
        row = {"test": name_of(test)}
        for shaking in SHAKINGS:
            agrees = 100.0 * agreement(data, place).sel(shaking=shaking).to_numpy()
            row[shaking] = f"{agrees[near]:.0f}, {agrees[none]:.0f}"
        rows.append(row)
    return pd.DataFrame(rows)


def draw_outcomes(data: xr.Dataset) -> Figure:
    """Draw the shares of each outcome by test and distance to the wall, under crustal motions."""
    gaps = ["no wall" if gap is None else f"{100 * gap:g} cm" for gap in GAPS]
    labels = [f"{name}; {gap}" for name in data["test"].to_numpy() for gap in gaps]
    rows = np.arange(len(labels))
    figure = new_figure(9.0, 0.28 * len(labels) + 1.4)
    axis = figure.subplots()
    start = np.zeros(len(labels))
    for place, (_, colour, hatch) in enumerate(LOOKS.values()):
        width = 100.0 * data["share"].isel(shaking=0, outcome=place).to_numpy().ravel()
        axis.barh(rows, width, 0.78, start, color=colour, hatch=hatch, edgecolor=INK, linewidth=0.5)
        start = start + width
    style(axis, zero=False)
    axis.set_yticks(rows, labels, fontsize=FONT - 2.0)
    axis.set_ylim(len(labels) - 0.5, -0.5)
    axis.set_xlim(0.0, 100.0)
    axis.set_xlabel("share of the cases [%]", fontsize=FONT)
    patches = [Patch(facecolor=c, hatch=h, edgecolor=INK, label=words) for words, c, h in LOOKS.values()]
    figure.legend(handles=patches, loc="outside lower center", ncols=3, fontsize=FONT, frameon=False)
    return figure
