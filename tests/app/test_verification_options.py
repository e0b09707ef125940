"""What the page's verification compares, and how many simulations it is told to take."""

from __future__ import annotations

from dataclasses import replace

import pytest

from stayput.app.limits import Limits
from stayput.app.messages import RefusedError
from stayput.app.verification import runs_of, with_options
from stayput.contents.contents import Contents
from stayput.scenario import Scenario
from stayput.scenario.measures import YOURS
from stayput.verification.contents import MOTIONS, runs_of_contents
from stayput.verification.options import compared_options

ON_CARPET = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "carpet", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"intensity": 6.0, "suite": {"count": 4}},
    "uncertainty": {"samples": 8},
}


def chosen(measure: str) -> Scenario:
    return Scenario.parse({**ON_CARPET, "measures": [{"name": YOURS, "combine": [{"type": measure}]}]})


@pytest.mark.parametrize("measure", [None, "l_bracket"])
def test_what_cannot_be_used_here_is_named_beside_what_is_compared(measure):
    scenario = chosen(measure) if measure else Scenario.parse(ON_CARPET)
    possible, impossible = compared_options(with_options(scenario, ON_CARPET, compare_usual=True))
    assert "gel_mats" not in [option.name for option in possible]
    assert "gel_mats" in [option.option.name for option in impossible]


def test_without_the_usual_ones_there_are_the_users_alone():
    scenario = with_options(chosen("l_bracket"), ON_CARPET, compare_usual=False)
    assert [option.name for option in compared_options(scenario)[0]] == ["none", YOURS]


def test_the_runs_of_contents_are_counted():
    full = Scenario.parse({**ON_CARPET, "contents": {"kind": "books"}})
    options = len(compared_options(full)[0])
    more = runs_of(full, Limits()) - runs_of(Scenario.parse(ON_CARPET), Limits())
    assert more == options * 4 * (1 + 5 * 8)
    assert runs_of_contents(Contents(drawers="stops"), 10 * MOTIONS) == MOTIONS * (1 + 5 * 8)


def test_too_many_items_are_refused_before_anything_is_run():
    crowded = Scenario.parse({**ON_CARPET, "contents": {"shelves": 100, "items": 1000}})
    with pytest.raises(RefusedError, match=r"."):
        runs_of(crowded, replace(Limits(), runs=100_000))
