"""What comes out of furniture, beside tests and reports of residents; nothing is fitted to them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.contents import CONTENTS, Contents
from stayput.contents.spill import spill
from stayput.measures import LBracket
from stayput.model.body import Body
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Floor, Room, Wall
from stayput.motion import near_fault, sine
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import INK, MUTED
from stayput.simulation.case import Case
from studies.study import PARTLY, YES, Claim, Quantity, Study, claims_table, increasing, outcome_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion import Motion

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

    Both pieces stand with their backs 2 cm from a wall and are shaken along x in both facings; shares are
    means of the two.

    Parameters
    ----------
    motion : Motion, optional
        The record, which is scaled to each intensity; default `near_fault`.
    intensities : array_like
        JMA intensities, rising; those of the reports are computed besides.

    Returns
    -------
    Study
        Figure "shares". Data over ``setting``, ``held`` and ``intensity``.

    Raises
    ------
    InputError
        Intensities that do not rise.

    Examples
    --------
    >>> import studies
    >>> quick = studies.contents(intensities=[5.5])
    >>> for name in ("out_held", "out_bare"):
    ...     print(f"{quick.quantities[name].label}: {quick.quantities[name]}")
    Books out of a bookcase with L-brackets at 6-upper: 38 %
    Books out of the same bookcase on the floor: 100 %
    """
    shaking = near_fault() if motion is None else motion
    asked = increasing("studies.intensities", intensities, 3.0, 7.5)
    levels = np.unique([*asked.tolist(), SIX_UPPER, SEVEN])
    with bar(len(SETTINGS) * len(HELD) * len(levels) * 2, "progress.studying") as advance:
        data = _computed(shaking, levels, advance)
    results = claims(data)
    pallets = _pallets()
    agree = [claim.outcome for claim in results].count(YES)
    return Study(
        name="contents",
        title="What is inside, beside tests and reports",
        quantities={
            "agree": Quantity("Reports that ours agrees with", agree, len(results), "d"),
            "out_held": Quantity(
                "Books out of a bookcase with L-brackets at 6-upper",
                f"{100.0 * _share(data, 'books, open', HELD[1], SIX_UPPER):.0f} %",
            ),
            "out_bare": Quantity(
                "Books out of the same bookcase on the floor",
                f"{100.0 * _share(data, 'books, open', HELD[0], SIX_UPPER):.0f} %",
            ),
            "pallets": Quantity("Pallet loads shed at rest [%]", pallets[0], 0.0, ".0f"),
            "pallets_shaken": Quantity("The same under a sine of 0.25 g and 2 Hz", pallets[1], form=".0f"),
        },
        data=data,
        figures={"shares": draw_shares(data)},
        tables={
            "Reports beside ours: share of the items that come out": claims_table(results),
            "Presets of contents (assumed but for the friction of pallet loads)": presets_table(),
        },
        claims=results,
    )


def _computed(motion: Motion, levels: NDArray[np.float64], advance: Callable[[int], None]) -> xr.Dataset:
    """Return the share that comes out and that of the pieces which overturn."""
    shape = (len(SETTINGS), len(HELD), len(levels))
    out, fell = np.zeros(shape), np.zeros(shape)
    room = Room(Floor.of("wood flooring"), left_wall=Wall(WALL))
    for place, (body, inside) in enumerate(SETTINGS.values()):
        for number, measures in enumerate(((), (LBracket(),))):
            for level, intensity in enumerate(levels.tolist()):
                scaled = motion.to_intensity(intensity)
                case = Case(body, room, scaled, measures=measures)
                both = [spill(replace(case, motion=m), inside) for m in (scaled, scaled.flipped())]
                out[place, number, level] = np.mean([one.share_out for one in both])
                fell[place, number, level] = np.mean([one.overturned for one in both])
                advance(2)
    over = ("setting", "held", "intensity")
    return xr.Dataset(
        {
            "out": (over, out, {"long_name": "share of the items that come out"}),
            "overturned": (over, fell, {"long_name": "share of the runs in which the piece overturns"}),
        },
        {
            "setting": list(SETTINGS),
            "held": list(HELD),
            "intensity": ("intensity", levels, {"long_name": "JMA intensity"}),
        },
    )


def _share(data: xr.Dataset, setting: str, held: str, intensity: float) -> float:
    return float(data["out"].sel(setting=setting, held=held, intensity=intensity))


def claims(data: xr.Dataset) -> tuple[Claim, ...]:
    """Return each report beside our share; whether it agrees is by `RANGES`."""
    found: list[Claim] = []
    for report in REPORTS:
        share = _share(data, report.setting, report.held, report.intensity)
        agrees = any(RANGES[word][0] <= share <= RANGES[word][1] for word in report.words)
        fell = float(
            data["overturned"].sel(setting=report.setting, held=report.held, intensity=report.intensity)
        )
        ours = (
            f"{report.setting}; {report.held}; {report.intensity:g}: {100.0 * share:.0f} % come out, the "
            f"piece overturns in {100.0 * fell:.0f} %"
        )
        outcome = outcome_of(int(agrees), 1)
        if agrees and report.words == ("none",) and fell >= 0.5:
            outcome = PARTLY  # latched doors are taken to stay shut in a fall
        found.append(Claim(report.source, report.claim, ours, outcome))
    return tuple(found)


def _pallets() -> tuple[float, float]:
    """Return the shares [%] of pallet loads shed from a rack whose shelves slope down to the front."""
    loads = Contents("pallet loads", shelves=1, slope=-SLOPE)
    rack = Body(1.1, 1.6, 2000.0)
    room = Room(Floor(3.0, 3.0))
    shares: list[float] = []
    for amplitude in (0.0, 0.25 * STANDARD_GRAVITY):
        motion = sine(max(amplitude, 1e-9), 2.0, 10.0)
        shares.append(100.0 * spill(Case(rack, room, motion), loads).share_out)
    return shares[0], shares[1]


def presets_table() -> pd.DataFrame:
    """Return the presets of contents."""
    return pd.DataFrame(
        [
            {
                "contents": name,
                "depth [m]": kind.width,
                "height [m]": kind.height,
                "static friction": kind.static_friction,
                "kinetic friction": kind.kinetic_friction,
                "setback [m]": kind.setback,
                "share of the mass": kind.mass_share,
            }
            for name, kind in CONTENTS.items()
        ]
    )


def draw_shares(data: xr.Dataset) -> Figure:
    """Draw what comes out over the intensity, on the floor and with L-brackets."""
    figure = new_figure(9.0, 6.4)
    axes = figure.subplots(2, 4, sharex=True, sharey=True).ravel()
    for axis, setting in zip(axes, SETTINGS, strict=True):
        for held, colour, line in zip(HELD, (MUTED, INK), ("--", "-"), strict=True):
            shares = 100.0 * data["out"].sel(setting=setting, held=held)
            axis.plot(data["intensity"], shares, line, color=colour, marker="o", markersize=3, label=held)
        axis.set_title(setting, fontsize=FONT)
        axis.set_ylim(-4.0, 104.0)
        style(axis)
    axes[0].legend(fontsize=FONT - 2.0, frameon=False)
    figure.supxlabel("JMA intensity", fontsize=FONT)
    figure.supylabel("items that come out [%]", fontsize=FONT)
    return figure
