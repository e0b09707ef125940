"""Turnover over width and wall distance under a record (the paper, §4.5 and Table 4.3)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.ensemble import sweep
from stayput.motion import near_fault
from stayput.simulation import LAWS
from stayput.studies.study import Study
from stayput.studies.walls.map import RATIO, WALLS, increasing, table_4_2, turnover
from stayput.studies.walls.ranges import TABLE_4_3
from stayput.studies.walls.record_figure import draw_ranges
from stayput.studies.walls.record_text import differences, nearest, outcomes, text_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from stayput.ensemble.axes import Axes
    from stayput.motion import Motion

POLARITIES = (1.0, -1.0)
"""Factors on the motion: as recorded, and reversed."""


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
    """
    shaking = (near_fault() if motion is None else motion).component("x")
    b = increasing("Width", tuple(TABLE_4_3) if widths is None else widths, 0.01, 10.0)
    l_w = increasing("Wall gap", np.linspace(0.0, 1.0, 101) if gaps is None else gaps, 0.0, 100.0)
    data = _simulated(shaking, b, l_w)
    tables = {f"T or N and the wall distances [m], law {law!r}": outcomes(data, law) for law in LAWS[::-1]}
    tables["Difference from Table 4.3, the nearest variant"] = differences(data, nearest(data))
    return Study(
        name="wall-gap-record",
        title="Turnover beside a wall under a record",
        text=text_of(shaking, data),
        data=data,
        figures={"ranges": draw_ranges(data)},
        tables=tables,
    )


def _simulated(motion: Motion, widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> xr.Dataset:
    case = table_4_2(motion)
    others: Axes = {"contact": LAWS, "motion.scale": POLARITIES}
    found = turnover(case, widths, gaps, others)
    bodies = {("body.width", "body.height"): (widths, widths / RATIO)}
    left, right = _reach(sweep(case, {**others, **bodies}, histories=("x", "tilt")), found.free)
    over = ("contact", "motion.scale")
    far = {"units": "m", "long_name": "farthest that it comes without a wall; nan where it turns over"}
    return xr.Dataset(
        {
            "overturned": (
                (*over, "wall", "body.width", "gap"),
                found.walled,
                {"long_name": "whether it turns over"},
            ),
            "overturned_free": (
                (*over, "body.width"),
                found.free,
                {"long_name": "whether it turns over without a wall"},
            ),
            "reach_left": ((*over, "body.width"), left, far),
            "reach_right": ((*over, "body.width"), right, far),
        },
        {
            "contact": list(LAWS),
            "motion.scale": list(POLARITIES),
            "wall": list(WALLS),
            "body.width": ("body.width", widths, {"units": "m"}),
            "gap": ("gap", gaps, {"units": "m", "long_name": "distance from the body to the wall"}),
        },
        {"motion": motion.name, "aspect_ratio": RATIO, "given_up": found.given_up},
    )


def _reach(histories: xr.Dataset, free: NDArray[np.bool_]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return how far free bodies come beyond their left and right faces at the motion's samples [m]."""
    b, h = (histories[f"body.{name}"].to_numpy()[:, None] for name in ("width", "height"))
    x, tilt = histories["x"].to_numpy(), histories["tilt"].to_numpy()
    half = 0.5 * (b * np.abs(np.cos(tilt)) + h * np.abs(np.sin(tilt)))
    stands = np.where(free, np.nan, 0.0)
    left, right = (np.fmax.reduce(half + side * x - b / 2, axis=-1) for side in (-1.0, 1.0))
    return left + stands, right + stands
