"""Turnover over width and wall distance under a record (the paper, §4.5 and Table 4.3)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from stayput.motion import near_fault
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK
from stayput.simulation.run import LAWS
from stayput.simulation.sweep import sweep
from studies.study import Quantity, Study, increasing
from studies.walls import FALLEN, RATIO, SIDES, WALLS, results_about, table_4_2, turnover

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion import Motion
    from stayput.simulation.axes import Axes as Columns

Range = tuple[float, float]
"""First and last distance [m]."""

TABLE_4_3: dict[float, Range | None] = {
    0.1: (0.0, math.inf),
    0.2: (0.0, 0.50),
    0.3: (0.0, 0.77),
    0.4: (0.02, 0.85),
    0.5: (0.05, 0.93),
    0.6: None,
    0.7: None,
    0.8: None,
    0.9: None,
    1.0: None,
}
"""The paper's Table 4.3: width [m], and the wall distances that turn it over; infinite: with any wall."""

POLARITIES = (1.0, -1.0)
"""Factors on the motion: as recorded, and reversed."""

Variant = tuple[str, float, str]
"""Contact law, polarity and side of the wall."""

WidthRow = tuple[float, list[Range], bool]
"""Width, ranges of distance at which it turns over, whether it does so without a wall."""

WIDEST_STEP = 0.02
"""Width of a bar of one distance, unless the distances are closer [m]."""

REACH = "#0072b2"
"""Colour of how far a body without a wall comes."""


def wall_gap_record(
    motion: Motion | None = None,
    *,
    widths: ArrayLike | None = None,
    gaps: ArrayLike | None = None,
) -> Study:
    """Find the wall distances at which bodies of Table 4.2 turn over under a record, as in Table 4.3.

    Both contact laws, the record and its reverse, a wall on the left, on the right and on both sides.
    Only the motion's x component shakes, as in the paper.

    Parameters
    ----------
    motion : Motion, optional
        The record; default `near_fault`. The paper's is the first 30 s of JMA Kobe 1995, NS.
    widths : array_like, shape [width], optional
        Widths b [m]; default Table 4.3's.
    gaps : array_like, shape [gap], optional
        Distances l_w from the body to the wall [m]; default 0 to 1 m by 0.01 m.

    Returns
    -------
    Study
        ``data`` holds ``overturned`` over law, polarity, wall, width and distance; ``overturned_free``
        without a wall; ``reach_left`` and ``reach_right``, how far a body without a wall comes to a side.

    Raises
    ------
    InputError
        Widths or distances out of range or not increasing.

    Examples
    --------
    >>> import studies
    >>> quick = studies.wall_gap_record(widths=[0.1, 0.2], gaps=[0.0, 0.2, 0.4])
    >>> reversed_motion = {"contact": "paper", "motion.scale": -1.0, "wall": "both"}
    >>> quick.data.overturned.sel(reversed_motion).to_pandas()
    gap           0.0    0.2    0.4
    body.width
    0.1         False   True   True
    0.2         False  False  False
    """
    shaking = (near_fault() if motion is None else motion).component("x")
    b = increasing("studies.width", tuple(TABLE_4_3) if widths is None else widths, 0.01, 10.0, "m")
    l_w = increasing(
        "studies.wall_gap", np.linspace(0.0, 1.0, 101) if gaps is None else gaps, 0.0, 100.0, "m"
    )
    data = _simulated(shaking, b, l_w)
    best = nearest(data)
    tables = {f"T or N and the wall distances [m], law {law!r}": outcomes(data, law) for law in LAWS[::-1]}
    tables["Difference from Table 4.3, the nearest variant"] = differences(data, best)
    return Study(
        name="wall-gap-record",
        title="Turnover beside a wall under a record",
        quantities=_quantities(data, best),
        data=data,
        figures={"ranges": draw_ranges(data)},
        tables=tables,
    )


def _simulated(motion: Motion, widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> xr.Dataset:
    case = table_4_2(motion)
    others: Columns = {"contact": LAWS, "motion.scale": POLARITIES}
    result = turnover(case, widths, gaps, others)
    bodies = {("body.width", "body.height"): (widths, widths / RATIO)}
    left, right = _reach(sweep(case, {**others, **bodies}, histories=("x", "tilt")), result.free)
    free = ("contact", "motion.scale", "body.width")
    far = {"units": "m", "long_name": "farthest that it comes without a wall; nan where it turns over"}
    about, coords = results_about(widths, gaps)
    return xr.Dataset(
        {
            "overturned": ((*free[:2], "wall", "body.width", "gap"), result.walled, about["overturned"]),
            "overturned_free": (free, result.free, about["overturned_free"]),
            "reach_left": (free, left, far),
            "reach_right": (free, right, far),
        },
        {**coords, "motion.scale": list(POLARITIES)},
        {"motion": motion.name, "aspect_ratio": RATIO, "given_up": result.given_up},
    )


def _reach(histories: xr.Dataset, free: NDArray[np.bool_]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return how far free bodies come beyond their left and right faces at the motion's samples [m]."""
    b, h = (histories[f"body.{name}"].to_numpy()[:, None] for name in ("width", "height"))
    x, tilt = histories["x"].to_numpy(), histories["tilt"].to_numpy()
    half = 0.5 * (b * np.abs(np.cos(tilt)) + h * np.abs(np.sin(tilt)))
    stands = np.where(free, np.nan, 0.0)
    left, right = (np.fmax.reduce(half + side * x - b / 2, axis=-1) for side in (-1.0, 1.0))
    return left + stands, right + stands


def _quantities(data: xr.Dataset, best: Variant) -> dict[str, Quantity]:
    agree, compared = _agreeing(data, best)
    _, polarity, wall = best
    ends, reach = _ends(data, best), _farther(data, best)
    beyond = sum(paper[1] > float(reach.sel({"body.width": b})) for b, paper, _ in ends)
    swapped = data["overturned"].sel({"wall": ["right", "left", "both"], "motion.scale": [-1.0, 1.0]})
    same = int((data["overturned"].to_numpy() == swapped.to_numpy()).sum())
    side = f"{SIDES[wall]}, the motion {polarity_name(polarity)}"
    quantities = {
        "nearest": Quantity("Variant nearest to Table 4.3", side),
        "agree": Quantity("Widths whose T or N agrees with Table 4.3", agree, compared, "d"),
        "ends": Quantity("Widths at which both have a range that ends", len(ends), form="d"),
        "beyond": Quantity("of these, with the paper's last beyond the body's reach", beyond, form="d"),
        "mirrored": Quantity("Results that are those of their mirror image", same, form="d"),
        "results": Quantity("Results", data["overturned"].size, form="d"),
        "given_up": Quantity("Runs given up, counted as turned over", int(data.attrs["given_up"]), form="d"),
    }
    for b, paper, ours in ends:
        for key, place in (("first", 0), ("last", 1)):
            label = f"{'Nearest' if place == 0 else 'Farthest'} wall that turns over b = {b:g} m [m]"
            quantities[f"{key}_{b:g}"] = Quantity(label, ours[place], paper[place], ".2f")
    return quantities


def of_paper(width: float) -> tuple[bool, Range | None]:
    """Return whether a width is in Table 4.3, and the paper's range for it."""
    for listed, span in TABLE_4_3.items():
        if abs(listed - width) < 1e-9:
            return True, span
    return False, None


def paper_words(width: float) -> str:
    """Return the paper's result for a width in its own manner; empty where it has none."""
    listed, span = of_paper(width)
    if not listed:
        return ""
    if span is None:
        return "N"
    first, last = span
    if math.isinf(last):
        return "T, without influence of wall"
    return f"T, {first:.2f}–{last:.2f}" if first else f"T, up to {last:.2f}"


def ranges(gaps: NDArray[np.float64], fallen: NDArray[np.bool_]) -> list[Range]:
    """Return first and last distance of each unbroken range of distances that turn a body over.

    Parameters
    ----------
    gaps : ndarray, shape [gap]
        Distances [m].
    fallen : ndarray of bool, shape [gap]
        Whether the body turns over.

    Examples
    --------
    >>> import numpy as np
    >>> ranges(np.array([0.0, 0.1, 0.2]), np.array([True, False, True]))
    [(0.0, 0.0), (0.2, 0.2)]
    """
    edges = np.diff(np.concatenate(([False], fallen, [False])).astype(np.int8))
    firsts, lasts = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
    return [(float(gaps[i]), float(gaps[j])) for i, j in zip(firsts, lasts, strict=True)]


def words(spans: list[Range], free: bool) -> str:
    """Return T or N, and the ranges; ``free`` is a body that turns over without a wall, too."""
    if not spans:
        return "T without a wall only" if free else "N"
    shown = ", ".join(f"{first:.2f}–{last:.2f}" if last > first else f"{first:.2f}" for first, last in spans)
    return f"T, {shown}; also without a wall" if free else f"T, {shown}"


def polarity_name(polarity: float) -> str:
    """Return the name of a factor of 1 or −1 on the motion."""
    return "as recorded" if polarity > 0.0 else "reversed"


def rows_of(data: xr.Dataset, variant: Variant) -> list[WidthRow]:
    """Return a variant's results, a row for each width."""
    law, polarity, wall = variant
    results = data.sel({"contact": law, "motion.scale": polarity, "wall": wall})
    gaps, widths = results["gap"].to_numpy(), results["body.width"].to_numpy()
    fallen, free = results["overturned"].to_numpy(), results["overturned_free"].to_numpy()
    return [
        (float(b), ranges(gaps, row), bool(alone)) for b, row, alone in zip(widths, fallen, free, strict=True)
    ]


def outcomes(data: xr.Dataset, law: str) -> pd.DataFrame:
    """Return T or N and the ranges of each width, the paper's column first."""
    widths = data["body.width"].to_numpy()
    table = {"b [m]": widths, "paper": [paper_words(b) for b in widths]}
    for polarity in data["motion.scale"].to_numpy():
        for wall in WALLS:
            rows = rows_of(data, (law, float(polarity), wall))
            table[f"{wall}, {polarity_name(polarity)}"] = [words(spans, free) for _, spans, free in rows]
    return pd.DataFrame(table)


def nearest(data: xr.Dataset) -> Variant:
    """Return the variant of the paper's law that comes nearest to Table 4.3.

    First by how many widths have the paper's T or N, then by the sum of the differences of the ends.
    """
    variants = [("paper", float(polarity), wall) for polarity in data["motion.scale"] for wall in WALLS]
    return min(variants, key=lambda variant: (-_agreeing(data, variant)[0], _distance(data, variant)))


def _agreeing(data: xr.Dataset, variant: Variant) -> tuple[int, int]:
    """Return how many widths have the paper's T or N, and how many of Table 4.3's there are."""
    listed = [(row, of_paper(row[0])[1]) for row in rows_of(data, variant) if of_paper(row[0])[0]]
    agree = [(bool(spans) or free) == (paper is not None) for (_, spans, free), paper in listed]
    return sum(agree), len(agree)


def _ends(data: xr.Dataset, variant: Variant) -> list[tuple[float, Range, Range]]:
    """Return width, the paper's range and our first and last, where both have one that ends."""
    ends: list[tuple[float, Range, Range]] = []
    for b, spans, _ in rows_of(data, variant):
        paper = of_paper(b)[1]
        if spans and paper is not None and math.isfinite(paper[1]):
            ends.append((b, paper, (spans[0][0], spans[-1][1])))
    return ends


def _distance(data: xr.Dataset, variant: Variant) -> float:
    ends = _ends(data, variant)
    return sum(abs(p - end) for _, paper, ours in ends for p, end in zip(paper, ours, strict=True))


def reach_of(data: xr.Dataset, variant: Variant) -> xr.DataArray:
    """Return how far bodies without a wall come to the side, or the farther side, of a variant's wall [m]."""
    law, polarity, wall = variant
    results = data.sel({"contact": law, "motion.scale": polarity})
    if wall != "both":
        return results[f"reach_{wall}"]
    return _farther(data, variant)


def _farther(data: xr.Dataset, variant: Variant) -> xr.DataArray:
    results = data.sel({"contact": variant[0], "motion.scale": variant[1]})
    return results[["reach_left", "reach_right"]].to_array().max("variable")


def differences(data: xr.Dataset, variant: Variant) -> pd.DataFrame:
    """Return both ends of each range beside the paper's, and how far the body comes without a wall."""
    reach = reach_of(data, variant)
    return pd.DataFrame(
        [
            {
                "b [m]": b,
                "first, paper [m]": paper[0],
                "first [m]": ours[0],
                "difference of first [m]": round(ours[0] - paper[0], 9),
                "last, paper [m]": paper[1],
                "last [m]": ours[1],
                "difference of last [m]": round(ours[1] - paper[1], 9),
                "reach without a wall [m]": float(reach.sel({"body.width": b})),
            }
            for b, paper, ours in _ends(data, variant)
        ]
    )


def draw_ranges(data: xr.Dataset) -> Figure:
    """Draw a panel for each law, polarity and wall: distance across, a row for each width."""
    variants = [(law, float(scale)) for law in LAWS[::-1] for scale in data["motion.scale"].to_numpy()]
    figure = new_figure(12.0, 3.0 * len(variants) + 0.9)
    panels = figure.subplots(len(variants), len(WALLS), sharex=True, sharey=True, squeeze=False)
    for row, (law, polarity) in zip(panels, variants, strict=True):
        for axis, wall in zip(row, WALLS, strict=True):
            _panel(axis, data, (law, polarity, wall))
            axis.set_title(f"law “{law}”, {polarity_name(polarity)}\n{SIDES[wall]}", fontsize=FONT)
        row[0].set_ylabel("width [m]", fontsize=FONT)
    for axis in panels[-1]:
        axis.set_xlabel("distance to the wall [m]", fontsize=FONT)
    figure.legend(
        handles=[
            Patch(facecolor=FALLEN, edgecolor=ALARM, hatch="////", label="turns over (T)"),
            Line2D([], [], color=ALARM, marker="X", linestyle="", label="turns over without a wall, too"),
            Patch(facecolor="none", edgecolor=INK, linewidth=1.5, label="the paper's Table 4.3 (its record)"),
            Line2D([], [], color=REACH, marker="d", linestyle="", label="how far it comes without a wall"),
        ],
        loc="outside lower center",
        ncols=4,
        fontsize=FONT,
        frameon=False,
    )
    return figure


def _panel(axis: Axes, data: xr.Dataset, variant: tuple[str, float, str]) -> None:
    law, polarity, wall = variant
    end = float(data["gap"].max())
    half = 0.5 * float(np.diff(data["gap"].to_numpy()).min(initial=WIDEST_STEP))
    for place, (b, spans, free) in enumerate(rows_of(data, variant)):
        for first, last in spans:
            low, high = max(first - half, 0.0), min(last + half, end)
            bar = (low, place - 0.27), high - low, 0.54
            axis.add_patch(Rectangle(*bar, facecolor=FALLEN, edgecolor=ALARM, hatch="////", linewidth=0.8))
        paper = of_paper(b)[1]
        if paper is not None:
            width = (end if math.isinf(paper[1]) else paper[1]) - paper[0]
            axis.add_patch(Rectangle((paper[0], place - 0.4), width, 0.8, fill=False, edgecolor=INK, lw=1.5))
        if free:
            axis.plot(1.04 * end, place, "X", color=ALARM, markersize=7)
    for side in ("left", "right") if wall == "both" else (wall,):
        reach = data[f"reach_{side}"].sel({"contact": law, "motion.scale": polarity}).to_numpy()
        axis.plot(reach, range(len(reach)), "d", color=REACH, markersize=5)
    axis.set_xlim(0.0, 1.08 * end)
    axis.set_yticks(range(data.sizes["body.width"]), [f"{b:g}" for b in data["body.width"].to_numpy()])
    axis.set_ylim(-0.6, data.sizes["body.width"] - 0.4)
    style(axis, zero=False)
