"""Locked casters: their friction is hardly known, so it is drawn far wider than that of any other surface."""

import numpy as np
import pytest

import stayput as sp
from stayput.measures import AntiSlipSheet, FreeCasters, LockedCasters, hold
from stayput.model.parameters import parameters
from stayput.model.room import LOCKED_CASTER, SURFACES
from stayput.montecarlo.hazard import FloorMotions
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import drawn_surfaces, draws, rows_of
from stayput.simulation.space import trace_assembly
from stayput.uncertainty import Confidence

CART, ROOM = sp.Body(width=0.7, height=1.2, mass=120.0, length=1.0), sp.Room()
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
    measured, stated = frictions(ROOM, LockedCasters()), frictions(sp.Room(sp.Floor.of(LOCKED_CASTER)))
    assert (measured == stated).all()
    assert np.median(measured) == pytest.approx(0.4, abs=0.01)
    assert (measured.min(), measured.max()) == pytest.approx((FREE, RUBBER))
    assert (measured < 0.1).mean() > 0.05


def test_other_surfaces_keep_their_scatter_even_on_a_floor_of_locked_casters() -> None:
    factor = draws(1, 2000, seed=1).columns["friction"][0]
    for measure in (FreeCasters(), AntiSlipSheet()):
        for room in (ROOM, sp.Room(sp.Floor.of(LOCKED_CASTER))):
            assert frictions(room, measure) == pytest.approx(factor * measure.static_friction)
    assert frictions(ROOM) == pytest.approx(factor * ROOM.floor.static_friction)


def test_a_cart_may_move_farther_with_its_casters_locked_than_free() -> None:
    drawn, motion = draws(1, 200, seed=1), sp.near_fault().component("x")
    floor = FloorMotions((motion,), np.ones(1), {}, 2)
    rows = [rows_of(CART, ROOM, (measure,), drawn, 9.8) for measure in (FreeCasters(), LockedCasters())]
    free, locked = (runs.slide[0] for runs in run_level(rows, floor))
    assert 0 < (locked > free).sum() < 20
    assert np.median(locked) < 0.5 * np.median(free)


@pytest.mark.parametrize(
    ("factor", "friction"), [(1.0, 0.4), (0.5, FREE), (0.9, 0.4 * 0.9**5), (1.5, RUBBER)]
)
def test_it_is_drawn_alike_in_space(factor: float, friction: float, monkeypatch: pytest.MonkeyPatch) -> None:
    found: list[float] = []

    def stop(_solids: object, laws: list[object], *_: object) -> None:
        found.append(laws[0].edge_friction[0])  # type: ignore[attr-defined]
        raise StopIteration

    monkeypatch.setattr("stayput.simulation.space.world_of", stop)
    piece = sp.Piece(CART, (0.0, 0.0, 0.0), 0.0, [LockedCasters()])
    with pytest.raises(StopIteration):
        trace_assembly(sp.Assembly([piece]), sp.Room(sp.Floor.of("vinyl")), None, 9.8, friction=factor)  # type: ignore[arg-type]
    assert found == pytest.approx([friction])


def test_its_grade_is_that_of_an_assumption_and_both_languages_say_why() -> None:
    known = [about for about in parameters(LockedCasters) if about.name.endswith("friction")]
    assert [about.confidence for about in known] == [Confidence.LOW] * 2
    assert {about.confidence for about in parameters(FreeCasters)} == {Confidence.MEDIUM}
    english, japanese = LockedCasters.about
    assert "did not always lessen how far it moved" in english
    assert "移動量が必ずしも減らず" in japanese
    (caution,) = LockedCasters().cautions(CART, ROOM)
    assert "may roll or slip all the same" in caution[0]
    assert "ロックしても転がったり滑ったりすることがあります" in caution[1]
