"""Fragility curves of a verdict as files: tables, a figure, and the forms that loss tools read.

OpenQuake's fragility model is NRML 0.5. Over a peak a lognormal that fits is written as a continuous
function, given by mean and standard deviation of the peak itself, not of its logarithm (OpenQuake manual,
fragility models). Over an intensity (JMA, MMI), and where no lognormal fits, the curve is written as a
discrete function: its probabilities at the levels. OpenQuake has no measure of a floor's motion, so curves
over one are refused.

Pelicun, the tool for FEMA P-58 assessments, reads a component library: its damage model parameters (its
``fragility.csv``), one component a row, whose single limit state LS1 is the fall. A lognormal that fits (in
an intensity: a normal curve) is written by its parameters, any other curve by its points, as pelicun's
``multilinear_CDF``. Names of demands and units are those of pelicun 3.10 and its model library.
"""

from __future__ import annotations

import csv
import hashlib
import io
import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import Phrase, phrase, say
from stayput.errors import InputError, list_of
from stayput.files import CSV_ENCODING, check_target, csv_text, draft, folder_draft
from stayput.fragility import intensity_measures
from stayput.fragility.curve import METHOD, FragilityCurve
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.report.fragility import plot_options
from stayput.report.summary import number

if TYPE_CHECKING:
    from stayput.verification import Verdict


_LONGEST = 100


def identifiers(curves: Sequence[FragilityCurve]) -> list[str]:
    """Return a name of letters, digits and underscores for each curve; see `plain_names`.

    Raises
    ------
    InputError
        A curve of one motion or without a median, without a name, or two curves with the same name.
    """
    checked = list_of("curves", curves, FragilityCurve)
    if not checked:
        raise InputError("common.empty", "curves")
    for curve in checked:
        if (why := _not_for_loss_tools(curve)) is not None:
            raise InputError("fragility.not_for_loss_tools", "curves", name=repr(curve.name), why=why)
    return plain_names([curve.name for curve in checked])


def plain_names(names: Sequence[str]) -> list[str]:
    """Return ASCII letters, digits and underscores for each name, all different whatever their case.

    A name that loses a letter so, that is too long or that becomes like another's ends in eight digits of its
    digest: it is the same in every file, whatever stands beside it there.

    Parameters
    ----------
    names : sequence of str
        The names, in any script.

    Raises
    ------
    InputError
        An empty name, or the same name twice.

    Examples
    --------
    >>> plain_names(["l_bracket", "tension_pole + wedge_stopper", "ポールとストッパー"])
    ['l_bracket', 'tension_pole_and_wedge_stopper', 'measure_31dd036d']
    """
    for name in names:
        if not name or names.count(name) > 1:
            raise InputError("rooms.same_name", name=repr(name))
    # pelicun takes a dash as the end of a part of a name
    plain = [re.sub(r"[^A-Za-z0-9]+", "_", name.replace("+", " and ")).strip("_") for name in names]
    plain_unique: list[str] = []
    for name, short in zip(names, plain, strict=True):
        alike = sum(other.casefold() == short.casefold() for other in plain) > 1
        lost = any(letter.isalnum() and not letter.isascii() for letter in name)
        if short and not (alike or lost or len(short) > _LONGEST):
            plain_unique.append(short)
        else:
            digest = hashlib.blake2s(name.encode(errors="surrogatepass"), digest_size=4).hexdigest()
            plain_unique.append(f"{short[: _LONGEST - 9] or 'measure'}_{digest}")
    return plain_unique


NAMESPACE = "http://openquake.org/xmlns/nrml/0.5"
"""Namespace of the format."""

LIMIT_STATE = "overturned"
"""The one limit state."""

DEMANDS = {
    intensity_measures.PGA.key: ("PGA", "Peak Ground Acceleration", "g", 1.0 / STANDARD_GRAVITY),
    intensity_measures.PFA.key: ("", "Peak Floor Acceleration", "g", 1.0 / STANDARD_GRAVITY),
    intensity_measures.PGV.key: ("PGV", "Peak Ground Velocity", "cmps", 100.0),
    intensity_measures.PFV.key: ("", "Peak Floor Velocity", "cmps", 100.0),
    intensity_measures.JMA_INTENSITY.key: ("JMA", "JMA Instrumental Intensity", "unitless", 1.0),
    intensity_measures.FLOOR_JMA.key: ("", "JMA Formula on Floor Motion", "unitless", 1.0),
    intensity_measures.MMI.key: ("MMI", "Modified Mercalli Intensity", "unitless", 1.0),
}
"""OpenQuake's name, or "" where it has none; pelicun's name and unit; and the number in that unit (g, cm/s)
over the SI number, of each measure but Sa.

Pelicun does not know the intensities of itself: its option ``CustomDemandTypes`` must name them.
"""

_REACH = 4.0
"""Dispersions on both sides of the median over which a lognormal is written; beyond, OpenQuake keeps its
ends."""


def demand_of(measure: intensity_measures.IntensityMeasure) -> tuple[str, str, str, float]:
    """Return what `DEMANDS` has of a measure, and of Sa."""
    if measure.period is not None:
        period = f"{measure.period:g}"
        return f"SA({period})", f"Spectral Acceleration|{period}", "g", 1.0 / STANDARD_GRAVITY
    return DEMANDS.get(measure.key, ("", measure.name, measure.unit, measure.shown))


def nrml_xml(curves: Sequence[FragilityCurve], description: str = "") -> str:
    """Return the text of the file: see `write_nrml`."""
    names = identifiers(curves)
    root = ET.Element("nrml", xmlns=NAMESPACE)
    about = {"id": "stayput", "assetCategory": "contents", "lossCategory": "contents"}
    model = ET.SubElement(root, "fragilityModel", about)
    text = description or "Overturning of furniture, simulated by stayput"
    ET.SubElement(model, "description").text = text.encode("ascii", "replace").decode("ascii")
    ET.SubElement(model, "limitStates").text = LIMIT_STATE
    for name, curve in zip(names, curves, strict=True):
        measure, _, _, factor = demand_of(curve.measure)
        if not measure:
            allowed = ", ".join((*(key for key, demand in DEMANDS.items() if demand[0]), "SA(T)"))
            name, over = repr(curve.name), curve.measure.key
            raise InputError("fragility.not_in_nrml", name=name, measure=over, allowed=allowed)
        if curve.measure.is_logarithm:  # NRML knows no normal distribution
            _add_discrete(model, name, curve, measure, factor)
        else:
            _add_lognormal(model, name, curve, measure, factor)
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def _add_lognormal(model: ET.Element, name: str, curve: FragilityCurve, imt: str, factor: float) -> None:
    assert curve.lognormal is not None
    median, beta = curve.lognormal.median * factor, curve.lognormal.dispersion
    mean = median * math.exp(0.5 * beta**2)
    deviation = mean * math.sqrt(math.expm1(beta**2))
    lowest, highest = (repr(median * math.exp(sign * _REACH * beta)) for sign in (-1.0, 1.0))
    about = {"id": name, "format": "continuous", "shape": "logncdf"}
    function = ET.SubElement(model, "fragilityFunction", about)
    ends = {"imt": imt, "noDamageLimit": lowest, "minIML": lowest, "maxIML": highest}
    ET.SubElement(function, "imls", ends)
    ET.SubElement(function, "params", {"ls": LIMIT_STATE, "mean": repr(mean), "stddev": repr(deviation)})


def _add_discrete(model: ET.Element, name: str, curve: FragilityCurve, imt: str, factor: float) -> None:
    grid = curve.grid(POINTS)
    levels = [f"{level * factor:.6g}" for level in grid.tolist()]
    function = ET.SubElement(model, "fragilityFunction", {"id": name, "format": "discrete"})
    ends = {"imt": imt, "noDamageLimit": levels[0]}
    ET.SubElement(function, "imls", ends).text = " ".join(levels)
    shares = " ".join(f"{p:.6f}" for p in curve.probability(grid).tolist())
    ET.SubElement(function, "poes", {"ls": LIMIT_STATE}).text = shares


def write_nrml(curves: Sequence[FragilityCurve], path: str | Path, description: str = "") -> None:
    """Write fragility curves as an OpenQuake fragility model.

    Parameters
    ----------
    curves : sequence of FragilityCurve
        Curves of several motions with different names, whose medians are known, over PGA, PGV, Sa(T), MMI or
        JMA's intensity.
    path : str or Path
        The file, whose name ends in .xml.
    description : str
        What the curves are.

    Raises
    ------
    InputError
        A curve of one motion, without a median or over a floor's motion, names that are alike, or a path that
        cannot be written.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.fragility.intensity_measures import PGA
    >>> trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    >>> sp.write_nrml([sp.FragilityCurve("bookcase", trials)], "fragility.xml")
    """
    text = nrml_xml(curves, description)
    with draft(check_target(path, (".xml",))) as unfinished:
        unfinished.write_text(text, encoding="utf-8")


HEADER = (
    *("ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional"),
    *("LS1-Family", "LS1-Theta_0", "LS1-Theta_1"),
)
"""Columns of pelicun's file."""


def pelicun_csv(curves: Sequence[FragilityCurve]) -> str:
    """Return the text of the file: see `write_pelicun`."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for name, curve in zip(identifiers(curves), curves, strict=True):
        assert curve.lognormal is not None
        _, demand, unit, factor = demand_of(curve.measure)
        # Theta_1 of "lognormal" is the standard deviation of the logarithm, of "normal_std" of the value
        family = "normal_std" if curve.measure.is_logarithm else "lognormal"
        parameters = family, repr(curve.lognormal.median * factor), repr(curve.lognormal.dispersion)
        writer.writerow((name, 0, demand, unit, 0, 0, *parameters))
    return text.getvalue()


def write_pelicun(curves: Sequence[FragilityCurve], path: str | Path) -> None:
    """Write fragility curves as damage model parameters for pelicun.

    The demand is that of the body's own floor (offset 0). It is not directional: all measures are of both
    horizontal components. Pelicun multiplies such demands by 1.2, unless its option
    ``NonDirectionalMultipliers`` says ``{"ALL": 1.0}``, as it must here: a peak is the larger one already.

    Parameters
    ----------
    curves : sequence of FragilityCurve
        Curves of several motions with different names, over any measures, whose medians are known.
    path : str or Path
        The file, whose name ends in .csv.

    Raises
    ------
    InputError
        A curve of one motion or without a median, names that are alike, or a path that cannot be written.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.fragility.intensity_measures import PGA
    >>> trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    >>> sp.write_pelicun([sp.FragilityCurve("bookcase", trials)], "fragility.csv")
    """
    text = pelicun_csv(curves)
    with draft(check_target(path, (".csv",))) as unfinished:
        unfinished.write_text(text, encoding="utf-8")


POINTS = 101
"""Points of a curve in the table."""

FOR_PEOPLE = ("curves.csv", "observed.csv")
"""Tables that people open in a spreadsheet; pelicun reads the other one, which is ASCII."""


def write_curves(
    verdict: Verdict, measure: intensity_measures.IntensityMeasure, folder: Path, language: str = "en"
) -> tuple[list[Path], list[str]]:
    """Write the curves of all options over one measure of intensity.

    Parameters
    ----------
    verdict : Verdict
        A verdict with curves.
    measure : IntensityMeasure
        What they are over.
    folder : Path
        Where the files go; it is made.
    language : str
        "en" or "ja": of the figure, and of the sentences.

    Returns
    -------
    tuple
        The files written, all or none of them, and a sentence for each thing that was left out.

    Raises
    ------
    InputError
        The folder does not let a file be written.
    """
    curves = [result.curves[measure] for result in verdict.options]
    texts: dict[str, str | None] = {
        "curves.csv": curves_csv(curves, measure),
        "observed.csv": observed_csv(curves),
        "fragility.svg": None,  # which is drawn
    }
    called = {  # in English as in the files
        result.option.name: result.option.name if language == "en" else verdict.label(result, language)
        for result in verdict.options
    }
    why = {curve.name: _not_for_loss_tools(curve) for curve in curves}
    left_out = [
        say("fragility.left_out", language, option=called[name], why=reason)
        for name, reason in why.items()
        if reason is not None
    ]
    left_out += [
        say("report.in_no_file", language, option=result.option.name, reason=result.why(language))
        for result in verdict.impossible
    ]
    several = [curve for curve in curves if why[curve.name] is None]
    left_out += [
        say("report.renamed", language, option=called[curve.name], identifier=identifier)
        for curve, identifier in zip(several, identifiers(several) if several else (), strict=True)
        if re.search(r"_[0-9a-f]{8}$", identifier)
    ]
    if several:
        texts["pelicun.csv"] = pelicun_csv(several)
    if several and not demand_of(curves[0].measure)[0]:
        left_out.append(say("report.no_nrml", language, measure=curves[0].measure.key))
    elif several:
        about = say("report.overturning_of", piece=verdict.scenario.piece.title)
        texts["nrml.xml"] = nrml_xml(several, about)
    with folder_draft(folder) as unfinished:
        for name, text in texts.items():
            if text is None:
                plot_options(verdict, measure, unfinished / name, language)
            else:
                encoding = CSV_ENCODING if name in FOR_PEOPLE else "utf-8"
                (unfinished / name).write_text(text, encoding=encoding)
    return [folder / name for name in texts], left_out


def _not_for_loss_tools(curve: FragilityCurve) -> Phrase | None:
    """Return why a curve is not for loss tools; None where it is."""
    if curve.one_motion:
        return phrase("fragility.is_of_one_motion")
    return phrase("fragility.has_no_median") if curve.lognormal is None else None


def curves_csv(curves: Sequence[FragilityCurve], measure: intensity_measures.IntensityMeasure) -> str:
    """Return curves as the text of a CSV file: intensity in SI units, probability and its interval."""
    rows: list[tuple[object, ...]] = []
    for curve in curves:
        grid = curve.grid(POINTS)
        low, high = curve.band(grid)
        table = np.column_stack((grid, curve.probability(grid), low, high))
        rows += [(curve.name, *map(number, row.tolist()), METHOD) for row in table]
    return csv_text(("option", key(measure), "probability", "low", "high", "method"), rows, "\n")


def observed_csv(curves: Sequence[FragilityCurve]) -> str:
    """Return the observed shares at each level as the text of a CSV file."""
    heading = ("option", key(curves[0].measure), "overturned", "runs", "probability", "low", "high")
    rows = [
        (
            curve.name,
            level.im,
            *(level.probability.fell, level.probability.runs, number(level.probability.estimate)),
            *(level.probability.low, level.probability.high),
        )
        for curve in curves
        for level in curve.levels
    ]
    return csv_text(heading, rows, "\n")


def key(measure: intensity_measures.IntensityMeasure) -> str:
    """Return the heading of a measure's column, with its SI unit."""
    unit = "" if measure.is_logarithm else "_m_s" if measure.unit == "cm/s" else "_m_s2"
    name = measure.key if measure.period is None else f"sa_{measure.period:g}"
    return f"{name.lower()}{unit}"
