"""What the spectra say, in numbers of the run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.motion.units import STANDARD_GRAVITY
from stayput.studies.spectrum.branches import outer_edges, pulse_branches
from stayput.studies.spectrum.runs import (
    PULSE_E,
    PULSE_PERIOD,
    PULSE_SLENDERNESS,
    QUIET,
    REFERENCE_EDGES,
    REFERENCE_P,
    REFERENCE_RATIO,
    STICKING,
    frequency_parameter,
    half_diagonal,
    housner_ratio,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    import xarray as xr

    from stayput.motion import Motion


def text_of(pulse: xr.Dataset, under: xr.Dataset, record: Motion, known: xr.Dataset) -> str:
    """Return the study's paragraphs."""
    return "\n\n".join((_done(under), _pulse(pulse, known), _record(under, record), _rocking(under)))


def _done(under: xr.Dataset) -> str:
    period, step = under["period"].values, 100.0 * under.attrs["largest_relative_step"]
    low, high = 2.0 * half_diagonal(frequency_parameter(period[[0, -1]]))
    return (
        f"Rectangular bodies of {low:.2g} to {high:.2g} m diagonal (2π/p of {period[0]:.3g} to "
        f"{period[-1]:.3g} s) stand on a floor whose friction is {STICKING.static_friction:g}, so that they "
        "rock. Every edge between standing and falling is kept: a body that falls at one amplitude may stand "
        f"at a higher one. The amplitudes are sampled in steps of {step:.2g} % and each edge is refined to "
        f"{100 * under.attrs['tolerance']:.2g} %. Islands between two samples are looked for where the "
        "number of landings before the fall changes; others narrower than a step can be missed."
    )


def _pulse(pulse: xr.Dataset, known: xr.Dataset) -> str:
    edges = known["amplitude"].values[: len(REFERENCE_EDGES)]
    worst = 100.0 * np.abs(edges / REFERENCE_EDGES[: len(edges)] - 1.0).max()
    factor = PULSE_E / housner_ratio(PULSE_SLENDERNESS)
    found = (
        f"Under one full sine (nonlinear equations, α = {PULSE_SLENDERNESS:g} rad, ratio of the rotation "
        f"rates at a landing e = {PULSE_E:g}, which is {factor:.4f} times Housner's) a block of "
        f"p = {REFERENCE_P:g} rad/s at ωp/p = {REFERENCE_RATIO:g} has its edges at {_listed(edges, '.3f')} "
        "times αg: it falls after an impact above the first, stands above the second and falls without "
        f"impact above the third. The reference values are {_listed(REFERENCE_EDGES, 'g')}; the largest "
        f"difference is {worst:.2g} %."
    )
    lower, _, without = pulse_branches(pulse)
    ratio = pulse["period"].values / PULSE_PERIOD
    both = ~np.isnan(lower) & ~np.isnan(without)
    if not both.any():
        return found + " No size of this run falls in both ways."
    return (
        f"{found} Of the sizes of this run, those of ωp/p from {ratio[both].min():.3g} to "
        f"{ratio[both].max():.3g} fall in both ways. The lowest amplitude without impact is there up to "
        f"{np.max(without[both] / lower[both]):.2g} times the lowest with one, so it must be said which is "
        "meant."
    )


def _listed(values: Iterable[float], form: str) -> str:
    return ", ".join(format(value, form) for value in values)


def _record(under: xr.Dataset, record: Motion) -> str:
    islands = under["islands"].values
    several = islands > 0
    parts = "with its vertical component" if record.z is not None else "horizontal only"
    peak = record.pga / STANDARD_GRAVITY
    said = (
        f"The record is {record.name or 'without a name'} (peak {peak:.3g} g, {parts}), "
        f"times a factor and followed by {QUIET:g} s of still floor; the landings are Housner's. Of "
        f"{islands.size} bodies {int(several.sum())} have islands of safety, the most {int(islands.max())}."
    )
    first, last = outer_edges(under)
    ratio = (last / first)[several]
    if not np.isnan(ratio).all():
        said += (
            f" For those the factor above which no sampled case stands is {np.nanmedian(ratio):.3g} times "
            f"the lowest that overturns (median; largest {np.nanmax(ratio):.3g}): one critical factor, found "
            "by bisection alone, would be any of the edges between."
        )
    failed = int(under["failed"].sum())
    return said + (f" {failed} runs were given up and count as falls." if failed else "")


def _rocking(under: xr.Dataset) -> str:
    falls, alpha, period = under["overturned"].values, under["slenderness"].values, under["period"].values
    diagonal = np.broadcast_to(2.0 * half_diagonal(frequency_parameter(period)), falls.shape)
    said = f"Under the record as it is {int(falls.sum())} of {falls.size} bodies fall"
    if falls.any() and not falls.all():
        said += (
            f"; the median diagonal of those is {np.median(diagonal[falls]):.2g} m, and of those that stand "
            f"{np.median(diagonal[~falls]):.2g} m"
        )
    relative = np.where(falls, 0.0, under["peak_tilt"].values / alpha[:, None])
    if not relative.any():
        return said + ". None of the others rocks."
    i, j = np.unravel_index(np.argmax(relative), relative.shape)
    return (
        f"{said}. Of those that stand, the largest peak tilt is {relative[i, j]:.2g} α, at "
        f"α = {alpha[i]:g} rad and 2π/p = {period[j]:.3g} s."
    )
