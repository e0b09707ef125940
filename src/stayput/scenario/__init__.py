"""A scenario file: what stands where and how it is shaken, in TOML, checked before anything runs."""

from __future__ import annotations

from stayput.scenario.assembly import AssemblyScenario, read_assembly
from stayput.scenario.room import RoomScenario, read_room
from stayput.scenario.scenario import Scenario, read_scenario

__all__ = ["AssemblyScenario", "RoomScenario", "Scenario", "read_assembly", "read_room", "read_scenario"]
