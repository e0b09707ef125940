"""Where a piece or a bed may go: off walls, doors, windows, pieces and people, a passage beside each bed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from test_rooms import changed

from stayput.model.floor_plan import FACING
from stayput.simulation.groups import outline_of
from stayput.verification.changes import FreeFloor, other_places, overlap, passages, places_at_walls


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
