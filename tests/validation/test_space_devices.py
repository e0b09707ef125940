"""Devices and floor laws in space: beside the engine in the plane, and beside closed forms."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.measures import MEASURES

G = 9.80665
NEAR_FAULT = sp.near_fault()
BODY = sp.Body(0.4, 1.8, 100.0, length=0.9)


def shaken(scale: float) -> sp.Motion:
    assert NEAR_FAULT.z is not None
    return sp.Motion(dt=NEAR_FAULT.dt, x=scale * NEAR_FAULT.x, z=scale * NEAR_FAULT.z, name="in the plane")


def still(duration: float, dt: float = 0.005) -> sp.Motion:
    return sp.Motion(dt=dt, x=np.zeros(round(duration / dt) + 1), name="still")


@pytest.mark.parametrize(
    ("kind", "scale", "settlement"),
    [
        ("l_bracket", 0.5, 0.0),
        ("l_bracket", 1.0, 0.0),
        ("l_bracket_board", 1.0, 1e-4),
        ("gel_mats", 0.5, 0.0),
        ("belt", 0.5, 0.0),
        ("belt", 1.0, 5e-5),
        ("tension_pole", 0.5, 0.0),
        ("tension_pole", 1.0, 0.0),
        ("wedge_stopper", 1.0, 0.0),
        ("base_isolator", 0.5, 0.0),
    ],
)
def test_a_measure_under_one_component_as_in_the_plane(kind: str, scale: float, settlement: float) -> None:
    """Two brackets, belts, poles and four mats at their places bear together what one element does there."""
    room = sp.Room(sp.Floor(settlement=settlement), sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
    measure, motion = MEASURES[kind](), shaken(scale)
    flat = sp.simulate(BODY, room, motion, [measure], dimensions=2)
    run = sp.simulate(BODY, room, motion, [measure], dimensions=3, step=5e-4)
    assert run.outcome == flat.outcome
    assert run[0].peak_tilt == pytest.approx(flat.peak_tilt, rel=0.015, abs=3e-5)
    # flat against the wall, rounding tells which edge meets it first
    assert np.abs(run.yaw).max() < (1e-2 if kind == "base_isolator" else 1e-3)
    for device in flat.devices:
        alike = [one for one in run.devices if one.place.startswith(device.place)]
        for peak in ("peak_pull", "peak_push", "peak_shear"):
            together = sum(getattr(one, peak) for one in alike)
            # a damper's force at a landing is that of a mean rate in the step: 60 N of some 4 kN of strength
            assert together == pytest.approx(getattr(device, peak), rel=0.03, abs=60.0)
        for one in alike:
            assert one.failed == device.failed
            assert one.failure_time == pytest.approx(device.failure_time, abs=0.01, nan_ok=True)


@pytest.mark.parametrize("restitution", [1.0, 0.9])
@pytest.mark.parametrize("landing_place", [1.0, 0.7])
@pytest.mark.parametrize("along", ["x", "y"])
def test_a_landing_keeps_the_rate_that_the_floor_lets_it(
    restitution: float, landing_place: float, along: str
) -> None:
    """The factor on the rate of a rocking box, over its depth and over its length as over a depth."""
    size = {"x": (0.4, 3.0), "y": (3.0, 0.4)}[along]
    floor = sp.Floor(5.0, 5.0, restitution=restitution, landing_place=landing_place)
    flat = sp.simulate(
        sp.Body(0.4, 1.8, 100.0), sp.Room(floor), still(2.0), initial=sp.State(tilt=0.1), dimensions=2
    )
    box = sp.Body.box(size[0], size[1], 1.8, 100.0)
    tilt, foot = 0.1, 0.2
    turn = (0.0, tilt, 0.0) if along == "x" else (-tilt, 0.0, 0.0)
    way = foot * (1.0 - math.cos(tilt))
    at = (way, 0.0, foot * math.sin(tilt)) if along == "x" else (0.0, way, foot * math.sin(tilt))
    start = sp.Piece(box, at, tilt=turn)
    run = sp.simulate(start, sp.Room(floor), still(2.0), step=2e-4)
    upright = run.turn[0, :, :, 2]
    tilted = np.arcsin(upright[:, 0] if along == "x" else upright[:, 1])
    assert tilted.min() == pytest.approx(flat.tilt.min(), rel=0.01)


def test_the_friction_of_an_edge_alone() -> None:
    """A box that is tipped slides by the edge's coefficients, one that stands flat by the base's.

    Between the two it chatters: flat it would tip, tipped it falls back. Which of them hold in a landing
    differs, so that the slides are up to 6 % apart, and long steps do not follow it.
    """
    floor = sp.Floor(0.5, 0.45, edge_static_friction=0.25, edge_kinetic_friction=0.2)
    motion = shaken(0.6)
    flat = sp.simulate(BODY, sp.Room(floor), motion, dimensions=2)
    run = sp.simulate(BODY, sp.Room(floor), motion, dimensions=3, step=5e-5)
    assert flat.peak_slide > 0.01
    assert run[0].peak_slide == pytest.approx(flat.peak_slide, rel=0.08)
    assert run[0].peak_tilt == pytest.approx(flat.peak_tilt, rel=0.02)


def test_a_box_turns_on_two_springs() -> None:
    """On a smooth floor two springs k at ± a along its length, joints to heavy boxes: ω² = 2 k a²/J_z."""
    light, heavy = sp.Body.box(0.4, 1.0, 0.3, 20.0), sp.Body.box(0.4, 1.0, 0.3, 1e6)
    stiffness, a = 2e4, 0.4
    joints = [
        sp.Joint(0, 1, (0.2, y, 0.15), (0.5, y, 0.15), stiffness=stiffness, damping=0.0) for y in (-a, a)
    ]
    # belts only pull: two more on the other side, all of them tightened by a push apart
    start = sp.Piece(light, rotation_rate=(0.0, 0.0, 0.02))
    anchors = [start, sp.Piece(heavy, (0.7, 0.0, 0.0)), sp.Piece(heavy, (-0.7, 0.0, 0.0))]
    joints += [
        sp.Joint(0, 2, (-0.2, y, 0.15), (-0.5, y, 0.15), stiffness=stiffness, damping=0.0) for y in (-a, a)
    ]
    run = sp.simulate(
        sp.Scene(anchors, sp.Room(sp.Floor(0.0, 0.0)), friction=(0.0, 0.0), joints=joints),
        still(1.0, 1e-3),
        step=2e-4,
    )
    yaw = run[0].yaw
    # at any turn one belt of each pair pulls: two at a, as one spring on each side
    inertia = float(light.solid.inertia[2, 2])
    omega = math.sqrt(2.0 * stiffness * a * a / inertia)
    crossings = run.time[np.flatnonzero(np.diff(np.sign(yaw[1:]))) + 1]
    assert np.diff(crossings).mean() == pytest.approx(math.pi / omega, rel=0.01)
    assert yaw.max() == pytest.approx(0.02 / omega, rel=0.01)


def test_a_piece_turns_about_the_bracket_that_holds() -> None:
    """Shaken along its length and its depth, one of two weak brackets goes first."""
    t = 0.005 * np.arange(2001)
    motion = sp.Motion(
        dt=0.005, x=7.0 * np.sin(9.0 * t), y=5.0 * np.sin(6.0 * t + 0.5), name="two directions"
    )
    room = sp.Room(sp.Floor(0.15, 0.12), sp.Wall(0.02))
    run = sp.simulate(BODY, room, motion, [MEASURES["l_bracket_board"]()])
    assert run.engine == "space"
    left, right = run.devices
    assert {left.place, right.place} == {"left", "right"}
    assert left.failed
    assert right.failed
    assert left.failure_time != right.failure_time
    assert np.abs(run.yaw).max() > 0.02


@pytest.mark.parametrize("margin", [1.05, 0.95])
def test_a_connector_breaks_at_its_strength_and_holds_below(margin: float) -> None:
    """Two boxes in flight part at v on a connector of stiffness k: its pull is v √(k m₁ m₂/(m₁ + m₂))."""
    lower, upper = sp.Body.box(0.5, 0.5, 0.5, 40.0), sp.Body.box(0.5, 0.5, 0.3, 10.0)
    stiffness, speed = 1e4, 0.2
    pull = speed * math.sqrt(stiffness * 8.0)
    members = [
        sp.Piece(lower, (0.0, 0.0, 20.0)),
        sp.Piece(upper, (0.0, 0.0, 20.5), velocity=(0.0, 0.0, speed)),
    ]
    joint = sp.Joint(1, 0, (0.0, 0.0, 20.5), stiffness=stiffness, strength=margin * pull, damping=0.0)
    run = sp.simulate(sp.Scene(members, joints=[joint]), still(0.08), step=2e-4)
    (found,) = run.devices
    assert found.failed == (margin < 1.0)
    assert found.peak_pull == pytest.approx(min(margin, 1.0) * pull, rel=0.01)
    if found.failed:
        assert found.cause == "pulled off"
        assert found.failure_time == pytest.approx(math.asin(margin) / math.sqrt(stiffness / 8.0), rel=0.02)


def test_forces_on_a_body_at_rest_are_its_weight() -> None:
    run = sp.simulate(BODY, sp.Room(sp.Floor()), still(0.2), dimensions=3)
    np.testing.assert_allclose(run.force[0, 1:, 0], [[0.0, 0.0, 100.0 * G]] * 40, rtol=1e-6, atol=1e-6)
    stack = [sp.Piece(sp.Body.box(0.5, 0.5, 0.2, 10.0), (0.0, 0.0, 0.2 * n)) for n in range(3)]
    run = sp.simulate(sp.Scene(stack), still(0.2))
    np.testing.assert_allclose(run.force[:, -1, 0, 2], [30.0 * G, 0.0, 0.0], atol=1e-3)
    np.testing.assert_allclose(run.force[:, -1, 1, 2], [-20.0 * G, 10.0 * G, 10.0 * G], atol=1e-3)


def test_what_hits_what_and_how_fast() -> None:
    """A box slides without friction into another: they meet at its speed, and once."""
    box = sp.Body.box(0.3, 0.3, 0.3, 10.0)
    thrown = sp.Piece(box, velocity=(1.0, 0.0, 0.0))
    run = sp.simulate(
        sp.Scene([thrown, sp.Piece(box, (0.8, 0.0, 0.0))], sp.Room(sp.Floor(0.0, 0.0))), still(1.0)
    )
    (hit,) = run.hits
    assert {hit.body, hit.other} == {0, 1}
    assert hit.time == pytest.approx(0.5, abs=2e-3)
    assert hit.speed == pytest.approx(1.0, abs=1e-6)
    np.testing.assert_allclose(run.velocity[:, -1, 0], 0.5, atol=1e-6)
    assert [(one.floor_impacts, one.wall_impacts, one.body_impacts) for one in run.pieces] == [(0, 0, 1)] * 2
