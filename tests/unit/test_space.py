"""Bodies in space as they begin: where they may, and what is refused."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import stayput as sp

BOX = sp.Body.box(0.4, 0.6, 1.5, 80.0)
DRUM = sp.Body.cylinder(0.4, 1.2, 30.0)
STILL = sp.Motion(dt=0.01, x=np.zeros(5))


def refused(bodies: Any, room: sp.Room | None = None, **given: Any) -> sp.InputError:
    def run() -> None:
        pieces = bodies if isinstance(bodies, list) else [sp.Piece(bodies)]
        sp.simulate(sp.Scene(pieces, room or sp.Room(), **given), STILL)

    with pytest.raises(sp.InputError) as caught:
        run()
    return caught.value


def test_an_edge_takes_from_the_others_what_is_not_said_of_it() -> None:
    body = sp.Body(width=0.4, height=1.2, mass=80.0, length=0.8)

    def slide(**edge: float) -> float:
        floor = sp.Floor(static_friction=0.5, kinetic_friction=0.4, **edge)
        return sp.simulate(body, sp.Room(floor), sp.near_fault()).peak_slide

    bare = slide()
    assert slide(left_edge_kinetic_friction=0.1) == slide(
        left_edge_static_friction=0.5, left_edge_kinetic_friction=0.1
    )
    assert slide(right_edge_static_friction=0.45) == slide(
        right_edge_static_friction=0.45, right_edge_kinetic_friction=0.4
    )
    assert slide(left_edge_kinetic_friction=0.1) > 2.0 * bare


@pytest.mark.parametrize("solid", [BOX, DRUM])
def test_a_body_that_begins_in_the_floor_or_the_ceiling(solid: sp.Body) -> None:
    sunk = [sp.Piece(solid), sp.Piece(solid, at=(2.0, 0.0, -0.02))]
    assert refused(sunk).told("en") == ("pieces[1] begins 0.02 m inside the floor; it must begin outside it.")
    low = sp.Room(ceiling=sp.Ceiling(1.1))
    assert refused(solid, low).told("en").endswith("inside the ceiling; it must begin outside it.")


def test_bodies_that_begin_in_each_other() -> None:
    error = refused([sp.Piece(BOX), sp.Piece(DRUM, (3.0, 0.0, 0.0)), sp.Piece(BOX, (0.35, 0.2, 0.0))])
    assert error.field == "pieces"
    assert error.told("en") == (
        "pieces[0] and pieces[2] begin 0.05 m inside each other; they must begin apart."
    )


def test_bodies_above_beside_and_on_each_other_begin() -> None:
    bodies = [
        sp.Piece(BOX),
        sp.Piece(BOX, at=(0.4, 0.0, 0.0)),
        sp.Piece(BOX, at=(0.0, 0.0, 1.5)),
        sp.Piece(DRUM, at=(2.0, 0.0, 0.3)),
    ]
    run = sp.simulate(sp.Scene(bodies), STILL)
    assert run.place.shape == (4, 5, 3)
    assert np.abs(run.velocity[:3]).max() == 0.0


@pytest.mark.parametrize("heading", [0.0, 0.05, 1.0])
def test_a_cylinder_at_a_wall_touches_it_with_its_circle(heading: float) -> None:
    flush = sp.Wall(0.0)
    room = sp.Room(left_wall=flush, right_wall=flush, near_side_wall=flush, far_side_wall=flush)
    standing = sp.Piece(DRUM, heading=heading)
    for direction in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (math.sqrt(0.5), math.sqrt(0.5), 0.0)):
        np.testing.assert_allclose(standing.reach(direction), (-0.2, 0.2), atol=1e-12)
    run = sp.simulate(standing, room, STILL)
    assert run.slide.max() < 1e-12


def test_what_else_is_refused() -> None:
    assert "number of pieces is 0" in refused([]).told("en")
    assert "must be 2 numbers" in refused([sp.Piece(BOX)], friction=(0.4, 0.3, 0.2)).told("en")
    assert "must be between 0 and 0.3" in refused([sp.Piece(BOX)], friction=(0.3, 0.4)).told("en")
    with pytest.warns(sp.InputWarning, match="by 0.1 mm, is left out"):
        sp.simulate(BOX, sp.Room(sp.Floor(settlement=1e-4)), STILL)
    with pytest.raises(sp.InputError, match="must be 3 numbers"):
        sp.Piece(BOX, at=(0.0, 0.0))  # pyright: ignore[reportArgumentType]


def test_faces_of_many_corners_touch() -> None:
    """Two polygons of 50 corners, one turned a little, have an intersection of 100."""
    angles = np.linspace(0.0, 2.0 * np.pi, 50, endpoint=False)
    disc = sp.Body.hull([(np.cos(a), np.sin(a), z) for z in (0.0, 0.5) for a in angles], 100.0)
    pile = [sp.Piece(disc), sp.Piece(disc, (0.0, 0.0, 0.5), heading=0.06)]
    run = sp.simulate(sp.Scene(pile), STILL)
    assert np.abs(run.velocity).max() == 0.0


def test_the_dataset() -> None:
    data = sp.simulate(BOX, sp.Room(), STILL).to_dataset()
    assert dict(data.sizes) == {"piece": 1, "time": 5, "axis": 3, "part": 4, "by": 2, "level_axis": 2}
    assert data.place.attrs["units"] == "m"
    assert float(data.tilt.max()) == 0.0


def test_a_piece_with_inset_feet_lies_on_its_side() -> None:
    """Its corners beyond the feet are cut off at 45° for the floor: it tips over a foot, and lies flat."""
    feet = [(x, y, 0.0) for x in (-0.17, 0.17) for y in (-0.37, 0.37)]
    solid = sp.Body.box(0.4, 0.8, 1.0, 30.0, feet=feet)
    tipped = sp.Piece(solid, (0.0, 0.0, 0.2), tilt=(0.0, 0.6, 0.0))
    run = sp.simulate(tipped, sp.Room(), sp.Motion(dt=0.01, x=np.zeros(400)))
    corners = run.place[0, -1] + (solid.solid.vertices - solid.solid.centre_of_gravity) @ run.turn[0, -1].T
    assert run[0].overturned
    assert np.degrees(run[0].tilt[-1]) == pytest.approx(90.0, abs=0.01)
    assert corners[:, 2].min() > -1e-5


def test_the_turn_in_plan_of_a_body_that_lies_is_the_last_before() -> None:
    """A cylinder that has fallen over and rolls turns about the vertical no more."""
    drum = sp.Piece(sp.Body.cone(0.2, 0.1, 0.5, 5.0), (0.0, 0.0, 0.3), tilt=(0.0, 1.2, 0.0))
    run = sp.simulate(drum, sp.Room(), sp.sine(3.0, 1.0, 3.0))
    lies = run[0].tilt > np.pi / 3
    assert lies[-1]
    assert np.ptp(run[0].yaw[np.flatnonzero(lies)[0] :]) == 0.0
