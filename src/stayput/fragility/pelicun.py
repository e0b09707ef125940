"""Fragility curves as a component library of pelicun, the tool for FEMA P-58 assessments.

Format: pelicun's damage model parameters (its ``fragility.csv``), one component a row, whose single limit
state LS1 is the fall. A lognormal that fits (in an intensity: a normal curve) is written by its parameters,
any other curve by its points, as pelicun's ``multilinear_CDF``. Names of demands and units are those of
pelicun 3.10 and its model library.
"""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING

import numpy as np

from stayput.files import check_target, draft
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY, MMI, PFA, PFV, PGA, PGV
from stayput.fragility.labels import identifiers
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.fragility.curve import FragilityCurve
    from stayput.fragility.intensity_measures import IntensityMeasure

HEADER = (
    "ID",
    "Incomplete",
    "Demand-Type",
    "Demand-Unit",
    "Demand-Offset",
    "Demand-Directional",
    "LS1-Family",
    "LS1-Theta_0",
    "LS1-Theta_1",
)
"""Columns of the file."""

JMA_DEMAND = "JMA Instrumental Intensity"
"""Name of the demand that pelicun does not know of itself: its option ``CustomDemandTypes`` must name it."""

JMA_OPTION = {JMA_DEMAND: {"Acronym": "JMA", "UnitType": "unitless"}}
"""What that option must hold for curves over JMA's intensity."""

FLOOR_JMA_DEMAND = "JMA Formula on Floor Motion"
"""Name of the demand of curves over the number that JMA's formula gives for a floor's motion."""

MMI_DEMAND = "Modified Mercalli Intensity"
"""Name of the other demand that its option ``CustomDemandTypes`` must name."""

MMI_OPTION = {MMI_DEMAND: {"Acronym": "MMI", "UnitType": "unitless"}}
"""What that option must hold for curves over modified Mercalli intensity."""

DEMANDS = {
    PGA.key: ("Peak Ground Acceleration", "g", 1.0 / STANDARD_GRAVITY),
    PFA.key: ("Peak Floor Acceleration", "g", 1.0 / STANDARD_GRAVITY),
    PGV.key: ("Peak Ground Velocity", "cmps", 100.0),
    PFV.key: ("Peak Floor Velocity", "cmps", 100.0),
    JMA_INTENSITY.key: (JMA_DEMAND, "unitless", 1.0),
    FLOOR_JMA.key: (FLOOR_JMA_DEMAND, "unitless", 1.0),
    MMI.key: (MMI_DEMAND, "unitless", 1.0),
}
"""Name, unit, and number in that unit over the SI number, of each measure but Sa."""

PARTS = 8
"""Parts from one level to the next of a curve that is written by points."""


def _demand(measure: IntensityMeasure) -> tuple[str, str, float]:
    """Return name and unit of a measure, and the number in that unit over the SI number."""
    if measure.period is not None:
        return f"Spectral Acceleration|{measure.period:g}", "g", 1.0 / STANDARD_GRAVITY
    return DEMANDS[measure.key]


def pelicun_csv(curves: Sequence[FragilityCurve]) -> str:
    """Return the text of the file: see `write_pelicun`."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for name, curve in zip(identifiers(curves), curves, strict=True):
        lognormal = curve.lognormal
        demand, unit, factor = _demand(curve.measure)
        if lognormal is None or not lognormal.fits:
            parameters = ("multilinear_CDF", _points(curve, factor), "")
        else:
            # Theta_1 of "lognormal" is the standard deviation of the logarithm, of "normal_std" of the value
            family = "normal_std" if curve.measure.is_logarithm else "lognormal"
            parameters = (family, repr(lognormal.median * factor), repr(lognormal.dispersion))
        writer.writerow((name, 0, demand, unit, 0, 1, *parameters))
    return text.getvalue()


def _points(curve: FragilityCurve, factor: float) -> str:
    """Return the points of a curve in pelicun's notation: intensities, a bar, shares that rise from 0 to 1.

    Pelicun's CDF is straight in the intensity, the curve in the logarithm of a peak, so it gets points
    between the levels too. Pelicun keeps six digits of both and wants both to rise: shares do, by 1e-6.
    """
    u, share = curve.rising.u, curve.rising.share
    parts = np.arange((len(u) - 1) * PARTS + 1) / PARTS
    x = factor * curve.measure.value(np.interp(parts, np.arange(len(u)), u))
    start = max(curve.measure.least, min(0.0, float(x[0]) - 1.0))
    x = np.array([start, *x, x[-1] + 1e-3 * (x[-1] - start)])
    y = np.array([0.0, *np.interp(parts, np.arange(len(u)), share), 1.0])
    points = dict(zip((f"{value:.5g}" for value in x), y.tolist(), strict=True))  # near ones fall together
    steps = np.arange(len(points))
    millionths = np.rint(1e6 * np.array(list(points.values()))) - steps
    rising = np.minimum(np.maximum.accumulate(millionths), 1e6 - steps[-1]) + steps
    return f"{','.join(points)}|{','.join(f'{value / 1e6:.6f}' for value in rising)}"


def write_pelicun(curves: Sequence[FragilityCurve], path: str | Path) -> None:
    """Write fragility curves as damage model parameters for pelicun.

    The demand is that of the body's own floor (offset 0) in the direction of the shaking (directional). A
    curve that no lognormal fits is written by its points (``multilinear_CDF``). That distribution must begin
    at 0 and end at 1: below the weakest level that was run it rises straight from no shaking (0), and above
    the strongest one everything falls.

    Parameters
    ----------
    curves : sequence of FragilityCurve
        Fitted curves of several motions with different names, over any measures.
    path : str or Path
        The file, whose name ends in .csv.

    Raises
    ------
    InputError
        A curve that is not fitted or is of one motion, names that are alike, or a path that cannot be
        written.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.fragility import PGA
    >>> trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    >>> sp.write_pelicun([sp.fragility_curve(trials, "bookcase")], "fragility.csv")
    """
    text = pelicun_csv(curves)
    with draft(check_target(path, (".csv",))) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
