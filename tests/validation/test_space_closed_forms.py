"""The engine in space beside closed forms: flight, sliding, barriers, impacts, stacks."""

import math

import numpy as np
import pytest

import stayput as sp

G = 9.80665
BOX = sp.Solid.box(0.4, 0.6, 1.5, 80.0)
STICKING = sp.Room(sp.Floor(5.0, 5.0))


def still(duration: float, dt: float = 0.01) -> sp.Motion:
    count = round(duration / dt) + 1
    return sp.Motion(dt=dt, x=np.zeros(count), name="still")


def steady(x: float, y: float, duration: float, dt: float = 0.01) -> sp.Motion:
    count = round(duration / dt) + 1
    return sp.Motion(dt=dt, x=np.full(count, x), y=np.full(count, y), name="steady")


def energy(run: sp.SpaceRun, body: int = 0) -> np.ndarray:
    """Kinetic and potential energy over time [J]."""
    solid = run.standing[body].solid
    inertia = np.einsum("sij,jk,slk->sil", run.turn[body], solid.inertia, run.turn[body])
    spin = run.rotation_rate[body]
    kinetic = 0.5 * solid.mass * (run.velocity[body] ** 2).sum(axis=1)
    turning = 0.5 * np.einsum("si,sij,sj->s", spin, inertia, spin)
    return kinetic + turning + solid.mass * G * run.place[body, :, 2]


def test_flight_of_a_body_of_three_moments_keeps_energy_and_momentum() -> None:
    """Euler's free top, about its unstable axis: it tumbles over and over (Dzhanibekov)."""
    thrown = sp.Standing(BOX, (0.0, 0.0, 90.0), velocity=(1.0, -2.0, 3.0), rotation_rate=(0.05, 5.0, 0.05))
    run = sp.simulate(thrown, sp.Room(), still(4.0))
    assert np.ptp(energy(run)) < 1e-9 * energy(run)[0]
    inertia = np.einsum("sij,jk,slk->sil", run.turn[0], BOX.inertia, run.turn[0])
    momentum = np.einsum("sij,sj->si", inertia, run.rotation_rate[0])
    assert np.abs(momentum - momentum[0]).max() < 1e-9 * np.abs(momentum[0]).max()
    assert run.turn[0, :, 1, 1].min() < -0.9  # it did turn over
    t = run.time
    np.testing.assert_allclose(run.place[0, :, 2], 90.75 + 3.0 * t - 0.5 * G * t * t, atol=1e-9)
    np.testing.assert_allclose(run.place[0, :, 0], t, atol=1e-12)


def test_a_body_on_a_still_floor_does_not_move_at_all() -> None:
    for solid in (BOX, sp.Solid.cylinder(0.4, 1.2, 30.0), sp.Solid.cone(0.4, 0.2, 1.0, 30.0)):
        run = sp.simulate(sp.Standing(solid, heading=0.3), sp.Room(), still(1.0))
        assert np.array_equal(run.place, np.repeat(run.place[:, :1], len(run.time), axis=1))
        assert np.array_equal(run.attitude, np.repeat(run.attitude[:, :1], len(run.time), axis=1))


@pytest.mark.parametrize("push", [(3.5, 0.0), (2.4, 2.4), (0.0, -3.8)])
def test_a_body_that_is_pushed_too_gently_does_not_creep(push: tuple[float, float]) -> None:
    squat = sp.Solid.box(0.8, 0.8, 0.3, 50.0)
    run = sp.simulate(squat, sp.Room(), steady(*push, 2.0))
    assert np.abs(run.slide).max() == 0.0


@pytest.mark.parametrize("direction", [0.0, 0.4, math.pi / 2])
def test_a_thrown_block_slides_to_where_friction_has_its_energy(direction: float) -> None:
    """Coulomb: v²/(2 μ g), whatever the direction and the heading."""
    squat = sp.Solid.box(0.8, 0.6, 0.2, 50.0)
    way = np.array([math.cos(direction), math.sin(direction)])
    thrown = sp.Standing(squat, heading=0.7, velocity=(*(2.0 * way), 0.0))
    run = sp.simulate(thrown, sp.Room(sp.Floor(0.4, 0.3)), still(2.0))
    np.testing.assert_allclose(run.slide[0, -1], 2.0**2 / (2.0 * 0.3 * G) * way, atol=2e-3)
    assert float(np.abs(run.rotation_rate).max()) < 1e-6


def test_a_block_under_two_components_slides_along_their_sum() -> None:
    squat = sp.Solid.box(0.8, 0.6, 0.2, 50.0)
    run = sp.simulate(squat, sp.Room(sp.Floor(0.4, 0.3)), steady(4.0, 3.0, 1.0))
    relative = 5.0 - 0.3 * G
    np.testing.assert_allclose(run.slide[0, -1], -0.5 * relative * np.array([0.8, 0.6]), rtol=2e-3)


@pytest.mark.parametrize(
    ("over", "factor", "falls"),
    [
        ("depth", 0.99, False),
        ("depth", 1.01, True),
        ("length", 0.99, False),
        ("length", 1.01, True),
        ("corner", 0.99, False),
    ],
)
def test_the_energy_barrier_of_edges_and_of_a_corner(over: str, factor: float, falls: bool) -> None:
    """½ J_O ω² = m g (R − z): G has to be lifted over the edge or the corner that it turns about.

    Over a corner, about which a body also turns in other ways, the energy is needed but need not do.
    """
    arm = {"depth": (0.2, 0.0, 0.0), "length": (0.0, 0.3, 0.0), "corner": (0.2, 0.3, 0.0)}[over]
    lever = np.array([0.0, 0.0, 0.75]) - np.array(arm)
    along = np.array(arm) / np.linalg.norm(arm)
    axis = np.cross([0.0, 0.0, 1.0], along)
    about = axis @ BOX.inertia @ axis + BOX.mass * lever @ lever
    rate = factor * math.sqrt(2.0 * BOX.mass * G * (np.linalg.norm(lever) - 0.75) / about)
    spin = rate * axis
    kicked = sp.Standing(BOX, velocity=tuple(np.cross(spin, lever)), rotation_rate=tuple(spin))
    run = sp.simulate(kicked, STICKING, still(4.0), step=1e-4)
    assert run.overturned[0] == falls


def test_housner_s_landing_on_the_other_edge() -> None:
    """Rocking about an edge, a block lands with 1 − (3/2) sin² α of its rate (Housner 1963)."""
    lever = np.array([-0.2, 0.0, 0.75])
    kicked = sp.Standing(BOX, velocity=tuple(np.cross((0.0, 0.5, 0.0), lever)), rotation_rate=(0.0, 0.5, 0.0))
    run = sp.simulate(kicked, STICKING, still(1.0, 0.001), step=1e-4)
    rate = run.rotation_rate[0, :, 1]
    landing = int(np.flatnonzero((rate[1:] < 0.0) & (np.diff(rate) > 0.01))[0])
    alpha = math.atan2(0.2, 0.75)
    assert rate[landing + 1] / rate[landing] == pytest.approx(1.0 - 1.5 * math.sin(alpha) ** 2, abs=0.01)


def test_a_tower_of_ten_blocks_stays_a_tower() -> None:
    block = sp.Solid.box(0.5, 0.5, 0.2, 10.0)
    tower = [sp.Standing(block, at=(0.0, 0.0, 0.2 * n)) for n in range(10)]
    run = sp.simulate(sp.Assembly(tower), sp.Room(), still(1.0))
    assert np.array_equal(run.place, np.repeat(run.place[:, :1], len(run.time), axis=1))


def test_the_upper_of_two_blocks_slides_on_the_lower() -> None:
    """The lower sticks at 4 m/s² with friction 0.6; the upper slides by 0.2: (4 − 0.2 g) t²/2."""
    block = sp.Solid.box(2.0, 2.0, 0.2, 40.0)
    small = sp.Solid.box(0.3, 0.3, 0.1, 5.0)
    stack = [sp.Standing(block), sp.Standing(small, at=(0.0, 0.0, 0.2))]
    room, motion = sp.Room(sp.Floor(0.6, 0.6)), steady(4.0, 0.0, 0.8)
    run = sp.simulate(sp.Assembly(stack, (0.2, 0.2)), room, motion)
    assert np.abs(run.slide[0]).max() < 1e-12
    assert run.slide[1, -1, 0] == pytest.approx(-0.5 * (4.0 - 0.2 * G) * 0.8**2, rel=2e-3)


def test_the_lower_of_two_blocks_slides_under_the_upper() -> None:
    """A floor of friction 0.1 under both, 0.5 between them: they slide as one."""
    block = sp.Solid.box(0.8, 0.8, 0.2, 40.0)
    stack = [sp.Standing(block), sp.Standing(block, at=(0.0, 0.0, 0.2))]
    run = sp.simulate(sp.Assembly(stack, (0.5, 0.5)), sp.Room(sp.Floor(0.1, 0.1)), steady(2.0, 0.0, 1.0))
    expected = -0.5 * (2.0 - 0.1 * G)
    np.testing.assert_allclose(run.slide[:, -1, 0], expected, rtol=2e-3)


@pytest.mark.parametrize("seed", range(6))
def test_no_impact_makes_energy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    prism = sp.Solid.prism([(0, 0), (1, 0), (0.2, 0.7)], 0.5, 30.0)
    solid = (BOX, sp.Solid.cylinder(0.5, 0.9, 40.0), prism)[seed % 3]
    velocity, rate = tuple(rng.normal(0, 1, 3)), tuple(rng.normal(0, 4, 3))
    thrown = sp.Standing(solid, at=(0.0, 0.0, 1.0), velocity=velocity, rotation_rate=rate)
    room = sp.Room(sp.Floor(0.5, 0.4, normal_restitution=rng.uniform(0.0, 0.7)))
    run = sp.simulate(thrown, room, still(4.0), step=2e-4)
    energies = energy(run)
    assert np.diff(energies).max() < 2e-3 * energies[0]
    assert energies[-1] < energies[0]
    lowest = run.place[0, :, 2, np.newaxis] + run.turn[0][:, 2] @ (solid.vertices - solid.centre_of_gravity).T
    assert lowest.min() > -1e-4


@pytest.mark.parametrize("direction", [0.0, 0.7, 2.5])
@pytest.mark.parametrize("factor", [0.999, 1.02])
def test_a_body_rocks_where_the_push_leaves_its_base(direction: float, factor: float) -> None:
    """It tips where h a > g d with d from below G to the edge of the base in the direction of the push."""
    push = np.array([math.cos(direction), math.sin(direction)])
    edge = min(0.2 / max(abs(push[0]), 1e-9), 0.3 / max(abs(push[1]), 1e-9))
    least = G * edge / 0.75
    run = sp.simulate(BOX, STICKING, steady(*(factor * least * push), 1.0))
    assert (run.tilt.max() > 1e-6) == (factor > 1.0)
    assert (run.steps == 0) == (factor < 1.0)


@pytest.mark.parametrize("factor", [0.999, 1.02])
def test_a_cylinder_rocks_where_the_push_leaves_its_circle(factor: float) -> None:
    drum = sp.Solid.cylinder(0.4, 1.2, 60.0)
    least = factor * G * 0.2 / 0.6
    run = sp.simulate(drum, STICKING, steady(0.8 * least, 0.6 * least, 1.0))
    assert (run.tilt.max() > 1e-6) == (factor > 1.0)
    assert (run.steps == 0) == (factor < 1.0)
