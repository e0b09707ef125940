"""Quantities that a scenario says were measured are not drawn."""

from dataclasses import fields

import numpy as np
import pytest

import stayput as sp
from stayput.model.body import Body
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.montecarlo.sampling import (
    AS_STATED,
    Draw,
    drawn_body,
    drawn_place,
    drawn_surfaces,
    draws,
    rows_of,
)
from stayput.simulation.flat_fields import case_columns
from stayput.uncertainty import USUAL

BODY = Body(0.4, 1.8, 100.0, base_insets=(0.01, 0.02), base_heights=(0.0, -0.001))
ROOM = Room(Floor.of("tatami, along the weave", restitution=0.97), left_wall=Wall(0.03, restitution=0.55))
SCENARIO = {
    "furniture": {"preset": "bookcase"},
    "room": {"back_wall": {"gap": 0.02, "restitution": 0.6}},
    "shaking": {"builtin": "near-fault", "intensity": 6.0},
    "measures": [{"type": "l_bracket"}],
}


def test_the_quantities_are_the_fields_of_a_draw():
    assert [field.name for field in fields(Draw)] == list(USUAL)


def test_a_draw_with_all_as_stated_changes_nothing():
    drawn = draws(1, 1, 3, as_stated=USUAL)[0][0]
    assert repr(drawn) == repr(AS_STATED)
    assert drawn_body(BODY, drawn) == BODY
    assert drawn_surfaces(drawn_place(ROOM, drawn), drawn) == ROOM
    plain = case_columns(BODY, ROOM, State(), 9.8)
    rows = rows_of(BODY, ROOM, (), draws(1, 2, 3, as_stated=USUAL), 9.8)
    assert rows.cases.tobytes() == np.repeat(plain, 2).tobytes()


def test_the_other_draws_stay_as_they_are():
    every, some = draws(3, 4, 5), draws(3, 4, 5, as_stated=["wall_gap", "lean"])
    for name in USUAL:
        same = (every.columns[name] == some.columns[name]).all()
        assert same == (name not in ("wall_gap", "lean"))
    assert np.all(some.columns["wall_gap"] == 1.0)
    assert np.all(some.columns["lean"] == 0.0)


def _verdict(*as_stated: str, samples: int = 20) -> sp.Verdict:
    uncertainty = {"samples": samples, "as_stated": [*as_stated]}
    return sp.verify(sp.Scenario.parse({**SCENARIO, "uncertainty": uncertainty}), levels=[])


def test_with_everything_as_stated_all_samples_are_one_run():
    verdict = _verdict(*USUAL)
    assert len(verdict.options) >= 2
    for option in verdict.options:
        assert option.tilt.median == option.tilt.p90
    alone = verdict.scenario.case().run()
    assert verdict.without.tilt.median == pytest.approx(alone.peak_tilt, rel=1e-9)


def test_the_report_says_what_was_measured():
    text = _verdict("wall_gap", samples=1).to_markdown("en")
    assert "| Gaps to the walls, factor on their value | as stated, not drawn |" in text
    assert "| Mass, factor on its value | lognormal" in text


def test_a_quantity_that_is_not_one_is_refused():
    with pytest.raises(sp.InputError, match=r"as_stated.*gap.*wall_gap"):
        _verdict("gap")
