"""Probability and capacity from counted falls: pure functions of numbers, nothing is simulated here."""

from __future__ import annotations

from stayput.fragility.bootstrap import Bootstrap, bootstrap
from stayput.fragility.capacity import Capacity
from stayput.fragility.curve import FragilityCurve, State, fragility_curve
from stayput.fragility.intensity_measures import (
    INTENSITY_MEASURES,
    JMA_INTENSITY,
    PFA,
    PFV,
    PGA,
    PGV,
    IntensityMeasure,
)
from stayput.fragility.nrml import write_nrml
from stayput.fragility.observed import Level
from stayput.fragility.paired import Difference, difference
from stayput.fragility.pelicun import write_pelicun
from stayput.fragility.precision import Plan, samples_needed
from stayput.fragility.probabilities import Probability, probability, wilson
from stayput.fragility.trials import Trials

__all__ = [
    "INTENSITY_MEASURES",
    "JMA_INTENSITY",
    "PFA",
    "PFV",
    "PGA",
    "PGV",
    "Bootstrap",
    "Capacity",
    "Difference",
    "FragilityCurve",
    "IntensityMeasure",
    "Level",
    "Plan",
    "Probability",
    "State",
    "Trials",
    "bootstrap",
    "difference",
    "fragility_curve",
    "probability",
    "samples_needed",
    "wilson",
    "write_nrml",
    "write_pelicun",
]
