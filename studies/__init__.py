"""The paper's studies and their kin; each is a function that returns a `Study`.

The paper is *A fundamental study on development of a verification system for earthquake-proof measures for
furniture* (14WCEE, 2008).
"""

from studies.ac156 import ac156
from studies.baseline import baseline
from studies.capacity import capacity
from studies.consumer_centre import consumer_centre
from studies.contents import contents
from studies.critical_ratio import critical_ratio
from studies.friction import friction
from studies.spectrum import spectrum
from studies.study import Quantity, Study
from studies.three_dimensions import three_dimensions
from studies.tip_over import tip_over
from studies.tokyo import tokyo
from studies.tombstones import tombstones
from studies.wall_gap import wall_gap
from studies.wall_gap_record import wall_gap_record

__all__ = [
    "Quantity",
    "Study",
    "ac156",
    "baseline",
    "capacity",
    "consumer_centre",
    "contents",
    "critical_ratio",
    "friction",
    "spectrum",
    "three_dimensions",
    "tip_over",
    "tokyo",
    "tombstones",
    "wall_gap",
    "wall_gap_record",
]
