"""stayput verifies earthquake-proof measures for furniture.

Will it stay put, what happens if it does not, and what helps? Public names are listed once, in
``_HOMES``, and load on first use, so that ``import stayput`` stays light.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from stayput.body import Body, Part
    from stayput.building import Building, Isolation, ShearModel
    from stayput.ensemble import overturning_map, simulate_many, sweep, trace_boundary
    from stayput.errors import InputError
    from stayput.fragility import FragilityCurve, Trials, fragility_curve, write_nrml, write_pelicun
    from stayput.inventory import assess
    from stayput.measures import MEASURES, Measure, hold
    from stayput.motion import Motion, near_fault, pulse, read_motion, sine
    from stayput.motion.spectrum import ResponseSpectrum, response_spectrum
    from stayput.motion.suites import (
        Suite,
        TargetSpectrum,
        asce7,
        japanese_design,
        read_suite,
        read_target,
        synthetic_suite,
    )
    from stayput.room import SURFACES, Ceiling, Floor, Room, Wall
    from stayput.scenario import Scenario, read_scenario
    from stayput.simulation import Case, Event, EventKind, Mode, Outcome, Run, State, simulate
    from stayput.uncertainty import Lognormal, Normal, Uncertainty, Uniform
    from stayput.verification import Verdict, verify

__version__ = "0.1.0"

_HOMES = {
    "Body": "body",
    "Building": "building",
    "Case": "simulation",
    "Ceiling": "room",
    "Event": "simulation",
    "EventKind": "simulation",
    "Floor": "room",
    "FragilityCurve": "fragility",
    "InputError": "errors",
    "Isolation": "building",
    "Lognormal": "uncertainty",
    "MEASURES": "measures",
    "Measure": "measures",
    "Mode": "simulation",
    "Motion": "motion",
    "Normal": "uncertainty",
    "Outcome": "simulation",
    "Part": "body",
    "ResponseSpectrum": "motion.spectrum",
    "Room": "room",
    "Run": "simulation",
    "SURFACES": "room",
    "Scenario": "scenario",
    "ShearModel": "building",
    "State": "simulation",
    "Suite": "motion.suites",
    "TargetSpectrum": "motion.suites",
    "Trials": "fragility",
    "Uncertainty": "uncertainty",
    "Uniform": "uncertainty",
    "Verdict": "verification",
    "Wall": "room",
    "asce7": "motion.suites",
    "assess": "inventory",
    "fragility_curve": "fragility",
    "hold": "measures",
    "japanese_design": "motion.suites",
    "near_fault": "motion",
    "overturning_map": "ensemble",
    "pulse": "motion",
    "read_motion": "motion",
    "read_scenario": "scenario",
    "read_suite": "motion.suites",
    "read_target": "motion.suites",
    "response_spectrum": "motion.spectrum",
    "simulate": "simulation",
    "simulate_many": "ensemble",
    "sine": "motion",
    "sweep": "ensemble",
    "synthetic_suite": "motion.suites",
    "trace_boundary": "ensemble",
    "verify": "verification",
    "write_nrml": "fragility",
    "write_pelicun": "fragility",
}

__all__ = [
    "MEASURES",
    "SURFACES",
    "Body",
    "Building",
    "Case",
    "Ceiling",
    "Event",
    "EventKind",
    "Floor",
    "FragilityCurve",
    "InputError",
    "Isolation",
    "Lognormal",
    "Measure",
    "Mode",
    "Motion",
    "Normal",
    "Outcome",
    "Part",
    "ResponseSpectrum",
    "Room",
    "Run",
    "Scenario",
    "ShearModel",
    "State",
    "Suite",
    "TargetSpectrum",
    "Trials",
    "Uncertainty",
    "Uniform",
    "Verdict",
    "Wall",
    "asce7",
    "assess",
    "fragility_curve",
    "hold",
    "japanese_design",
    "near_fault",
    "overturning_map",
    "pulse",
    "read_motion",
    "read_scenario",
    "read_suite",
    "read_target",
    "response_spectrum",
    "simulate",
    "simulate_many",
    "sine",
    "sweep",
    "synthetic_suite",
    "trace_boundary",
    "verify",
    "write_nrml",
    "write_pelicun",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'stayput' has no attribute {name!r}")
    value = getattr(importlib.import_module(f"stayput.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
