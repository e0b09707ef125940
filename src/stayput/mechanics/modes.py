"""Which mode follows: the one consistent set of contact forces, and the velocities that go with it.

The patterns are tried from the most contacts to the fewest, so that where more than one is consistent
the body keeps the contacts, and the rest, that it has. At the instant of an event a force is exactly at
its limit; the choice is therefore made for the loads and the state a moment later.
"""

from __future__ import annotations

import math

from stayput.mechanics.columns import FAILED, FLAT, FLIGHT, FLOOR_BITS, HELD, PLANE, SLIP, STICK, WEDGE
from stayput.mechanics.compiled import inner
from stayput.mechanics.contact import (
    both_slip,
    holding_limits,
    mark_slips,
    none_presses,
    one_slips,
    one_sticks,
    tabulate_forces,
    use_flat_friction,
)
from stayput.mechanics.geometry import along, arm, resting_place, resting_tilt, slip_rate

MOMENT = 1e-9
"""How far ahead the forces are looked at when a mode is chosen [s]."""

SETTLED_HEIGHT = 1e-9
"""A bounce that would not rise higher than this is over [m]."""

TOLERANCE = 1e-11
"""Slack of the inequalities between accelerations [m/s²]."""


@inner
def _set_mode(s, kind, i, d, j, dj):
    s.kind, s.i, s.d, s.j, s.dj = kind, i, d, j, dj
    s.closed = 0
    if i >= 0:
        s.closed |= 1 << i
    if j >= 0:
        s.closed |= 1 << j


@inner
def settling_rate(case):
    """Rate at which a contact opens in a bounce that is over [m/s]."""
    return math.sqrt(2.0 * SETTLED_HEIGHT * case.gravity)


@inner
def _hold(rows, count, contacts, closed, settle, case, s, a, G):
    """Try to hold the body still: the contacts must (all but) not move and the forces fit their cones."""
    for k in range(count):
        if abs(slip_rate(contacts[rows[k].index], s)) > settle:
            return False
    low, high = holding_limits(rows, count)
    if not (G > 0.0 and low * G <= a <= high * G):
        return False
    _set_mode(s, HELD, -1, 0, -1, 0)
    s.closed = closed
    s.low, s.high = low, high
    s.vx = s.vz = s.omega = s.alpha = 0.0
    if closed & FLOOR_BITS == FLOOR_BITS:
        stand_flat(case, s)
    return True


@inner
def stand_flat(case, s):
    """Put both base corners exactly on the floor."""
    s.theta = resting_tilt(case)
    s.z = resting_place(case, s.theta)[1]


@inner
def choose_mode(rows, contacts, touching, settle, case, s, a, a_rate, G, G_rate):
    """Set the mode of a body whose contacts ``touching`` are closed, and its velocities.

    A contact that opens no faster than ``settle`` [m/s] stays closed if the forces press it: after an
    impact, the rate of a bounce that is over; else none.
    ``a`` and ``G`` are the floor's acceleration and g + z̈_G now, with their rates.
    """
    I = case.inertia
    closed = 0
    c = 0
    while touching >> c:
        if touching >> c & 1:
            con = contacts[c]
            sigma, _ = arm(con, s.theta)
            if along(con, s.vx, s.vz)[1] - s.omega * sigma <= settle:
                closed |= 1 << c
        c += 1
    theta, omega = s.theta + MOMENT * s.omega, s.omega + MOMENT * s.alpha
    a, G = a + MOMENT * a_rate, G + MOMENT * G_rate
    count = tabulate_forces(rows, contacts, closed, theta, omega, a, G)
    mark_slips(rows, count, contacts, s)
    use_flat_friction(rows, count, case.static_friction, case.kinetic_friction)

    if count >= 2:
        if _hold(rows, count, contacts, closed, settle, case, s, a, G):
            return
        for i in range(count):
            for j in range(i + 1, count):
                if _pair(rows, count, i, j, case, s, I):
                    _settle_pair(contacts, case, s)
                    return
    for i in range(count):
        ok, fx, fz, fl = False, 0.0, 0.0, 0.0
        if rows[i].slipping == 0.0:
            ok, fx, fz, fl = one_sticks(rows, count, i, I, TOLERANCE)
        if ok:
            _set_mode(s, STICK, rows[i].index, 0, -1, 0)
            s.alpha = fl / I
            pivot_on(contacts[s.i], s)
            return
        for side in (1.0, -1.0):
            if rows[i].slipping == -side:
                continue
            ok, fx, fz, fl = one_slips(rows, count, i, side, I, TOLERANCE)
            if ok:
                _set_mode(s, SLIP, rows[i].index, int(side), -1, 0)
                s.alpha = fl / I
                stay_on_plane(contacts[s.i], s)
                return
    if none_presses(rows, count, TOLERANCE):
        _set_mode(s, FLIGHT, -1, 0, -1, 0)
        s.alpha = 0.0
        return
    _set_mode(s, FAILED, -1, 0, -1, 0)


@inner
def _pair(rows, count, i, j, case, s, I):
    """Try two contacts that both press and slip."""
    first, second = rows[i].index, rows[j].index
    same = PLANE[first] == PLANE[second]
    for side_i in (1.0, -1.0):
        if rows[i].slipping == -side_i:
            continue
        for side_j in (1.0, -1.0):
            if (same and side_i != side_j) or rows[j].slipping == -side_j:
                continue
            ok, fx, fz, fl = both_slip(rows, count, i, side_i, j, side_j, I, TOLERANCE)
            if ok:
                kind = FLAT if same else WEDGE
                _set_mode(s, kind, first, int(side_i), second, int(side_j))
                s.alpha = fl / I
                return True
    return False


@inner
def pivot_on(con, s):
    """Give G the velocity of a rotation about the contact's corner."""
    sigma, kappa = arm(con, s.theta)
    tangential, normal = s.omega * kappa, s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal


@inner
def stay_on_plane(con, s):
    """Take away the velocity of the contact's corner off its plane, and the corner's distance to it."""
    sigma, kappa = arm(con, s.theta)
    tangential, _ = along(con, s.vx, s.vz)
    normal = s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal
    along_plane, _ = along(con, s.x, s.z)
    height = kappa - con.offset
    s.x = con.cos * along_plane - con.sin * height
    s.z = con.sin * along_plane + con.cos * height


@inner
def _settle_pair(contacts, case, s):
    """Velocities with both contacts closed: along the plane they share, or the rotation that keeps both."""
    first, second = contacts[s.i], contacts[s.j]
    if s.kind == FLAT:
        s.omega = s.alpha = 0.0
        if s.closed == FLOOR_BITS:
            stand_flat(case, s)
        stay_on_plane(first, s)
        return
    close_both(first, second, case.inertia, s)


@inner
def close_both(first, second, I, s):
    """Move the state, by the least change in the metric of mass, to where both contacts are closed."""
    sigma, kappa = arm(first, s.theta)
    sigma2, kappa2 = arm(second, s.theta)
    aa, bb = 1.0 + sigma * sigma / I, 1.0 + sigma2 * sigma2 / I
    ab = first.sin * second.sin + first.cos * second.cos + sigma * sigma2 / I
    det = aa * bb - ab * ab
    if abs(det) < 1e-14:
        return
    gap = along(first, s.x, s.z)[1] + first.offset - kappa
    gap2 = along(second, s.x, s.z)[1] + second.offset - kappa2
    p, q = -(gap * bb - gap2 * ab) / det, -(gap2 * aa - gap * ab) / det
    s.x -= p * first.sin + q * second.sin
    s.z += p * first.cos + q * second.cos
    s.theta -= (p * sigma + q * sigma2) / I
    rate = along(first, s.vx, s.vz)[1] - s.omega * sigma
    rate2 = along(second, s.vx, s.vz)[1] - s.omega * sigma2
    p, q = -(rate * bb - rate2 * ab) / det, -(rate2 * aa - rate * ab) / det
    s.vx -= p * first.sin + q * second.sin
    s.vz += p * first.cos + q * second.cos
    s.omega -= (p * sigma + q * sigma2) / I


@inner
def unjam(contacts, case, s):
    """Stop the fulcrum where no force can keep it slipping (Painlevé): an impact without a collision."""
    if s.kind != FAILED:
        return
    c = 0
    while s.present >> c:
        if s.closed >> c & 1:
            con = contacts[c]
            if con.mu_static > 0.0 and abs(slip_rate(con, s)) > 0.0:
                sigma, kappa = arm(con, s.theta)
                spin = s.omega * case.inertia
                tangential, normal = along(con, s.vx, s.vz)
                s.omega = (spin + kappa * tangential + sigma * normal) / (
                    case.inertia + sigma * sigma + kappa * kappa
                )
                pivot_on(con, s)
                return
        c += 1
