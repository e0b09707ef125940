"""Turnover over width and wall distance under a record (the paper, §4.5, Table 4.3)."""

from __future__ import annotations

import math
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import ListedColormap
from matplotlib.patches import Rectangle

from stayput.motion.synthetic import near_fault
from stayput.report.palette import ALARM, INK
from stayput.scenario.sweep import sweep
from stayput.simulation.run import LAWS
from studies.study import COLOURS, Quantity, Study, label_edges, panels
from studies.wall_gap import DURATION, FALLEN, RATIO, WALLS, coordinates, table_4_2, turnover

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion.record import Motion
    from stayput.simulation.grid import Axes as Columns

Range = tuple[float, float]
"""First and last distance to the wall that turns a body over [m]."""

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

GAPS = np.linspace(0.0, 1.0, 101)
"""Distances to the wall [m]."""

POLARITIES = {1.0: "as recorded", -1.0: "reversed"}
"""Factors on the motion."""

Variant = tuple[float, str]
"""Polarity and side of the wall."""


def wall_gap_record(
    motion: Motion | None = None, *, widths: ArrayLike = tuple(TABLE_4_3), gaps: ArrayLike = GAPS
) -> Study:
    """Find the wall distances at which bodies of Table 4.2 turn over under a record, as in Table 4.3.

    Both contact laws, the record and its reverse, a wall on the left, on the right and on both sides.
    Only the motion's x component shakes, as in the paper.

    Parameters
    ----------
    motion : Motion, optional
        The record, of which the first 30 s shake; default `near_fault`. The paper's is JMA Kobe 1995, NS.
    widths, gaps : array_like
        Widths b of Table 4.3, and distances l_w from the body to the wall [m].

    Returns
    -------
    Study
        Data: ``overturned`` over law, polarity, wall, width and distance; ``overturned_free`` without a wall;
        ``reach_left`` and ``reach_right``, how far a body without a wall comes to a side [m].
    """
    shaking = (near_fault() if motion is None else motion).component("x")
    shaking = shaking.trimmed(0.0, min(DURATION, shaking.duration))
    b, l_w = np.asarray(widths, np.float64), np.asarray(gaps, np.float64)
    case = table_4_2(shaking)
    others: Columns = {"contact": LAWS, "motion.scale": list(POLARITIES)}
    result = turnover(case, b, l_w, others)
    bodies = {("body.width", "body.height"): (b, b / RATIO)}
    left, right = _reach(
        sweep(case, {**others, **bodies}, histories=("x", "tilt"), progress=False), result.free
    )
    free = ("contact", "motion.scale", "body.width")
    data = xr.Dataset(
        {
            "overturned": ((*free[:2], "wall", "body.width", "gap"), result.walled),
            "overturned_free": (free, result.free),
            "reach_left": (free, left, {"units": "m"}),
            "reach_right": (free, right, {"units": "m"}),
        },
        {**coordinates(b, l_w), "motion.scale": list(POLARITIES)},
        {"motion": shaking.name},
    )
    best = nearest(data)
    return Study(
        name="wall_gap_record",
        title="Turnover beside a wall under a record",
        quantities=_quantities(data, best, result.given_up),
        data=data,
        figure=_drawn(data),
        tables={
            **{f"T or N and the wall distances [m], law {law!r}": outcomes(data, law) for law in LAWS[::-1]},
            "Difference from Table 4.3, the nearest variant": differences(data, best),
        },
    )


def _reach(histories: xr.Dataset, free: NDArray[np.bool_]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return how far free bodies come beyond their left and right faces at the motion's samples [m]."""
    b, h = (histories[f"body.{name}"].to_numpy()[:, None] for name in ("width", "height"))
    x, tilt = histories["x"].to_numpy(), histories["tilt"].to_numpy()
    half = 0.5 * (b * np.abs(np.cos(tilt)) + h * np.abs(np.sin(tilt)))
    stands = np.where(free, np.nan, 0.0)
    left, right = (np.fmax.reduce(half + side * x - b / 2, axis=-1) for side in (-1.0, 1.0))
    return left + stands, right + stands


def _quantities(data: xr.Dataset, best: Variant, given_up: int) -> dict[str, Quantity]:
    agree, compared = _agreeing(data, best)
    shown = differences(data, best)
    beyond = int((shown["last, paper [m]"] > shown["reach without a wall [m]"]).sum())
    swapped = data["overturned"].sel({"wall": ["right", "left", "both"], "motion.scale": [-1.0, 1.0]})
    same = int((data["overturned"].to_numpy() == swapped.to_numpy()).sum())
    variant = f"wall: {best[1]}, the motion {POLARITIES[best[0]]}"
    quantities = {
        "nearest": Quantity("Variant nearest to Table 4.3, law 'paper'", variant),
        "agree": Quantity("Widths whose T or N agrees with Table 4.3", agree, compared, "d"),
        "ends": Quantity("Widths at which both have a range that ends", len(shown), form="d"),
        "beyond": Quantity("of these, with the paper's last beyond the body's reach", beyond, form="d"),
        "mirrored": Quantity(
            "Results that are those of their mirror image", same, data["overturned"].size, "d"
        ),
        "given_up": Quantity("Runs given up, counted as turned over", given_up, form="d"),
    }
    for row in shown.to_dict("records"):
        for key, name in (("first", "Nearest"), ("last", "Farthest")):
            label = f"{name} wall that turns over b = {row['b [m]']:g} m [m]"
            ours, paper = row[f"{key} [m]"], row[f"{key}, paper [m]"]
            quantities[f"{key}_{row['b [m]']:g}"] = Quantity(label, ours, paper, ".2f")
    return quantities


def of_paper(width: float) -> tuple[bool, Range | None]:
    """Return whether a width is in Table 4.3, and the paper's range for it."""
    found = [span for listed, span in TABLE_4_3.items() if abs(listed - width) < 1e-9]
    return bool(found), found[0] if found else None


def paper_words(width: float) -> str:
    """Return the paper's result for a width in its own manner; empty where it has none."""
    listed, span = of_paper(width)
    if span is None:
        return "N" if listed else ""
    first, last = span
    if math.isinf(last):
        return "T, without influence of wall"
    return f"T, {first:.2f}–{last:.2f}" if first else f"T, up to {last:.2f}"


def ranges(gaps: NDArray[np.float64], fallen: NDArray[np.bool_]) -> list[Range]:
    """Return first and last distance of each unbroken range of distances that turn a body over.

    Examples
    --------
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


def rows_of(data: xr.Dataset, variant: Variant, law: str = "paper") -> list[tuple[float, list[Range], bool]]:
    """Return width, ranges of distance that turn it over, and whether it does without a wall."""
    results = data.sel({"contact": law, "motion.scale": variant[0], "wall": variant[1]})
    gaps, widths = results["gap"].to_numpy(), results["body.width"].to_numpy()
    fallen, free = results["overturned"].to_numpy(), results["overturned_free"].to_numpy()
    return [
        (float(b), ranges(gaps, row), bool(alone)) for b, row, alone in zip(widths, fallen, free, strict=True)
    ]


def outcomes(data: xr.Dataset, law: str) -> pd.DataFrame:
    """Return T or N and the ranges of each width, the paper's column first."""
    widths = data["body.width"].to_numpy()
    table: dict[str, object] = {"b [m]": widths, "paper": [paper_words(b) for b in widths]}
    for polarity, wall in product(POLARITIES, WALLS):
        rows = rows_of(data, (polarity, wall), law)
        table[f"{wall}, {POLARITIES[polarity]}"] = [words(spans, free) for _, spans, free in rows]
    return pd.DataFrame(table)


def nearest(data: xr.Dataset) -> Variant:
    """Return the variant of the paper's law that comes nearest to Table 4.3.

    First by how many widths have the paper's T or N, then by the sum of the differences of the ends.
    """

    def distance(variant: Variant) -> float:
        ends = differences(data, variant)[["difference of first [m]", "difference of last [m]"]]
        return float(np.abs(ends.to_numpy()).sum())

    return min(product(POLARITIES, WALLS), key=lambda one: (-_agreeing(data, one)[0], distance(one)))


def _agreeing(data: xr.Dataset, variant: Variant) -> tuple[int, int]:
    """Return how many widths have the paper's T or N, and how many of Table 4.3's there are."""
    listed = [(bool(spans) or free, of_paper(b)) for b, spans, free in rows_of(data, variant)]
    agree = [falls == (paper is not None) for falls, (known, paper) in listed if known]
    return sum(agree), len(agree)


def differences(data: xr.Dataset, variant: Variant) -> pd.DataFrame:
    """Return both ends of each range beside the paper's, and how far the body comes without a wall."""
    polarity, wall = variant
    sides = ["reach_left", "reach_right"] if wall == "both" else [f"reach_{wall}"]
    reach = data.sel({"contact": "paper", "motion.scale": polarity})[sides].to_array().max("variable")
    rows: list[dict[str, float]] = []
    for b, spans, _ in rows_of(data, variant):
        paper = of_paper(b)[1]
        if not spans or paper is None or math.isinf(paper[1]):
            continue
        row = {"b [m]": b}
        for name, ours, theirs in zip(("first", "last"), (spans[0][0], spans[-1][1]), paper, strict=True):
            row |= {f"{name}, paper [m]": theirs, f"{name} [m]": ours}
            row[f"difference of {name} [m]"] = round(ours - theirs, 9)
        rows.append(row | {"reach without a wall [m]": float(reach.sel({"body.width": b}))})
    ends = [[f"{end}, paper [m]", f"{end} [m]", f"difference of {end} [m]"] for end in ("first", "last")]
    return pd.DataFrame(rows, columns=["b [m]", *ends[0], *ends[1], "reach without a wall [m]"])


def _drawn(data: xr.Dataset) -> Figure:
    """Draw a panel for each law, polarity and wall: distance across, a row for each width."""
    variants = list(product(LAWS[::-1], POLARITIES, WALLS))
    figure, axes = panels(len(WALLS), 2 * len(LAWS), width=4.0, height=3.0, sharex=True, sharey=True)
    for axis, (law, polarity, wall) in zip(axes, variants, strict=True):
        _panel(axis, data, law, (polarity, wall))
        axis.set_title(f"law “{law}”, {POLARITIES[polarity]}; wall: {wall}")
    label_edges(axes, len(WALLS), "distance to the wall [m]", "width [m]")
    figure.suptitle(
        f"{data.attrs['motion']}; filled: turns over; cross: without a wall, too\n"
        "frame: the paper's Table 4.3; diamond: how far it comes without a wall"
    )
    return figure


def _panel(axis: Axes, data: xr.Dataset, law: str, variant: Variant) -> None:
    polarity, wall = variant
    results = data.sel({"contact": law, "motion.scale": polarity})
    gaps, widths = data["gap"].to_numpy(), data["body.width"].to_numpy().tolist()
    rows, end = np.arange(len(widths)), float(gaps[-1])
    shown = np.where(results["overturned"].sel(wall=wall), 0.0, np.nan)
    axis.pcolormesh(gaps, rows, shown, cmap=ListedColormap([FALLEN]), shading="nearest")
    for row, span in zip(rows, (of_paper(width)[1] for width in widths), strict=True):
        if span is not None:
            size = (span[0], row - 0.4), min(span[1], end) - span[0], 0.8
            axis.add_patch(Rectangle(*size, fill=False, edgecolor=INK, lw=1.5))
    free = rows[results["overturned_free"].to_numpy()]
    axis.plot(np.full(len(free), 1.04 * end), free, "X", color=ALARM)
    for side in ("left", "right") if wall == "both" else (wall,):
        axis.plot(results[f"reach_{side}"], rows, "d", color=COLOURS[0])
    axis.set_yticks(rows, [f"{width:g}" for width in widths])
