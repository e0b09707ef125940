"""The ladder: a body that leans on a wall, by statics and by Newton's equations.

A top corner rests on the right wall, the right base corner on the floor. At the limit both slip: with
N_w = μ_f N_f and N_f + μ_w N_w = mg the moments about the foot give
x_G = μ_f/(1 + μ_f μ_w)·(z_D + μ_w x_D). A uniform frictionless ladder leaves the wall when its top has
come down by a third (a classical exercise, e.g. E. J. Routh, 1905, Dynamics of a System of Rigid Bodies).
"""

import math

import numpy as np
import pytest
from equations import EXACT, ladder
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from setups import G, constant, events, first, simulate, still, turned

import stayput as sp

BODIES = {"plank": sp.Body(0.05, 2.0, 100.0), "bookcase": sp.Body(0.3, 1.8, 100.0, cg_offset=(0.02, -0.2))}


def gap_for(body: sp.Body, tilt: float) -> float:
    """Distance of the wall at which the top corner touches it."""
    return float((turned(body.corners[3], tilt) - turned(body.corners[1], tilt))[0])


def leaning_room(body: sp.Body, tilt: float, static: float, kinetic: float, wall: float) -> sp.Room:
    return sp.Room(
        sp.Floor(static, kinetic), right_wall=sp.Wall(gap_for(body, tilt), restitution=0.0, friction=wall)
    )


def least_friction(body: sp.Body, tilt: float, wall: float) -> float:
    foot = turned(body.corners[1], tilt)
    x_g, (x_d, z_d) = -foot[0], turned(body.corners[3], tilt) - foot
    return brentq(lambda mu: mu / (1 + mu * wall) * (z_d + wall * x_d) - x_g, 0.0, 50.0, xtol=1e-15)


@pytest.mark.parametrize("wall", [0.0, 0.2, 0.5])
@pytest.mark.parametrize("tilt", [0.3, 0.6])
@pytest.mark.parametrize("name", BODIES)
def test_friction_that_holds_a_ladder(name, tilt, wall):
    body = BODIES[name]
    assert tilt > body.slenderness[1]
    limit = least_friction(body, tilt, wall)
    assert 0.01 < limit < 1.0
    enough, little = limit * (1 + 1e-6), limit * (1 - 1e-6)
    holds = simulate(body, leaning_room(body, tilt, enough, enough, wall), still(5.0), tilt=tilt)
    assert holds.outcome is sp.Outcome.LEANING
    assert set(holds.mode) == {sp.Mode.LEAN}
    assert (set(holds.tilt), np.ptp(holds.slide)) == ({tilt}, 0.0)
    slips = simulate(body, leaning_room(body, tilt, little, little, wall), still(1.0), tilt=tilt)
    assert slips.residual_tilt > tilt
    assert slips.slide[-1] < 0.0
    assert slips.slide_rate[-1] < 0.0


@pytest.mark.parametrize("name", BODIES)
def test_the_floors_acceleration_holds_or_pulls(name):
    """Under a constant ẍ the ladder stands until the wall carries nothing."""
    body, tilt = BODIES[name], 0.4
    place = leaning_room(body, tilt, 1.0, 1.0, 0.0)
    x_g, z_g = -turned(body.corners[1], tilt)
    released = G * x_g / z_g  # moments about the foot: N_w z_D = g x_G − ẍ z_G
    holds = simulate(body, place, constant(released * (1 - 1e-6), 0.3), tilt=tilt)
    assert (holds.outcome, holds.events) == (sp.Outcome.LEANING, ())
    back = simulate(body, place, constant(released * (1 + 1e-6), 0.3), tilt=tilt)
    assert back.mode[-1] == sp.Mode.ROCK
    assert back.residual_tilt < tilt


@pytest.mark.parametrize(("floor", "wall"), [(0.0, 0.0), (0.1, 0.0), (0.1, 0.15)])
@pytest.mark.parametrize("name", BODIES)
def test_a_sliding_ladder(name, floor, wall):
    body, tilt = BODIES[name], 0.6
    assert floor < least_friction(body, tilt, wall)
    dt, steps = 0.005, 300

    def leaves(_, y):
        return ladder(body, y[0], y[1], floor, wall)[4]

    leaves.terminal = True
    peer = solve_ivp(
        lambda _, y: [y[1], ladder(body, y[0], y[1], floor, wall)[2]],
        (0.0, dt * steps),
        [tilt, 0.0],
        events=leaves,
        dense_output=True,
        max_step=0.02,
        **EXACT,
    )
    assert peer.status == 1
    run = simulate(body, leaning_room(body, tilt, floor, floor, wall), still(dt * steps, dt), tilt=tilt)
    release = first(run, sp.EventKind.WALL_RELEASE)
    assert release.time == pytest.approx(peer.t[-1], abs=1e-6)
    assert (release.tilt, release.tilt_rate) == pytest.approx(peer.y[:, -1], abs=1e-6)
    before = run.time < release.time
    assert set(run.mode[before]) == {sp.Mode.LEAN}
    assert run.tilt[before] == pytest.approx(peer.sol(run.time[before])[0], abs=1e-8)
    assert run.rotation_rate[0, before, 1] == pytest.approx(peer.sol(run.time[before])[1], abs=1e-7)


def test_a_frictionless_ladder_leaves_the_wall_at_two_thirds_of_its_height():
    body, tilt = sp.Body(0.001, 3.0, 100.0), 0.4
    run = simulate(body, leaning_room(body, tilt, 0.0, 0.0, 0.0), still(2.0), tilt=tilt)
    release = first(run, sp.EventKind.WALL_RELEASE)
    assert math.cos(release.tilt) / math.cos(tilt) == pytest.approx(2 / 3, abs=1e-3)
    assert len(events(run, sp.EventKind.WALL_RELEASE)) == 1
