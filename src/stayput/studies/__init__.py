"""The paper's studies and their kin; each is a function that returns a `Study`.

The paper is *A fundamental study on development of a verification system for earthquake-proof measures for
furniture* (14WCEE, 2008).
"""

from stayput.studies.capacity.study import capacity
from stayput.studies.critical_ratio.study import critical_ratio
from stayput.studies.friction.study import friction
from stayput.studies.spectrum.study import spectrum
from stayput.studies.study import Study
from stayput.studies.tokyo.study import tokyo
from stayput.studies.walls.gap import wall_gap
from stayput.studies.walls.record import wall_gap_record

__all__ = [
    "Study",
    "capacity",
    "critical_ratio",
    "friction",
    "spectrum",
    "tokyo",
    "wall_gap",
    "wall_gap_record",
]
