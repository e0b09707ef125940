"""Corners, contacts and gaps of a body in a room, from its tilt and place."""

import math

import numpy as np
import pytest
from numba import njit

import stayput as sp
from stayput.mechanics import columns as col
from stayput.mechanics import geometry
from stayput.model.state import standing_corners
from stayput.simulation.flat_fields import case_columns

BODY = sp.Body(0.4, 1.6, 100.0, cg_offset=(0.03, -0.1))
ROOM = sp.Room(left_wall=sp.Wall(0.5), right_wall=sp.Wall(0.6), ceiling=sp.Ceiling(1.9))


@njit
def placed(case, contacts, states, tilt):
    """Gaps of all contacts of a body tilted about its fulcrum, with its slide."""
    s = states[0]
    geometry.set_up(case, contacts, s)
    corner = 1 if tilt > 0.0 else 0
    foot = s.foot_b if corner == 1 else s.foot_a
    geometry.turn_to(s, s.rest + tilt)
    s.x, s.z = foot - geometry.corner_right(case, corner, s), -geometry.corner_up(case, corner, s)
    gaps = np.array([geometry.gap(contacts[c], s) for c in range(8)])
    return gaps, geometry.touching(contacts, s), geometry.slide_of(case, s)[0]


@njit
def sin_cos(theta, near):
    return geometry.sin_cos(theta, near, math.sin(near), math.cos(near))


@pytest.mark.parametrize("tilt", [0.0, 0.2, -0.15])
def test_gaps_are_the_distances_of_the_corners_from_the_planes(tilt):
    (case,) = case_columns(BODY, ROOM, sp.State(), 9.81)
    contacts, states = np.zeros(col.CONTACTS, col.CONTACT), np.zeros(1, col.STATE)
    gaps, touching, slide = placed(case, contacts, states, tilt)
    corners = np.array(standing_corners(BODY, sp.State(tilt=tilt)))
    at_rest = np.array(standing_corners(BODY, sp.State()))
    right, left = at_rest[:, 0].max() + 0.6, at_rest[:, 0].min() - 0.5
    for c in range(col.CONTACTS):
        x, z = corners[col.CORNER[c]]
        expected = (z, right - x, x - left, 1.9 - z)[col.PLANE[c]]
        assert gaps[c] == pytest.approx(expected, abs=1e-12)
    assert touching == (col.FLOOR_BITS if tilt == 0.0 else (2 if tilt > 0.0 else 1))
    assert slide == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("turn", [1e-9, 1e-3, 0.0999, 0.2])
def test_sine_and_cosine_near_a_known_tilt(turn):
    assert sin_cos(0.3 + turn, 0.3) == pytest.approx((math.sin(0.3 + turn), math.cos(0.3 + turn)), abs=2e-16)
