"""Impacts in space: an edge and a corner on a floor, and boxes on each other, beside momentum.

A plastic impact at a point that does not slip leaves the body turning about it: what it keeps is the angular
momentum about that point. The impulse p of a point at the lever c from G changes its velocity by K p with
K = 1/m − [c]× J⁻¹ [c]×, summed over both bodies where two meet.
"""

import numpy as np
import pytest
from in_space import STICKING, G, about, energy, lifted, still, turned

import stayput as sp

BOX = sp.Body.box(0.4, 0.6, 1.0, 60.0)
BRICK = sp.Body.box(0.5, 0.7, 0.3, 40.0)


def skew(c: np.ndarray) -> np.ndarray:
    return np.array([[0.0, -c[2], c[1]], [c[2], 0.0, -c[0]], [-c[1], c[0], 0.0]])


def compliance(convex: sp.Body, c: np.ndarray) -> np.ndarray:
    """K of a body's point at the lever c from G, shape (3, 3) [1/kg]."""
    return np.eye(3) / convex.mass - skew(c) @ np.linalg.inv(convex.solid.inertia) @ skew(c)


def landing(
    convex: sp.Body, velocity: np.ndarray, spin: np.ndarray, room: sp.Room
) -> tuple[np.ndarray, np.ndarray]:
    """Velocity and rotation rate right after the lowest point of a body has met the floor.

    It begins 0.1 µm above it, and is looked at after 40 µs, of which gravity's share is taken off.
    """
    thrown = sp.Piece(convex, lifted(convex, 1e-7), velocity=tuple(velocity), rotation_rate=tuple(spin))
    run = sp.simulate(thrown, room, still(4e-5, 2e-5), step=1e-6)
    return run.velocity[0, -1], run.rotation_rate[0, -1]


@pytest.mark.parametrize("seed", range(5))
def test_a_corner_lands_and_sticks(seed: int) -> None:
    """Angular momentum about the corner is kept: J_C ω⁺ = J ω⁻ − m c × v⁻ with J_C = J + m (c² − c cᵀ)."""
    rng = np.random.default_rng(seed)
    convex = turned(BOX, about(tuple(rng.normal(size=3)), rng.uniform(0.4, 1.2)))
    arms = convex.solid.vertices - convex.solid.centre_of_gravity
    c = arms[np.argmin(arms[:, 2])]
    velocity, spin = np.array([*rng.normal(0.0, 0.4, 2), -1.5]), rng.normal(0.0, 1.0, 3)
    if (velocity + np.cross(spin, c))[2] > -0.5:
        velocity[2] -= 1.5
    after, rotation = landing(convex, velocity, spin, STICKING)
    about_corner = convex.solid.inertia + convex.mass * (c @ c * np.eye(3) - np.outer(c, c))
    expected = np.linalg.solve(
        about_corner, convex.solid.inertia @ spin - convex.mass * np.cross(c, velocity)
    )
    np.testing.assert_allclose(rotation, expected, atol=2e-3)
    np.testing.assert_allclose(after, -np.cross(expected, c), atol=2e-3)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
@pytest.mark.parametrize("seed", range(3))
def test_a_corner_lands_without_friction(seed: int, restitution: float) -> None:
    """p = −(1 + e) u_n/(n·K n) along the normal: what slides keeps its horizontal momentum."""
    rng = np.random.default_rng(seed)
    convex = turned(BOX, about(tuple(rng.normal(size=3)), rng.uniform(0.4, 1.2)))
    arms = convex.solid.vertices - convex.solid.centre_of_gravity
    c = arms[np.argmin(arms[:, 2])]
    velocity, spin = np.array([*rng.normal(0.0, 0.4, 2), -3.0]), rng.normal(0.0, 1.0, 3)
    room = sp.Room(sp.Floor(0.0, 0.0, normal_restitution=restitution))
    after, rotation = landing(convex, velocity, spin, room)
    closing = (velocity + np.cross(spin, c))[2]
    p = np.array([0.0, 0.0, -(1.0 + restitution) * closing / compliance(convex, c)[2, 2]])
    np.testing.assert_allclose(after, velocity + p / convex.mass, atol=2e-3)
    np.testing.assert_allclose(
        rotation, spin + np.linalg.solve(convex.solid.inertia, np.cross(c, p)), atol=5e-3
    )


@pytest.mark.parametrize("friction", [0.05, 0.2])
def test_a_corner_lands_and_slips(friction: float) -> None:
    """Thrown fast along x it slips all through the impact: p_t = −μ p_n along the slip after it (Moreau).

    u⁺ = u⁻ + K p has no normal part, and its tangential part points against p_t.
    """
    convex = turned(BOX, about((0.3, 1.0, 0.2), 0.8))
    arms = convex.solid.vertices - convex.solid.centre_of_gravity
    c = arms[np.argmin(arms[:, 2])]
    velocity, spin = np.array([6.0, 1.0, -2.0]), np.array([0.2, -0.3, 0.5])
    after, rotation = landing(convex, velocity, spin, sp.Room(sp.Floor(friction, friction)))
    p = convex.mass * (after - velocity + [0.0, 0.0, 4e-5 * G])
    slip = (after + np.cross(rotation, c))[:2]
    K = compliance(convex, c)
    np.testing.assert_allclose((velocity + np.cross(spin, c) + K @ p)[2], 0.0, atol=2e-3)
    np.testing.assert_allclose(p[:2] / p[2], -friction * slip / np.linalg.norm(slip), rtol=0.02, atol=1e-3)


@pytest.mark.parametrize("lean", [0.2, 0.6, 1.2])
def test_an_edge_lands(lean: float) -> None:
    """Two corners at once, and no slip: ω⁺ = e·(J ω⁻ − m c × v⁻)/(e·J_C e) about the edge, and no other."""
    convex = turned(BOX, about((0.0, 1.0, 0.0), lean))
    arms = convex.solid.vertices - convex.solid.centre_of_gravity
    c = arms[np.argsort(arms[:, 2])[:2]].mean(axis=0)
    velocity, spin = np.array([0.3, 0.2, -1.0]), np.array([0.0, 0.4, 0.0])
    after, rotation = landing(convex, velocity, spin, STICKING)
    kept = convex.solid.inertia @ spin - convex.mass * np.cross(c, velocity)
    rate = kept[1] / (convex.solid.inertia[1, 1] + convex.mass * c @ c)
    np.testing.assert_allclose(rotation, (0.0, rate, 0.0), atol=2e-3)
    np.testing.assert_allclose(after, -np.cross(rotation, c), atol=2e-3)


def two(upper: sp.Body, at: tuple[float, float], speed: float, friction: float) -> sp.Run:
    """Let a body meet a brick from above, both falling freely, 50 m above the floor."""
    x, y, z = lifted(upper, 50.3 + 1e-7)
    above = sp.Piece(upper, (x + at[0], y + at[1], z), velocity=(0.0, 0.0, -speed))
    below = sp.Piece(BRICK, (0.0, 0.0, 50.0))
    coefficients = friction, friction
    return sp.simulate(sp.Scene((above, below), friction=coefficients), still(4e-5, 2e-5), step=1e-6)


def test_a_central_impact_of_boxes() -> None:
    """Face on face: both go on with (m₁ v₁ + m₂ v₂)/(m₁ + m₂), and lose ½ m₁ m₂/(m₁ + m₂) (v₁ − v₂)²."""
    upper, speed = sp.Body.box(0.3, 0.3, 0.4, 15.0), 2.0
    run = two(upper, (0.0, 0.0), speed, 0.5)
    fallen = -4e-5 * G
    common = -speed * 15.0 / 55.0
    np.testing.assert_allclose(run.velocity[:, -1], [[0.0, 0.0, common + fallen]] * 2, atol=1e-6)
    assert np.abs(run.rotation_rate).max() < 1e-6
    lost = sum(np.ptp(energy(run, body)[[0, -1]]) * (1 if body == 0 else -1) for body in (0, 1))
    assert lost == pytest.approx(0.5 * 15.0 * 40.0 / 55.0 * speed**2, rel=2e-4)


@pytest.mark.parametrize("friction", [0.0, 5.0])
@pytest.mark.parametrize("at", [(0.1, 0.0), (-0.15, 0.2)])
def test_an_eccentric_impact_of_a_corner(at: tuple[float, float], friction: float) -> None:
    """A corner on a face, off both centres: p = −K⁻¹ u where it sticks, −u_n/K_nn without friction."""
    convex = turned(sp.Body.box(0.3, 0.4, 0.5, 15.0), about((1.0, 0.4, 0.0), 0.7))
    low = convex.solid.vertices[np.argmin(convex.solid.vertices[:, 2])]
    speed = 2.0
    run = two(convex, (at[0] - low[0], at[1] - low[1]), speed, friction)
    a = low - convex.solid.centre_of_gravity
    b = np.array([*at, 0.15])
    K = compliance(convex, a) + compliance(BRICK, b)
    u = np.array([0.0, 0.0, -speed])
    p = -np.linalg.solve(K, u) if friction else np.array([0.0, 0.0, speed / K[2, 2]])
    fallen = np.array([0.0, 0.0, -4e-5 * G])
    np.testing.assert_allclose(run.velocity[0, -1], u + p / 15.0 + fallen, atol=2e-3)
    np.testing.assert_allclose(run.velocity[1, -1], -p / 40.0 + fallen, atol=2e-3)
    np.testing.assert_allclose(
        run.rotation_rate[0, -1], np.linalg.solve(convex.solid.inertia, np.cross(a, p)), atol=5e-3
    )
    np.testing.assert_allclose(
        run.rotation_rate[1, -1], -np.linalg.solve(BRICK.solid.inertia, np.cross(b, p)), atol=5e-3
    )
