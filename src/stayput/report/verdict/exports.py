"""Fragility curves of a verdict as files: tables, a figure, and the forms that loss tools read."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase, say
from stayput.files import folder_draft
from stayput.fragility.curve import METHOD, CurveState, FragilityCurve
from stayput.fragility.exports import demand_of, identifiers, nrml_xml, pelicun_csv
from stayput.fragility.intensity_measures import JMA_INTENSITY, IntensityMeasure
from stayput.report.fragility import plot_fragility
from stayput.report.summary import number
from stayput.report.verdict.assumptions import motions_told
from stayput.spreadsheets import CSV_ENCODING, csv_text
from stayput.verification.words import title

if TYPE_CHECKING:
    from stayput.verification import Verdict

POINTS = 101
"""Points of a curve in the table."""

FOR_PEOPLE = ("curves.csv", "observed.csv")
"""Tables that people open in a spreadsheet; pelicun reads the other one, which is ASCII."""

DRAWN = 8
"""Most curves in a figure: no measure, and the best ones."""


def write_curves(
    verdict: Verdict, measure: IntensityMeasure, folder: Path, language: str = "en"
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
    fitted = [curve for curve in curves if curve.state is CurveState.FITTED]
    texts: dict[str, str | None] = {
        "curves.csv": curves_csv(fitted, measure),
        "observed.csv": observed_csv(curves),
        "fragility.svg": None,  # which is drawn
    }
    called = {  # in English as in the files
        result.option.name: result.option.name
        if language == "en"
        else title(result.option, verdict, language)
        for result in verdict.options
    }
    left_out = [reason for curve in curves if (reason := _left_out(curve, called[curve.name], language))]
    left_out += [
        say("report.in_no_file", language, option=result.option.name, reason=result.why(language))
        for result in verdict.impossible
    ]
    several = [curve for curve in fitted if not curve.one_motion]
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
                _plot(verdict, measure, unfinished / name, language)
            else:
                encoding = CSV_ENCODING if name in FOR_PEOPLE else "utf-8"
                (unfinished / name).write_text(text, encoding=encoding)
    return [folder / name for name in texts], left_out


def _left_out(curve: FragilityCurve, name: str, language: str) -> str:
    """Return why a curve is not in the files for loss tools, or there by its points; else nothing."""
    if curve.state is not CurveState.FITTED:
        return say("fragility.left_out_state", language, option=name, state=curve.state.phrase)
    if curve.one_motion:
        return say("fragility.left_out_one_motion", language, option=name)
    lognormal, highest = curve.lognormal, curve.measure.text(curve.levels[-1].im)
    if lognormal is not None and lognormal.fits:
        return ""
    why = phrase("fragility.no_lognormal") if lognormal is None else lognormal.texts
    return say("fragility.by_points", language, option=name, highest=highest, why=why)


def curves_csv(curves: Sequence[FragilityCurve], measure: IntensityMeasure) -> str:
    """Return fitted curves as the text of a CSV file: intensity in SI units, probability and its interval.

    Of one motion there is no interval.
    """
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


def key(measure: IntensityMeasure) -> str:
    """Return the heading of a measure's column, with its SI unit."""
    unit = "" if measure.is_logarithm else "_m_s" if measure.unit == "cm/s" else "_m_s2"
    name = measure.key if measure.period is None else f"sa_{measure.period:g}"
    return f"{name.lower()}{unit}"


def _plot(verdict: Verdict, measure: IntensityMeasure, path: Path, language: str) -> None:
    bare = verdict.without
    best = [result for result in verdict.options if result is not bare][: DRAWN - 1]
    curves = [
        replace(result.curves[measure], name=title(result.option, verdict, language))
        for result in (bare, *best)
    ]
    motions = say(motions_told(verdict.scenario, verdict.motions)[0], language)
    here = verdict.intensity if measure == JMA_INTENSITY else None
    plot_fragility(
        curves,
        path,
        here=here,
        title=verdict.scenario.title or "",
        subtitle=say("report.motions_shown", language, motions=motions),
        language=language,
    )
