"""What must change nothing: turning everything in plan, a mirror, the order of bodies, and units.

The runs are short and rough: rocking on edges and corners, sliding, a rim. What is left is rounding and the
error of the step, as contacts are solved one after another in the order of the corners.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from in_space import about

import stayput as sp

BODIES = {
    "box": sp.Body.box(0.4, 0.6, 1.5, 80.0),
    "cylinder": sp.Body.cylinder(0.45, 1.4, 60.0),
    "prism": sp.Body.hull(
        [(x, y, z) for z in (0.0, 1.3) for x, y in ((-0.25, -0.2), (0.25, -0.2), (0.15, 0.2), (-0.15, 0.1))],
        70.0,
    ),
}
ROOM = sp.Room(sp.Floor(0.45, 0.4))


def shaking(turn: np.ndarray | None = None, slower: float = 1.0) -> sp.Motion:
    """Two components of a second and a half, turned or mirrored by a matrix in plan; or slower."""
    t = 0.01 * np.arange(151)
    plan = np.array([3.6 * np.sin(6.0 * t), 2.4 * np.sin(4.5 * t + 0.8)])
    if turn is not None:
        plan = turn[:2, :2] @ plan
    return sp.Motion(dt=0.01 * slower, x=plan[0], y=plan[1], name="two components")


def run(name: str, turn: float = 0.0, motion: sp.Motion | None = None) -> sp.Run:
    standing = sp.Piece(BODIES[name], heading=0.3 + turn)
    return sp.simulate(standing, ROOM, motion or shaking(), step=1e-4)


def first_second(history: np.ndarray) -> np.ndarray:
    """The part in which impacts have not yet enlarged what differs."""
    return history[:, :100]


@pytest.mark.parametrize("name", BODIES)
@pytest.mark.parametrize("heading", [0.7, math.pi / 2, 3.0, -2.2])
def test_any_heading_of_everything(name: str, heading: float) -> None:
    turn = about((0.0, 0.0, 1.0), heading)
    straight, other = run(name), run(name, heading, shaking(turn))
    assert straight.tilt.max() > 0.005 or straight.slide.max() > 0.005
    np.testing.assert_allclose(first_second(other.place @ turn), first_second(straight.place), atol=2e-4)
    np.testing.assert_allclose(other.tilt[:100], straight.tilt[:100], atol=5e-4)


@pytest.mark.parametrize("name", BODIES)
def test_a_mirror(name: str) -> None:
    """RoomEvents in a mirror across y: y, and rotations about x and z, change their signs."""
    body = BODIES[name]
    mirror = np.diag([1.0, -1.0, 1.0])
    image = sp.Body.hull(
        body.solid.vertices @ mirror,
        body.mass,
        centre_of_gravity=body.solid.centre_of_gravity @ mirror,
        inertia=mirror @ body.solid.inertia @ mirror,
        rims=body.solid.rims,
    )
    standing = sp.Piece(image, heading=-0.3)
    straight = run(name)
    other = sp.simulate(standing, ROOM, shaking(mirror), step=1e-4)
    np.testing.assert_allclose(first_second(other.place @ mirror), first_second(straight.place), atol=2e-4)
    np.testing.assert_allclose(
        first_second(other.rotation_rate) * [-1.0, 1.0, -1.0], first_second(straight.rotation_rate), atol=0.02
    )


@pytest.mark.parametrize("name", BODIES)
def test_mass_has_no_unit(name: str) -> None:
    """All masses times 4 (a power of two: the same bits), and times 3."""
    body = BODIES[name]
    straight = run(name)
    for factor in (4.0, 3.0):
        heavy = sp.Body.hull(
            body.solid.vertices,
            factor * body.mass,
            centre_of_gravity=body.solid.centre_of_gravity,
            inertia=factor * body.solid.inertia,
            rims=body.solid.rims,
        )
        other = sp.simulate(sp.Piece(heavy, heading=0.3), ROOM, shaking(), step=1e-4)
        np.testing.assert_allclose(first_second(other.place), first_second(straight.place), atol=5e-6)
        if factor == 4.0:
            assert other.place.tobytes() == straight.place.tobytes()


@pytest.mark.parametrize("name", BODIES)
def test_a_model_of_a_quarter_of_the_size_in_half_the_time(name: str) -> None:
    """Froude: lengths times k, times times √k, accelerations alike, with k = 1/4."""
    body = BODIES[name]
    rims = body.solid.rims * [0.25, 0.25, 0.25, 1.0, 1.0, 1.0, 0.25] if len(body.solid.rims) else ()
    model = sp.Body.hull(
        0.25 * body.solid.vertices,
        body.mass,
        centre_of_gravity=0.25 * body.solid.centre_of_gravity,
        inertia=body.solid.inertia / 16.0,
        rims=rims,
    )
    straight = run(name)
    motion = shaking(slower=0.5)
    floor = replace(ROOM.floor, rolling_resistance=0.25 * ROOM.floor.rolling_resistance)
    small = sp.simulate(sp.Piece(model, heading=0.3), sp.Room(floor), motion, step=5e-5)
    np.testing.assert_allclose(first_second(4.0 * small.place), first_second(straight.place), atol=1e-3)
    np.testing.assert_allclose(small.tilt[:100], straight.tilt[:100], atol=1e-3)


@pytest.mark.parametrize("order", [(2, 0, 1), (1, 2, 0), (2, 1, 0)])
def test_the_order_of_several_to_the_bit(order: tuple[int, ...]) -> None:
    """A stack that is joined and held, and a cylinder beside it that both hit."""
    chest = sp.Body(0.45, 0.9, 60.0, length=0.8)
    members = [
        sp.Piece(chest, measures=[sp.MEASURES["l_bracket"]()]),
        sp.Piece(sp.Body(0.4, 0.6, 20.0, length=0.7), at=(0.0, 0.02, 0.9), heading=0.1),
        sp.Piece(sp.Body.cylinder(0.4, 1.2, 60.0), at=(0.5, 0.1, 0.0)),
    ]
    room = sp.Room(sp.Floor(0.45, 0.4), left_wall=sp.Wall(0.02))
    motion = sp.near_fault().scaled(0.9)

    def several(order: tuple[int, ...]) -> sp.Run:
        joint = sp.Joint(order.index(1), order.index(0), (0.0, 0.3, 0.9), strength=300.0, shear=300.0)
        return sp.simulate(sp.Scene([members[n] for n in order], room, joints=[joint]), motion)

    straight, other = several((0, 1, 2)), several(order)
    assert min(piece.body_impacts for piece in straight.pieces) > 0, "all have hit another"
    for history in ("place", "attitude", "velocity", "force"):
        there = getattr(other, history)
        assert there[np.argsort(order)].tobytes() == getattr(straight, history).tobytes()
    pulls = [sorted(device.peak_pull for device in run.devices) for run in (straight, other)]
    assert pulls[0] == pulls[1]
    assert max(pulls[0]) > 0.0
    gaps = other.gaps[1]
    assert gaps.room[np.argsort(order)].tobytes() == straight.gaps[1].room.tobytes()
    assert sorted(
        (hit.time, hit.speed, {order[n] for n in (hit.body, hit.other) if n is not None})
        for hit in other.hits
    ) == sorted(
        (hit.time, hit.speed, {n for n in (hit.body, hit.other) if n is not None}) for hit in straight.hits
    )
