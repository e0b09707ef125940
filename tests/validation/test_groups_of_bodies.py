"""Bodies that cannot reach each other do what each does alone, to the bit; those that come together meet."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import stayput as sp
from stayput.measures import LBracket

ROOM = sp.Room(left_wall=sp.Wall(0.02))
PIECES = [
    sp.Piece(sp.Body(0.3, 1.8, 90.0, length=0.9), measures=[LBracket()]),
    sp.Piece(sp.Body(0.3, 1.8, 60.0, length=0.9), at=(0.0, 6.0, 0.0)),
    sp.Piece(sp.Body.cylinder(0.4, 1.2, 30.0), at=(0.06, 12.0, 0.0)),
]


def same(whole: Any, alone: Any, number: int) -> bool:
    names = ("place", "attitude", "velocity", "rotation_rate", "force")
    of_piece = ("peak_tilt", "floor_impacts", "wall_impacts", "body_impacts")
    return all(
        np.array_equal(getattr(whole, name)[number], getattr(alone, name)[0]) for name in names
    ) and all(getattr(whole[number], name) == getattr(alone[0], name) for name in of_piece)


@pytest.mark.parametrize("scale", [0.4, 1.0])
def test_three_pieces_out_of_reach_have_the_bits_of_each_alone(scale: float) -> None:
    motion = sp.near_fault().scaled(scale)
    whole = sp.simulate(sp.Scene(PIECES, ROOM), motion)
    turned = sp.simulate(sp.Scene(PIECES[::-1], ROOM), motion)
    for number, piece in enumerate(PIECES):
        if number < 2:  # the cylinder stands a centimetre in front of the others: its wall has another gap
            assert same(whole, sp.simulate(piece, ROOM, motion), number)
        assert np.array_equal(whole.place[number], turned.place[2 - number])
    assert len(whole.devices) == 2
    assert whole.devices[0].pull.shape == whole.time.shape
    times = [hit.time for hit in whole.hits]
    assert times == sorted(times)
    assert {hit.body for hit in whole.hits} <= {0, 1, 2}
    assert np.isinf(whole.gaps[0].bodies).all()
    free = sp.simulate(sp.Scene(PIECES[1:]), motion)
    for number, piece in enumerate(PIECES[1:]):
        assert same(free, sp.simulate(piece, sp.Room(), motion), number)


def test_a_box_that_slides_up_to_another_hits_it() -> None:
    """Out of reach at first: the runs without each other are made again with both."""
    still = sp.sine(amplitude=0.0, frequency=1.0, duration=2.0)
    box = sp.Body.box(0.3, 0.3, 0.3, 10.0)
    pieces = [sp.Piece(box, velocity=(4.0, 0.0, 0.0)), sp.Piece(box, at=(1.5, 0.0, 0.0))]
    room = sp.Room(sp.Floor(0.2, 0.2))
    run = sp.simulate(sp.Scene(pieces, room), still)
    assert any(hit.other is not None for hit in run.hits)
    assert run.place[1, -1, 0] > 1.6
    beside = [pieces[0], sp.Piece(box, at=(1.5, 1.0, 0.0))]
    run = sp.simulate(sp.Scene(beside, room), still)
    assert run.place[1, -1, 0] == 1.5


def test_what_is_joined_runs_together_however_far() -> None:
    boxes = [sp.Piece(sp.Body.box(0.4, 0.4, 1.2, 30.0), at=(x, 0.0, 0.0)) for x in (0.0, 3.0)]
    joint = sp.Joint(0, 1, at=(0.2, 0.0, 1.1), to=(2.8, 0.0, 1.1), stiffness=1e5)
    motion = sp.near_fault()
    free, tied = (sp.simulate(sp.Scene(boxes, joints=joints), motion) for joints in ([], [joint]))
    assert not np.array_equal(free.place, tied.place)
    assert tied.devices[0].peak_pull > 0.0


def test_what_begins_inside_is_named_by_its_number_among_all() -> None:
    sunk = sp.Piece(sp.Body.box(0.4, 0.4, 1.2, 30.0), at=(4.0, 0.0, -0.1))
    with pytest.raises(sp.InputError, match=r"pieces\[3\] begins 0.1 m inside the floor"):
        sp.simulate(sp.Scene([*PIECES, sunk], ROOM), sp.near_fault())
