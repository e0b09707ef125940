"""`Body` of a shape of its own: what the plane sees of it, as a value, and where it is refused."""

from __future__ import annotations

import pickle
from dataclasses import replace

import numpy as np
import pytest

import stayput as sp

ROOM, MOTION = sp.Room(sp.Floor(0.4, 0.3), left_wall=sp.Wall(0.02)), sp.near_fault().scaled(0.4)
VASE = sp.Body.cone(0.10, 0.22, 0.35, 1.8)
WEDGE = sp.Body.hull(
    [(x, y, 0.0) for x in (0.1, 0.5) for y in (-0.3, 0.3)] + [(0.1, -0.3, 1.2), (0.1, 0.3, 1.2)], 30.0
)


def test_the_plane_sees_the_box_around_it() -> None:
    assert (WEDGE.width, WEDGE.length, WEDGE.height, WEDGE.mass) == (0.4, 0.6, 1.2, 30.0)
    assert WEDGE.centre_of_gravity == pytest.approx((-0.4 / 6, 0.4))
    assert WEDGE.inertia_about_cg == WEDGE.solid.inertia[1, 1]
    box = sp.Body(0.4, 1.2, 30.0, WEDGE.cg_offset, WEDGE.inertia, length=0.6)
    flat = sp.simulate(WEDGE, ROOM, MOTION, dimensions=2)
    assert isinstance(flat, sp.Run)
    assert np.array_equal(flat.tilt, sp.simulate(box, ROOM, MOTION, dimensions=2).tilt)
    assert isinstance(sp.simulate(WEDGE, ROOM, sp.sine(1.0, 1.0, 1.0)), sp.Run)


def test_a_body_of_a_shape_is_a_value() -> None:
    assert pickle.loads(pickle.dumps(VASE)) == VASE
    assert hash(VASE) == hash(sp.Body.cone(0.10, 0.22, 0.35, 1.8))
    assert replace(VASE, shape=None) != VASE
    assert replace(VASE, shape=None).shape is None
    assert "shape=Solid(" in repr(VASE)
    for changed in ({"mass": 2.0}, {"base": "edges"}, {"base_insets": (0.01, 0.01)}, {"length": None}):
        with pytest.raises(sp.InputError, match="follows from the shape of the body"):
            replace(VASE, **changed)
    with pytest.raises(sp.InputError, match="shape is 'round'; it must be of type Solid"):
        replace(VASE, shape="round")


def test_what_takes_a_section_alone_refuses_it() -> None:
    belt = sp.MEASURES["belt"]()
    with pytest.raises(sp.InputError, match="has a shape of its own"):
        sp.verify(sp.Case(VASE, ROOM, MOTION))
    with pytest.raises(sp.InputError, match="has a shape of its own"):
        sp.sweep(sp.Case(VASE, ROOM, MOTION), {"motion.scale": [1.0]})
    with pytest.raises(sp.InputError, match="initial is given for what is no lone Body"):
        sp.simulate(VASE, ROOM, MOTION, initial=sp.State(tilt=0.1))
    pieces = [sp.Piece(sp.Body(0.4, 1.8, 60.0, length=0.9)), sp.Piece(VASE, (1.0, 0.0, 0.0), 0.0, [belt])]
    with pytest.raises(sp.InputError, match=r"pieces\[1\].*has a shape of its own"):
        sp.simulate(sp.Scene(pieces, ROOM), MOTION)


def test_a_piece_of_furniture_begins_as_stated() -> None:
    """A box by its section that begins tilted moves as the same box by its shape."""
    still = sp.sine(0.0, 1.0, 1.0)
    at, start = (0.0, 0.0, 0.2 * np.sin(0.1)), {"tilt": (0.0, 0.1, 0.0), "velocity": (0.0, 0.05, 0.0)}
    runs = [
        sp.simulate(sp.Piece(body, at, **start), sp.Room(), still)
        for body in (sp.Body(0.4, 1.8, 60.0, length=0.9), sp.Body.box(0.4, 0.9, 1.8, 60.0))
    ]
    assert runs[0].tilt[0] == pytest.approx(0.1)
    np.testing.assert_allclose(runs[0].place, runs[1].place, atol=1e-9)


def test_in_the_plane_a_shape_stands_on_what_it_stands_on_in_space() -> None:
    """A cone on its small end, and feet inside the outline: the section has the corners of the base."""
    cone = sp.Body.cone(0.2, 0.4, 1.0, 30.0)
    assert cone.base_width == pytest.approx(0.2)
    rise = cone.solid.centre_of_gravity[2]
    assert cone.overturning_acceleration()[0] == pytest.approx(9.80665 * 0.1 / rise)
    feet = [(x, y, 0.0) for x in (-0.05, 0.1) for y in (-0.1, 0.1)]
    drum = sp.Body.cylinder(0.4, 1.2, 40.0, feet=feet)
    assert drum.base_insets == pytest.approx((0.15, 0.1))
    motion = sp.sine(2.5, 1.0, 2.0)
    for body in (cone, drum):
        flat, space = (sp.simulate(body, sp.Room(sp.Floor(1.0, 1.0)), motion, dimensions=d) for d in (2, 3))
        assert flat.overturned == bool(space.overturned)
