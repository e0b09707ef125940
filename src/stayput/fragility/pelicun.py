"""Fragility curves as a component library of pelicun, the tool for FEMA P-58 assessments.

Format: pelicun's damage model parameters (its ``fragility.csv``), one component a row, whose single limit
state LS1 is the fall. A limit state is lognormal there (normal in an intensity), so only curves that
are so too can be written. Names of demands and units are those of pelicun 3.10 and its model library.
"""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.files import check_target, draft
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY, MMI, PFA, PFV, PGA, PGV
from stayput.fragility.labels import identifiers
from stayput.model.gravity import STANDARD_GRAVITY

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
        if lognormal is None or not lognormal.fits:
            fit = phrase("fragility.no_lognormal") if lognormal is None else lognormal.texts
            raise InputError("fragility.not_lognormal", name=repr(curve.name), fit=fit)
        demand, unit, factor = _demand(curve.measure)
        # Theta_1 of "lognormal" is the standard deviation of the logarithm, of "normal_std" that of the value
        family = "normal_std" if curve.measure.is_logarithm else "lognormal"
        parameters = (family, repr(lognormal.median * factor), repr(lognormal.dispersion))
        writer.writerow((name, 0, demand, unit, 0, 1, *parameters))
    return text.getvalue()


def write_pelicun(curves: Sequence[FragilityCurve], path: str | Path) -> None:
    """Write fragility curves as damage model parameters for pelicun.

    The demand is that of the body's own floor (offset 0) in the direction of the shaking (directional).

    Parameters
    ----------
    curves : sequence of FragilityCurve
        Curves that a lognormal fits, with different names, over any measures.
    path : str or Path
        The file, whose name ends in .csv.

    Raises
    ------
    InputError
        A curve that is not fitted, is of one motion or that no lognormal fits, names that are alike, or a
        path that cannot be written.

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
