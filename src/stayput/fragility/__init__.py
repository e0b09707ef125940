"""Probability and capacity from counted falls: pure functions of numbers, nothing is simulated here."""

from __future__ import annotations

from stayput.fragility.curve import Capacity, CurveState, FragilityCurve, fragility_curve
from stayput.fragility.exports import write_nrml, write_pelicun
from stayput.fragility.intensity_measures import (
    INTENSITY_MEASURES,
    JMA_INTENSITY,
    MMI,
    PFA,
    PFV,
    PGA,
    PGV,
    IntensityMeasure,
    intensity_measure,
    spectral_acceleration,
)
from stayput.fragility.paired import Difference, difference
from stayput.fragility.probabilities import Probability, probability, samples_needed, wilson
from stayput.fragility.trials import Trials

__all__ = [
    "INTENSITY_MEASURES",
    "JMA_INTENSITY",
    "MMI",
    "PFA",
    "PFV",
    "PGA",
    "PGV",
    "Capacity",
    "CurveState",
    "Difference",
    "FragilityCurve",
    "IntensityMeasure",
    "Probability",
    "Trials",
    "difference",
    "fragility_curve",
    "intensity_measure",
    "probability",
    "samples_needed",
    "spectral_acceleration",
    "wilson",
    "write_nrml",
    "write_pelicun",
]
