"""A room: where its furniture comes to lie in an earthquake, who is hit, and what to do about it."""

from __future__ import annotations

from stayput.rooms.planning import action_plan
from stayput.rooms.steps import ActionPlan
from stayput.rooms.verdict import RoomVerdict
from stayput.rooms.verify import verify_room

__all__ = ["ActionPlan", "RoomVerdict", "action_plan", "verify_room"]
