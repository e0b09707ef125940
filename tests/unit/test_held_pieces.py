"""Measures on the pieces of a scene: where they act, what they change, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

import stayput as sp
from stayput.measures import MEASURES, Measure
from stayput.simulation.placing import hold_piece, placed, room_seen
from stayput.simulation.space_records import planes_of

BODY = sp.Body(0.4, 1.8, 100.0, length=0.9, base="feet")
ROOM = sp.Room(sp.Floor(0.5, 0.4), left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
SHAKEN = sp.near_fault()


def of(*kinds: str) -> list[Measure]:
    return [MEASURES[kind]() for kind in kinds]


@pytest.mark.parametrize(
    "kinds",
    [
        ("l_bracket",),
        ("tension_pole",),
        ("gel_mats",),
        ("anti_slip_sheet",),
        ("wedge_stopper",),
        ("base_isolator",),
        ("ballast",),
        ("wedge_stopper", "belt"),
    ],
)
def test_a_piece_alone_is_held_like_a_body_in_space(kinds: tuple[str, ...]) -> None:
    alone = sp.simulate(BODY, ROOM, SHAKEN, of(*kinds), dimensions=3)
    among = sp.simulate(sp.Scene([sp.Piece(BODY, measures=of(*kinds))], ROOM), SHAKEN)
    assert among.outcome == alone.outcome
    if "wedge_stopper" not in kinds:
        assert np.array_equal(among.place, alone.place)
        assert [one.peak_pull for one in among.devices] == [one.peak_pull for one in alone.devices]
        return
    # it leans on the wall, where its wall and that of the room are a micrometre apart
    assert among.peak_tilt == pytest.approx(alone.peak_tilt, rel=0.05)
    assert [one.place for one in among.devices] == [one.place for one in alone.devices]
    for mine, theirs in zip(among.devices, alone.devices, strict=True):
        assert mine.failed == theirs.failed
        assert mine.peak_pull == pytest.approx(theirs.peak_pull, rel=0.05, abs=0.1)


@pytest.mark.parametrize("kind", ["l_bracket", "belt"])
def test_a_piece_that_is_turned_about_is_held_to_the_wall_behind_it(kind: str) -> None:
    assert SHAKEN.y is not None
    about = sp.Motion(dt=SHAKEN.dt, x=-SHAKEN.x, y=-SHAKEN.y, z=SHAKEN.z, name="about")
    behind = sp.Room(ROOM.floor, right_wall=ROOM.left_wall, ceiling=ROOM.ceiling)
    facing = sp.Piece(BODY, measures=of(kind))
    turned = sp.Piece(BODY, (1.0, 2.0, 0.0), math.pi, of(kind))
    first = sp.simulate(sp.Scene([facing], ROOM), SHAKEN)
    second = sp.simulate(sp.Scene([turned], behind), about)
    assert first.devices[0].peak_pull > 50.0
    before = first.time < 6.8  # in which impacts have not yet enlarged what differs by rounding
    np.testing.assert_allclose(first[0].tilt[before], second[0].tilt[before], atol=1e-7)
    for mine, theirs in zip(first.devices, second.devices, strict=True):
        assert mine.peak_pull == pytest.approx(theirs.peak_pull, rel=5e-3)


def test_a_piece_on_another_is_held_where_its_back_and_top_are() -> None:
    """As one of the same back and top that reaches down to the floor."""
    upper, whole = sp.Body(0.35, 0.95, 40.0, length=0.9), sp.Body(0.35, 1.85, 40.0, length=0.9)
    measures = of("l_bracket", "tension_pole")
    upper_part = sp.Piece(upper, (-0.05, 0.0, 0.9), 0.0, measures)
    raised = hold_piece(upper_part, ROOM, planes_of([upper_part], ROOM))
    reaching = sp.hold(whole, ROOM, measures, dimensions=3)
    assert raised.body == upper
    for mine, theirs in zip(raised.elements, reaching.elements, strict=True):
        assert mine.normal.stiffness == pytest.approx(theirs.normal.stiffness)
        assert mine.normal.limit_plus == pytest.approx(theirs.normal.limit_plus)
        assert mine.friction == pytest.approx(theirs.friction, nan_ok=True)
        assert mine.point == pytest.approx((theirs.point[0], theirs.point[1] - 0.9))


def test_the_room_as_a_piece_sees_it() -> None:
    """Its wall behind is the one that its back faces; walls that none of its sides faces are left out."""
    room = sp.Room(left_wall=sp.Wall(0.1), right_wall=sp.Wall(0.2), far_side_wall=sp.Wall(0.3))
    neighbour = sp.Piece(BODY, (1.0, -2.0, 0.0))  # what is outermost in front and at the near side

    def seen(*at: float, heading: float = 0.0) -> list[float | None]:
        piece = sp.Piece(BODY, (at[0], at[1], 0.0), heading)
        planes = planes_of([sp.Piece(BODY), piece, neighbour], room)
        found = room_seen(piece, room, planes)
        walls = (found.left_wall, found.right_wall, found.near_side_wall, found.far_side_wall)
        return [None if wall is None else round(wall.gap, 9) for wall in walls]

    assert seen(0.5, 0.0) == [0.6, 0.7, None, 0.3]
    assert seen(0.5, 0.0, heading=-math.pi) == [0.7, 0.6, 0.3, None]
    # its depth along y, its length along x
    assert seen(0.5, 0.0, heading=-math.pi / 2) == [0.55, None, 0.35, 0.45]
    assert seen(0.5, 0.0, heading=0.5) == [None, None, None, None]


def test_a_sheet_is_under_its_own_piece_alone() -> None:
    """Of two alike on a floor that a sine makes them slide on, the one on a sheet stays where it is."""
    low = sp.Body(0.6, 0.4, 30.0, length=0.6)
    pieces = [sp.Piece(low), sp.Piece(low, (0.0, 1.0, 0.0), 0.0, of("anti_slip_sheet"))]
    run = sp.simulate(sp.Scene(pieces, sp.Room(sp.Floor(0.2, 0.15))), sp.sine(3.0, 2.0, 3.0))
    assert run[0].peak_slide > 0.005
    assert run[1].peak_slide < 1e-9


@pytest.mark.parametrize(
    ("piece", "room", "said"),
    [
        (sp.Piece(BODY, heading=0.3, measures=of("against_wall")), ROOM, "cannot be given to one piece"),
        (sp.Piece(BODY, heading=0.3, measures=of("l_bracket")), ROOM, "wall"),
        (sp.Piece(BODY, measures=of("tension_pole")), sp.Room(), "need a ceiling"),
        (
            sp.Piece(BODY, heading=0.3, measures=[sp.MEASURES["tension_pole"](ceiling_height=2.4)]),  # type: ignore[call-arg]
            sp.Room(),
            "need a ceiling",
        ),
    ],
)
def test_what_cannot_be_put_in_place(piece: sp.Piece, room: sp.Room, said: str) -> None:
    with pytest.raises(sp.InputError, match=said):
        sp.simulate(sp.Scene([piece], room), sp.sine(1.0, 1.0, 1.0))


def test_measures_of_several_pieces_do_not_change_the_room() -> None:
    pieces = [sp.Piece(BODY, measures=of("against_wall")), sp.Piece(BODY, (0.0, 2.0, 0.0))]
    with pytest.raises(sp.InputError, match="cannot be given to one piece of several"):
        sp.simulate(sp.Scene(pieces, ROOM), sp.sine(1.0, 1.0, 1.0))


def test_bodies_that_are_no_pieces() -> None:
    with pytest.raises(sp.InputError, match="length"):
        sp.Piece(sp.Body(0.4, 1.8, 100.0))
    with pytest.raises(sp.InputError, match="given twice"):
        sp.Piece(BODY, measures=of("l_bracket", "l_bracket"))


def test_members_without_measures_keep_their_bits() -> None:
    solid = sp.Body.box(0.4, 0.9, 1.8, 100.0)
    run = sp.simulate(sp.Scene([sp.Piece(solid)], ROOM), SHAKEN.scaled(0.3))
    again = sp.simulate(solid, ROOM, SHAKEN.scaled(0.3))
    assert np.array_equal(run.place, again.place)
    assert run.held is None


@pytest.mark.parametrize("insets", [(0.1, 0.0), (0.0, 0.1), (0.05, 0.05)])
def test_insets_move_neither_a_piece_nor_an_end_of_its_belt(insets: tuple[float, float]) -> None:
    """The middle of its outline is at its place; a belt begins as long as it is, from wall to piece."""
    body = sp.Body(0.4, 1.8, 100.0, length=0.9, base_insets=insets)
    (one,) = placed(sp.Scene([sp.Piece(body, measures=of("belt"))], ROOM))
    assert one.piece.reach((1.0, 0.0, 0.0)) == pytest.approx((-0.2, 0.2))
    for spring in one.springs:
        point, anchor = ([spring[f"{name}{axis}"] for axis in "xyz"] for name in "pa")
        assert np.linalg.norm(np.add(one.piece.place, point) - anchor) == pytest.approx(spring["length"])
