"""Fragility curves as OpenQuake's fragility model, NRML 0.5.

Over a peak they are its continuous functions, lognormal and given by mean and standard deviation of the
peak itself, not of its logarithm (OpenQuake manual, fragility models). Over JMA's intensity, in which a
curve is normal, they are its discrete functions: probabilities at levels. OpenQuake has no measure of a
floor's motion, so curves over one are refused.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.files import check_target, draft
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGA, PGV
from stayput.fragility.labels import identifiers

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.fragility.curve import FragilityCurve

NAMESPACE = "http://openquake.org/xmlns/nrml/0.5"
"""Namespace of the format."""

LIMIT_STATE = "overturned"
"""The one limit state."""

_STANDARD_GRAVITY = 9.80665

MEASURES = {
    PGA.key: ("PGA", 1.0 / _STANDARD_GRAVITY),
    PGV.key: ("PGV", 100.0),
    JMA_INTENSITY.key: ("JMA", 1.0),
}
"""Name, and number in OpenQuake's unit (g, cm/s) over the SI number, of each measure that it has."""

_REACH = 4.0
"""Dispersions on both sides of the median over which a curve is written; beyond, OpenQuake keeps its ends."""

_LEVELS = 65
"""Levels of a discrete function, an eighth of a dispersion apart."""


def lognormal_moments(median: float, dispersion: float) -> tuple[float, float]:
    """Return mean θ exp(β²/2) and standard deviation mean·√(exp(β²) − 1) of a lognormal variable."""
    mean = median * math.exp(0.5 * dispersion**2)
    return mean, mean * math.sqrt(math.expm1(dispersion**2))


def nrml_xml(curves: Sequence[FragilityCurve], description: str = "") -> str:
    """Return the text of the file: see `write_nrml`."""
    names = identifiers(curves)
    ET.register_namespace("", NAMESPACE)
    root = ET.Element(_tag("nrml"))
    about = {"id": "stayput", "assetCategory": "contents", "lossCategory": "contents"}
    model = ET.SubElement(root, _tag("fragilityModel"), about)
    told = description or "Overturning of furniture, simulated by stayput"
    ET.SubElement(model, _tag("description")).text = told.encode("ascii", "replace").decode("ascii")
    ET.SubElement(model, _tag("limitStates")).text = LIMIT_STATE
    for name, curve in zip(names, curves, strict=True):
        if curve.measure.key not in MEASURES:
            raise InputError(
                f"The curve {curve.name!r} is over {curve.measure.key}; in NRML it must be over "
                f"{', '.join(MEASURES)}."
            )
        (_add_discrete if curve.measure.is_logarithm else _add_lognormal)(model, name, curve)
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def _tag(name: str) -> str:
    return f"{{{NAMESPACE}}}{name}"


def _add_lognormal(model: ET.Element, name: str, curve: FragilityCurve) -> None:
    imt, factor = MEASURES[curve.measure.key]
    median, beta = curve.median * factor, curve.dispersion
    mean, deviation = lognormal_moments(median, beta)
    function = ET.SubElement(
        model, _tag("fragilityFunction"), {"id": name, "format": "continuous", "shape": "logncdf"}
    )
    lowest, highest = (repr(median * math.exp(sign * _REACH * beta)) for sign in (-1.0, 1.0))
    ends = {"imt": imt, "noDamageLimit": lowest, "minIML": lowest, "maxIML": highest}
    ET.SubElement(function, _tag("imls"), ends)
    ET.SubElement(
        function, _tag("params"), {"ls": LIMIT_STATE, "mean": repr(mean), "stddev": repr(deviation)}
    )


def _add_discrete(model: ET.Element, name: str, curve: FragilityCurve) -> None:
    imt, _ = MEASURES[curve.measure.key]
    z = np.linspace(-_REACH, _REACH, _LEVELS)
    levels = curve.median + curve.dispersion * z
    levels = levels[levels > 0.0]
    function = ET.SubElement(model, _tag("fragilityFunction"), {"id": name, "format": "discrete"})
    ends = {"imt": imt, "noDamageLimit": f"{levels[0]:.6f}"}
    ET.SubElement(function, _tag("imls"), ends).text = " ".join(f"{level:.6f}" for level in levels)
    shares = " ".join(f"{p:.6f}" for p in curve.probability(levels))
    ET.SubElement(function, _tag("poes"), {"ls": LIMIT_STATE}).text = shares


def write_nrml(curves: Sequence[FragilityCurve], path: str | Path, description: str = "") -> None:
    """Write fragility curves as an OpenQuake fragility model.

    Parameters
    ----------
    curves : sequence of FragilityCurve
        Fitted curves with different names, over PGA, PGV or JMA's intensity.
    path : str or Path
        The file, whose name ends in .xml.
    description : str
        What the curves are.

    Raises
    ------
    InputError
        A curve that is not fitted or is over a floor's motion, names that are alike, or a path that cannot
        be written.
    """
    text = nrml_xml(curves, description)
    with draft(check_target(path, (".xml",))) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
