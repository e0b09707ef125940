"""What the server of `forks` has loaded before it forks: modules, compiled code, the cities' motions.

It assesses nothing itself: that would start threads, which a child does not get.
"""

from contextlib import suppress

import rich.console  # noqa: F401
import scipy.stats  # noqa: F401

import stayput as sp
from conftest import load_solvers
from stayput.files import arrow
from stayput.inventory.assess import assess  # noqa: F401

with suppress(ImportError):  # for the workers of a cluster
    pass

arrow("dataset")
arrow("parquet")
load_solvers()
BUILDING = {"storeys": 4, "structure": "steel"}
SHAKING = {"suite": {"family": "crustal", "count": 3, "seed": 1}, "intensity": 6.0, "building": BUILDING}
sp.Scenario.parse({"furniture": {"preset": "chest"}, "shaking": {**SHAKING, "storey": 2}}).case().run()
