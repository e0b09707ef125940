"""A room: where its furniture comes to lie in an earthquake, who is hit, which door stays shut."""

from __future__ import annotations

from stayput.rooms.verdict import RoomVerdict
from stayput.rooms.verify import verify_room

__all__ = ["RoomVerdict", "verify_room"]
