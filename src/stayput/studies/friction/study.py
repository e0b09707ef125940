"""How far a body slides over its static and kinetic friction (the paper, §4.2).

The paper does not give its input (Fig. 4.2), so the sine is searched whose three slides come nearest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import InputError, finite
from stayput.studies.friction.figures import draw_effects, draw_map, draw_search
from stayput.studies.friction.runs import (
    HELD,
    PAPER_ROWS,
    PAPER_SLIDES,
    PHASES,
    Nearest,
    models,
    nearest_sine,
    slide_map,
    slides_under,
    unit_sine,
)
from stayput.studies.friction.text import text_of
from stayput.studies.study import Study

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Numbers = Sequence[float] | NDArray[np.float64]

AMPLITUDES = np.round(np.arange(4.0, 15.01, 0.2), 1)
"""Amplitudes that are searched [m/s²]: from 0.4 g, where the paper's first body begins to slide."""

FREQUENCIES = np.round(np.arange(0.5, 6.01, 0.1), 1)
"""Frequencies that are searched [Hz]."""

COEFFICIENTS = np.linspace(0.05, 0.8, 31)
"""Coefficients of friction of the map."""


def friction(
    *,
    amplitudes: Numbers = AMPLITUDES,
    frequencies: Numbers = FREQUENCIES,
    coefficients: Numbers = COEFFICIENTS,
    duration: float = 10.0,
) -> Study:
    """Study the slide over static and kinetic friction, as the paper's §4.2.

    Parameters
    ----------
    amplitudes, frequencies : array_like
        The sines that are searched [m/s², Hz]; at least two of each, rising.
    coefficients : array_like
        Coefficients of friction of the map, static and kinetic; at least two, rising.
    duration : float
        Length of the shaking [s].

    Returns
    -------
    Study
        Figures "map" (peak slide over μ and μ'), "search" (how near each sine comes to the paper) and
        "effects" (which coefficient matters more). The data have a row for each case: the searched sines
        under the paper's three pairs of coefficients, and the map.

    Raises
    ------
    InputError
        Values that do not rise, fewer than two of them, or a case that is not possible.
    """
    A, f = rising("amplitudes", amplitudes), rising("frequencies", frequencies)
    mu = rising("coefficients", coefficients)
    searched: dict[str, xr.Dataset] = {}
    nearest: dict[str, Nearest] = {}
    for name, case in models(unit_sine(f[0], duration, 0.0)).items():
        searched[name] = slides_under(case, PHASES, f, A)
        nearest[name] = nearest_sine(case, searched[name])
    chosen = nearest[HELD]
    stated = models(unit_sine(chosen.frequency, duration, chosen.phase))
    rows = {
        name: slides_under(case, (chosen.phase,), np.array([chosen.frequency]), np.array([chosen.amplitude]))
        for name, case in stated.items()
    }
    maps = {name: slide_map(case, chosen.amplitude, mu) for name, case in stated.items()}
    return Study(
        name="friction",
        title="Sliding and the coefficients of friction",
        text=text_of(searched, nearest, rows, duration),
        data=_tidy(searched, maps, chosen),
        figures={
            "map": draw_map(maps, chosen),
            "search": draw_search(searched, nearest),
            "effects": draw_effects(searched, chosen.phase),
        },
        tables={
            f"Peak slide [cm] under the sine nearest for the body that {HELD}": _rows_table(rows),
            "The nearest sine for each model, with its three slides [cm]": _nearest_table(nearest),
        },
    )


def rising(what: str, values: Numbers) -> NDArray[np.float64]:
    """Return values as an array, or raise `InputError` where they are fewer than two or do not rise."""
    array = np.array([finite(f"One of the {what}", value) for value in values])
    if len(array) < 2 or np.any(np.diff(array) <= 0.0):
        raise InputError(f"The {what} are {array.tolist()}; they must be two or more, each above the last.")
    return array


def _rows_table(rows: dict[str, xr.Dataset]) -> pd.DataFrame:
    table = pd.DataFrame(PAPER_ROWS, columns=["μ", "μ'"])
    paper = np.array(PAPER_SLIDES)
    table["the paper"] = 100.0 * paper
    for name, found in rows.items():
        slides = found.peak_slide.to_numpy().ravel()
        table[name] = (100.0 * slides).round(6)
        table[f"{name}, against the paper [%]"] = 100.0 * (slides / paper - 1.0)
    return table


def _nearest_table(nearest: dict[str, Nearest]) -> pd.DataFrame:
    heads = [f"({static:g}, {kinetic:g})" for static, kinetic in PAPER_ROWS]
    paper = {"model": "the paper", **dict(zip(heads, 100.0 * np.array(PAPER_SLIDES), strict=True))}
    rows = [
        {
            "model": name,
            "A [m/s²]": found.amplitude,
            "f [Hz]": found.frequency,
            "phase [°]": found.phase,
            **dict(zip(heads, 100.0 * found.slides, strict=True)),
            "largest deviation [%]": 100.0 * found.deviation,
            "rocks": "yes" if found.rocks else "no",
        }
        for name, found in nearest.items()
    ]
    return pd.DataFrame([*rows, {**paper, "rocks": "not stated"}])


def _tidy(searched: dict[str, xr.Dataset], maps: dict[str, xr.Dataset], chosen: Nearest) -> xr.Dataset:
    """Return a row for each case: the search and the map, of all models."""
    columns = ["static_friction", "kinetic_friction", "phase", "frequency", "amplitude"]
    columns += ["peak_slide", "rocks", "overturned"]
    sine = {"phase": chosen.phase, "frequency": chosen.frequency, "amplitude": chosen.amplitude}
    parts: list[pd.DataFrame] = []
    for name in searched:
        parts += [
            found.to_dataframe().reset_index().assign(**given)[columns].assign(part=part, body=name)
            for part, found, given in (("search", searched[name], {}), ("map", maps[name], sine))
        ]
    table = pd.concat(parts).dropna(subset="overturned").reset_index(drop=True).rename_axis("case")
    data = xr.Dataset.from_dataframe(table.astype({"rocks": bool, "overturned": bool}))
    for column, unit in (
        ("phase", "degree"),
        ("frequency", "Hz"),
        ("amplitude", "m/s2"),
        ("peak_slide", "m"),
    ):
        data[column].attrs["units"] = unit
    return data
