"""What comes out of furniture, beside tests and reports of residents; nothing is fitted to them."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.contents.contents import CONTENTS, Contents
from stayput.contents.spill import spill
from stayput.measures import LBracket
from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Floor, Room, Wall
from stayput.motion.synthetic import near_fault, sine
from stayput.report.palette import INK, MUTED
from stayput.simulation.case import Case
from studies.study import PARTLY, YES, Quantity, Study, claim, panels

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

    from stayput.motion.record import Motion

BOOKCASE = Body(0.30, 1.80, 200.0)
CUPBOARD = Body(0.40, 1.80, 100.0)
WALL = 0.02
"""Gap to the wall behind [m]."""

SIX_UPPER, SEVEN = 6.25, 6.75
"""JMA intensities in the middle of the classes 6-upper and 7; the latter has no upper end."""

INTENSITIES = (5.25, 5.5, 5.75, 6.0, 6.25, 6.5, 6.75)

LIP = 0.03
"""Height of the lip [m]."""

SLOPE = math.radians(3.5)
"""Slope of the pallet rack's shelves [rad]."""

HELD = ("on the floor", "L-brackets")

SETTINGS: dict[str, tuple[Body, Contents]] = {
    **{f"{kind}, open": (BOOKCASE, Contents(kind)) for kind in ("books", "bottles", "boxes")},
    "books, lip": (BOOKCASE, Contents("books", lip=LIP)),
    "dishes, no doors": (CUPBOARD, Contents("dishes")),
    "dishes, hinged doors": (CUPBOARD, Contents("dishes", doors="hinged")),
    "dishes, latched doors": (CUPBOARD, Contents("dishes", doors="hinged, latched")),
    "dishes, sliding doors": (CUPBOARD, Contents("dishes", doors="sliding")),
}
"""What is in which piece, and what is in front of it."""

RANGES = {"none": (0.0, 0.05), "few": (0.05, 0.35), "many": (0.35, 0.8), "all": (0.8, 1.0)}
"""What the words of a report are taken to mean, as shares that come out."""


@dataclass(frozen=True, slots=True)
class Report:
    """What a test or residents reported, and which of our results stands beside it.

    Attributes
    ----------
    claim : str
        What was reported.
    source : str
        Who reported it.
    setting : str
        One of `SETTINGS`.
    held : str
        One of `HELD`.
    intensity : float
        JMA intensity.
    words : tuple of str
        Those of `RANGES` that agree with it.
    """

    claim: str
    source: str
    setting: str
    held: str
    intensity: float
    words: tuple[str, ...]


_CENTRE, _RESIDENTS = "Consumer centre 2018", "Residents' reports 2011"

REPORTS = (
    Report("no latches: all dishes out", _CENTRE, "dishes, hinged doors", HELD[0], SEVEN, ("all",)),
    Report("latches: dishes kept", _CENTRE, "dishes, latched doors", HELD[0], SEVEN, ("none",)),
    Report("hinged doors: all dishes out", _RESIDENTS, "dishes, hinged doors", HELD[1], SIX_UPPER, ("all",)),
    Report("sliding doors: a few out", _RESIDENTS, "dishes, sliding doors", HELD[1], SIX_UPPER, ("few",)),
    Report("a small lip kept books", _RESIDENTS, "books, lip", HELD[1], SIX_UPPER, ("none",)),
    Report(
        "fixed to the wall: lost its books", _RESIDENTS, "books, open", HELD[1], SIX_UPPER, ("many", "all")
    ),
    Report("not fixed: moved and kept them", _RESIDENTS, "books, open", HELD[0], SIX_UPPER, ("none", "few")),
)
"""Reports; the strength of those of residents is that of their class where they say one, else 6-upper."""


def contents(motion: Motion | None = None, intensities: ArrayLike = INTENSITIES) -> Study:
    """Compute what comes out of a bookcase and a cupboard, bare and held, and compare with reports.

    Parameters
    ----------
    motion : Motion, optional
        The record, which is scaled to each intensity; default `near_fault`.
    intensities : array_like
        JMA intensities; those of the reports are computed besides.

    Returns
    -------
    Study
        Data over ``setting``, ``held`` and ``intensity``.
    """
    shaking = near_fault() if motion is None else motion
    levels = np.unique([*np.ravel(intensities), SIX_UPPER, SEVEN])
    shape = (len(SETTINGS), len(HELD), len(levels))
    out, fell = np.zeros(shape), np.zeros(shape)
    room = Room(Floor.of("wood flooring"), left_wall=Wall(WALL))
    for level, intensity in enumerate(levels.tolist()):
        scaled = shaking.to_intensity(intensity)
        for place, (body, inside) in enumerate(SETTINGS.values()):
            for number, measures in enumerate(((), (LBracket(),))):
                case = Case(body, room, scaled, measures=measures)
                both = [spill(replace(case, motion=m), inside) for m in (scaled, scaled.flipped())]
                out[place, number, level] = np.mean([one.share_out for one in both])
                fell[place, number, level] = np.mean([one.overturned for one in both])
    over = ("setting", "held", "intensity")
    data = xr.Dataset(
        {
            "out": (over, out, {"long_name": "share of the items that come out"}),
            "overturned": (over, fell, {"long_name": "share of the runs in which the piece overturns"}),
        },
        {"setting": list(SETTINGS), "held": list(HELD), "intensity": levels},
    )
    results = tuple(_claim(data, report) for report in REPORTS)
    books = 100.0 * data["out"].sel(setting="books, open", intensity=SIX_UPPER)
    agree = [one["comes out"] for one in results].count(YES)
    return Study(
        name="contents",
        title="What is inside, beside tests and reports",
        quantities={
            "agree": Quantity("Reports that ours agrees with", agree, len(results), "d"),
            "out_held": Quantity(
                "Books out of a bookcase with L-brackets at 6-upper [%]", float(books[1]), form=".0f"
            ),
            "out_bare": Quantity(
                "Books out of the same bookcase on the floor [%]", float(books[0]), form=".0f"
            ),
            "pallets": Quantity("Pallet loads shed at rest [%]", _shed(0.0), 0.0, ".0f"),
            "pallets_shaken": Quantity("The same under a sine of 0.25 g and 2 Hz", _shed(0.25), form=".0f"),
        },
        data=data,
        figure=_drawn(data),
        tables={
            "Reports beside ours: share of the items that come out": pd.DataFrame(results),
            "Presets of contents (assumed but for the friction of pallet loads); m, and shares": (
                pd.DataFrame(map(asdict, CONTENTS.values()), list(CONTENTS))
                .rename_axis("contents")
                .reset_index()
            ),
        },
        claims=results,
    )


def _claim(data: xr.Dataset, report: Report) -> dict[str, str]:
    """Return a report beside our share; whether it agrees is by `RANGES`."""
    at = data.sel(setting=report.setting, held=report.held, intensity=report.intensity)
    share, fell = float(at["out"]), float(at["overturned"])
    agrees = any(RANGES[word][0] <= share <= RANGES[word][1] for word in report.words)
    ours = (
        f"{report.setting}; {report.held}; {report.intensity:g}: {100.0 * share:.0f} % come out, the "
        f"piece overturns in {100.0 * fell:.0f} %"
    )
    row = claim(report.source, report.claim, ours, int(agrees), 1)
    if agrees and report.words == ("none",) and fell >= 0.5:
        row["comes out"] = PARTLY  # latched doors are taken to stay shut in a fall
    return row


def _shed(amplitude: float) -> float:
    """Return the share [%] of pallet loads shed from shelves that slope to the front, under a sine [g]."""
    loads = Contents("pallet loads", shelves=1, slope=-SLOPE)
    motion = sine(max(amplitude * STANDARD_GRAVITY, 1e-9), 2.0, 10.0)
    return 100.0 * spill(Case(Body(1.1, 1.6, 2000.0), Room(Floor(3.0, 3.0)), motion), loads).share_out


def _drawn(data: xr.Dataset) -> Figure:
    """Draw what comes out over the intensity, on the floor and with L-brackets."""
    figure, axes = panels(4, 2, width=2.4, height=3.2, sharex=True, sharey=True)
    for axis, setting in zip(axes, SETTINGS, strict=True):
        for held, colour, line in zip(HELD, (MUTED, INK), ("--o", "-o"), strict=True):
            axis.plot(
                data["intensity"],
                100.0 * data["out"].sel(setting=setting, held=held),
                line,
                color=colour,
                label=held,
            )
        axis.set_title(setting, fontsize="medium")
    axes[0].legend()
    figure.supxlabel("JMA intensity")
    figure.supylabel("items that come out [%]")
    return figure
