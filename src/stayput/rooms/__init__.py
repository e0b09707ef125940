"""A plan of what to do about a room: what to move, what to buy, how strong, in which order."""

from __future__ import annotations

from stayput.rooms.planning import action_plan
from stayput.rooms.steps import ActionPlan

__all__ = ["ActionPlan", "action_plan"]
