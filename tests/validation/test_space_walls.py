"""Walls on any side: rebounds in closed form, and a room that is turned with the piece and the motion."""

import math
from typing import Any

import numpy as np
import pytest

import stayput as sp

SLIPPERY = sp.Floor(0.0, 0.0)
SMOOTH = {"restitution": 0.6, "friction": 0.0}
BOX = sp.Body.box(0.4, 0.6, 1.2, 80.0)
STILL = sp.Motion(dt=0.01, x=np.zeros(101), name="still")


@pytest.mark.parametrize(("side", "way"), [("near_side_wall", -1.0), ("far_side_wall", 1.0)])
@pytest.mark.parametrize("restitution", [0.0, 0.3, 1.0])
def test_a_box_that_slides_into_a_side_wall_returns_with_its_restitution(
    side: str, way: float, restitution: float
) -> None:
    """Newton: at v it meets the wall at gap/v, over all of its face, and leaves with −e v."""
    speed, gap = 0.5, 0.1
    room = sp.Room(SLIPPERY, **{side: sp.Wall(gap, restitution, 0.0)})
    standing = sp.Piece(BOX, at=(0.3, -0.2, 0.0), velocity=(0.0, way * speed, 0.0))
    run = sp.simulate(standing, room, STILL)
    apart = np.abs(run.time - gap / speed) > 0.005
    expected = way * np.where(run.time < gap / speed, speed, -restitution * speed)
    np.testing.assert_allclose(run.velocity[0, apart, 1], expected[apart], atol=1e-9)
    assert (way * run[0].slide_in_plan[:, 1]).max() == pytest.approx(gap, abs=1e-6)
    assert run.tilt.max() < 1e-7  # the impulses are found to so much
    first = run.hits[0]
    assert (first.surface, first.time) == (side, pytest.approx(gap / speed, abs=2e-3))
    assert first.speed == pytest.approx(speed, abs=1e-9)


def test_in_the_corner_of_two_walls_each_returns_its_own_component() -> None:
    """Both at once, after 0.2 s: the components are independent where nothing rubs."""
    walls = {"left_wall": sp.Wall(0.1, **SMOOTH), "near_side_wall": sp.Wall(0.06, 0.2, 0.0)}
    standing = sp.Piece(BOX, velocity=(-0.5, -0.3, 0.0))
    run = sp.simulate(standing, sp.Room(SLIPPERY, **walls), STILL)
    np.testing.assert_allclose(run.velocity[0, -1], (0.3, 0.06, 0.0), atol=1e-6)
    assert {hit.surface for hit in run.hits} == {"left_wall", "near_side_wall"}
    one_after_the_other = sp.Room(SLIPPERY, **{**walls, "near_side_wall": sp.Wall(0.09, 0.2, 0.0)})
    run = sp.simulate(standing, one_after_the_other, STILL)
    np.testing.assert_allclose(run.velocity[0, -1], (0.3, 0.06, 0.0), atol=1e-6)


def shaking(dt: float = 0.01) -> tuple[np.ndarray, np.ndarray]:
    """Two components of a second, of which each makes the boxes below hit a wall."""
    t = dt * np.arange(101)
    return 4.0 * np.sin(7.0 * t), 2.5 * np.sin(5.0 * t + 0.4)


@pytest.mark.parametrize("both", [False, True])
def test_a_room_turned_by_a_right_angle_with_the_piece_and_the_motion(both: bool) -> None:
    """What happens to the back and the front happens to the near and the far side."""
    along, across = shaking()
    across = across if both else 0.0 * across
    back, front = sp.Wall(0.005, 0.4, 0.2), sp.Wall(0.01, 0.2, 0.5)
    straight = sp.simulate(
        sp.Piece(BOX), sp.Room(left_wall=back, right_wall=front), sp.Motion(dt=0.01, x=along, y=across)
    )
    room = sp.Room(near_side_wall=back, far_side_wall=front)
    turned = sp.simulate(sp.Piece(BOX, heading=math.pi / 2), room, sp.Motion(dt=0.01, x=-across, y=along))
    assert straight[0].wall_impacts > 1
    assert straight.tilt.max() > 0.01
    early = straight.time < 0.6
    np.testing.assert_allclose(turned[0].tilt[early], straight[0].tilt[early], atol=2e-4)
    back_again = np.stack([turned.place[..., 1], -turned.place[..., 0], turned.place[..., 2]], axis=-1)
    np.testing.assert_allclose(back_again[0, early], straight.place[0, early], atol=2e-4)


def test_a_piece_of_furniture_between_side_walls_is_one_between_the_others_turned() -> None:
    along, _ = shaking()
    back, front = sp.Wall(0.005, 0.4, 0.2), sp.Wall(0.01, 0.2, 0.5)
    deep = sp.Body(0.4, 1.2, 80.0, length=0.6)
    long = sp.Body(0.6, 1.2, 80.0, length=0.4)
    ahead = sp.simulate(
        deep, sp.Room(left_wall=back, right_wall=front), sp.Motion(dt=0.01, x=along), dimensions=3
    )
    aside = sp.simulate(
        long,
        sp.Room(near_side_wall=back, far_side_wall=front),
        sp.Motion(dt=0.01, x=0.0 * along, y=along),
        dimensions=3,
    )
    planar = sp.simulate(deep, sp.Room(left_wall=back, right_wall=front), sp.Motion(dt=0.01, x=along))
    assert isinstance(planar, sp.Run)
    assert planar.wall_impacts > 1
    early = ahead.time < 0.6
    np.testing.assert_allclose(aside.tilt[early], ahead.tilt[early], atol=2e-4)
    np.testing.assert_allclose(aside.tilt[early], np.abs(planar.tilt[early]), atol=1e-3)


def test_side_walls_that_are_not_touched_change_no_bit() -> None:
    along, _ = shaking()
    body, motion = sp.Body(0.4, 1.2, 80.0, length=0.6), sp.Motion(dt=0.01, x=along)
    walls = {"left_wall": sp.Wall(0.005), "ceiling": sp.Ceiling(1.21)}
    beside = {"near_side_wall": sp.Wall(1e-3), "far_side_wall": sp.Wall(2e-3)}
    free = sp.simulate(body, sp.Room(**walls), motion, dimensions=3)
    walled = sp.simulate(body, sp.Room(**walls, **beside), motion, dimensions=3)
    assert free.tilt.max() > 0.01
    assert free[0].wall_impacts > 0
    for name in ("place", "attitude", "velocity", "rotation_rate", "force"):
        assert getattr(walled, name).tobytes() == getattr(free, name).tobytes(), name


@pytest.mark.parametrize(
    ("x", "room"),
    [
        (1.0, {"ceiling": sp.Ceiling(0.6)}),
        (0.0, {"left_wall": sp.Wall(0.0), "right_wall": sp.Wall(0.0)}),
        (0.0, {"right_wall": sp.Wall(0.0)}),
    ],
)
def test_surfaces_that_touch_a_body_at_first_hold_nothing(x: float, room: dict[str, Any]) -> None:
    # what nothing presses against them does not rub there either
    ground, floor = sp.near_fault(), sp.Floor(0.1, 0.1)
    motion = sp.Motion(dt=ground.dt, x=x * ground.x, y=ground.x, name="along a wall")
    body = sp.Body(0.4, 0.6, 30.0, length=0.6)
    free = sp.simulate(body, sp.Room(floor), motion, dimensions=3)
    between = sp.simulate(body, sp.Room(floor, **room), motion, dimensions=3)
    assert between.peak_slide == pytest.approx(free.peak_slide, rel=1e-3)


def test_a_box_beside_a_wall_that_is_shaken_along_its_depth_does_not_turn_in_plan() -> None:
    """Its halves are mirror images, even where friction allows one corner of a landing edge to bear all."""
    body = sp.Body(0.354, 1.579, 80.0, length=0.3)
    wall, motion = sp.Wall(0.0049, 0.834), sp.sine(7.80451, 3.59332, 3.0)
    for friction, step in ((1.159, 1e-3), (1.159, 5e-4), (1.5, 1e-3)):
        room = sp.Room(sp.Floor(friction, 0.975 * friction, restitution=0.64371), left_wall=wall)
        planar = sp.simulate(body, room, motion, dimensions=2)
        run = sp.simulate(body, room, motion, dimensions=3, step=step)
        assert run.wall_impacts > 10
        # rounding that 20 to 34 impacts enlarge
        assert np.abs(run.yaw).max() < 1e-5
        assert np.abs(run[0].slide_in_plan[:, 1]).max() < 1e-5
        assert run.peak_slide == pytest.approx(planar.peak_slide, abs=1e-4)


def slide_against_a_wall(motion: sp.Motion, friction: tuple[float, float], gap: float) -> float:
    """Return the peak slide of a block on which a plastic wall stands at −gap, in steps of dt/400.

    It stands while static friction holds it or it is pressed against the wall, and where it would turn back.
    """
    static, kinetic = (coefficient * 9.80665 for coefficient in friction)
    h = motion.dt / 400
    times = h * (np.arange(400 * (len(motion.x) - 1)) + 0.5)
    x = v = peak = 0.0
    for a in (-np.interp(times, motion.dt * np.arange(len(motion.x)), motion.x)).tolist():
        if v == 0.0 and (abs(a) <= static or (x == -gap and a < 0.0)):
            continue
        after = v + h * (a - math.copysign(kinetic, v or a))
        if after * v < 0.0 and abs(a) <= static:
            after = 0.0
        x, v = x + 0.5 * h * (v + after), after
        if x <= -gap:
            x, v = -gap, max(0.0, v)
        peak = max(peak, abs(x))
    return peak


@pytest.mark.parametrize(
    ("body", "friction", "gap", "sine"),
    [
        (sp.Body(1.02, 0.64, 50.0, length=0.51), (0.253, 0.209), 6.345e-3, (7.21, 4.62)),
        (sp.Body(0.92, 1.73, 50.0, length=0.43), (0.396, 0.319), 3e-5, (6.85, 4.69)),
        (sp.Body(0.51, 0.71, 50.0, length=0.87), (0.313, 0.254), 5.25e-3, (6.3, 4.15)),
    ],
)
def test_a_block_that_slides_against_a_plastic_wall_leaves_it_when_its_friction_gives_way(
    body: sp.Body, friction: tuple[float, float], gap: float, sine: tuple[float, float]
) -> None:
    room, motion = sp.Room(sp.Floor(*friction), left_wall=sp.Wall(gap, 0.0)), sp.sine(*sine, 3.0)
    exact = slide_against_a_wall(motion, friction, gap)
    for dimensions in (2, 3):
        run = sp.simulate(body, room, motion, dimensions=dimensions)
        assert run.peak_slide == pytest.approx(exact, rel=3e-3)
        assert run.peak_tilt < 1e-5


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_plane_and_space_count_the_same_hits_on_walls_and_see_the_gap_used_up(restitution: float) -> None:
    """Walls 1 mm off, which the block meets between samples; hits below 1 cm/s count in neither."""
    wall = sp.Wall(1e-3, restitution)
    room = sp.Room(sp.Floor(0.15, 0.13), left_wall=wall, right_wall=wall)
    body, motion = sp.Body(0.8, 0.5, 50.0, length=0.6), sp.sine(5.0, 3.0, 3.0)
    planar, run = (sp.simulate(body, room, motion, dimensions=dimensions) for dimensions in (2, 3))
    assert planar.wall_impacts == run.wall_impacts > 10
    for each in (planar, run):
        assert each.peak_slide == pytest.approx(1e-3, abs=2e-6)
    moved = sp.simulate(sp.Scene([sp.Piece(body, at=(0.5, 0.25, 0.0))], room), motion)
    assert moved[0].peak_slide == pytest.approx(1e-3, abs=2e-6)
