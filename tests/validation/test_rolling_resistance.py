"""Rolling resistance: what rolls slows down as the moment f N says, stops, and stays where less pushes it."""

import math

import numpy as np
import pytest
from in_space import G, about, lifted, steady, still, turned

import stayput as sp

R, ARM = 0.1, 1.5e-3
SOLID = sp.Body.cylinder(2.0 * R, 0.5, 10.0)
DRUM = sp.Body.cylinder(2.0 * R, 0.5, 10.0, inertia=np.diag([0.25, 0.25, 0.09]))
FLOOR = sp.Room(sp.Floor(0.4, 0.3, rolling_resistance=ARM))


def rolling(cylinder: sp.Body, speed: float, heading: float = 0.0) -> sp.Piece:
    """A cylinder on its side that rolls across its axis, which lies along y turned by the heading."""
    body = turned(cylinder, about((0.0, 0.0, 1.0), heading) @ about((1.0, 0.0, 0.0), math.pi / 2))
    ahead = np.array([math.cos(heading), math.sin(heading), 0.0])
    spin = speed / R * np.array([-ahead[1], ahead[0], 0.0])
    return sp.Piece(body, lifted(body), velocity=tuple(speed * ahead), rotation_rate=tuple(spin))


@pytest.mark.parametrize("heading", [0.0, 0.7])
@pytest.mark.parametrize("cylinder", [SOLID, DRUM], ids=["solid", "drum"])
def test_a_cylinder_that_rolls_stops(cylinder: sp.Body, heading: float) -> None:
    """(J + m R²) ω̇ = −f m g: it is slower by g f R/(R² + J/m) each second, and stops after v²/2 of that."""
    speed, m = 0.3, cylinder.mass
    slows = G * ARM * R / (R**2 + cylinder.solid.inertia[2, 2] / m)
    run = sp.simulate(rolling(cylinder, speed, heading), FLOOR, still(1.2 * speed / slows))
    assert run.outcome == "rolled"
    assert run.residual_slide == pytest.approx(speed**2 / (2.0 * slows), rel=1e-5)
    assert np.linalg.norm(run.velocity[0, 100]) == pytest.approx(speed - slows, rel=1e-5)
    assert not run.velocity[0, -1].any()
    assert run.time[np.flatnonzero(run.velocity[0].any(axis=1))[-1]] == pytest.approx(speed / slows, abs=0.02)


@pytest.mark.parametrize("share", [0.5, 0.99, 1.01, 2.0])
def test_a_cylinder_is_pushed_on_its_side(share: float) -> None:
    """It stays below a push of g f/R, to the bit, and beyond it rolls with 2/3 of what is left of that."""
    least = G * ARM / R
    run = sp.simulate(rolling(SOLID, 0.0), FLOOR, steady(-share * least, 0.0, 2.0))
    if share < 1.0:
        assert run.outcome == "rested"
        assert np.ptp(run.place[0], axis=0).max() == 0.0
    else:
        assert run.peak_slide == pytest.approx(0.5 * 2.0**2 * least * (share - 1.0) / 1.5, rel=1e-4)


def test_a_cone_on_its_side_rolls_round_until_it_stops() -> None:
    """With K about the line on which it lies and turns: K ω̇ = −f m g, and it rolls by ω² K/(2 f m g)."""
    cone = sp.Body.cone(bottom=0.1, top=0.22, height=0.35, mass=1.8)
    beta, rate = math.atan2(0.06, 0.35), 2.0
    body = turned(cone, about((0.0, 1.0, 0.0), math.pi / 2 - beta))
    at = lifted(body)
    centre = np.array(at) + body.solid.centre_of_gravity
    line, low = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, centre[2]])
    inertia = line @ body.solid.inertia @ line + body.mass * centre[2] ** 2
    spin = rate * line
    start = sp.Piece(body, at, velocity=tuple(np.cross(spin, low)), rotation_rate=tuple(spin))
    slows = ARM * body.mass * G / inertia
    run = sp.simulate(start, FLOOR, still(1.3 * rate / slows, 1e-3), step=2e-4)
    rates = np.linalg.norm(run.rotation_rate[0], axis=1)
    half = int(500 * rate / slows)
    assert rates[half] == pytest.approx(rate - slows * run.time[half], rel=2e-3)
    assert rates.sum() * 1e-3 == pytest.approx(rate**2 / (2.0 * slows), rel=2e-3)
    assert rates[-1] == 0.0


def test_a_can_that_rocks_across_its_rim_feels_nothing() -> None:
    can = sp.Body.cylinder(0.4, 1.0, 30.0)
    start = sp.Piece(can, (0.0, 0.0, 0.2 * math.sin(0.1)), tilt=(0.0, 0.1, 0.0))
    free, braked = (
        sp.simulate(start, sp.Room(sp.Floor(2.0, 2.0, rolling_resistance=arm)), still(0.6))
        for arm in (0.0, 5e-3)
    )
    np.testing.assert_allclose(braked.tilt, free.tilt, atol=1e-6)
