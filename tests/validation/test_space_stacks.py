"""Two bodies on each other, beside closed forms: rest, joint rocking, and slides that end together."""

import math

import numpy as np
import pytest
from in_space import STICKING, G, steady, still

import stayput as sp

ROUGH = (5.0, 5.0)


@pytest.mark.parametrize("upper", ["box", "cylinder", "prism"])
@pytest.mark.parametrize("push", [0.0, 1.8])
def test_rest(upper: str, push: float) -> None:
    """With μ g above the floor's acceleration nothing moves, to the bit."""
    base = sp.Body.box(0.6, 0.8, 0.7, 40.0)
    small = {
        "box": sp.Body.box(0.4, 0.5, 0.5, 10.0),
        "cylinder": sp.Body.cylinder(0.4, 0.5, 10.0),
        "prism": sp.Body.hull(
            [
                (x, y, z)
                for z in (0, 0.5)
                for x, y in ((-0.2, -0.175), (0.2, -0.175), (0.1, 0.175), (-0.1, 0.175))
            ],
            10.0,
        ),
    }[upper]
    stack = (sp.Piece(base), sp.Piece(small, (0.05, -0.1, 0.7), heading=0.4))
    room = sp.Room(sp.Floor(0.25, 0.2))
    run = sp.simulate(sp.Scene(stack, room, friction=(0.25, 0.2)), steady(push, 0.5 * push, 1.0))
    assert np.array_equal(run.place, np.repeat(run.place[:, :1], len(run.time), axis=1))
    assert np.array_equal(run.attitude, np.repeat(run.attitude[:, :1], len(run.time), axis=1))


@pytest.mark.parametrize("rate", [0.25, 0.5])
def test_two_blocks_rock_as_one(rate: float) -> None:
    """About the lower edge, until they land: θ̈ = −(m g R/J_O) sin(α − θ) of both together.

    The upper block presses on the lower while they turn, and has no reason to move on it. So the pair does
    what one block of the whole height does.
    """
    half = sp.Body.box(0.4, 0.5, 0.7, 30.0)
    whole = sp.Body.box(0.4, 0.5, 1.4, 60.0)
    spin, corner = np.array([0.0, rate, 0.0]), np.array([0.2, 0.0, 0.0])
    levels = (half, 0.0), (half, 0.7)
    stack = tuple(
        sp.Piece(
            block,
            (0.0, 0.0, z),
            velocity=tuple(np.cross(spin, block.solid.centre_of_gravity + np.array([0.0, 0.0, z]) - corner)),
            rotation_rate=tuple(spin),
        )
        for block, z in levels
    )
    lever = whole.solid.centre_of_gravity - corner
    one = sp.Piece(whole, velocity=tuple(np.cross(spin, lever)), rotation_rate=tuple(spin))
    about = whole.solid.inertia[1, 1] + whole.mass * lever @ lever
    R, alpha = float(np.linalg.norm(lever)), math.atan2(0.2, 0.7)
    peak = alpha - math.acos(0.5 * about * rate**2 / (whole.mass * G * R) + math.cos(alpha))
    motion = still(0.6, 0.002)
    alone = sp.simulate(one, STICKING, motion, step=1e-4)
    both = sp.simulate(sp.Scene(stack, STICKING, friction=ROUGH), motion, step=1e-4)
    landed = int(np.argmax(alone[0].tilt)) + int(np.argmin(alone[0].tilt[np.argmax(alone[0].tilt) :]))
    until = slice(0, min(landed, len(motion.x)) - 2)
    assert alone[0].tilt[until].max() == pytest.approx(peak, rel=2e-3)
    for block in (0, 1):
        np.testing.assert_allclose(both[block].tilt[until], alone[0].tilt[until], atol=2e-3 * peak)
    assert both[1].slide[until].max() < 1e-4  # the upper rides on the lower: over that it does not slide


def test_what_is_joined_does_not_slide_over_each_other_at_a_wall() -> None:
    """As it hits the wall too: the upper block is carried along, by 15 cm in the room."""
    body = sp.Body.box(width=0.3, length=0.6, height=0.9, mass=40.0)
    pieces = [sp.Piece(body, name="lower"), sp.Piece(body, name="upper", on="lower")]
    corners = [(x, y, 0.9) for x in (-0.15, 0.15) for y in (-0.3, 0.3)]
    joints = [sp.Joint(1, 0, corner, stiffness=1e7) for corner in corners]
    room = sp.Room(sp.Floor(1.2, 1.1), left_wall=sp.Wall(0.2))
    run = sp.simulate(sp.Scene(pieces, room, joints=joints, friction=(1.5, 1.4)), sp.sine(3.0, 1.5, 3.0))
    assert run["upper"].wall_impacts > 0
    assert run["upper"].peak_slide < 1e-3
    assert run["upper"].peak_slide == pytest.approx(run["upper"].slide.max(), abs=1e-4)


@pytest.mark.parametrize("speed", [1.0, 2.0])
def test_the_upper_drags_the_lower(speed: float) -> None:
    """Thrown onto a block at rest, the upper loses μ₂ g and the lower gains (μ₂ m₂ − μ₁ (m₁ + m₂)) g/m₁.

    At t = v/((μ₂ g) + gain) they go at one speed; from then on μ₁ g stops both as one.
    """
    m1, m2, mu1, mu2 = 20.0, 60.0, 0.1, 0.3
    lower, upper = sp.Body.box(1.2, 1.0, 0.1, m1), sp.Body.box(0.4, 0.4, 0.1, m2)
    stack = (sp.Piece(lower), sp.Piece(upper, (-0.3, 0.0, 0.1), velocity=(speed, 0.0, 0.0)))
    gain = (mu2 * m2 - mu1 * (m1 + m2)) * G / m1
    assert gain > 0.0
    meet = speed / (mu2 * G + gain)
    common = gain * meet
    assert 0.5 * speed * meet < 0.8, "the upper must stay on the lower"
    last = 0.5 * common**2 / (mu1 * G)
    room = sp.Room(sp.Floor(mu1, mu1))
    run = sp.simulate(sp.Scene(stack, room, friction=(mu2, mu2)), still(3.0), step=1e-4)
    assert np.abs(run.velocity[:, -1]).max() == 0.0
    assert run[0].slide_in_plan[-1, 0] == pytest.approx(0.5 * gain * meet**2 + last, rel=3e-3)
    over_the_lower = 0.5 * speed * meet  # the difference of their speeds falls evenly to 0
    assert run[1].slide_in_plan[-1, 0] == pytest.approx(over_the_lower, rel=3e-3)


def test_both_slide_at_their_own_rates() -> None:
    """A floor at a: ẍ₁ = −a + (μ₁ (m₁ + m₂) − μ₂ m₂) g/m₁, and ẍ₂ = −a + μ₂ g, less held, ahead of it."""
    m1, m2, mu1, mu2, a = 40.0, 10.0, 0.25, 0.1, 5.0
    lower, upper = sp.Body.box(3.0, 1.0, 0.2, m1), sp.Body.box(0.4, 0.4, 0.2, m2)
    stack = (sp.Piece(lower), sp.Piece(upper, (1.0, 0.0, 0.2)))
    room, motion = sp.Room(sp.Floor(mu1, mu1)), steady(a, 0.0, 0.5)
    run = sp.simulate(sp.Scene(stack, room, friction=(mu2, mu2)), motion, step=1e-4)
    first = -a + (mu1 * (m1 + m2) - mu2 * m2) * G / m1
    second = -a + mu2 * G
    assert second < first < 0.0
    assert run[0].slide_in_plan[-1, 0] == pytest.approx(0.5 * first * 0.5**2, rel=2e-3)
    assert run[1].slide_in_plan[-1, 0] == pytest.approx(0.5 * (second - first) * 0.5**2, rel=2e-3)


@pytest.mark.parametrize("rate", [-0.2, -0.4, -0.8])
@pytest.mark.parametrize("over", [-0.002, -0.005, -0.01, -0.03])
def test_a_corner_that_hangs_over_is_not_inside(over: float, rate: float) -> None:
    """A box tips over the edge of the one below it, beyond which its own corners sink under that one's top.

    Its energy I θ̇²/2 about the edge lifts G, whose arm is a, to the tilt I θ̇²/(2 m g a) nearly.
    """
    arm, upper = 0.25 + over, np.array([over + 0.25, 0.0, 0.15])
    spin = np.array([0.0, rate, 0.0])
    thrown = sp.Piece(
        sp.Body.box(0.5, 0.5, 0.3, 20.0),
        (over, 0.0, 0.3),
        velocity=tuple(np.cross(spin, upper)),
        rotation_rate=tuple(spin),
    )
    lower = sp.Piece(sp.Body.box(0.5, 0.5, 0.3, 2e4))
    run = sp.simulate(sp.Scene([lower, thrown], STICKING, friction=(0.8, 0.8)), still(0.1))
    about_edge = (0.5**2 + 0.3**2) / 12.0 + arm**2 + 0.15**2
    assert run[1].peak_tilt == pytest.approx(0.5 * rate**2 * about_edge / (G * arm), rel=0.05)
    assert run.steps < 400


def slide_of_one(omega: float, amplitude: float, friction: tuple[float, float], until: float) -> float:
    """Return the peak slide of a block under a sine, in steps of 20 µs; it sticks as soon as it may."""
    static, kinetic = (coefficient * G for coefficient in friction)
    h, slips, v, x, peak = 2e-5, False, 0.0, 0.0, 0.0
    for k in range(int(until / h)):
        a = -amplitude * math.sin(omega * (k + 0.5) * h)
        slips = slips or abs(a) > static
        if slips:
            after = v + h * (a - math.copysign(kinetic, v or a))
            if after * v < 0.0:
                slips, after = abs(a) > static, 0.0
            x, v = x + 0.5 * h * (v + after), after
            peak = max(peak, abs(x))
    return peak


@pytest.mark.parametrize("step", [1e-3, 5e-4])
@pytest.mark.parametrize("omega", [33.0, 37.0, 42.0, 47.0])
def test_a_slab_that_turns_back_slips_on_and_carries_the_one_on_it(omega: float, step: float) -> None:
    """At the turn the law of friction would allow that it sticks and the upper one slips: it has not stuck.

    The time when it turns is not found, so that a slide at 1 ms is off by a few per cent.
    """
    sizes = zip((4.0, 3.7, 3.4), (1.5, 1.5, 8.0), strict=True)
    slabs = [
        sp.Piece(sp.Body.box(side, side, 0.04, mass), (0.0, 0.0, 0.04 * k))
        for k, (side, mass) in enumerate(sizes)
    ]
    t = 0.005 * np.arange(401)
    motion = sp.Motion(dt=0.005, x=8.0 * np.sin(omega * t))
    run = sp.simulate(
        sp.Scene(slabs, sp.Room(sp.Floor(0.55, 0.55)), friction=(0.36, 0.26)), motion, step=step
    )
    second, third = np.abs(np.diff(run.place[:, :, 0], axis=0)).max(axis=1)
    assert third < 1e-6
    assert second == pytest.approx(slide_of_one(omega, 8.0, (0.36, 0.26), 2.0), rel=0.05)
