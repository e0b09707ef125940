"""Fragility curves as OpenQuake's fragility model, NRML 0.5.

Over a peak a lognormal that fits is written as a continuous function, given by mean and standard deviation
of the peak itself, not of its logarithm (OpenQuake manual, fragility models). Over an intensity (JMA, MMI),
and where no lognormal fits, the curve is written as a discrete function: its probabilities at the levels.
OpenQuake has no measure of a floor's motion, so curves over one are refused.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.files import check_target, draft
from stayput.fragility.intensity_measures import JMA_INTENSITY, MMI, PGA, PGV
from stayput.fragility.labels import identifiers
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.fragility.curve import FragilityCurve
    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.lognormal import LognormalFit

NAMESPACE = "http://openquake.org/xmlns/nrml/0.5"
"""Namespace of the format."""

LIMIT_STATE = "overturned"
"""The one limit state."""

MEASURES = {
    PGA.key: ("PGA", 1.0 / STANDARD_GRAVITY),
    PGV.key: ("PGV", 100.0),
    JMA_INTENSITY.key: ("JMA", 1.0),
    MMI.key: ("MMI", 1.0),
}
"""Name, and number in OpenQuake's unit (g, cm/s) over the SI number, of each measure it has beside Sa."""

_REACH = 4.0
"""Dispersions on both sides of the median over which a lognormal is written; beyond, OpenQuake keeps its
ends."""


def in_openquake(measure: IntensityMeasure) -> tuple[str, float] | None:
    """Return the name of a measure and the number in OpenQuake's unit over the SI number, or None."""
    if measure.period is not None:
        return f"SA({measure.period:g})", 1.0 / STANDARD_GRAVITY
    return MEASURES.get(measure.key)


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
    text = description or "Overturning of furniture, simulated by stayput"
    ET.SubElement(model, _tag("description")).text = text.encode("ascii", "replace").decode("ascii")
    ET.SubElement(model, _tag("limitStates")).text = LIMIT_STATE
    for name, curve in zip(names, curves, strict=True):
        known = in_openquake(curve.measure)
        if known is None:
            raise InputError(
                "fragility.not_in_nrml",
                name=repr(curve.name),
                measure=curve.measure.key,
                allowed=", ".join((*MEASURES, "SA(T)")),
            )
        fitted = curve.lognormal
        if fitted is not None and fitted.fits and not curve.measure.is_logarithm:
            _add_lognormal(model, name, fitted, *known)
        else:
            _add_discrete(model, name, curve, *known)
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def _tag(name: str) -> str:
    return f"{{{NAMESPACE}}}{name}"


def _add_lognormal(model: ET.Element, name: str, curve: LognormalFit, imt: str, factor: float) -> None:
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


def _add_discrete(model: ET.Element, name: str, curve: FragilityCurve, imt: str, factor: float) -> None:
    levels = [level.im * factor for level in curve.levels]
    function = ET.SubElement(model, _tag("fragilityFunction"), {"id": name, "format": "discrete"})
    ends = {"imt": imt, "noDamageLimit": f"{levels[0]:.6g}"}
    ET.SubElement(function, _tag("imls"), ends).text = " ".join(f"{level:.6g}" for level in levels)
    shares = " ".join(f"{p:.6f}" for p in curve.rising.share)
    ET.SubElement(function, _tag("poes"), {"ls": LIMIT_STATE}).text = shares


def write_nrml(curves: Sequence[FragilityCurve], path: str | Path, description: str = "") -> None:
    """Write fragility curves as an OpenQuake fragility model.

    Parameters
    ----------
    curves : sequence of FragilityCurve
        Fitted curves of several motions with different names, over PGA, PGV, Sa(T), MMI or JMA's intensity.
    path : str or Path
        The file, whose name ends in .xml.
    description : str
        What the curves are.

    Raises
    ------
    InputError
        A curve that is not fitted, is of one motion or is over a floor's motion, names that are alike, or a
        path that cannot be written.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.fragility import PGA
    >>> trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    >>> sp.write_nrml([sp.fragility_curve(trials, "bookcase")], "fragility.xml")
    """
    text = nrml_xml(curves, description)
    with draft(check_target(path, (".xml",))) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
