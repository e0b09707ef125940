"""Tables and text of the study of walls under a record."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import pandas as pd

from stayput.room import Wall
from stayput.simulation import LAWS
from stayput.studies.walls.map import MASS, WALLS, about_given_up
from stayput.studies.walls.ranges import of_paper, paper_words, ranges, words

if TYPE_CHECKING:
    import xarray as xr

    from stayput.motion import Motion
    from stayput.studies.walls.ranges import Range

Variant = tuple[str, float, str]
"""Contact law, polarity and side of the wall."""

Row = tuple[float, list["Range"], bool]
"""Width, ranges of distance at which it turns over, whether it does so without a wall."""


def polarity_name(polarity: float) -> str:
    """Return what a factor of 1 or −1 on the motion is called."""
    return "as recorded" if polarity > 0.0 else "reversed"


def rows_of(data: xr.Dataset, variant: Variant) -> list[Row]:
    """Return a variant's results, a row for each width."""
    law, polarity, wall = variant
    mine = data.sel({"contact": law, "motion.scale": polarity, "wall": wall})
    gaps, widths = mine["gap"].to_numpy(), mine["body.width"].to_numpy()
    fallen, free = mine["overturned"].to_numpy(), mine["overturned_free"].to_numpy()
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
            table[f"{wall}, {polarity_name(polarity)}"] = [words(found, free) for _, found, free in rows]
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
    return sum((bool(found) or free) == (paper is not None) for (_, found, free), paper in listed), len(
        listed
    )


def _ends(data: xr.Dataset, variant: Variant) -> list[tuple[float, Range, Range]]:
    """Return width, the paper's range and our first and last, where both have one that ends."""
    found: list[tuple[float, Range, Range]] = []
    for b, mine, _ in rows_of(data, variant):
        paper = of_paper(b)[1]
        if mine and paper is not None and math.isfinite(paper[1]):
            found.append((b, paper, (mine[0][0], mine[-1][1])))
    return found


def _distance(data: xr.Dataset, variant: Variant) -> float:
    ends = _ends(data, variant)
    return sum(abs(p - m) for _, paper, mine in ends for p, m in zip(paper, mine, strict=True))


def reach_of(data: xr.Dataset, variant: Variant) -> xr.DataArray:
    """Return how far bodies without a wall come to the side, or the farther side, of a variant's wall [m]."""
    law, polarity, wall = variant
    mine = data.sel({"contact": law, "motion.scale": polarity})
    if wall != "both":
        return mine[f"reach_{wall}"]
    return mine[["reach_left", "reach_right"]].to_array().max("variable")


def differences(data: xr.Dataset, variant: Variant) -> pd.DataFrame:
    """Return both ends of each range beside the paper's, and how far the body comes without a wall."""
    reach = reach_of(data, variant)
    return pd.DataFrame(
        [
            {
                "b [m]": b,
                "first, paper [m]": paper[0],
                "first [m]": mine[0],
                "difference of first [m]": round(mine[0] - paper[0], 9),
                "last, paper [m]": paper[1],
                "last [m]": mine[1],
                "difference of last [m]": round(mine[1] - paper[1], 9),
                "reach without a wall [m]": float(reach.sel({"body.width": b})),
            }
            for b, paper, mine in _ends(data, variant)
        ]
    )


def text_of(motion: Motion, data: xr.Dataset) -> str:
    """Return what was done and found."""
    gaps = data["gap"].to_numpy()
    made = " (synthetic)" if motion.synthetic else ""
    done = (
        f"Bodies of the paper's Table 4.2 (b/h = {data.attrs['aspect_ratio']:g}, {MASS:g} kg) under the "
        f"motion “{motion.name}”{made}, {motion.duration:g} s, peak {motion.pga:.3g} m/s², along x only; "
        f"{len(gaps)} wall distances from {gaps[0]:g} to {gaps[-1]:g} m. T: it turns over at some "
        f"distance or without a wall; N: it never does.{about_given_up(int(data.attrs['given_up']))}"
        f" The wall's friction, {Wall(0.0).friction:g}, is ours; only the law 'coulomb' uses it."
    )
    return "\n\n".join((done, _compared(data), _mirrored(data), _laws(data)))


def _compared(data: xr.Dataset) -> str:
    best = nearest(data)
    agree, listed = _agreeing(data, best)
    _, polarity, wall = best
    side = "walls on both sides" if wall == "both" else f"the wall on the {wall}"
    parts = [
        "The paper's column belongs to the record of JMA Kobe of 1995, NS, 30 s.",
        "Beside another motion it stands for orientation.",
        f"Nearest to Table 4.3 comes {side} with the motion {polarity_name(polarity)}:",
        f"T or N agree at {agree} of {listed} widths.",
    ]
    ends = _ends(data, best)
    if ends:
        firsts = ", ".join(f"{mine[0]:.2f} ({paper[0]:.2f}) m at b = {b:g} m" for b, paper, mine in ends)
        lasts = ", ".join(f"{mine[1]:.2f} ({paper[1]:.2f}) m at b = {b:g} m" for b, paper, mine in ends)
        parts.append(f"The nearest wall that turns it over, with the paper's in brackets: {firsts}.")
        parts.append(f"The farthest: {lasts}.")
        parts.append(_why(data, best, ends))
    return " ".join(parts)


def _why(data: xr.Dataset, best: Variant, ends: list[tuple[float, Range, Range]]) -> str:
    """Compare the paper's last distances with how far the body comes without a wall."""
    law, polarity, _ = best
    mine = data.sel({"contact": law, "motion.scale": polarity})
    farther = mine[["reach_left", "reach_right"]].to_array().max("variable")
    reached = [(b, paper[1], float(farther.sel({"body.width": b}))) for b, paper, _ in ends]
    beyond = [(b, last, reach) for b, last, reach in reached if last > reach]
    if not beyond:
        return "All of the paper's last distances are within the reach of the body without a wall."
    said = ", ".join(f"{reach:.2f} m at b = {b:g} m" for b, _, reach in beyond)
    return (
        f"The paper's last distance is beyond the body's reach at {len(beyond)} of these {len(reached)} "
        f"widths: without a wall it comes no farther than {said}, to either side, at the record's samples, "
        "and a wall beyond that is never touched. So no rule for the wall gives these ends: the paper's body "
        "moved farther than ours does under the same rules and coefficients, or its distance is measured "
        "otherwise."
    )


def _mirrored(data: xr.Dataset) -> str:
    """Compare the reversed motion with the wall on the other side."""
    swapped = {"left": "right", "right": "left", "both": "both"}
    fallen = data["overturned"]
    other = fallen.sel({"wall": [swapped[wall] for wall in WALLS], "motion.scale": [-1.0, 1.0]})
    same = int((fallen.to_numpy() == other.to_numpy()).sum())
    return (
        "A reversed motion with the wall on the left mirrors the motion as recorded with the wall on the "
        f"right: {same} of {fallen.size} results are the same as those of their mirror image."
    )


def _laws(data: xr.Dataset) -> str:
    parts: list[str] = []
    for law in LAWS[::-1]:
        found: list[str] = []
        for wall in WALLS:
            rows = rows_of(data, (law, 1.0, wall))
            fell = [f"{b:g}" for b, spans, free in rows if spans and not free]
            found.append(f"{wall}: {', '.join(fell) if fell else 'none'}")
        alone = [f"{b:g}" for b, _, free in rows_of(data, (law, 1.0, WALLS[0])) if free]
        parts.append(
            f"Law {law!r}, motion as recorded: without a wall these widths turn over [m]: "
            f"{', '.join(alone) if alone else 'none'}. Only beside a wall, by its side: {'; '.join(found)}."
        )
    return " ".join(parts)
