"""Overturning spectra: the edges between standing and fallen over the sizes of bodies of one slenderness.

A rectangle of half diagonal R and slenderness α has b = 2R sin α, h = 2R cos α and p² = 3g/(4R).
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.model.body import Body
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.motion import sine
from stayput.simulation.boundary import trace_boundary
from stayput.simulation.case import Case
from stayput.simulation.sweep import sweep

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.axes import Axes

PULSE_SLENDERNESS, PULSE_E = 0.25, 0.9
"""α [rad] of Zhang and Makris's block, and e: rotation rate after a landing over that before it."""

PULSE_PERIOD = 0.5
"""Period of the one-cycle sine [s]; its spectrum depends on ωp/p only."""

REFERENCE_P, REFERENCE_RATIO = 2.14, 5.0
"""p [rad/s] of their block, and the ωp/p at which the edges are known beforehand."""

REFERENCE_EDGES = (3.032, 6.743, 7.493)
"""These edges [a_p/(αg)], of the nonlinear equations: it falls above the first, stands above the second."""

STICKING = Floor(3.0, 3.0)
"""A floor on which bodies rock, whatever the shaking; its landings are Housner's."""

QUIET = 5.0
"""Still floor after a record [s]."""


def frequency_parameter(period: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return p [rad/s] of 2π/p [s]."""
    return 2.0 * math.pi / period


def half_diagonal(p: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return R = 3g/(4p²) [m]."""
    return 3.0 * STANDARD_GRAVITY / (4.0 * p**2)


def housner_ratio(alpha: float) -> float:
    """Return Housner's ratio of the rates at a landing of a rectangle, 1 − 3/2 sin²α."""
    return 1.0 - 1.5 * math.sin(alpha) ** 2


def log_steps(low: float, high: float, step: float) -> NDArray[np.float64]:
    """Return amplitudes from ``low`` to ``high`` in relative steps of about ``step``."""
    return np.geomspace(low, high, 2 + math.ceil(math.log(high / low) / step))


def pulse_spectrum(period: NDArray[np.float64], step: float) -> xr.Dataset:
    """Return the edges under the one-cycle sine, a_p/(αg), over one slenderness, 2π/p [s] and ``edge``."""
    highest = max(4.0, 0.4 * (float(period.max()) / PULSE_PERIOD) ** 2)
    case = _pulse_case(PULSE_PERIOD, float(period.max()))
    return _edges(case, log_steps(0.98, highest, step), np.array([PULSE_SLENDERNESS]), period)


def reference_edges(step: float) -> xr.Dataset:
    """Return the edges [a_p/(αg)] of Zhang and Makris's block at the ωp/p of the reference."""
    size = np.array([2.0 * math.pi / REFERENCE_P])
    case = _pulse_case(float(size[0]) / REFERENCE_RATIO, float(size[0]))
    edges = _edges(case, log_steps(2.0, 10.0, step), np.array([PULSE_SLENDERNESS]), size)
    return edges.isel(slenderness=0, period=0)


def _pulse_case(pulse: float, largest: float) -> Case:
    """Return a case under one sine of α g; the still floor after it is long for the ``largest`` 2π/p [s]."""
    amplitude = PULSE_SLENDERNESS * STANDARD_GRAVITY
    motion = sine(amplitude, 1.0 / pulse, pulse, dt=pulse / 200.0, quiet=3.0 * largest)
    floor = replace(STICKING, restitution=PULSE_E / housner_ratio(PULSE_SLENDERNESS))
    return Case(Body(0.4, 1.8, 100.0), Room(floor), motion)


def record_spectrum(
    motion: Motion, slenderness: NDArray[np.float64], period: NDArray[np.float64], step: float
) -> xr.Dataset:
    """Return the edges under a record, factors on it, over α [rad], 2π/p [s] and ``edge``.

    The factors go from half of what uplifts the slenderest body, by the record's peak, to ten times what
    uplifts the stockiest. ``peak_tilt`` [rad] and ``overturned`` are those of the record as it is.
    """
    peak = motion.pga
    if peak == 0.0:
        raise InputError("studies.still", "motion", motion=motion.name)
    uplift = STANDARD_GRAVITY * np.tan(slenderness) / peak
    scales = log_steps(0.5 * float(uplift.min()), 10.0 * float(uplift.max()), step)
    case = Case(Body(0.4, 1.8, 100.0), Room(STICKING), motion.padded(after=QUIET))
    edges = _edges(case, scales, slenderness, period)
    own = sweep(case, _sizes(slenderness, period))
    for name in ("peak_tilt", "overturned"):
        values = own[name].values.reshape(len(slenderness), len(period))
        edges[name] = (("slenderness", "period"), values, own[name].attrs)
    return edges


def _sizes(slenderness: NDArray[np.float64], period: NDArray[np.float64]) -> Axes:
    """Return one axis of bodies: every size of the first slenderness, then of the next."""
    R = half_diagonal(frequency_parameter(period))
    b, h = (2.0 * np.outer(f(slenderness), R).ravel() for f in (np.sin, np.cos))
    return {("body.width", "body.height"): (b, h)}


def _edges(
    case: Case, scales: NDArray[np.float64], slenderness: NDArray[np.float64], period: NDArray[np.float64]
) -> xr.Dataset:
    """Return all edges over slenderness, period and edge."""
    traced = trace_boundary(case, scales, _sizes(slenderness, period))
    edges = traced.drop_vars(["body.width", "body.height"]).rename({"body.width": "size"})
    edges = edges.assign_coords(
        slenderness=("size", np.repeat(slenderness, len(period))),
        period=("size", np.tile(period, len(slenderness))),
    )
    unstacked = edges.set_index(size=["slenderness", "period"]).unstack("size")
    return unstacked.transpose("slenderness", "period", ...)


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
