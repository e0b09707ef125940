"""Verdicts of the plane beside those of space: how often they differ, and for which pieces."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import whole_within
from stayput.fragility import difference, probability
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import INK, MUTED
from studies.study import Quantity, Study, increasing
from studies.three_dimensions_runs import (
    CABINETS,
    ENGINES,
    FAMILIES,
    FLOORING,
    HEADINGS,
    LEVELS,
    SETTINGS,
    Shaken,
    outcomes,
)
from stayput.verification.notes import LONG

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.fragility import Difference, Probability
    from studies.three_dimensions_runs import ShapeSetting

PLANE, STRONGER, SPACE = ENGINES

SLIDES = 0.01
"""Slide from which on ratios of slides are taken [m]."""

CLASSES = {"short": "shorter than deep", "square": "square", "long": "1.5 times as long as deep, or more"}
"""Free boxes by shape, and what they are called; those of `ROUND` are cylinders."""

ROUND, LIMITED = "round", "limited"
"""Kinds of settings beside free boxes: free cylinders, and pieces before a wall or held."""

STRONGEST = "6-upper"
"""Class of intensity of the figures."""


def three_dimensions(motions: int = 12, *, headings: Sequence[float] = HEADINGS, seed: int = 1) -> Study:
    """Study how often the verdict of the plane differs from that of space, by shape, heading and device.

    Parameters
    ----------
    motions : int
        Synthetic motions of each family, scaled to the middle of each class of intensity.
    headings : sequence of float
        Angles in plan from the motions' x to the depth of a piece [degrees].
    seed : int
        Seed of motions and of the floor's friction.

    Returns
    -------
    Study
        Figures "differences" and "shapes". Data over ``setting``, ``level``, ``engine``, ``heading`` and
        ``motion``: whether it overturned, and the peak slide [m].

    Raises
    ------
    InputError
        A number out of range.

    Examples
    --------
    >>> import studies
    >>> quick = studies.three_dimensions(motions=2, headings=[0.0])
    >>> print(f"{quick.quantities['plane_differs'].label}: {quick.quantities['plane_differs']}")
    Verdicts that differ, component along the depth [%]: 12
    """
    count = whole_within("studies.motions", motions, 2, 1000)
    angles = increasing("simulation.heading", headings, -360.0, 360.0, "°")
    shaken = Shaken.of(count, angles.tolist(), seed)
    shape = (len(SETTINGS), len(LEVELS), len(ENGINES), len(angles), len(FAMILIES) * count)
    overturned, missing, slide = np.zeros(shape, np.bool_), np.zeros(shape, np.bool_), np.zeros(shape)
    with bar(len(SETTINGS) * len(LEVELS), "progress.studying", unit="progress.settings") as advance:
        for row, setting in enumerate(SETTINGS):
            for column, intensity in enumerate(LEVELS.values()):
                found = outcomes(setting, intensity, shaken)
                for place, engine in enumerate(ENGINES):
                    at = (row, column, place)
                    overturned[at], missing[at], slide[at] = found[engine]
                advance(1)
    over = ("setting", "level", "engine", "heading", "motion")
    data = xr.Dataset(
        {
            "overturned": (over, overturned, {"long_name": "whether it overturned"}),
            "missing": (over, missing, {"long_name": "whether the run was given up"}),
            "slide": (over, slide, {"long_name": "peak slide", "units": "m"}),
        },
        {
            "setting": [setting.name for setting in SETTINGS],
            "kind": ("setting", list(map(kind_of, SETTINGS))),
            "level": list(LEVELS),
            "intensity": ("level", list(LEVELS.values())),
            "engine": list(ENGINES),
            "heading": ("heading", angles, {"units": "degrees"}),
            "family": ("motion", np.repeat(FAMILIES, count)),
        },
        {"motions": count},
    )
    return Study(
        name="three-dimensions",
        title="The plane or space",
        quantities=_quantities(data),
        data=data,
        figures={"differences": draw_differences(data), "shapes": draw_shapes(data)},
        tables={
            f"Overturned at {level} [%], of pieces some of which do, and the differences from space in "
            "percentage points with their 95 % intervals": overturned_table(data, level)
            for level in reversed(LEVELS)
        }
        | {
            "Free boxes by shape: runs that differ [%], and differences from space in points": shapes_table(
                data
            ),
            f"Near-fault motions at {STRONGEST}, free boxes: differences from space in points, by the angle "
            "from the pulse to the depth": headings_table(data),
            f"Peak slide at {STRONGEST} of pieces that stand in both: medians [cm], and the median "
            "of space over plane where both slide 1 cm or more": slides_table(data),
        },
    )


def kind_of(setting: ShapeSetting) -> str:
    """Return the kind of a setting: a class of `CLASSES`, `ROUND` or `LIMITED`."""
    if not setting.is_free:
        return LIMITED
    if setting.round:
        return ROUND
    ratio = setting.length / setting.depth
    return "long" if ratio >= LONG - 1e-9 else "short" if ratio < 1.0 - 1e-9 else "square"


def less_space(data: xr.Dataset, engine: str) -> Difference:
    """Return the probability of overturning by an engine less that in space, paired by motion.

    Parameters
    ----------
    data : xarray.Dataset
        What is to count of the study's data: runs of one motion are taken as dependent.
    engine : str
        One of `ENGINES`.
    """
    given_up = _by_motion(data, "missing", engine) | _by_motion(data, "missing", SPACE)
    return difference(_by_motion(data, "overturned", engine), _by_motion(data, "overturned", SPACE), given_up)


def _by_motion(data: xr.Dataset, name: str, engine: str) -> NDArray[np.bool_]:
    """Return a quantity by an engine, shape (motions, runs of each)."""
    part = data[name].sel(engine=engine).transpose("motion", ...)
    return part.to_numpy().reshape(part.sizes["motion"], -1)


def differing(data: xr.Dataset, engine: str) -> float:
    """Return the share of runs whose overturning differs between an engine and space."""
    return float((data["overturned"].sel(engine=engine) != data["overturned"].sel(engine=SPACE)).mean())


def points(one: Difference) -> str:
    """Return a difference with its interval in percentage points: "−12 (−20 to −3)"."""
    middle, low, high = (
        f"{100.0 * value:+.0f}".replace("-", "−") for value in (one.estimate, one.low, one.high)
    )
    return f"{middle} ({low} to {high})"


def verdicts(data: xr.Dataset, kinds: Sequence[str], engine: str) -> tuple[int, int, int]:
    """Return for how many settings of some kinds and levels an engine says clearly less or more than space.

    Returns
    -------
    tuple of int
        Clearly less, clearly more, and how many there are.
    """
    part = data.sel(setting=data["kind"].isin(list(kinds)))
    found = [
        less_space(part.isel(setting=row, level=level), engine)
        for row in range(part.sizes["setting"])
        for level in range(part.sizes["level"])
    ]
    return sum(one.high < 0.0 for one in found), sum(one.low > 0.0 for one in found), len(found)


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    quantities = {
        "cases": Quantity("Runs of each engine", data["overturned"].size // len(ENGINES), form="d"),
        "given_up": Quantity("Runs given up, and left out", int(data["missing"].sum()), form="d"),
    }
    for key, label in ((PLANE, "component along the depth"), (STRONGER, "stronger component")):
        share = 100.0 * differing(data, key)
        quantities[f"{key}_differs"] = Quantity(f"Verdicts that differ, {label} [%]", share, form=".0f")
    for key, kinds in (("long", ("long",)), ("other", ("short", "square", ROUND))):
        for engine in (PLANE, STRONGER):
            less, more, of = verdicts(data, kinds, engine)
            named = CLASSES["long"] if key == "long" else "all other free pieces"
            quantities[f"{key}_{engine}_less"] = Quantity(f"{named}: {engine} clearly too low", less, of, "d")
            quantities[f"{key}_{engine}_more"] = Quantity(
                f"{named}: {engine} clearly too high", more, of, "d"
            )
    return quantities


def overturned_table(data: xr.Dataset, level: str) -> pd.DataFrame:
    """Return a row for each setting of which some overturn at a level."""
    rows: list[dict[str, str]] = []
    for place, name in enumerate(data["setting"].to_numpy().tolist()):
        part = data.isel(setting=place).sel(level=level)
        shares = 100.0 * part["overturned"].mean(("heading", "motion"))
        if not shares.any():
            continue
        row = {"piece": name}
        row |= {engine: f"{float(shares.sel(engine=engine)):.0f}" for engine in ENGINES}
        row["differ"] = f"{100.0 * differing(part, PLANE):.0f}"
        row |= {f"{engine} − space": points(less_space(part, engine)) for engine in (PLANE, STRONGER)}
        rows.append(row)
    return pd.DataFrame(rows)


def shapes_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each class of free boxes, on flooring and on rubber feet."""
    rows: list[dict[str, str]] = []
    rubber = np.array([setting.friction != FLOORING for setting in SETTINGS])
    for kind, called in CLASSES.items():
        for floor, chosen in (("flooring", ~rubber), ("rubber feet", rubber)):
            part = data.isel(setting=np.flatnonzero((data["kind"].to_numpy() == kind) & chosen))
            row = {"boxes": f"{called}, {floor}", "settings": str(part.sizes["setting"])}
            for level in list(LEVELS)[1:]:
                here = part.sel(level=level)
                row[f"{level}: differ"] = f"{100.0 * differing(here, PLANE):.0f}"
                row[f"{level}: plane"] = points(less_space(here, PLANE))
                row[f"{level}: stronger"] = points(less_space(here, STRONGER))
            rows.append(row)
    return pd.DataFrame(rows)


def pulses(data: xr.Dataset, kind: str) -> xr.Dataset:
    """Return the free boxes of a class under near-fault motions at `STRONGEST`."""
    return data.sel(setting=data["kind"] == kind, level=STRONGEST, motion=data["family"] == FAMILIES[0])


def headings_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each class of free boxes and each choice of the component."""
    called_by = {PLANE: "along the depth", STRONGER: "stronger"}
    rows: list[dict[str, str]] = []
    for kind, called in CLASSES.items():
        part = pulses(data, kind)
        for engine in called_by:
            row = {"boxes": called, "component": called_by[engine]}
            for place, angle in enumerate(data["heading"].to_numpy().tolist()):
                row[f"{angle:g}°"] = points(less_space(part.isel(heading=place), engine))
            rows.append(row)
    return pd.DataFrame(rows)


def slide_ratio(data: xr.Dataset) -> float:
    """Return the median of the slide in space over that in the plane where both stand and slide `SLIDES`."""
    plane, space = (data["slide"].sel(engine=engine).to_numpy() for engine in (PLANE, SPACE))
    both = ~data["overturned"].sel(engine=[PLANE, SPACE]).any("engine").to_numpy()
    counted = both & (plane >= SLIDES) & (space >= SLIDES)
    return float(np.median(space[counted] / plane[counted])) if counted.any() else np.nan


def slides_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each setting."""
    rows: list[dict[str, str]] = []
    for place, name in enumerate(data["setting"].to_numpy().tolist()):
        part = data.isel(setting=place).sel(level=STRONGEST)
        stands = ~part["overturned"].sel(engine=[PLANE, SPACE]).any("engine").to_numpy()
        row = {"piece": name, "runs": str(int(stands.sum()))}
        for engine in (PLANE, SPACE):
            slides = part["slide"].sel(engine=engine).to_numpy()[stands]
            row[engine] = f"{100.0 * np.median(slides):.1f}" if len(slides) else ""
        ratio = slide_ratio(part)
        row["space over plane"] = f"{ratio:.1f}" if np.isfinite(ratio) else ""
        rows.append(row)
    return pd.DataFrame(rows)


LOOKS = {
    PLANE: ("plane, component along the depth", "#0072b2", "o"),
    STRONGER: ("plane, stronger component", "#e69f00", "s"),
    SPACE: ("space, three components", INK, "D"),
}
"""What the engines are called in figures, their colours and markers."""


def draw_differences(data: xr.Dataset) -> Figure:
    """Draw by setting how many more overturn in the plane than in space, with intervals."""
    names = data["setting"].to_numpy().tolist()
    rows = np.arange(len(names), dtype=np.float64)
    levels = list(LEVELS)[1:]
    figure = new_figure(11.0, 0.34 * len(names) + 1.6)
    for axis, level in zip(figure.subplots(1, len(levels), sharey=True), levels, strict=True):
        style(axis, zero=False)
        axis.axvline(0.0, color=MUTED, linewidth=1.0)
        for engine, shift in ((PLANE, -0.16), (STRONGER, 0.16)):
            found = [less_space(data.isel(setting=row).sel(level=level), engine) for row in range(len(names))]
            _marked(axis, found, engine, rows + shift, upright=False)
        axis.set_title(level, fontsize=FONT)
        axis.set_xlim(-100.0, 100.0)
        axis.set_ylim(len(names) - 0.4, -0.6)
        axis.set_yticks(rows, names, fontsize=FONT - 1.0)
        axis.set_xlabel("fewer fall than in space ←  points  → more fall than in space", fontsize=FONT)
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=2, fontsize=FONT, frameon=False)
    return figure


def _marked(
    axis: Axes,
    found: Sequence[Difference | Probability],
    engine: str,
    at: NDArray[np.float64],
    *,
    upright: bool,
) -> None:
    """Draw estimates with their intervals in per cent, upright over x or lying at y."""
    label, colour, marker = LOOKS[engine]
    middle, low, high = (
        100.0 * np.array([getattr(one, end) for one in found]) for end in ("estimate", "low", "high")
    )
    x, y = (at, middle) if upright else (middle, at)
    ends = np.stack([middle - low, high - middle])
    axis.errorbar(
        x,
        y,
        yerr=ends if upright else None,
        xerr=None if upright else ends,
        fmt=marker,
        color=colour,
        markersize=5.5,
        linewidth=1.3,
        label=label,
    )


def draw_shapes(data: xr.Dataset) -> Figure:
    """Draw the share of cabinets that overturns over their length in planes and space, with intervals."""
    figure = new_figure(10.0, 4.6)
    half = len(CABINETS) // 2
    panels = {"wood flooring": CABINETS[:half], "rubber feet": CABINETS[half:]}
    for axis, (floor, cabinets) in zip(figure.subplots(1, 2, sharey=True), panels.items(), strict=True):
        style(axis, zero=False)
        ratio = np.array([one.length / one.depth for one in cabinets])
        for engine, shift in zip(ENGINES, (-0.02, 0.02, 0.0), strict=True):
            found = [
                probability(_by_motion(data.sel(setting=one.name, level=STRONGEST), "overturned", engine))
                for one in cabinets
            ]
            _marked(axis, found, engine, ratio + shift, upright=True)
            axis.plot(ratio + shift, [100.0 * one.estimate for one in found], color=LOOKS[engine][1], lw=1.0)
        axis.set_title(floor, fontsize=FONT)
        axis.set_xlabel("length over depth", fontsize=FONT)
        axis.set_ylim(-3.0, 103.0)
    figure.axes[0].set_ylabel(f"cabinets that overturn at {STRONGEST} [%]", fontsize=FONT)
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3, fontsize=FONT, frameon=False)
    return figure
