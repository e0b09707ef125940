"""What is drawn and what is not: quantities that a scenario says were measured, and locked casters."""

from dataclasses import fields, replace
from functools import partial

import numpy as np
import pytest

import stayput as sp
from stayput.measures import AntiSlipSheet, FreeCasters, LockedCasters, hold
from stayput.model.body import Body
from stayput.model.flat_fields import case_columns
from stayput.model.room import LOCKED_CASTER, SURFACES, Floor, Room, Wall
from stayput.model.state import State
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import (
    AS_STATED,
    Draw,
    drawn_body,
    drawn_floor,
    drawn_place,
    drawn_surfaces,
    draws,
    rows_of,
)
from stayput.montecarlo.scaled_motions import FloorMotions
from stayput.simulation.space import trace_together
from stayput.simulation.space_engine import SpaceShaking
from stayput.uncertainty import USUAL

BODY = Body(0.4, 1.8, 100.0, base_insets=(0.01, 0.02), base_heights=(0.0, -0.001))
ROOM = Room(Floor.of("tatami, along the weave", restitution=0.97), left_wall=Wall(0.03, restitution=0.55))
SCENARIO = {
    "furniture": {"preset": "bookcase"},
    "room": {"left_wall": {"gap": 0.02, "restitution": 0.6}},
    "shaking": {"builtin": "near-fault", "intensity": 6.0},
    "measures": [{"type": "l_bracket"}],
    "direction": 0.0,
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
    assert verdict.without.tilt.median == pytest.approx(alone.peak_tilt, rel=1e-6)


def test_the_report_says_what_was_measured():
    text = _verdict("wall_gap", samples=1).to_markdown("en")
    assert "| Gaps to the walls, factor on their value | as stated, not drawn |" in text
    assert "| Mass, factor on its value | lognormal" in text


def test_a_quantity_that_is_not_one_is_refused():
    with pytest.raises(sp.InputError, match=r"as_stated.*gap.*wall_gap"):
        _verdict("gap")


CART, EMPTY = sp.Body(width=0.7, height=1.2, mass=120.0, length=1.0), sp.Room()
FREE, RUBBER = SURFACES["free caster, hard floor"].static_friction, SURFACES["rubber pad"].static_friction


def frictions(room: sp.Room, *measures: sp.Measure) -> np.ndarray:
    """Static friction in 2000 draws, by both ways of drawing: all rows at once, and one by one."""
    drawn = draws(1, 2000, seed=1)
    together = rows_of(CART, room, measures, drawn, 9.8).cases["static_friction"]
    held = hold(CART, room, measures).room
    apart = [drawn_surfaces(held, draw).floor.static_friction for draw in drawn[0]]
    assert together == pytest.approx(np.array(apart))
    return together


def test_the_friction_of_locked_casters_reaches_from_rolling_to_rubber() -> None:
    measured, stated = frictions(EMPTY, LockedCasters()), frictions(sp.Room(sp.Floor.of(LOCKED_CASTER)))
    assert measured == pytest.approx(stated)
    assert np.median(measured) == pytest.approx(0.4, abs=0.01)
    assert (measured.min(), measured.max()) == pytest.approx((FREE, RUBBER))
    assert (measured < 0.1).mean() > 0.05


def test_other_surfaces_keep_their_scatter_even_on_a_floor_of_locked_casters() -> None:
    factor = draws(1, 2000, seed=1).columns["friction"][0]
    for measure in (FreeCasters(), AntiSlipSheet()):
        for room in (EMPTY, sp.Room(sp.Floor.of(LOCKED_CASTER))):
            assert frictions(room, measure) == pytest.approx(factor * measure.static_friction)
    assert frictions(EMPTY) == pytest.approx(factor * EMPTY.floor.static_friction)


def test_a_cart_may_move_farther_with_its_casters_locked_than_free() -> None:
    drawn, motion = draws(1, 200, seed=1), sp.near_fault().component("x")
    floor = FloorMotions((motion,), np.ones(1), {})
    rows = [rows_of(CART, EMPTY, (measure,), drawn, 9.8) for measure in (FreeCasters(), LockedCasters())]
    free, locked = (runs.slide for runs in run_level(rows, floor))
    assert 0 < (locked > free).sum() < 40
    assert np.median(locked) < 0.5 * np.median(free)


@pytest.mark.parametrize(
    ("factor", "friction"), [(1.0, 0.4), (0.5, FREE), (0.9, 0.4 * 0.9**5), (1.5, RUBBER)]
)
def test_it_is_drawn_alike_in_space(factor: float, friction: float, monkeypatch: pytest.MonkeyPatch) -> None:
    found: list[float] = []

    def stop(_solids: object, floors: list[np.void], *_: object) -> None:
        found.append(float(floors[0]["edge_static_friction"]))
        raise StopIteration

    monkeypatch.setattr("stayput.simulation.space.world_of", stop)
    piece = sp.Piece(CART, (0.0, 0.0, 0.0), 0.0, [LockedCasters()])
    drawn = partial(drawn_floor, draw=replace(AS_STATED, friction=factor))
    shaking = SpaceShaking.of(sp.near_fault())
    with pytest.raises(StopIteration):
        trace_together(sp.Scene([piece], sp.Room(sp.Floor.of("vinyl"))), shaking, 9.8, drawn_floor=drawn)
    assert found == pytest.approx([friction])
