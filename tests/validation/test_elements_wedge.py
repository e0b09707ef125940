"""Wedge stoppers: a body that stands tilted back on a front edge of rubber; statics in closed form."""

import math

import numpy as np
import pytest
from setups import STICKING, G, constant, room, still, threshold

import stayput as sp
from devices import bare, held

BOTH = [pytest.param(bare, id="bare"), pytest.param(held, id="with elements")]


@pytest.mark.parametrize("run", BOTH)
def test_a_wedge_tilts_the_body_back_and_turns_its_limits(run):
    """With a wedge w under the front edge: tan θ₀ = −w/b; tipping at (b_f/h_G) of the tilted body."""
    b, h, w = 0.4, 1.8, 0.012
    body, place = sp.Body(b, h, 100.0, base_heights=(0.0, -w)), sp.Room(STICKING)
    assert body.resting_tilt == pytest.approx(-math.atan(w / b), rel=1e-12)
    quiet = run(body, place, still(1.0))
    assert quiet.result["outcome"] == 0
    assert set(quiet.history[:, 2]) == {0.0}

    sin, cos = math.sin(body.resting_tilt), math.cos(body.resting_tilt)
    for corner, way in ((1, -1.0), (0, 1.0)):
        u, v = body.corners[corner]
        across, up = u * cos + v * sin, v * cos - u * sin
        limit = threshold(
            lambda a, way=way: run(body, place, constant(way * a, 0.05)).result["outcome"] != 0,
            0.05 * G,
            0.6 * G,
            halvings=30,
        )
        assert limit == pytest.approx(abs(across / up) * G, rel=1e-8)
    flat = b / h
    assert abs(body.corners[1][0] * cos + body.corners[1][1] * sin) / (h / 2) > flat  # forward it is safer


@pytest.mark.parametrize("run", BOTH)
@pytest.mark.parametrize(("left", "right"), [(0.3, 0.8), (0.8, 0.3), (0.1, 0.2)])
def test_each_base_corner_has_its_own_friction(run, left, right):
    """Flat, each corner bears what the moment about G gives it, and slips with its own coefficient."""
    b, h = 2.0, 0.6
    floor = sp.Floor(
        left_edge_static_friction=left,
        left_edge_kinetic_friction=left,
        right_edge_static_friction=right,
        right_edge_kinetic_friction=right,
    )
    for d in (1.0, -1.0):
        # N_A + N_B = 1; moment about G: b/2 (N_A − N_B) + d h/2 (μ_A N_A + μ_B N_B) = 0
        matrix = [[1.0, 1.0], [b / 2 + d * h / 2 * left, -b / 2 + d * h / 2 * right]]
        loads = np.linalg.solve(matrix, [1.0, 0.0])
        mu = loads @ [left, right]
        found = run(sp.Body(b, h, 100.0), sp.Room(floor), still(2.0, 0.002), slide_rate=d)
        assert d * found.result["peak_slide"] * d == pytest.approx(1.0 / (2 * mu * G), rel=1e-9)
        # it starts to slide at the same load, in the direction that the load pushes it
        limit = threshold(
            lambda a, d=d, floor=floor: (
                run(sp.Body(b, h, 100.0), sp.Room(floor), constant(-d * a, 0.05)).result["outcome"] != 0
            ),
            0.01 * G,
            0.9 * G,
            halvings=25,
        )
        assert limit == pytest.approx(mu * G, rel=1e-6)


@pytest.mark.parametrize("run", BOTH)
def test_a_corner_alone_keeps_its_friction(run):
    """A body that rocks on its rubber edge sticks; on the bare one it slips."""
    body = sp.Body(0.4, 1.6, 100.0)
    rubber = sp.Floor(0.05, 0.05, right_edge_static_friction=1.0, right_edge_kinetic_friction=1.0)
    sticks = run(body, sp.Room(rubber), still(0.2), tilt=0.1)
    slips = run(body, sp.Room(rubber), still(0.2), tilt=-0.1)
    assert sticks.result["peak_slide"] == 0.0
    assert slips.result["peak_slide"] > 1e-3


def test_own_frictions_equal_to_the_floors_change_nothing():
    motion = sp.sine(amplitude=0.5 * G, frequency=1.0, duration=5.0)
    own = {
        f"{side}_edge_{kind}_friction": value
        for side in ("left", "right")
        for kind, value in (("static", 0.4), ("kinetic", 0.3))
    }
    plain = bare(sp.Body(0.5, 1.0, 100.0), room(0.4, 0.3), motion)
    same = bare(sp.Body(0.5, 1.0, 100.0), room(0.4, 0.3, **own), motion)
    assert np.array_equal(plain.history, same.history)


def test_kinetic_friction_above_static_is_refused():
    with pytest.raises(sp.InputError, match=r"right edge kinetic friction is 0\.5"):
        sp.Floor(0.4, 0.3, right_edge_kinetic_friction=0.5)
