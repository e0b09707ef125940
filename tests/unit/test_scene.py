"""`Scene`: pieces on, against and beside each other in one value, from Python as from a file."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import stayput as sp

BOOKCASE = sp.Body(width=0.3, height=1.8, mass=80.0, length=0.9)
BOX = sp.Body.box(0.2, 0.3, 0.2, 4.0)
SHAKING = sp.near_fault().scaled(0.6)
PLAN = sp.FloorPlan(3.6, 2.7, doors=[sp.Door("right_wall", 0.2, 0.8)], walls="concrete")
PIECES = [
    sp.Piece(BOOKCASE, name="bookcase", against="far_side_wall", along=1.5, gap=0.05),
    sp.Piece(BOX, at=(0.05, -0.1, 0.0), name="box", on="bookcase"),
]
FILE = {
    "plan": {"width": 3.6, "length": 2.7},
    "doors": [{"wall": "right_wall", "start": 0.2, "width": 0.8}],
    "room": {"floor": {"static_friction": 0.4, "kinetic_friction": 0.3}, "walls": "concrete"},
    "furniture": [
        {
            "name": "bookcase",
            "width": 0.3,
            "height": 1.8,
            "mass": 80.0,
            "length": 0.9,
            "against": "far_side_wall",
            "along": 1.5,
            "gap": 0.05,
        },
        {
            "name": "box",
            "width": 0.2,
            "height": 0.2,
            "mass": 4.0,
            "length": 0.3,
            "at": [0.05, -0.1],
            "on": "bookcase",
        },
    ],
}


def test_pieces_are_moved_to_their_places_once() -> None:
    scene = sp.Scene(PIECES, plan=PLAN)
    bookcase, box = scene.pieces
    assert bookcase.at == pytest.approx((1.5, 2.7 - 0.05 - 0.15, 0.0))
    assert bookcase.heading == pytest.approx(-math.pi / 2.0)
    assert box.at == pytest.approx((1.55, 2.4, 1.8))
    assert replace(scene, joints=()) == scene
    assert scene.names == ("bookcase", "box")
    around = scene.around
    assert around.far_side_wall is not None
    assert around.left_wall is not None
    assert around.far_side_wall.construction == "concrete"
    assert (around.far_side_wall.gap, around.left_wall.gap) == pytest.approx((0.05, 1.05))


def test_a_scene_in_python_runs_as_its_file() -> None:
    scenario = sp.Scenario.parse(FILE | {"shaking": {"builtin": "near-fault", "scale": 0.6}})
    room = sp.Room(sp.Floor(0.4, 0.3))
    scene = sp.Scene([PIECES[0], replace(PIECES[1], body=sp.Body(0.2, 0.2, 4.0, length=0.3))], room, PLAN)
    ours, theirs = sp.simulate(scene, scenario.motion()), scenario.run()
    assert ours.names == theirs.names
    assert ours.plan == theirs.plan == PLAN
    assert np.array_equal(ours.place, theirs.place)
    assert ours["box"].outcome is theirs["box"].outcome


@pytest.mark.parametrize(
    ("scene", "told"),
    [
        ({"pieces": PIECES}, "against is given without a [plan]; it must be left out"),
        (
            {"pieces": PIECES[::-1], "plan": PLAN},
            "on is 'bookcase'; it must be the name of a piece given before",
        ),
        ({"pieces": [PIECES[0], replace(PIECES[1], at=(0.5, 0.0, 0.0))], "plan": PLAN}, "must be a place on"),
        ({"pieces": [sp.Piece(BOX, name="a"), sp.Piece(BOX, name="a")]}, "must not be that of pieces[0]"),
        ({"pieces": PIECES, "plan": PLAN, "room": sp.Room(left_wall=sp.Wall(0.1))}, "beside plan"),
        ({"pieces": [sp.Piece(BOX, (9.0, 0.5, 0.0))], "plan": PLAN}, "pieces[0] reaches"),
        ({"pieces": [PIECES[0], sp.Piece(BOX, (1.5, 2.5, 0.0))], "plan": PLAN}, "“bookcase”"),
        (
            {"pieces": PIECES, "plan": PLAN, "room": sp.Room(ceiling=sp.Ceiling(1.9))},
            "pieces[1] (“box”) is 2 m high",
        ),
    ],
)
def test_what_is_wrong_is_refused(scene: dict, told: str) -> None:
    with pytest.raises(sp.InputError) as caught:
        sp.simulate(sp.Scene(**scene), SHAKING)
    assert told in str(caught.value)
    assert caught.value.told("ja") != str(caught.value)


def test_a_place_is_stated_once() -> None:
    for other in ({"at": (1.0, 0.0, 0.0)}, {"heading": 1.0}, {"on": "chest"}):
        with pytest.raises(sp.InputError, match="beside against"):
            sp.Piece(BOX, against="left_wall", along=1.0, **other)
    for other, message in (
        ({"along": 1.0}, "along is given without against"),
        ({"gap": 0.1}, "gap is given without against"),
        ({"against": "left_wall"}, "against is given without along"),
        ({"on": "chest", "at": (0.0, 0.0, 5.0)}, r"at\[2\] is given beside on"),
    ):
        with pytest.raises(sp.InputError, match=message):
            sp.Piece(BOX, **other)
    for keys, message in (
        ({"against": "left_wall", "along": 1.0, "at": [0.5, 0.5]}, "at is given beside"),
        ({"against": "left_wall", "along": 1.0, "heading": 0.3}, "heading is given beside"),
        ({"along": 1.0}, "along is given without"),
        ({"gap": 0.1}, "gap is given without"),
        ({"against": "left_wall"}, "against is given without along"),
        ({"on": "chest", "at": [0.0, 0.0, 0.4]}, r"at\[2\] is given beside on"),
    ):
        with pytest.raises(sp.InputError, match=message):
            sp.Scenario.parse(
                {"plan": {"width": 3.6, "length": 2.7}, "furniture": [{"preset": "bookcase", **keys}]}
            )


def test_a_scene_has_its_room_and_a_body_needs_one() -> None:
    scene = sp.Scene([sp.Piece(BOX)])
    with pytest.raises(sp.InputError, match="room is given beside a Scene"):
        sp.simulate(scene, sp.Room(), SHAKING)  # pyright: ignore[reportCallIssue, reportArgumentType]
    with pytest.raises(sp.InputError, match="measures"):
        sp.simulate(scene, SHAKING, measures=[sp.MEASURES["belt"]()])  # pyright: ignore[reportCallIssue]
    with pytest.raises(sp.InputError, match="room"):
        sp.simulate(BOX, SHAKING)  # pyright: ignore[reportCallIssue, reportArgumentType]
