"""What standards ask, beside the simulation: one module a standard, with the clause in each docstring.

Only what was read is here; `docs/standards.md` says what was not.
"""

from stayput.standards.ac156 import ac156, ac156_motion
from stayput.standards.asce43 import asce43_sliding
from stayput.standards.equipment import (
    EquipmentLoad,
    anchor_tension,
    equipment_coefficient,
    equipment_loads,
    holding_force,
    position_of,
)

__all__ = [
    "EquipmentLoad",
    "ac156",
    "ac156_motion",
    "anchor_tension",
    "asce43_sliding",
    "equipment_coefficient",
    "equipment_loads",
    "holding_force",
    "position_of",
]
