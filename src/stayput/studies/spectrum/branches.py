"""The edges of spectra, put together for figures and text."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from numpy.typing import NDArray


def pulse_branches(
    pulse: xr.Dataset,
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the branches of Zhang and Makris over the sizes, NaN where there is none.

    Returns
    -------
    lower, upper : ndarray, shape (n,)
        The band in which the body falls after an impact.
    without : ndarray, shape (n,)
        Above it the body falls without impact.
    """
    amplitude, direction, impacts = (pulse[name] for name in ("amplitude", "direction", "floor_impacts"))
    lower = amplitude.where((direction > 0) & (impacts > 0)).min("edge")
    upper = amplitude.where((direction < 0) & (impacts > 0)).max("edge")
    without = amplitude.where((direction > 0) & (impacts == 0)).min("edge")
    return lower.values, upper.values, without.values


def outer_edges(under: xr.Dataset) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the lowest factor that overturns, and the lowest above which no sampled case stands.

    Over slenderness and size; NaN where they lie outside the factors sampled.
    """
    rising = under["amplitude"].where(under["direction"] > 0)
    first = rising.min("edge").where(~under["falls_at_lowest"])
    return first.values, rising.max("edge").where(under["falls_at_highest"]).values


def falling_ranges(point: xr.Dataset) -> list[tuple[float, float]]:
    """Return the ranges of amplitude in which one body falls, as far as they were sampled."""
    edges = point["amplitude"].values[point["direction"].values != 0].tolist()
    if bool(point["falls_at_lowest"]):
        edges = [float(point.attrs["lowest_amplitude"]), *edges]
    if bool(point["falls_at_highest"]):
        edges = [*edges, float(point.attrs["highest_amplitude"])]
    return list(zip(edges[::2], edges[1::2], strict=True))
