"""The paper's studies and their kin; each is a function that returns a `Study`.

The paper is *A fundamental study on development of a verification system for earthquake-proof measures for
furniture* (14WCEE, 2008).
"""

from stayput.studies.ac156 import ac156
from stayput.studies.baseline import baseline
from stayput.studies.capacity import capacity
from stayput.studies.consumer_centre import consumer_centre
from stayput.studies.contents import contents
from stayput.studies.critical_ratio import critical_ratio
from stayput.studies.friction import friction
from stayput.studies.spectrum import spectrum
from stayput.studies.study import Quantity, Study
from stayput.studies.three_dimensions import three_dimensions
from stayput.studies.tip_over import tip_over
from stayput.studies.tokyo import tokyo
from stayput.studies.tombstones import tombstones
from stayput.studies.wall_gap import wall_gap
from stayput.studies.wall_gap_record import wall_gap_record

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
