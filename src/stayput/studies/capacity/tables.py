"""Tables of the study of capacities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd

from stayput.studies.capacity.runs import STATED

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

BAND = 0.2
"""How far a median may be from the formula's."""


def stated(data: xr.Dataset) -> xr.Dataset:
    """Return the runs in the stated setting."""
    return data.isel(run=np.flatnonzero(data["setting"].to_numpy() == STATED.name))


def inside(ratio: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which ratios are within the band."""
    return np.abs(ratio - 1.0) <= BAND


def medians_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each size and spectrum."""
    main = stated(data)
    rows: list[dict[str, object]] = []
    for size in main["body"].to_numpy():
        for run in range(main.sizes["run"]):
            one = main.sel(body=size).isel(run=run)
            formula, ratio = float(one["formula"]), float(one["ratio"])
            fe, fb = float(one["frequency"]), float(one["branch"])
            rows.append(
                {
                    "body": f"{size}, {100 * float(one['width']):g} × {100 * float(one['height']):g} cm",
                    "corner [s]": float(one["corner"]),
                    "Fe [Hz]": round(fe, 2),
                    "Fe/Fb": round(fe / fb, 2),
                    "formula": round(formula, 2),
                    "simulation": round(ratio * formula, 2),
                    "ratio": f"{ratio:.2f} ({float(one['ratio_low']):.2f} to {float(one['ratio_high']):.2f})",
                    "within ±20 %": "yes" if bool(inside(np.array(ratio))) else "no",
                    "ratio of first overturnings": round(float(one["first_ratio"]), 2),
                    "ζ": round(float(one["dispersion"]), 2),
                    "motions with islands [%]": round(100.0 * float(one["islands"])),
                }
            )
    return pd.DataFrame(rows)


def variations_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each setting: the ratios of each size over its spectra, and how many are within."""
    rows: list[dict[str, object]] = []
    for name in dict.fromkeys(data["setting"].to_numpy().tolist()):
        mine = data.isel(run=np.flatnonzero(data["setting"].to_numpy() == name))
        ratio = mine["ratio"].to_numpy()
        spread = {str(size): _range(ratio[:, place]) for place, size in enumerate(mine["body"].to_numpy())}
        rows.append(
            {
                "condition": name,
                **spread,
                "within ±20 %": f"{int(inside(ratio).sum())} of {ratio.size}",
                "ζ": _range(mine["dispersion"].to_numpy().ravel()),
            }
        )
    return pd.DataFrame(rows)


def _range(values: NDArray[np.float64]) -> str:
    low, high = float(values.min()), float(values.max())
    return f"{low:.2f}" if len(values) == 1 else f"{low:.2f} to {high:.2f}"
