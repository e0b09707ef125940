"""What stands between the ground and the furniture: a building, and the motion of its floors."""

from __future__ import annotations

from stayput.building.building import Building
from stayput.building.isolation import Isolation
from stayput.building.model import ShearModel
from stayput.building.structures import STRUCTURES

__all__ = ["STRUCTURES", "Building", "Isolation", "ShearModel"]
