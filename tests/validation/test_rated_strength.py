"""The force that a bracket must bear, against the static force on a tie.

Source: balance of moments about the front edge of a rigid block under a constant acceleration a, which a tie
at height z holds, F = m (a h − g b) / z with half its height h and half its width b. A slow sine shakes it,
so that inertia plays no part, and the brackets have no slack, over which the block would gain speed.
"""

from __future__ import annotations

from typing import Any

import pytest

import stayput as sp
from stayput.measures import LBracket
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.rooms.purchases import quantile_of
from stayput.uncertainty import USUAL
from stayput.verification.changes import Change, with_changes
from stayput.verification.demand import demand_runs
from stayput.verification.option_runner import OptionRunner

WIDTH, LENGTH, HEIGHT, MASS, G = 0.3, 0.8, 1.8, 100.0, 9.80665


def room(acceleration: float) -> sp.Scenario:
    size = {"width": WIDTH, "length": LENGTH, "height": HEIGHT, "mass": MASS}
    scene: dict[str, Any] = {
        "plan": {"width": 3.6, "length": 2.7},
        "furniture": [{"name": "block", **size, "against": "left_wall", "along": 1.3}],
        "direction": 0.0,
        "room": {"floor": {"static_friction": 2.0, "kinetic_friction": 2.0}},
        "shaking": {"sine": {"amplitude": acceleration, "frequency": 0.1, "duration": 20.0}},
        "uncertainty": {"samples": 1, "as_stated": list(USUAL)},
    }
    return sp.Scenario.parse(scene)


@pytest.mark.parametrize("acceleration", [2.0, 2.5, 3.0])
@pytest.mark.parametrize("count", [2, 3])
def test_brackets_bear_the_static_force_of_the_tie(acceleration: float, count: int):
    scenario = room(acceleration)
    runner, brackets = OptionRunner(scenario, SLIDE_LIMIT, 1), LBracket(count=count, slack=0.0).unbreakable()
    option = with_changes(scenario.stated, [Change("block", brackets)], scenario.names)
    elements = [element for _, element in runner.held_by(option) if element is not None]
    force = quantile_of(demand_runs(runner, option, option).devices, elements)
    tie = MASS * (acceleration * 0.5 * HEIGHT - G * 0.5 * WIDTH) / HEIGHT
    # the brackets also bear shear at the back as it rises, which takes a part of the moment
    assert count * (force.pull + force.shear * WIDTH / HEIGHT) == pytest.approx(tie, rel=0.02)
    assert force.shear * WIDTH / HEIGHT < 0.1 * force.pull
