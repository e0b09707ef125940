"""Impacts on a wall: impulse and momentum of a rigid body, Newton's restitution, Coulomb's friction.

The impulses are found here by trying every combination of open, sticking and slipping contacts with a
plain linear solver (E. J. Routh, 1905, Dynamics of a System of Rigid Bodies, on impact with friction).
"""

import itertools
import math

import numpy as np
import pytest
from setups import STICKING, first, simulate, still, turned

import stayput as sp

BEFORE = 1e-7  # rad, from the wall


def hit(body: sp.Body, tilt: float, rate: float, floor: sp.Floor, wall: sp.Wall) -> sp.Event:
    """First event of a body that turns about B into a wall that it reaches at this tilt."""
    gap = float((turned(body.corners[3], tilt) - turned(body.corners[1], tilt))[0])
    place = sp.Room(floor, right_wall=sp.Wall(gap, wall.restitution, wall.friction))
    run = simulate(body, place, still(0.02, 0.001), tilt=tilt - BEFORE, tilt_rate=rate)
    return first(run, sp.EventKind.WALL_IMPACT)


def velocities_after(
    body: sp.Body, tilt: float, rate: float, floor: float, wall: sp.Wall
) -> list[tuple[float, float, float]]:
    """Velocity of G and rotation rate after the impact, for every consistent set of impulses."""
    inertia = body.inertia_about_cg / body.mass
    (bx, bz), (dx, dz) = turned(body.corners[1], tilt), turned(body.corners[3], tilt)
    # rows: normal and tangent at B (floor), at D (wall): what they see of (v_x, v_z, θ̇)
    normals = np.array([[0, 1, -bx], [-1, 0, -dz]])
    tangents = np.array([[1, 0, bz], [0, 1, -dx]])
    inverse = np.diag([1, 1, 1 / inertia])
    before = np.array([-bz * rate, bx * rate, rate])  # B stands still
    targets = np.array([0.0, -wall.restitution * (normals[1] @ before)])
    mu = (floor, wall.friction)
    found = []
    for modes in itertools.product(("open", "stick", "left", "right"), repeat=2):
        rows, wanted, pushes = [], [], []
        for k, mode in enumerate(modes):
            if mode == "open":
                continue
            rows.append(normals[k])
            wanted.append(targets[k])
            if mode == "stick":
                pushes.append(normals[k])
                rows.append(tangents[k])
                wanted.append(0.0)
                pushes.append(tangents[k])
            else:
                side = 1 if mode == "right" else -1
                pushes.append(normals[k] - side * mu[k] * tangents[k])
        if not rows:
            continue
        rows, pushes = np.array(rows), np.array(pushes)
        matrix = rows @ inverse @ pushes.T
        if abs(np.linalg.det(matrix)) < 1e-12:
            continue
        impulses = list(np.linalg.solve(matrix, np.array(wanted) - rows @ before))
        after = before + inverse @ pushes.T @ np.array(impulses)
        good = True
        for k, mode in enumerate(modes):
            if mode == "open":
                good &= normals[k] @ after >= targets[k] - 1e-12
                continue
            normal = impulses.pop(0)
            good &= normal >= 0
            if mode == "stick":
                good &= abs(impulses.pop(0)) <= mu[k] * normal + 1e-12
            else:
                good &= (tangents[k] @ after) * (1 if mode == "right" else -1) >= -1e-12
        if good:
            found.append(tuple(after))
    return found


@pytest.mark.parametrize("e_w", [0.0, 0.3, 0.8])
@pytest.mark.parametrize("tilt", [0.5, 0.62, 0.8])
def test_a_falling_body_turns_back_on_a_sticking_fulcrum(e_w, tilt):
    """Beyond α the floor can hold the foot: θ̇' = −e_w θ̇, by the moment of momentum about it."""
    landing = hit(sp.Body(0.1, 2.0, 100.0), tilt, 1.0, STICKING, sp.Wall(0.0, e_w, 0.0))
    rate = math.sqrt(1.0 + 2 * BEFORE * 9.81)  # near enough; gravity hardly acts over 1e-7 rad
    assert landing.tilt_rate == pytest.approx(-e_w * rate, abs=2e-6)
    assert landing.slide_rate == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("e_w", [0.0, 0.3, 0.8])
@pytest.mark.parametrize("tilt", [0.05, 0.15])
def test_a_body_below_alpha_is_thrown_off_the_floor(e_w, tilt):
    """The floor cannot pull: one impulse, at the top corner, by Newton's restitution."""
    body = sp.Body(0.5, 1.6, 100.0)
    assert tilt < body.slenderness[1]
    (_, bz), (_, dz) = turned(body.corners[1], tilt), turned(body.corners[3], tilt)
    inertia = body.inertia_about_cg / body.mass
    impulse = (1 + e_w) * (dz - bz) / (1 + dz * dz / inertia)
    landing = hit(body, tilt, 1.0, STICKING, sp.Wall(0.0, e_w, 0.0))
    assert landing.mode is sp.Mode.FLIGHT
    assert landing.tilt_rate == pytest.approx(1 - impulse * dz / inertia, abs=2e-6)
    slip = -bz - impulse + landing.tilt_rate * bz
    assert landing.slide_rate == pytest.approx(slip, abs=5e-6)


@pytest.mark.parametrize("wall", [sp.Wall(0.0, 0.5, 0.0), sp.Wall(0.0, 0.0, 0.4), sp.Wall(0.0, 0.6, 1.0)])
@pytest.mark.parametrize("floor", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("tilt", [0.1, 0.35, 0.6, 1.0])
@pytest.mark.parametrize(
    "body",
    [sp.Body(0.1, 2.0, 100.0), sp.Body(0.4, 1.6, 100.0), sp.Body(0.5, 1.0, 100.0, cg_offset=(0.1, -0.2))],
)
def test_impulses_at_floor_and_wall(body, tilt, floor, wall):
    rate = 2.0
    landing = hit(body, tilt, rate, sp.Floor(floor, floor), wall)
    inertia = body.inertia_about_cg / body.mass
    foot = turned(body.corners[1], tilt)
    before = np.array([-foot[1], foot[0], 1.0]) * rate

    def energy(velocity: np.ndarray) -> float:
        return float(velocity @ np.diag([1, 1, inertia]) @ velocity)

    expected = [
        after
        for after in map(np.array, velocities_after(body, tilt, rate, floor, wall))
        if energy(after) <= energy(before) * (1 + 1e-9)
    ]
    if (
        not expected
    ):  # Newton's restitution with friction would create energy: (1+e) times the plastic impulses
        plastic = sp.Wall(0.0, 0.0, wall.friction)
        plastically = map(np.array, velocities_after(body, tilt, rate, floor, plastic))
        expected = [before + (1 + wall.restitution) * (after - before) for after in plastically]
        assert max(map(energy, expected)) <= energy(before) * (1 + 1e-9)
    expected = [(after[2], after[0] + after[2] * foot[1]) for after in expected]
    nearest = min(expected, key=lambda pair: abs(pair[0] - landing.tilt_rate))
    assert (landing.tilt_rate, landing.slide_rate) == pytest.approx(nearest, abs=1e-5)


@pytest.mark.parametrize("e_w", [0.0, 0.5, 1.0])
def test_a_sliding_base_comes_back(e_w):
    """A low body that slides flat into the wall: v' = −e_w v, and no turning."""
    place = sp.Room(sp.Floor(0.3, 0.3), right_wall=sp.Wall(0.05, e_w, 0.3))
    run = simulate(sp.Body(1.6, 0.4, 100.0), place, still(1.0), slide_rate=1.0)
    landing = first(run, sp.EventKind.WALL_IMPACT)
    assert landing.slide == pytest.approx(0.05, abs=1e-10)
    speed = math.sqrt(1.0 - 2 * 0.3 * 9.81 * 0.05)
    assert landing.slide_rate == pytest.approx(-e_w * speed, abs=1e-9)
    assert set(run.tilt) == {0.0}
    back = (e_w * speed) ** 2 / (2 * 0.3 * 9.81)
    assert run.residual_slide == pytest.approx(0.05 - back, abs=1e-9)
