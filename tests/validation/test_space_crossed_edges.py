"""Edges of two boxes that cross: they touch in one point, where they cross, and nowhere else."""

import math
from typing import Any

import numpy as np
import pytest
from in_space import G, about, energy, lifted, still, turned
from scipy.spatial.transform import Rotation
from test_space_impacts import compliance

import stayput as sp
from stayput.compiling import entry
from stayput.mechanics.space.columns import POSE, SOLID
from stayput.mechanics.space.pairs import turning_opens  # pyright: ignore[reportUnknownVariableType]


@entry
def accelerations(bodies: Any, poses: Any, n: Any, u: Any, axes: Any, edges: Any, corners: Any, found: Any):
    for i in range(3):
        across, slip = (n[0], n[1], n[2]), (u[0], u[1], u[2])
        found[i] = turning_opens(bodies[0], poses[0], poses[1], across, slip, axes[i], edges, corners)


@pytest.mark.parametrize("seed", range(5))
def test_gaps_of_what_turns_beside_their_second_differences(seed: int) -> None:
    """Between two lines that turn and slide, and between each and a plane that the other carries."""
    va, vb, *spins, e, f = np.random.default_rng(seed).normal(size=(6, 3))
    n = np.cross(e, f) / np.linalg.norm(np.cross(e, f))
    u = va - vb - n * (n @ (va - vb))  # they touch at the origin, and stay so

    def gaps(t: float) -> np.ndarray:
        a, b = (Rotation.from_rotvec(w * t).as_matrix() for w in spins)
        across = np.cross(a @ e, b @ f)
        return np.array([across / np.linalg.norm(across), a @ n, b @ n]) @ u * t

    bodies, poses, found = np.zeros(1, SOLID), np.zeros(2, POSE), np.zeros(3)
    bodies[0]["faces"] = 1
    for pose, spin in zip(poses, spins, strict=True):
        pose["wx"], pose["wy"], pose["wz"] = spin
    corners, edges = np.array([[0.0, 0.0, 0.0], e, f]), np.array([[0, 1], [0, 2]])
    accelerations(bodies, poses, n, u, np.array([[0, 1], [0, -1], [1, -1]]), edges, corners, found)
    h = 1e-4
    np.testing.assert_allclose(found, (gaps(h) - 2.0 * gaps(0.0) + gaps(-h)) / h**2, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize("duration", [2e-6, 4e-5, 2e-4])
def test_an_edge_meets_an_edge(duration: float) -> None:
    """p = −u_n/K_nn along the normal across both edges; after that both are free, and stay so."""
    wedge = turned(sp.Body.box(0.3, 0.9, 0.3, 20.0), about((0.0, 1.0, 0.0), math.pi / 4))
    other = turned(sp.Body.box(0.3, 0.9, 0.3, 30.0), about((0.0, 1.0, 0.0), math.pi / 4))
    other = turned(other, about((0.0, 0.0, 1.0), 1.2))
    offset, speed = 0.2, 1.5
    x, y, _ = -wedge.solid.centre_of_gravity
    below = sp.Piece(other, (-other.solid.centre_of_gravity[0], -other.solid.centre_of_gravity[1], 50.0))
    top = 50.0 + other.solid.vertices[:, 2].max()
    above = sp.Piece(wedge, (x, y + offset, lifted(wedge, top + 1e-7)[2]), velocity=(0.0, 0.0, -speed))
    motion = still(duration, duration / 2.0)
    run = sp.simulate(sp.Scene((above, below), friction=(0.0, 0.0)), motion, step=1e-6)
    # the wedge's edge goes along y through x = 0; the other's through x = y = 0: they cross there
    half = 0.3 / math.sqrt(2.0)
    a, b = np.array([0.0, -offset, -half]), np.array([0.0, 0.0, half])
    p = speed / (compliance(wedge, a) + compliance(other, b))[2, 2]
    fallen = duration * G
    assert run.velocity[0, -1, 2] == pytest.approx(-speed + p / 20.0 - fallen, abs=2e-3)
    assert run.velocity[1, -1, 2] == pytest.approx(-p / 30.0 - fallen, abs=2e-3)
    expected = (-offset * p / wedge.solid.inertia[0, 0], 0.0, 0.0)
    np.testing.assert_allclose(run.rotation_rate[0, -1], expected, atol=5e-3)
    assert np.abs(run.rotation_rate[1, -1]).max() < 1e-3


def test_a_box_that_falls_on_a_box_makes_no_energy() -> None:
    """Thrown on a box that stands, without friction and restitution: an edge comes to cross an edge."""
    base = sp.Piece(sp.Body.box(0.933, 1.247, 0.371, 29.0))
    thrown = sp.Piece(
        sp.Body.box(1.205, 0.381, 0.122, 186.0),
        (0.0, 0.09, 0.372),
        heading=1.0,
        velocity=(-1.31, 0.99, 1.42),
        rotation_rate=(-4.37, -0.36, -4.19),
    )
    room = sp.Room(sp.Floor(0.0, 0.0))
    run = sp.simulate(sp.Scene((base, thrown), room, friction=(0.0, 0.0)), still(0.1, 5e-4), step=5e-4)
    total = energy(run, 0) + energy(run, 1)
    assert np.diff(total).max() < 1e-5 * total[0]
