"""The paper's sections and the evidence; each is a function that returns a `Study`.

The paper is *A fundamental study on development of a verification system for earthquake-proof measures for
furniture* (14WCEE, 2008). ``python -m studies`` runs them.
"""

from collections.abc import Callable

from studies.baseline import baseline
from studies.capacity import capacity
from studies.consumer_centre import consumer_centre
from studies.contents import contents
from studies.critical_ratio import critical_ratio
from studies.friction import friction
from studies.races import races
from studies.study import Study
from studies.three_dimensions import three_dimensions
from studies.tokyo import tokyo
from studies.tombstones import tombstones
from studies.wall_gap import wall_gap
from studies.wall_gap_record import wall_gap_record

Studies = tuple[Callable[..., Study], ...]

PAPER: Studies = (friction, critical_ratio, wall_gap, wall_gap_record)
"""The sections of the paper: 4.2, 4.3 with Eq. 4.1, 4.4, and 4.5 with Table 4.3."""

EVIDENCE: Studies = (
    *(tokyo, consumer_centre, baseline, capacity, contents, tombstones, three_dimensions, races),
)
"""What tests, surveys and formulas say, beside stayput; the plane beside space; how often intervals hold."""
