"""Projection of the state onto closed contacts: places on their planes, and velocities along them."""

from __future__ import annotations

import math

from stayput.compiling import inner
from stayput.mechanics.columns import FLOOR_BITS, SLIDE
from stayput.mechanics.contact import STICK_RATE
from stayput.mechanics.geometry import arm, gap, gap_rate, slip_rate, stand_flat, to_plane_axes, turn_to

FLAT_TOLERANCE = 1e-8
"""Rotation off flat below which a body on both base corners is set exactly flat [rad]."""

MAX_SETTLING = 10.0
"""Largest velocity removed when a bounce ends, in multiples of the rate at which its gap may still open."""


@inner
def set_pivot_velocity(con, s):
    """Set the velocity of G to that of a pure rotation about the contact's corner."""
    sigma, kappa = arm(con, s)
    tangential, normal = s.omega * kappa, s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal


@inner
def project_on_plane(con, s):
    """Project the state so that the contact's corner is on its plane and moves along it."""
    sigma, kappa = arm(con, s)
    tangential, _ = to_plane_axes(con, s.vx, s.vz)
    normal = s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal
    along_plane, _ = to_plane_axes(con, s.x, s.z)
    height = kappa - con.offset
    s.x = con.cos * along_plane - con.sin * height
    s.z = con.sin * along_plane + con.cos * height


@inner
def project_pair(contacts, case, s):
    """Project the state so that both contacts are closed: flat on their plane, or leaning on two."""
    first, second = contacts[s.i], contacts[s.j]
    if s.kind == SLIDE:
        s.omega = s.alpha = 0.0
        if s.closed == FLOOR_BITS and abs(s.theta - s.rest) < FLAT_TOLERANCE:
            stand_flat(case, s)
        project_on_plane(first, s)
        return
    project_on_both(first, second, case.inertia, s)


@inner
def _remove_component(j, e):
    """Remove the component of a vector along a unit vector."""
    p = j[0] * e[0] + j[1] * e[1] + j[2] * e[2]
    return j[0] - p * e[0], j[1] - p * e[1], j[2] - p * e[2]


@inner
def remove_gap_rates(contacts, closed, settle_rate, I, s):
    """Project away the gap rates of closed contacts, which are at most ``settle_rate``.

    Contacts that stick keep sticking; slip is left to friction, whatever its rate. The change is the least in
    the mass metric, so energy never grows: (v_x, v_z, √I ω) loses its component in the space of these normals
    and tangents, found by Gram–Schmidt. A direction in which more than `MAX_SETTLING` times ``settle_rate``
    would be lost is skipped: a corner right above another hardly moves in a rotation about it, however fast.
    """
    root = math.sqrt(I)
    v = (s.vx, s.vz, root * s.omega)
    zero = (0.0, 0.0, 0.0)
    e1, e2, e3 = zero, zero, zero
    for tangential in (False, True):
        c = 0
        while closed >> c:
            con = contacts[c]
            if closed >> c & 1 and not (tangential and abs(slip_rate(con, s)) > STICK_RATE):
                sigma, kappa = arm(con, s)
                j = (con.cos, con.sin, -kappa / root) if tangential else (-con.sin, con.cos, -sigma / root)
                new = _remove_component(_remove_component(_remove_component(j, e1), e2), e3)
                size = math.sqrt(new[0] * new[0] + new[1] * new[1] + new[2] * new[2])
                if size > 1e-6:  # else the direction depends on those before
                    e = new[0] / size, new[1] / size, new[2] / size
                    if abs(v[0] * e[0] + v[1] * e[1] + v[2] * e[2]) <= MAX_SETTLING * settle_rate:
                        e1, e2, e3 = e, e1, e2
                        v = _remove_component(v, e1)
            c += 1
    s.vx, s.vz, s.omega = v[0], v[1], v[2] / root


@inner
def _least_change(first, second, gap1, gap2, I, s):
    """Least change of x, z and θ, or of their rates, that brings two gaps, or gap rates, to zero."""
    sigma1, _ = arm(first, s)
    sigma2, _ = arm(second, s)
    aa, bb = 1.0 + sigma1 * sigma1 / I, 1.0 + sigma2 * sigma2 / I
    ab = first.sin * second.sin + first.cos * second.cos + sigma1 * sigma2 / I
    det = aa * bb - ab * ab
    if abs(det) < 1e-14:
        return 0.0, 0.0, 0.0
    p, q = -(gap1 * bb - gap2 * ab) / det, -(gap2 * aa - gap1 * ab) / det
    return (
        -(p * first.sin + q * second.sin),
        p * first.cos + q * second.cos,
        -(p * sigma1 + q * sigma2) / I,
    )


@inner
def _remove_both_gap_rates(first, second, I, s):
    rate1, rate2 = gap_rate(first, s), gap_rate(second, s)
    dx, dz, turn = _least_change(first, second, rate1, rate2, I, s)
    s.vx, s.vz, s.omega = s.vx + dx, s.vz + dz, s.omega + turn


@inner
def project_on_both(first, second, I, s):
    """Project the state, by the least change in the mass metric, so that both contacts are closed."""
    dx, dz, turn = _least_change(first, second, gap(first, s), gap(second, s), I, s)
    s.x, s.z = s.x + dx, s.z + dz
    turn_to(s, s.theta + turn)
    _remove_both_gap_rates(first, second, I, s)
