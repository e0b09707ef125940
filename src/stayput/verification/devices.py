"""What became of the devices of an option, over all its runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.fragility import probability
from stayput.mechanics.restrained.columns import HOLDS
from stayput.verification.verdict import DeviceSummary, Quantiles

if TYPE_CHECKING:
    from stayput.measures import Held
    from stayput.verification.runs import Runs


def device_summaries(held: Held, runs: Runs) -> tuple[DeviceSummary, ...]:
    """Return a summary of each force element of a measure.

    Parameters
    ----------
    held : Held
        The body with the measures, as stated.
    runs : Runs
        Its runs.
    """
    nowhere = np.zeros_like(runs.overturned)
    found: list[DeviceSummary] = []
    for number, element in enumerate(held.elements):
        device = runs.devices[:, :, number]
        along = np.maximum(device["peak_pull"], device["peak_push"])
        force = runs.masses * np.hypot(along, device["peak_shear"])
        failed = device["failure"] != HOLDS
        times = device["failure_time"][failed & ~runs.missing]
        found.append(
            DeviceSummary(
                kind=element.kind,
                name=f"{element.kind} {element.place}".strip(),
                failed=probability(failed, runs.missing),
                failure_time=float(np.median(times)) if times.size else np.nan,
                peak=Quantiles.of(force, nowhere),
                used=Quantiles.of(runs.used[:, :, number], nowhere),
            )
        )
    return tuple(found)
