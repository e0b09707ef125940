"""Fragility curves of a verdict as files: tables, a figure, and the forms that loss tools read."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING

import numpy as np

from stayput.files import draft
from stayput.fragility import PFA, PFV, write_nrml, write_pelicun
from stayput.fragility.curve import State
from stayput.report.fragility import plot_fragility
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.data import number

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.fragility import FragilityCurve, IntensityMeasure
    from stayput.verification import Verdict

POINTS = 101
"""Points of a curve in the table."""

DRAWN = 8
"""Most curves in a figure: no measure, and the best ones."""


def write_curves(verdict: Verdict, measure: IntensityMeasure, folder: Path) -> tuple[list[Path], list[str]]:
    """Write the curves of all options over one measure of intensity.

    Parameters
    ----------
    verdict : Verdict
        A verdict with curves.
    measure : IntensityMeasure
        What they are over.
    folder : Path
        Where the files go; it is made.

    Returns
    -------
    tuple
        The files written, and a sentence for each thing that was left out.
    """
    curves = [one.curves[measure] for one in verdict.options]
    fitted = [curve for curve in curves if curve.state is State.FITTED]
    folder.mkdir(exist_ok=True)
    files = [folder / name for name in ("curves.csv", "observed.csv", "fragility.svg")]
    for file, text in zip(files, (curves_csv(fitted, measure), observed_csv(curves)), strict=False):
        with draft(file) as unfinished:
            unfinished.write_text(text, encoding="utf-8")
    _plot(verdict, measure, files[2])
    left_out = [
        f"{curve.name} is not in the files for loss tools: it has no curve ({curve.state.value})."
        for curve in curves
        if curve.state is not State.FITTED
    ]
    if fitted:
        files.append(folder / "pelicun.csv")
        write_pelicun(fitted, files[-1])
        if measure in (PFA, PFV):
            left_out.append(f"There is no NRML file: OpenQuake has no {measure.key}.")
        else:
            files.append(folder / "nrml.xml")
            write_nrml(fitted, files[-1], f"Overturning of {verdict.scenario.furniture.title}")
    return files, left_out


def curves_csv(curves: Sequence[FragilityCurve], measure: IntensityMeasure) -> str:
    """Return fitted curves as the text of a CSV file: intensity in SI units, probability and its interval."""
    rows: list[tuple[object, ...]] = []
    for curve in curves:
        u = measure.coordinate(curve.trials.im)
        grid = measure.value(np.linspace(float(u.min()), float(u.max()), POINTS))
        low, high = curve.band(grid)
        table = np.column_stack((grid, curve.probability(grid), low, high))
        rows += [(curve.name, *map(float, row)) for row in table]
    return _text(("option", key(measure), "probability", "low", "high"), rows)


def observed_csv(curves: Sequence[FragilityCurve]) -> str:
    """Return what was counted at each level as the text of a CSV file."""
    heading = ("option", key(curves[0].measure), "overturned", "runs", "probability", "low", "high")
    rows = [
        (
            curve.name,
            level.im,
            level.probability.fell,
            level.probability.runs,
            number(level.probability.estimate),
            level.probability.low,
            level.probability.high,
        )
        for curve in curves
        for level in curve.levels
    ]
    return _text(heading, rows)


def key(measure: IntensityMeasure) -> str:
    """Return the heading of a measure's column, with its SI unit."""
    unit = "" if measure.is_logarithm else "_m_s" if measure.unit == "cm/s" else "_m_s2"
    return f"{measure.key.lower()}{unit}"


def _text(heading: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heading)
    writer.writerows(rows)
    return text.getvalue()


def _plot(verdict: Verdict, measure: IntensityMeasure, path: Path) -> None:
    bare = verdict.without
    best = [one for one in verdict.options if one is not bare][: DRAWN - 1]
    curves = [one.curves[measure] for one in (bare, *best)]
    motions = next(one for one in assumptions(verdict) if one.what("en") == "Motions").value("en")
    here = verdict.intensity if measure.is_logarithm else None
    plot_fragility(
        curves, path, here=here, title=verdict.scenario.title or "", subtitle=f"Motions: {motions}"
    )
