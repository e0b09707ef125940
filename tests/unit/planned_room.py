"""A room of which plans to buy and do are made: a bookcase beside a bed, and a chest."""

from __future__ import annotations

import math
from typing import Any

ROOM: dict[str, Any] = {
    "plan": {"width": 3.6, "length": 2.7},
    "furniture": [
        {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 1.9},
        {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 1.6},
    ],
    "places": [{"kind": "bed", "at": [1.4, 1.9], "heading": math.pi / 2}],
    "doors": [{"wall": "right_wall", "start": 0.3}],
    "room": {"ceiling": {"height": 2.4}},
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
    "uncertainty": {"samples": 8},
}
