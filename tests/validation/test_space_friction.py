"""Friction in two directions, beside closed forms: circular shaking, sliding with spin."""

import math
from itertools import pairwise

import numpy as np
import pytest
from in_space import G, steady, still
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

import stayput as sp


@pytest.mark.parametrize("height", [0.05, 0.3])
@pytest.mark.parametrize(("amplitude", "friction"), [(4.0, 0.2), (3.0, 0.28), (6.0, 0.1)])
def test_circular_shaking(amplitude: float, friction: float, height: float) -> None:
    """A block on a floor whose acceleration a goes round at ω slides in a circle.

    With the slip v = V exp(i(ωt + φ)), v̇ = −a − μ g v/|v| asks for |iωV + μ g| = a: in the steady state
    V = √(a² − μ² g²)/ω, on a circle of the radius V/ω, and it begins so. The block
    does not turn, however high G is: the floor's forces are parallel, their normal parts displaced along
    them.
    """
    omega, turns, dt = 2.0 * math.pi, 6, 0.002
    t = dt * np.arange(round(turns / dt) + 1)
    shaking = sp.Motion(
        dt=dt, x=amplitude * np.cos(omega * t), y=amplitude * np.sin(omega * t), name="circle"
    )
    block = sp.Body.box(0.9, 0.9, height, 30.0, base="feet")
    last = slice(-round(1.0 / dt) - 1, None)
    speed = math.sqrt(amplitude**2 - (friction * G) ** 2) / omega
    start = -amplitude / complex(friction * G, omega * speed) * speed
    thrown = sp.Piece(block, velocity=(start.real, start.imag, 0.0))
    run = sp.simulate(thrown, sp.Room(sp.Floor(friction, friction)), shaking)
    np.testing.assert_allclose(np.linalg.norm(run.velocity[0, last, :2], axis=1), speed, rtol=1e-4)
    np.testing.assert_allclose(np.ptp(run.place[0, last, :2], axis=0), 2.0 * speed / omega, rtol=2e-3)
    assert np.abs(run.rotation_rate).max() < 1e-6


def test_circular_shaking_begins_at_the_coefficient() -> None:
    """μ g holds a block in whatever direction a points: the cone is round, and what sticks does not creep."""
    t = 0.01 * np.arange(101)
    block = sp.Body.box(0.9, 0.9, 0.1, 30.0)
    for share, slides in ((0.999, False), (1.01, True)):
        x, y = (share * 0.3 * G * part(2.0 * math.pi * t) for part in (np.cos, np.sin))
        # chords between samples lie inside the circle, by a part in 2000
        run = sp.simulate(block, sp.Room(sp.Floor(0.3, 0.3)), sp.Motion(dt=0.01, x=x, y=y))
        assert (run.slide.max() > 0.0) == slides


@pytest.mark.parametrize("spike", [2.0, 6.0, 12.0])
@pytest.mark.parametrize("dt", [0.005, 0.01, 0.02])
def test_a_rocking_box_slips_at_a_peak_of_the_motion(dt: float, spike: float) -> None:
    """The edge on which it rocks holds up to μ_s at the sample of a peak, not only in the mean of a step.

    About the edge θ̈ = R/(4/3 R²) (a cos s − g sin s) with s = α − θ; of the mass it asks for the forces
    T = a − R (θ̈ cos s + θ̇² sin s) and N = g + R (θ̈ sin s − θ̇² cos s).
    """
    width, height, peak = 0.4, 1.2, round(0.2 / dt)
    t = dt * np.arange(round(1.0 / dt))
    x = 5.0 * np.sin(3.0 * math.pi * t) * (t < 0.34)
    x[peak] += spike
    R, alpha = 0.5 * math.hypot(width, height), math.atan(width / height)

    def turns(at: float, y: np.ndarray) -> list[float]:
        s, a = alpha - y[0], float(np.interp(at, t, x))
        found = 0.75 / R * (a * math.cos(s) - G * math.sin(s))
        return [y[1], 0.0 if y[0] <= 0.0 and found < 0.0 else found]

    theta, rate = solve_ivp(turns, (0.0, t[peak]), [0.0, 0.0], max_step=1e-4, rtol=1e-8).y[:, -1]
    s, turned = alpha - theta, turns(t[peak], np.array([theta, rate]))[1]
    along = x[peak] - R * (turned * math.cos(s) + rate**2 * math.sin(s))
    needed = along / (G + R * (turned * math.sin(s) - rate**2 * math.cos(s)))
    for share, slides in ((0.996, True), (1.004, False)):
        room = sp.Room(sp.Floor(share * needed, 0.6 * share * needed))
        run = sp.simulate(sp.Body(width, height, 80.0, length=0.5), room, sp.Motion(dt, x), dimensions=3)
        assert (np.abs(run[0].slide_in_plan[: peak + round(0.1 / dt), 0]).max() > 1e-4) == slides


def ring(count: int, radius: float = 0.3, start: float = 0.1) -> np.ndarray:
    """Feet on a circle, level with the base, shape (count, 3) [m]."""
    angles = start + 2.0 * math.pi * np.arange(count) / count
    return np.column_stack((radius * np.cos(angles), radius * np.sin(angles), np.zeros(count)))


def disc(count: int, share: float) -> sp.Body:
    """A body on feet, or without any a flat one, G level with the floor, of the moment share · m (0.3 m)²."""
    moments = 8.0 * 0.3**2 * np.diag([0.6 * share, 0.6 * share, share])
    feet = {"feet": ring(count)} if count else {}
    return sp.Body.cylinder(0.7, 0.05, 8.0, centre_of_gravity=(0.0, 0.0, 0.0), inertia=moments, **feet)


@pytest.mark.parametrize(("velocity", "rate"), [(1.0, 2.0), (0.3, 6.0), (1.0, 0.2)])
def test_a_body_on_three_feet_slides_and_spins(velocity: float, rate: float) -> None:
    """With G level with three feet around it, each carries a third of the weight.

    The reference integrates m v̇ = −μ (m g/3) Σ uᵢ/|uᵢ| and C ω̇ = −μ (m g/3) Σ (rᵢ × uᵢ)_z/|uᵢ| to 1e-10.
    """
    friction, solid = 0.25, disc(3, 0.5)
    m, C = solid.mass, solid.solid.inertia[2, 2]

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        cos, sin = math.cos(y[2]), math.sin(y[2])
        arms = ring(3)[:, :2] @ np.array([[cos, sin], [-sin, cos]])
        slip = y[3:5] + y[5] * np.column_stack((-arms[:, 1], arms[:, 0]))
        push = -friction * m * G / 3.0 * slip / np.linalg.norm(slip, axis=1, keepdims=True)
        moment = arms[:, 0] @ push[:, 1] - arms[:, 1] @ push[:, 0]
        return np.concatenate((y[3:], push.sum(axis=0) / m, [moment / C]))

    duration = 0.9 * max(velocity, 0.3 * rate / 2.0) / (friction * G)
    start = np.array([0.0, 0.0, 0.0, velocity, 0.0, rate])
    times = np.linspace(0.0, duration, 51)
    exact = solve_ivp(rates, (0.0, duration), start, t_eval=times, rtol=1e-10, atol=1e-12).y
    moving = np.hypot(exact[3], exact[4]) > 0.02
    thrown = sp.Piece(solid, velocity=(velocity, 0.0, 0.0), rotation_rate=(0.0, 0.0, rate))
    room = sp.Room(sp.Floor(friction, friction))
    run = sp.simulate(thrown, room, still(duration, duration / 50), step=2e-4)
    np.testing.assert_allclose(run.velocity[0, moving, :2], exact[3:5, moving].T, atol=2e-3 * velocity)
    np.testing.assert_allclose(run.rotation_rate[0, moving, 2], exact[5, moving], atol=2e-3 * rate)
    np.testing.assert_allclose(run.place[0, moving, :2], exact[:2, moving].T, atol=1e-3)


def coupled(ratio: float, radii: str) -> tuple[float, float]:
    """Friction force over μ m g, and moment over μ m g R, at ε = v/(R ω): means over the contact."""

    def means(s: float) -> tuple[float, float]:
        def size(angle: float) -> float:
            return math.sqrt(max(ratio**2 - 2.0 * ratio * s * math.sin(angle) + s**2, 1e-300))

        low, high = -math.pi / 2, math.pi / 2
        force = quad(lambda a: (ratio - s * math.sin(a)) / size(a), low, high, limit=200)[0]
        moment = quad(lambda a: s * (s - ratio * math.sin(a)) / size(a), low, high, limit=200)[0]
        return force / math.pi, moment / math.pi

    if radii == "ring":
        return means(1.0)
    force = quad(lambda s: 2.0 * s * means(s)[0], 0.0, 1.0, points=[min(ratio, 1.0)])[0]
    return force, quad(lambda s: 2.0 * s * means(s)[1], 0.0, 1.0, points=[min(ratio, 1.0)])[0]


def ratio_at_the_stop(share: float, radii: str) -> float:
    """ε that stays as it is: v̇/v = ω̇/ω, so that share · force = ε · moment."""

    def drift(ratio: float) -> float:
        force, moment = coupled(ratio, radii)
        return share * force - ratio * moment

    return float(brentq(drift, 0.2, 5.0, xtol=1e-6))


def test_the_stop_of_a_disc_as_published() -> None:
    """ε → 0.653 for a uniform disc: Z. Farkas, G. Bartels, T. Unger, D. E. Wolf (2003),
    *Frictional coupling between sliding and spinning motion*, Phys. Rev. Lett. 90, 248302, whose abstract was
    read: a disc always stops to slide and to spin at the same moment.

    That is the reference below. In the engine a flat disc rubs at eight points at 2/3 R, and ends at 2/3.
    """
    assert ratio_at_the_stop(0.5, "disc") == pytest.approx(0.653, abs=1e-3)
    thrown = sp.Piece(
        disc(0, 0.5 * (0.35 / 0.3) ** 2), velocity=(0.6, 0.0, 0.0), rotation_rate=(0.0, 0.0, 5.0)
    )
    assert ratio_before_the_stop(thrown, 0.35) == pytest.approx(2.0 / 3.0, rel=1e-3)


def ratio_before_the_stop(thrown: sp.Piece, radius: float) -> float:
    """ε of a run shortly before all of it stops, at once."""
    run = sp.simulate(thrown, sp.Room(sp.Floor(0.2, 0.2)), still(2.0, 1e-3), step=1e-4)
    speed = np.linalg.norm(run.velocity[0, :, :2], axis=1)
    spin = np.abs(run.rotation_rate[0, :, 2])
    assert speed[-1] == spin[-1] == 0.0
    assert np.flatnonzero(speed)[-1] == np.flatnonzero(spin)[-1]
    return float(speed[speed > 0.0][-4] / (radius * spin[spin > 0.0][-4]))


@pytest.mark.parametrize(("velocity", "rate"), [(1.2, 2.0), (0.6, 5.0), (0.4, 5.0)])
def test_the_stop_of_a_hoop(velocity: float, rate: float) -> None:
    """Sliding and spin end together, at v = R ω, whatever the start: the condition above, of a ring.

    Of a ring whose moment about the vertical is less than m R² the ratio is larger, and of 1/2 m R² or less
    the spin fades before the slide. There single feet stick, and how the feet share the weight counts,
    which the law leaves open.
    """
    assert ratio_at_the_stop(1.0, "ring") == pytest.approx(1.0, abs=1e-3)
    thrown = sp.Piece(disc(24, 1.0), velocity=(velocity, 0.0, 0.0), rotation_rate=(0.0, 0.0, rate))
    assert ratio_before_the_stop(thrown, 0.3) == pytest.approx(1.0, rel=5e-3)


@pytest.mark.parametrize("share", [0.5, 1.0])
def test_four_points_stand_for_a_rim(share: float) -> None:
    """A cylinder's rim that lies flat touches in four points: it stops within 3 % of the way on 24 feet."""
    inertia = 8.0 * 0.3**2 * np.diag([0.6 * share, 0.6 * share, share])
    own = {"inertia": inertia, "centre_of_gravity": (0.0, 0.0, 0.0)}
    ways = []
    for solid in (disc(24, share), sp.Body.cylinder(0.6, 0.05, 8.0, base="edges", **own)):
        thrown = sp.Piece(solid, velocity=(1.0, 0.0, 0.0), rotation_rate=(0.0, 0.0, 3.0))
        run = sp.simulate(thrown, sp.Room(sp.Floor(0.2, 0.2)), still(1.5), step=2e-4)
        assert np.abs(run.velocity[0, -1]).max() == 0.0
        ways.append(run[0].slide_in_plan[-1, 0])
    assert ways[1] == pytest.approx(ways[0], rel=0.03)


def test_a_push_in_one_direction_and_a_slip_in_another() -> None:
    """What slips has no friction left: a gentle steady push across moves a sliding block sideways.

    v̇ = (p − μ g v/|v|) with p across: while v is large, v_y follows ẏ = p t − μ g ∫ v_y/|v|.
    """
    friction, push, start = 0.3, 0.5, 2.0

    def rates(_: float, v: np.ndarray) -> np.ndarray:
        return np.array([0.0, -push]) - friction * G * v / np.linalg.norm(v)

    exact = solve_ivp(rates, (0.0, 0.5), [start, 0.0], rtol=1e-10, atol=1e-12).y[:, -1]
    thrown = sp.Piece(sp.Body.box(0.8, 0.8, 0.1, 20.0), velocity=(start, 0.0, 0.0))
    run = sp.simulate(thrown, sp.Room(sp.Floor(friction, friction)), steady(0.0, push, 0.5))
    np.testing.assert_allclose(run.velocity[0, -1, :2], exact, rtol=2e-3)


@pytest.mark.parametrize("speed", [1e-3, 0.01, 0.05])
@pytest.mark.parametrize("step", [1e-3, 1e-4])
def test_a_base_that_turns_back_is_held_by_its_static_friction(speed: float, step: float) -> None:
    floor, share = sp.Floor(0.05, 0.04), 0.9  # of what static friction holds beyond kinetic
    a = (floor.kinetic_friction + share * 0.01) * G
    motion = sp.Motion(dt=0.002, x=np.full(201, a), name="steady")
    start = sp.Piece(sp.Body.box(1.0, 1.0, 0.3, 10.0), velocity=(speed, 0.0, 0.0))
    run = sp.simulate(start, sp.Room(floor), motion, step=step)
    way = speed**2 / (2.0 * (a + floor.kinetic_friction * G))
    assert run[0].slide_in_plan[-1, 0] == pytest.approx(way, abs=1e-7)
    assert run.velocity[0, -1].tolist() == [0.0, 0.0, 0.0]


def slid_in_closed_form(acceleration: np.ndarray, dt: float, static: float, kinetic: float) -> np.ndarray:
    """Return the slide of a block on a floor whose acceleration is linear between samples, event by event."""
    ways, x, v = [0.0], 0.0, 0.0
    for first, last in pairwise(acceleration):
        jerk, t = (last - first) / dt, 0.0
        while t < dt:
            a = first + jerk * t
            if v == 0.0 and abs(a) <= static * G:
                crossed = (math.copysign(static * G, jerk) - first) / jerk if jerk else math.inf
                if not t < crossed < dt:
                    break
                t, a = crossed, math.copysign(static * G, jerk)
            way = math.copysign(1.0, v) if v else -math.copysign(1.0, a)
            loses = a + kinetic * G * way
            stops = [root.real for root in np.roots([-0.5 * jerk, -loses, v]) if abs(root.imag) < 1e-12]
            left = min([s for s in stops if s > 1e-9 and v], default=math.inf)
            h = min(left, dt - t)
            x += v * h - loses * h**2 / 2.0 - jerk * h**3 / 6.0
            v, t = (0.0 if left <= dt - t else v - loses * h - 0.5 * jerk * h**2), t + h
        ways.append(x)
    return np.array(ways)


@pytest.mark.parametrize(("step", "within"), [(1e-2, 2e-3), (1e-3, 5e-4)])
@pytest.mark.parametrize("seed", range(6))
def test_a_block_sticks_and_slips_as_in_closed_form(seed: int, step: float, within: float) -> None:
    rng, t = np.random.default_rng(seed), np.arange(0.0, 5.0, 0.01)
    waves = [(rng.uniform(0.5, 2.0), rng.uniform(2.0, 30.0), rng.uniform(0.0, 6.0)) for _ in range(4)]
    a = sum(size * np.sin(rate * t + phase) for size, rate, phase in waves) * np.minimum(1.0, 2.0 * t)
    exact = slid_in_closed_form(a, 0.01, 0.3, 0.2)
    run = sp.simulate(
        sp.Body.box(1.0, 1.0, 0.3, 10.0),
        sp.Room(sp.Floor(0.3, 0.2)),
        sp.Motion(dt=0.01, x=a, name="waves"),
        step=step,
    )
    peak = np.abs(exact).max()
    assert peak > 1e-3
    np.testing.assert_allclose(run[0].slide_in_plan[:, 0], exact, rtol=0.0, atol=within * peak)


@pytest.mark.parametrize("step", [1e-3, 5e-4, 1e-4])
@pytest.mark.parametrize("below", [(), (sp.Piece(sp.Body.box(1.2, 1.2, 0.2, 2e4)),)])
def test_static_friction_holds_through_a_landing(below: tuple[sp.Piece, ...], step: float) -> None:
    """A box let go on its edge needs H/N = .369 before it lands, .395 as it does, and .386 after: .42 holds.

    So its base is where it was, on the floor and on a slab, with the rebound of the planar engine, and each
    landing counts as a hit.
    """
    width, height, tilt, top = 0.46765, 0.8206, 0.206714, 0.2 * len(below)
    box = sp.Piece(
        sp.Body.box(width, 0.40922, height, 20.0),
        (0.0, 0.0, top + 0.5 * width * math.sin(tilt)),
        tilt=(0.0, tilt, 0.0),
    )
    room = sp.Room(sp.Floor(0.42, 0.3))
    run = sp.simulate(sp.Scene((*below, box), room, friction=(0.42, 0.3)), still(1.5), step=step)
    plane = sp.simulate(
        sp.Body(width, height, 20.0), room, still(1.5), initial=sp.State(tilt=tilt), dimensions=2
    )
    assert run[-1].residual_slide < 1e-4
    assert run[-1].tilt[30:60].max() == pytest.approx(np.abs(plane.tilt[30:60]).max(), rel=1e-3)
    assert run[-1].floor_impacts + run[-1].wall_impacts + run[-1].body_impacts > 5


@pytest.mark.parametrize("step", [1e-3, 1e-4])
def test_what_comes_to_a_stop_may_tip_instead_of_sliding_back(step: float) -> None:
    """With μ_k < b/h < μ_s: at the stop it may stick and tip with H/N = .4417 of .4912, as in the plane.

    Standing flat it would need a/g = .56, so that it was taken to slide back with its kinetic friction.
    """
    body, room = sp.Body(0.303, 0.75, 50.0, length=0.5), sp.Room(sp.Floor(0.4912, 0.295))
    push, slides = steady(5.5, 0.0, 0.3), sp.State(slide_rate=0.5)
    plane = sp.simulate(body, room, push, initial=slides, step=step, dimensions=2)
    space = sp.simulate(body, room, push, initial=slides, step=step, dimensions=3)
    assert space.tilt[20] == pytest.approx(-plane.tilt[20], rel=1e-4)
    assert space.tilt[20] == pytest.approx(0.02697, rel=1e-3)


def test_what_leans_on_short_feet_tips_over_its_feet() -> None:
    """Its base juts out beyond the feet, and its lean lifts it there: it rocks as in the plane."""
    body = sp.Body(0.3, 1.8, 100.0, length=0.8, base_insets=(0.018, 0.01), base_heights=(0.0, -0.0006))
    room, start = sp.Room(sp.Floor(2.0, 2.0)), sp.State(tilt=0.05)
    plane = sp.simulate(body, room, still(2.0), initial=start, dimensions=2)
    space = sp.simulate(body, room, still(2.0), initial=start, dimensions=3)
    assert np.abs(space.tilt - np.abs(plane.tilt))[:100].max() < 1e-3
