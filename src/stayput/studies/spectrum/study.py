"""Overturning and rocking spectra: what falls, by size and slenderness, under a pulse and under a record.

Source of the pulse's spectrum: Zhang and Makris (2001), Rocking response of free-standing blocks under
cycloidal pulses, J. Eng. Mech. 127(5), 473-483.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import InputError, within
from stayput.motion import near_fault
from stayput.studies.spectrum.branches import outer_edges
from stayput.studies.spectrum.figures import pulse_figure, record_figure, rocking_figure
from stayput.studies.spectrum.runs import (
    PULSE_E,
    PULSE_PERIOD,
    PULSE_SLENDERNESS,
    REFERENCE_EDGES,
    REFERENCE_RATIO,
    frequency_parameter,
    half_diagonal,
    housner_ratio,
    pulse_spectrum,
    record_spectrum,
    reference_edges,
)
from stayput.studies.spectrum.text import text_of
from stayput.studies.study import Study

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion

SLENDERNESS = (0.15, 0.2, 0.3, 0.4)
"""α of the bodies under the record [rad]: from a bookcase to a cupboard."""


def spectrum(
    motion: Motion | None = None,
    *,
    slenderness: Sequence[float] = SLENDERNESS,
    periods: Sequence[float] | NDArray[np.float64] | None = None,
    step: float = 0.01,
) -> Study:
    """Study what falls by size: overturning spectra of a one-cycle sine and of a record, rocking spectra.

    Bodies are rectangles on a floor so rough that they rock, under the coulomb law.

    Parameters
    ----------
    motion : Motion, optional
        The record; default the built-in near-fault motion along the shaking only.
    slenderness : sequence of float
        α of the bodies under the record [rad], increasing.
    periods : array_like, optional
        Their sizes, as 2π/p [s], increasing; default 0.5 to 5 s. Under the one-cycle sine the same sizes
        give ωp/p = 2π/p over the sine's period of 0.5 s.
    step : float
        Relative step of the amplitudes that are sampled; islands narrower than this can be missed.

    Returns
    -------
    Study
        Figures "pulse", "record" and "rocking". Data over ``curve`` (the sine, then each slenderness under
        the record), ``period`` (2π/p) and ``edge``.

    Raises
    ------
    InputError
        Values out of range or not increasing, a motion that is still, or bodies too small or too large.
    """
    record = near_fault().component("x") if motion is None else motion
    alpha = _increasing("Slenderness", slenderness, 0.01, 1.2, "rad")
    given = np.geomspace(0.5, 5.0, 61) if periods is None else periods
    period = _increasing("Period 2π/p", given, 0.05, 20.0, "s")
    if len(alpha) < 1 or len(period) < 2:
        raise InputError(
            f"The spectrum has {len(alpha)} slendernesses and {len(period)} periods; "
            "it must have one or more and two or more."
        )
    step = within("Step", step, 1e-4, 0.2)
    pulse = pulse_spectrum(period, step)
    under = record_spectrum(record, alpha, period, step)
    known = reference_edges(step)
    data = _together(pulse, under, record)
    return Study(
        name="spectrum",
        title="Overturning and rocking spectra",
        text=text_of(pulse.isel(slenderness=0), under, record, known),
        data=data,
        figures={
            "pulse": pulse_figure(pulse.isel(slenderness=0)),
            "record": record_figure(under, record),
            "rocking": rocking_figure(under, record),
        },
        tables={
            f"Edges under one sine at ωp/p = {REFERENCE_RATIO:g}, a_p/(αg)": _reference_table(known),
            f"Bodies under {record.name or 'the record'}, all sizes": _record_table(under),
        },
    )


def _increasing(
    name: str, values: Sequence[float] | NDArray[np.float64], low: float, high: float, unit: str
) -> NDArray[np.float64]:
    array = np.array([within(name, value, low, high, unit) for value in values])
    if np.any(np.diff(array) <= 0.0):
        raise InputError(f"{name} has the values {array.tolist()}; they must be increasing.")
    return array


def _together(pulse: xr.Dataset, under: xr.Dataset, record: Motion) -> xr.Dataset:
    """Return one dataset over curve, period and edge: the pulse first."""
    edges = under.drop_vars(["peak_tilt", "overturned"])
    parts = [part.rename(slenderness="curve").drop_vars("curve") for part in (pulse, edges)]
    missing = {"amplitude": np.nan, "lower": np.nan, "upper": np.nan, "direction": 0, "floor_impacts": -1}
    data = xr.concat(parts, "curve", join="outer", fill_value=missing, combine_attrs="override")
    alpha = np.append(PULSE_SLENDERNESS, under["slenderness"])
    size = half_diagonal(frequency_parameter(data["period"].values))
    data = data.assign_coords(
        motion=("curve", ["one-cycle sine", *[record.name or "record"] * (len(alpha) - 1)]),
        slenderness=("curve", alpha, {"units": "rad", "long_name": "slenderness"}),
        restitution=("curve", [PULSE_E, *map(housner_ratio, alpha[1:])], {"long_name": "ratio of rates"}),
        half_diagonal=("period", size, {"units": "m", "long_name": "R = 3g/(4p2)"}),
        frequency_ratio=("period", data["period"].values / PULSE_PERIOD, {"long_name": "wp/p of the sine"}),
    )
    data["period"].attrs = {"units": "s", "long_name": "2 pi/p, the size of the body"}
    data["amplitude"].attrs["comment"] = "of the sine: a_p/(alpha g); of the record: factor on it"
    for name, unit in (("peak_tilt", "rad"), ("overturned", "")):
        values = under[name].transpose("slenderness", "period").values.astype(np.float64)
        data[name] = (("curve", "period"), np.vstack((np.full(values.shape[1], np.nan), values)))
        data[name].attrs = {"units": unit, "long_name": f"{name} under the record as it is; nan: the sine"}
    for name in ("lowest_amplitude", "highest_amplitude"):
        sampled = [pulse.attrs[name], *[under.attrs[name]] * (len(alpha) - 1)]
        data = data.assign_coords({name: ("curve", sampled, {"long_name": "of those sampled"})})
    data.attrs = {name: under.attrs[name] for name in ("tolerance", "largest_relative_step", "resolution")}
    return data.assign_attrs(pulse_period=PULSE_PERIOD, record=record.name)


def _reference_table(known: xr.Dataset) -> pd.DataFrame:
    found = known["amplitude"].values[: len(REFERENCE_EDGES)]
    found = np.pad(found, (0, len(REFERENCE_EDGES) - len(found)), constant_values=math.nan)
    above = ["falls, after an impact", "stands", "falls, without impact"]
    table = pd.DataFrame({"above it": above, "this run": found, "reference": REFERENCE_EDGES})
    table["difference [%]"] = 100.0 * (table["this run"] / table["reference"] - 1.0)
    return table


def _record_table(under: xr.Dataset) -> pd.DataFrame:
    first, last = outer_edges(under)
    falls, alpha = under["overturned"].values, under["slenderness"].values
    diagonal = np.broadcast_to(2.0 * half_diagonal(frequency_parameter(under["period"].values)), falls.shape)
    return pd.DataFrame(
        {
            "α [rad]": alpha,
            "b/h": np.tan(alpha),
            "sizes that fall, record as it is [%]": 100.0 * falls.mean(1),
            "largest diagonal that falls [m]": _largest(np.where(falls, diagonal, np.nan)),
            "lowest factor that overturns any": -_largest(-first),
            "sizes with islands [%]": 100.0 * (under["islands"].values > 0).mean(1),
            "most islands": under["islands"].values.max(1),
            "largest ratio of last to first edge": _largest(last / first),
        }
    )


def _largest(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest of each row, NaN where it has none."""
    found = np.where(np.isnan(values), -math.inf, values).max(1)
    return np.where(np.isinf(found), math.nan, found)
