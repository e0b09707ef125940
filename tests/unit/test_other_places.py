"""Where a piece or a bed may go: off walls, doors, windows, pieces and people, a passage beside each bed."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from test_rooms import changed

from stayput.model.floor_plan import FACING, PersonPlace
from stayput.simulation.groups import at_rest, outline_of
from stayput.verification.changes import FreeFloor, other_places, overlap, passages, places_at_walls
from stayput.verification.events import ENTERS_BY
from stayput.verification.search import reached, swept_in_falling, turned_rectangles


def test_a_large_room_is_searched_in_as_many_steps_as_a_smaller_one():
    whole = changed(plan={"width": 30.0, "length": 30.0}).scene()
    assert whole.plan is not None
    floor = FreeFloor(whole.plan, whole.pieces)
    (bed,) = whole.plan.places
    assert 600 < len(other_places(bed, floor)) <= 2 * 21 * 21


def test_free_floor_keeps_off_walls_doors_windows_pieces_and_people():
    room = changed(windows=[{"wall": "far_side_wall", "start": 0.5, "width": 1.0, "sill": 0.9}])
    whole = room.scene()
    plan = whole.plan
    assert plan is not None
    floor = FreeFloor(plan, whole.pieces)
    square = np.array([[0.0, 0.0], [0.4, 0.0], [0.4, 0.4], [0.0, 0.4]])
    for at, height, fits in (
        ((1.5, 0.4), 1.0, True),
        ((-0.1, 0.4), 1.0, False),  # in the wall
        ((0.1, 1.8), 1.0, False),  # in the bookcase
        ((1.4, 1.9), 1.0, False),  # on the bed
        ((3.1, 1.4), 1.0, False),  # before the door
    ):
        assert floor.fits(square + at, height=height) == fits, at
    window = np.array([[0.5, 2.4], [0.9, 2.4], [0.9, 2.7], [0.5, 2.7]])
    nothing = FreeFloor(plan, ())
    assert nothing.fits(window, height=0.8, but_place="bed")
    assert not nothing.fits(window, height=1.0, but_place="bed")
    walls = dict(places_at_walls(whole, 0, floor))
    assert set(walls) <= set(FACING)
    assert all(walls.values())
    before_the_door = np.array([[2.9, 1.25], [3.6, 1.25], [3.6, 1.95], [2.9, 1.95]])
    assert not any(overlap(place.corners, before_the_door) for place in other_places(plan.places[0], floor))


def test_a_passage_stays_along_a_long_side_of_each_bed():
    """The bed is 1 m by 2 m in a room of 3.6 m by 2.7 m, with a bookcase; a person needs 0.5 m."""
    whole = changed(windows=[]).scene()
    plan = whole.plan
    assert plan is not None
    (bed,) = plan.places
    floor = FreeFloor(plan, whole.pieces)
    taken = [outline_of(piece.solid.vertices @ piece.turn.T + np.asarray(piece.at)) for piece in whole.pieces]
    strips = [[*passages(place.corners)] for place in other_places(bed, floor)]
    assert len(strips) > 20
    for along in strips:
        assert all(np.ptp(strip, axis=0).round(9).tolist() in ([0.5, 2.0], [2.0, 0.5]) for strip in along)
        assert any(
            (strip > -1e-9).all()
            and (strip < np.array([plan.width, plan.length]) + 1e-9).all()
            and not any(overlap(strip, other) for other in taken)
            for strip in along
        )
    # from 1.3 m to 2.3 m, with 0.4 m beyond
    wide = FreeFloor(replace(plan, places=(replace(bed, at=(1.4, 1.8)),)), ())
    beside = np.array([[1.0, 0.8], [1.4, 0.8], [1.4, 1.2], [1.0, 1.2]])
    assert not wide.fits(beside, height=1.0)
    assert wide.fits(beside - [0.0, 0.5], height=1.0)
    # where there is none now, with 0.4 m on either side, none is taken away
    narrow = FreeFloor(replace(plan, length=1.8, doors=(), places=(replace(bed, at=(1.4, 0.9)),)), ())
    assert narrow.fits(beside - [0.0, 0.8], height=1.0)


def test_rectangles_turn_with_the_piece():
    rectangles = np.array([[[0.1, -0.4], [0.9, 0.4]], [[np.nan, np.nan], [np.nan, np.nan]]])
    quarter, eighth = (turned_rectangles(rectangles, angle) for angle in (math.pi / 2.0, math.pi / 4.0))
    np.testing.assert_allclose(quarter[0], [[-0.4, 0.1], [0.4, 0.9]], atol=1e-12)
    root = math.sqrt(0.5)
    np.testing.assert_allclose(eighth[0], [[-0.3 * root, -0.3 * root], [1.3 * root, 1.3 * root]], atol=1e-12)
    assert np.isnan(quarter[1]).all()


def test_a_rectangle_reaches_a_place_from_where_falling_pieces_hit_it():
    bed = PersonPlace("bed", (2.0, 1.0), 1.0, 2.0, 0.4, 0.7)  # x from 1.5 to 2.5 m, y from 0 to 2 m
    ends = [1.5 + ENTERS_BY - 1e-6, 1.5 + ENTERS_BY + 1e-6, np.nan]
    swept = np.array([[[0.2, 0.5], [end, 1.5]] for end in ends])
    assert reached(swept, [bed]).tolist() == [[False], [True], [False]]
    assert reached(swept, []).shape == (3, 0)


def test_what_does_not_fall_sweeps_nothing():
    standing = at_rest(changed().scene().pieces[0])
    cos, sin = np.cos(1.0), np.sin(1.0)  # far beyond where it could still rock back
    falls = replace(standing, turn=np.array([[[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]]]))
    swept = swept_in_falling([standing, falls])
    assert np.isnan(swept[0]).all()
    np.testing.assert_array_equal(swept[1], falls.span[:, :2])
