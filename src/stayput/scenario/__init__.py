"""A scenario file: what stands where and how it is shaken, in TOML, checked before anything runs."""

from __future__ import annotations

from stayput.scenario.scenario import Scenario, read

__all__ = ["Scenario", "read"]
