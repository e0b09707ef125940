"""What the other engine would say: the plane beside space, of free and of held pieces, by size and heading.

Nothing is drawn but the friction of the floor, and the same for both engines, so that what differs between
them is the third dimension.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
import xarray as xr

from stayput import Scenario, Suite, synthetic_suite
from stayput.fragility.paired import difference
from stayput.measures import MEASURES
from stayput.report.palette import INK
from stayput.scenario.measures import Option
from stayput.uncertainty import USUAL
from stayput.verification.option_runner import OptionRunner
from studies.study import COLOURS, Quantity, Study, panels

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.fragility.paired import Difference
    from stayput.montecarlo.runs import Runs

FAMILIES = ("near-fault", "crustal")
"""Earthquakes with a pulse along x, and some without direction; those of 100 to 300 s are left out."""

LEVELS = {"6-lower": 5.75, "6-upper": 6.25}
"""Classes of intensity, and the middle at which each is run."""

STRONGEST = "6-upper"
"""Class of intensity of the key numbers and of the figure."""

HEADINGS = (0.0, 45.0, 90.0)
"""Angles in plan from the depth of a piece to the motion's x, along which pulses are [degrees]."""

ENGINES = PLANE, SPACE = "plane", "space"
"""The plane under the component along the depth; space under all three."""

PIECES = {
    "short cabinet": (0.45, 0.30, 1.50, 80.0),
    "square cabinet": (0.45, 0.45, 1.50, 80.0),
    "long cabinet": (0.45, 0.90, 1.50, 80.0),
    "bookcase": (0.30, 0.90, 1.80, 200.0),
    "refrigerator": (0.65, 0.65, 1.75, 100.0),
    "low chest": (0.45, 0.90, 0.80, 60.0),
}
"""Depth, length and height [m], and mass [kg] of each piece; in the plane the cabinets are all the same."""

DEVICES = ("L-brackets", "belts", "tension poles", "gel mats")
"""What holds a piece by forces; a wedge stopper only tilts it."""

_KINDS = ("l_bracket", "belt", "tension_pole", "gel_mats", "wedge_stopper")
_HELD = zip((*DEVICES, "wedge stopper"), _KINDS, strict=True)
_FLOORING = {"static_friction": 0.40, "kinetic_friction": 0.30}

ROOMS: tuple[tuple[dict[str, Any], tuple[Option, ...]], ...] = (
    ({"floor": _FLOORING}, (Option("free"),)),
    ({"floor": {"static_friction": 0.80, "kinetic_friction": 0.60}}, (Option("free, rubber feet"),)),
    (
        {"floor": _FLOORING, "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
        (Option("wall alone"), *(Option(name, ((MEASURES[kind](),),)) for name, kind in _HELD)),
    ),
)
"""Rooms with wood flooring, and what holds the pieces in each; the friction of rubber feet is assumed."""

HOLDS = tuple(option.name for _, options in ROOMS for option in options)
FREE, WALLED = HOLDS[:2], HOLDS[2:]
"""What holds the pieces: nothing on two kinds of feet, and what there is before a wall."""

READ = "(plane / space; differences in points with 95 % intervals; slides of those that stand in both)"
"""How the tables are read."""


def suite_of(motions: int) -> Suite:
    """Return so many synthetic motions of each family."""
    made = (motion for family in FAMILIES for motion in synthetic_suite(family, motions))
    return Suite(tuple(made), " and ".join(FAMILIES))


def outcomes(
    piece: str, suite: Suite, engine: str, heading: float, intensity: float
) -> dict[str, NDArray[np.generic]]:
    """Return what became of a piece by an engine under motions, each with one draw of the floor's friction.

    Parameters
    ----------
    piece : str
        One of `PIECES`.
    suite : Suite
        The motions.
    engine : str
        One of `ENGINES`.
    heading : float
        Where the motions' x points in plan, from the depth of the piece [degrees].
    intensity : float
        JMA intensity of the ground.

    Returns
    -------
    dict
        Each of shape (holds, motions): whether it ``overturned``, was given up (``missing``), and whether a
        device ``failed``; its peak ``slide`` [m], along the depth in the plane and in any direction in space;
        and the largest utilisation of its devices, ``used``: force over strength, at least 1 where one
        failed.
    """
    tables: dict[str, Any] = {
        "furniture": dict(zip(("width", "length", "height", "mass"), PIECES[piece], strict=True)),
        "shaking": {"intensity": intensity},
        "direction": math.radians(heading),
        "dimensions": 2 if engine == PLANE else 3,
        "uncertainty": {"samples": len(suite), "as_stated": [name for name in USUAL if name != "friction"]},
    }
    runs: list[Runs] = []
    for room, options in ROOMS:
        scenario = Scenario.parse(tables | {"room": room}).with_python(motions=suite)
        runner = OptionRunner(scenario, 0.1, None)
        runs += runner.run(options, runner.members)
    return {
        "overturned": np.array([each.overturned for each in runs]),
        "missing": np.array([each.missing for each in runs]),
        "failed": np.array([each.device_failed for each in runs]),
        "slide": np.array([each.slide for each in runs]),
        "used": np.array([each.used.max(axis=-1, initial=0.0) for each in runs]),
    }


@dataclass(frozen=True, slots=True)
class Comparison:
    """The plane beside space over some runs; pairs are plane, then space.

    Parameters
    ----------
    overturned, failed : tuple of float
        Shares that overturn, and in which a device fails [%].
    less : Difference
        Probability of overturning in the plane less that in space, paired by motion.
    median, high : tuple of float
        Median and 90 % peak slide of the runs that stand in both [cm]; NaN where there are none.
    used : tuple of float
        Median utilisation.
    """

    overturned: tuple[float, ...]
    failed: tuple[float, ...]
    less: Difference
    median: tuple[float, ...]
    high: tuple[float, ...]
    used: tuple[float, ...]

    @classmethod
    def of(cls, data: xr.Dataset) -> Comparison:
        """Compare the engines over some runs of the study's data; those given up by one do not count."""
        ordered = data.transpose("engine", "motion", ...)
        shape = len(ENGINES), data.sizes["motion"], -1
        overturned, missing, failed, slide, used = (
            ordered[name].to_numpy().reshape(shape)
            for name in ("overturned", "missing", "failed", "slide", "used")
        )
        gone = missing.any(axis=0)
        slides = 100.0 * slide[:, ~(overturned.any(axis=0) | gone)]
        median, high = np.quantile(slides, (0.5, 0.9), axis=1) if slides.size else np.full((2, 2), math.nan)
        return cls(
            tuple(100.0 * overturned[:, ~gone].mean(axis=1)),
            tuple(100.0 * failed[:, ~gone].mean(axis=1)),
            difference(overturned[0], overturned[1], gone),
            tuple(median),
            tuple(high),
            tuple(np.median(used[:, ~gone], axis=1)),
        )

    @property
    def differing(self) -> float:
        """Share of runs of which one engine alone says that they overturn [%]."""
        return 100.0 * (self.less.more + self.less.fewer) / self.less.pairs

    @property
    def points(self) -> str:
        """Plane less space with its interval in percentage points: "−12 (−20 to −3)"."""
        ends = (round(100.0 * end) for end in (self.less.estimate, self.less.low, self.less.high))
        return "{} ({} to {})".format(*(f"{end:+d}".replace("-", "−") if end else "0" for end in ends))


def beside(pair: tuple[float, ...], form: str = ".0f") -> str:
    """Return a number of the plane beside that of space: "12 / 30", or nothing where there is none."""
    return "" if math.isnan(pair[0]) else " / ".join(format(value, form) for value in pair)


def three_dimensions(motions: int = 5, *, headings: Sequence[float] = HEADINGS) -> Study:
    """Study what the plane says beside space of free and of held pieces, by size and heading.

    Parameters
    ----------
    motions : int
        Synthetic motions of each family, scaled to the middle of each class of intensity.
    headings : sequence of float
        Angles in plan from the depth of a piece to the motions' x [degrees], rising.

    Returns
    -------
    Study
        Data over ``piece``, ``level``, ``heading``, ``engine``, ``hold`` and ``motion``: see `outcomes`.
    """
    suite = suite_of(motions)
    axes: dict[str, list[Any]] = {
        "piece": [*PIECES],
        "level": [*LEVELS],
        "heading": [*headings],
        "engine": [*ENGINES],
    }
    runs = [
        outcomes(piece, suite, engine, heading, LEVELS[level])
        for piece, level, heading, engine in itertools.product(*axes.values())
    ]
    shape = (*map(len, axes.values()), len(HOLDS), len(suite))
    data = xr.Dataset(
        {
            name: ((*axes, "hold", "motion"), np.array([each[name] for each in runs]).reshape(shape))
            for name in runs[0]
        },
        axes | {"hold": [*HOLDS], "family": ("motion", np.repeat(FAMILIES, motions))},
    )
    data["slide"].attrs["units"], data["heading"].attrs["units"] = "m", "degrees"
    free, walled, strongest = data.sel(hold=[*FREE]), data.sel(hold=[*WALLED]), data.sel(level=STRONGEST)
    return Study(
        name="three_dimensions",
        title="What the other engine would say",
        quantities=_quantities(data),
        data=data,
        figure=_drawn(strongest),
        tables={
            f"Free pieces {READ}": table(free, "piece", "hold", "level"),
            f"Before a wall, pieces of all sizes {READ}": table(walled, "hold", "level"),
            f"Before a wall at {STRONGEST}, by size {READ}": table(
                walled.sel(level=STRONGEST), "hold", "piece"
            ),
            f"All sizes at {STRONGEST}, by heading [°] {READ}": table(strongest, "hold", "heading"),
        },
    )


def table(data: xr.Dataset, *by: str) -> pd.DataFrame:
    """Return a row with what both engines say for each group of runs, by `hold` and another dimension."""
    rows: list[dict[str, str]] = []
    for place in itertools.product(*(data[name].to_numpy().tolist() for name in by)):
        group = dict(zip(by, place, strict=True))
        one = Comparison.of(data.sel({name: [value] for name, value in group.items()}))
        row = {name: f"{value:g}" if name == "heading" else str(value) for name, value in group.items()}
        row |= {"overturned [%]": beside(one.overturned), "plane − space": one.points}
        row |= {"median slide [cm]": beside(one.median, ".1f"), "90 % slide [cm]": beside(one.high, ".1f")}
        if group["hold"] in DEVICES:
            row |= {"one fails [%]": beside(one.failed), "median utilisation": beside(one.used, ".2f")}
        rows.append(row)
    return pd.DataFrame(rows).fillna("")


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    strongest, at = data.sel(level=STRONGEST), f"at {STRONGEST}"
    free, walled = data.sel(hold=[*FREE]), data.sel(hold=[*WALLED])
    slides = Comparison.of(strongest.sel(hold="free"))
    quantities = {
        "cases": Quantity("Runs of each engine", data["overturned"].size // len(ENGINES), form="d"),
        "given_up": Quantity("Runs given up, and left out", int(data["missing"].sum()), form="d"),
        "free_differ": Quantity("Verdicts that differ, free [%]", Comparison.of(free).differing, form=".0f"),
        "walled_differ": Quantity(
            "Verdicts that differ, before a wall [%]", Comparison.of(walled).differing, form=".0f"
        ),
        "median_slide": Quantity(
            f"Free, wood flooring: median slide {at} [cm]", beside(slides.median, ".1f")
        ),
        "high_slide": Quantity(f"Free, wood flooring: 90 % slide {at} [cm]", beside(slides.high, ".1f")),
    }
    for piece, (hold, floor) in itertools.product(PIECES, zip(FREE, ("flooring", "rubber"), strict=True)):
        points = Comparison.of(strongest.sel(piece=piece, hold=hold)).points
        label = f"{piece}, {hold}: plane less space {at} [points]"
        quantities[f"{_key(piece)}_{floor}"] = Quantity(label, points)
    for hold in WALLED:
        one, key = Comparison.of(strongest.sel(hold=hold)), _key(hold)
        quantities[f"{key}_less"] = Quantity(f"{hold}: plane less space {at} [points]", one.points)
        if hold in DEVICES:
            quantities[f"{key}_fail"] = Quantity(f"{hold}: one fails {at} [%]", beside(one.failed))
            quantities[f"{key}_used"] = Quantity(f"{hold}: median utilisation {at}", beside(one.used, ".2f"))
    return quantities


def _key(name: str) -> str:
    return name.removeprefix("L-").replace(" ", "_")


def _drawn(data: xr.Dataset) -> Figure:
    """Draw over the heading: cabinets that overturn, devices that fail, and how much these are used."""
    figure, axes = panels(2, 2, width=5.2)
    shares, over = 100.0 * data[["overturned", "failed"]].mean("motion"), data["heading"].to_numpy()
    fail, used = shares["failed"].mean("piece"), data["used"].median(("piece", "motion"))
    for axis, hold in zip(axes[:2], FREE, strict=True):
        of_hold = shares["overturned"].sel(hold=hold)
        plane = of_hold.sel(piece="square cabinet", engine=PLANE)
        axis.plot(over, plane, "o--", color=INK, mfc="white", label="plane, any length")
        for name, colour in zip(list(PIECES)[:3], COLOURS, strict=False):
            axis.plot(over, of_hold.sel(piece=name, engine=SPACE), "o-", color=colour, label=f"space, {name}")
        axis.set(title=f"Cabinets at {STRONGEST}, {hold}", ylabel="overturned [%]")
    for axis, values, label in zip(
        axes[2:], (fail, used), ("one fails [%]", "median utilisation"), strict=True
    ):
        for (name, colour), engine in itertools.product(zip(DEVICES, COLOURS, strict=False), ENGINES):
            line, face = ("o--", "white") if engine == PLANE else ("o-", colour)
            curve, called = values.sel(hold=name, engine=engine), f"{engine}, {name}"
            axis.plot(over, curve, line, color=colour, mfc=face, label=called)
        axis.set(title=f"Devices at {STRONGEST}, all sizes", ylabel=label)
    for axis, top in zip(axes, (100.0, 100.0, 100.0, 1.0), strict=True):
        axis.set(xlabel="angle from the depth to the motion's x [°]", xticks=over)
        axis.set(ylim=(-0.04 * top, 1.55 * top), yticks=np.linspace(0.0, top, 6))
        axis.legend(fontsize=8, ncols=2, loc="upper left")
    return figure
