"""Shelves of pieces that move in space: a closed form, beside the plane, and turned in plan."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from in_space import about

import stayput as sp
from stayput.contents.carrier import STEP, Carrier
from stayput.contents.contents import DOORS, DRAWERS
from stayput.model.flat_fields import case_columns
from stayput.simulation.space_engine import SpaceShaking

BOOKCASE = sp.Body(0.4, 1.8, 100.0, length=0.9)
SQUAT = sp.Body(0.6, 0.9, 100.0, length=0.9)
WALLED = sp.Room(left_wall=sp.Wall(0.02))
ALONG = replace(sp.near_fault(), y=None, z=None)
"""One horizontal component, under which a piece in space stays in the plane."""

FRONTS = [
    *(sp.Contents("dishes", doors=doors) for doors in DOORS),
    *(sp.Contents("boxes", drawers=drawers) for drawers in DRAWERS[1:]),
    sp.Contents("books", lip=0.02),
    sp.Contents("dishes", slope=-0.06),
]


def front(contents: sp.Contents) -> str:
    return f"{contents.doors}-{contents.drawers}-{contents.lip}-{contents.slope}"


@pytest.mark.parametrize("slope", [0.0, 0.1])
@pytest.mark.parametrize("axis", [(0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (0.3, 0.8, -0.5)])
def test_a_point_of_a_body_that_turns_as_prescribed(axis, slope):
    """A = ẍ_G + a_G + α × r + ω × (ω × r), in axes that turn with the body; it swings about a fixed axis."""
    t = STEP * np.arange(1201)
    angle, rate, turning = 0.5 * np.sin(3.0 * t), 1.5 * np.cos(3.0 * t), -4.5 * np.sin(3.0 * t)
    turn = np.stack([about(axis, a) for a in angle]) @ about((0.0, 0.0, 1.0), 0.7)
    ways = np.array([0.2, -0.1, 0.05])
    place = ways * np.sin(5.0 * t)[:, np.newaxis] + [0.0, 0.0, 0.9]
    floor = np.stack([3.0 * np.cos(2.0 * t), 2.0 * np.sin(4.0 * t), np.sin(6.0 * t)], axis=1)
    case = case_columns(BOOKCASE, sp.Room(), sp.State(), 9.81)[0]
    moved = Carrier.in_space(case, SpaceShaking(floor, STEP), place, turn, None, BOOKCASE.height, False)
    point = moved.point(0.1, 1.5, slope)

    unit = np.array(axis) / np.linalg.norm(axis)
    arm = turn @ [0.1, 0.0, 0.6]
    acceleration = floor - 25.0 * (place - [0.0, 0.0, 0.9]) + turning[:, np.newaxis] * np.cross(unit, arm)
    acceleration += rate[:, np.newaxis] ** 2 * np.cross(unit, np.cross(unit, arm)) + [0.0, 0.0, 9.81]
    shelf = turn @ about((0.0, 1.0, 0.0), -slope)
    felt = np.einsum("nij,ni->nj", shelf, acceleration)[1:-1]
    velocity = 5.0 * ways * np.cos(5.0 * t)[:, np.newaxis] + rate[:, np.newaxis] * np.cross(unit, arm)
    faces = np.cross(turn[:, :, 1], [0.0, 0.0, 1.0])
    ahead = (velocity * faces).sum(axis=1) / np.linalg.norm(faces, axis=1)
    assert point.along[1:-1] == pytest.approx(felt[:, 0], abs=1e-3)
    assert point.up[1:-1] + 9.81 == pytest.approx(felt[:, 2], abs=1e-3)
    assert point.height == pytest.approx(place[:, 2] + arm[:, 2])
    assert point.velocity[1:-1] == pytest.approx(ahead[1:-1], abs=1e-4)
    # what the front dips by is the pitch, seen along the body's own y
    assert np.tan(point.turn + slope) == pytest.approx(-turn[:, 2, 0] / turn[:, 2, 2])


@pytest.mark.parametrize("contents", FRONTS, ids=front)
@pytest.mark.parametrize(
    ("body", "intensity", "outcome"),
    [(SQUAT, 6.1, "rested"), (BOOKCASE, 6.2, "rocked"), (BOOKCASE, 6.6, "overturned")],
)
def test_one_component_spills_in_space_what_it_does_in_the_plane(body, intensity, outcome, contents):
    room = replace(WALLED, floor=sp.Floor(0.9, 0.9)) if outcome == "rested" else WALLED
    case = sp.Case(body, room, ALONG.to_intensity(intensity))
    plane, space = (replace(case, dimensions=d) for d in (2, 3))
    assert [str(each.run().outcome) for each in (plane, space)] == [outcome, outcome]
    there, here = sp.spill(plane, contents), sp.spill(space, contents)
    assert here.overturned == there.overturned
    item = 1.001 / here.out.size
    assert here.share_out == pytest.approx(there.share_out, abs=item)
    assert here.share_toppled == pytest.approx(there.share_toppled, abs=item)
    assert here.open_from == pytest.approx(there.open_from, abs=1.001 * STEP)
    both = np.isfinite(here.time) & np.isfinite(there.time)
    # a piece that falls carries its shelves down by some 3 m/s in the 4 ms by which the times may differ
    for name, within in (("time", 4.001 * STEP), ("height", 0.015), ("speed", 0.05), ("distance", 0.03)):
        assert getattr(here, name)[both] == pytest.approx(getattr(there, name)[both], abs=within), name


@pytest.mark.parametrize("intensity", [6.2, 6.6])
@pytest.mark.parametrize("contents", [FRONTS[0], FRONTS[1], FRONTS[4]], ids=front)
def test_a_piece_turned_by_90_degrees_spills_under_y_what_it_does_under_x(contents, intensity):
    motion = ALONG.to_intensity(intensity).resampled(STEP)
    across = replace(motion, x=0.0 * motion.x, y=motion.x)
    turned = sp.Scene([sp.Piece(BOOKCASE, heading=0.5 * math.pi)], sp.Room(near_side_wall=sp.Wall(0.02)))
    ahead = sp.spill(sp.simulate(BOOKCASE, WALLED, motion, dimensions=3), contents)
    aside = sp.spill(sp.simulate(turned, across), contents)
    assert aside.share_out > 0.0
    for name in ("out", "toppled", "open_from", "time"):
        assert np.array_equal(getattr(aside, name), getattr(ahead, name), equal_nan=True), name
    assert aside.speed == pytest.approx(ahead.speed, abs=1e-4, nan_ok=True)


def test_each_piece_of_a_run_of_several_spills_as_it_does_alone():
    """The second faces the other way, which is the first under the opposite motion."""
    motion, contents = ALONG.to_intensity(6.2).resampled(STEP), sp.Contents("boxes", drawers="free")
    pieces = [sp.Piece(BOOKCASE), sp.Piece(BOOKCASE, at=(3.0, 0.0, 0.0), heading=math.pi)]
    run = sp.simulate(sp.Scene(pieces), motion)
    for number, alone in enumerate((motion, motion.flipped())):
        case = sp.Case(BOOKCASE, sp.Room(), alone, dimensions=3)
        together, by_itself = sp.spill(run, contents, number), sp.spill(case, contents)
        assert together.share_out > 0.0
        assert np.array_equal(together.out, by_itself.out)
        assert together.time == pytest.approx(by_itself.time, abs=1.001 * STEP, nan_ok=True)
