"""stayput verifies earthquake-proof measures for furniture.

Will it stay put, what happens if it does not, and what helps? Public names are listed once, in
``_HOMES``, and load on first use, so that ``import stayput`` stays light.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from stayput.body import Body, Part
    from stayput.ensemble import overturning_map, simulate_many, sweep, trace_boundary
    from stayput.errors import InputError
    from stayput.motion import Motion, near_fault, pulse, read_motion, sine
    from stayput.room import SURFACES, Ceiling, Floor, Room, Wall
    from stayput.scenario import Scenario, read_scenario
    from stayput.simulation import Case, Event, EventKind, Mode, Outcome, Run, State, simulate

__version__ = "0.1.0"

_HOMES = {
    "Body": "body",
    "Case": "simulation",
    "Ceiling": "room",
    "Event": "simulation",
    "EventKind": "simulation",
    "Floor": "room",
    "InputError": "errors",
    "Mode": "simulation",
    "Motion": "motion",
    "Outcome": "simulation",
    "Part": "body",
    "Room": "room",
    "Run": "simulation",
    "SURFACES": "room",
    "Scenario": "scenario",
    "State": "simulation",
    "Wall": "room",
    "near_fault": "motion",
    "overturning_map": "ensemble",
    "pulse": "motion",
    "read_motion": "motion",
    "read_scenario": "scenario",
    "simulate": "simulation",
    "simulate_many": "ensemble",
    "sine": "motion",
    "sweep": "ensemble",
    "trace_boundary": "ensemble",
}

__all__ = [
    "SURFACES",
    "Body",
    "Case",
    "Ceiling",
    "Event",
    "EventKind",
    "Floor",
    "InputError",
    "Mode",
    "Motion",
    "Outcome",
    "Part",
    "Room",
    "Run",
    "Scenario",
    "State",
    "Wall",
    "near_fault",
    "overturning_map",
    "pulse",
    "read_motion",
    "read_scenario",
    "simulate",
    "simulate_many",
    "sine",
    "sweep",
    "trace_boundary",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'stayput' has no attribute {name!r}")
    value = getattr(importlib.import_module(f"stayput.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
