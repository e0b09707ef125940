"""The first runs of all kinds, in the background: they compile, and make the suite of motions."""

from __future__ import annotations

from stayput.app.presets import SCENE, SHOWN
from stayput.app.running import simulated
from stayput.app.scenes import YOURS
from stayput.app.size_map import size_map
from stayput.scenario import Scenario
from stayput.verification import verify


def warm() -> None:
    """Run the scene that the page begins with first; then upstairs, the map and a small verification."""
    upstairs = {**SCENE["shaking"], "building": {"storeys": 10}, "storey": 5}
    simulated(Scenario.parse({**SCENE, "measures": [{"name": YOURS, "combine": SHOWN}]}))
    simulated(Scenario.parse({**SCENE, "shaking": upstairs}))
    size_map(Scenario.parse(SCENE), "height", 1)
    few = {"measures": [{"type": "belt"}], "uncertainty": {"samples": 1}}
    verify(Scenario.parse({**SCENE, **few}), levels=[6.0], threads=1, progress=False)
