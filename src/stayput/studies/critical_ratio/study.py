"""The critical amplitude of a sine over aspect ratio and frequency (the paper, §4.3 and Eq. 4.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import InputError, within
from stayput.studies.critical_ratio.cases import Conditions, all_conditions, critical_amplitudes, rows_of
from stayput.studies.critical_ratio.figures import (
    draw_critical,
    draw_influences,
    draw_residuals,
    draw_scale_free,
)
from stayput.studies.critical_ratio.fit import EQUATION_4_1, Fit, fitted, regression
from stayput.studies.critical_ratio.text import text_of
from stayput.studies.friction.study import rising
from stayput.studies.study import Study

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Numbers = Sequence[float] | NDArray[np.float64]

RATIOS = np.round(np.linspace(0.2, 0.6, 9), 3)
"""Aspect ratios b/h [–]."""

FREQUENCIES = np.round(np.arange(0.5, 2.01, 0.25), 3)
"""Frequencies [Hz]."""

UNITS = {
    "frequency": "Hz",
    "height": "m",
    "phase": "degree",
    "duration": "s",
    "critical": "m/s2",
    "last_safe": "m/s2",
    "eq_4_1": "m/s2",
    "fit": "m/s2",
}


def critical_ratio(
    *,
    ratios: Numbers = RATIOS,
    frequencies: Numbers = FREQUENCIES,
    height: float = 1.4,
    restitution: float = 0.3,
    phase: float = 90.0,
    duration: float = 10.0,
    step: float = 0.02,
) -> Study:
    """Study the critical amplitude of turnover under a sine, as the paper's §4.3.

    Rocking only, under the paper's contact law; the critical amplitude is the first that turns the body over.

    Parameters
    ----------
    ratios, frequencies : array_like
        Aspect ratios b/h [–] and frequencies [Hz]; at least two of each, rising.
    height : float
        Height of the bodies [m].
    restitution : float
        Restitution e of the floor [–].
    phase : float
        Phase of the sine [°]; 90 is a cosine.
    duration : float
        Length of the shaking [s].
    step : float
        Step of the amplitudes that are run, in g·b/h; a band of turnover narrower than it may be missed.

    Returns
    -------
    Study
        Figures "main" (critical amplitude over b/h beside Eq. 4.1), "residuals", "scale_free" (the dependence
        on size) and "influences" (restitution, phase, sway). The data have a row for each critical amplitude.

    Raises
    ------
    InputError
        Values that do not rise, fewer than two of them, a case that is not possible, or fewer than five
        bodies that turn over at all.
    """
    b_h, f = rising("ratios", ratios), rising("frequencies", frequencies)
    base = Conditions(height=height, restitution=restitution, phase=phase, duration=duration)
    step = within("Step of the amplitudes", step, 1e-3, 1.0, "g·b/h")
    table = critical_amplitudes(list(all_conditions(base, b_h, f)), step)
    turned = rows_of(table, part="main").dropna(subset="critical")
    if len(turned) < 5:
        raise InputError(
            f"{len(turned)} of the bodies turn over at some amplitude; a regression needs five or more."
        )
    values = [turned[name].to_numpy() for name in ("ratio", "frequency", "critical")]
    fit, absolute = fitted(*values), fitted(*values, relative=False)
    table["fit"] = regression(fit.coefficients, table["ratio"].to_numpy(), table["frequency"].to_numpy())
    return Study(
        name="critical-ratio",
        title="The critical amplitude of turnover under a sine",
        text=text_of(base, table, fit, absolute, step),
        data=_dataset(table),
        figures={
            "main": draw_critical(table, fit),
            "residuals": draw_residuals(table),
            "scale_free": draw_scale_free(table),
            "influences": draw_influences(table),
        },
        tables={
            "S₁ = c₁ exp(c₂ S₂)·(b/h) + c₃ S₂ + c₄, with 95 % confidence intervals": _coefficients(
                fit, absolute
            ),
            "Mean deviation of our critical amplitudes by frequency [%]": _by_frequency(table),
        },
    )


def _coefficients(fit: Fit, absolute: Fit) -> pd.DataFrame:
    def told(which: Fit) -> list[str]:
        pairs = zip(which.coefficients, which.half_widths, strict=True)
        return [f"{value:.3f} ± {half:.3f}" for value, half in pairs]

    return pd.DataFrame(
        {
            "coefficient": ["c₁ [m/s²]", "c₂ [s]", "c₃ [m/s]", "c₄ [m/s²]"],
            "Eq. 4.1": EQUATION_4_1,
            "ours": told(fit),
            "ours, of absolute residuals": told(absolute),
        }
    )


def _by_frequency(table: pd.DataFrame) -> pd.DataFrame:
    main = rows_of(table, part="main")
    from_paper = 100.0 * (main["critical"] / main["eq_4_1"] - 1.0)
    from_fit = 100.0 * (main["critical"] / main["fit"] - 1.0)
    grouped = pd.DataFrame(
        {
            "f [Hz]": main["frequency"],
            "from Eq. 4.1, size": from_paper.abs(),
            "from Eq. 4.1, signed": from_paper,
            "from our fit, size": from_fit.abs(),
        }
    )
    return grouped.groupby("f [Hz]").mean().reset_index()


def _dataset(table: pd.DataFrame) -> xr.Dataset:
    data = xr.Dataset.from_dataframe(table.rename_axis("case"))
    for name, unit in UNITS.items():
        data[name].attrs["units"] = unit
    return data
