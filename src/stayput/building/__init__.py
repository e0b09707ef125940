"""What stands between the ground and the furniture: a building, and the motion of its floors."""

from __future__ import annotations

from stayput.building.building import STRUCTURES, Building, Isolation
from stayput.building.model import ShearModel

__all__ = ["STRUCTURES", "Building", "Isolation", "ShearModel"]
