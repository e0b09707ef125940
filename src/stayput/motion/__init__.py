"""What shakes: records, their readers, and synthetic motions."""

from __future__ import annotations

from stayput.motion.integrals import Peaks
from stayput.motion.readers import read_motion
from stayput.motion.record import Motion
from stayput.motion.synthetic import near_fault, pulse, sine

__all__ = ["Motion", "Peaks", "near_fault", "pulse", "read_motion", "sine"]
